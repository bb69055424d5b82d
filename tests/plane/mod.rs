//! What tests of plane outlines share.

#![allow(dead_code, unreachable_pub, reason = "each test file uses a part of it")]

use glam::DVec3;
use gusset::outline::Method;
use std::path::PathBuf;

pub const METHODS: [Method; 5] =
    [Method::Bisector, Method::Median, Method::Normal, Method::Symmedian, Method::Alpha(0.3)];

/// The outlines of the data folder; none, and a word about it, if there is no such folder.
pub fn data() -> Vec<(String, Vec<[f64; 2]>, bool)> {
    let folder = std::env::var_os("GUSSET_DATA").map_or_else(|| PathBuf::from("../shared/data"), PathBuf::from);
    let Ok(entries) = std::fs::read_dir(folder.join("outlines")) else {
        eprintln!("SKIPPED: no outlines in {}; set GUSSET_DATA", folder.display());
        return Vec::new();
    };
    let mut names: Vec<_> = entries.map(|entry| entry.unwrap().path()).collect();
    names.sort();
    let mut outlines = Vec::new();
    for path in names {
        let name = path.file_name().unwrap().to_string_lossy().into_owned();
        if !name.ends_with(".csv") && !name.ends_with(".dat") {
            continue;
        }
        let text = std::fs::read_to_string(&path).unwrap();
        let number = |line: &str| -> Option<[f64; 2]> {
            let mut words = line.split([',', ' ', '\t']).filter(|word| !word.is_empty());
            Some([words.next()?.parse().ok()?, words.next()?.parse().ok()?])
        };
        let points: Vec<[f64; 2]> = text.lines().filter_map(number).collect();
        outlines.push((name.clone(), points, !name.contains("open") && !name.ends_with(".dat")));
    }
    assert!(outlines.len() > 20);
    outlines
}

/// De Casteljau's scheme, on its own.
pub fn casteljau(controls: &[DVec3], t: f64) -> DVec3 {
    let mut points = controls.to_vec();
    while points.len() > 1 {
        points = points.windows(2).map(|pair| pair[0].lerp(pair[1], t)).collect();
    }
    points[0]
}

pub fn lift(p: [f64; 2]) -> DVec3 {
    DVec3::new(p[0], p[1], 0.0)
}
