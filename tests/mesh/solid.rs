//! Repair, judged by solids of unit cubes: sets of cells of a lattice, whose volume is their count.

use crate::common::{Soup, edge_counts, faces_of, is_exhaustive, volume};
use glam::DVec3;
use gusset::Job;
use gusset::attributes::Origins;
use gusset::mesh::NONE;
use gusset::solid::{DropReason, Options, Repaired, repair};
use proptest::prelude::*;
use std::collections::{BTreeMap, BTreeSet, HashMap};

pub(crate) type Cell = [i32; 3];

/// The corners of the wall of a cell in direction `axis`, `up` or down, counter-clockwise from
/// outside.
pub(crate) fn wall(cell: Cell, axis: usize, up: bool) -> [Cell; 4] {
    let (x, y) = ((axis + 1) % 3, (axis + 2) % 3);
    let corner = |i: i32, j: i32| {
        let mut corner = cell;
        corner[axis] += i32::from(up);
        corner[x] += i;
        corner[y] += j;
        corner
    };
    let mut corners = [corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)];
    if !up {
        corners.reverse();
    }
    corners
}

fn neighbour(cell: Cell, axis: usize, up: bool) -> Cell {
    let mut next = cell;
    next[axis] += if up { 1 } else { -1 };
    next
}

fn directions() -> impl Iterator<Item = (usize, bool)> {
    (0..3).flat_map(|axis| [(axis, false), (axis, true)])
}

/// Walls as a mesh with common vertices.
pub(crate) fn mesh_of(walls: impl IntoIterator<Item = [Cell; 4]>) -> Soup {
    let mut numbers = BTreeMap::new();
    let mut soup = Soup { offsets: vec![0], ..Soup::default() };
    for wall in walls {
        let face = wall.map(|corner| {
            *numbers.entry(corner).or_insert_with(|| {
                soup.points.push(corner.map(f64::from));
                soup.points.len() as u32 - 1
            })
        });
        soup.face(&face);
    }
    soup
}

/// The walls between cells of the set and others, outwards.
pub(crate) fn outer_walls(cells: &BTreeSet<Cell>) -> Vec<[Cell; 4]> {
    let of_cell = |&cell: &Cell| {
        directions()
            .filter(move |&(axis, up)| !cells.contains(&neighbour(cell, axis, up)))
            .map(move |(axis, up)| wall(cell, axis, up))
    };
    cells.iter().flat_map(of_cell).collect()
}

/// The walls between two cells of the set, each once.
fn inner_walls(cells: &BTreeSet<Cell>) -> Vec<[Cell; 4]> {
    let of_cell = |&cell: &Cell| {
        (0..3).filter(move |&axis| cells.contains(&neighbour(cell, axis, true))).map(move |axis| wall(cell, axis, true))
    };
    cells.iter().flat_map(of_cell).collect()
}

/// Adds the cells that the set encloses.
fn without_cavities(mut cells: BTreeSet<Cell>) -> BTreeSet<Cell> {
    let mut outside = BTreeSet::from([[-1; 3]]);
    let mut reached = vec![[-1; 3]];
    while let Some(cell) = reached.pop() {
        for (axis, up) in directions() {
            let next = neighbour(cell, axis, up);
            if next.iter().all(|x| (-1..=SIZE).contains(x)) && !cells.contains(&next) && outside.insert(next) {
                reached.push(next);
            }
        }
    }
    for x in 0..SIZE {
        for y in 0..SIZE {
            cells.extend((0..SIZE).map(|z| [x, y, z]).filter(|cell| !outside.contains(cell)));
        }
    }
    cells
}

const SIZE: i32 = 4;

fn cells() -> impl Strategy<Value = BTreeSet<Cell>> {
    prop::collection::btree_set(prop::array::uniform3(0..SIZE), 1..40)
}

fn repaired(soup: &Soup) -> Repaired {
    repair(&soup.view(), &Options::default(), &Job::default()).unwrap()
}

pub(crate) fn volume_of(repaired: &Repaired) -> f64 {
    volume(|v| repaired.mesh.positions.get(v).to_array(), faces_of(&repaired.mesh))
}

