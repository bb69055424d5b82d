//! Where two curves in space come near to each other: the places where their distance is least, if it is small enough.
//!
//! Pairs of parts are halved until a proof holds:
//!
//! * *apart*: their hulls are farther from each other than asked for, along an axis or across both chords;
//! * *none*: one of the slopes of f = |A(s) - B(t)|^2 / 2 has one sign all over the pair, and leads into the next part;
//! * *one at most*: the Hessian of f is positive definite for all s and t of the pair, or f falls towards the end of a segment and is
//!   convex along that end: then Newton's method finds the only least distance there is. All by bounds over the control points.
//!
//! Parts that run beside each other have no such proof: what is left of them at the least size is one part in common, if it is near
//! enough.

use super::super::curve::{CurveView, MAX_DEGREE, Place};
use super::super::segment;
use super::evaluate::derive;
use super::frame::Frame;
use super::split::{Controls, split_segment};
use crate::alloc;
use crate::error::{Error, Result};
use crate::geom::{Aabb, box_tree::BoxTree};
use crate::job::Job;
use glam::{DVec2, DVec3};

/// Two places of two curves, between which their distance is least.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Approach {
    /// On the first curve.
    pub a: Place,
    /// On the second.
    pub b: Place,
    /// How far the points there are apart.
    pub distance: f64,
}

/// Parts of two curves that stay near to each other.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Beside {
    /// From where to where on the first curve.
    pub a: [Place; 2],
    /// On the second: between which places the near points are.
    pub b: [Place; 2],
}

/// Where two curves come near to each other.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Approaches {
    /// By their places on the first curve.
    pub places: Vec<Approach>,
    /// Parts that stay near, or touch so closely that no place can be told from the next; the nearest places of each are among the
    /// places.
    pub overlaps: Vec<Beside>,
    /// True if parts were given up that may be near enough and are not among the overlaps.
    pub undecided: bool,
}

/// Distances below this, in a frame of size 1, are rounding.
const NOISE: f64 = 1e-12;
/// Parts are not halved beyond this.
const SHORT: f64 = 1.0 / 1024.0;
/// Pairs of parts that are looked at for two segments.
const PATIENCE: usize = 20_000;
/// Places whose parameters differ by less are one.
const SAME: f64 = 1e-7;

/// A part of a segment.
#[derive(Clone, Copy)]
struct Part {
    controls: Controls,
    len: usize,
    from: f64,
    to: f64,
}

/// What was found, as numbers: segment and parameter added.
#[derive(Clone, Copy)]
struct Find {
    at: DVec2,
    distance: f64,
}

impl CurveView<'_> {
    /// Where two curves in space come as near to each other as `within`: each place where their distance is least, once; of curves
    /// that stay near, the parts where they do. `within` below 1e-12 of the curves' size is taken as that. Bounded work for each
    /// pair of segments whose boxes are near.
    ///
    /// # Errors [`Error::EmptyCurve`], [`Error::OptionOutOfRange`] (`within` is negative or not finite), [`Error::OutOfMemory`],
    /// [`Error::Cancelled`].
    pub fn approaches(&self, other: &CurveView<'_>, within: f64, job: &Job<'_>) -> Result<Approaches> {
        if self.is_empty() || other.is_empty() {
            return Err(Error::EmptyCurve);
        }
        if !(within >= 0.0 && within.is_finite()) {
            return Err(Error::OptionOutOfRange { option: "within", value: within });
        }
        let frame = Frame::of(self.points().iter().chain(other.points()));
        let mut search = Search { within: frame.length(within).max(NOISE), ..Search::default() };
        let sides = [Side::new(self, &frame)?, Side::new(other, &frame)?];
        let tree = BoxTree::new(sides[1].parts.iter().map(|part| Aabb::of(part.controls())))?;
        for (i, a) in sides[0].parts.iter().enumerate() {
            if i % 16 == 0 {
                job.step(i as f64 / sides[0].parts.len() as f64, "approaches of curves")?;
            }
            tree.overlapping(&Aabb::of(a.controls()), search.within, |j| search.run(&sides, [i, j]))?;
        }
        search.finish([self, other], &frame)
    }
}

/// The segments of a curve in the frame.
struct Side {
    parts: Vec<Part>,
    closed: bool,
}

