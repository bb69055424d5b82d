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

/// The content of a text file.
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

/// A view of a scanner: a triangle for each three neighbours of its grid that are near each other.
pub fn range_scan(name: &str) -> Option<Soup> {
    let text = text(name)?;
    let mut lines = text.lines();
    let (mut vertices, mut rows, mut columns) = (0, 0, 0);
    for line in lines.by_ref().take_while(|line| line.trim() != "end_header") {
        let words: Vec<&str> = line.split_whitespace().collect();
        match words[..] {
            ["element", "vertex", count] => vertices = count.parse().unwrap(),
            ["obj_info", "num_rows", count] => rows = count.parse().unwrap(),
            ["obj_info", "num_cols", count] => columns = count.parse().unwrap(),
            _ => {}
        }
    }
    let mut soup = Soup { offsets: vec![0], ..Soup::default() };
    for line in lines.by_ref().take(vertices) {
        let mut words = line.split_whitespace();
        soup.points.push(numbers(&mut words, 3).try_into().unwrap());
    }
    let grid: Vec<Option<u32>> = lines.map(|line| line.split_whitespace().nth(1).map(|v| v.parse().unwrap())).collect();
    assert_eq!(grid.len(), rows * columns);
    let distance = |u: u32, v: u32| {
        let [p, q] = [u, v].map(|v| glam::DVec3::from_array(soup.points[v as usize]));
        p.distance(q)
    };
    let mut faces = Vec::new();
    for (i, j) in (1..rows).flat_map(|i| (1..columns).map(move |j| (i, j))) {
        let at = |i: usize, j: usize| grid[i * columns + j];
        let corners = [at(i - 1, j - 1), at(i - 1, j), at(i, j), at(i, j - 1)];
        let there: Vec<u32> = corners.into_iter().flatten().collect();
        match there[..] {
            [a, b, c, d] if distance(a, c) <= distance(b, d) => faces.extend([[a, b, c], [a, c, d]]),
            [a, b, c, d] => faces.extend([[a, b, d], [b, c, d]]),
            [a, b, c] => faces.push([a, b, c]),
            _ => {}
        }
    }
    let mut lengths: Vec<f64> = faces.iter().flat_map(|&[a, b, c]| [distance(a, b), distance(b, c)]).collect();
    lengths.sort_by(f64::total_cmp);
    // Longer ones are steps from one surface to another behind it.
    let longest = 4.0 * lengths[lengths.len() / 2];
    let near = |&[a, b, c]: &[u32; 3]| distance(a, b).max(distance(b, c)).max(distance(c, a)) < longest;
    let faces: Vec<_> = faces.into_iter().filter(near).collect();
    faces.iter().for_each(|face| soup.face(face));
    Some(soup)
}
