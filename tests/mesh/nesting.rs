//! Which closed components face inwards: the walls of cavities. The winding number of the whole
//! result at points inside and outside, summed over solid angles, is 1 in the solid and 0 elsewhere.

use crate::common::{Soup, cap, faces_of, some_of};
use crate::pieces::cube;
use glam::{DQuat, DVec3};
use gusset::Job;
use gusset::assemble::{self, assemble};
use gusset::fill::{self, LoopSelection, fill_holes};
use gusset::mesh::Mesh;
use gusset::repair::orient::{Options, Outward, orient, turn_outwards};
use std::f64::consts::TAU;

/// Numbers below 1 from a seed (SplitMix64).
struct Random(u64);

impl Random {
    fn number(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut x = self.0;
        x = (x ^ (x >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        x = (x ^ (x >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((x ^ (x >> 31)) >> 11) as f64 / (1u64 << 53) as f64
    }

    fn below(&mut self, n: u32) -> u32 {
        (self.number() * f64::from(n)) as u32
    }

    fn direction(&mut self) -> DVec3 {
        DVec3::from_array([0; 3].map(|_| self.number() - 0.5)).normalize()
    }
}

/// A cube or a ball about the origin: between the balls of radius 1/2 and 1.
fn shape(n: i32, is_ball: bool) -> Soup {
    let mut soup = cube(n);
    let scale = |p: DVec3| if is_ball { p.normalize() } else { p * (2.0 / 3f64.sqrt()) };
    soup.points.iter_mut().for_each(|p| *p = scale(DVec3::from_array(*p)).to_array());
    soup
}

/// Components with their centres and depths.
#[derive(Default)]
struct Nest {
    soup: Soup,
    centres: Vec<DVec3>,
    depths: Vec<u32>,
    /// The component of each face.
    owners: Vec<usize>,
}

impl Nest {
    fn add(&mut self, part: &Soup, centre: DVec3, depth: u32) {
        self.owners.extend(part.faces().map(|_| self.centres.len()));
        self.soup = if self.centres.is_empty() { part.clone() } else { self.soup.and(part) };
        self.centres.push(centre);
        self.depths.push(depth);
    }

    /// A component within the ball, and up to two within each.
    fn fill_ball(&mut self, centre: DVec3, radius: f64, depth: u32, random: &mut Random) {
        let mut part = shape(2 + random.below(3) as i32, random.below(2) == 0);
        let turn = DQuat::from_axis_angle(random.direction(), TAU * random.number());
        part.points.iter_mut().for_each(|p| *p = (centre + turn * DVec3::from_array(*p) * radius).to_array());
        self.add(&if random.below(2) == 0 { part.turned() } else { part }, centre, depth);
        if depth == 4 {
            return;
        }
        let inner = 0.5 * radius;
        match random.below(4) {
            0 => {}
            1 => {
                let r = inner * (0.4 + 0.55 * random.number());
                self.fill_ball(centre + random.direction() * (inner - r) * 0.95, r, depth + 1, random);
            }
            _ => {
                let (r, way) = (inner * (0.2 + 0.28 * random.number()), random.direction());
                for side in [1.0, -1.0] {
                    self.fill_ball(centre + way * side * (inner - r), r * 0.95, depth + 1, random);
                }
            }
        }
    }

    /// Moves everything to another place and unit.
    fn moved(mut self, shift: DVec3, unit: f64) -> Self {
        self.soup.points.iter_mut().for_each(|p| *p = ((DVec3::from_array(*p) + shift) * unit).to_array());
        self.centres.iter_mut().for_each(|p| *p = (*p + shift) * unit);
        self
    }
}

/// The winding number of some faces around a point, from solid angles (Van Oosterom, Strackee).
fn winding<'a>(mesh: &'a Mesh, p: DVec3, faces: impl Iterator<Item = &'a [u32]>) -> f64 {
    let unit = mesh.positions.get(0).distance(p);
    let at = |v: u32| (mesh.positions.get(v) - p) / unit;
    let mut sum = 0.0;
    for face in faces {
        for k in 1..face.len() - 1 {
            let [a, b, c] = [face[0], face[k], face[k + 1]].map(at);
            let [x, y, z] = [a, b, c].map(DVec3::length);
            let lower = x * y * z + a.dot(b) * z + b.dot(c) * x + c.dot(a) * y;
            sum += a.dot(b.cross(c)).atan2(lower) * 2.0;
        }
    }
    sum / (2.0 * TAU)
}

/// The winding number of each component around its centre is 1 at even depths, else -1.
fn assert_faces_the_solid(nest: &Nest, mesh: &Mesh) {
    for (k, (&centre, &depth)) in nest.centres.iter().zip(&nest.depths).enumerate() {
        let own = faces_of(mesh).zip(&nest.owners).filter(|&(_, &owner)| owner == k).map(|(face, _)| face);
        let expected = if depth % 2 == 0 { 1.0 } else { -1.0 };
        assert!((winding(mesh, centre, own) - expected).abs() < 1e-6, "component {k} at depth {depth}");
    }
}

#[test]
fn walls_of_cavities_face_into_them() {
    for case in some_of(5, 0..1000) {
        let mut random = Random(case);
        let mut nest = Nest::default();
        for k in 0..1 + random.below(3) {
            nest.fill_ball(DVec3::X * 2.1 * f64::from(k), 1.0, 0, &mut random);
        }
        let unit = 2f64.powi(random.below(500) as i32 - 250) * (1.0 + random.number());
        let nest = nest.moved(random.direction() * 1e3 * random.number(), unit);
        let before = gusset::mesh::concatenate(&[nest.soup.view()], &Job::default()).unwrap().0;
        let mut mesh = before.clone();
        let turned = turn_outwards(&mut mesh, &Job::default()).unwrap();
        assert_faces_the_solid(&nest, &mesh);
        // Each component encloses its centre, and so do those that enclose it.
        for (k, &centre) in nest.centres.iter().enumerate() {
            let around = (0..nest.centres.len()).filter(|&j| {
                let own = faces_of(&mesh).zip(&nest.owners).filter(|&(_, &owner)| owner == j).map(|(face, _)| face);
                j != k && winding(&mesh, centre, own).abs() > 0.5
            });
            // A child may lie around the centre of its parent.
            assert!(around.count() as u32 >= nest.depths[k]);
        }
        assert!(turned.zero_volume.is_empty());
        let done = orient(&nest.soup.view(), &Options { outward: Outward::Closed }, &Job::default()).unwrap();
        assert_eq!(done.mesh, mesh);
        let options = fill::Options { outward: Outward::Closed, ..fill::Options::default() };
        let filled = fill_holes(&nest.soup.view(), LoopSelection::All, &options, &Job::default()).unwrap();
        assert_eq!((filled.mesh, filled.turned_outwards), (mesh.clone(), turned.turned));
        let options = assemble::Options::default();
        assert_eq!(assemble(&[nest.soup.view()], &options, &Job::default()).unwrap().mesh, mesh);
    }
}

fn two(outer: &Soup, inner: &Soup) -> [bool; 2] {
    let mut mesh = gusset::mesh::concatenate(&[outer.view(), inner.view()], &Job::default()).unwrap().0;
    let turned = turn_outwards(&mut mesh, &Job::default()).unwrap().turned;
    let first = outer.faces().count() as u32;
    [turned.contains(&0), turned.contains(&first)]
}

fn moved(soup: &Soup, scale: f64, shift: [f64; 3]) -> Soup {
    let mut soup = soup.clone();
    let shift = DVec3::from_array(shift);
    soup.points.iter_mut().for_each(|p| *p = (DVec3::from_array(*p) * scale + shift).to_array());
    soup
}

#[test]
fn only_components_that_lie_apart_within_others_are_cavities() {
    let cube = cube(2);
    let small = |shift: [f64; 3]| moved(&cube, 0.25, shift);
    // Within; within at a lattice point, where rays meet edges and vertices; outside; beside a wall.
    assert_eq!(two(&cube, &small([0.1, 0.05, 0.02])), [false, true]);
    assert_eq!(two(&cube, &small([0.125, 0.125, 0.125])), [false, true]);
    assert_eq!(two(&cube, &small([0.7, 0.0, 0.0])), [false, false]);
    // Components that cross are solids.
    assert_eq!(two(&cube, &small([0.45, 0.0, 0.0])), [false, false]);
    // A spike of the outer component runs through the inner one, all of whose vertices lie inside.
    let mut spiked = cube.clone();
    let top = spiked.points.iter().position(|p| *p == [0.0, 0.0, 0.5]).unwrap();
    assert_eq!(two(&spiked, &small([0.0, 0.0, 0.2])), [false, true]);
    spiked.points[top] = [0.0, 0.0, -0.4];
    assert_eq!(two(&spiked, &small([0.0, 0.0, 0.2])), [false, false]);
    // Walls that touch; a component given twice.
    assert_eq!(two(&cube, &small([0.375, 0.0, 0.0])), [false, false]);
    assert_eq!(two(&cube, &cube), [false, false]);
    // A common vertex is not a crossing.
    let corner = Soup::new(
        vec![[0.5, 0.0, 0.0], [0.2, 0.1, 0.0], [0.2, -0.1, 0.1], [0.2, -0.1, -0.1]],
        &[&[0, 1, 2], &[0, 2, 3], &[0, 3, 1], &[1, 3, 2]],
    );
    for corner in [corner.clone(), corner.turned()] {
        let turned = two(&cube, &corner);
        let mut mesh = gusset::mesh::concatenate(&[corner.view()], &Job::default()).unwrap().0;
        let alone = !turn_outwards(&mut mesh, &Job::default()).unwrap().turned.is_empty();
        assert_eq!(turned, [false, !alone]);
    }
    // All vertices of the inner component lie on the outer one: within it, or outside in a notch.
    let octahedron = |at: [[f64; 3]; 6]| {
        Soup::new(
            at.to_vec(),
            &[&[0, 2, 4], &[2, 1, 4], &[1, 3, 4], &[3, 0, 4], &[2, 0, 5], &[1, 2, 5], &[3, 1, 5], &[0, 3, 5]],
        )
    };
    let centres = [0, 0, 1, 1, 2, 2].map(|k| [0, 1, 2].map(|j| if j == k { 0.5 } else { 0.0 }));
    let sign = |k: usize| if k.is_multiple_of(2) { 1.0 } else { -1.0 };
    let inscribed = octahedron([0, 1, 2, 3, 4, 5].map(|k| centres[k].map(|x| x * sign(k))));
    assert_eq!(two(&cube, &inscribed), [false, true]);
    assert_eq!(two(&cube, &inscribed.turned()), [false, false]);
    let mut notched = cube.clone();
    notched.points[top] = [0.0, 0.0, -0.25];
    let middles = [[0.0, 0.0, -0.25], [0.5, 0.0, 0.5], [0.0, 0.5, 0.5], [-0.5, 0.0, 0.5]];
    let plug = Soup::new(middles.to_vec(), &[&[0, 2, 1], &[0, 3, 2], &[0, 1, 3], &[1, 2, 3]]);
    assert_eq!([two(&notched, &plug)[1], two(&notched, &plug.turned())[1]], [false, true]);
    // Open components enclose nothing, and stay.
    let bowl = moved(&cap(12, 4, 0.2, 1.0), 4.0, [0.0; 3]);
    assert_eq!(two(&bowl, &small([0.0, 0.0, 1.0]).turned()), [false, true]);
    assert_eq!(two(&cube, &moved(&cap(12, 4, 0.2, 1.0), 0.2, [0.0; 3]).turned()), [false, false]);
}