impl Side {
    fn new(curve: &CurveView<'_>, frame: &Frame) -> Result<Side> {
        let parts = alloc::collect(curve.segments().map(|points| in_frame(points, frame)))?;
        Ok(Side { parts, closed: curve.is_closed() })
    }

    /// The direction in which the curve leaves segment k at one of its ends; `None` if it ends there.
    fn beyond(&self, k: usize, at_end: bool) -> Option<DVec3> {
        let (count, last) = (self.parts.len(), if at_end { self.parts.len() - 1 } else { 0 });
        if k == last && !self.closed {
            return None;
        }
        let next = &self.parts[if at_end { (k + 1) % count } else { (k + count - 1) % count }];
        let controls = next.controls();
        Some(if at_end { segment::first_leg(controls) } else { -segment::last_leg(controls) })
    }
}

/// The search, in the frame.
#[derive(Default)]
struct Search {
    within: f64,
    finds: Vec<Find>,
    /// Pairs left open: the middles and half sizes of their parameters, and their middles' distance.
    open: Vec<(DVec2, DVec2, f64)>,
    undecided: bool,
}

impl Search {
    /// Looks at two segments, by their numbers.
    fn run(&mut self, sides: &[Side; 2], numbers: [usize; 2]) -> Result<()> {
        let [a, b] = [0, 1].map(|k| &sides[k].parts[numbers[k]]);
        let base = DVec2::new(numbers[0] as f64, numbers[1] as f64);
        let mut waiting = Vec::new();
        alloc::push(&mut waiting, [*a, *b])?;
        let mut looked = 0;
        while let Some([p, q]) = waiting.pop() {
            looked += 1;
            if apart(&p, &q, self.within) {
                continue;
            }
            match judge(&p, &q) {
                Verdict::None => continue,
                Verdict::One => {
                    self.add_least(sides, numbers, [&p, &q])?;
                    continue;
                }
                Verdict::Open => {}
            }
            let sizes = [&p, &q].map(|part| Aabb::of(part.controls()).size().max_element());
            let short = [&p, &q].map(|part| part.to - part.from <= SHORT);
            if looked > PATIENCE || (short[0] && short[1]) {
                let middle = DVec2::new(p.from + p.to, q.from + q.to) * 0.5;
                let half = DVec2::new(p.to - p.from, q.to - q.from) * 0.5;
                let [x, y] = [point(a, middle.x), point(b, middle.y)];
                self.undecided |= looked > PATIENCE;
                alloc::push(&mut self.open, (base + middle, half, x.distance(y)))?;
            } else {
                alloc::reserve(&mut waiting, 2)?;
                if short[1] || (!short[0] && sizes[0] >= sizes[1]) {
                    waiting.extend(p.halves().map(|half| [half, q]));
                } else {
                    waiting.extend(q.halves().map(|half| [p, half]));
                }
            }
        }
        Ok(())
    }

    /// Adds the least distance of a pair that has only one, if it is one of the curves too and near enough.
    fn add_least(&mut self, sides: &[Side; 2], numbers: [usize; 2], pair: [&Part; 2]) -> Result<()> {
        let whole = [0, 1].map(|k| &sides[k].parts[numbers[k]]);
        let low = DVec2::new(pair[0].from, pair[1].from);
        let high = DVec2::new(pair[0].to, pair[1].to);
        let (at, gradient) = descend(whole, 0.5 * (low + high), low, high);
        let gap = point(whole[0], at.x) - point(whole[1], at.y);
        for k in 0..2 {
            let (at_low, at_high) = (at[k] <= low[k], at[k] >= high[k]);
            let falls = if at_low { gradient[k] } else { -gradient[k] };
            if gap.length() <= NOISE || !(at_low || at_high) || falls <= 1e-12 * whole[k].size() * gap.length() {
                continue;
            }
            // At an inner end of a part the next part has it; at a joint the next segment, if it goes down there.
            let at_joint = at[k] == 0.0 || at[k] == 1.0;
            let sign = if k == 0 { 1.0 } else { -1.0 };
            let goes_on = |along: DVec3| sign * gap.dot(along) < 0.0;
            if !at_joint || sides[k].beyond(numbers[k], at_high).is_some_and(goes_on) {
                return Ok(());
            }
        }
        if gap.length() <= self.within {
            let at = DVec2::new(numbers[0] as f64, numbers[1] as f64) + at;
            alloc::push(&mut self.finds, Find { at, distance: gap.length() })?;
        }
        Ok(())
    }

