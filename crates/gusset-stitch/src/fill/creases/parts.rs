//! The parts of a hole that curves cut out of it.

use super::super::patch_rim::{OldFaces, Rim};
use super::bridges::Bridge;
use super::ends::{Corners, End, Touch};
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::sort::sort_distinct;
use gusset_mesh::NONE;

/// Of a vertex on no curve.
const NO_CURVE: [u32; 2] = [NONE; 2];

/// A part of a hole.
pub(in super::super) struct Part {
    /// Its rim, along the hole's and along curves, in the unit of the hole's; old triangles count
    /// only on this side of the creases.
    pub(in super::super) rim: Rim,
    /// Of each vertex of its rim, the number in the hole's, or after those that of a curve's vertex.
    pub(in super::super) names: Vec<u32>,
    /// The curves that each is on.
    curves: Vec<[u32; 2]>,
    /// How many vertices the hole's rim has.
    count: usize,
}

impl Part {
    /// True of two vertices of its rim that must not get an edge: `taken` ones of the hole's rim, and
    /// those of one curve, as the part beyond it has them, too.
    pub(in super::super) fn is_taken(&self, u: u32, v: u32, taken: &dyn Fn(u32, u32) -> bool) -> bool {
        let [of_u, of_v] = [u, v].map(|v| self.curves[v as usize]);
        let on_one = of_u.iter().any(|curve| *curve != NONE && of_v.contains(curve));
        let [u, v] = [u, v].map(|v| self.names[v as usize]);
        on_one || (u.max(v) as usize) < self.count && taken(u, v)
    }
}

/// What the rims of parts run along.
pub(super) struct Outlines<'a> {
    pub(super) rim: &'a Rim,
    pub(super) corners: &'a Corners,
    pub(super) ends: &'a [End],
    pub(super) touches: &'a [Touch],
    /// Of each end, if there is one.
    pub(super) bridges: &'a [Option<Bridge>],
}

impl Outlines<'_> {
    /// The parts between bridges, or one of the whole rim if that touches creases only; `None` if there
    /// are none, or if one has no vertex but those of creases. `points`: of the curves. O(n) a part
    /// for n old vertices.
    pub(super) fn parts(&self, points: &[DVec3]) -> Result<Option<Vec<Part>>> {
        let count = self.rim.count;
        // Of each vertex of the rim the end whose tip it is, or that follows the rim there.
        let mut end_at = alloc::filled(None, count)?;
        for (k, end) in self.ends.iter().enumerate().filter(|&(k, _)| self.bridges[k].is_some()) {
            end.vertices(count).for_each(|v| end_at[v] = Some(k));
        }
        let at = |v: usize| end_at[v].and_then(|k: usize| Some((&self.ends[k], self.bridges[k].as_ref()?)));
        let mut touch_at = alloc::filled(None, count)?;
        for (k, touch) in self.touches.iter().enumerate() {
            touch.vertices(count).for_each(|v| touch_at[v] = Some(k));
        }
        let mut parts = Vec::new();
        if self.bridges.iter().all(Option::is_none) && !self.touches.is_empty() {
            let mut outline = Outline::new(self);
            (0..count).try_for_each(|v| outline.follow(v, touch_at[v]))?;
            alloc::push(&mut parts, outline)?;
        }
        let mut done = alloc::filled(false, self.ends.len())?;
        for first in 0..self.ends.len() {
            let mut outline = Outline::new(self);
            let mut start = first;
            while let (false, Some(leaving)) = (done[start], &self.bridges[start]) {
                done[start] = true;
                outline.leave(&self.ends[start], leaving.curve)?;
                let mut v = (self.ends[start].tip + 1) % count;
                let (end, bridge) = loop {
                    match at(v) {
                        Some((end, bridge)) if v == end.tip => break (end, bridge),
                        Some((end, bridge)) => outline.follow_crease(v, end, bridge.curve)?,
                        None => outline.follow(v, touch_at[v])?,
                    }
                    v = (v + 1) % count;
                };
                outline.arrive(end, bridge.curve)?;
                outline.cross(&bridge.inner)?;
                start = bridge.to;
            }
            if !outline.names.is_empty() {
                alloc::push(&mut parts, outline)?;
            }
        }
        if parts.is_empty() || !parts.iter().all(|outline| outline.curves.contains(&NO_CURVE)) {
            return Ok(None);
        }
        alloc::try_collect(parts.into_iter().map(|outline| outline.part(points))).map(Some)
    }
}

/// The rim of a part under construction.
struct Outline<'a> {
    rim: &'a Rim,
    corners: &'a Corners,
    touches: &'a [Touch],
    names: Vec<u32>,
    curves: Vec<[u32; 2]>,
    /// The old triangles on this side of the creases.
    around: Vec<u32>,
}

impl<'a> Outline<'a> {
    fn new(&Outlines { rim, corners, touches, .. }: &Outlines<'a>) -> Self {
        Outline { rim, corners, touches, names: Vec::new(), curves: Vec::new(), around: Vec::new() }
    }

