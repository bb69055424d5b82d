//! Filling, held against shapes of known area and volume, all triangulations of small loops, and
//! Euler's formula.

use crate::common::{Soup, cap, edge_counts, euler, sheet, volume};
use gusset::assemble::{self, assemble};
use gusset::fill::{
    Continuity, Fairing, Filled, Finish, HoleStatus, Keep, Limits, LoopSelection, Options, Refinement, Together,
    Weight, fill_holes,
};
use gusset::mesh::Mesh;
use gusset::repair::orient::Outward;
use gusset::stitch::{self, Intersections};
use gusset::{Error, Job};
use proptest::prelude::*;
use std::f64::consts::{PI, TAU};

const AREA: Options = Options {
    weight: Weight::Area,
    finish: stitch::Finish::Strip,
    refinement: Refinement::None,
    fairing: Fairing::None,
    continuity: Continuity::C1,
    ignore_creases: false,
    limits: Limits { edges: None, length: None, diameter: None, area: None },
    keep: Keep::None,
    intersections: Intersections::Report,
    together: Together::Apart,
    plan_only: false,
    outward: Outward::Keep,
};
/// The defaults, but every loop is a hole.
fn every_loop() -> Options {
    Options { keep: Keep::None, ..Options::default() }
}

const REFINED: Options = Options { weight: Weight::AreaAndBend, refinement: Refinement::RimDensity(0), ..AREA };
const LIEPA: Options = Options { weight: Weight::BendThenArea, ..AREA };
const FAIR: Options = Options { fairing: Fairing::ThinPlate, ..REFINED };

fn fill(soup: &Soup, options: &Options) -> Filled {
    fill_holes(&soup.view(), LoopSelection::All, options, &Job::default()).unwrap()
}

fn faces(mesh: &Mesh) -> impl Iterator<Item = &[u32]> + Clone {
    mesh.face_offsets.windows(2).map(|w| &mesh.face_corners[w[0] as usize..w[1] as usize])
}

fn statuses(filled: &Filled) -> Vec<HoleStatus> {
    filled.holes.iter().map(|hole| hole.status).collect()
}

/// Closed, manifold at every edge, consistently oriented; and the old mesh is the beginning of it.
fn assert_closed(soup: &Soup, filled: &Filled) {
    for (edge, counts) in edge_counts(faces(&filled.mesh)) {
        assert_eq!(counts, (1, 1), "edge {edge:?}");
    }
    assert!(soup.faces().eq(faces(&filled.mesh).take(soup.faces().count())));
    for (v, point) in soup.points.iter().enumerate() {
        assert_eq!(filled.mesh.positions.get(v as u32).to_array(), *point);
    }
    assert_eq!(filled.quality.loops_left, 0);
}

fn volume_of(mesh: &Mesh) -> f64 {
    volume(|v| mesh.positions.get(v).to_array(), faces(mesh))
}

/// A fan of long triangles from the loop through `points` to one far vertex: an open cone whose rim
/// is the loop. Seen from the far vertex, the loop is clockwise, so that its patch faces away.
fn cone(points: &[[f64; 3]], tip: [f64; 3]) -> Soup {
    let n = points.len() as u32;
    let mut soup = Soup { points: points.to_vec(), offsets: vec![0], ..Soup::default() };
    soup.points.push(tip);
    (0..n).for_each(|i| soup.face(&[(i + 1) % n, i, n]));
    soup
}

fn area_of(filled: &Filled, signed_along: [f64; 3]) -> (f64, f64) {
    let (mut area, mut signed) = (0.0, 0.0);
    let axis = glam::DVec3::from_array(signed_along);
    for hole in &filled.holes {
        for f in hole.faces.clone() {
            let face: Vec<_> = faces(&filled.mesh).nth(f as usize).unwrap().to_vec();
            let [a, b, c] = [0, 1, 2].map(|k| filled.mesh.positions.get(face[k]));
            let vector = (b - a).cross(c - a) / 2.0;
            area += vector.length();
            signed += vector.dot(axis);
        }
    }
    (area, signed)
}

