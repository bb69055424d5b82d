//! Where two curves of a net are nearest to each other.

use super::strand::{At, Strand, part, point};
use crate::alloc;
use crate::error::Result;
use glam::DVec3;

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

/// Finds where two curves are nearest, or one place where they are no farther apart than `noise`.
pub(super) fn nearest<const N: usize>(strands: [&Strand<N>; 2], boxes: [&Boxes; 2], noise: f64) -> Result<Meeting> {
    let start = At { segment: 0, t: 0.0 };
    let mut best = Meeting { places: [start; 2], distance: f64::INFINITY };
    let top = boxes.map(|boxes| (boxes.levels.len() - 1, 0));
    let mut stack = Vec::new();
    alloc::push(&mut stack, (0.0, top))?;
    let mut left = PAIRS;
    while let Some((distance, [a, b])) = stack.pop() {
        if distance >= best.distance || best.distance <= noise {
            continue;
        }
        if a.0 == 0 && b.0 == 0 {
            Segments { strands, of: [a.1, b.1], noise }.search(&mut best, &mut left)?;
            continue;
        }
        // The larger one is opened; the nearer child is taken first, being last.
        let from = stack.len();
        if a.0 >= b.0 {
            for child in boxes[0].children(a) {
                alloc::push(&mut stack, (gap(boxes[0].get(child), boxes[1].get(b)), [child, b]))?;
            }
        } else {
            for child in boxes[1].children(b) {
                alloc::push(&mut stack, (gap(boxes[0].get(a), boxes[1].get(child)), [a, child]))?;
            }
        }
        if stack.len() == from + 2 && stack[from].0 < stack[from + 1].0 {
            stack.swap(from, from + 1);
        }
    }
    Ok(best)
}

/// Two segments, one of each curve.
struct Segments<'a, const N: usize> {
    strands: [&'a Strand<N>; 2],
    of: [usize; 2],
    noise: f64,
}

/// Parts of both.
struct Parts<const N: usize> {
    points: [[DVec3; N]; 2],
    from: [f64; 2],
    size: [f64; 2],
    depth: u32,
}

impl<const N: usize> Segments<'_, N> {
    fn search(&self, best: &mut Meeting, left: &mut usize) -> Result<()> {
        let points = [0, 1].map(|k| self.strands[k].segments[self.of[k]]);
        let mut stack = Vec::new();
        alloc::push(&mut stack, Parts { points, from: [0.0; 2], size: [1.0; 2], depth: 0 })?;
        while let Some(parts) = stack.pop() {
            let [a, b] = [0, 1].map(|k| bounds(&parts.points[k]));
            if gap(a, b) >= best.distance || best.distance <= self.noise {
                continue;
            }
            let found = descend(&points, [0, 1].map(|k| parts.from[k] + 0.5 * parts.size[k]));
            if found.1 < best.distance {
                best.distance = found.1;
                best.places = [0, 1].map(|k| At { segment: self.of[k], t: found.0[k] });
            }
            if parts.depth == DEPTH || *left == 0 {
                continue;
            }
            *left -= 1;
            let longer = usize::from(b[0].distance_squared(b[1]) > a[0].distance_squared(a[1]));
            for from in [0.5, 0.0] {
                let mut half = Parts { depth: parts.depth + 1, ..parts };
                half.points[longer] = part(&parts.points[longer], [from, from + 0.5]);
                half.from[longer] += from * parts.size[longer];
                half.size[longer] *= 0.5;
                alloc::push(&mut stack, half)?;
            }
        }
        Ok(())
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