    fn push(&mut self, name: usize, curves: [u32; 2]) -> Result<()> {
        alloc::push(&mut self.names, name as u32)?;
        alloc::push(&mut self.curves, curves)
    }

    fn all_at(&mut self, v: usize) -> Result<()> {
        alloc::extend(&mut self.around, self.corners.get(v).iter().map(|&(t, _, _)| t))
    }

    /// A vertex of the hole's rim, and the touch that it is of.
    fn follow(&mut self, v: usize, touch: Option<usize>) -> Result<()> {
        let Some(k) = touch else {
            self.push(v, NO_CURVE)?;
            return self.all_at(v);
        };
        // Curves are numbered from 0 on.
        self.push(v, [NONE - 1 - k as u32, NONE])?;
        let touch = &self.touches[k];
        if v == touch.first {
            alloc::append(&mut self.around, &touch.sides[0])?;
        }
        if v == (touch.first + touch.edges) % self.rim.count {
            alloc::append(&mut self.around, &touch.sides[1])?;
        }
        Ok(())
    }

    /// A vertex of the hole's rim where that follows a crease.
    fn follow_crease(&mut self, v: usize, end: &End, curve: u32) -> Result<()> {
        self.push(v, [curve, NONE])?;
        let side = usize::from(end.along < 0);
        if v == end.base { alloc::append(&mut self.around, &end.sides[side]) } else { Ok(()) }
    }

    /// The tip of an end from which the part goes on along the rim.
    fn leave(&mut self, end: &End, curve: u32) -> Result<()> {
        self.push(end.tip, [curve, NONE])?;
        if end.along > 0 { self.all_at(end.tip) } else { alloc::append(&mut self.around, &end.sides[1]) }
    }

    /// The tip of an end where the part leaves the rim.
    fn arrive(&mut self, end: &End, curve: u32) -> Result<()> {
        self.push(end.tip, [curve, NONE])?;
        if end.along < 0 { self.all_at(end.tip) } else { alloc::append(&mut self.around, &end.sides[0]) }
    }

    /// The vertices of a bridge.
    fn cross(&mut self, inner: &[(u32, [u32; 2])]) -> Result<()> {
        inner.iter().try_for_each(|&(name, curves)| self.push(name as usize, curves))
    }

    /// The part within. O(n) for n old vertices.
    fn part(mut self, points: &[DVec3]) -> Result<Part> {
        let (rim, count, n) = (self.rim, self.rim.count, self.names.len());
        let mut numbers = alloc::filled(NONE, rim.points.len())?;
        let mut own = alloc::with_capacity(n + rim.points.len())?;
        for (k, &name) in self.names.iter().enumerate() {
            let name = name as usize;
            own.push(if name < count { rim.points[name] } else { points[name - count] });
            if name < count {
                numbers[name] = k as u32;
            }
        }
        let is_own = |v: u32| (v as usize) < count && numbers[v as usize] != NONE;
        let mut sides = alloc::gather(rim.sides.iter().copied().filter(|&(u, v)| is_own(u) || is_own(v)))?;
        let mut number = |v: u32| {
            let number = &mut numbers[v as usize];
            if *number == NONE {
                *number = own.len() as u32;
                own.push(rim.points[v as usize]);
            }
            *number
        };
        sort_distinct(&mut self.around);
        let around = alloc::collect(self.around.iter().map(|&t| rim.around[t as usize].map(&mut number)))?;
        sides.iter_mut().for_each(|(u, v)| (*u, *v) = (number(*u), number(*v)));
        let mut is_near = alloc::filled(false, rim.points.len())?;
        self.around.iter().for_each(|&t| rim.around[t as usize].iter().for_each(|&v| is_near[v as usize] = true));
        let next_to = rim.beyond.iter().filter(|triangle| triangle.iter().any(|&v| is_near[v as usize]));
        let beyond = alloc::gather(next_to.map(|triangle| triangle.map(&mut number)))?;
        let mut across = alloc::with_capacity(n)?;
        for (k, &name) in self.names.iter().enumerate() {
            let next = (k + 1) % n;
            let is_crease = self.curves[k].iter().any(|curve| *curve != NONE && self.curves[next].contains(curve));
            across.push(if is_crease { DVec3::ZERO } else { rim.across[name as usize] });
            if is_crease {
                alloc::push(&mut sides, (k as u32, next as u32))?;
            }
        }
        let is_whole = |(&name, &curves): (&u32, &[u32; 2])| curves == NO_CURVE && rim.whole[name as usize];
        let whole = alloc::collect(self.names.iter().zip(&self.curves).map(is_whole))?;
        let part = rim.part(own, OldFaces { around, beyond, sides }, across, whole)?;
        Ok(Part { rim: part, names: self.names, curves: self.curves, count })
    }
}
