//! All arcs of a pair of cells.
//!
//! A box of parameters is done if nothing is in it, or if its solutions are a graph whose arc is found; else it is halved across its longest
//! side. It is given up, and reported, when the two pieces in it are within the tolerance of each other all over: they touch there, or coincide.

use super::arc::{End, Found, Search};
use super::chart::{Part, Proof};
use super::equation::Equation;
use super::refine::Refined;
use crate::alloc;
use crate::error::Result;
use glam::{DVec3, DVec4};

/// Boxes looked at before it is asked whether the cells touch, or have no area: curves that meet, meet in points.
const PATIENCE: usize = 12;

/// Spots apart from each other that one pair may have.
const SPOTS: usize = 64;

/// A piece of the intersection over one pair of cells, in the direction N_A x N_B.
#[derive(Debug, Clone, Copy)]
pub(super) struct Arc {
    /// Which pair.
    pub(super) pair: u32,
    /// Its points among those of the [`Pieces`].
    pub(super) from: u32,
    pub(super) to: u32,
    /// The first and the last point, and the directions there.
    pub(super) ends: [DVec3; 2],
    pub(super) directions: [DVec3; 2],
}

/// Where cells touch, or may do: a ball round it.
#[derive(Debug, Clone, Copy)]
pub(super) struct Spot {
    pub(super) pair: u32,
    pub(super) x: DVec4,
    pub(super) centre: DVec3,
    pub(super) radius: f64,
    /// How far the cells are apart at x.
    pub(super) gap: f64,
}

/// What was found over some pairs.
#[derive(Debug, Default)]
pub(super) struct Pieces {
    pub(super) points: Vec<DVec4>,
    pub(super) arcs: Vec<Arc>,
    pub(super) spots: Vec<Spot>,
    /// Pairs on which more boxes were to be looked at than permitted.
    pub(super) exhausted: Vec<u32>,
}

impl Pieces {
    /// How many points, arcs and spots there are.
    fn counts(&self) -> [usize; 3] {
        [self.points.len(), self.arcs.len(), self.spots.len()]
    }

    /// Forgets what was added since.
    fn truncate(&mut self, [points, arcs, spots]: [usize; 3]) {
        self.points.truncate(points);
        self.arcs.truncate(arcs);
        self.spots.truncate(spots);
    }

    /// Adds what was found over other pairs.
    pub(super) fn append(&mut self, other: &Pieces) -> Result<()> {
        let before = self.points.len() as u32;
        alloc::append(&mut self.points, &other.points)?;
        alloc::reserve(&mut self.arcs, other.arcs.len())?;
        self.arcs.extend(other.arcs.iter().map(|arc| Arc { from: arc.from + before, to: arc.to + before, ..*arc }));
        alloc::append(&mut self.spots, &other.spots)?;
        alloc::append(&mut self.exhausted, &other.exhausted)
    }
}

/// How a pair of cells is to be solved.
#[derive(Debug, Clone, Copy)]
pub(super) struct Task {
    pub(super) pair: u32,
    /// By parameter, whether a cell follows above.
    pub(super) followed: [bool; 4],
    pub(super) tolerance: f64,
    /// The greatest distance of a chord from the curve.
    pub(super) chord: f64,
    /// Boxes that may be looked at.
    pub(super) limit: usize,
    /// Whether what is left then is given up; else the pair is only named.
    pub(super) last: bool,
    /// Lengths up to this may be rounding.
    pub(super) noise: f64,
}

impl Task {
    /// Adds the arcs of the pair.
    pub(super) fn solve<const N: usize, const M: usize>(&self, whole: &Part<N, M>, pieces: &mut Pieces) -> Result<()> {
        let equation = &whole.nets;
        let before = pieces.counts();
        let [_, _, spots] = before;
        // Of most pairs there is one box to be looked at.
        let Some([low, high]) = self.look(equation, whole, spots, pieces)? else {
            return Ok(());
        };
        let mut stack = vec![high, low];
        let mut looked_at = 1;
        while let Some(part) = stack.pop() {
            looked_at += 1;
            let hopeless = || equation.a.patch().has_no_area() && equation.b.patch().has_no_area();
            if looked_at == PATIENCE && (hopeless() || self.coincide(equation)) {
                pieces.truncate(before);
                self.give_up(equation, whole, spots, pieces);
                return Ok(());
            }
            if looked_at > self.limit && !self.last {
                pieces.truncate(before);
                return alloc::push(&mut pieces.exhausted, self.pair);
            }
            if looked_at > self.limit {
                self.give_up(equation, &part, spots, pieces);
            } else if let Some([low, high]) = self.look(equation, &part, spots, pieces)? {
                stack.extend([high, low]);
            }
        }
        Ok(())
    }

