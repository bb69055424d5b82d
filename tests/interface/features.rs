//! Cargo gives a package the features that all who are built at once ask for. Were the tests to
//! ask for more than the library, cargo would compile the library twice, once for C and once for
//! them: minutes of `make test`, which builds both at once, and one build would remove the file
//! that the tests of the other are about to read.

use std::collections::BTreeSet;
use std::env;
use std::process::Command;

/// The packages of which a package of this workspace is made, each with its features.
fn made_of(package: &[&str]) -> BTreeSet<String> {
    let arguments = ["tree", "--locked", "--offline", "--prefix", "none", "-e", "normal,build", "-f", "{p} {f}"];
    let tree = Command::new(env::var("CARGO").unwrap())
        .args(arguments)
        .args(package)
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .output()
        .unwrap();
    assert!(tree.status.success(), "{}", String::from_utf8_lossy(&tree.stderr));
    let listing = String::from_utf8(tree.stdout).unwrap();
    listing.lines().map(|line| line.trim_end_matches("(*)").trim_end().to_owned()).collect()
}

#[test]
fn the_tests_ask_for_no_more_than_the_library() {
    let alone = made_of(&["-p", "gusset", "--features", "reserve"]);
    assert!(alone.len() > 10, "{alone:?}");
    let with_the_tests = made_of(&["-p", "gusset-tests"]);
    let changed: Vec<_> = alone.difference(&with_the_tests).collect();
    assert!(changed.is_empty(), "with other features among the tests: {changed:?}");
}

/// The allocator of a program is its own choice: what it links has the reserve only where it asks.
#[test]
fn the_crate_has_no_reserve_unless_it_is_asked_for() {
    let features = |package: &[&str]| {
        let all = made_of(package);
        let own = all.iter().find(|line| line.starts_with("gusset v")).unwrap();
        own.rsplit_once(')').unwrap().1.trim().to_owned()
    };
    assert_eq!(features(&["-p", "gusset"]), "");
    assert_eq!(features(&["-p", "gusset", "--features", "reserve"]), "reserve");
    // Set by cargo-c, which makes libraries for C.
    assert_eq!(features(&["-p", "gusset", "--features", "capi"]), "capi,reserve");
}