#[test]
fn a_cap_of_a_sphere_is_restored() {
    for rim in [0.3, 0.6, 0.8] {
        let open = cap(48, 24, -rim, 1.0);
        // The polyhedron itself lacks about 1 % of the ball.
        let whole = 4.0 / 3.0 * PI;
        let missing = PI * (1.0 - rim) * (1.0 - rim) * (2.0 + rim) / 3.0;
        let flat = fill(&open, &Options::default());
        assert_closed(&open, &flat);
        assert_eq!(euler(faces(&flat.mesh)), 2);
        assert_eq!((flat.holes[0].faces.len(), flat.holes[0].vertices.len()), (46, 0));
        assert!((volume_of(&flat.mesh) - (whole - missing)).abs() < 0.05, "{rim}");

        let fair = fill(&open, &FAIR);
        assert_closed(&open, &fair);
        assert_eq!(euler(faces(&fair.mesh)), 2);
        let gained = (volume_of(&fair.mesh) - volume_of(&flat.mesh)) / missing;
        assert!((gained - 1.0).abs() < 0.15, "{rim}: {gained} of the missing cap");
        assert!(fair.quality.min_angle > 0.2 && fair.quality.max_aspect < 4.0, "{:?}", fair.quality);
        for v in fair.holes[0].vertices.clone() {
            let off = fair.mesh.positions.get(v).length() - 1.0;
            assert!(off.abs() < 0.4 * (1.0 - rim), "{rim}: {off}");
        }
    }
}

#[test]
fn refined_faces_are_as_small_as_their_neighbours() {
    let open = cap(48, 24, -0.3, 1.0);
    let flat = fill(&open, &Options::default());
    let refined = fill(&open, &REFINED);
    assert_closed(&open, &refined);
    // The hole is flat, so refinement changes no area.
    assert!((refined.quality.area / flat.quality.area - 1.0).abs() < 1e-9);
    let count = refined.holes[0].vertices.len();
    assert_eq!(refined.holes[0].faces.len(), 46 + 2 * count);
    assert!(refined.quality.max_edge < 0.4 && refined.quality.min_angle > 0.3, "{:?}", refined.quality);

    let few = fill(&open, &Options { refinement: Refinement::RimDensity(20), ..REFINED });
    assert_closed(&open, &few);
    assert!((5..=40).contains(&few.holes[0].vertices.len()), "{}", few.holes[0].vertices.len());
}

/// A comb with `teeth` teeth, counter-clockwise, of the area given.
fn comb(teeth: u32) -> (Vec<[f64; 3]>, f64) {
    let mut points = vec![[0.0, -1.0, 0.0], [f64::from(teeth), -1.0, 0.0]];
    for i in (0..teeth).rev() {
        let x = f64::from(i);
        points.extend([[x + 1.0, 0.0, 0.0], [x + 0.9, 5.0, 0.0], [x + 0.5, 5.5, 0.0], [x + 0.4, 0.0, 0.0]]);
    }
    points.push([0.0, 0.0, 0.0]);
    let doubled: f64 = (0..points.len())
        .map(|i| {
            let (p, q) = (points[i], points[(i + 1) % points.len()]);
            p[0] * q[1] - p[1] * q[0]
        })
        .sum();
    (points, doubled / 2.0)
}

#[test]
fn planar_concave_holes_have_no_overlaps() {
    // 400 teeth have 1,603 vertices, which is too long for the whole to be done at once.
    for teeth in [1, 5, 60, 400] {
        let (points, exact) = comb(teeth);
        let soup = cone(&points, [0.3, 0.2, -50.0]);
        for options in [AREA, LIEPA, every_loop(), REFINED] {
            let filled = fill(&soup, &options);
            assert_closed(&soup, &filled);
            let (area, signed) = area_of(&filled, [0.0, 0.0, 1.0]);
            assert!((area / exact - 1.0).abs() < 1e-12, "{teeth} teeth: {area}, not {exact}");
            assert!((signed / exact - 1.0).abs() < 1e-12, "{teeth} teeth, faces up");
            assert_eq!(filled.quality.degenerate_faces, 0);
        }
    }
}

