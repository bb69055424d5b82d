//! A patch must not intersect faces, fold back onto polygons, or leave the neighbourhood of its
//! rim; its report must be true.

use crate::common::{Soup, cap, edge_counts, faces_of, sheet, torus};
use gusset::Job;
use gusset::boundary::{self, boundary_loops};
use gusset::fill::{
    Continuity, Fairing, Filled, Finish, HoleStatus, Keep, Limits, LoopSelection, Options, Refinement, Together,
    Weight, fill_holes,
};
use gusset::repair::orient::Outward;
use gusset::stitch::{self, Intersections};
use proptest::prelude::*;
use std::f64::consts::TAU;

const FAIR: Options = Options {
    weight: Weight::Continuation,
    finish: stitch::Finish::Strip,
    refinement: Refinement::RimDensity(0),
    fairing: Fairing::ThinPlate,
    continuity: Continuity::C1,
    ignore_creases: false,
    intersections: Intersections::Auto,
    limits: Limits { edges: None, length: None, diameter: None, area: None },
    keep: Keep::None,
    together: Together::Apart,
    plan_only: false,
    outward: Outward::Keep,
};

fn fill(soup: &Soup, options: &Options) -> Filled {
    fill_holes(&soup.view(), LoopSelection::All, options, &Job::default()).unwrap()
}

/// The result as triangles: polygons cut into fans from the corner that `first` says.
fn triangulated(filled: &Filled, first: usize) -> Vec<[u32; 3]> {
    let faces = filled.mesh.face_offsets.windows(2).map(|w| &filled.mesh.face_corners[w[0] as usize..w[1] as usize]);
    let fans = faces.flat_map(|face| {
        let n = face.len();
        let corner = move |k: usize| face[(first + k) % n];
        (1..n - 1).map(move |k| [corner(0), corner(k), corner(k + 1)])
    });
    fans.collect()
}

/// A tube of quads from z = 0 to `height`, its radius by the angle, and two open ends.
fn tube(columns: u32, height: f64, radius: impl Fn(f64) -> f64) -> Soup {
    let mut soup = Soup { offsets: vec![0], ..Soup::default() };
    let rows = 4;
    for row in 0..=rows {
        for k in 0..columns {
            let angle = TAU * f64::from(k) / f64::from(columns);
            let r = radius(angle);
            soup.points.push([r * angle.cos(), r * angle.sin(), height * f64::from(row) / f64::from(rows)]);
        }
    }
    for row in 0..rows {
        for k in 0..columns {
            let (a, b) = (row * columns + k, row * columns + (k + 1) % columns);
            soup.face(&[a, b, b + columns, a + columns]);
        }
    }
    soup
}

#[test]
fn no_weight_cuts_less_than_the_default() {
    let shapes = [
        tube(136, 2.0, |_| 1.0),
        tube(90, 1.0, |angle| 1.0 + 0.3 * (5.0 * angle).cos()),
        tube(40, 0.5, |angle| 1.0 + 0.8 * (2.0 * angle).cos()),
        cap(54, 20, 0.4, 1.0),
        cap(300, 40, -0.6, 1.0),
    ];
    for (number, soup) in shapes.iter().enumerate() {
        let cuts = |options: &Options| fill(soup, options).intersections.unwrap().len();
        for (refinement, fairing) in [
            (Refinement::None, Fairing::None),
            (Refinement::RimDensity(0), Fairing::None),
            (Refinement::RimDensity(0), Fairing::ThinPlate),
        ] {
            let options = Options { refinement, fairing, ..FAIR };
            let own = cuts(&options);
            for weight in [Weight::AreaAndBend, Weight::BendThenArea, Weight::Area] {
                let other = Options { weight, intersections: Intersections::Report, ..Options::default() };
                assert!(own <= cuts(&other), "shape {number}, {weight:?}");
            }
            assert_eq!(own, 0, "shape {number}");
        }
    }
}

