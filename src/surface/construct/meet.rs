//! Where two curves of a net are nearest to each other.

use super::strand::{At, Strand, part, point};
use crate::alloc;
use crate::error::{Error, Result};
use glam::DVec3;
use std::cmp::Ordering;
use std::collections::BinaryHeap;

/// Pairs of parts that are looked at for two curves: curves that run together would take them without end.
const PAIRS: usize = 1 << 14;
/// Halvings of a segment.
const DEPTH: u32 = 48;
/// Newton steps from a start.
const STEPS: usize = 16;

type Box = [DVec3; 2];

fn bounds(points: &[DVec3]) -> Box {
    points.iter().fold([DVec3::INFINITY, DVec3::NEG_INFINITY], |[low, high], &p| [low.min(p), high.max(p)])
}

/// How far boxes are apart.
fn gap(a: Box, b: Box) -> f64 {
    (a[0] - b[1]).max(b[0] - a[1]).max(DVec3::ZERO).length()
}

/// Boxes of the segments of a curve, of pairs of them, and so on up to that of all.
pub(super) struct Boxes {
    levels: Vec<Vec<Box>>,
}

impl Boxes {
    pub(super) fn of<const N: usize>(strand: &Strand<N>) -> Result<Self> {
        let mut levels = alloc::with_capacity(32)?;
        let mut level = alloc::collect(strand.segments.iter().map(|points| bounds(points)))?;
        while level.len() > 1 {
            let joined = |pair: &[Box]| bounds(pair.as_flattened());
            let above = alloc::collect(level.chunks(2).map(joined))?;
            levels.push(std::mem::replace(&mut level, above));
        }
        levels.push(level);
        Ok(Boxes { levels })
    }

    fn get(&self, (level, k): (usize, usize)) -> Box {
        self.levels[level][k]
    }

    /// The one or two boxes that a box is of.
    fn children(&self, (level, k): (usize, usize)) -> impl Iterator<Item = (usize, usize)> {
        let count = self.levels[level - 1].len();
        (2 * k..(2 * k + 2).min(count)).map(move |child| (level - 1, child))
    }
}

/// The places where two curves are nearest.
#[derive(Debug, Clone, Copy)]
pub(super) struct Meeting {
    pub(super) places: [At; 2],
    pub(super) distance: f64,
}

/// Parts of two segments, one of each curve.
struct Parts<const N: usize> {
    of: [usize; 2],
    points: [[DVec3; N]; 2],
    from: [f64; 2],
    size: [f64; 2],
    depth: u32,
}

/// What may have something nearer: boxes of segments, or parts.
enum Kind<const N: usize> {
    Boxes([(usize, usize); 2]),
    Parts(std::boxed::Box<Parts<N>>),
}

/// It, with how far its boxes are apart, and when it came.
struct Item<const N: usize> {
    gap: f64,
    number: usize,
    kind: Kind<N>,
}

impl<const N: usize> Ord for Item<N> {
    /// The nearest is the greatest, and of several the first.
    fn cmp(&self, other: &Self) -> Ordering {
        other.gap.total_cmp(&self.gap).then(other.number.cmp(&self.number))
    }
}

