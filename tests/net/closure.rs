//! Closures: what surface each one makes.

use crate::complexes::{Oracle, area_and_volume, check_gauss_bonnet, degrees, pairs};
use glam::DVec3;
use gusset::net::closure::{self, BoxKind, Cuboid};
use gusset::net::complex::Complex;
use gusset::net::{Shape, Sides, Topology};
use gusset::{Error, Job};

const KINDS: [BoxKind; 3] = [BoxKind::Slit, BoxKind::Cross, BoxKind::Concentric];

fn complex(topology: &Topology) -> Complex {
    let complex = Complex::from_topology(topology, &Job::default()).unwrap();
    if topology.shape().node_count() <= 200 {
        Oracle::new(topology.shape(), &pairs(topology), |_, _| true).check(&complex);
    }
    complex
}

/// A surface with this Euler characteristic, this many boundary loops, and one fan at each vertex.
#[track_caller]
fn check(topology: &Topology, chi: i64, loops: usize, orientable: bool) -> Complex {
    let complex = complex(topology);
    assert_eq!((complex.euler_characteristic(), complex.boundary.len()), (chi, loops));
    assert!(complex.is_manifold(), "{complex:?}");
    assert_eq!((complex.is_closed(), complex.orientable), (loops == 0, orientable));
    let handles = 2 - chi - loops as i64;
    assert_eq!(complex.genus(), Some(if orientable { handles / 2 } else { handles } as u64));
    if loops == 0 {
        check_gauss_bonnet(topology, &complex);
    }
    complex
}

fn sizes() -> impl Iterator<Item = Shape> {
    (4..9).flat_map(|h| (4..10).map(move |w| Shape::new(h, w).unwrap()))
}

#[test]
fn sides_make_the_surfaces_of_the_table() {
    for shape in sizes() {
        let (h, w) = (shape.rows() as u64, shape.columns() as u64);
        let of = |sides| Topology::from_sides(shape, sides);
        let sheet = check(&of(Sides::SHEET), 1, 1, true);
        assert_eq!(sheet.boundary.edge_count(0) as u64, 2 * (h - 1 + w - 1));
        let tube = check(&of(Sides::TUBE), 0, 2, true);
        assert!((0..2).all(|k| tube.boundary.get(k).len() as u64 == w - 1));
        let two = check(&of(Sides::TWO_POLES), 2, 0, true);
        assert_eq!((two.vertices, two.triangles), ((h - 2) * (w - 1) + 2, 2 * (w - 1)));
        let one = check(&of(Sides::ONE_POLE), 2, 0, true);
        assert_eq!((one.vertices, one.digons), ((h - 2) * (w - 2) + 1, 4));
        let torus = check(&of(Sides::TORUS), 0, 0, true);
        assert_eq!((torus.vertices, torus.quads), ((h - 1) * (w - 1), (h - 1) * (w - 1)));
        // A sphere whose poles are one point: the study's errata, E11.
        let both = Sides { pole_left: true, pole_right: true, ..Sides::SHEET };
        assert_eq!(complex(&of(both)).euler_characteristic(), 1);
    }
}

#[test]
fn sides_turned_round() {
    for shape in sizes() {
        let (h, w) = (shape.rows() as u64, shape.columns() as u64);
        let moebius = check(&closure::moebius(shape).unwrap(), 0, 1, false);
        assert_eq!(moebius.conflicts.len() as u64, h - 1);
        assert_eq!(moebius.boundary.edge_count(0) as u64, 2 * (w - 1));
        let klein = check(&closure::klein(shape).unwrap(), 0, 0, false);
        assert_eq!(klein.conflicts.len() as u64, h - 1);
        assert_eq!(klein.vertices, (h - 1) * (w - 1));
        let plane = check(&closure::projective_plane(shape).unwrap(), 1, 0, false);
        assert_eq!(plane.conflicts.len() as u64, h + w - 2);
        if w % 2 == 0 {
            assert!(matches!(closure::pillow(shape), Err(Error::OptionOutOfRange { .. })));
            continue;
        }
        let topology = closure::pillow(shape).unwrap();
        let pillow = check(&topology, 2, 0, true);
        assert!(pillow.conflicts.is_empty() && pillow.triangles == 0);
        assert_eq!(degrees(&topology).values().filter(|&&degree| degree == 2).count(), 4);
    }
    // The study's counts of conflicts, on 5 x 9 nodes.
    let shape = Shape::new(5, 9).unwrap();
    let conflicts = |topology: gusset::error::Result<Topology>| complex(&topology.unwrap()).conflicts.len();
    assert_eq!(conflicts(closure::moebius(shape)), 4);
    assert_eq!(conflicts(closure::klein(shape)), 4);
    assert_eq!(conflicts(closure::projective_plane(shape)), 12);
    assert_eq!(conflicts(closure::pillow(shape)), 0);
}