    /// Looks at a box: it is done, or else its halves are to be looked at.
    fn look<const N: usize, const M: usize>(
        &self,
        equation: &Equation<N, M>,
        part: &Part<N, M>,
        spots: usize,
        pieces: &mut Pieces,
    ) -> Result<Option<[Part<N, M>; 2]>> {
        let frame = equation.frame(part.middle());
        match part.prove(&frame, self.noise) {
            Proof::Empty => return Ok(None),
            Proof::Open => {}
            Proof::Graph(chart) => {
                let search = Search::new(equation, part, &chart, self.tolerance, self.noise, self.followed);
                let found = match search.along_line(&frame) {
                    Some(found) => found,
                    None if part.is_apart(&frame, self.noise) => Found::Nothing,
                    None => search.through_inside(&frame),
                };
                match found {
                    Found::Nothing => return Ok(None),
                    Found::Open => {}
                    Found::Arc(ends) => {
                        self.add(equation, ends, chart.free, pieces)?;
                        return Ok(None);
                    }
                }
            }
        }
        let extents = part.extents();
        let longest = (0..4).fold(0, |best, k| if extents[k] > extents[best] { k } else { best });
        if extents[longest] <= 0.25 * self.tolerance || part.is_within(&frame, self.tolerance) {
            self.give_up(equation, part, spots, pieces);
            return Ok(None);
        }
        Ok(Some(part.halves(longest)))
    }

    /// Adds an arc, unless it is as short as may be dropped.
    fn add<const N: usize, const M: usize>(
        &self,
        equation: &Equation<N, M>,
        ends: [End; 2],
        free: usize,
        pieces: &mut Pieces,
    ) -> Result<()> {
        // By rising free parameter; but the curve runs along N_A x N_B.
        let rises = ends[0].tangent[free] > 0.0;
        let ends = if rises { ends } else { [ends[1], ends[0]] };
        let places = ends.map(|end| equation.point(end.x));
        if places[0].distance(places[1]) <= 0.5 * self.tolerance {
            return Ok(());
        }
        let from = pieces.points.len() as u32;
        alloc::push(&mut pieces.points, ends[0].x)?;
        Refined { equation, free, chord: self.chord }.between(ends, places, &mut pieces.points)?;
        alloc::push(&mut pieces.points, ends[1].x)?;
        let to = pieces.points.len() as u32;
        let directions = ends.map(|end| end.direction.normalize_or_zero());
        alloc::push(&mut pieces.arcs, Arc { pair: self.pair, from, to, ends: places, directions })
    }

    /// Reports a box: spots of the same pair that touch are one.
    fn give_up<const N: usize, const M: usize>(
        &self,
        equation: &Equation<N, M>,
        part: &Part<N, M>,
        first: usize,
        pieces: &mut Pieces,
    ) {
        let x = part.middle();
        let centre = equation.point(x);
        let reach = |corner: &DVec3| corner.distance(centre);
        let radius = part.nets.a.patch().points.as_flattened().iter().map(reach).fold(0.0, f64::max);
        let gap = equation.frame(x).miss.length();
        let spot = Spot { pair: self.pair, x, centre, radius, gap };
        let own = &mut pieces.spots[first..];
        let touches = |other: &Spot| other.centre.distance(centre) <= other.radius + radius + self.tolerance;
        // Of too many apart from each other, the last one takes the rest.
        let found = own.iter().position(touches).or((own.len() >= SPOTS).then(|| own.len() - 1));
        match found {
            Some(k) => {
                let nearer = if gap < own[k].gap { spot } else { own[k] };
                let reach = |spot: &Spot| nearer.centre.distance(spot.centre) + spot.radius;
                own[k] = Spot { radius: reach(&spot).max(reach(&own[k])), ..nearer };
            }
            None => pieces.spots.push(spot),
        }
    }

    /// Whether the cells touch at three places at least, as far as a few points show: it is no use to look closer then.
    fn coincide<const N: usize, const M: usize>(&self, equation: &Equation<N, M>) -> bool {
        let mut contacts = [DVec3::ZERO; 3];
        let mut count = 0;
        for k in 0..18 {
            let (along, across) = (0.5 * f64::from(k / 3 % 3), 0.5 * f64::from(k % 3));
            let Some(contact) = self.contact(equation, along, across, k < 9) else {
                continue;
            };
            if contacts[..count].iter().all(|other| other.distance(contact) > 64.0 * self.tolerance) {
                contacts[count] = contact;
                count += 1;
            }
            if count == 3 {
                return true;
            }
        }
        false
    }

    /// The point of the one cell at the given parameters, if the other cell touches it there.
    fn contact<const N: usize, const M: usize>(
        &self,
        equation: &Equation<N, M>,
        along: f64,
        across: f64,
        on_a: bool,
    ) -> Option<DVec3> {
        let fixed = if on_a { 0 } else { 2 };
        let mut x = DVec4::splat(0.5);
        (x[fixed], x[fixed + 1]) = (along, across);
        let (p, q) = (2 - fixed, 3 - fixed);
        for _ in 0..8 {
            let frame = equation.frame(x);
            let [a, b] = frame.normals();
            let (one, other) = (frame.columns[p], frame.columns[q]);
            if frame.miss.length() <= self.tolerance {
                let touches = a.cross(b).length() <= 1e-4 * a.length() * b.length();
                return touches.then(|| equation.point(x));
            }
            // Gauss and Newton's step towards the nearest point.
            let (aa, ab, bb) = (one.length_squared(), one.dot(other), other.length_squared());
            let determinant = aa * bb - ab * ab;
            let (f, g) = (frame.miss.dot(one), frame.miss.dot(other));
            x[p] = (x[p] - (f * bb - g * ab) / determinant).clamp(0.0, 1.0);
            x[q] = (x[q] - (g * aa - f * ab) / determinant).clamp(0.0, 1.0);
            if !x.is_finite() {
                return None;
            }
        }
        None
    }
}
