//! Many files, one at a time or several together.

use crate::failure::{Exit, Failure};
use crate::reading::FileName;
use crate::report::describe_failure;
use crate::request::BatchOptions;
use crate::writing::print;
use gusset_io::Format;
use serde_json::{Value, json};
use std::collections::HashSet;
use std::path::{Path, PathBuf};
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};

/// The text and the JSON of one file's report.
pub(crate) type FileReport = (String, Value);

/// Works on each file, and prints the reports in the order of the files. The first failure decides the exit status; other files are
/// worked on all the same.
pub(crate) fn run_all(
    files: &[FileName],
    options: &BatchOptions,
    json: bool,
    work: impl Fn(usize) -> Result<FileReport, Failure> + Sync,
) -> Result<Vec<Value>, Failure> {
    let next = AtomicUsize::new(0);
    let results: Vec<Mutex<Option<Result<FileReport, Failure>>>> = files.iter().map(|_| Mutex::new(None)).collect();
    let work_through = || {
        while let Some(place) = Some(next.fetch_add(1, Ordering::Relaxed)).filter(|&place| place < files.len()) {
            let done = work(place);
            if let Ok(mut slot) = results[place].lock() {
                *slot = Some(done);
            }
        }
    };
    std::thread::scope(|scope| {
        for _ in 1..options.jobs.min(files.len()) {
            // The other threads do the work of one that does not start, as when memory runs out.
            let _ = std::thread::Builder::new().spawn_scoped(scope, work_through);
        }
        work_through();
    });
    let mut first_failure = None;
    let mut reports = Vec::new();
    for (file, slot) in files.iter().zip(results) {
        match slot.into_inner().ok().flatten() {
            Some(Ok((text, report))) => {
                if !json {
                    print(&if files.len() > 1 { with_name(&file.shown(), &text) } else { text })?;
                }
                reports.push(report);
            }
            Some(Err(failure)) => {
                crate::writing::tell!("gusset: {failure}");
                reports.push(json!({ "file": file.shown(), "error": describe_failure(&failure) }));
                first_failure.get_or_insert(failure.exit);
            }
            None => {
                return Err(Failure::new(
                    Exit::Plugin,
                    format!("{}: the work broke off; please report it with the file", file.shown()),
                ));
            }
        }
    }
    if json {
        let report = if let [report] = &reports[..] { report.clone() } else { json!({ "files": reports }) };
        print(&format!("{report:#}\n"))?;
    }
    match first_failure {
        None => Ok(reports),
        Some(exit) => Err(Failure { exit, message: String::new(), refusal: crate::failure::Refusal::default() }),
    }
}

fn with_name(name: &str, text: &str) -> String {
    text.lines().map(|line| format!("{name}: {line}\n")).collect()
}

/// Returns for each input the file in a folder that its result is written to. Refuses results of one name, and results that would
/// replace inputs.
pub(crate) fn outputs_in_folder(
    folder: &Path,
    inputs: &[FileName],
    format: Option<Format>,
) -> Result<Vec<FileName>, Failure> {
    let absolute = |file: &FileName| if let FileName::Path(path) = file { path.canonicalize().ok() } else { None };
    let given: HashSet<PathBuf> = inputs.iter().filter_map(absolute).collect();
    let mut taken: HashSet<PathBuf> = HashSet::new();
    let mut outputs = Vec::new();
    for input in inputs {
        let output = output_in_folder(folder, input, format)?;
        if absolute(&output).is_some_and(|path| given.contains(&path)) {
            return Err(Failure::usage(format!("{} would replace an input; choose another --out-dir", output.shown())));
        }
        if let FileName::Path(path) = &output
            && !taken.insert(path.clone())
        {
            return Err(Failure::usage(format!("several inputs would become {}; rename one", output.shown())));
        }
        outputs.push(output);
    }
    Ok(outputs)
}

fn output_in_folder(folder: &Path, input: &FileName, format: Option<Format>) -> Result<FileName, Failure> {
    let FileName::Path(path) = input else {
        return Err(Failure::usage("standard input has no name for a file in --out-dir"));
    };
    let name = path.file_name().ok_or_else(|| Failure::usage(format!("{}: not the name of a file", input.shown())))?;
    let mut output = folder.join(name);
    let own = Format::from_name(&name.to_string_lossy());
    if let Some(format) = format.filter(|&format| own != Some(format)) {
        output.set_extension(format.extension());
    }
    Ok(FileName::Path(output))
}
