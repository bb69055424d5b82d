//! Real data, which the project has not: in the folder that GUSSET_DATA names, or in its usual place.

use super::Soup;
use std::path::{Path, PathBuf};

/// A file or a folder of the data. Says so if it is not there: what needs it is skipped.
pub fn path(name: &str) -> Option<PathBuf> {
    let usual = || Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/..")).join("../shared/data");
    let found = std::env::var_os("GUSSET_DATA").map_or_else(usual, PathBuf::from).join(name);
    if found.exists() {
        return Some(found);
    }
    println!("SKIPPED: no {}; set GUSSET_DATA", found.display());
    None
}

/// What is in a file of text.
pub fn text(name: &str) -> Option<String> {
    path(name).map(|path| std::fs::read_to_string(path).unwrap())
}

/// A mesh in OFF.
pub fn off(name: &str) -> Option<Soup> {
    let text = text(name)?;
    // Without the comments; and, as some have it, the numbers at once after the word.
    let lines = text.lines().map(|line| line.split('#').next().unwrap_or_default());
    let text = lines.collect::<Vec<_>>().join("\n");
    let mut words = text.trim_start().strip_prefix("OFF").unwrap().split_whitespace();
    let mut soup = Soup { offsets: vec![0], ..Soup::default() };
    let counts = numbers(&mut words, 3);
    for _ in 0..counts[0] as usize {
        soup.points.push(numbers(&mut words, 3).try_into().unwrap());
    }
    for _ in 0..counts[1] as usize {
        let n = numbers(&mut words, 1)[0] as usize;
        soup.face(&numbers(&mut words, n).iter().map(|&v| v as u32).collect::<Vec<_>>());
    }
    Some(soup)
}

fn numbers<'a>(words: &mut impl Iterator<Item = &'a str>, count: usize) -> Vec<f64> {
    words.take(count).map(|word| word.parse().unwrap()).collect()
}
