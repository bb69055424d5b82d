//! Several loops closed by one patch, held against known areas and volumes and Euler's formula.

use crate::common::{Silent, Soup, cap, edge_counts, euler, faces_of, some_of, volume};
use gusset::Job;
use gusset::fill::{
    Fairing, Filled, Finish, HoleStatus, Keep, Limits, LoopSelection, Options, Refinement, Together, Weight, fill_holes,
};
use gusset::mesh::NONE;
use std::f64::consts::{PI, TAU};

const WEIGHTS: [Weight; 4] = [Weight::Continuation, Weight::AreaAndBend, Weight::BendThenArea, Weight::Area];

fn fill(soup: &Soup, options: &Options) -> Filled {
    fill_holes(&soup.view(), LoopSelection::All, options, &Job::default()).unwrap()
}

fn one() -> Options {
    Options { together: Together::One, ..Options::default() }
}

fn fair(together: Together) -> Options {
    let refinement = Refinement::RimDensity(0);
    Options { together, refinement, fairing: Fairing::ThinPlate, ..Options::default() }
}

/// The mesh is closed, manifold at every edge, consistently oriented, and has this Euler
/// characteristic. No face of a patch intersects another, and the report has this many patches.
fn assert_closed(soup: &Soup, filled: &Filled, characteristic: i64, patches: u32) {
    assert_eq!(filled.intersections.as_deref(), Some(&[][..]));
    assert_surface(soup, filled, characteristic, patches);
}

/// The same, without the check of intersections.
fn assert_surface(soup: &Soup, filled: &Filled, characteristic: i64, patches: u32) {
    for (edge, counts) in edge_counts(faces_of(&filled.mesh)) {
        assert_eq!(counts, (1, 1), "edge {edge:?}");
    }
    assert_eq!(euler(faces_of(&filled.mesh)), characteristic);
    assert_accounts(soup, filled, patches);
}

/// Loops of one patch have equal ranges. The ranges of all patches are consecutive and cover all
/// new elements. A patch of k loops with n vertices has n + 2 k - 4 faces, and two for each new
/// vertex.
fn assert_accounts(soup: &Soup, filled: &Filled, patches: u32) {
    let old = [soup.offsets.len() as u32 - 1, soup.points.len() as u32];
    let (mut faces, mut vertices) = (old[0], old[1]);
    for patch in 0..patches {
        let own: Vec<_> = filled.holes.iter().filter(|hole| hole.patch == patch).collect();
        let rims: usize = own.iter().map(|hole| hole.rim.len()).sum();
        let first = own[0];
        assert_eq!((first.faces.start, first.vertices.start), (faces, vertices));
        (faces, vertices) = (first.faces.end, first.vertices.end);
        assert!(own.iter().all(|hole| hole.faces == first.faces && hole.vertices == first.vertices));
        assert!(own.iter().all(|hole| hole.status == HoleStatus::Filled));
        assert_eq!(first.faces.len(), rims + 2 * own.len() - 4 + 2 * first.vertices.len());
        let of_rims: Vec<u32> = own.iter().flat_map(|hole| &filled.rims[hole.rim.clone()]).copied().collect();
        let places = first.vertices.clone().map(|v| (v - old[1]) as usize);
        for (parents, weights) in places.map(|k| (filled.parents[k], filled.weights[k])) {
            assert!(parents.iter().all(|v| of_rims.contains(v)));
            assert!(weights.iter().all(|&w| w >= 0.0) && (weights.iter().sum::<f64>() - 1.0).abs() < 1e-12);
        }
    }
    assert_eq!((faces, vertices), (filled.mesh.face_count() as u32, filled.mesh.positions.len() as u32));
    for hole in &filled.holes {
        assert!(hole.patch < patches || hole.patch == NONE && hole.faces.is_empty() && hole.vertices.is_empty());
    }
}

fn point(filled: &Filled, v: u32) -> glam::DVec3 {
    filled.mesh.positions.get(v)
}

fn volume_of(filled: &Filled) -> f64 {
    volume(|v| point(filled, v).to_array(), faces_of(&filled.mesh))
}

/// The area of the new faces, and of their projection along z.
fn new_area(soup: &Soup, filled: &Filled) -> [f64; 2] {
    let mut sums = [0.0; 2];
    for face in faces_of(&filled.mesh).skip(soup.offsets.len() - 1) {
        let [a, b, c] = [0, 1, 2].map(|k| point(filled, face[k]));
        let vector = (b - a).cross(c - a) / 2.0;
        sums[0] += vector.length();
        sums[1] += vector.z;
    }
    sums
}

