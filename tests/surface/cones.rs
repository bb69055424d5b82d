//! Cones of normals: every normal of a block is in its cone and in the cones of all blocks above,
//! also where patches jump, fold or end in poles.

use crate::common::Silent;
use crate::shapes::{Random, SHAPES, Shape, WIGLEY, grid, rough};
use glam::DVec3;
use gusset::Job;
use gusset::surface::{Grid, MAX_DEGREE, Nodes, NormalCone, Patches, Place, Scheme, Sheet, Surface};
use std::f64::consts::{FRAC_PI_2, PI};

/// Cells along the side of a block.
const BLOCK: usize = 4;

fn angle(a: DVec3, b: DVec3) -> f64 {
    a.cross(b).length().atan2(a.dot(b))
}

fn with_cones(sheet: Sheet<'_>) -> Surface<'_> {
    let job = Job::default();
    let surface = Surface::new(vec![sheet], None, &job).unwrap();
    assert_eq!((surface.cone_bytes(), surface.normal_cone(0, 0, [0, 0])), (0, None));
    surface.build_cones(&job).unwrap();
    surface
}

/// The cones that contain a cell, of the block first.
fn above(surface: &Surface<'_>, [i, j]: [usize; 2]) -> Vec<NormalCone> {
    (0..32).map_while(|level| surface.normal_cone(0, level, [i, j].map(|k| (k / BLOCK) >> level))).collect()
}

/// Samples the normals of all cells, with limits at poles. Returns the number of useful cones, and
/// the least margin of the normals within their cones.
fn check(name: &str, sheet: Sheet<'_>, samples: usize) -> (usize, f64) {
    let surface = with_cones(sheet);
    let [rows, columns] = surface.sheet(0).cells();
    let (mut telling, mut least) = (0, f64::INFINITY);
    for (i, j) in (0..rows).flat_map(|i| (0..columns).map(move |j| (i, j))) {
        let cones = above(&surface, [i, j]);
        let levels = (0..).find(|&k| rows.max(columns).div_ceil(BLOCK << k) <= 2).unwrap() + 1;
        assert_eq!(cones.len(), levels, "{name}: levels");
        telling += usize::from(i % BLOCK == 0 && j % BLOCK == 0 && cones[0].angle < PI);
        if cones[0].angle == PI && cones.iter().all(|cone| cone.angle == PI) {
            continue;
        }
        for k in 0..(samples + 1) * (samples + 1) {
            let [u, v] = [k / (samples + 1), k % (samples + 1)].map(|k| k as f64 / samples as f64);
            let normal = surface.normal(Place { sheet: 0, cell: [i as u32, j as u32], u, v });
            if normal == DVec3::ZERO {
                continue;
            }
            for (level, cone) in cones.iter().enumerate() {
                let within = cone.angle - angle(cone.axis, normal);
                least = least.min(within);
                assert!(within >= 0.0, "{name}: cell {i} {j}, ({u}, {v}), level {level}: {within:e}");
            }
        }
    }
    (telling, least)
}

#[test]
fn normals_are_in_their_cones() {
    for shape in SHAPES.iter().chain([&WIGLEY]) {
        let shape = Shape { cells: shape.cells.map(|count| 4 * count + 1), ..*shape };
        let blocks = shape.cells.map(|count| count.div_ceil(BLOCK)).iter().product::<usize>();
        let (telling, _) = check(shape.name, Sheet::Grid(grid(&shape)), 4);
        assert!(3 * telling > blocks, "{}: {telling} of {blocks} cones tell something", shape.name);
        let other = Grid::new(grid(&shape).nodes().clone(), shape.closed, Scheme::FourPoint).unwrap();
        check(&format!("{}, four points", shape.name), Sheet::Grid(other), 6);
    }
}

/// A smooth sheet whose nodes are moved at random by some part of a cell.
fn moved(shape: &Shape, scheme: Scheme, by: f64, random: &mut Random) -> Grid<'static> {
    let ([h, w], smooth) = (shape.cells, grid(shape));
    let mut data = vec![0.0; 3 * (h + 1) * (w + 1)];
    for (i, j) in (0..=h).flat_map(|i| (0..=w).map(move |j| (i, j))) {
        let [from_i, from_j] = [(i, h, 0), (j, w, 1)].map(|(k, n, d)| if shape.closed[d] { k % n } else { k });
        let at = if (from_i, from_j) == (i, j) {
            (smooth.nodes().get(i, j) + random.point(by / h.max(w) as f64)).to_array()
        } else {
            let at = 3 * (from_i * (w + 1) + from_j);
            [data[at], data[at + 1], data[at + 2]]
        };
        data[3 * (i * (w + 1) + j)..][..3].copy_from_slice(&at);
    }
    Grid::new(Nodes::strided(data, h + 1, w + 1, 0, 0).unwrap(), shape.closed, scheme).unwrap()
}

