//! Shapes made by formula, and independent checks, for the integration tests.
#![allow(dead_code, unreachable_pub, reason = "each test file uses its own part")]

pub mod data;

use gusset::mesh::{Faces, Mesh, MeshView, Positions};
use gusset::{Job, Progress};
use std::cell::Cell;
use std::collections::{HashMap, HashSet};
use std::f64::consts::TAU;
use std::ops::ControlFlow;

/// Under `make exhaustive`.
pub fn is_exhaustive() -> bool {
    std::env::var_os("GUSSET_EXHAUSTIVE").is_some()
}

/// Every `step`-th of many cases, or all of them under `make exhaustive`.
pub fn some_of<I: Iterator>(step: usize, cases: I) -> impl Iterator<Item = I::Item> {
    cases.step_by(if is_exhaustive() { 1 } else { step })
}

/// A mesh as a test writes it down.
#[derive(Clone, Default, Debug)]
pub struct Soup {
    pub points: Vec<[f64; 3]>,
    pub offsets: Vec<u32>,
    pub corners: Vec<u32>,
}

impl Soup {
    pub fn new(points: Vec<[f64; 3]>, faces: &[&[u32]]) -> Self {
        let mut soup = Soup { points, offsets: vec![0], corners: Vec::new() };
        faces.iter().for_each(|face| soup.face(face));
        soup
    }

    /// `count` points on a circle's arc, so that no three are in line and none coincide.
    pub fn flat(count: usize, faces: &[&[u32]]) -> Self {
        let points = (0..count).map(|i| (i as f64, 0.1 * (i * i) as f64, 0.0).into()).collect();
        Soup::new(points, faces)
    }

    pub fn face(&mut self, face: &[u32]) {
        self.corners.extend(face);
        self.offsets.push(self.corners.len() as u32);
    }

    pub fn faces(&self) -> impl Iterator<Item = &[u32]> + Clone {
        self.offsets.windows(2).map(|w| &self.corners[w[0] as usize..w[1] as usize])
    }

    /// The faces that are kept, and the vertices that they use in the order of their first corners.
    pub fn part(&self, keeps: impl Fn(&[u32]) -> bool) -> Soup {
        let mut part = Soup { offsets: vec![0], ..Soup::default() };
        let mut names = HashMap::new();
        for face in self.faces().filter(|face| keeps(face)) {
            for v in face {
                part.corners.push(*names.entry(*v).or_insert_with(|| {
                    part.points.push(self.points[*v as usize]);
                    part.points.len() as u32 - 1
                }));
            }
            part.offsets.push(part.corners.len() as u32);
        }
        part
    }

    /// The mean of some of its points.
    pub fn middle(&self, face: &[u32]) -> glam::DVec3 {
        face.iter().map(|&v| glam::DVec3::from_array(self.points[v as usize])).sum::<glam::DVec3>() / face.len() as f64
    }

    pub fn view(&self) -> MeshView<'_> {
        let faces = Faces::polygons(&self.offsets, &self.corners).unwrap();
        MeshView::new(Positions::from(self.points.as_slice()), faces, &Job::default()).unwrap()
    }

    /// All faces turned over.
    pub fn turned(&self) -> Soup {
        let mut soup = Soup { points: self.points.clone(), offsets: vec![0], corners: Vec::new() };
        for face in self.faces() {
            soup.face(&face.iter().rev().copied().collect::<Vec<_>>());
        }
        soup
    }

    /// This mesh and another, not joined.
    pub fn and(&self, other: &Soup) -> Soup {
        let mut soup = self.clone();
        let first = soup.points.len() as u32;
        soup.points.extend(&other.points);
        for face in other.faces() {
            soup.face(&face.iter().map(|v| v + first).collect::<Vec<_>>());
        }
        soup
    }
}

/// A sheet of w x h square cells in the plane z = 0, faces counter-clockwise from above.
pub fn sheet(w: u32, h: u32) -> Soup {
    let at = |i: u32, j: u32| j * (w + 1) + i;
    let mut soup = Soup { offsets: vec![0], ..Soup::default() };
    for j in 0..=h {
        for i in 0..=w {
            soup.points.push([f64::from(i), f64::from(j), 0.0]);
        }
    }
    for j in 0..h {
        for i in 0..w {
            soup.face(&[at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)]);
        }
    }
    soup
}

