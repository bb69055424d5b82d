//! Closed meshes from which a disc is cut, and the distance of its patch from the removed surface.

use crate::common::{Soup, edge_counts, euler, faces_of};
use glam::{DMat3, DVec3};
use gusset::Job;
use gusset::fill::{Fairing, Filled, HoleStatus, LoopSelection, Options, Refinement, fill_holes};
use gusset_oracles::distances::{farthest, nearest_on_any, nearest_on_segment, samples};
use std::collections::BTreeMap;

/// Edges of patches that bend by more are sharp, in radians.
pub(super) const SHARP: f64 = 0.5;
/// A true crease that turns by more at a vertex has a corner there, in radians.
const KINK: f64 = 0.6;

pub(super) fn options(fair: bool) -> Options {
    let plain = Options::default();
    if fair { Options { refinement: Refinement::RimDensity(0), fairing: Fairing::ThinPlate, ..plain } } else { plain }
}

/// A closed mesh of triangles, its true surface, and a disc to cut out.
pub(super) struct Case {
    pub(super) points: Vec<DVec3>,
    pub(super) triangles: Vec<[u32; 3]>,
    pub(super) centre: DVec3,
    pub(super) radius: f64,
    /// The nearest point of the true surface; `None`: of the triangles.
    pub(super) surface: Option<fn(DVec3) -> DVec3>,
}

/// How far a patch is from the truth, in diameters of its hole.
#[derive(Debug, Clone, Copy)]
pub(super) struct Errors {
    /// Hausdorff's distance.
    pub(super) surface: f64,
    /// The largest distance of a true crease from the patch's sharp edges.
    pub(super) missed: f64,
    /// The largest distance of a sharp edge of the patch from the true creases.
    pub(super) invented: f64,
}

fn normal(points: &[DVec3], triangle: [u32; 3]) -> DVec3 {
    let [a, b, c] = triangle.map(|v| points[v as usize]);
    (b - a).cross(c - a).normalize_or_zero()
}

/// The edges of triangles that bend by more than [`SHARP`], of those for which `counts` is true of a
/// triangle at them, in the order of their vertices.
pub(super) fn sharp_edges(points: &[DVec3], triangles: &[[u32; 3]], counts: impl Fn(usize) -> bool) -> Vec<[u32; 2]> {
    let mut at: BTreeMap<(u32, u32), Vec<usize>> = BTreeMap::new();
    for (t, &[a, b, c]) in triangles.iter().enumerate() {
        [(a, b), (b, c), (c, a)].iter().for_each(|&(u, v)| at.entry((u.min(v), u.max(v))).or_default().push(t));
    }
    let mut found = Vec::new();
    for ((u, v), at) in at {
        if let [s, t] = at[..]
            && (counts(s) || counts(t))
            && normal(points, triangles[s]).angle_between(normal(points, triangles[t])) > SHARP
        {
            found.push([u, v]);
        }
    }
    found
}

/// The same, as pairs of points.
fn sharp(points: &[DVec3], triangles: &[[u32; 3]], counts: impl Fn(usize) -> bool) -> Vec<[DVec3; 2]> {
    sharp_edges(points, triangles, counts).into_iter().map(|edge| edge.map(|v| points[v as usize])).collect()
}

impl Case {
    pub(super) fn is_cut(&self, triangle: [u32; 3]) -> bool {
        let centre = triangle.iter().map(|&v| self.points[v as usize]).sum::<DVec3>() / 3.0;
        centre.distance(self.centre) < self.radius
    }

    /// The mesh without the disc.
    pub(super) fn open(&self) -> Soup {
        let points = self.points.iter().map(DVec3::to_array).collect();
        let mut soup = Soup { points, offsets: vec![0], ..Soup::default() };
        self.triangles.iter().filter(|&&triangle| !self.is_cut(triangle)).for_each(|triangle| soup.face(triangle));
        soup
    }

    pub(super) fn turned(mut self, by: DMat3) -> Case {
        assert!(self.surface.is_none());
        self.points.iter_mut().for_each(|p| *p = by * *p);
        self.centre = by * self.centre;
        self
    }