    /// Sorts, makes one of what was found twice, and what the open pairs are.
    fn finish(mut self, curves: [&CurveView<'_>; 2], frame: &Frame) -> Result<Approaches> {
        let mut found = Approaches { undecided: self.undecided, ..Approaches::default() };
        let place = |k: usize, at: f64| {
            let segment = (at.max(0.0) as usize).min(curves[k].len() - 1);
            Place { segment: segment as u32, t: (at - segment as f64).clamp(0.0, 1.0) }
        };
        self.open.sort_by(|x, y| x.0.x.total_cmp(&y.0.x).then(x.0.y.total_cmp(&y.0.y)));
        for spot in spots(&self.open)? {
            let members = || spot.iter().map(|&k| self.open[k]);
            let low = members().map(|(middle, half, _)| middle - half).fold(DVec2::INFINITY, DVec2::min);
            let high = members().map(|(middle, half, _)| middle + half).fold(DVec2::NEG_INFINITY, DVec2::max);
            let best = members().fold(self.open[spot[0]], |best, x| if x.2 < best.2 { x } else { best });
            let local = |k: usize| (place(k, best.0[k]).segment as usize, place(k, best.0[k]).t);
            let whole = [0, 1].map(|k| in_frame(curves[k].segment(local(k).0), frame));
            let start = DVec2::new(local(0).1, local(1).1);
            let reach = 2.0 * best.1;
            let (at, _) = descend(
                [&whole[0], &whole[1]],
                start,
                (start - reach).max(DVec2::ZERO),
                (start + reach).min(DVec2::ONE),
            );
            let distance = point(&whole[0], at.x).distance(point(&whole[1], at.y));
            if distance <= self.within {
                let at = DVec2::new(local(0).0 as f64, local(1).0 as f64) + at;
                alloc::push(&mut self.finds, Find { at, distance })?;
                let ends = |k: usize| [place(k, low[k]), place(k, high[k])];
                alloc::push(&mut found.overlaps, Beside { a: ends(0), b: ends(1) })?;
            } else if best.2 <= self.within {
                found.undecided = true;
            }
        }
        self.finds.sort_by(|x, y| x.at.x.total_cmp(&y.at.x).then(x.at.y.total_cmp(&y.at.y)));
        let rounds = curves.map(|curve| if curve.is_closed() { curve.len() as f64 } else { f64::INFINITY });
        let same = |x: &Find, y: &Find| {
            (0..2).all(|k| {
                let gap = (x.at[k] - y.at[k]).abs();
                gap <= SAME || (rounds[k] - gap).abs() <= SAME
            })
        };
        let mut kept: Vec<Find> = alloc::with_capacity(self.finds.len())?;
        for find in self.finds {
            let near = kept.iter().rev().take_while(|other| find.at.x - other.at.x <= SAME);
            let first = kept.iter().take_while(|other| other.at.x <= SAME);
            if !near.chain(first).any(|other| same(other, &find)) {
                kept.push(find);
            }
        }
        found.places = alloc::collect(kept.iter().map(|find| {
            let (a, b) = (place(0, find.at.x), place(1, find.at.y));
            Approach { a, b, distance: frame.length_back(find.distance) }
        }))?;
        Ok(found)
    }
}

/// Open pairs that touch, as lists of their numbers; they are sorted by the first parameter.
fn spots(open: &[(DVec2, DVec2, f64)]) -> Result<Vec<Vec<usize>>> {
    let mut spots: Vec<(f64, Vec<usize>)> = Vec::new();
    for (k, &(middle, half, _)) in open.iter().enumerate() {
        let touches = |&other: &usize| {
            let (there, reach, _) = open[other];
            ((middle - there).abs() - 1.000_001 * (half + reach)).max_element() <= 0.0
        };
        let mut home: Option<usize> = None;
        let mut i = 0;
        while i < spots.len() {
            // Only those that reach so far along the first curve.
            let meets = spots[i].0 >= middle.x - half.x - 1e-9 && spots[i].1.iter().rev().any(touches);
            match home {
                Some(at) if meets => {
                    let (end, members) = spots.swap_remove(i);
                    spots[at].0 = spots[at].0.max(end);
                    alloc::append(&mut spots[at].1, &members)?;
                    continue;
                }
                None if meets => home = Some(i),
                _ => {}
            }
            i += 1;
        }
        let end = middle.x + half.x;
        match home {
            Some(at) => {
                spots[at].0 = spots[at].0.max(end);
                alloc::push(&mut spots[at].1, k)?;
            }
            None => alloc::push(&mut spots, (end, vec![k]))?,
        }
    }
    spots.sort_by_key(|spot| spot.1.iter().copied().min());
    Ok(spots.into_iter().map(|spot| spot.1).collect())
}

fn in_frame(points: &[DVec3], frame: &Frame) -> Part {
    let mut controls = [DVec3::ZERO; MAX_DEGREE + 1];
    controls.iter_mut().zip(points).for_each(|(to, &point)| *to = frame.point(point));
    Part { controls, len: points.len(), from: 0.0, to: 1.0 }
}

impl Part {
    fn controls(&self) -> &[DVec3] {
        &self.controls[..self.len]
    }