fn measured(cuboid: Cuboid) -> (f64, f64) {
    area_and_volume(cuboid.shape().unwrap(), |i, j| DVec3::from_array(cuboid.lattice_point(i, j).map(f64::from)))
}

#[test]
fn cubes_of_all_sizes() {
    for n in 1..=64u32 {
        for kind in KINDS {
            let cuboid = Cuboid::cube(kind, n);
            let topology = cuboid.topology().unwrap();
            let complex = check(&topology, 2, 0, true);
            let (n, cube) = (u64::from(n), f64::from(n).powi(3));
            assert_eq!(measured(cuboid), (2.0 * 6.0 * (n * n) as f64, 6.0 * cube), "{kind:?} {n}");
            if kind == BoxKind::Concentric {
                continue;
            }
            let counts = (complex.vertices, complex.quads, complex.triangles);
            assert_eq!(counts, (6 * n * n + 2, 6 * n * n, 0), "{kind:?} {n}");
            if n <= 8 {
                let degrees = degrees(&topology);
                let of = |wanted| degrees.values().filter(|&&degree| degree == wanted).count() as u64;
                assert_eq!((of(3), of(4)), (8, 6 * n * n - 6));
            }
        }
    }
}

#[test]
fn boxes_of_three_sizes() {
    for code in 0..5 * 5 * 5u32 {
        let cells = [1 + code % 5, 1 + code / 5 % 5, 1 + code / 25];
        let [a, b, c] = cells.map(u64::from);
        let area = 2 * (a * b + b * c + c * a);
        for kind in KINDS {
            let cuboid = Cuboid { kind, cells };
            let complex = check(&cuboid.topology().unwrap(), 2, 0, true);
            assert_eq!(measured(cuboid), (2.0 * area as f64, 6.0 * (a * b * c) as f64), "{cuboid:?}");
            if kind != BoxKind::Concentric {
                assert_eq!((complex.quads, complex.triangles), (area, 0), "{cuboid:?}");
            }
        }
    }
    assert!(matches!(Cuboid { kind: BoxKind::Slit, cells: [1, 0, 1] }.topology(), Err(Error::OptionOutOfRange { .. })));
    assert!(matches!(Cuboid::cube(BoxKind::Slit, u32::MAX).shape(), Err(Error::TooLarge { .. })));
}

/// The study's errata, E12: the crosswise cube's four corner vertices of a cap have four different
/// orders.
#[test]
fn orders_of_the_crosswise_cube() {
    for n in [2u32, 4, 7] {
        let cuboid = Cuboid::cube(BoxKind::Cross, n);
        let shape = cuboid.shape().unwrap();
        let classes = gusset::net::NodeClasses::new(&cuboid.topology().unwrap()).unwrap();
        let order = |corner: [u32; 3]| {
            let nodes = || (0..shape.rows()).flat_map(|i| (0..shape.columns()).map(move |j| (i, j)));
            let (i, j) = nodes().find(|&(i, j)| cuboid.lattice_point(i, j) == corner).unwrap();
            let class = classes.representative(shape.node(i, j));
            nodes().filter(|&(i, j)| classes.representative(shape.node(i, j)) == class).count() as u32
        };
        let mut orders = [[0, 0, n], [n, 0, n], [n, n, n], [0, n, n]].map(order);
        orders.sort_unstable();
        // The tube's seam doubles the one on it.
        assert_eq!(orders, [1, 2, 2 * n + 1, 2 * n + 2]);
    }
}