/// Cuts a sheet of quads along x = `column` from y = 1 to y = 8: the quads to the right get new
/// vertices there, which come last.
fn slit(soup: &mut Soup, columns: u32, column: u32) -> std::ops::Range<usize> {
    let first = soup.points.len();
    for j in 2..8 {
        let v = j * (columns + 1) + column;
        let own = soup.points.len() as u32;
        soup.points.push(soup.points[v as usize]);
        for corners in soup.corners.chunks_exact_mut(4) {
            if corners.iter().any(|&w| w < first as u32 && w % (columns + 1) > column) {
                corners.iter_mut().filter(|w| **w == v).for_each(|w| *w = own);
            }
        }
    }
    first..soup.points.len()
}

/// Fills all loops but the longest, even where they are not sewn.
fn fill_inner_loops(soup: &Soup, options: &Options) -> Filled {
    let every = boundary_loops(&soup.view(), &boundary::Options::default(), &Job::default()).unwrap();
    let mut loops: Vec<&[u32]> = every.iter().map(|found| found.vertices).collect();
    loops.sort_by_key(|vertices| vertices.len());
    loops.pop();
    fill_holes(&soup.view(), LoopSelection::Loops(&loops), options, &Job::default()).unwrap()
}

/// Nothing is gained by a band between two slits, on faces that are there.
#[test]
fn slits_are_not_joined_with_each_other() {
    let mut soup = sheet(9, 9);
    slit(&mut soup, 9, 3);
    slit(&mut soup, 9, 6);
    for options in [Options::default(), FAIR] {
        let filled = fill_inner_loops(&soup, &Options { together: Together::Cheapest, ..options });
        let patches: Vec<u32> = filled.holes.iter().map(|hole| hole.patch).filter(|&patch| patch != u32::MAX).collect();
        assert_eq!(patches, [0, 1]);
        assert_eq!(filled.intersections.as_deref(), Some(&[][..]));
    }
}

/// A sheet cut along an inner line without moving, like a texture seam, or slightly opened at
/// places. The patch has area only where the slit is open, and nowhere lies back to back.
#[test]
fn slits_whose_sides_coincide_are_closed_without_area() {
    let mut random = fastrand::Rng::with_seed(5);
    for (case, opened) in [0, 1, 2, 4].into_iter().enumerate() {
        for bent in [0.0, 0.3] {
            let mut soup = sheet(9, 9);
            let slit = slit(&mut soup, 9, 4);
            soup.points.iter_mut().for_each(|p| p[2] += bent * (0.7 * p[0]).sin() * (0.9 * p[1]).cos());
            let width = 0.2;
            for _ in 0..opened {
                soup.points[slit.start + random.usize(0..slit.len())][0] += width;
            }
            for options in [Options::default(), FAIR] {
                let filled = fill_inner_loops(&soup, &options);
                assert_eq!(filled.intersections.as_deref(), Some(&[][..]), "case {case}, {bent}");
                let counts = edge_counts(faces_of(&filled.mesh));
                assert_eq!(counts.values().filter(|&&counts| counts != (1, 1)).count(), 36, "case {case}, {bent}");
                let point = |v: u32| glam::DVec3::from_array(filled.mesh.positions.get(v).to_array());
                let areas = faces_of(&filled.mesh).skip(81).map(|face| {
                    let [a, b, c] = [0, 1, 2].map(|k| point(face[k]));
                    (b - a).cross(c - a).length() / 2.0
                });
                let area: f64 = areas.sum();
                // Each vertex that was moved opens two triangles at the most.
                let open = f64::from(opened as u32) * width * 1.3;
                assert!(area <= 1e-12 + open, "case {case}, {bent}: {area}");
            }
        }
    }
}