/// A cone over a star of `n` corners in the plane z = 0, counter-clockwise from above or not, and
/// the star's area.
fn star(n: u32, radius: f64, centre: [f64; 2], tip: f64, upwards: bool) -> (Soup, f64) {
    let mut soup = Soup { offsets: vec![0], ..Soup::default() };
    for i in 0..n {
        let (r, t) = (radius * [1.0, 0.8][i as usize % 2], TAU * f64::from(i) / f64::from(n));
        soup.points.push([centre[0] + r * t.cos(), centre[1] + r * t.sin(), 0.0]);
    }
    soup.points.push([centre[0], centre[1], tip]);
    (0..n).for_each(|i| soup.face(&if upwards { [(i + 1) % n, i, n] } else { [i, (i + 1) % n, n] }));
    (soup, f64::from(n) / 2.0 * 0.8 * radius * radius * (TAU / f64::from(n)).sin())
}

/// A bowl whose rim has round dents with this many corners.
fn bowl(n: u32, dents: u32, corners: u32) -> (Soup, f64) {
    let (mut soup, mut area) = star(n, 1.0, [0.0, 0.0], -5.0, true);
    for k in 0..dents {
        let t = TAU * f64::from(k) / f64::from(dents) + 0.3;
        let r = if dents == 1 { 0.1 } else { 0.45 };
        let (dent, missing) = star(corners, 0.2, [r * t.cos(), r * t.sin()], -0.5, false);
        (soup, area) = (soup.and(&dent), area - missing);
    }
    (soup, area)
}

#[test]
fn a_planar_hole_round_islands_has_no_overlaps() {
    for (n, dents, corners) in [(40, 1, 20), (40, 3, 8), (12, 5, 12), (600, 4, 200)] {
        let (soup, exact) = bowl(n, dents, corners);
        let refined = Options { refinement: Refinement::RimDensity(0), ..one() };
        let area = Options { weight: Weight::Area, ..one() };
        let cheapest = Options { together: Together::Cheapest, ..area };
        for options in [one(), area, refined, cheapest] {
            let filled = fill(&soup, &options);
            assert_closed(&soup, &filled, 2, 1);
            let [area, shadow] = new_area(&soup, &filled);
            assert!((area / exact - 1.0).abs() < 1e-9, "{n} {dents} {options:?}: {area}, not {exact}");
            assert!((shadow / exact - 1.0).abs() < 1e-9, "{n} {dents} {options:?}: {shadow}");
            assert_eq!(filled.quality.loops_left, 0);
        }
    }
}

/// A tube of quads about an axis through the origin, from one distance to another, faces outwards;
/// its ends are its first and its last `n` vertices.
fn tube(axis: glam::DVec3, n: u32, radius: f64, ends: [f64; 2]) -> Soup {
    let x = axis.any_orthonormal_vector();
    let (y, rows) = (axis.cross(x), 4);
    let mut soup = Soup { offsets: vec![0], ..Soup::default() };
    for row in 0..=rows {
        for k in 0..n {
            let (t, along) = (TAU * f64::from(k) / f64::from(n), f64::from(row) / f64::from(rows));
            let p = axis * (ends[0] + (ends[1] - ends[0]) * along) + (x * t.cos() + y * t.sin()) * radius;
            soup.points.push(p.to_array());
        }
    }
    for row in 0..rows {
        for k in 0..n {
            let (a, b) = (row * n + k, row * n + (k + 1) % n);
            soup.face(&[a, b, b + n, a + n]);
        }
    }
    soup
}

/// Two tubes in line, 1 long each.
fn two_tubes(n: u32, gap: f64) -> Soup {
    let z = glam::DVec3::Z;
    tube(z, n, 1.0, [0.0, 1.0]).and(&tube(z, n, 1.0, [1.0 + gap, 2.0 + gap]))
}

/// The loops, by the mean of z.
fn loops_by_height(soup: &Soup) -> Vec<Vec<u32>> {
    let plan = fill(soup, &Options { plan_only: true, ..Options::default() });
    assert!(plan.holes.iter().all(|hole| hole.patch == NONE));
    let mut loops: Vec<Vec<u32>> = plan.holes.iter().map(|hole| plan.rims[hole.rim.clone()].to_vec()).collect();
    let height = |rim: &[u32]| rim.iter().map(|&v| soup.points[v as usize][2]).sum::<f64>() / rim.len() as f64;
    loops.sort_by(|a, b| height(a).total_cmp(&height(b)));
    loops
}