impl<const N: usize> PartialOrd for Item<N> {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl<const N: usize> PartialEq for Item<N> {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl<const N: usize> Eq for Item<N> {}

/// Finds where two curves are nearest, or a place where they are farther apart than there by `slack` at most: whatever may be nearest is looked at
/// first.
pub(super) fn nearest<const N: usize>(strands: [&Strand<N>; 2], boxes: [&Boxes; 2], slack: f64) -> Result<Meeting> {
    let start = At { segment: 0, t: 0.0 };
    let mut best = Meeting { places: [start; 2], distance: f64::INFINITY };
    let mut heap = BinaryHeap::new();
    let mut number = 0;
    let mut push = |heap: &mut BinaryHeap<Item<N>>, gap: f64, kind: Kind<N>| -> Result<()> {
        heap.try_reserve(1).map_err(|_| Error::OutOfMemory { bytes: size_of::<Item<N>>() as u64 })?;
        number += 1;
        heap.push(Item { gap, number, kind });
        Ok(())
    };
    push(&mut heap, 0.0, Kind::Boxes(boxes.map(|boxes| (boxes.levels.len() - 1, 0))))?;
    let mut left = PAIRS;
    while let Some(Item { gap: apart, kind, .. }) = heap.pop() {
        if apart >= best.distance - slack {
            break;
        }
        match kind {
            Kind::Boxes([a, b]) if a.0 == 0 && b.0 == 0 => {
                let of = [a.1, b.1];
                let points = [0, 1].map(|k| strands[k].segments[of[k]]);
                let whole = Parts { of, points, from: [0.0; 2], size: [1.0; 2], depth: 0 };
                push(&mut heap, apart, Kind::Parts(std::boxed::Box::new(whole)))?;
            }
            Kind::Boxes([a, b]) if a.0 >= b.0 => {
                for child in boxes[0].children(a) {
                    push(&mut heap, gap(boxes[0].get(child), boxes[1].get(b)), Kind::Boxes([child, b]))?;
                }
            }
            Kind::Boxes([a, b]) => {
                for child in boxes[1].children(b) {
                    push(&mut heap, gap(boxes[0].get(a), boxes[1].get(child)), Kind::Boxes([a, child]))?;
                }
            }
            Kind::Parts(parts) => {
                best.improve(&parts, strands);
                if parts.depth < DEPTH && left > 0 {
                    left -= 1;
                    for half in parts.halves() {
                        let [a, b] = [0, 1].map(|k| bounds(&half.points[k]));
                        push(&mut heap, gap(a, b), Kind::Parts(std::boxed::Box::new(half)))?;
                    }
                }
            }
        }
    }
    Ok(best)
}

impl Meeting {
    /// Looks from the middle of parts.
    fn improve<const N: usize>(&mut self, parts: &Parts<N>, strands: [&Strand<N>; 2]) {
        let whole = [0, 1].map(|k| strands[k].segments[parts.of[k]]);
        let found = descend(&whole, [0, 1].map(|k| parts.from[k] + 0.5 * parts.size[k]));
        if found.1 < self.distance {
            self.distance = found.1;
            self.places = [0, 1].map(|k| At { segment: parts.of[k], t: found.0[k] });
        }
    }
}

impl<const N: usize> Parts<N> {
    /// The halves of the longer one, each with the other.
    fn halves(&self) -> [Parts<N>; 2] {
        let [a, b] = [0, 1].map(|k| bounds(&self.points[k])).map(|[low, high]| low.distance_squared(high));
        let longer = usize::from(b > a);
        [0.0, 0.5].map(|from| {
            let mut half = Parts { depth: self.depth + 1, ..*self };
            half.points[longer] = part(&self.points[longer], [from, from + 0.5]);
            half.from[longer] += from * self.size[longer];
            half.size[longer] *= 0.5;
            half
        })
    }
}

/// Goes from parameters of two segments to where they are nearest thereabouts: Gauss and Newton's steps, within 0 to 1.
fn descend<const N: usize>(segments: &[[DVec3; N]; 2], start: [f64; 2]) -> ([f64; 2], f64) {
    let apart = |at: [f64; 2]| {
        let [[p, pd], [q, qd]] = [0, 1].map(|k| point(&segments[k], at[k]));
        (p - q, pd, qd)
    };
    let mut at = start;
    let mut here = apart(at);
    for _ in 0..STEPS {
        let (from, a, b) = here;
        let slopes = [a.dot(from), -b.dot(from)];
        let held = [0, 1].map(|k| (at[k] <= 0.0 && slopes[k] >= 0.0) || (at[k] >= 1.0 && slopes[k] <= 0.0));
        let [aa, ab, bb] = [a.length_squared(), -a.dot(b), b.length_squared()];
        let determinant = aa * bb - ab * ab;
        let mut step = [slopes[0] / aa, slopes[1] / bb];
        if held == [false, false] && determinant > 1e-12 * aa * bb {
            step = [(bb * slopes[0] - ab * slopes[1]) / determinant, (aa * slopes[1] - ab * slopes[0]) / determinant];
        }
        let mut length = 1.0;
        let next = loop {
            let moved = |k: usize| if held[k] || !step[k].is_finite() { at[k] } else { at[k] - length * step[k] };
            let there = [0, 1].map(|k| moved(k).clamp(0.0, 1.0));
            let reached = apart(there);
            if reached.0.length_squared() < from.length_squared() {
                break Some((there, reached));
            }
            length *= 0.25;
            if length < 1e-3 {
                break None;
            }
        };
        let Some((there, reached)) = next else { break };
        (at, here) = (there, reached);
    }
    (at, here.0.length())
}
