//! The energies of a line across a bridge and of a cell of a film, and sums of squares that bound
//! them from above.
//!
//! A length |e| is at most |e|^2 / (2 l) + l / 2 with the current length l, and the force density
//! is 1 / l (Schek 1974). The area of a triangle is at most the Dirichlet energy of the map from
//! the current triangle, with its cotangents (Pinkall and Polthier 1993; Pauletti and Pimenta
//! 2008). The energy of a spring is at most the energy of a spring between points that rests at its
//! length in the current direction.

use super::quadratic_term::QuadraticTerm;
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;

/// Lengths below this count as 0 in weights. The unit is about the size of the net.
pub(super) const MIN_RELATIVE_LENGTH: f64 = 1e-12;
/// The smallest double area of a triangle, relative to the square of its longest side, so that
/// cotangents are finite.
const MIN_RELATIVE_DOUBLE_AREA: f64 = 1e-12;

/// The parts of the energy.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(super) struct BridgeEnergies {
    pub(super) tension: f64,
    pub(super) elastic: f64,
    pub(super) bending: f64,
}

impl BridgeEnergies {
    pub(super) fn total_energy(&self) -> f64 {
        self.tension + self.elastic + self.bending
    }
}

/// The tension, elasticity and stiffness of a line across a bridge, relative to the largest force,
/// with the net's size as the unit of length.
#[derive(Clone, Copy, Default)]
pub(super) struct ElasticLaw {
    pub(super) tension: f64,
    pub(super) elasticity: f64,
    pub(super) stiffness: f64,
}

/// A line of links across a bridge.
pub(super) struct BridgeLine {
    /// The points from side to side.
    pub(super) points: Vec<u32>,
    /// The rest lengths of the links; 0 if unknown.
    pub(super) rest_lengths: Vec<f64>,
    /// The mean of the known rest lengths.
    pub(super) spacing: f64,
    /// The targets of its ends, one link away.
    pub(super) end_targets: [Option<u32>; 2],
    pub(super) law: ElasticLaw,
}

impl BridgeLine {
    fn edge_vectors<'a>(&'a self, x: &'a [DVec3]) -> impl Iterator<Item = DVec3> + 'a {
        self.points.windows(2).map(|ends| x[ends[1] as usize] - x[ends[0] as usize])
    }

    /// Returns the square root of the number of links times the sum of their squares: the length of
    /// the line once its nodes are evenly spaced, as in equilibrium.
    fn line_length(&self, x: &[DVec3]) -> f64 {
        (self.rest_lengths.len() as f64 * self.edge_vectors(x).map(DVec3::length_squared).sum::<f64>()).sqrt()
    }

    /// Returns the weight of a squared second difference: stiffness / h^3 for the mean rest length
    /// h; 0 if h is unknown.
    fn bending_weight(&self) -> f64 {
        let h = self.spacing;
        if self.law.stiffness > 0.0 && h > MIN_RELATIVE_LENGTH { self.law.stiffness / (h * h * h) } else { 0.0 }
    }