/// Checks edges and fans by hashing, unlike the library.
pub(crate) fn assert_manifold(repaired: &Repaired) {
    assert!(edge_counts(faces_of(&repaired.mesh)).values().all(|&count| count == (1, 1)), "{:?}", repaired.after);
    let mut next: HashMap<u32, HashMap<u32, u32>> = HashMap::new();
    for face in faces_of(&repaired.mesh) {
        for (i, &v) in face.iter().enumerate() {
            let (before, after) = (face[(i + face.len() - 1) % face.len()], face[(i + 1) % face.len()]);
            assert!(next.entry(v).or_default().insert(after, before).is_none());
        }
    }
    for (v, links) in next {
        let start = *links.keys().next().unwrap();
        let (mut at, mut count) = (links[&start], 1);
        while at != start {
            (at, count) = (links[&at], count + 1);
        }
        assert_eq!(count, links.len(), "vertex {v} has several fans");
    }
    assert!(repaired.is_valid() || !repaired.intersections.is_empty());
}

/// Checks that the result bounds these cells, and that nothing but `dropped` faces is missing.
fn assert_solid(soup: &Soup, repaired: &Repaired, cells: usize, dropped: &[u32]) {
    assert_manifold(repaired);
    assert!((volume_of(repaired) - cells as f64).abs() < 1e-9, "{} instead of {cells}", volume_of(repaired));
    assert_origins(soup, repaired);
    let listed: Vec<u32> = repaired.dropped.iter().map(|dropped| dropped.face).collect();
    assert_eq!(listed, dropped, "{:?}", repaired.dropped);
    for (v, &origin) in repaired.vertex_origin.iter().enumerate() {
        assert!(origin == NONE || repaired.mesh.positions.get(v as u32).to_array() == soup.points[origin as usize]);
    }
}

/// Checks that each corner of an old face lies at the place of its origin on its old face, and each new vertex at
/// its place between old ones.
fn assert_origins(soup: &Soup, repaired: &Repaired) {
    let history = &repaired.history;
    let place = |corner: u32| DVec3::from_array(soup.points[soup.corners[corner as usize] as usize]);
    let face_of = |corner: u32| soup.offsets.partition_point(|&start| start <= corner) - 1;
    for (corner, origin) in history.corners.iter().enumerate() {
        let sources = || origin.corners.into_iter().zip(origin.weights).filter(|&(source, _)| source != NONE);
        let expected: DVec3 = sources().map(|(source, weight)| place(source) * weight).sum();
        let found = repaired.mesh.positions.get(repaired.mesh.corner(corner));
        assert!(expected.distance(found) < 1e-12, "{expected} {found}");
        assert!((sources().map(|(_, weight)| weight).sum::<f64>() - 1.0).abs() < 1e-12);
        let face = repaired.face_origin[repaired.mesh.face_of_corner(corner as u32)];
        assert!(sources().all(|(source, _)| face_of(source) as u32 == face));
    }
    let old = repaired.vertex_origin.iter().take_while(|&&v| v != NONE).count();
    for (v, &(sources, weights)) in (old as u32..).zip(&history.placed) {
        let sources = sources.into_iter().zip(weights).filter(|&(source, _)| source != NONE);
        let expected: DVec3 = sources.map(|(v, weight)| DVec3::from_array(soup.points[v as usize]) * weight).sum();
        assert!(expected.distance(repaired.mesh.positions.get(v)) < 1e-12);
    }
    let others = repaired.vertex_origin.len() - old - history.placed.len();
    assert_eq!((history.parents.len(), history.weights.len()), (others, others));
    Origins::from_repaired(repaired, &Job::default()).unwrap();
}

/// The mesh with own vertices for each face.
pub(crate) fn scattered(soup: &Soup) -> Soup {
    let mut all = Soup { offsets: vec![0], ..Soup::default() };
    for face in soup.faces() {
        let first = all.points.len() as u32;
        all.points.extend(face.iter().map(|&v| soup.points[v as usize]));
        all.face(&(first..first + face.len() as u32).collect::<Vec<_>>());
    }
    all
}

/// Numbers by a linear congruence.
pub(crate) struct Random(pub(crate) u64);

impl Random {
    pub(crate) fn below(&mut self, limit: usize) -> usize {
        self.0 = self.0.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        ((self.0 >> 33) as usize) % limit
    }
}

