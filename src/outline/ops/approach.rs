//! Where two curves in space come near to each other: the places where their distance is least, if it is small enough.
//!
//! Pairs of parts are halved until a proof holds:
//!
//! * *apart*: their hulls are farther from each other than asked for, along an axis or across both chords;
//! * *one at most*: the Hessian of |A(s) - B(t)|^2 / 2 is positive definite for all s and t of the pair, by bounds of its
//!   coefficients over the control points: then Newton's method finds the only least distance there is.
//!
//! Parts that run beside each other have no such proof: what is left of them at the least size is one part in common, if it is near
//! enough.

use super::super::curve::{CurveView, MAX_DEGREE, Place};
use super::super::segment;
use super::evaluate::derive;
use super::frame::Frame;
use super::split::{Room, split_segment};
use super::tree::{Aabb, Tree};
use crate::alloc;
use crate::error::{Error, Result};
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
const SHORT: f64 = 1.0 / 4096.0;
/// Pairs of parts that are looked at for two segments.
const PATIENCE: usize = 20_000;
/// Places whose parameters differ by less are one.
const SAME: f64 = 1e-7;

/// A part of a segment.
#[derive(Clone, Copy)]
struct Part {
    controls: Room,
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
        let (ours, theirs) = (parts(self, &frame)?, parts(other, &frame)?);
        let tree = Tree::new(theirs.iter().map(|part| Aabb::of(part.controls())))?;
        for (i, a) in ours.iter().enumerate() {
            if i % 16 == 0 {
                job.step(i as f64 / ours.len() as f64, "approaches of curves")?;
            }
            tree.overlapping(&Aabb::of(a.controls()), search.within, |j| {
                search.run(a, &theirs[j], DVec2::new(i as f64, j as f64), [ours.len(), theirs.len()])
            })?;
        }
        search.finish([self, other], &frame)
    }
}

