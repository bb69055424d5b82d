//! A short run of each fuzzer, on cases that are always the same: `make fuzz` has the long ones.

use gusset_fuzz::{SEEDS, TARGETS, changed, run, seed_bytes};
use std::collections::BTreeSet;
use std::panic::catch_unwind;
use std::path::PathBuf;
use std::time::Instant;
use std::{env, fs};

/// Cases of a target. Slow targets have fewer cases.
fn case_count(name: &str) -> u64 {
    match name {
        "filters" => 300,
        "surface_paths" => 8,
        "assemble" | "curve_meet" | "curve_net" | "fill" | "overlaps" | "stitch" => 60,
        "surface_lines" => 30,
        _ => 150,
    }
}

#[test]
fn each_target_runs_for_a_moment() {
    let mut failed = Vec::new();
    for (name, _) in TARGETS {
        let begun = Instant::now();
        for number in 0..case_count(name) {
            let bytes = seed_bytes(number);
            if catch_unwind(|| run(name, &bytes)).is_err() {
                failed.push((name, number));
            }
        }
        println!("{name}: {} cases, {:.2} s", case_count(name), begun.elapsed().as_secs_f64());
    }
    assert!(failed.is_empty(), "{failed:?}");
}

/// Valid and hostile files, and files that differ from them in a few bytes.
#[test]
fn each_reader_copes_with_changed_files() {
    const CHANGES: u64 = 40;
    let mut failed = Vec::new();
    for (name, seeds) in SEEDS {
        let begun = Instant::now();
        for (seed, file) in seeds().iter().enumerate() {
            for number in 0..=CHANGES {
                let bytes = if number == 0 { file.clone() } else { changed(file, number) };
                if catch_unwind(|| run(name, &bytes)).is_err() {
                    failed.push((name, seed, number));
                }
            }
        }
        println!("{name}: {:.2} s", begun.elapsed().as_secs_f64());
    }
    assert!(failed.is_empty(), "{failed:?}");
}

/// Fixed findings of the fuzzers: see the README of the folder.
#[test]
fn what_was_found_is_mended() {
    let folder = PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/../fuzz/found"));
    let folder = env::var_os("GUSSET_FOUND").map_or(folder, PathBuf::from);
    let mut failed = Vec::new();
    for (name, _) in TARGETS {
        let Ok(files) = fs::read_dir(folder.join(name)) else { continue };
        for file in files.map(|file| file.unwrap().path()) {
            let bytes = fs::read(&file).unwrap();
            let begun = Instant::now();
            if catch_unwind(|| run(name, &bytes)).is_err() {
                failed.push(file.clone());
            }
            println!("{}: {:.2} s", file.display(), begun.elapsed().as_secs_f64());
        }
    }
    assert!(failed.is_empty(), "{failed:?}");
}

#[test]
fn each_fuzzer_is_in_the_table() {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../fuzz/fuzz_targets");
    let files = fs::read_dir(folder).unwrap().map(|file| file.unwrap().path());
    let names: BTreeSet<_> = files.map(|file| file.file_stem().unwrap().to_str().unwrap().to_owned()).collect();
    assert_eq!(names, TARGETS.iter().map(|(name, _)| (*name).to_owned()).collect());
    let manifest = include_str!("../../fuzz/Cargo.toml");
    assert!(names.iter().all(|name| manifest.contains(&format!("name = \"{name}\""))));
}
