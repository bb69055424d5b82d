//! Where two plane curves meet, and where one meets itself.

use super::super::curve::{CurveView, Place};
use super::frame::Frame;
use super::pair::{COMMON, Found, Joined, SAME, SLACK, advances, meet};
use super::split::split_segment;
use crate::alloc;
use crate::error::Result;
use crate::geom::{Aabb, box_tree::BoxTree};
use crate::job::Job;
use glam::DVec3;

/// A common point of two curves, or of two places of one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Meeting {
    /// On the first curve; of one curve, the earlier place.
    pub a: Place,
    /// On the second curve; of one curve, the later place.
    pub b: Place,
}

/// A part that two segments have in common.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Overlap {
    /// From where to where on the first segment, in its direction.
    pub a: [Place; 2],
    /// The same ends on the second segment.
    pub b: [Place; 2],
}

/// What two curves have in common.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Meetings {
    /// Crossings and touches, by their places on the first curve; none within an overlap.
    pub points: Vec<Meeting>,
    /// Parts in common, one for each pair of segments.
    pub overlaps: Vec<Overlap>,
    /// True if some pair of segments was given up: they run beside each other within rounding for a long way without being
    /// the same curve. Some of their common points may be missing.
    pub undecided: bool,
}

/// A part of a curve without points in common with itself.
struct Piece {
    controls: Vec<DVec3>,
    segment: u32,
    from: f64,
    to: f64,
}

impl Piece {
    fn controls(&self) -> &[DVec3] {
        &self.controls
    }

    fn place(&self, t: f64) -> Place {
        let t = if t == 1.0 { self.to } else { self.from + (self.to - self.from) * t };
        Place { segment: self.segment, t }
    }
}

/// How often a segment is halved to have no points in common with itself.
const DEEPEST: u32 = 20;

impl CurveView<'_> {
    /// The common points of two plane curves: crossings to rounding, touches to about 1e-7 in the parameters. Curves touch
    /// where they come within 1e-12 of their size; meetings that differ by less than 1e-6 in both parameters count as one.
    /// Parts in common are reported as such. Bounded work for each pair of segments whose boxes meet; about O(log(1 /
    /// distance)) halvings for each meeting.
    ///
    /// # Errors [`CurveNotPlane`](crate::Error::CurveNotPlane), [`OutOfMemory`](crate::Error::OutOfMemory),
    /// [`Cancelled`](crate::Error::Cancelled).
    pub fn intersections(&self, other: &CurveView<'_>, job: &Job<'_>) -> Result<Meetings> {
        self.check_plane()?;
        other.check_plane()?;
        let frame = Frame::of(self.points().iter().chain(other.points()));
        let (ours, theirs) = (self.pieces(&frame, 0)?, other.pieces(&frame, 0)?);
        let tree = BoxTree::new(theirs.iter().map(|piece| Aabb::of(piece.controls())))?;
        let mut meetings = Meetings::default();
        let mut found = Found::default();
        for (k, piece) in ours.iter().enumerate() {
            if k % 64 == 0 {
                job.step(k as f64 / ours.len() as f64, "intersections")?;
            }
            tree.overlapping(&Aabb::of(piece.controls()), SLACK, |i| {
                meetings.add(piece, &theirs[i], Joined::default(), &mut found)
            })?;
        }
        meetings.settle(rounds(self), rounds(other));
        Ok(meetings)
    }

    /// The points that a plane curve passes more than once: crossings, touches, parts run through twice, loops within a
    /// segment. The joint of neighbours is none, nor is the closing of a closed curve, nor a cusp. Loops that take less than
    /// 1e-5 of a segment's parameter are not seen. Otherwise as [`intersections`](Self::intersections).
    ///
    /// # Errors
    /// As for [`intersections`](Self::intersections).
    pub fn self_intersections(&self, job: &Job<'_>) -> Result<Meetings> {
        self.check_plane()?;
        let frame = Frame::of(self.points());
        let pieces = self.pieces(&frame, DEEPEST)?;
        let last = pieces.len().saturating_sub(1);
        let tree = BoxTree::new(pieces.iter().map(|piece| Aabb::of(piece.controls())))?;
        let mut meetings = Meetings::default();
        let mut found = Found::default();
        for (k, piece) in pieces.iter().enumerate() {
            if k % 64 == 0 {
                job.step(k as f64 / pieces.len() as f64, "self-intersections")?;
            }
            tree.overlapping(&Aabb::of(piece.controls()), SLACK, |i| {
                if i <= k {
                    return Ok(());
                }
                let joined = Joined { after: i == k + 1, before: self.is_closed() && k == 0 && i == last };
                meetings.add(piece, &pieces[i], joined, &mut found)
            })?;
        }
        let round = rounds(self);
        for m in &mut meetings.points {
            // The end of a closed curve is its start.
            if round > 0.0 && along(m.b) >= round - SAME {
                *m = Meeting { a: Place { segment: 0, t: 0.0 }, b: m.a };
            }
        }
        meetings.points.retain(|m| {
            let gap = (along(m.b) - along(m.a)).abs();
            gap.min(if round > 0.0 { (round - gap).abs() } else { f64::INFINITY }) > 10.0 * SAME
        });
        meetings.settle(round, round);
        Ok(meetings)
    }

    /// The segments in a frame, those that may meet themselves halved until they do not, at most `depth` times. Segments that
    /// are points are left out where `depth` asks for self-intersections.
    fn pieces(&self, frame: &Frame, depth: u32) -> Result<Vec<Piece>> {
        let mut pieces = alloc::with_capacity(self.len())?;
        for (k, controls) in self.segments().enumerate() {
            if depth > 0 && controls.iter().all(|&p| p == controls[0]) {
                continue;
            }
            let local = alloc::collect(controls.iter().map(|&p| frame.point(p)))?;
            let piece = Piece { controls: local, segment: k as u32, from: 0.0, to: 1.0 };
            simple(piece, depth, &mut pieces)?;
        }
        Ok(pieces)
    }
}