    /// The true creases inside the hole: the number of vertices at which they branch, turn, and
    /// end.
    pub(super) fn inside(&self) -> [usize; 3] {
        let mut open = vec![false; self.points.len()];
        let kept = self.triangles.iter().filter(|&&triangle| !self.is_cut(triangle));
        kept.flatten().for_each(|&v| open[v as usize] = true);
        let edges = sharp_edges(&self.points, &self.triangles, |t| self.is_cut(self.triangles[t]));
        let mut counts = [0; 3];
        for v in (0..self.points.len() as u32).filter(|&v| !open[v as usize]) {
            let others = edges.iter().filter(|edge| edge.contains(&v)).map(|&[a, b]| a + b - v);
            let ways: Vec<_> = others.map(|w| self.points[w as usize] - self.points[v as usize]).collect();
            match ways[..] {
                [] => {}
                [_] => counts[2] += 1,
                [p, q] => counts[1] += usize::from((-p).angle_between(q) > KINK),
                _ => counts[0] += 1,
            }
        }
        counts
    }

    /// Filled, which must close it without cuts, and how far that is from the truth.
    pub(super) fn filled(&self, options: &Options) -> (Filled, Errors) {
        self.filled_if_disc(options).expect("the disc is no disc")
    }

    /// The same; `None` if the removed part is not a disc.
    pub(super) fn filled_if_disc(&self, options: &Options) -> Option<(Filled, Errors)> {
        let soup = self.open();
        let filled = fill_holes(&soup.view(), LoopSelection::All, options, &Job::default()).unwrap();
        if filled.holes.len() != 1 || euler(faces_of(&filled.mesh)) != 2 {
            return None;
        }
        assert_eq!(filled.holes[0].status, HoleStatus::Filled);
        assert_eq!((filled.quality.loops_left, filled.intersections.as_deref()), (0, Some(&[][..])));
        assert!(edge_counts(faces_of(&filled.mesh)).values().all(|&counts| counts == (1, 1)));
        for (parents, weights) in filled.parents.iter().zip(&filled.weights) {
            assert!(weights.iter().all(|&w| w >= 0.0) && (weights.iter().sum::<f64>() - 1.0).abs() < 1e-12);
            assert!(parents.iter().all(|parent| filled.rims.contains(parent)));
        }
        let errors = self.errors(&filled);
        Some((filled, errors))
    }

    fn errors(&self, filled: &Filled) -> Errors {
        let points: Vec<DVec3> =
            (0..filled.mesh.positions.len() as u32).map(|v| filled.mesh.positions.get(v)).collect();
        let triangles: Vec<[u32; 3]> = faces_of(&filled.mesh).map(|face| face.try_into().unwrap()).collect();
        let new = filled.holes[0].faces.start as usize;
        let rim: Vec<DVec3> = filled.rims.iter().map(|&v| points[v as usize]).collect();
        let far = |p: &DVec3| rim.iter().map(|q| q.distance(*p)).fold(0.0, f64::max);
        let diameter = rim.iter().map(far).fold(0.0, f64::max);
        let corners = |triangle: &[u32; 3], points: &[DVec3]| triangle.map(|v| points[v as usize]);
        let patch: Vec<_> = triangles[new..].iter().map(|triangle| corners(triangle, &points)).collect();
        let gone: Vec<_> = self.triangles.iter().filter(|&&triangle| self.is_cut(triangle)).collect();
        let gone: Vec<_> = gone.into_iter().map(|triangle| corners(triangle, &self.points)).collect();
        let near = self.triangles.iter().map(|triangle| corners(triangle, &self.points));
        let near: Vec<_> = near.filter(|c| c[0].distance(self.centre) < 3.0 * self.radius).collect();
        let on_truth = |points: Vec<DVec3>| match self.surface {
            Some(surface) => points.into_iter().map(surface).collect(),
            None => points.into_iter().map(|p| nearest_on_any(&near, p)).collect::<Vec<_>>(),
        };
        let step = diameter / 40.0;
        let there = samples(&patch, step);
        let off = there.iter().zip(on_truth(there.clone())).map(|(p, q)| p.distance(q)).fold(0.0, f64::max);
        let surface = off.max(farthest(&on_truth(samples(&gone, step)), &patch));

        let truth = sharp(&self.points, &self.triangles, |t| self.is_cut(self.triangles[t]));
        let made = sharp(&points, &triangles, |t| t >= new);
        let distance = |from: &[[DVec3; 2]], to: &[[DVec3; 2]]| {
            let along = |[u, v]: [DVec3; 2]| (0..=8).map(move |k| u.lerp(v, f64::from(k) / 8.0));
            let off =
                |p: DVec3| to.iter().map(|&[u, v]| nearest_on_segment(u, v, p).distance(p)).fold(diameter, f64::min);
            from.iter().copied().flat_map(along).map(off).fold(0.0, f64::max)
        };
        let [missed, invented] = [distance(&truth, &made), distance(&made, &truth)];
        Errors { surface: surface / diameter, missed: missed / diameter, invented: invented / diameter }
    }
}
