//! The zero set of a field over one cell, as arcs between marks. Marks are the places where the
//! zero set crosses sides. [`subdivide`] splits the cell into quarters.
//!
//! Signs follow `side_sign_changes`: 0 counts as positive. The sign changes an even number of times
//! around the border of a cell or part. It changes alternately from plus to minus, where an arc
//! enters (with plus on its left), and from minus to plus, where an arc leaves. A part is settled
//! in one of these cases. Otherwise it is split into four parts, whose common sides get their own
//! marks:
//! - *none*: the border has no marks, and all coefficients have one sign;
//! - *graph*: the field is monotone in u, or in v. The zero set is a graph over the other
//!   parameter, so closed loops are impossible. Arcs are in order along it, and the k-th entry
//!   belongs to the k-th exit;
//! - *unresolved*: the field cannot be distinguished from 0, or the part is too small. The sign in
//!   the middle determines how marks are linked, and the part is reported.
//!
//! Invariant: a part takes its marks from its parent, and from the lines between parts, so that
//! arcs of neighbouring parts join exactly. Monotonicity as a termination criterion: Alberti,
//! Mourrain and Wintz (2008). Cost: O(M^3) for a split, at most [`MAX_PARTS_PER_CELL`] parts.

use super::side_sign_changes::{counts_as_positive, find_sign_changes};
use crate::subdivision::BernsteinField;
use glam::DVec2;
use gusset_base::geom::subdivision::{BoxTest, Subdivision, SubdivisionLimits, subdivide};
use gusset_base::sort;
use std::convert::Infallible;

/// Number of halvings of each parameter before a part is given up.
const MAX_SUBDIVISION_DEPTH: u32 = 26;
/// Largest number of parts examined in one cell.
const MAX_PARTS_PER_CELL: usize = 1024;

/// Number of sides of a cell or part. Counter-clockwise, the sides are v low, u high, v high, u
/// low.
pub(super) const SIDES_PER_CELL: usize = 4;
/// For each side, the corners (2 u + v) at its start and end. The parameter increases between them.
pub(super) const CORNERS_OF_SIDES: [[usize; 2]; SIDES_PER_CELL] = [[0, 2], [2, 3], [1, 3], [0, 1]];

/// A place where the sign changes along a side.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct SignChangeMark {
    /// The key, which all cells and parts that share the side agree on.
    pub(super) key: u64,
    /// The parameters in the cell.
    pub(super) parameters: DVec2,
    pub(super) side: usize,
    /// True if the sign changes from minus to plus with increasing parameter along the side.
    pub(super) rising: bool,
}

impl SignChangeMark {
    /// The parameter along its side.
    fn parameter_on_side(&self) -> f64 {
        self.parameters[self.side % 2]
    }

    /// True if an arc begins here: counter-clockwise, the sign changes from plus to minus.
    fn is_entry(&self) -> bool {
        self.rising == (self.side >= 2)
    }
}

/// An arc as a graph: over u (0) or v (1), with the range of the other parameter.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct ArcGraphRange {
    pub(super) graph_parameter: usize,
    pub(super) value_range: [f64; 2],
}

/// An arc of the zero set.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct MarkedArc {
    pub(super) start_mark: SignChangeMark,
    pub(super) end_mark: SignChangeMark,
    /// The graph of the arc; `None` in unresolved parts.
    pub(super) graph: Option<ArcGraphRange>,
}

/// A cell or part with the marks on its border.
pub(super) struct CellPartWithMarks<const M: usize> {
    field: BernsteinField<M>,
    marks: Vec<SignChangeMark>,
    /// Whether the field counts as positive at the corners 2 u + v.
    corners: [bool; 4],
    low_corner: DVec2,
    size: f64,
}

/// A generator of keys for marks inside cells.
pub(super) struct InnerMarkKeyGenerator(pub(super) u64);

impl InnerMarkKeyGenerator {
    fn next_key(&mut self) -> u64 {
        self.0 += 1;
        self.0
    }
}

