//! Reports of filters: lines for people, and the numbers in them under names for programs. A line
//! has six significant digits of a measure; the number under its name has all of them.

use glam::DVec3;
use std::fmt::{self, Display};
use std::ops::Deref;

/// The kind of a number in a report.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ReportValueKind {
    /// A whole number.
    Count,
    /// 0 or 1.
    Flag,
    /// A number without unit, or in a unit of its own, such as an energy.
    Number,
    /// A length in the unit of the positions.
    Length,
    /// An area in the square of that unit.
    Area,
    /// A volume in the cube of that unit.
    Volume,
    /// An angle in radians.
    Angle,
}

/// A number in a report.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ReportValue {
    /// Its kind.
    pub kind: ReportValueKind,
    /// The number; flags are 0 or 1.
    pub number: f64,
}

impl ReportValue {
    pub(super) fn count(count: impl TryInto<i64>) -> Self {
        // No mesh has more than 2^63 of anything.
        ReportValue { kind: ReportValueKind::Count, number: count.try_into().unwrap_or(i64::MAX) as f64 }
    }

    pub(super) fn flag(is: bool) -> Self {
        ReportValue { kind: ReportValueKind::Flag, number: f64::from(u8::from(is)) }
    }

    pub(super) const fn number(number: f64) -> Self {
        ReportValue { kind: ReportValueKind::Number, number }
    }

    pub(super) const fn length(length: f64) -> Self {
        ReportValue { kind: ReportValueKind::Length, number: length }
    }

    pub(super) const fn area(area: f64) -> Self {
        ReportValue { kind: ReportValueKind::Area, number: area }
    }

    pub(super) const fn volume(volume: f64) -> Self {
        ReportValue { kind: ReportValueKind::Volume, number: volume }
    }

    /// An angle in radians.
    pub(super) const fn angle(angle: f64) -> Self {
        ReportValue { kind: ReportValueKind::Angle, number: angle }
    }
}

/// A report; it is read as its text.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Report {
    text: String,
    values: Vec<(&'static str, ReportValue)>,
}

impl Report {
    /// Lines and the numbers in them. Names are lower case, words joined by underscores.
    pub(super) fn new(text: String, values: &[(&'static str, ReportValue)]) -> Self {
        Report { text, values: values.to_vec() }
    }

    /// The numbers under their names, in the order of the lines.
    pub fn values(&self) -> &[(&'static str, ReportValue)] {
        &self.values
    }
}

impl From<String> for Report {
    fn from(text: String) -> Self {
        Report { text, values: Vec::new() }
    }
}

impl Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.text)
    }
}

impl Deref for Report {
    type Target = str;

    fn deref(&self) -> &str {
        &self.text
    }
}

/// A noun for one and for any other number.
pub(super) type Noun = [&'static str; 2];

pub(super) const VERTEX: Noun = ["vertex", "vertices"];
pub(super) const EDGE: Noun = ["edge", "edges"];
pub(super) const FACE: Noun = ["face", "faces"];
pub(super) const TRIANGLE: Noun = ["triangle", "triangles"];
pub(super) const QUAD: Noun = ["quad", "quads"];
pub(super) const PIECE: Noun = ["piece", "pieces"];
pub(super) const BOUNDARY_EDGE: Noun = ["boundary edge", "boundary edges"];
pub(super) const BOUNDARY_LOOP: Noun = ["boundary loop", "boundary loops"];
pub(super) const POINT: Noun = ["point", "points"];
pub(super) const CURVE: Noun = ["curve", "curves"];
pub(super) const HIT: Noun = ["hit", "hits"];
pub(super) const ROW: Noun = ["row", "rows"];
pub(super) const COLUMN: Noun = ["column", "columns"];

/// A number of things: "1 face", "2 faces".
pub(super) fn count_with_noun<N: Display + PartialEq + From<u8> + Copy>(count: N, [one, many]: Noun) -> String {
    let noun = if count == N::from(1) { one } else { many };
    format!("{count} {noun}")
}

/// Six significant digits, without zeros behind them.
pub(super) fn format_short(value: f64) -> String {
    const SIGNIFICANT_DIGITS: i32 = 6;
    let trimmed = |digits: &str| match digits.contains('.') {
        true => digits.trim_end_matches('0').trim_end_matches('.').to_owned(),
        false => digits.to_owned(),
    };
    // No sign before 0.
    let value = value + 0.0;
    let scientific = format!("{value:.*e}", SIGNIFICANT_DIGITS as usize - 1);
    let Some((mantissa, exponent)) = scientific.split_once('e') else { return scientific };
    match exponent.parse::<i32>() {
        Ok(power @ -5..SIGNIFICANT_DIGITS) => {
            trimmed(&format!("{value:.*}", (SIGNIFICANT_DIGITS - 1 - power) as usize))
        }
        _ => format!("{}e{exponent}", trimmed(mantissa)),
    }
}

/// The coordinates of a point.
pub(super) fn format_short_point(p: DVec3) -> String {
    format!("({} {} {})", format_short(p.x), format_short(p.y), format_short(p.z))
}

/// Appends a formatted line to a text.
macro_rules! push_line {
    ($text:expr, $($arg:tt)*) => {{
        use std::fmt::Write as _;
        // Writing to a string cannot fail.
        let _ = writeln!($text, $($arg)*);
    }};
}
pub(super) use push_line;

/// Appends a line that counts the items beyond the listed ones, if there are any.
pub(super) fn push_unlisted_count(text: &mut String, count: usize, listed: usize) {
    if count > listed {
        push_line!(text, "and {} more", count - listed);
    }
}

/// A line on distances: their number, the largest, the mean and the root mean square.
pub(super) fn distance_report(of_what: Noun, distances: impl Iterator<Item = f64>) -> Report {
    let (mut count, mut largest, mut sum) = (0u64, 0.0f64, 0.0);
    // Squares are relative to the largest so far: they do not overflow or vanish.
    let mut squares = 0.0;
    for distance in distances {
        count += 1;
        sum += distance;
        if distance > largest {
            squares = squares * (largest / distance) * (largest / distance);
            largest = distance;
        }
        if largest > 0.0 {
            squares += (distance / largest) * (distance / largest);
        }
    }
    let number = count.max(1) as f64;
    let (mean, root) = (sum / number, largest * (squares / number).sqrt());
    let text = format!(
        "{}: largest distance {}, mean {}, root mean square {}\n",
        count_with_noun(count, of_what),
        format_short(largest),
        format_short(mean),
        format_short(root)
    );
    let values = [
        ("count", ReportValue::count(count)),
        ("largest_distance", ReportValue::length(largest)),
        ("mean_distance", ReportValue::length(mean)),
        ("root_mean_square_distance", ReportValue::length(root)),
    ];
    Report::new(text, &values)
}