/// The segments in a frame.
fn parts(curve: &CurveView<'_>, frame: &Frame) -> Result<Vec<Part>> {
    alloc::collect(curve.segments().map(|points| {
        let mut controls = [DVec3::ZERO; MAX_DEGREE + 1];
        controls.iter_mut().zip(points).for_each(|(to, &point)| *to = frame.point(point));
        Part { controls, len: points.len(), from: 0.0, to: 1.0 }
    }))
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
    /// Looks at two segments; `base`: their numbers, `counts`: of how many.
    fn run(&mut self, a: &Part, b: &Part, base: DVec2, counts: [usize; 2]) -> Result<()> {
        let mut waiting = Vec::new();
        alloc::push(&mut waiting, [*a, *b])?;
        let mut looked = 0;
        while let Some([p, q]) = waiting.pop() {
            looked += 1;
            if apart(&p, &q, self.within) {
                continue;
            }
            if convex(&p, &q) {
                self.add_least([a, b], [&p, &q], base, counts)?;
                continue;
            }
            let sizes = [&p, &q].map(|part| Aabb::of(part.controls()).size());
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
    fn add_least(&mut self, whole: [&Part; 2], pair: [&Part; 2], base: DVec2, counts: [usize; 2]) -> Result<()> {
        let low = DVec2::new(pair[0].from, pair[1].from);
        let high = DVec2::new(pair[0].to, pair[1].to);
        let (at, gradient) = descend(whole, 0.5 * (low + high), low, high);
        // At an inner end of a part from which it goes on down, the next part has it; at the end of a curve, it ends there.
        for k in 0..2 {
            let play = 1e-9 * whole[k].size();
            let goes_on = |end: f64, slope: f64| {
                let last = if end == 0.0 { base[k] == 0.0 } else { base[k] as usize + 1 == counts[k] };
                let of_segment = end == 0.0 || end == 1.0;
                slope > play && !(of_segment && last)
            };
            if (at[k] <= low[k] && goes_on(low[k], gradient[k])) || (at[k] >= high[k] && goes_on(high[k], -gradient[k]))
            {
                return Ok(());
            }
        }
        let distance = point(whole[0], at.x).distance(point(whole[1], at.y));
        if distance <= self.within {
            alloc::push(&mut self.finds, Find { at: base + at, distance })?;
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
        Aabb::of(self.controls()).size()
    }

    fn halves(mut self) -> [Part; 2] {
        let middle = 0.5 * (self.from + self.to);
        let mut before = Part { to: middle, ..self };
        split_segment(&mut self.controls[..self.len], 0.5, &mut before.controls[..self.len]);
        [before, Part { from: middle, ..self }]
    }

    /// n (n - 1) (B_i+2 - 2 B_i+1 + B_i) or n (B_i+1 - B_i): the mean, and how far the others are from it.
    fn derivative(&self, order: usize) -> (DVec3, f64) {
        let mut room = self.controls;
        let mut left = self.len;
        for _ in 0..order {
            left = derive(&mut room[..left]);
        }
        if left == 0 {
            return (DVec3::ZERO, 0.0);
        }
        let mean = room[..left].iter().sum::<DVec3>() / left as f64;
        (mean, room[..left].iter().map(|v| v.distance(mean)).fold(0.0, f64::max))
    }
}

fn point(part: &Part, t: f64) -> DVec3 {
    segment::point(part.controls(), t)
}

/// True if the hulls are farther apart than `within`.
fn apart(p: &Part, q: &Part, within: f64) -> bool {
    let (a, b) = (p.controls(), q.controls());
    if !Aabb::of(a).near(&Aabb::of(b), within) {
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

/// True if |A(s) - B(t)|^2 / 2 is convex all over the pair.
fn convex(p: &Part, q: &Part) -> bool {
    let [(a, ra), (b, rb)] = [p.derivative(1), q.derivative(1)];
    let [(aa, raa), (bb, rbb)] = [p.derivative(2), q.derivative(2)];
    let (mut gap, mut spread) = (DVec3::ZERO, 0.0);
    for (part, sign) in [(p, 1.0), (q, -1.0)] {
        let (mean, radius) = part.derivative(0);
        gap += sign * mean;
        spread += radius;
    }
    // How far products are from those of the means.
    let play = |x: DVec3, rx: f64, y: DVec3, ry: f64| x.length() * ry + y.length() * rx + rx * ry;
    let (x, y, z) = (a.length_squared() + gap.dot(aa), b.length_squared() - gap.dot(bb), -a.dot(b));
    let x = x - play(a, ra, a, ra) - play(gap, spread, aa, raa);
    let y = y - play(b, rb, b, rb) - play(gap, spread, bb, rbb);
    let z = z.abs() + play(a, ra, b, rb);
    x > 0.0 && y > 0.0 && x * y > z * z * (1.0 + 1e-9)
}

/// Goes down |A - B|^2 / 2 within a box by Newton's and Gauss's steps; returns the place and the gradient there.
fn descend(whole: [&Part; 2], start: DVec2, low: DVec2, high: DVec2) -> (DVec2, DVec2) {
    let jets = |at: DVec2| {
        let jet = |part: &Part, t: f64| {
            let mut room = part.controls;
            let mut left = part.len;
            [(); 3].map(|()| {
                let value = if left > 0 { segment::point(&room[..left], t) } else { DVec3::ZERO };
                left = derive(&mut room[..left]);
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
        let damped = || solve(gauss.map(|x| 1.000_001 * x));
        let Some(step) = solve(full).or_else(damped).filter(|step| step.is_finite()) else { break };
        let mut length = 1.0;
        let next = loop {
            let there = (at - length * step).clamp(low, high);
            let (p, q) = jets(there);
            if there == at || length < 1e-3 {
                break None;
            }
            if p[0].distance_squared(q[0]) < gap.length_squared() {
                break Some((there, p, q));
            }
            length *= 0.25;
        };
        let Some((there, p, q)) = next else { break };
        (at, a, b) = (there, p, q);
    }
    (at, slope(&a, &b))
}