/// The part of the unit sphere above (`sign` = 1) or below (-1) the height z = `sign` * `rim`. It
/// has a pole and `rings` rings of `n` vertices, the last of which is the rim. Faces are
/// counter-clockwise from outside.
pub fn cap(n: u32, rings: u32, rim: f64, sign: f64) -> Soup {
    let mut soup = Soup { points: vec![[0.0, 0.0, sign]], offsets: vec![0], ..Soup::default() };
    let end = rim.acos();
    for ring in 1..=rings {
        let theta = end * f64::from(ring) / f64::from(rings);
        for i in 0..n {
            let phi = sign * TAU * (f64::from(i) + 0.37 * f64::from(ring)) / f64::from(n);
            soup.points.push([theta.sin() * phi.cos(), theta.sin() * phi.sin(), sign * theta.cos()]);
        }
    }
    let at = |ring: u32, i: u32| 1 + (ring - 1) * n + i % n;
    for i in 0..n {
        soup.face(&[0, at(1, i), at(1, i + 1)]);
    }
    for ring in 1..rings {
        for i in 0..n {
            soup.face(&[at(ring, i), at(ring + 1, i), at(ring + 1, i + 1), at(ring, i + 1)]);
        }
    }
    soup
}

/// A torus round the z axis of n x m quads, faces outwards.
pub fn torus(n: u32, m: u32) -> Soup {
    let mut soup = Soup { offsets: vec![0], ..Soup::default() };
    for i in 0..n {
        for j in 0..m {
            let (s, t) = (TAU * f64::from(i) / f64::from(n), TAU * f64::from(j) / f64::from(m));
            soup.points.push([(2.0 + t.cos()) * s.cos(), (2.0 + t.cos()) * s.sin(), t.sin()]);
            let (a, b) = ((i + 1) % n, (j + 1) % m);
            soup.face(&[i * m + j, a * m + j, a * m + b, i * m + b]);
        }
    }
    soup
}

/// How often each edge is run from its smaller to its larger vertex, and back: counted by hashing,
/// unlike the library.
pub fn edge_counts<'a>(faces: impl Iterator<Item = &'a [u32]>) -> HashMap<(u32, u32), (u32, u32)> {
    let mut edges = HashMap::new();
    for face in faces {
        for (i, &u) in face.iter().enumerate() {
            let v = face[(i + 1) % face.len()];
            let entry: &mut (u32, u32) = edges.entry((u.min(v), u.max(v))).or_default();
            if u < v { entry.0 += 1 } else { entry.1 += 1 }
        }
    }
    edges
}

/// The faces of a result.
pub fn faces_of(mesh: &Mesh) -> impl Iterator<Item = &[u32]> + Clone {
    mesh.face_offsets.windows(2).map(|w| &mesh.face_corners[w[0] as usize..w[1] as usize])
}

/// Vertices (used ones) - edges + faces.
pub fn euler<'a>(faces: impl Iterator<Item = &'a [u32]> + Clone) -> i64 {
    let used: HashSet<u32> = faces.clone().flatten().copied().collect();
    used.len() as i64 - edge_counts(faces.clone()).len() as i64 + faces.count() as i64
}

/// The volume enclosed, by the divergence theorem over fans of triangles; positive if faces look
/// outwards.
pub fn volume<'a>(point: impl Fn(u32) -> [f64; 3], faces: impl Iterator<Item = &'a [u32]>) -> f64 {
    let mut sum = 0.0;
    for face in faces {
        for k in 1..face.len() - 1 {
            let [a, b, c] = [point(face[0]), point(face[k]), point(face[k + 1])];
            sum += a[0] * (b[1] * c[2] - b[2] * c[1])
                + a[1] * (b[2] * c[0] - b[0] * c[2])
                + a[2] * (b[0] * c[1] - b[1] * c[0]);
        }
    }
    sum / 6.0
}

/// Progress that never goes back.
#[derive(Default)]
pub struct Steady(Cell<f64>);

impl Progress for Steady {
    fn step(&self, fraction: f64, stage: &'static str) -> ControlFlow<()> {
        assert!((self.0.get()..=1.0).contains(&fraction), "{stage}: {fraction} after {}", self.0.get());
        self.0.set(fraction);
        ControlFlow::Continue(())
    }
}

/// Ignores progress and never cancels.
pub struct Silent;

impl Progress for Silent {
    fn step(&self, _: f64, _: &'static str) -> ControlFlow<()> {
        ControlFlow::Continue(())
    }
}

/// Cancels at a report, counted from 0.
pub struct StopAt(Cell<u32>);

impl StopAt {
    pub fn new(report: u32) -> Self {
        StopAt(Cell::new(report))
    }
}

impl Progress for StopAt {
    fn step(&self, _: f64, _: &'static str) -> ControlFlow<()> {
        let left = self.0.get();
        self.0.set(left.wrapping_sub(1));
        if left == 0 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    }
}
