//! Each operation keeps the values of linear fields at the positions of the result.

use super::{Case, carried};
use crate::common::{Soup, cap, sheet, some_of, torus};
use glam::DVec3;
use gusset::Job;
use gusset::assemble::{self, assemble};
use gusset::attributes::{Domain, Origins, Rule};
use gusset::fill::{self, LoopSelection, fill_holes};
use gusset::repair::orient::{self, orient};
use gusset::repair::sew::sew;
use gusset::repair::weld::{self, weld};
use gusset::stitch::{self, Cells, Finish, Options, Request, Rows, stitch};
use std::collections::HashMap;

pub(super) fn job() -> Job<'static> {
    Job::default()
}

fn moved(mut soup: Soup, by: [f64; 3]) -> Soup {
    soup.points.iter_mut().for_each(|p| (0..3).for_each(|k| p[k] += by[k]));
    soup
}

pub(super) fn stitched(name: &'static str, a: &Soup, b: Option<&Soup>, options: &Options) -> Case {
    let (view_a, view_b) = (a.view(), b.map(Soup::view));
    let request = Request { a: &view_a, loop_a: None, b: view_b.as_ref(), loop_b: None };
    let done = stitch(&request, options, &job()).unwrap();
    let origins = Origins::from_stitch(&done, &job()).unwrap();
    let pieces = [Some(a), b].into_iter().flatten().cloned().collect();
    Case { name, pieces, mesh: done.mesh, origins }
}

fn filled(name: &'static str, soup: &Soup, options: &fill::Options) -> Case {
    let done = fill_holes(&soup.view(), LoopSelection::All, options, &job()).unwrap();
    let origins = Origins::from_filled(&done, &job()).unwrap();
    Case { name, pieces: vec![soup.clone()], mesh: done.mesh, origins }
}

fn assembled(name: &'static str, pieces: Vec<Soup>, options: &assemble::Options<'_>) -> Case {
    let views: Vec<_> = pieces.iter().map(Soup::view).collect();
    let done = assemble(&views, options, &job()).unwrap();
    let origins = Origins::from_assembly(&done, &job()).unwrap();
    Case { name, mesh: done.mesh, origins, pieces }
}

fn sewn(name: &'static str, soup: Soup, options: &weld::Options) -> Case {
    let done = sew(&soup.view(), options, &job()).unwrap();
    assert!(done.splits > 0, "{name}");
    let origins = Origins::from_sew(&done, &job()).unwrap();
    Case { name, mesh: done.mesh, origins, pieces: vec![soup] }
}

fn welded(name: &'static str, soup: Soup, options: &weld::Options) -> Case {
    let done = weld(&soup.view(), options, &job()).unwrap();
    let origins = Origins::from_weld(&done, &job()).unwrap();
    Case { name, mesh: done.mesh, origins, pieces: vec![soup] }
}

/// Two sheets whose borders match at some vertices only, and polygons of four and five corners.
fn junctions() -> Soup {
    let mut upper = sheet(3, 1);
    upper.points.iter_mut().for_each(|p| (p[0], p[1]) = (p[0] * 4.0 / 3.0, p[1] + 2.0));
    let mut triangles = Soup {
        points: vec![[0.0, -1.0, 0.0], [4.0, -1.0, 0.0], [4.0, 0.0, 0.0], [0.0, 0.0, 0.0]],
        offsets: vec![0],
        ..Soup::default()
    };
    triangles.face(&[0, 1, 2]);
    triangles.face(&[0, 2, 3]);
    sheet(4, 2).and(&upper).and(&triangles)
}

/// Triangles of a soup, some of which collapse.
fn needles() -> Soup {
    let mut soup = sheet(6, 6);
    let count = soup.points.len() as u32;
    let copies: Vec<_> = soup.points.iter().map(|p| [p[0] + 1e-9, p[1], 0.0]).collect();
    soup.points.extend(copies);
    // A pentagon with a corner twice, a triangle that is an edge, and a lone point.
    soup.face(&[0, 1, count + 1, 8, 7]);
    soup.face(&[2, count + 2, 9]);
    soup.points.push([9.0, 9.0, 9.0]);
    soup
}