/// The given loops, each with a number.
fn grouped(soup: &Soup, loops: &[Vec<u32>], numbers: &[u32], options: &Options) -> Filled {
    let groups: Vec<_> = loops.iter().map(Vec::as_slice).zip(numbers.iter().copied()).collect();
    fill_holes(&soup.view(), LoopSelection::Groups(&groups), options, &Job::default()).unwrap()
}

#[test]
fn two_tubes_become_one() {
    let n = 36;
    let prism = f64::from(n) / 2.0 * (TAU / f64::from(n)).sin();
    for gap in [0.3, 1.5] {
        let soup = two_tubes(n, gap);
        let loops = loops_by_height(&soup);
        // By area a thin neck between two discs is better than a long tube.
        for weight in WEIGHTS.into_iter().filter(|&weight| gap < 1.0 || weight != Weight::Area) {
            let options = Options { weight, ..Options::default() };
            let filled = grouped(&soup, &loops, &[7, 3, 3, 9], &options);
            assert_closed(&soup, &filled, 2, 3);
            assert_eq!(filled.holes.iter().map(|hole| hole.patch).collect::<Vec<_>>(), [0, 1, 1, 2]);
            let exact = prism * (2.0 + gap);
            // Other triangulations have an equal largest bend, so that the area decides.
            let volume = volume_of(&filled);
            assert!((volume / exact - 1.0).abs() < 1e-9, "{weight:?} {gap}: {volume}, not {exact}");
        }
        // By the way that the surface continues, these are the cheapest patches, too.
        let cheapest = fill(&soup, &Options { together: Together::Cheapest, ..Options::default() });
        assert_closed(&soup, &cheapest, 2, 3);
        assert!((volume_of(&cheapest) / (prism * (2.0 + gap)) - 1.0).abs() < 1e-9);
    }
}

#[test]
fn far_tubes_are_closed_apart() {
    let n = 24;
    for gap in [4.0, 50.0] {
        let soup = two_tubes(n, gap);
        for weight in [Weight::Continuation, Weight::AreaAndBend] {
            let filled = fill(&soup, &Options { together: Together::Cheapest, weight, ..Options::default() });
            assert_closed(&soup, &filled, 4, 4);
            let prism = f64::from(n) / 2.0 * (TAU / f64::from(n)).sin();
            assert!((volume_of(&filled) / (2.0 * prism) - 1.0).abs() < 1e-9);
        }
    }
    // The patches that there are without any choice, byte for byte.
    let soup = sphere_without_caps(&[glam::DVec3::X, glam::DVec3::Y, glam::DVec3::Z], 0.4);
    let cheapest = fill(&soup, &Options { together: Together::Cheapest, ..Options::default() });
    assert_eq!(cheapest, fill(&soup, &Options::default()));
}

#[test]
fn a_band_of_a_sphere_is_restored() {
    for rim in [0.15, 0.3] {
        let soup = cap(48, 18, rim, 1.0).and(&cap(40, 18, rim, -1.0));
        let caps = 2.0 * PI * (1.0 - rim) * (1.0 - rim) * (2.0 + rim) / 3.0;
        let cylinder = TAU * rim * (1.0 - rim * rim);
        let plain = fill(&soup, &one());
        assert_closed(&soup, &plain, 2, 1);
        let volume = volume_of(&plain);
        assert!((volume / (caps + cylinder) - 1.0).abs() < 0.02, "{rim}: {volume}");

        let faired = fill(&soup, &fair(Together::One));
        assert_closed(&soup, &faired, 2, 1);
        assert!(faired.holes.iter().all(|hole| hole.finish == Finish::Faired && !hole.vertices.is_empty()));
        let ball = 4.0 / 3.0 * PI;
        assert!((volume_of(&faired) / ball - 1.0).abs() < 0.02 && volume_of(&faired) > volume, "{rim}");
        for v in faired.holes[0].vertices.clone() {
            let off = point(&faired, v).length() - 1.0;
            assert!(off.abs() < 0.02, "{rim}: {off}");
        }
        assert!(faired.quality.min_angle > 0.3, "{:?}", faired.quality);
    }
}