    fn size(&self) -> f64 {
        Aabb::of(self.controls()).size().max_element()
    }

    fn halves(mut self) -> [Part; 2] {
        let middle = 0.5 * (self.from + self.to);
        let mut before = Part { to: middle, ..self };
        split_segment(&mut self.controls[..self.len], 0.5, &mut before.controls[..self.len]);
        [before, Part { from: middle, ..self }]
    }

    /// n (n - 1) (B_i+2 - 2 B_i+1 + B_i) or n (B_i+1 - B_i): the mean, and how far the others are from it.
    fn derivative(&self, order: usize) -> (DVec3, f64) {
        let mut buffer = self.controls;
        let mut left = self.len;
        for _ in 0..order {
            left = derive(&mut buffer[..left]);
        }
        if left == 0 {
            return (DVec3::ZERO, 0.0);
        }
        let mean = buffer[..left].iter().sum::<DVec3>() / left as f64;
        (mean, buffer[..left].iter().map(|v| v.distance(mean)).fold(0.0, f64::max))
    }
}

fn point(part: &Part, t: f64) -> DVec3 {
    segment::point(part.controls(), t)
}

/// True if the hulls are farther apart than `within`.
fn apart(p: &Part, q: &Part, within: f64) -> bool {
    let (a, b) = (p.controls(), q.controls());
    if !Aabb::of(a).is_within(&Aabb::of(b), within) {
        return true;
    }
    let chord = |c: &[DVec3]| (c[c.len() - 1] - c[0]).normalize_or_zero();
    let (u, v) = (chord(a), chord(b));
    let normal = u.cross(v).normalize_or_zero();
    let between = a[0] - b[0];
    let across = (between - between.dot(u) * u).normalize_or_zero();
    [normal, u, v, normal.cross(u), normal.cross(v), across]
        .into_iter()
        .filter(|direction| *direction != DVec3::ZERO)
        .any(|direction| {
            let range = |points: &[DVec3]| {
                let along = points.iter().map(|&point| direction.dot(point - a[0]));
                along.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| (low.min(x), high.max(x)))
            };
            let (x, y) = (range(a), range(b));
            // The directions are of length 1 but for rounding.
            let within = within * (1.0 + 1e-12) + 1e-15;
            x.0 - y.1 > within || y.0 - x.1 > within
        })
}

/// What can be said of a pair.
enum Verdict {
    None,
    One,
    Open,
}