#[test]
fn cuts_that_cannot_be_avoided_are_reported() {
    // A rim that goes twice round, the second time beside the first: a disc between them cuts itself.
    let n = 48;
    let mut soup = Soup { offsets: vec![0], ..Soup::default() };
    for z in [0.0, -0.1] {
        for k in 0..n {
            let t = 2.0 * TAU * f64::from(k) / f64::from(n);
            let r = 1.0 + 0.5 * (t / 2.0).cos();
            soup.points.push([r * t.cos(), r * t.sin(), 0.3 * (t / 2.0).sin() + z]);
        }
    }
    (0..n).for_each(|k| soup.face(&[k, k + n, (k + 1) % n + n, (k + 1) % n]));
    let top: Vec<u32> = (0..n).collect();
    let of = |intersections: Intersections| {
        let options = Options { intersections, ..Options::default() };
        fill_holes(&soup.view(), LoopSelection::Loops(&[&top]), &options, &Job::default()).unwrap()
    };
    let (avoided, reported) = (of(Intersections::Auto), of(Intersections::Report));
    let first = soup.offsets.len() as u32 - 1;
    for filled in [&avoided, &reported] {
        let pairs = filled.intersections.as_ref().unwrap();
        assert!(!pairs.is_empty() && pairs.is_sorted());
        assert!(pairs.iter().all(|&[f, g]| f >= first && g < f));
    }
    assert!(avoided.intersections.unwrap().len() <= reported.intersections.unwrap().len());
    assert_eq!(of(Intersections::Ignore).intersections, None);
}

proptest! {
    /// Grids of quads with cells taken out: where the result is closed, it stays so when quads are cut along
    /// either diagonal.
    #[test]
    fn closed_as_polygons_is_closed_as_triangles(gone in prop::collection::vec((0u32..5, 0u32..5), 1..9), fair: bool) {
        let mut full = sheet(5, 5);
        full.points.iter_mut().for_each(|p| p[2] += 0.3 * (2.0 * p[0]).sin() * p[1]);
        let mut soup = Soup { points: full.points.clone(), offsets: vec![0], ..Soup::default() };
        for (k, face) in full.faces().enumerate() {
            let cell = (k as u32 % 5, k as u32 / 5);
            if !gone.contains(&cell) {
                soup.face(face);
            }
        }
        prop_assume!(soup.offsets.len() > 1);
        let options = if fair { FAIR } else { Options::default() };
        let filled = fill(&soup, &options);
        prop_assume!(filled.quality.loops_left == 0);
        for first in 0..2 {
            for (edge, counts) in edge_counts(triangulated(&filled, first).iter().map(<[u32; 3]>::as_slice)) {
                prop_assert_eq!(counts, (1, 1), "edge {:?}", edge);
            }
        }
    }
}

#[test]
fn parents_place_new_vertices_on_the_plain_patch() {
    let open = cap(48, 24, 0.3, 1.0);
    let options = Options { fairing: Fairing::None, ..FAIR };
    let filled = fill(&open, &options);
    let hole = &filled.holes[0];
    assert_eq!((hole.finish, hole.vertices.len()), (Finish::Refined, filled.parents.len()));
    for ((v, parents), weights) in hole.vertices.clone().zip(&filled.parents).zip(&filled.weights) {
        assert!(weights.iter().all(|&w| w >= 0.0) && (weights.iter().sum::<f64>() - 1.0).abs() < 1e-12);
        assert!(parents.iter().all(|p| filled.rims[hole.rim.clone()].contains(p)));
        let at = |v: u32| filled.mesh.positions.get(v);
        let place = (0..3).map(|k| weights[k] * at(parents[k])).sum::<glam::DVec3>();
        assert!(place.distance(at(v)) < 1e-9);
    }
}

#[test]
fn faired_patches_stay_near_their_rims() {
    // A spike beside the hole tilts the tangent planes there.
    let mut open = cap(24, 6, 0.2, 1.0);
    let rim = open.points.len() - 24;
    for k in 0..24 {
        let p = &mut open.points[rim - 24 + k];
        *p = [p[0] * 1.8, p[1] * 1.8, p[2] - 1.0];
    }
    let filled = fill(&open, &FAIR);
    let hole = &filled.holes[0];
    let points: Vec<_> = filled.rims[hole.rim.clone()].iter().map(|&v| filled.mesh.positions.get(v)).collect();
    let (low, high) = points.iter().fold((points[0], points[0]), |(low, high), &p| (low.min(p), high.max(p)));
    let room = 0.5 * low.distance(high) + 1e-9;
    for v in hole.vertices.clone() {
        let p = filled.mesh.positions.get(v);
        assert!(p.cmpge(low - room).all() && p.cmple(high + room).all(), "{p}");
    }
}