    /// Returns the rest lengths of the links that are springs.
    fn spring_rest_lengths(&self) -> impl Iterator<Item = Option<f64>> + '_ {
        self.rest_lengths.iter().map(|&rest| (self.law.elasticity > 0.0 && rest > MIN_RELATIVE_LENGTH).then_some(rest))
    }

    /// Returns the clamped ends: the point next to each end, and its target.
    fn clamped_ends(&self) -> impl Iterator<Item = [u32; 2]> + '_ {
        let next = [1, self.points.len() - 2];
        (0..2).filter_map(move |end| Some([self.points[next[end]], self.end_targets[end]?]))
    }

    /// Returns the approximate energy of its springs at twice their rest length. The rounding of
    /// their energy is relative to it if the energy is nearly 0.
    pub(super) fn spring_energy_scale(&self) -> f64 {
        self.law.elasticity * self.rest_lengths.iter().sum::<f64>()
    }

    pub(super) fn add_energies(&self, x: &[DVec3], sum: &mut BridgeEnergies) {
        if self.law.tension > 0.0 {
            sum.tension += self.law.tension * self.line_length(x);
        }
        for (e, rest) in self.edge_vectors(x).zip(self.spring_rest_lengths()) {
            if let Some(rest) = rest {
                sum.elastic += self.law.elasticity / 2.0 * (e.length() - rest).powi(2) / rest;
            }
        }
        let weight = self.bending_weight();
        if weight > 0.0 {
            let at = |k: u32| x[k as usize];
            let bends = self.points.windows(3).map(|p| (at(p[0]) - 2.0 * at(p[1]) + at(p[2])).length_squared());
            let clamps = self.clamped_ends().map(|[p, q]| 2.0 * at(p).distance_squared(at(q)));
            sum.bending += weight / 2.0 * (bends.sum::<f64>() + clamps.sum::<f64>());
        }
    }

    pub(super) fn push_quadratic_terms(&self, x: &[DVec3], terms: &mut Vec<QuadraticTerm>) -> Result<()> {
        let links = self.rest_lengths.len() as f64;
        let tension = if self.law.tension > 0.0 {
            self.law.tension * links / self.line_length(x).max(MIN_RELATIVE_LENGTH)
        } else {
            0.0
        };
        for ((ends, e), rest) in self.points.windows(2).zip(self.edge_vectors(x)).zip(self.spring_rest_lengths()) {
            if tension > 0.0 {
                alloc::push(terms, QuadraticTerm::from_edge(ends[1], ends[0], tension, DVec3::ZERO))?;
            }
            if let Some(rest) = rest {
                let weight = self.law.elasticity / rest;
                alloc::push(terms, QuadraticTerm::from_edge(ends[1], ends[0], weight, rest * e.normalize_or_zero()))?;
            }
        }
        let weight = self.bending_weight();
        if weight > 0.0 {
            for p in self.points.windows(3) {
                let (points, factors) = ([p[0], p[1], p[2]], [1.0, -2.0, 1.0]);
                alloc::push(terms, QuadraticTerm { points, factors, weight, rest_value: DVec3::ZERO })?;
            }
            for [p, q] in self.clamped_ends() {
                alloc::push(terms, QuadraticTerm::from_edge(p, q, 2.0 * weight, DVec3::ZERO))?;
            }
        }
        Ok(())
    }
}

/// A cell of a film under surface tension.
pub(super) struct FilmQuad {
    pub(super) corners: [u32; 4],
    pub(super) tension: f64,
}

impl FilmQuad {
    /// Returns the four triangles of its corners, from both diagonals.
    fn triangles(&self) -> impl Iterator<Item = [u32; 3]> {
        let [a, b, c, d] = self.corners;
        let all = [[a, b, c], [a, c, d], [a, b, d], [b, c, d]];
        all.into_iter().filter(|[a, b, c]| a != b && b != c && c != a)
    }

    /// Returns the mean area of both triangulations.
    pub(super) fn quad_area(&self, x: &[DVec3]) -> f64 {
        let double =
            |[a, b, c]: [u32; 3]| (x[b as usize] - x[a as usize]).cross(x[c as usize] - x[a as usize]).length();
        self.triangles().map(double).sum::<f64>() / 4.0
    }

    pub(super) fn film_energy(&self, x: &[DVec3]) -> f64 {
        self.tension * self.quad_area(x)
    }

    pub(super) fn push_quadratic_terms(&self, x: &[DVec3], terms: &mut Vec<QuadraticTerm>) -> Result<()> {
        for triangle in self.triangles() {
            let at = |k: usize| x[triangle[k % 3] as usize];
            let sides = [0, 1, 2].map(|k| at(k + 2) - at(k + 1));
            let longest = sides
                .iter()
                .map(|side| side.length_squared())
                .fold(MIN_RELATIVE_LENGTH * MIN_RELATIVE_LENGTH, f64::max);
            let double = sides[0].cross(sides[1]).length().max(MIN_RELATIVE_DOUBLE_AREA * longest);
            for k in 0..3 {
                let cotangent = -sides[(k + 1) % 3].dot(sides[(k + 2) % 3]) / double;
                let (p, q) = (triangle[(k + 1) % 3], triangle[(k + 2) % 3]);
                // Half the cotangent, and half the weight for each of the two triangulations.
                alloc::push(terms, QuadraticTerm::from_edge(p, q, self.tension * cotangent / 4.0, DVec3::ZERO))?;
            }
        }
        Ok(())
    }
}