#[test]
fn a_square_in_a_sheet_with_points_on_its_sides() {
    let mut soup = Soup { points: sheet(9, 9).points, offsets: vec![0], ..Soup::default() };
    let all = sheet(9, 9);
    all.faces()
        .enumerate()
        .filter(|(f, _)| !(3..6).contains(&(f % 9)) || !(3..6).contains(&(f / 9)))
        .for_each(|(_, face)| soup.face(face));
    for options in [AREA, LIEPA, every_loop(), REFINED, FAIR] {
        let filled = fill(&soup, &Options { keep: Keep::Longest, ..options });
        let statuses = statuses(&filled);
        assert_eq!(statuses.iter().filter(|&&s| s == HoleStatus::Kept).count(), 1);
        assert_eq!(statuses.iter().filter(|&&s| s == HoleStatus::Filled).count(), 1);
        let (area, signed) = area_of(&filled, [0.0, 0.0, 1.0]);
        assert!((area - 9.0).abs() < 1e-9 && (signed - 9.0).abs() < 1e-9, "{area} {signed} {options:?}");
        assert!(filled.quality.degenerate_faces == 0 && filled.quality.min_angle > 0.2, "{:?}", filled.quality);
        assert_eq!((filled.quality.loops_left, filled.quality.non_manifold_edges), (1, 0));
    }
}

/// Every triangulation of the polygon through places i .. k: lists of triangles.
fn triangulations(i: usize, k: usize) -> Vec<Vec<[usize; 3]>> {
    if k - i < 2 {
        return vec![Vec::new()];
    }
    let mut all = Vec::new();
    for m in i + 1..k {
        for left in triangulations(i, m) {
            for right in triangulations(m, k) {
                let mut both = vec![[i, m, k]];
                both.extend(left.iter().chain(&right));
                all.push(both);
            }
        }
    }
    all
}

fn triangle_area(points: &[[f64; 3]], t: [usize; 3]) -> f64 {
    let [a, b, c] = t.map(|v| glam::DVec3::from_array(points[v]));
    (b - a).cross(c - a).length() / 2.0
}

fn points(range: std::ops::Range<usize>) -> impl Strategy<Value = Vec<[f64; 3]>> {
    prop::collection::vec(prop::array::uniform3(-1.0..1.0), range)
}

proptest! {
    // Parts between creases have a larger area together, except in a plane.
    #[test]
    fn the_area_is_the_least_of_all(points in points(3..10), planar: bool) {
        let flat = |&[x, y, z]: &[f64; 3]| if planar { [x, y, 0.0] } else { [x, y, z] };
        let points: Vec<_> = points.iter().map(flat).collect();
        let soup = cone(&points, [0.1, 0.2, 7.0]);
        let filled = fill(&soup, &Options { ignore_creases: !planar, ..AREA });
        assert_closed(&soup, &filled);
        let least = triangulations(0, points.len() - 1)
            .iter()
            .map(|all| all.iter().map(|&t| triangle_area(&points, t)).sum::<f64>())
            .fold(f64::INFINITY, f64::min);
        prop_assert!((filled.quality.area - least).abs() < 1e-12, "{} {}", filled.quality.area, least);
    }

    #[test]
    fn it_does_not_matter_where_things_are(
        points in points(4..20),
        turn in prop::array::uniform3(-3.0..3.0f64),
        away in prop::array::uniform3(-5.0..5.0f64),
        scale in 1e-3..1e3f64,
        start in 0usize..20,
    ) {
        // The rim of a crown: old faces bend by several angles.
        let n = points.len();
        let moved = |p: [f64; 3]| {
            let turn = glam::DQuat::from_euler(glam::EulerRot::XYZ, turn[0], turn[1], turn[2]);
            ((turn * glam::DVec3::from_array(p)) * scale + glam::DVec3::from_array(away) * scale).to_array()
        };
        let tip = [0.4, -0.3, 3.0];
        let renumbered: Vec<_> = (0..n).map(|i| moved(points[(i + start) % n])).collect();
        for options in [AREA, LIEPA, every_loop(), FAIR] {
            let (a, b) = (fill(&cone(&points, tip), &options), fill(&cone(&renumbered, moved(tip)), &options));
            let area = b.quality.area / (scale * scale);
            prop_assert!((area / a.quality.area - 1.0).abs() < 1e-6, "{} {}", area, a.quality.area);
            prop_assert_eq!(a.mesh.positions.len(), b.mesh.positions.len());
        }
    }

    #[test]
    fn loops_given_are_filled_whichever_way_they_run(backwards: bool, start in 0usize..20) {
        let soup = cap(20, 4, 0.5, 1.0);
        let rim = soup.points.len() as u32 - 20;
        let mut given: Vec<u32> = (0..20).map(|i| rim + (i + start as u32) % 20).collect();
        if backwards {
            given.reverse();
        }
        let filled = fill_holes(&soup.view(), LoopSelection::Loops(&[&given, &given]), &FAIR, &Job::default()).unwrap();
        assert_closed(&soup, &filled);
        prop_assert_eq!(statuses(&filled), [HoleStatus::Filled, HoleStatus::NotFree]);
        let all = fill(&soup, &FAIR);
        // All edges of the rim are equally long, and any may be the one that the work starts from.
        prop_assert!((volume_of(&filled.mesh) / volume_of(&all.mesh) - 1.0).abs() < 0.02, "{} {}", volume_of(&filled.mesh), volume_of(&all.mesh));
    }
}