/// Finds the arcs of a cell from its marks and the signs at its corners. Values up to
/// `rounding_error` may be 0. Returns a place that is left unresolved, if any.
#[inline]
pub(super) fn find_cell_arcs<const M: usize>(
    field: &BernsteinField<M>,
    marks: &mut Vec<SignChangeMark>,
    corners: [bool; 4],
    rounding_error: f64,
    keys: &mut InnerMarkKeyGenerator,
    mut add: impl FnMut(MarkedArc),
) -> Option<DVec2> {
    // The usual case.
    if marks.is_empty() && has_one_sign(field) {
        return None;
    }
    if let Some(over) = graph_parameter(field, rounding_error) {
        link_marks_along_graph(marks, ArcGraphRange { graph_parameter: over, value_range: [0.0, 1.0] }, &mut add);
        return None;
    }
    let marks = std::mem::take(marks);
    let whole = CellPartWithMarks { field: *field, marks, corners, low_corner: DVec2::ZERO, size: 1.0 };
    let mut search = CellArcSearch { rounding_error, keys, visit_arc: add, unresolved: None };
    let limits = SubdivisionLimits { max_depth: MAX_SUBDIVISION_DEPTH, max_boxes: MAX_PARTS_PER_CELL };
    let Ok(()) = subdivide(&mut search, whole, &mut Vec::new(), limits);
    search.unresolved.map(|(_, place)| place)
}

/// The search in one cell.
struct CellArcSearch<'a, F> {
    rounding_error: f64,
    keys: &'a mut InnerMarkKeyGenerator,
    visit_arc: F,
    /// The middle of the unresolved part with the smallest absolute value there, preceded by that
    /// value.
    unresolved: Option<(f64, DVec2)>,
}

impl<F: FnMut(MarkedArc), const M: usize> Subdivision<CellPartWithMarks<M>, 4> for CellArcSearch<'_, F> {
    /// The parameter over which the zero set is a graph.
    type Solution = usize;
    type Split = ();
    type Stop = Infallible;

    #[inline]
    fn classify_box(&mut self, part: &CellPartWithMarks<M>) -> Result<BoxTest<usize, ()>, Infallible> {
        Ok(if part.marks.is_empty() && has_one_sign(&part.field) {
            BoxTest::Empty
        } else if let Some(over) = graph_parameter(&part.field, self.rounding_error) {
            BoxTest::Unique(over)
        } else {
            let [low, high] = part.field.coefficient_range();
            let vanishes = low >= -self.rounding_error && high <= self.rounding_error;
            if vanishes { BoxTest::Unresolved } else { BoxTest::Undecided(()) }
        })
    }

    fn record_solution(&mut self, mut part: CellPartWithMarks<M>, over: usize) -> Result<(), Infallible> {
        let low = part.low_corner[1 - over];
        link_marks_along_graph(
            &mut part.marks,
            ArcGraphRange { graph_parameter: over, value_range: [low, low + part.size] },
            &mut self.visit_arc,
        );
        Ok(())
    }

    fn record_unresolved(&mut self, part: CellPartWithMarks<M>, _exhausted: bool) -> Result<(), Infallible> {
        let middle = part.field.evaluate_jet(0.5, 0.5).value;
        if self.unresolved.is_none_or(|(min, _)| middle.abs() < min) {
            self.unresolved = Some((middle.abs(), part.low_corner + 0.5 * part.size));
        }
        link_marks_around_middle(&part.marks, counts_as_positive(middle), &mut self.visit_arc);
        Ok(())
    }

    fn split_box(&mut self, part: CellPartWithMarks<M>, (): ()) -> [CellPartWithMarks<M>; 4] {
        part.into_quarters(self.keys)
    }
}

/// True if the coefficients prove that the field does not vanish.
#[inline]
pub(super) fn has_one_sign<const M: usize>(field: &BernsteinField<M>) -> bool {
    let [low, high] = field.coefficient_range();
    low >= 0.0 || high < 0.0
}

/// The parameter, u (0) or v (1), over which the zero set is a graph, because the field is monotone
/// in the other one. If both are possible, the field is steeper in the other parameter.
#[inline]
fn graph_parameter<const M: usize>(field: &BernsteinField<M>, rounding_error: f64) -> Option<usize> {
    // Slopes are differences of coefficients, times the degree.
    let slack = rounding_error * (M - 1) as f64;
    let steep = |[low, high]: [f64; 2]| {
        let rises = low >= -slack && high > 16.0 * slack;
        let falls = high <= slack && low < -16.0 * slack;
        (rises || falls).then_some(low.abs().min(high.abs()))
    };
    match field.derivative_ranges().map(steep) {
        [Some(u), Some(v)] => Some(usize::from(u > v)),
        [Some(_), None] => Some(1),
        [None, Some(_)] => Some(0),
        [None, None] => None,
    }
}

