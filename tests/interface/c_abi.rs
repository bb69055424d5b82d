//! The C interface as built: header, version, symbols, what the linker was told.
//!
//! `GUSSET_UPDATE=1 cargo test --test interface` rewrites the committed header and the list of
//! symbols.

use gusset_interface::source::Kind;
use std::collections::BTreeSet;
use std::ffi::{CStr, CString};
use std::path::{Path, PathBuf};
use std::process::Command;
use std::{env, fs};

const ROOT: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/..");
/// The libraries that a C program links besides the static library, on Linux.
const STATIC_LINK_LINE: &str = "-lgcc_s -lutil -lrt -lpthread -lm -ldl -lc";

/// All headers, one after the other.
fn headers() -> String {
    let library = gusset_interface::library_headers(Path::new(ROOT), env!("CARGO_PKG_VERSION")).unwrap();
    let paths = library
        .iter()
        .map(|(path, _)| Path::new(ROOT).join(path))
        .filter(|path| path.extension() == Some("h".as_ref()));
    paths.map(|path| fs::read_to_string(path).unwrap()).collect()
}

/// Compares a committed file with what it must be, or rewrites it.
fn committed(path: &str, generated: &str) {
    let path = Path::new(ROOT).join(path);
    if env::var_os("GUSSET_UPDATE").is_some() {
        fs::write(&path, generated).unwrap();
    }
    let found = fs::read_to_string(&path).unwrap_or_default();
    let line = found.lines().zip(generated.lines()).position(|(a, b)| a != b);
    assert!(
        found == generated,
        "{} is not what the sources say, from line {} on; GUSSET_UPDATE=1 cargo test --test interface rewrites it",
        path.display(),
        line.unwrap_or(found.lines().count().min(generated.lines().count())) + 1
    );
}

#[test]
fn the_committed_headers_are_the_generated_ones() {
    let root = Path::new(ROOT);
    let wrapper = fs::read_dir(root.join("include/gusset")).unwrap().map(|entry| entry.unwrap().path());
    let wrapper: String = wrapper.filter_map(|path| fs::read_to_string(path).ok()).collect();
    for (path, text) in gusset_interface::library_headers(root, env!("CARGO_PKG_VERSION")).unwrap() {
        committed(&path, &text);
        // The page that programs include names each header of C; a header of C++ includes the C++
        // headers.
        let name = path.trim_start_matches("include/");
        let named = if path.ends_with(".h") {
            fs::read_to_string(root.join("include/gusset.h")).unwrap().contains(name)
        } else {
            wrapper.contains(&format!("#include <{name}>"))
        };
        // The tables of the plugin and of files are for hosts without the library.
        let is_table = ["include/gusset_plugin.h", "include/gusset_files.h"].contains(&path.as_str());
        assert!(named || is_table, "{path}");
    }
    for (path, text) in gusset_interface::library_texts(root).unwrap() {
        committed(&path, &text);
    }
}

#[test]
fn the_version_is_the_package_s() {
    // SAFETY: the function returns a static string.
    #[allow(unsafe_code)]
    let version = unsafe { CStr::from_ptr(gusset::capi::version::gusset_version()) };
    assert_eq!(version.to_str().unwrap(), env!("CARGO_PKG_VERSION"));
    let header = fs::read_to_string(Path::new(ROOT).join("include/gusset/base.h")).unwrap();
    let parts: Vec<_> = env!("CARGO_PKG_VERSION").split('.').collect();
    for (name, part) in ["MAJOR", "MINOR", "PATCH"].iter().zip(parts) {
        assert!(header.contains(&format!("#define GUSSET_VERSION_{name} {part}\n")), "{name}");
    }
}

#[test]
fn every_status_has_a_text_of_its_own() {
    #[allow(unsafe_code)]
    let text = |status: i64| {
        // SAFETY: the function returns a static string.
        unsafe { CStr::from_ptr(gusset::capi::status::gusset_status_text(status as i32)) }.to_str().unwrap()
    };
    let items = gusset_interface::sources(Path::new(ROOT)).unwrap().into_iter().flat_map(|source| source.items);
    let statuses = items.filter_map(|item| match item.kind {
        Kind::Enum(values) if item.name == "gusset_status" => Some(values),
        _ => None,
    });
    let numbers: Vec<i64> = statuses.flatten().map(|(_, number, _)| number).collect();
    assert!(numbers.len() > 20);
    let mut texts: Vec<_> = numbers.iter().map(|&n| text(n)).collect();
    assert!(!texts.contains(&"unknown status"));
    assert_eq!(text(-1), "unknown status");
    texts.sort_unstable();
    texts.dedup();
    assert_eq!(texts.len(), numbers.len());
}