#[test]
fn a_saddle_rim() {
    let n = 40;
    let points: Vec<[f64; 3]> = (0..n)
        .map(|i| {
            let t = TAU * f64::from(i) / f64::from(n);
            [t.cos(), t.sin(), 0.5 * (2.0 * t).cos()]
        })
        .collect();
    let soup = cone(&points, [0.0, 0.0, -4.0]);
    for options in [AREA, LIEPA, every_loop(), REFINED, FAIR] {
        let filled = fill(&soup, &options);
        assert_closed(&soup, &filled);
        assert_eq!(euler(faces(&filled.mesh)), 2);
    }
    // A disc over the rim has at least the area of its projection. The saddle z = (x^2 - y^2) / 2
    // has the area below, the integral of sqrt(1 + r^2) over the disc. Without inner vertices the
    // area is larger.
    let saddle = TAU / 3.0 * (2f64.powf(1.5) - 1.0);
    let area = fill(&soup, &AREA).quality.area;
    assert!(area > 0.98 * PI && area < 1.15 * saddle, "{area} {saddle}");
}

#[test]
fn no_edge_is_repeated() {
    // Two of the four faces of a tetrahedron: of the two diagonals of the hole one is an edge
    // already.
    let corners = vec![[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let soup = Soup::new(corners.clone(), &[&[0, 2, 1], &[0, 1, 3]]);
    for options in [AREA, LIEPA, every_loop(), REFINED, FAIR] {
        let filled = fill(&soup, &options);
        assert_closed(&soup, &filled);
        assert_eq!(euler(faces(&filled.mesh)), 2);
    }
    // The same with an old edge that Delaunay's rule would like to have.
    let thin = vec![[0.0, 0.0, 0.0], [0.2, 0.0, 0.0], [0.1, 1.0, 0.0], [0.1, -1.0, 0.1]];
    let soup = Soup::new(thin, &[&[0, 2, 1], &[0, 1, 3]]);
    for options in [REFINED, FAIR] {
        assert_closed(&soup, &fill(&soup, &options));
    }
    // Two holes that share two vertices: the edge between them is the best for both.
    let (a, b) = ([0, 2, 1, 3], [0, 4, 1, 5]);
    let mut soup = Soup { points: vec![[-0.1, 0.0, 0.0], [0.1, 0.0, 0.0]], offsets: vec![0], ..Soup::default() };
    soup.points.extend([
        [0.0, -1.0, 0.0],
        [0.0, 1.0, 0.0],
        [0.0, -1.0, 2.0],
        [0.0, 1.0, 2.0],
        [0.0, 0.0, -3.0],
        [0.0, 0.0, 8.0],
    ]);
    for (rim, tip) in [(a, 6), (b, 7)] {
        (0..4).for_each(|i| soup.face(&[rim[(i + 1) % 4], rim[i], tip]));
    }
    for options in [AREA, LIEPA, every_loop(), REFINED, FAIR] {
        let filled = fill(&soup, &options);
        assert_eq!(statuses(&filled), [HoleStatus::Filled; 2]);
        assert_closed(&soup, &filled);
    }
    // Both diagonals of the hole are edges of a second sheet through the same vertices.
    let mut soup = Soup::new(corners, &[&[0, 1, 4], &[1, 2, 4], &[2, 3, 4], &[3, 0, 4], &[0, 2, 5], &[1, 3, 6]]);
    soup.points.extend([[0.3, 0.3, -3.0], [5.0, 0.0, 0.0], [6.0, 0.0, 0.0]]);
    let filled = fill_holes(&soup.view(), LoopSelection::Loops(&[&[0, 1, 2, 3]]), &FAIR, &Job::default()).unwrap();
    assert_eq!(statuses(&filled), [HoleStatus::NoTriangulation]);
    assert_eq!(filled.mesh.face_count(), 6);
    assert_eq!(filled.quality.non_manifold_edges, 0);
}

#[test]
fn holes_that_touch() {
    // A sheet without two cells that meet at a vertex; and without two that share two vertices with
    // cells between.
    let all = sheet(6, 6);
    for missing in [vec![14, 21], vec![14, 21, 15], vec![7, 8, 14, 21, 22]] {
        let mut soup = Soup { points: all.points.clone(), offsets: vec![0], ..Soup::default() };
        all.faces().enumerate().filter(|(f, _)| !missing.contains(f)).for_each(|(_, face)| soup.face(face));
        for options in [AREA, LIEPA, every_loop(), REFINED, FAIR] {
            let filled = fill(&soup, &Options { keep: Keep::Longest, ..options });
            let (area, signed) = area_of(&filled, [0.0, 0.0, 1.0]);
            assert!((area - missing.len() as f64).abs() < 1e-9 && (signed - area).abs() < 1e-9, "{area}");
            assert_eq!((filled.quality.loops_left, filled.quality.non_manifold_edges), (1, 0));
        }
    }
}

#[test]
fn a_blend_is_refined_and_faired() {
    let soup = cap(24, 6, -0.3, 1.0);
    let blend = Options { finish: stitch::Finish::Blend, ..every_loop() };
    let fair = Options { refinement: Refinement::RimDensity(0), fairing: Fairing::ThinPlate, ..every_loop() };
    assert_eq!(fill(&soup, &blend), fill(&soup, &fair));
    assert!(!fill(&soup, &blend).parents.is_empty());
    // In a join, the finish of the strips is the finish of the patches.
    for finish in [stitch::Finish::Strip, stitch::Finish::Blend] {
        let strip = stitch::Options { finish, ..stitch::Options::default() };
        let options = assemble::Options { strip, fill: Some(every_loop()), ..assemble::Options::default() };
        let done = assemble(&[soup.view()], &options, &Job::default()).unwrap();
        assert_eq!(done.holes[0].finish == Finish::Faired, finish == stitch::Finish::Blend);
    }
}

#[test]
fn loops_that_are_left_say_why() {
    let soup = cap(12, 3, 0.5, 1.0).and(&cap(24, 3, 0.5, -1.0));
    let limited = |limits: Limits| statuses(&fill(&soup, &Options { limits, ..every_loop() }));
    use HoleStatus::{Filled, TooLarge};
    assert_eq!(limited(Limits { edges: Some(12), ..Limits::default() }), [Filled, TooLarge]);
    assert_eq!(limited(Limits { edges: Some(11), ..Limits::default() }), [TooLarge, TooLarge]);
    let circle = TAU * 0.75f64.sqrt();
    assert_eq!(limited(Limits { length: Some(circle), ..Limits::default() }), [Filled, Filled]);
    assert_eq!(limited(Limits { length: Some(0.99 * circle), ..Limits::default() }), [Filled, TooLarge]);
    assert_eq!(limited(Limits { diameter: Some(2.0), ..Limits::default() }), [TooLarge, TooLarge]);
    assert_eq!(limited(Limits { diameter: Some(2.5), ..Limits::default() }), [Filled, Filled]);

    let bad: [&[u32]; 4] = [&[0, 1], &[1, 2, 3, 2], &[0, 1, 2], &[99, 0, 1]];
    let filled = fill_holes(&soup.view(), LoopSelection::Loops(&bad), &Options::default(), &Job::default()).unwrap();
    use HoleStatus::{NotFree, NotSimple};
    assert_eq!(statuses(&filled), [NotSimple, NotSimple, NotFree, NotFree]);
    assert_eq!(filled.mesh.face_count(), soup.faces().count());
    assert_eq!(&filled.rims[filled.holes[1].rim.clone()], bad[1]);

    // A vertex that does not exist is an error, not a reason to leave a loop open.
    let missing: [&[u32]; 2] = [&[0, 1, 2], &[0, 1, 1000]];
    let refused =
        fill_holes(&soup.view(), LoopSelection::Loops(&missing), &Options::default(), &Job::default()).unwrap_err();
    let count = soup.points.len() as u32;
    assert_eq!(refused, Error::LoopIndexOutOfRange { number: 1, place: 2, vertex: 1000, count });

    // Two faces that disagree; three faces at an edge.
    let mixed = Soup::flat(4, &[&[0, 1, 2], &[1, 2, 3]]);
    assert_eq!(statuses(&fill(&mixed, &Options::default())), [HoleStatus::NotOriented]);
    let book = Soup::flat(5, &[&[0, 1, 2], &[0, 1, 3], &[0, 1, 4]]);
    assert!(statuses(&fill(&book, &Options::default())).iter().all(|&s| s == HoleStatus::NonManifold));

    let wrong = Options { limits: Limits { length: Some(f64::NAN), ..Limits::default() }, ..Options::default() };
    let refused = fill_holes(&soup.view(), LoopSelection::All, &wrong, &Job::default());
    assert!(matches!(refused, Err(Error::OptionOutOfRange { option: "max_length", .. })));
}

#[test]
fn long_rims_take_linear_memory() {
    // A wavy ring of 6,000 vertices.
    let points: Vec<[f64; 3]> = (0..6000)
        .map(|i| {
            let t = TAU * f64::from(i) / 6000.0;
            let r = 1.0 + 0.3 * (40.0 * t).cos();
            [r * t.cos(), r * t.sin(), 0.02 * (3.0 * t).sin()]
        })
        .collect();
    let soup = cone(&points, [0.0, 0.0, -10.0]);
    let filled = fill(&soup, &Options::default());
    assert_closed(&soup, &filled);
    let exact = PI * (1.0 + 0.09 / 2.0);
    assert!((filled.quality.area / exact - 1.0).abs() < 0.01, "{}", filled.quality.area);
}

#[test]
fn sizes_and_degenerate_rims_do_no_harm() {
    for scale in [0.0, 1e-200, 1e200] {
        let mut soup = cap(12, 3, 0.5, 1.0);
        soup.points.iter_mut().flatten().for_each(|x| *x *= scale);
        for options in [AREA, LIEPA, every_loop(), REFINED, FAIR] {
            let filled = fill(&soup, &options);
            assert_closed(&soup, &filled);
            for v in 0..filled.mesh.positions.len() as u32 {
                assert!(filled.mesh.positions.get(v).abs().max_element() <= 1.1 * scale);
            }
        }
    }
    // All rim vertices in one place; all in line.
    for flatten in [[0.0, 0.0, 1.0], [1.0, 0.0, 0.0]] {
        let mut soup = cap(12, 3, 0.5, 1.0);
        let rim = soup.points.len() - 12;
        soup.points[rim..].iter_mut().for_each(|p| *p = [p[0] * flatten[0], p[1] * flatten[1], 0.5]);
        for options in [AREA, LIEPA, every_loop(), REFINED, FAIR] {
            assert_closed(&soup, &fill(&soup, &options));
        }
    }
}