/// Appends a piece, or its halves; what is smaller than rounding can tell is one piece.
fn simple(mut piece: Piece, depth: u32, pieces: &mut Vec<Piece>) -> Result<()> {
    if depth == 0 || advances(piece.controls()) || Aabb::of(piece.controls()).size().max_element() <= COMMON {
        return alloc::push(pieces, piece);
    }
    let mut before = alloc::filled(DVec3::ZERO, piece.controls.len())?;
    split_segment(&mut piece.controls, 0.5, &mut before);
    let middle = 0.5 * (piece.from + piece.to);
    simple(Piece { controls: before, to: middle, ..piece }, depth - 1, pieces)?;
    simple(Piece { from: middle, ..piece }, depth - 1, pieces)
}

/// The place as one number.
fn along(place: Place) -> f64 {
    f64::from(place.segment) + place.t
}

/// After how many segments a closed curve comes round; 0 for an open one.
fn rounds(curve: &CurveView<'_>) -> f64 {
    if curve.is_closed() { curve.len() as f64 } else { 0.0 }
}

impl Meetings {
    fn add(&mut self, p: &Piece, q: &Piece, joined: Joined, found: &mut Found) -> Result<()> {
        meet(p.controls(), q.controls(), joined, found)?;
        for &[s, t] in &found.at {
            alloc::push(&mut self.points, Meeting { a: p.place(s), b: q.place(t) })?;
        }
        for &[s, t] in &found.overlaps {
            alloc::push(&mut self.overlaps, Overlap { a: s.map(|s| p.place(s)), b: t.map(|t| q.place(t)) })?;
        }
        self.undecided |= found.undecided;
        Ok(())
    }

    /// Sorts, and takes away what joints have reported twice, and the ends of overlaps.
    fn settle(&mut self, round_a: f64, round_b: f64) {
        let same = |x: Place, y: Place, round: f64| {
            let gap = (along(x) - along(y)).abs();
            gap <= SAME || (round > 0.0 && (round - gap).abs() <= SAME)
        };
        self.points.sort_by(|x, y| along(x.a).total_cmp(&along(y.a)).then(along(x.b).total_cmp(&along(y.b))));
        self.overlaps
            .sort_by(|x, y| along(x.a[0]).total_cmp(&along(y.a[0])).then(along(x.b[0]).total_cmp(&along(y.b[0]))));
        let overlaps = &self.overlaps;
        let mut kept: usize = 0;
        for i in 0..self.points.len() {
            let m = self.points[i];
            let repeated = |old: &Meeting| same(old.a, m.a, round_a) && same(old.b, m.b, round_b);
            // Sorted by a: what is the same is near, or at the start of a closed curve.
            let near = self.points[..kept].iter().rev().take_while(|old| along(m.a) - along(old.a) <= SAME);
            let first = self.points[..kept].iter().take_while(|old| round_a > 0.0 && along(old.a) <= SAME);
            let at_end = |o: &Overlap| (0..2).any(|i| same(o.a[i], m.a, round_a) && same(o.b[i], m.b, round_b));
            if !near.chain(first).any(repeated) && !overlaps.iter().any(at_end) {
                self.points[kept] = m;
                kept += 1;
            }
        }
        self.points.truncate(kept);
    }
}
