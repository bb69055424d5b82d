//! Outlines: the curves pass their points, are smooth where they should be, and move with their points.

use gusset::Job;
use gusset::outline::{Constraint, Demand, FitStatus, Method, Mode, Options, Outlines, PointStatus, Points, fit};
use std::path::PathBuf;

/// The outlines of the data folder; none, and a word about it, if there is no such folder.
fn data() -> Vec<(String, Vec<[f64; 2]>, bool)> {
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

#[test]
fn speed() {
    let all: Vec<_> = data().into_iter().filter(|outline| outline.2).collect();
    let mut points: Vec<[f64; 2]> = Vec::new();
    let mut offsets = vec![0u32];
    for (_, outline, _) in &all {
        points.extend(outline);
        offsets.push(points.len() as u32);
    }
    for method in [Method::Bisector, Method::Median, Method::Symmedian, Method::Normal] {
        let outlines =
            Outlines { points: Points::from(&points[..]), offsets: Some(&offsets), closed: true, constraints: &[] };
        let options = Options { method, ..Options::default() };
        let job = Job::default();
        let mut times: Vec<f64> = (0..50)
            .map(|_| {
                let start = std::time::Instant::now();
                let done = fit(&outlines, &options, &job).unwrap();
                let time = start.elapsed().as_secs_f64() * 1e9 / points.len() as f64;
                assert!(done.len() == all.len());
                time
            })
            .collect();
        times.sort_by(f64::total_cmp);
        let done = fit(&outlines, &options, &job).unwrap();
        let worst = done.reports().iter().map(|r| r.max_residual).fold(0.0, f64::max);
        let sine = done.reports().iter().map(|r| r.max_joint_sine).fold(0.0, f64::max);
        println!("{method:?} {} points {:.1} ns residual {worst:e} sine {sine:e}", points.len(), times[25]);
        for (k, report) in done.reports().iter().enumerate() {
            if report.max_joint_sine > 1e-13 || report.status != FitStatus::Ok {
                println!("{} {report:?}", all[k].0);
            }
        }
    }
}
