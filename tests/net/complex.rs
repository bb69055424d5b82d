//! The quotient complex of nets with holes, bridges and random gluings, against its definition.

use crate::complexes::{Dice, Oracle, pairs};
use crate::space::is_present;
use glam::DVec3;
use gusset::Job;
use gusset::mesh::Scalar;
use gusset::net::complex::Complex;
use gusset::net::convert::MeshOptions;
use gusset::net::topology::{ContractedLinks, Gluing, LinkMatrix, SeamRun};
use gusset::net::{Bridge, BridgeKind, BridgeMode, Direction, Net, Seam, Shape, Sides, Topology, closure};

fn flat(topology: Topology) -> Net<'static> {
    Net::from_fn(topology, Scalar::F32, |i, j| DVec3::new(j as f64, i as f64, 0.0)).unwrap()
}

fn random_topology(dice: &mut Dice, shape: Shape) -> Option<Topology> {
    let (h, w) = (shape.rows() as u64, shape.columns() as u64);
    if dice.below(3) == 0 {
        let start = match dice.below(3) {
            0 => closure::moebius(shape),
            1 => closure::klein(shape),
            _ => closure::projective_plane(shape),
        };
        return start.ok();
    }
    let bits = dice.below(64);
    let on = |k: u64| bits >> k & 1 == 1;
    let sides = Sides {
        rows_closed: on(0),
        columns_closed: on(1),
        pole_top: on(2),
        pole_bottom: on(3),
        pole_left: on(4),
        pole_right: on(5),
    };
    let mut matrix = LinkMatrix::from_sides(shape, if dice.below(2) == 0 { sides } else { Sides::SHEET }).unwrap();
    for _ in 0..dice.below(h * w) {
        matrix.set_contracted(dice.below(2 * h * w) as u32, true);
    }
    let mut seams = Vec::new();
    for _ in 0..dice.below(3) {
        let at = |dice: &mut Dice| SeamRun::along_row(dice.below(h) as u32, dice.below(w) as u32, 0);
        seams.push(Seam { a: at(dice), b: at(dice), count: 1 });
    }
    Topology::new(shape, ContractedLinks::Matrix(matrix), &seams).ok()
}

#[test]
fn random_gluings_with_missing_nodes() {
    let mut dice = Dice(11);
    let mut checked = [0; 2];
    for round in 0..6000 {
        let shape = Shape::new(2 + dice.below(4) as usize, 2 + dice.below(5) as usize).unwrap();
        let Some(topology) = random_topology(&mut dice, shape) else { continue };
        let pairs = pairs(&topology);
        let reversed = dice.below(2) == 1;
        let mut net = flat(topology);
        let all = Complex::from_topology(net.topology(), &Job::default()).unwrap();
        Oracle::new(shape, &pairs, |_, _| true).check(&all);
        assert_eq!(Complex::from_topology(net.topology(), &Job::default()).unwrap(), all);
        for _ in 0..dice.below(1 + shape.node_count() as u64 / 4) {
            let (i, j) = shape.row_and_column(dice.below(shape.node_count() as u64) as u32);
            net.coordinates_mut().set(i, j, DVec3::new(f64::NAN, 0.0, 0.0));
        }
        let present = Complex::from_net(&net, &Job::default()).unwrap();
        let oracle = Oracle::new(shape, &pairs, |i, j| is_present(&net, i, j));
        oracle.check(&present);
        // The mesh has the same cells, even if of glued nodes only some are missing.
        let made = net.to_mesh(&MeshOptions::default(), &Job::default()).unwrap();
        assert_eq!((made.mesh.face_count() as u64, made.wires.len()), (present.faces(), present.wires.len()));
        assert!((0..made.mesh.positions.len() as u32).all(|k| made.mesh.positions.get(k).is_finite()));
        checked[usize::from(present != all)] += 1;
        if reversed && round % 8 == 0 {
            let turned = Complex::from_topology(&net.topology().clone().with_reversed(true), &Job::default()).unwrap();
            for k in 0..all.boundary.len() {
                let (a, b) = (all.boundary.get(k), turned.boundary.get(k));
                assert!(a.iter().eq(b.iter().rev()), "the boundary runs the other way");
            }
        }
    }
    assert!(checked.iter().all(|&count| count > 1000), "{checked:?}");
}