/// A sphere of triangles, finer in four steps from an octahedron, without caps of this half angle.
fn sphere_without_caps(axes: &[glam::DVec3], angle: f64) -> Soup {
    use glam::DVec3;
    let axis = [DVec3::X, DVec3::Y, DVec3::Z];
    let mut triangles: Vec<[DVec3; 3]> = Vec::new();
    for signs in 0..8 {
        let [x, y, z] = [0, 1, 2].map(|k| if signs >> k & 1 == 0 { axis[k] } else { -axis[k] });
        triangles.push(if x.cross(y).dot(z) > 0.0 { [x, y, z] } else { [y, x, z] });
    }
    for _ in 0..4 {
        let split = |&[a, b, c]: &[DVec3; 3]| {
            let [x, y, z] = [b + c, c + a, a + b].map(DVec3::normalize);
            [[a, z, y], [z, b, x], [y, x, c], [x, y, z]]
        };
        triangles = triangles.iter().flat_map(split).collect();
    }
    let mut soup = Soup { offsets: vec![0], ..Soup::default() };
    let mut numbers = std::collections::HashMap::new();
    let is_left = |corners: &&[DVec3; 3]| {
        let centre = corners.iter().sum::<DVec3>().normalize();
        axes.iter().all(|axis| axis.dot(centre) < angle.cos())
    };
    for corners in triangles.iter().filter(is_left) {
        let face = corners.map(|p| {
            let place = p.to_array().map(|x| (x * 1e9).round() as i64);
            *numbers.entry(place).or_insert_with(|| {
                soup.points.push(p.to_array());
                soup.points.len() as u32 - 1
            })
        });
        soup.face(&face);
    }
    soup
}

/// `count` directions as far apart as may be, about.
fn directions(count: usize) -> Vec<glam::DVec3> {
    use glam::DVec3;
    let corners = [DVec3::new(1.0, 1.0, 1.0), DVec3::new(1.0, -1.0, -1.0), DVec3::new(-1.0, 1.0, -1.0)];
    let axes = [DVec3::X, -DVec3::X, DVec3::Y, -DVec3::Y, DVec3::Z, -DVec3::Z];
    match count {
        4 => corners.into_iter().chain([DVec3::new(-1.0, -1.0, 1.0)]).map(DVec3::normalize).collect(),
        _ => axes[..count].to_vec(),
    }
}

#[test]
fn caps_of_a_sphere_joined_inside_it_make_handles() {
    let refined = Options { refinement: Refinement::RimDensity(0), ..one() };
    let ways = [one(), refined, Options { weight: Weight::Area, ..one() }];
    for (count, options) in some_of(7, (2..=6).rev().flat_map(|count| ways.map(|way| (count, way)))) {
        let soup = sphere_without_caps(&directions(count), 0.6);
        let filled = fill(&soup, &options);
        assert_eq!(filled.holes.len(), count);
        // A sphere without k discs has 2 - k, and so has the patch.
        assert_surface(&soup, &filled, 4 - 2 * count as i64, 1);
        // All is inside the sphere. Two of five tunnels intersect, and the report says so.
        assert!(volume_of(&filled) > 0.1 && volume_of(&filled) < 0.98 * 4.0 / 3.0 * PI, "{count}");
        assert!(count == 5 || filled.intersections.as_deref() == Some(&[][..]), "{count}");
    }
}

/// Three tubes that look at each other.
fn trousers(n: u32) -> Soup {
    let axes = [0.0, 1.0, 2.0].map(|k| glam::DVec3::new((TAU * k / 3.0).cos(), (TAU * k / 3.0).sin(), 0.0));
    let tubes = axes.map(|axis| tube(axis, n, 0.5, [1.0, 2.0]));
    tubes[0].and(&tubes[1]).and(&tubes[2])
}

/// The inner ends of [`trousers`].
fn inner_ends(n: u32) -> Vec<Vec<u32>> {
    (0..3).map(|k| (5 * n * k..5 * n * k + n).collect()).collect()
}

#[test]
fn trousers_have_three_loops() {
    for (n, options) in [(12, Options::default()), (24, Options::default()), (24, fair(Together::Apart))] {
        let soup = trousers(n);
        let loops = inner_ends(n);
        let filled = grouped(&soup, &loops, &[1, 1, 1], &options);
        assert_accounts(&soup, &filled, 1);
        assert_eq!((filled.quality.loops_left, filled.intersections.as_deref()), (3, Some(&[][..])));
        // Three discs less than a sphere.
        assert_eq!(euler(faces_of(&filled.mesh)), -1);
        let rest = fill(&soup, &Options { together: Together::Cheapest, ..options });
        assert_closed(&soup, &rest, 2, 4);
        // The area is at most a third more than straight tubes, and less than the convex hull of
        // the ends, which lies in a prism of height 1 over a hexagon; faired patches may have a
        // tenth more.
        let tubes = 3.0 * PI * 0.25;
        let hexagon = 1.5 + 1.5 * 1.25 * (TAU / 3.0 - 2.0 * 0.5f64.atan()).sin();
        let volume = volume_of(&rest);
        assert!(volume > 1.3 * tubes && volume < 1.1 * (tubes + hexagon), "{volume}");
    }
}