#[test]
fn normals_of_moved_nodes_are_in_their_cones() {
    let mut random = Random(17);
    for shape in &SHAPES {
        for (scheme, by) in
            [Scheme::SixTap, Scheme::FourPoint].into_iter().flat_map(|s| [0.01, 0.1, 0.5].map(|by| (s, by)))
        {
            let shape = Shape { cells: shape.cells.map(|count| 2 * count + 3), ..*shape };
            let (telling, _) = check(shape.name, Sheet::Grid(moved(&shape, scheme, by, &mut random)), 5);
            assert!(telling > 100 || by > 0.2 || shape.cells[0] < 30, "{}, {by}: {telling}", shape.name);
        }
    }
}

#[test]
fn normals_of_rough_sheets_are_in_their_cones() {
    for seed in 0..12 {
        for (closed, scheme) in [
            ([false, false], Scheme::SixTap),
            ([false, true], Scheme::SixTap),
            ([true, true], Scheme::SixTap),
            ([false, false], Scheme::FourPoint),
            ([true, true], Scheme::FourPoint),
        ] {
            // Few lines too: there nodes are their own neighbours.
            let cells = [[21, 26], [3, 9], [5, 4], [4, 3]][seed as usize % 4];
            check("rough", Sheet::Grid(rough(cells, closed, scheme, seed)), 5);
        }
    }
}

/// A sheet of patches whose control points are off a smooth one by `by`.
fn patches<const N: usize>(degree: usize, by: f64, random: &mut Random) -> Patches<N> {
    let (rows, columns) = (6, 5);
    let mut points = Vec::new();
    for (i, j) in (0..rows).flat_map(|i| (0..columns).map(move |j| (i, j))) {
        for (a, b) in (0..=degree).flat_map(|a| (0..=degree).map(move |b| (a, b))) {
            let at = |k: usize, a: usize| k as f64 + a as f64 / degree as f64;
            let (x, y) = (at(i, a), at(j, b));
            points.push(DVec3::new(x, y + 0.2 * x, 0.3 * (0.7 * x).sin() * (0.6 * y).cos()) + random.point(by));
        }
    }
    Patches::new(&points, [degree; 2], rows, columns).unwrap()
}

#[test]
fn normals_of_patches_are_in_their_cones() {
    let mut random = Random(3);
    for degree in 1..=MAX_DEGREE {
        for by in [0.0, 0.01, 0.1, 1.0] {
            let name = format!("degree {degree}, {by}");
            let sheet = match degree {
                ..4 => Sheet::Cubic(patches(degree, by, &mut random)),
                _ => Sheet::High(patches(degree, by, &mut random)),
            };
            let (telling, _) = check(&name, sheet, 6);
            assert!(telling > 0 || by > 0.02, "{name}");
        }
    }
}