#[test]
fn every_constant_of_a_choice_has_a_text_of_its_own() {
    #[allow(unsafe_code)]
    let text = |choice: &str, value: u32| {
        let choice = CString::new(choice).unwrap();
        // SAFETY: a text that ends with a NUL; the function returns a static string.
        unsafe { CStr::from_ptr(gusset::capi::status::gusset_choice_text(choice.as_ptr(), value)) }.to_str().unwrap()
    };
    // The functions of the header, which cbindgen wrote.
    let header = headers();
    let mut count = 0;
    for choice in header.lines().filter_map(|line| line.strip_prefix("typedef uint32_t ")?.strip_suffix(';')) {
        let (_, after) = header.split_once(&format!("typedef uint32_t {choice};\n")).unwrap();
        let block = after.split("\n\n").next().unwrap();
        let defined = block.lines().filter_map(|line| line.strip_prefix("#define GUSSET_")?.rsplit_once(' '));
        // A value may have two names.
        let values: BTreeSet<u32> = defined.filter_map(|(_, value)| value.parse().ok()).collect();
        let texts: BTreeSet<&str> = values.iter().map(|&value| text(choice, value)).collect();
        assert!(!texts.contains("unknown value") && texts.iter().all(|text| text.len() >= 2), "{choice}: {texts:?}");
        assert_eq!(texts.len(), values.len(), "{choice}");
        count += values.len();
    }
    assert!(count > 300, "{count}");
    assert_eq!(text("gusset_left_reason", 0), "It is the only loop.");
    assert_eq!(text("gusset_left_reason", 99), "unknown value");
    assert_eq!(text("gusset_left", 0), "unknown value");
}

/// Cargo puts the C libraries where this test program is.
#[cfg(target_os = "linux")]
fn built(name: &str) -> PathBuf {
    let path = env::current_exe().unwrap().with_file_name(name);
    assert!(path.exists(), "{name} was not built");
    path
}

#[cfg(target_os = "linux")]
fn run(command: &mut Command) -> String {
    let output = command.output().unwrap();
    assert!(output.status.success(), "{command:?}: {}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).unwrap()
}

#[test]
#[cfg(target_os = "linux")]
fn the_library_exports_what_the_header_declares_and_nothing_else() {
    let listing = run(Command::new("nm").args(["-D", "--defined-only"]).arg(built("libgusset.so")));
    let symbols = listing.lines().filter_map(|line| line.split_whitespace().nth(2));
    let (effects, symbols): (Vec<_>, Vec<_>) = symbols.partition(|symbol| symbol.starts_with("Ofx"));
    committed("include/gusset.symbols", &(symbols.join("\n") + "\n"));
    assert!(effects.is_empty(), "{effects:?}");
    let header = headers();
    for symbol in &symbols {
        assert!(header.contains(&format!("{symbol}(")), "{symbol} is not declared");
    }
    let declared = |api: &str| header.matches(api).count() - header.matches(&format!("#define {api}")).count();
    assert_eq!(declared("GUSSET_API") + declared("GUSSET_PLUGIN_API"), symbols.len());
}

#[test]
#[cfg(target_os = "linux")]
fn the_library_has_its_soname_and_stays_loaded() {
    let dynamic = run(Command::new("readelf").arg("-d").arg(built("libgusset.so")));
    let (major_minor, _) = env!("CARGO_PKG_VERSION").rsplit_once('.').unwrap();
    assert!(dynamic.contains(&format!("[libgusset.so.{major_minor}]")), "{dynamic}");
    assert!(dynamic.contains("NODELETE"), "{dynamic}");
}

#[test]
fn all_that_name_the_static_link_line_agree() {
    let files = [
        ("docs/guides/c.md", " "),
        ("docs/guides/linking.md", " "),
        ("packaging/gusset.pc.in", " "),
        ("include/cmake/gussetTargets.cmake", ";"),
    ];
    for (path, separator) in files {
        let text = fs::read_to_string(Path::new(ROOT).join(path)).unwrap();
        assert!(text.contains(&STATIC_LINK_LINE.replace(' ', separator)), "{path}");
        // Without it a small program has the whole library in it.
        assert!(text.contains("--gc-sections"), "{path}");
    }
}

/// References to the shared library name the version that this version installs.
#[test]
fn the_name_of_the_library_has_this_version() {
    let name = concat!("libgusset.so.", env!("CARGO_PKG_VERSION_MAJOR"), ".", env!("CARGO_PKG_VERSION_MINOR"));
    let pages = ["docs/guides/linking.md", "docs/guides/plugin.md"];
    for file in ["include/gusset_plugin.h", "examples/guides/plugin.c"].iter().chain(&pages) {
        let text = fs::read_to_string(Path::new(ROOT).join(file)).unwrap();
        let mut versions = text.match_indices("libgusset.so.").map(|(at, _)| &text[at..]).peekable();
        assert!(versions.peek().is_some(), "{file}");
        for version in versions {
            let rest = version.strip_prefix(name).filter(|rest| !rest.starts_with(|c: char| c.is_ascii_digit()));
            assert!(rest.is_some(), "{file}: {:?} is not {name}", &version[..20.min(version.len())]);
        }
    }
}

#[test]
#[cfg(target_os = "linux")]
fn the_static_link_line_suffices() {
    let folder = env::temp_dir().join(format!("gusset-link-{}", std::process::id()));
    fs::create_dir_all(&folder).unwrap();
    let (source, program) = (folder.join("link.c"), folder.join("link"));
    fs::write(&source, "#include <gusset.h>\nint main(void) { return gusset_abi() == 0 || gusset_version() == 0; }\n")
        .unwrap();
    let mut gcc = Command::new("gcc");
    gcc.args(["-std=c99", "-Wall", "-Wextra", "-Werror", "-pedantic", "-nodefaultlibs", "-I"]);
    gcc.arg(Path::new(ROOT).join("include")).arg(&source).arg(built("libgusset.a"));
    run(gcc.args(STATIC_LINK_LINE.split(' ')).arg("-o").arg(&program));
    run(&mut Command::new(&program));
    fs::remove_dir_all(&folder).unwrap();
}