pub(super) fn cases() -> Vec<Case> {
    let (top, bottom) = (cap(24, 5, 0.3, 1.0), cap(17, 4, 0.3, -1.0));
    let rows = Options { rows: Rows::Count(3), ..Options::default() };
    let quads = Options { cells: Cells::Quads, rows: Rows::Count(2), ..Options::default() };
    let arcs = Options { extent: stitch::Extent::OpenArcs, ..Options::default() };
    let bent = {
        let mut soup = cap(40, 8, 0.5, 1.0);
        soup.points.iter_mut().for_each(|p| p[2] += 0.5 * (p[0] * p[0] - 0.6 * p[1] * p[1] + 0.8 * p[0] * p[0] * p[1]));
        soup
    };
    let apart = |y: f64| moved(sheet(5, 2), [0.1, y, 0.2]);
    // A cap below, whose rim is the rim of the cap above for one half, and lower for the other.
    let rim_in_place = {
        let mut soup = cap(24, 5, 0.0, -1.0);
        for (k, p) in cap(24, 5, 0.0, 1.0).points[97..].iter().rev().enumerate() {
            soup.points[97 + k] = [p[0], p[1], if k < 12 { p[2] } else { p[2] - 0.2 }];
        }
        soup
    };
    let refined = fill::Options { refinement: fill::Refinement::RimDensity(10_000), ..fill::Options::default() };
    let all = weld::Options { vertices: weld::Vertices::All, tolerance: Some(1e-6), ..weld::Options::default() };
    let collapsing = weld::Options { collapse: true, remove_unused: true, ..all };
    let octants = || {
        let shell = torus(16, 12);
        (0..4).map(move |k| {
            let mut part = Soup { points: shell.points.clone(), offsets: vec![0], ..Soup::default() };
            shell.faces().enumerate().filter(|(f, _)| f / 48 == k).for_each(|(_, face)| part.face(face));
            if k % 2 == 1 { part.turned() } else { part }
        })
    };
    let torn: Vec<_> = (0..4)
        .map(|k| if k % 2 == 0 { cap(20, 4, 0.4, 1.0) } else { cap(20, 4, 0.4, -1.0).turned() })
        .zip([0.0, 0.0, 5.0, 5.0])
        .map(|(soup, x)| moved(soup, [x, 0.0, 0.0]))
        .collect();
    let oriented = {
        let soup = torus(8, 6).and(&moved(torus(5, 4), [9.0, 0.0, 0.0]).turned());
        let mut mixed = Soup { points: soup.points.clone(), offsets: vec![0], ..Soup::default() };
        for (f, face) in soup.faces().enumerate() {
            let turned: Vec<u32> = face.iter().rev().copied().collect();
            mixed.face(if f % 5 == 2 { &turned } else { face });
        }
        let options = orient::Options { outward: orient::Outward::Closed };
        let done = orient(&mixed.view(), &options, &job()).unwrap();
        let origins = Origins::from_oriented(&done, &job()).unwrap();
        Case { name: "oriented", pieces: vec![mixed], mesh: done.mesh, origins }
    };
    vec![
        stitched("rows", &top, Some(&bottom), &rows),
        stitched("quads", &top, Some(&bottom), &quads),
        stitched("turned", &top, Some(&bottom.turned()), &rows),
        stitched("plain", &top, Some(&bottom), &Options::default()),
        stitched("rims in one place", &cap(24, 5, 0.0, 1.0), Some(&rim_in_place), &Options::default()),
        stitched("arcs", &sheet(4, 2), Some(&apart(2.7)), &arcs),
        stitched("one mesh", &top.and(&bottom.turned()), None, &rows),
        filled("plain patch", &top, &fill::Options::default()),
        filled("fine patch", &top, &refined),
        filled("bent patch", &bent, &refined),
        filled("bent patch far away", &moved(bent.clone(), [100.0, 0.0, 0.0]), &refined),
        filled("inside out", &top.turned(), &fill::Options { outward: orient::Outward::Closed, ..refined }),
        assembled("touching", octants().collect(), &assemble::Options::default()),
        assembled("apart", torn.clone(), &assemble::Options { strip: rows, ..assemble::Options::default() }),
        assembled(
            "filled",
            torn,
            &assemble::Options {
                max_gap: assemble::MaxGap::Given(0.1),
                fill: Some(refined),
                ..assemble::Options::default()
            },
        ),
        assembled("junctions", vec![junctions()], &assemble::Options::default()),
        sewn("sewn", junctions(), &weld::Options::default()),
        sewn("sewn, collapsing", junctions().and(&moved(needles(), [20.0, 0.0, 0.0])), &collapsing),
        welded("welded", needles(), &all),
        welded("welded, collapsing", needles(), &collapsing),
        oriented,
    ]
}

const FIELD: [f64; 4] = [0.7, -1.3, 0.4, 2.0];

