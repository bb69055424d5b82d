//! The README and the guides show code that the tests compile and run. A block of code names its
//! file, and perhaps a part of it, which lies between two lines that end in `! [part]`.
//! `GUSSET_UPDATE=1 cargo test --test docs` copies them in. A block that names
//! no file may hold calls of make, whose targets there must be, or output.

use std::path::{Path, PathBuf};
use std::{env, fs};

const ROOT: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/..");

fn read(path: impl AsRef<Path>) -> String {
    let path = Path::new(ROOT).join(path);
    fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// The README, and the guides in the order of their names.
fn pages() -> Vec<PathBuf> {
    let folder = fs::read_dir(Path::new(ROOT).join("docs/guides")).unwrap();
    let mut guides: Vec<_> = folder.map(|entry| Path::new("docs/guides").join(entry.unwrap().file_name())).collect();
    guides.sort();
    [vec![PathBuf::from("README.md")], guides].concat()
}

/// A part of a file, without the indentation that all of it has; or all of the file.
fn part(file: &str, name: Option<&str>) -> String {
    let text = read(file);
    let Some(name) = name else { return text };
    let mark = format!("! [{name}]");
    let mut lines = text.lines().skip_while(|line| !line.ends_with(&mark)).skip(1).peekable();
    assert!(lines.peek().is_some(), "{file} has no part {name}");
    let lines: Vec<_> = lines.take_while(|line| !line.ends_with(&mark)).collect();
    let blank = |line: &&&str| !line.trim().is_empty();
    let indent = lines.iter().filter(blank).map(|line| line.len() - line.trim_start().len()).min().unwrap_or(0);
    lines.iter().map(|line| line.get(indent..).unwrap_or("").to_owned() + "\n").collect()
}

/// The page as it must be, and the files that it shows.
fn wanted(page: &str, makefile: &str) -> (String, Vec<String>) {
    let (mut text, mut files) = (String::new(), Vec::new());
    let mut lines = page.lines();
    while let Some(line) = lines.next() {
        text += &(line.to_owned() + "\n");
        let Some(info) = line.strip_prefix("```") else { continue };
        let mut words = info.split(' ');
        let language = words.next().unwrap_or("");
        let block: Vec<_> = lines.by_ref().take_while(|line| *line != "```").collect();
        if let Some(file) = words.next() {
            files.push(file.to_owned());
            text += &part(file, words.next());
        } else {
            for line in &block {
                let mut words = line.split_whitespace();
                let target = (words.next() == Some("make")).then(|| words.next().unwrap_or("build"));
                let there = target.is_some_and(|target| makefile.lines().any(|l| l.starts_with(&format!("{target}:"))));
                assert!(language == "text" || there, "of no file, and no target of the Makefile: {line}");
                text += &((*line).to_owned() + "\n");
            }
        }
        text += "```\n";
    }
    (text, files)
}

#[test]
fn pages_show_what_is_compiled_and_run() {
    let makefile = read("Makefile");
    let parts = ["", "python/", "tiles/", "vtk/"].map(|part| read(format!("cpp_tests/{part}CMakeLists.txt")));
    let built = parts.concat() + &read("cpp_tests/docs.cmake") + &read("tests/docs/rust.rs");
    let project = read("examples/guides/CMakeLists.txt");
    let mut shown = 0;
    for path in pages() {
        let page = read(&path);
        let (wanted, files) = wanted(&page, &makefile);
        shown += files.len();
        for file in files {
            let name = match file.strip_prefix("examples/guides/") {
                Some("CMakeLists.txt") => "--build-and-test ${guides} ".to_owned(),
                // The project's programs: `add_executable(name file)`.
                Some(name) if project.contains(&format!(" {name})\n")) => "--build-and-test ${guides} ".to_owned(),
                Some(name) => format!("${{guides}}/{name}"),
                // The examples of the reference are built one by one, by their names.
                None if file.starts_with("examples/reference/") => "/examples/reference/${name}.c".to_owned(),
                // Programs in Rust are modules of these tests.
                None if file.starts_with("examples/rust/") => file.clone(),
                None => format!("${{root}}/{file}"),
            };
            assert!(built.contains(&name), "{}: no test builds {file}", path.display());
        }
        if env::var_os("GUSSET_UPDATE").is_some() {
            fs::write(Path::new(ROOT).join(&path), &wanted).unwrap();
        } else {
            let page = path.display();
            assert!(read(&path) == wanted, "{page}: GUSSET_UPDATE=1 cargo test --test docs copies the examples in");
        }
    }
    assert!(shown > 20);
}

#[test]
fn the_errata_name_tests_that_there_are() {
    let (page, mut named) = (read("docs/errata.md"), 0);
    for line in page.lines().filter(|line| line.starts_with("| ")) {
        let words: Vec<_> = line.split('`').skip(1).step_by(2).collect();
        let Some(first) = words.iter().position(|word| word.starts_with("tests/")) else { continue };
        // A file, and the tests in it; then perhaps another file.
        for tests in words[first..].chunk_by(|_, word| !word.starts_with("tests/")) {
            assert!(tests.len() > 1, "no test: {line}");
            for test in &tests[1..] {
                assert!(read(tests[0]).contains(&format!("fn {test}(")), "{} has no {test}", tests[0]);
                named += 1;
            }
        }
    }
    assert!(named > 40);
}