/// Links marks along a graph: the k-th entry to the k-th exit.
#[inline]
fn link_marks_along_graph(marks: &mut [SignChangeMark], graph: ArcGraphRange, add: &mut impl FnMut(MarkedArc)) {
    if let [a, b] = *marks {
        let (from, to) = if a.is_entry() { (a, b) } else { (b, a) };
        return add(MarkedArc { start_mark: from, end_mark: to, graph: Some(graph) });
    }
    sort::sort_stable(marks, &|a, b| {
        a.parameters[graph.graph_parameter].total_cmp(&b.parameters[graph.graph_parameter])
    });
    let (entries, exits) = (marks.iter().filter(|mark| mark.is_entry()), marks.iter().filter(|mark| !mark.is_entry()));
    for (&from, &to) in entries.zip(exits) {
        add(MarkedArc { start_mark: from, end_mark: to, graph: Some(graph) });
    }
}

/// Links marks around an unresolved part. If the middle is positive, arcs cut off negative regions,
/// and positive ones otherwise.
fn link_marks_around_middle(marks: &[SignChangeMark], middle: bool, add: &mut impl FnMut(MarkedArc)) {
    let mut round: Vec<SignChangeMark> = Vec::with_capacity(marks.len());
    for side in 0..SIDES_PER_CELL {
        let first = round.len();
        round.extend(marks.iter().filter(|mark| mark.side == side));
        sort::sort_stable(&mut round[first..], &|a, b| a.parameter_on_side().total_cmp(&b.parameter_on_side()));
        if side >= 2 {
            round[first..].reverse();
        }
    }
    let count = round.len();
    for (k, &from) in round.iter().enumerate().filter(|(_, mark)| mark.is_entry()) {
        let to = round[(k + if middle { 1 } else { count - 1 }) % count];
        add(MarkedArc { start_mark: from, end_mark: to, graph: None });
    }
}

impl<const M: usize> CellPartWithMarks<M> {
    /// The four quarters: low u and low v, low u and high v, high u and low v, high u and high v.
    fn into_quarters(self, keys: &mut InnerMarkKeyGenerator) -> [CellPartWithMarks<M>; 4] {
        let half = 0.5 * self.size;
        let middle = self.low_corner + half;
        // The signs at the middles of sides: the sign at the start, changed by each mark before the
        // middle.
        let amid: [bool; SIDES_PER_CELL] = std::array::from_fn(|side| {
            let before = |mark: &&SignChangeMark| mark.side == side && mark.parameter_on_side() < middle[side % 2];
            self.corners[CORNERS_OF_SIDES[side][0]] ^ (self.marks.iter().filter(before).count() % 2 == 1)
        });
        let fields = self.field.quarters();
        let centre = counts_as_positive(fields[0].coefficients[M - 1][M - 1]);
        let [c00, c01, c10, c11] = self.corners;
        let corners = [
            [c00, amid[3], amid[0], centre],
            [amid[3], c01, centre, amid[2]],
            [amid[0], centre, c10, amid[1]],
            [centre, amid[2], amid[1], c11],
        ];
        let mut marks: [Vec<SignChangeMark>; 4] = std::array::from_fn(|_| Vec::new());
        for mark in self.marks {
            let high = mark.parameter_on_side() >= middle[mark.side % 2];
            marks[[[0, 2], [2, 3], [1, 3], [0, 1]][mark.side][usize::from(high)]].push(mark);
        }
        // The lines between the parts, as (part before, part after, side of the part before).
        for (low, high, side) in [(0, 2, 1), (1, 3, 1), (0, 1, 2), (2, 3, 2)] {
            let along = side % 2;
            let c: [f64; M] = match side {
                1 => fields[low].coefficients[M - 1],
                _ => fields[low].coefficients.map(|row| row[M - 1]),
            };
            let start = if low == 0 { self.low_corner[along] } else { middle[along] };
            let ends = CORNERS_OF_SIDES[side].map(|corner| corners[low][corner]);
            find_sign_changes(&c, ends, |crossing| {
                let mut at = middle;
                at[along] = start + half * crossing.side_parameter;
                let mark = SignChangeMark { key: keys.next_key(), parameters: at, side, rising: crossing.rising };
                marks[low].push(mark);
                marks[high].push(SignChangeMark { side: (side + 2) % SIDES_PER_CELL, ..mark });
            });
        }
        std::array::from_fn(|quarter| CellPartWithMarks {
            field: fields[quarter],
            marks: std::mem::take(&mut marks[quarter]),
            corners: corners[quarter],
            low_corner: self.low_corner + half * DVec2::new((quarter / 2) as f64, (quarter % 2) as f64),
            size: half,
        })
    }
}
