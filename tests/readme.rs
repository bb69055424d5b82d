//! The examples in README.md are the files that the tests compile. `GUSSET_UPDATE=1 cargo test --test readme` copies them in.

use std::{env, fs, path::Path};

#[test]
fn examples_are_the_files_that_are_compiled() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let readme = fs::read_to_string(root.join("README.md")).unwrap();
    let mut wanted = String::new();
    let mut lines = readme.lines();
    let mut examples = 0;
    while let Some(line) = lines.next() {
        wanted += &(line.to_owned() + "\n");
        // A block that names its file: ```c examples/c/stitch.c
        if let Some((_, file)) = line.strip_prefix("```").and_then(|info| info.split_once(' ')) {
            examples += 1;
            wanted += &fs::read_to_string(root.join(file)).unwrap();
            wanted += "```\n";
            assert!(lines.by_ref().any(|line| line == "```"), "{file}: the block does not end");
        }
    }
    assert_eq!(examples, 2);
    if env::var_os("GUSSET_UPDATE").is_some() {
        fs::write(root.join("README.md"), &wanted).unwrap();
    } else {
        assert!(
            readme == wanted,
            "README.md and examples/ differ; GUSSET_UPDATE=1 cargo test --test readme copies them"
        );
    }
}
