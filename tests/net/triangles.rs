//! Nets recognised in meshes of triangles: every triangle in one cell, and the cells that were cut.

use crate::common::Soup;
use crate::space::{sheet, sphere, torus};
use gusset::mesh::Scalar;
use gusset::net::convert::{MeshOptions, net_of_triangles};
use gusset::net::{Net, Sides, Topology};
use gusset::{Error, Job};
use std::collections::BTreeSet;

fn job() -> Job<'static> {
    Job::default()
}

/// Numbers from 0 on, by a linear congruence.
struct Dice(u64);

impl Dice {
    fn next(&mut self, below: usize) -> usize {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) as usize % below
    }
}

/// The diagonals of cells.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Cut {
    OneWay,
    Alternating,
    Random,
}

/// The faces of a net as triangles, in random order, each begun anywhere; and its cells, each with
/// its corners in order.
fn cut(net: &Net<'_>, cut: Cut, seed: u64) -> (Vec<Vec<u32>>, BTreeSet<Vec<u32>>, u32) {
    let mesh = net.to_mesh(&MeshOptions::default(), &job()).unwrap().mesh;
    let (mut triangles, mut cells, mut dice) = (Vec::new(), BTreeSet::new(), Dice(seed | 1));
    let columns = net.shape().columns() - 1;
    for (k, face) in mesh.faces().enumerate() {
        let mut cell = face.to_vec();
        cell.sort_unstable();
        cells.insert(cell);
        let turn = match cut {
            Cut::OneWay => 0,
            Cut::Alternating => (k / columns + k % columns) % 2,
            Cut::Random => dice.next(2),
        };
        match *face {
            [a, b, c, d] if turn == 0 => triangles.extend([vec![a, b, c], vec![a, c, d]]),
            [a, b, c, d] => triangles.extend([vec![a, b, d], vec![b, c, d]]),
            _ => triangles.push(face.to_vec()),
        }
    }
    for k in (1..triangles.len()).rev() {
        triangles.swap(k, dice.next(k + 1));
        triangles[k].rotate_left(dice.next(3));
    }
    (triangles, cells, mesh.positions.len() as u32)
}

fn soup(vertices: u32, triangles: &[Vec<u32>]) -> Soup {
    let faces: Vec<&[u32]> = triangles.iter().map(Vec::as_slice).collect();
    Soup::flat(vertices as usize, &faces)
}

fn tube(rows: usize, columns: usize) -> Net<'static> {
    let mut net = sheet(rows, columns, Scalar::F64);
    net.set_topology(Topology::from_sides(net.shape(), Sides::TUBE));
    net
}

#[test]
fn grids_that_were_cut_are_found_again() {
    let cone = |rows, columns| {
        let mut net = sheet(rows, columns, Scalar::F64);
        net.set_topology(Topology::from_sides(net.shape(), Sides { pole_top: true, ..Sides::TUBE }));
        net
    };
    let mut nets = vec![("torus", torus(9, 13, Scalar::F64)), ("torus", torus(14, 8, Scalar::F64))];
    for (h, w) in [(2, 2), (2, 5), (3, 3), (5, 8), (9, 6), (20, 31)] {
        nets.push(("sheet", sheet(h, w, Scalar::F64)));
        nets.extend((w > 3).then(|| ("tube", tube(h, w))));
        nets.extend((w > 3 && h > 2).then(|| ("cone", cone(h, w))));
        nets.extend((w > 3 && h > 3).then(|| ("sphere", sphere(h, w, Scalar::F64))));
    }
    for (name, net) in &nets {
        for way in [Cut::OneWay, Cut::Alternating, Cut::Random] {
            for seed in 0..6 {
                let (triangles, cells, vertices) = cut(net, way, seed);
                let mesh = soup(vertices, &triangles);
                let found = net_of_triangles(&mesh.view(), &job());
                let what = format!("{name} {:?} {way:?} {seed}", net.shape());
                let found = match found {
                    Ok(found) => found,
                    // Tori that are cut without any rule may be refused, and nothing else.
                    Err(Error::NoGrid { .. }) if *name == "torus" && way == Cut::Random => continue,
                    Err(error) => panic!("{what}: {error}"),
                };
                check(&found, &triangles, &what);
                let [a, b] = [net.shape(), found.net.shape()];
                let same = |found: BTreeSet<Vec<u32>>| found == cells;
                let corners = |cell: usize| {
                    let columns = b.columns() - 1;
                    let mut all = b
                        .corners_of_cell(cell / columns, cell % columns)
                        .map(|n| found.vertex_of_node[n as usize])
                        .to_vec();
                    all.sort_unstable();
                    all.dedup();
                    all
                };
                if *name != "torus" && a.rows() > 4 {
                    assert!(a == b || a == b.transposed(), "{what}: {b:?}");
                    // A mesh closed in one direction and cut in the other may be sheared: its cells
                    // differ.
                    let is_one = *name == "sheet" || way != Cut::OneWay;
                    assert!(!is_one || same((0..b.cell_count()).map(corners).collect()), "{what}");
                }
            }
        }
    }
}