fn field(p: DVec3) -> f64 {
    FIELD[0] * p.x + FIELD[1] * p.y + FIELD[2] * p.z + FIELD[3]
}

#[test]
fn linear_fields_are_what_they_are() {
    for case in cases() {
        case.assert_sound();
        let name = case.name;
        let vertices = carried(&case.origins, Domain::Vertices, Rule::Linear, 1, &case.given(Domain::Vertices, field));
        for (v, &value) in vertices.iter().enumerate() {
            let exact = field(case.at(v as u32));
            assert!((value - exact).abs() < 1e-6, "{name}: vertex {v}: {value} for {exact}");
        }
        let corners = carried(&case.origins, Domain::Corners, Rule::Linear, 1, &case.given(Domain::Corners, field));
        for (c, &value) in corners.iter().enumerate() {
            let exact = field(case.at(case.mesh.face_corners[c]));
            assert!((value - exact).abs() < 1e-6, "{name}: corner {c}: {value} for {exact}");
        }
    }
}

/// Each face of the result has the values of a face of the inputs that it is, is a part of, or is
/// near.
#[test]
fn faces_have_the_numbers_of_faces() {
    for case in cases() {
        let mut first = 0.0;
        let mut numbers = Vec::new();
        for piece in &case.pieces {
            numbers.push(piece.faces().enumerate().map(|(f, _)| first + f as f64).collect::<Vec<_>>());
            first += piece.faces().count() as f64;
        }
        let found = carried(&case.origins, Domain::Faces, Rule::Nearest, 1, &numbers);
        let all: Vec<Vec<DVec3>> = case
            .pieces
            .iter()
            .flat_map(|piece| {
                piece.faces().map(|face| face.iter().map(|&v| DVec3::from_array(piece.points[v as usize])).collect())
            })
            .collect();
        let mut same = 0;
        for (f, &number) in found.iter().enumerate() {
            let own: Vec<DVec3> = case.mesh.faces().nth(f).unwrap().iter().map(|&v| case.at(v)).collect();
            let source = &all[number as usize];
            let shared = own.iter().filter(|p| source.iter().any(|q| p.distance(*q) < 1e-6)).count();
            same += usize::from(shared == source.len());
        }
        // Faces that nothing was done to are most of them.
        assert!(same * 2 > all.len(), "{}: {same} of {}", case.name, all.len());
    }
}

#[test]
fn blends_have_both_rims() {
    let (top, bottom) = (cap(24, 5, 0.3, 1.0), cap(17, 4, 0.3, -1.0));
    let case = stitched("blend", &top, Some(&bottom), &Options { finish: Finish::Blend, ..Options::default() });
    case.assert_sound();
    // On the plain strip the height is between the heights of the rims, with any fairing.
    let heights = carried(&case.origins, Domain::Vertices, Rule::Linear, 1, &case.given(Domain::Vertices, |p| p.z));
    let new = &heights[top.points.len() + bottom.points.len()..];
    assert!(!new.is_empty() && new.iter().all(|z| z.abs() < 0.3 + 1e-12));
    assert!(new.iter().any(|z| z.abs() < 0.1));
}

/// Sheets torn at random, with vertices beside the edges of others: sewing splits edges at which
/// strips begin, and each new corner has all of its sources.
#[test]
fn strips_at_split_edges_lose_no_sources() {
    for seed in some_of(4, 0..200) {
        let mut random = fastrand::Rng::with_seed(seed);
        let whole = sheet(3, 3);
        let parts = random.u32(1..4);
        let mut torn = Soup { offsets: vec![0], ..Soup::default() };
        let mut names = HashMap::new();
        for face in whole.faces() {
            let part = random.u32(..parts);
            let mut corners = Vec::new();
            for &v in face {
                let name = *names.entry((part, v)).or_insert_with(|| {
                    let jitter = |x: f64| x + 0.16 * (random.f64() - 0.5);
                    torn.points.push(whole.points[v as usize].map(jitter));
                    torn.points.len() as u32 - 1
                });
                corners.push(name);
            }
            torn.face(&corners);
        }
        let weld = Some(weld::Options { tolerance: Some(0.05), ..weld::Options::default() });
        let pieces = vec![torn, whole];
        let views: Vec<_> = pieces.iter().map(Soup::view).collect();
        let Ok(done) = assemble(&views, &assemble::Options { weld, ..assemble::Options::default() }, &job()) else {
            continue;
        };
        let origins = Origins::from_assembly(&done, &job()).unwrap();
        Case { name: "torn", mesh: done.mesh, origins, pieces }.assert_sound();
    }
}