#[test]
fn plans_and_limits() {
    let soup = tube(30, 1.0, |_| 1.0);
    let plan = fill(&soup, &Options { plan_only: true, ..Options::default() });
    assert_eq!(plan.mesh.face_count(), soup.offsets.len() - 1);
    assert_eq!(plan.intersections, None);
    let side = 2.0 * (TAU / 60.0).sin();
    for hole in &plan.holes {
        assert_eq!((hole.status, hole.faces.len()), (HoleStatus::Filled, 0));
        assert!((hole.measures.length - 30.0 * side).abs() < 1e-12);
        assert!((hole.measures.area - 15.0 * (TAU / 30.0).sin()).abs() < 1e-12);
        assert!((hole.measures.diameter - 8f64.sqrt()).abs() < 0.02);
    }
    let faired = fill(&soup, &Options { plan_only: true, ..FAIR });
    assert!(faired.holes.iter().all(|hole| hole.finish == Finish::Faired && hole.vertices.is_empty()));
    // A closed component that is inside out: turned with the holes, but not by a plan.
    let turned = |soup: &Soup, plan_only: bool| {
        let options = Options { plan_only, outward: Outward::Closed, ..Options::default() };
        fill(soup, &options).turned_outwards.len()
    };
    let both = [torus(6, 5), torus(6, 5).turned()].map(|torus| soup.and(&torus));
    assert_eq!(both.each_ref().map(|soup| turned(soup, true)), [0, 0]);
    assert_ne!(turned(&both[0], false), turned(&both[1], false));
    let area = plan.holes[0].measures.area;
    for (limit, status) in [(area * 0.99, HoleStatus::TooLarge), (area * 1.01, HoleStatus::Filled)] {
        let limits = Limits { area: Some(limit), ..Limits::default() };
        let filled = fill(&soup, &Options { limits, ..Options::default() });
        assert!(filled.holes.iter().all(|hole| hole.status == status));
    }
}

#[test]
fn borders_are_told_from_holes() {
    // A sheet with a hole inside its outline. A cup: its only loop is a hole.
    let mut full = sheet(11, 11);
    full.points.iter_mut().for_each(|p| p[2] += 0.02 * p[0] * p[1]);
    let mut holed = Soup { points: full.points.clone(), offsets: vec![0], ..Soup::default() };
    full.faces().enumerate().filter(|(k, _)| ![60, 61, 71].contains(k)).for_each(|(_, face)| holed.face(face));
    let options = Options { keep: Keep::OuterBorders, ..Options::default() };
    let statuses: Vec<_> = fill(&holed, &options).holes.iter().map(|hole| (hole.rim.len(), hole.status)).collect();
    let (outer, inner): (Vec<_>, Vec<_>) = statuses.into_iter().partition(|&(length, _)| length > 20);
    assert_eq!((outer.len(), outer[0].1), (1, HoleStatus::Kept));
    assert!(!inner.is_empty() && inner.iter().all(|(_, status)| *status == HoleStatus::Filled));
    let cup = cap(24, 12, -0.6, 1.0);
    assert!(fill(&cup, &options).holes.iter().all(|hole| hole.status == HoleStatus::Filled));
}

#[test]
fn long_rims_are_like_short_ones() {
    // The same wavy rim with 100 to 3,000 vertices: patches of the same area, without a cut.
    let areas: Vec<f64> = [100, 128, 129, 400, 3000]
        .into_iter()
        .map(|n| {
            let soup = tube(n, 0.2, |angle| 1.0 + 0.1 * (7.0 * angle).sin());
            let bent: Vec<_> = soup.points.iter().map(|p| [p[0], p[1], p[2] + 0.2 * p[0] * p[1]]).collect();
            let filled = fill(&Soup { points: bent, ..soup }, &Options::default());
            assert_eq!(filled.intersections.as_deref(), Some(&[][..]), "{n}");
            filled.quality.area
        })
        .collect();
    assert!(areas.iter().all(|area| (area / areas[0] - 1.0).abs() < 0.02), "{areas:?}");
}