/// Every triangle is half of a cell, or a whole cell at a pole, and the first half of each cell is
/// reported.
fn check(found: &gusset::net::convert::RecognisedNet, triangles: &[Vec<u32>], what: &str) {
    let shape = found.net.shape();
    let mut covered = vec![0; triangles.len()];
    for cell in 0..shape.cell_count() {
        let columns = shape.columns() - 1;
        let corners = shape.corners_of_cell(cell / columns, cell % columns).map(|n| found.vertex_of_node[n as usize]);
        let mut set: Vec<u32> = corners.to_vec();
        set.sort_unstable();
        set.dedup();
        let inside = |t: &Vec<u32>| t.iter().all(|v| set.contains(v));
        let halves: Vec<usize> = (0..triangles.len()).filter(|&k| inside(&triangles[k])).collect();
        // On the smallest nets, triangles of other cells have the same corners.
        if halves.len() == set.len() - 2 {
            assert_eq!(halves[0] as u32, found.face_of_cell[cell], "{what}");
        }
        halves.iter().for_each(|&k| covered[k] += 1);
    }
    assert!(covered.iter().all(|&times| times >= 1), "{what}");
    assert!(shape.rows() < 5 || shape.columns() < 6 || covered.iter().all(|&times| times == 1), "{what}");
}

#[test]
fn positions_keep_their_bits() {
    let net = sphere(9, 13, Scalar::F32);
    let options = MeshOptions { triangles: Some(gusset::net::convert::Diagonal::Shorter), ..MeshOptions::default() };
    let mesh = net.to_mesh(&options, &job()).unwrap().mesh;
    let found = net_of_triangles(&mesh.view(&job()).unwrap(), &job()).unwrap();
    assert_eq!((found.net.shape(), found.net.topology().sides()), (net.shape(), Some(Sides::TWO_POLES)));
    for (node, &vertex) in (0..).zip(&found.vertex_of_node) {
        let (i, j) = net.shape().row_and_column(node);
        assert_eq!(
            found.net.get(i, j).to_array().map(f64::to_bits),
            mesh.positions.get(vertex).to_array().map(f64::to_bits)
        );
    }
}

#[test]
fn what_is_no_grid_is_refused() {
    let refused = |vertices: u32, triangles: &[Vec<u32>]| matches!(net_of_triangles(&soup(vertices, triangles).view(), &job()), Err(Error::NoGrid { face }) if (face as usize) < triangles.len().max(1));
    // One triangle; an icosahedron's fan of five with a rim of triangles round it; a quad.
    assert!(refused(3, &[vec![0, 1, 2]]));
    assert!(refused(4, &[vec![0, 1, 2, 3]]));
    let icosahedron: Vec<Vec<u32>> = [
        [0, 1, 2],
        [0, 2, 3],
        [0, 3, 4],
        [0, 4, 5],
        [0, 5, 1],
        [1, 6, 2],
        [2, 6, 7],
        [2, 7, 3],
        [3, 7, 8],
        [3, 8, 4],
        [4, 8, 9],
        [4, 9, 5],
        [5, 9, 10],
        [5, 10, 1],
        [1, 10, 6],
        [11, 7, 6],
        [11, 8, 7],
        [11, 9, 8],
        [11, 10, 9],
        [11, 6, 10],
    ]
    .map(|t| t.to_vec())
    .to_vec();
    // The icosahedron is a grid: two fans of five, and a ring of ten triangles, five cells.
    let found = net_of_triangles(&soup(12, &icosahedron).view(), &job()).unwrap();
    assert_eq!((found.net.shape().rows(), found.net.shape().columns()), (4, 6));
    // A grid with a triangle away, and one with a triangle cut in three.
    let (mut triangles, _, vertices) = cut(&sheet(8, 9, Scalar::F64), Cut::Random, 4);
    triangles.remove(20);
    assert!(refused(vertices, &triangles));
    let (mut triangles, _, vertices) = cut(&sphere(8, 9, Scalar::F64), Cut::Alternating, 4);
    let [a, b, c] = [0, 1, 2].map(|k| triangles[17][k]);
    triangles[17] = vec![a, b, vertices];
    triangles.extend([vec![b, c, vertices], vec![c, a, vertices]]);
    assert!(refused(vertices + 1, &triangles));
    // Two grids side by side; three faces at an edge; faces of both orientations.
    let (first, _, count) = cut(&sheet(4, 5, Scalar::F64), Cut::OneWay, 1);
    let second: Vec<Vec<u32>> = first.iter().map(|t| t.iter().map(|v| v + count).collect()).collect();
    assert!(refused(2 * count, &[first.clone(), second].concat()));
    assert!(refused(count + 1, &[first.clone(), vec![vec![first[0][0], first[0][1], count]]].concat()));
    let mut turned = first.clone();
    turned[5].reverse();
    assert!(refused(count, &turned));
}

#[test]
fn large_grids_are_found_in_time_that_grows_with_their_size() {
    for net in [sheet(150, 160, Scalar::F32), tube(150, 160), sphere(150, 160, Scalar::F32)] {
        let (triangles, _, vertices) = cut(&net, Cut::Random, 7);
        let found = net_of_triangles(&soup(vertices, &triangles).view(), &job()).unwrap();
        assert!(found.net.shape() == net.shape() || found.net.shape() == net.shape().transposed());
    }
}