/// Bounds the slopes and the Hessian of |A(s) - B(t)|^2 / 2 all over the pair.
fn judge(p: &Part, q: &Part) -> Verdict {
    let [(a, ra), (b, rb)] = [p.derivative(1), q.derivative(1)];
    let [(aa, raa), (bb, rbb)] = [p.derivative(2), q.derivative(2)];
    let [(here, r), (there, rr)] = [p.derivative(0), q.derivative(0)];
    let (gap, spread) = (here - there, r + rr);
    // How far products are from those of the means.
    let play = |x: DVec3, rx: f64, y: DVec3, ry: f64| x.length() * ry + y.length() * rx + rx * ry;
    let sign = |slope: f64, play: f64| if slope > play { 1 } else { -i32::from(slope < -play) };
    let signs = [sign(gap.dot(a), play(gap, spread, a, ra)), sign(-gap.dot(b), play(gap, spread, b, rb))];
    // The function falls towards one end, which is an end of the segment.
    let held = |k: usize, part: &Part| (signs[k] > 0 && part.from == 0.0) || (signs[k] < 0 && part.to == 1.0);
    let held = [held(0, p), held(1, q)];
    if (0..2).any(|k| signs[k] != 0 && !held[k]) {
        return Verdict::None;
    }
    let x = a.length_squared() + gap.dot(aa) - play(a, ra, a, ra) - play(gap, spread, aa, raa);
    let y = b.length_squared() - gap.dot(bb) - play(b, rb, b, rb) - play(gap, spread, bb, rbb);
    let z = a.dot(b).abs() + play(a, ra, b, rb);
    // Where the Hessian is indefinite, there is no least distance but at ends of segments.
    let inner = [p, q].iter().all(|part| part.from > 0.0 && part.to < 1.0);
    let [most_x, most_y] = [
        a.length_squared() + gap.dot(aa) + play(a, ra, a, ra) + play(gap, spread, aa, raa),
        b.length_squared() - gap.dot(bb) + play(b, rb, b, rb) + play(gap, spread, bb, rbb),
    ];
    let least_z = (a.dot(b).abs() - play(a, ra, b, rb)).max(0.0);
    if inner && (most_x < 0.0 || most_y < 0.0 || most_x * most_y < least_z * least_z) {
        return Verdict::None;
    }
    let convex = x > 0.0 && y > 0.0 && x * y > z * z * (1.0 + 1e-9);
    let at_end = (held[0] && (y > 0.0 || held[1])) || (held[1] && x > 0.0);
    if convex || at_end { Verdict::One } else { Verdict::Open }
}

/// Goes down |A - B|^2 / 2 within a box by Newton's and Gauss's steps; returns the place and the gradient there.
fn descend(whole: [&Part; 2], start: DVec2, low: DVec2, high: DVec2) -> (DVec2, DVec2) {
    let jets = |at: DVec2| {
        let jet = |part: &Part, t: f64| {
            let mut buffer = part.controls;
            let mut left = part.len;
            [(); 3].map(|()| {
                let value = if left > 0 { segment::point(&buffer[..left], t) } else { DVec3::ZERO };
                left = derive(&mut buffer[..left]);
                value
            })
        };
        (jet(whole[0], at.x), jet(whole[1], at.y))
    };
    let mut at = start.clamp(low, high);
    let (mut a, mut b) = jets(at);
    let slope = |a: &[DVec3; 3], b: &[DVec3; 3]| {
        let gap = a[0] - b[0];
        DVec2::new(gap.dot(a[1]), -gap.dot(b[1]))
    };
    for _ in 0..50 {
        let (gap, gradient) = (a[0] - b[0], slope(&a, &b));
        let held = |k: usize| (at[k] <= low[k] && gradient[k] > 0.0) || (at[k] >= high[k] && gradient[k] < 0.0);
        let (mixed, gauss) = (-a[1].dot(b[1]), [a[1].length_squared(), b[1].length_squared()]);
        let full = [gauss[0] + gap.dot(a[2]), gauss[1] - gap.dot(b[2])];
        let solve = |[x, y]: [f64; 2]| match (held(0), held(1)) {
            (false, false) => {
                let determinant = x * y - mixed * mixed;
                (x > 0.0 && determinant > 1e-14 * x * y).then(|| {
                    DVec2::new(gradient.x * y - gradient.y * mixed, gradient.y * x - gradient.x * mixed) / determinant
                })
            }
            (false, true) => (x > 0.0).then(|| DVec2::new(gradient.x / x, 0.0)),
            (true, false) => (y > 0.0).then(|| DVec2::new(0.0, gradient.y / y)),
            (true, true) => None,
        };
        // Newton's step, or where that does not go down Gauss's, which along valleys is damped.
        let shorter = |step: DVec2| {
            let lengths = [1.0, 0.25, 0.0625, 0.015_625, 0.004];
            lengths.into_iter().map(move |length| (at - length * step).clamp(low, high))
        };
        let steps = [full, gauss.map(|x| 1.000_001 * x), gauss.map(|x| 1.2 * x)].into_iter().filter_map(solve);
        let next = steps.filter(|step| step.is_finite()).flat_map(shorter).find_map(|there| {
            let (p, q) = jets(there);
            let down = there != at && p[0].distance_squared(q[0]) < gap.length_squared();
            down.then_some((there, p, q))
        });
        let Some((there, p, q)) = next else { break };
        (at, a, b) = (there, p, q);
    }
    (at, slope(&a, &b))
}
