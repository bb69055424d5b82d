//! A real part with sharp edges: the fandisk of H. Hoppe and others (1994), of which discs round points
//! of its feature edges are cut out.

use crate::common::data;

use super::case::{Case, options, sharp_edges};
use glam::DVec3;

fn fandisk() -> Option<(Vec<DVec3>, Vec<[u32; 3]>)> {
    let text = data::text("meshes/fandisk.obj")?;
    let (mut points, mut triangles) = (Vec::new(), Vec::new());
    for line in text.lines() {
        let words: Vec<_> = line.split_whitespace().collect();
        match words[..] {
            ["v", x, y, z] => points.push(DVec3::from([x, y, z].map(|x| x.parse().unwrap()))),
            ["f", a, b, c] => {
                let vertex = |word: &str| word.split('/').next().unwrap().parse::<u32>().unwrap() - 1;
                triangles.push([a, b, c].map(vertex));
            }
            _ => {}
        }
    }
    Some((points, triangles))
}

#[test]
fn feature_edges_of_the_fandisk_go_on() {
    let Some((points, triangles)) = fandisk() else {
        return;
    };
    let edges = sharp_edges(&points, &triangles, |_| true);
    let edges: Vec<_> = edges.into_iter().map(|edge| edge.map(|v| points[v as usize])).collect();
    let mean = edges.iter().map(|[p, q]| p.distance(*q)).sum::<f64>() / edges.len() as f64;
    for times in [3.0, 5.0] {
        let mut found: Vec<(&str, f64)> = Vec::new();
        for &[p, q] in edges.iter().step_by(9) {
            let case = Case {
                points: points.clone(),
                triangles: triangles.clone(),
                centre: p.midpoint(q),
                radius: times * mean,
                surface: None,
            };
            let kind = match case.inside() {
                [0, 0, 0] => "smooth",
                [1, 0, 0] => "branch",
                [0, _, 0] => "kink",
                _ => "other",
            };
            if kind == "other" {
                continue;
            }
            found.extend(case.filled_if_disc(&options(true)).map(|(_, errors)| (kind, errors.surface)));
        }
        for kind in ["smooth", "branch", "kink"] {
            let mut all: Vec<_> = found.iter().filter(|found| found.0 == kind).map(|found| found.1).collect();
            all.sort_by(f64::total_cmp);
            if all.is_empty() {
                continue;
            }
            let below = all.iter().filter(|&&error| error <= 0.02).count();
            let at = |share: usize| all[(all.len() - 1) * share / 100];
            if kind == "smooth" {
                // The others turn within the hole, by less than a corner does, or fade.
                assert!(below * 100 >= 75 * all.len() && at(50) <= 0.005, "{times} edges: {all:?}");
            }
            println!(
                "{times} edges, {kind}: {} discs, {below} within 2 %, median {:.4}, 90 % {:.4}, most {:.4}",
                all.len(),
                at(50),
                at(90),
                at(100)
            );
        }
    }
}
