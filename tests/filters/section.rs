//! Sections of meshes: the surface that is cut, the places of the planes, and the curves.

use crate::common::{Soup, sheet, torus};
use crate::editor::{polylines, sphere, values};
use gusset::filters::Filter;
use gusset::filters::data::{Curves, Input, Output};
use gusset::filters::report::Report;
use gusset::{Error, Job, Result};
use std::f64::consts::PI;

fn cut(soup: &Soup, set: &[(&str, &[f64])]) -> Result<(Curves, Report)> {
    let inputs = [Input::Mesh(soup.view())];
    let outputs = Filter::find("section").unwrap().run(&inputs, &values("section", &inputs, set), &Job::default())?;
    match <[Output; 2]>::try_from(outputs).unwrap() {
        [Output::Curves(curves), Output::Text(report)] => Ok((curves, report)),
        other => panic!("{other:?}"),
    }
}

fn number(report: &Report, name: &str) -> f64 {
    report.values().iter().find(|(own, _)| *own == name).unwrap_or_else(|| panic!("{name}: {report}")).1.number
}

/// Each quad as two triangles.
fn in_triangles(soup: &Soup) -> Soup {
    let halves: Vec<[u32; 3]> = soup.faces().flat_map(|f| (1..f.len() - 1).map(|k| [f[0], f[k], f[k + 1]])).collect();
    Soup::new(soup.points.clone(), &halves.iter().map(|face| &face[..]).collect::<Vec<_>>())
}

fn curve(curves: &Curves, c: usize) -> &[[f64; 3]] {
    &curves.points[curves.offsets[c] as usize..curves.offsets[c + 1] as usize]
}

/// A grid of quads is cut as its smooth surface, unless its faces are chosen; triangles are cut as they
/// are.
#[test]
fn the_kind_of_mesh_chooses_the_surface() {
    let grid = sphere(16, 24);
    let off_sphere = |curves: &Curves| {
        let radius = |p: &[f64; 3]| p.iter().map(|x| x * x).sum::<f64>().sqrt();
        curves.points.iter().map(|p| (radius(p) - 1.0).abs()).fold(0.0, f64::max)
    };
    let (smooth, report) = cut(&grid, &[]).unwrap();
    assert!(report.starts_with("10 curves of the smooth surface by 10 planes, 10 of them closed"), "{report}");
    assert!(off_sphere(&smooth) < 1e-3);
    let (chosen, _) = cut(&grid, &[("cut", &[2.0])]).unwrap();
    assert_eq!(chosen, smooth);
    let (faces, report) = cut(&grid, &[("cut", &[1.0])]).unwrap();
    assert!(report.starts_with("10 curves of faces by 10 planes, 10 of them closed"), "{report}");
    assert!((1e-3..5e-2).contains(&off_sphere(&faces)), "{}", off_sphere(&faces));
    let triangles = in_triangles(&grid);
    let (cut_as_is, _) = cut(&triangles, &[]).unwrap();
    assert_eq!(cut_as_is, cut(&triangles, &[("cut", &[1.0])]).unwrap().0);
    let refused = cut(&triangles, &[("cut", &[2.0])]);
    assert!(matches!(refused, Err(Error::NoGrid { .. })), "{refused:?}");
}

/// The sections of a box by given planes have known lengths and areas.
#[test]
fn given_planes_cut_a_box_in_known_rectangles() {
    let corners =
        (0..8).map(|k| [f64::from(k & 1) * 2.0, f64::from(k >> 1 & 1) * 3.0, f64::from(k >> 2) * 4.0]).collect();
    let faces: [&[u32]; 6] = [&[0, 4, 6, 2], &[1, 3, 7, 5], &[0, 1, 5, 4], &[2, 6, 7, 3], &[0, 2, 3, 1], &[4, 5, 7, 6]];
    let soup = Soup::new(corners, &faces);
    let planes: &[(&str, &[f64])] =
        &[("placement", &[1.0]), ("number", &[3.0]), ("offset", &[1.0]), ("distance", &[2.0])];
    let (curves, report) = cut(&soup, planes).unwrap();
    assert_eq!((curves.closed.len(), number(&report, "planes"), number(&report, "length")), (2, 3.0, 20.0));
    assert!(
        report.contains("plane at 1: 1 curve, length 10, area 6\nplane at 3: 1 curve, length 10, area 6\n"),
        "{report}"
    );
    // The rule for faces in a plane: the lid at 4 is seen from below, or not at all.
    for (in_plane, count) in [(0.0, 1), (1.0, 0)] {
        let lid: &[(&str, &[f64])] =
            &[("placement", &[1.0]), ("number", &[1.0]), ("offset", &[4.0]), ("in_plane", &[in_plane])];
        assert_eq!(cut(&soup, lid).unwrap().0.closed, vec![true; count]);
    }
}

/// Each plane about the axis of a torus cuts two rings of the tube.
#[test]
fn planes_about_an_axis_cut_the_tube_of_a_torus() {
    for soup in [torus(48, 24), in_triangles(&torus(48, 24))] {
        let (curves, report) = cut(&soup, &[("placement", &[2.0]), ("number", &[7.0])]).unwrap();
        assert_eq!(curves.closed, [true; 14], "{report}");
        for c in 0..14 {
            let off_plane = |k: u32| {
                let (sine, cosine) = (PI * f64::from(k) / 7.0).sin_cos();
                curve(&curves, c).iter().map(|p| (p[0] * sine - p[1] * cosine).abs()).fold(0.0, f64::max)
            };
            assert!((0..7).map(off_plane).fold(f64::INFINITY, f64::min) < 1e-6, "{c}");
        }
    }
}

/// Points are left out within the tolerance; open meshes give open curves.
#[test]
fn curves_are_simplified_and_may_be_open() {
    let flat = in_triangles(&sheet(40, 30));
    let across: &[(&str, &[f64])] = &[("direction", &[1.0, 0.0, 0.0]), ("number", &[4.0])];
    let (all, _) = cut(&flat, across).unwrap();
    assert_eq!(all.closed, [false; 4]);
    let (few, report) = cut(&flat, &[across, &[("tolerance", &[1e-6])]].concat()).unwrap();
    assert!(few.points.len() < all.points.len() && number(&report, "points") == few.points.len() as f64);
    let beside: &[(&str, &[f64])] = &[("placement", &[1.0]), ("offset", &[5.0])];
    assert_eq!(cut(&flat, beside).unwrap().0, polylines(&[]));
}