#[test]
fn loops_that_are_left_do_not_count() {
    let soup = two_tubes(24, 0.5);
    let loops = loops_by_height(&soup);
    // The same loop again is not free: the other has the patch of the group by itself.
    let given = vec![loops[0].clone(), loops[0].clone(), loops[1].clone(), loops[2].clone()];
    let filled = grouped(&soup, &given, &[0, 5, 5, 5], &Options::default());
    let status: Vec<_> = filled.holes.iter().map(|hole| (hole.status, hole.patch)).collect();
    use HoleStatus::{Filled, NotFree, TooLarge};
    assert_eq!(status, [(Filled, 0), (NotFree, NONE), (Filled, 1), (Filled, 1)]);
    assert_accounts(&soup, &filled, 2);

    let soup = cap(24, 6, 0.3, 1.0).and(&cap(24, 6, 0.3, -1.0)).and(&cap(40, 6, 0.6, -1.0));
    let limits = Limits { edges: Some(30), ..Limits::default() };
    let filled = fill(&soup, &Options { limits, keep: Keep::None, ..one() });
    let mut status: Vec<_> = filled.holes.iter().map(|hole| (hole.rim.len(), hole.status, hole.patch)).collect();
    status.sort_by_key(|&(length, ..)| length);
    assert_eq!(status, [(24, Filled, 0), (24, Filled, 0), (40, TooLarge, NONE)]);
    assert_accounts(&soup, &filled, 1);
    // Nothing to fill at all.
    let none = fill(&soup, &Options { limits: Limits { edges: Some(3), ..limits }, ..one() });
    assert_accounts(&soup, &none, 0);
}

#[test]
fn loops_that_share_a_vertex_have_no_common_patch() {
    // Two cones that touch at one vertex of their rims.
    let (mut soup, _) = star(12, 1.0, [0.0, 0.0], -1.0, true);
    let (other, _) = star(12, 1.0, [2.0, 0.0], -1.0, true);
    let first = soup.points.len() as u32;
    soup = soup.and(&other);
    soup.corners.iter_mut().filter(|v| **v == first + 6).for_each(|v| *v = 0);
    soup.points[0] = [1.0, 0.0, 0.0];
    let together = fill(&soup, &one());
    assert_eq!(together.holes.len(), 2);
    assert!(together.holes.iter().all(|hole| hole.status == HoleStatus::NoTriangulation && hole.patch == NONE));
    assert_accounts(&soup, &together, 0);
    let cheapest = fill(&soup, &Options { together: Together::Cheapest, ..Options::default() });
    assert_eq!(cheapest, fill(&soup, &Options::default()));
    assert_accounts(&soup, &cheapest, 2);
}

#[test]
fn no_edge_of_a_joint_patch_repeats_one_of_the_mesh() {
    // One row of quads between the loops: every bridge to the next three vertices has a face already.
    let n = 8;
    let mut soup = Soup { offsets: vec![0], ..Soup::default() };
    for z in [0.0, 0.2] {
        for k in 0..n {
            let t = TAU * f64::from(k) / f64::from(n);
            soup.points.push([t.cos(), t.sin(), z]);
        }
    }
    (0..n).for_each(|k| soup.face(&[k, (k + 1) % n, (k + 1) % n + n, k + n]));
    for weight in WEIGHTS {
        let filled = fill(&soup, &Options { weight, ..one() });
        // A torus, closed also with its quads cut along either diagonal.
        assert_eq!(euler(faces_of(&filled.mesh)), 0);
        for first in 0..2 {
            let fans = faces_of(&filled.mesh).flat_map(|face| {
                let corner = move |k: usize| face[(first + k) % face.len()];
                (1..face.len() - 1).map(move |k| [corner(0), corner(k), corner(k + 1)])
            });
            let fans: Vec<[u32; 3]> = fans.collect();
            for (edge, counts) in edge_counts(fans.iter().map(<[u32; 3]>::as_slice)) {
                assert_eq!(counts, (1, 1), "edge {edge:?}");
            }
        }
    }
}

#[test]
fn the_same_input_gives_the_same_patch() {
    let shapes = [trousers(16), two_tubes(20, 0.7), bowl(40, 3, 8).0, sphere_without_caps(&directions(3), 0.35)];
    let ways = [Together::Cheapest, Together::Cheapest, Together::One, Together::One];
    for (soup, together) in some_of(2, shapes.iter().zip(ways)) {
        let of = |threads: usize| {
            let job = Job::new(threads, &Silent);
            fill_holes(&soup.view(), LoopSelection::All, &fair(together), &job).unwrap()
        };
        let first = of(1);
        assert_eq!(first, of(1));
        assert_eq!(first, of(3));
    }
}
