//! Glues nets by hand: classes of nodes equal a plain union of all pairs, Euler's formula holds for
//! the complex, and detection by coordinates glues no more than was glued.

use crate::agree::agreed;
use crate::input;
use glam::DVec3;
use gusset::Job;
use gusset::mesh::Scalar;
use gusset::net::complex::Complex;
use gusset::net::topology::{CellDiagonal, Gluing, SeamRun, find_gluing_occurrences};
use gusset::net::{LinkMatrix, Net, NodeClasses, Seam, Shape, Sides, Topology, detect_gluing};

/// Runs one case.
pub(crate) fn run(bytes: &[u8]) {
    let Some((size, sides, requests, choice)) = input::taken::<([u8; 2], u8, Vec<[u8; 6]>, u8)>(bytes) else { return };
    let [rows, columns] = size.map(|size| 2 + usize::from(size % 7));
    let shape = Shape::new(rows, columns).expect("a small shape");
    let sides = [Sides::SHEET, Sides::TORUS, Sides::ONE_POLE, Sides::TWO_POLES][usize::from(sides % 4)];
    let gluings: Vec<Gluing> = requests.iter().take(12).map(|&request| gluing(request)).collect();
    let plain = Topology::from_sides(shape, sides);
    let Ok(glued) = plain.glued(&gluings) else { return };
    let (classes, truth) = (NodeClasses::new(&glued).expect("few nodes"), united(&glued));
    for (a, b) in (0..truth.len()).flat_map(|a| (0..a).map(move |b| (a, b))) {
        let same = classes.representative(a as u32) == classes.representative(b as u32);
        assert_eq!(same, truth[a] == truth[b], "{a} {b} {gluings:?}");
    }
    let complex = agreed(choice, |job| Complex::from_topology(&glued, job)).expect("few nodes");
    let euler = complex.vertices as i64 - complex.edges as i64 + complex.faces() as i64;
    assert_eq!(euler, complex.euler_characteristic());
    // Excludes a net glued to a point, and a net with a separate point.
    if complex.is_manifold() && complex.orientable && complex.components == 1 && complex.faces() > 0 {
        let genus = complex.genus().expect("a manifold has one") as i64;
        assert_eq!(euler, 2 * complex.components as i64 - 2 * genus - complex.boundary.len() as i64, "{gluings:?}");
    }
    let matrix = glued.to_link_matrix().expect("few nodes");
    let again = LinkMatrix::from_bytes(shape, &matrix.to_bytes(shape).expect("few nodes")).expect("its own bytes");
    assert!(matrix.links().eq(again.links()));
    let _ = (glued.unglued(&gluings), agreed(choice, |job| find_gluing_occurrences(&glued, false, job)));
    // Each class in a place of its own.
    let place =
        |i: usize, j: usize| DVec3::new(truth[i * columns + j] as f64, (truth[i * columns + j] % 3) as f64, 0.0);
    let net = Net::from_fn(glued.canonical_form().expect("few nodes"), Scalar::F64, place).expect("few nodes");
    if let Ok(found) = detect_gluing(net.coordinates(), 0.0, &Job::default()) {
        let found = united(&found);
        for (a, b) in (0..found.len()).flat_map(|a| (0..a).map(move |b| (a, b))) {
            assert!(found[a] != found[b] || truth[a] == truth[b], "{a} {b} {gluings:?}");
        }
    }
}

fn gluing([kind, a, b, c, d, e]: [u8; 6]) -> Gluing {
    let at = u32::from(a) % 70;
    match kind % 6 {
        0 => Gluing::Link(u32::from(a) % 140),
        1 => Gluing::Star { node: at, mask: b % 17 },
        2 => Gluing::Cell { cell: at, mask: b % 17 },
        3 => Gluing::CellDiagonal {
            cell: at,
            diagonal: if b % 2 == 0 { CellDiagonal::Falling } else { CellDiagonal::Rising },
        },
        _ => {
            let run = |row: u8, column: u8| SeamRun {
                row: u32::from(row % 8),
                column: u32::from(column % 8),
                row_step: i32::from(row / 8 % 3) - 1,
                column_step: i32::from(column / 8 % 3) - 1,
            };
            Gluing::Seam(Seam { a: run(a, b), b: run(c, d), count: u32::from(e % 9) })
        }
    }
}

/// For each node the least that it is one with, by plain repetition over links and seams.
fn united(topology: &Topology) -> Vec<usize> {
    let shape = topology.shape();
    let mut pairs: Vec<[u32; 2]> = topology.seams().iter().flat_map(|seam| seam.pairs(shape)).collect();
    let (rows, columns) = (shape.rows(), shape.columns());
    let node = |i: usize, j: usize| (i % rows * columns + j % columns) as u32;
    let matrix = topology.to_link_matrix().expect("few nodes");
    // Two links a node: to its right and below, round the sides.
    for link in matrix.links() {
        let (i, j) = (link as usize / 2 / columns, link as usize / 2 % columns);
        pairs.push([node(i, j), if link % 2 == 0 { node(i, j + 1) } else { node(i + 1, j) }]);
    }
    let mut least: Vec<usize> = (0..rows * columns).collect();
    for _ in 0..least.len() {
        for &[a, b] in &pairs {
            let both = least[a as usize].min(least[b as usize]);
            (least[a as usize], least[b as usize]) = (both, both);
        }
    }
    least
}
