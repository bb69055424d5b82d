//! Transforms of the plane.

use super::svg_numbers::NumberReader;
use crate::outline_pen::Vector;

/// Takes (x, y) to (a x + c y + e, b x + d y + f).
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Transform {
    parts: [f64; 6],
}

impl Transform {
    /// Turns the y axis up.
    pub(super) const UPWARDS: Self = Self { parts: [1.0, 0.0, 0.0, -1.0, 0.0, 0.0] };

    pub(super) fn translation(x: f64, y: f64) -> Self {
        Self { parts: [1.0, 0.0, 0.0, 1.0, x, y] }
    }

    pub(super) fn scaling(x: f64, y: f64) -> Self {
        Self { parts: [x, 0.0, 0.0, y, 0.0, 0.0] }
    }

    /// Returns the transform that applies `inner` first.
    pub(super) fn after(&self, inner: &Self) -> Self {
        let [a, b, c, d, e, f] = self.parts;
        let [p, q, r, s, t, u] = inner.parts;
        Self {
            parts: [a * p + c * q, b * p + d * q, a * r + c * s, b * r + d * s, a * t + c * u + e, b * t + d * u + f],
        }
    }

    pub(super) fn point(&self, [x, y]: [f64; 2]) -> Vector {
        let [a, b, c, d, e, f] = self.parts;
        [a * x + c * y + e, b * x + d * y + f, 0.0]
    }

    pub(super) fn vector(&self, [x, y]: [f64; 2]) -> Vector {
        let [a, b, c, d, ..] = self.parts;
        [a * x + c * y, b * x + d * y, 0.0]
    }

    /// Reads a `transform` attribute. Returns `None` if it is malformed.
    pub(super) fn from_list(text: &str) -> Option<Self> {
        let mut all = Self::scaling(1.0, 1.0);
        let mut rest = text;
        loop {
            rest = rest.trim_start_matches(|c: char| c.is_ascii_whitespace() || c == ',');
            if rest.is_empty() || rest == "none" {
                return Some(all);
            }
            let (name, behind) = rest.split_once('(')?;
            let (arguments, behind) = behind.split_once(')')?;
            all = all.after(&Self::from_function(name.trim(), arguments)?);
            rest = behind;
        }
    }

    fn from_function(name: &str, arguments: &str) -> Option<Self> {
        let mut reader = NumberReader::new(arguments);
        let mut numbers = [0.0; 6];
        let mut count = 0;
        while count < 6
            && let Some(number) = reader.number()
        {
            numbers[count] = number;
            count += 1;
        }
        let [a, b, c, ..] = numbers;
        match (name, count) {
            ("matrix", 6) => Some(Self { parts: numbers }),
            ("translate", 1 | 2) => Some(Self::translation(a, b)),
            ("scale", 1) => Some(Self::scaling(a, a)),
            ("scale", 2) => Some(Self::scaling(a, b)),
            ("rotate", 1) => Some(Self::rotation(a)),
            ("rotate", 3) => Some(Self::translation(b, c).after(&Self::rotation(a)).after(&Self::translation(-b, -c))),
            ("skewX", 1) => Some(Self { parts: [1.0, 0.0, a.to_radians().tan(), 1.0, 0.0, 0.0] }),
            ("skewY", 1) => Some(Self { parts: [1.0, a.to_radians().tan(), 0.0, 1.0, 0.0, 0.0] }),
            _ => None,
        }
    }

    fn rotation(degrees: f64) -> Self {
        // Quarter turns are exact.
        let (sin, cos) = match degrees.rem_euclid(360.0) {
            0.0 => (0.0, 1.0),
            90.0 => (1.0, 0.0),
            180.0 => (0.0, -1.0),
            270.0 => (-1.0, 0.0),
            _ => degrees.to_radians().sin_cos(),
        };
        Self { parts: [cos, sin, -sin, cos, 0.0, 0.0] }
    }
}