/// Points, lines and planes; and a smooth sheet far from the origin, where rounding is what there
/// is.
#[test]
fn degenerate_sheets_have_cones() {
    let flat = |map: fn(f64, f64) -> DVec3| {
        let shape = Shape { name: "", cells: [9, 13], closed: [false; 2], point: map };
        Sheet::Grid(grid(&shape))
    };
    assert_eq!(check("point", flat(|_, _| DVec3::ONE), 2).0, 0);
    assert_eq!(check("line", flat(|u, v| DVec3::new(u + v, 0.0, 0.0)), 2).0, 0);
    let (telling, _) = check("plane", flat(|u, v| DVec3::new(u, v, 0.0)), 2);
    assert_eq!(telling, 12);
    check("far", flat(|u, v| DVec3::new(1e9 + u, v, 0.1 * (3.0 * u).sin())), 5);
    check("farther", flat(|u, v| DVec3::new(1e14 + u, v, 0.1 * (3.0 * u).sin())), 5);
    check("folded", flat(|u, v| DVec3::new((3.0 * u - 1.5).powi(2), v, 0.01 * u)), 5);
}

/// On a smooth surface cones are not much wider than they must be.
#[test]
fn cones_are_tight() {
    let shape = Shape { cells: [200, 400], ..SHAPES[0] };
    let surface = with_cones(Sheet::Grid(grid(&shape)));
    let (mut cones, mut true_ones) = (0.0, 0.0);
    for (r, c) in (0..50).flat_map(|r| (0..100).map(move |c| (r, c))) {
        let cone = surface.normal_cone(0, 0, [r, c]).unwrap();
        cones += cone.angle;
        let corner = |i: usize, j: usize| {
            let cell = [4 * r + i, 4 * c + j].map(|k| k as u32);
            angle(cone.axis, surface.normal(Place { sheet: 0, cell, u: (i / 3) as f64, v: (j / 3) as f64 }))
        };
        true_ones += [corner(0, 0), corner(0, 3), corner(3, 0), corner(3, 3)].into_iter().fold(0.0, f64::max);
    }
    let ratio = cones / true_ones;
    assert!(ratio < 2.5, "{ratio}");
    // The greatest is of more than half the torus.
    let greatest = surface.normal_cone(0, 6, [0, 0]).unwrap().angle;
    assert!(greatest > FRAC_PI_2 && surface.normal_cone(0, 7, [0, 0]).is_none());
    assert!(surface.normal_cone(0, 6, [0, 2]).is_none() && surface.normal_cone(1, 0, [0, 0]).is_none());
}

/// The same bits for any number of threads, also when threads ask at once; and within the memory
/// that was promised.
#[test]
fn cones_are_built_once() {
    let shape = Shape { cells: [203, 401], ..SHAPES[1] };
    let made: Vec<Surface<'_>> =
        (0..3).map(|_| Surface::new(vec![Sheet::Grid(grid(&shape))], None, &Job::default()).unwrap()).collect();
    let quiet = Silent;
    made[0].build_cones(&Job::new(1, &quiet)).unwrap();
    made[1].build_cones(&Job::new(3, &quiet)).unwrap();
    std::thread::scope(|scope| {
        for _ in 0..4 {
            scope.spawn(|| made[2].nearest_angle(DVec3::Z, 1.0, false, &Job::new(1, &quiet)).unwrap());
        }
    });
    let all = |surface: &Surface<'_>| -> Vec<NormalCone> {
        let blocks = (0..8).flat_map(|level| (0..51 * 101).map(move |k| (level, [k / 101, k % 101])));
        blocks.filter_map(|(level, block)| surface.normal_cone(0, level, block)).collect()
    };
    let first = all(&made[0]);
    assert!(first.len() > 51 * 101 && first == all(&made[1]) && first == all(&made[2]));
    let bytes = (made[0].index_bytes() + made[0].cone_bytes()) as f64 / made[0].node_count() as f64;
    assert!(made[0].cone_bytes() > 0 && bytes < 9.0, "{bytes}");
    assert_eq!(made[0].cone_bytes(), made[2].cone_bytes());
}