pub(crate) fn shuffled<T>(mut items: Vec<T>, seed: u64) -> Vec<T> {
    let mut random = Random(seed);
    for k in (1..items.len()).rev() {
        items.swap(k, random.below(k + 1));
    }
    items
}

/// Writes a face as two flat triangles around a point on its first side, and the rest.
fn with_flat_triangle(soup: &Soup, f: usize) -> Soup {
    let mut all = Soup { points: soup.points.clone(), offsets: vec![0], corners: Vec::new() };
    let middle = all.points.len() as u32;
    for (k, face) in soup.faces().enumerate() {
        if k == f {
            all.points.push((soup.middle(&face[..2])).to_array());
            all.face(&[&[face[0], middle], &face[1..]].concat());
            all.face(&[face[0], face[1], middle]);
        } else {
            all.face(face);
        }
    }
    all
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(if is_exhaustive() { 2000 } else { 32 }))]

    #[test]
    fn cubes_that_touch_at_edges_and_vertices_are_separated(cells in cells()) {
        let soup = mesh_of(outer_walls(&cells));
        let repaired = repaired(&soup);
        assert_solid(&soup, &repaired, cells.len(), &[]);
        prop_assert_eq!(repaired.turned.iter().filter(|&&turned| turned).count(), 0);
        let again = repair(&repaired.mesh.view(&Job::default()).unwrap(), &Options::default(), &Job::default()).unwrap();
        prop_assert_eq!(&again.mesh, &repaired.mesh);
    }

    #[test]
    fn scattered_faces_become_one_solid(cells in cells(), seed: u64) {
        let soup = scattered(&mesh_of(shuffled(outer_walls(&cells), seed)));
        assert_solid(&soup, &repaired(&soup), cells.len(), &[]);
    }

    #[test]
    fn walls_within_the_solid_are_dropped(cells in cells(), seed: u64, share in 0.0..1.0) {
        let cells = without_cavities(cells);
        let outer = outer_walls(&cells);
        let inner: Vec<_> = shuffled(inner_walls(&cells), seed);
        let inner = &inner[..(share * inner.len() as f64) as usize];
        let soup = mesh_of(outer.iter().chain(inner).copied());
        let dropped: Vec<u32> = (outer.len()..outer.len() + inner.len()).map(|f| f as u32).collect();
        let repaired = repaired(&soup);
        assert_solid(&soup, &repaired, cells.len(), &dropped);
    }

    #[test]
    fn faces_that_look_inwards_are_turned(cells in cells(), seed: u64) {
        let cells = without_cavities(cells);
        let mut random = Random(seed);
        let turned = |mut wall: [Cell; 4]| {
            if random.below(2) == 1 {
                wall.reverse();
            }
            wall
        };
        let soup = mesh_of(outer_walls(&cells).into_iter().map(turned));
        assert_solid(&soup, &repaired(&soup), cells.len(), &[]);
    }

    #[test]
    fn copies_of_faces_are_dropped(cells in cells(), seed: u64, share in 0.0..1.0, reversed: bool) {
        let outer = outer_walls(&cells);
        let copies: Vec<_> = shuffled(outer.clone(), seed).into_iter().take((share * outer.len() as f64) as usize).collect();
        let turned = |mut wall: [Cell; 4]| {
            if reversed {
                wall.reverse();
            }
            wall
        };
        let soup = mesh_of(outer.iter().copied().chain(copies.iter().map(|&copy| turned(copy))));
        let dropped: Vec<u32> = (outer.len()..outer.len() + copies.len()).map(|f| f as u32).collect();
        assert_solid(&soup, &repaired(&soup), cells.len(), &dropped);
    }

    #[test]
    fn flat_triangles_are_replaced_by_seams(cells in cells(), seed: u64) {
        let soup = mesh_of(outer_walls(&cells));
        let f = Random(seed).below(soup.offsets.len() - 1);
        let soup = with_flat_triangle(&soup, f);
        let repaired = repaired(&soup);
        assert_solid(&soup, &repaired, cells.len(), &[f as u32 + 1]);
        prop_assert_eq!(repaired.dropped[0].reason, DropReason::ZeroArea);
    }

    // Where the rim runs along an edge of other cells, several solids fit.
    #[test]
    fn missing_faces_are_filled(cells in cells(), seed: u64) {
        let mut outer = shuffled(outer_walls(&cells), seed);
        let mut corners: BTreeMap<Cell, BTreeSet<Cell>> = BTreeMap::new();
        for &cell in &cells {
            let of_cell = directions().flat_map(|(axis, up)| wall(cell, axis, up));
            of_cell.for_each(|corner| _ = corners.entry(corner).or_default().insert(cell));
        }
        // Cells at a corner that touch each other in walls.
        let is_plain = |corner: &Cell| {
            let around = &corners[corner];
            let mut reached: Vec<Cell> = around.iter().take(1).copied().collect();
            let mut next = 0;
            while next < reached.len() {
                for (axis, up) in directions() {
                    let other = neighbour(reached[next], axis, up);
                    if around.contains(&other) && !reached.contains(&other) {
                        reached.push(other);
                    }
                }
                next += 1;
            }
            reached.len() == around.len()
        };
        let removed = outer.iter().position(|wall| wall.iter().all(is_plain));
        prop_assume!(removed.is_some());
        outer.remove(removed.unwrap());
        let soup = mesh_of(outer);
        let repaired = repaired(&soup);
        assert_solid(&soup, &repaired, cells.len(), &[]);
        prop_assert_eq!(repaired.filled_holes, 1);
    }

    #[test]
    fn fins_are_dropped(cells in cells(), seed: u64) {
        // Walls outside of the solid that stand on one of its edges.
        let cells = without_cavities(cells);
        let outer = outer_walls(&cells);
        let corners: BTreeSet<Cell> = outer.iter().flatten().copied().collect();
        let edges: BTreeSet<[Cell; 2]> = outer.iter().flat_map(|wall| (0..4).map(|k| {
            let mut edge = [wall[k], wall[(k + 1) % 4]];
            edge.sort_unstable();
            edge
        })).collect();
        let stands = |wall: &[Cell; 4]| {
            let on_edge = (0..4).filter(|&k| {
                let mut edge = [wall[k], wall[(k + 1) % 4]];
                edge.sort_unstable();
                edges.contains(&edge)
            });
            on_edge.count() == 1 && wall.iter().filter(|corner| corners.contains(*corner)).count() == 2
        };
        let everywhere: BTreeSet<Cell> = (-1..=SIZE).flat_map(|x| (-1..=SIZE).flat_map(move |y| (-1..=SIZE).map(move |z| [x, y, z]))).collect();
        let free: BTreeSet<Cell> = everywhere.difference(&cells).copied().collect();
        let fins: Vec<_> = shuffled(inner_walls(&free), seed).into_iter().filter(stands).take(1).collect();
        let soup = mesh_of(outer.iter().chain(&fins).copied());
        let dropped: Vec<u32> = (outer.len()..outer.len() + fins.len()).map(|f| f as u32).collect();
        assert_solid(&soup, &repaired(&soup), cells.len(), &dropped);
    }

    #[test]
    fn fins_at_vertices_are_dropped(cells in cells(), seed: u64) {
        // Walls outside of the solid that meet it in one corner.
        let cells = without_cavities(cells);
        let outer = outer_walls(&cells);
        let corners: BTreeSet<Cell> = outer.iter().flatten().copied().collect();
        let stands = |wall: &[Cell; 4]| wall.iter().filter(|corner| corners.contains(*corner)).count() == 1;
        let everywhere: BTreeSet<Cell> = (-1..=SIZE).flat_map(|x| (-1..=SIZE).flat_map(move |y| (-1..=SIZE).map(move |z| [x, y, z]))).collect();
        let free: BTreeSet<Cell> = everywhere.difference(&cells).copied().collect();
        let fins: Vec<_> = shuffled(inner_walls(&free), seed).into_iter().filter(stands).take(1).collect();
        let soup = mesh_of(outer.iter().chain(&fins).copied());
        let dropped: Vec<u32> = (outer.len()..outer.len() + fins.len()).map(|f| f as u32).collect();
        assert_solid(&soup, &repaired(&soup), cells.len(), &dropped);
    }

    #[test]
    fn narrow_gaps_are_closed(size in prop::array::uniform3(1..=SIZE), width in 1e-3..0.12f64, seed: u64) {
        let cells = (0..size[0]).flat_map(|x| (0..size[1]).flat_map(move |y| (0..size[2]).map(move |z| [x, y, z])));
        let cells: BTreeSet<Cell> = cells.collect();
        let mut random = Random(seed);
        let (fixed, moved): (Vec<_>, Vec<_>) = outer_walls(&cells).into_iter().partition(|_| random.below(2) == 0);
        let shared: BTreeSet<Cell> = fixed.iter().flatten().copied().collect();
        let mut apart = mesh_of(moved.iter().copied());
        for point in &mut apart.points {
            if shared.contains(&point.map(|x| x as i32)) {
                let offset = DVec3::from_array([0.0; 3].map(|_| random.below(1001) as f64 - 500.0)).normalize_or_zero();
                *point = (DVec3::from_array(*point) + width * offset).to_array();
            }
        }
        let soup = mesh_of(fixed.iter().copied()).and(&apart);
        let repaired = repaired(&soup);
        assert_manifold(&repaired);
        prop_assert!(repaired.is_valid() && repaired.dropped.is_empty());
        prop_assert_eq!((repaired.filled_holes, repaired.mesh.face_count()), (0, fixed.len() + moved.len()));
        prop_assert!(repaired.tolerance <= width * (1.0 + 1e-9));
        prop_assert!((volume_of(&repaired) - cells.len() as f64).abs() < 1e-9, "{}", volume_of(&repaired));
    }

    #[test]
    fn pinholes_of_thin_walls_are_filled(size in 1..=SIZE, thickness in 1e-3..0.1f64, pick: prop::sample::Index) {
        let cells = (0..size).flat_map(|x| (0..size).flat_map(move |y| (0..size).map(move |z| [x, y, z])));
        let mut walls = outer_walls(&cells.collect());
        let removed = pick.index(walls.len());
        walls.remove(removed);
        let outer = mesh_of(walls.iter().copied());
        let mut inner = mesh_of(walls.iter().map(|&[a, b, c, d]| [d, c, b, a]));
        let shrunk = |x: f64| thickness + x * (1.0 - 2.0 * thickness / f64::from(size));
        inner.points.iter_mut().for_each(|point| *point = point.map(shrunk));
        let repaired = repaired(&outer.and(&inner));
        assert_manifold(&repaired);
        prop_assert_eq!((repaired.filled_holes, repaired.welded_vertices), (2, 0));
        let expected = f64::from(size).powi(3) - (f64::from(size) - 2.0 * thickness).powi(3);
        prop_assert!((volume_of(&repaired) - expected).abs() < 1e-9, "{} {}", volume_of(&repaired), expected);
    }

    #[test]
    fn boxes_that_overlap_become_their_union(corners in prop::collection::vec(prop::array::uniform6(0..6i32), 2..5)) {
        let boxes: Vec<[[i32; 2]; 3]> =
            corners.iter().map(|c| [0, 1, 2].map(|k| [c[k].min(c[k + 3]), c[k].max(c[k + 3]) + 1])).collect();
        // A box within another without contact is a cavity.
        let is_within = |a: &[[i32; 2]; 3], b: &[[i32; 2]; 3]| (0..3).all(|k| a[k][0] > b[k][0] && a[k][1] < b[k][1]);
        prop_assume!(!boxes.iter().any(|a| boxes.iter().any(|b| is_within(a, b))));
        let mut soup = Soup { offsets: vec![0], ..Soup::default() };
        for sides in &boxes {
            let stretched = |corner: Cell| [0, 1, 2].map(|k| sides[k][corner[k] as usize]);
            let walls = directions().map(|(axis, up)| wall([0; 3], axis, up).map(stretched));
            soup = soup.and(&mesh_of(walls));
        }
        let mut cells = BTreeSet::new();
        for [x, y, z] in boxes {
            for i in x[0]..x[1] {
                for j in y[0]..y[1] {
                    cells.extend((z[0]..z[1]).map(|k| [i, j, k]));
                }
            }
        }
        let repaired = repaired(&soup);
        assert_manifold(&repaired);
        prop_assert!(repaired.is_valid(), "{:?} {:?}", repaired.after, repaired.intersections);
        prop_assert!((volume_of(&repaired) - cells.len() as f64).abs() < 1e-9, "{} {}", volume_of(&repaired), cells.len());
        assert_origins(&soup, &repaired);
    }
}
