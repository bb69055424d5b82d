//! Writes what follows from the sources of the C interface.
//!
//! - `gusset-interface headers` writes the headers and the texts of statuses and choices.
//! - `gusset-interface describe FILE` writes the description for other generators.
//! - `gusset-interface reference FOLDER` writes the headers as doxygen reads them.
//!
//! Run it at the top of the repository.

use std::path::Path;
use std::process::ExitCode;
use std::{env, fs};

fn run(arguments: &[&str]) -> Result<(), String> {
    let (root, version) = (Path::new("."), env!("CARGO_PKG_VERSION"));
    let write = |path: &Path, text: &str| fs::write(path, text).map_err(|error| format!("{}: {error}", path.display()));
    match arguments {
        ["headers"] => {
            let texts = gusset_interface::library_texts(root)?;
            for (path, text) in texts.into_iter().chain(gusset_interface::library_headers(root, version)?) {
                write(&root.join(path), &text)?;
            }
            Ok(())
        }
        ["describe", file] => {
            let text = gusset_interface::library_description(root, version)?;
            // An unchanged file keeps its time, so that its dependents are not rebuilt.
            if fs::read_to_string(file).is_ok_and(|old| old == text) { Ok(()) } else { write(Path::new(file), &text) }
        }
        ["reference", folder] => {
            for (path, text) in gusset_interface::reference_headers(root, version)? {
                let path = Path::new(folder).join(path);
                fs::create_dir_all(path.parent().unwrap_or(root)).map_err(|error| format!("{folder}: {error}"))?;
                write(&path, &text)?;
            }
            Ok(())
        }
        _ => Err("gusset-interface headers | describe FILE | reference FOLDER".to_owned()),
    }
}

fn main() -> ExitCode {
    let arguments: Vec<String> = env::args().skip(1).collect();
    match run(&arguments.iter().map(String::as_str).collect::<Vec<_>>()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(what) => {
            eprintln!("gusset-interface: {what}");
            ExitCode::FAILURE
        }
    }
}