#[test]
fn holes_of_a_plane_have_loops_of_their_own() {
    let shape = Shape::new(10, 12).unwrap();
    let mut net = flat(Topology::from_sides(shape, Sides::SHEET));
    // A hole of 2 x 2 cells, and two that touch at one node.
    for (i, j) in [(2, 2), (5, 5), (7, 7)] {
        net.coordinates_mut().set(i, j, DVec3::splat(f64::INFINITY));
    }
    let complex = Complex::from_net(&net, &Job::default()).unwrap();
    assert_eq!((complex.quads, complex.components), (99 - 12, 1));
    // Round a hole the boundary follows the faces: at the common node of the two it turns from the
    // one to the other.
    let mut lengths: Vec<_> = (0..complex.boundary.len()).map(|k| complex.boundary.edge_count(k)).collect();
    lengths.sort_unstable();
    assert_eq!(lengths, [8, 16, 40]);
    assert_eq!(complex.pinches, [shape.node(6, 6)]);
    assert_eq!(complex.euler_characteristic(), -2);
}

/// Two spheres joined pole to pole: a row of cells whose upper and lower side are a point each is
/// one edge.
#[test]
fn a_thread_is_one_wire() {
    let (h, w) = (6, 9);
    let shape = Shape::new(2 * h, w).unwrap();
    let mut matrix = LinkMatrix::from_sides(shape, Sides::TUBE).unwrap();
    for row in [0, h - 1, h, 2 * h - 1] {
        (0..w - 1).for_each(|j| matrix.set_contracted(2 * shape.node(row, j), true));
    }
    let mut net = flat(Topology::new(shape, ContractedLinks::Matrix(matrix), &[]).unwrap());
    net.bridges_mut().push(Bridge::new(Direction::Down, h as u32, w as u32, BridgeKind::Thread, BridgeMode::Keep));
    let complex = Complex::from_net(&net, &Job::default()).unwrap();
    assert_eq!((complex.euler_characteristic(), complex.components), (3, 1));
    assert_eq!(complex.wires, [[shape.node(h - 1, 0), shape.node(h, 0)]]);
    assert_eq!(complex.digons, w as u64 - 1);
    assert!(complex.is_closed() && complex.genus().is_none());
    // Hidden: two spheres.
    net.bridges_mut()[0].mode = BridgeMode::Hide;
    let complex = Complex::from_net(&net, &Job::default()).unwrap();
    assert_eq!((complex.euler_characteristic(), complex.components), (4, 2));
    assert_eq!((complex.wires.len(), complex.genus()), (0, Some(0)));
    assert_eq!(Complex::from_topology(net.topology(), &Job::default()).unwrap().wires.len(), 1);
}

#[test]
fn three_sheets_at_one_edge() {
    // A strip of which one row is glued to another: a branch along the row.
    let shape = Shape::new(6, 5).unwrap();
    let seam = Seam { a: SeamRun::along_row(1, 0, 1), b: SeamRun::along_row(4, 0, 1), count: 5 };
    let topology = Topology::from_sides(shape, Sides::SHEET).glued(&[Gluing::Seam(seam)]).unwrap();
    let complex = Complex::from_topology(&topology, &Job::default()).unwrap();
    Oracle::new(shape, &pairs(&topology), |_, _| true).check(&complex);
    assert_eq!(complex.branches.len(), 4);
    assert!(complex.genus().is_none() && complex.conflicts.is_empty());
}

/// Only the first node of a pole is missing: its two cells are missing, and the other nodes define
/// the pole.
#[test]
fn a_pole_survives_its_first_node() {
    let mut net = flat(Topology::from_sides(Shape::new(5, 6).unwrap(), Sides::TWO_POLES));
    net.coordinates_mut().set(0, 0, DVec3::NAN);
    let complex = Complex::from_net(&net, &Job::default()).unwrap();
    let made = net.to_mesh(&MeshOptions::default(), &Job::default()).unwrap();
    assert_eq!((complex.faces(), made.mesh.face_count()), (19, 19));
    let pole = made.vertex_of_node[0];
    assert_eq!((made.node_of_vertex[pole as usize], made.mesh.positions.get(pole)), (0, net.get(0, 1)));
}
