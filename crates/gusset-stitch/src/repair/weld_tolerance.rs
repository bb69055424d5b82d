//! The default tolerance: the largest distance between two copies of one vertex that rounding can
//! explain.
//!
//! Two causes are considered, and the larger applies:
//!
//! * **The scalar type**: [`ROUND_OFF_ULPS`] units in the last place of the largest coordinate,
//!   which is 2^-19 of its magnitude for 32 bits and 2^-48 for 64. In 32 bits this covers numbers
//!   written with seven significant digits, for any first digit: sqrt 3 units of 1e-6.
//! * **The visible digits**, for files with fewer digits than the type holds. A decimal step u =
//!   10^p is visible if at least a third of the non-round coordinates are multiples of u, up to
//!   rounding. The coarsest visible step applies. With one more digit, a tenth are multiples by
//!   chance. The test uses the coordinates of the largest decade, in which significant digits and
//!   decimals have the same step. It also uses the differences of successive coordinates, which are
//!   invariant under translation. Round numbers, the multiples of 1e-4 of the size, are ignored:
//!   they come from coarse grids. Two copies rounded to neighbouring steps are u apart along each
//!   axis, and sqrt 3 u in space. The tolerance is 2 u, because conversions round too.
//!
//! **Edges do not collapse**: the reach of each vertex is the tolerance, limited to
//! [`MAX_REACH_TO_EDGE_RATIO`] of the shortest edge at the vertex. Vertices within mutual reach are
//! at most half that edge apart. If edges may collapse, edges within the rounding of the scalar type
//! are not counted. O(V + H) time.

use gusset_base::alloc;
use gusset_base::error::{Error, Result};
use gusset_base::geom::Aabb;
use gusset_base::geom::scale::overflow_safe_distance;
use gusset_base::job::Job;
use gusset_mesh::{MeshView, Scalar, half_edges};

/// Round-off of computations, in units in the last place of the largest coordinate.
const ROUND_OFF_ULPS: f64 = 16.0;

/// Largest reach of a vertex, relative to the shortest edge at the vertex.
const MAX_REACH_TO_EDGE_RATIO: f64 = 0.25;

/// Number of decimal places from the first digit of the size to the coarsest step that may be
/// rounding.
const DECIMAL_PLACES_TO_FIRST_STEP: i32 = 5;

/// Powers of ten are exact up to this exponent.
const MAX_EXACT_POWER: i32 = 22;

/// Smallest number of non-round coordinates that can show a step.
const MIN_NON_ROUND_COORDINATES: usize = 8;

/// The largest decade has at least one in this number of coordinates; larger coordinates are
/// outliers.
const OUTLIER_SHARE_DIVISOR: usize = 64;

/// Number of decades below the largest coordinate that are distinguished.
const DECADE_COUNT: usize = 8;

/// Number of steps that are distinguished.
const DECIMAL_STEP_COUNT: usize = 16;

/// Number of vertices, or faces, between two progress reports.
const ELEMENTS_PER_REPORT: usize = 1 << 16;

const STAGE: &str = "tolerance";

/// The source of the tolerance.
#[derive(Debug, Clone, Copy)]
pub(super) enum ToleranceSource {
    /// Derived from the data.
    Data,
    /// Derived from the data in an earlier pass.
    Earlier(f64),
    /// Given by the caller, finite and not negative. It is not limited at short edges.
    Given(f64),
}

impl ToleranceSource {
    /// Returns the given tolerance, or the one by the data.
    ///
    /// # Errors
    /// [`Error::OptionOutOfRange`] for a tolerance that is negative or not finite.
    pub(super) fn from_option(tolerance: Option<f64>) -> Result<Self> {
        let given = tolerance.unwrap_or(0.0);
        Error::require((0.0..f64::INFINITY).contains(&given), "tolerance", given, "finite and at least 0")?;
        Ok(tolerance.map_or(ToleranceSource::Data, ToleranceSource::Given))
    }
}

/// The largest distance between coincident vertices.
pub(super) struct WeldDistances {
    /// The largest distance; 0 for equal positions.
    pub(super) max_distance: f64,
    /// For each member, the largest distance from it; empty for equal positions.
    pub(super) max_distance_of_member: Vec<f64>,
}

impl WeldDistances {
    /// Finds the tolerance for `members`, which have finite positions. `collapse` allows edges to
    /// collapse.
    pub(super) fn find_for_members(
        mesh: &MeshView<'_>,
        members: &[u32],
        source: ToleranceSource,
        collapse: bool,
        job: &Job<'_>,
    ) -> Result<Self> {
        let length = match source {
            ToleranceSource::Data => coordinate_round_off(mesh, members, &job.sub_job(0.0, 0.5))?,
            ToleranceSource::Earlier(length) | ToleranceSource::Given(length) => length,
        };
        let reach = match source {
            _ if length == 0.0 => Vec::new(),
            ToleranceSource::Given(_) => alloc::filled(length, members.len())?,
            ToleranceSource::Data | ToleranceSource::Earlier(_) => {
                limited_reach(mesh, members, length, collapse, &job.sub_job(0.5, 1.0))?
            }
        };
        Ok(WeldDistances { max_distance: length, max_distance_of_member: reach })
    }
}

/// Returns the reach of each member, limited at short edges. If edges may collapse, edges within the
/// rounding of the scalar type do not limit it.
pub(super) fn limited_reach(
    mesh: &MeshView<'_>,
    members: &[u32],
    length: f64,
    collapse: bool,
    job: &Job<'_>,
) -> Result<Vec<f64>> {
    let min = if collapse { type_round_off(mesh, members).1 } else { 0.0 };
    let edges = shortest_edge_lengths(mesh, members, min, job)?;
    alloc::collect(members.iter().map(|&v| length.min(MAX_REACH_TO_EDGE_RATIO * edges[v as usize])))
}

/// Returns the bounding box of vertices, and the rounding of the scalar type at the largest coordinate.
fn type_round_off(mesh: &MeshView<'_>, members: &[u32]) -> (Aabb, f64) {
    let whole = Aabb::from_points(members.iter().map(|&v| mesh.positions().get(v)));
    let size = if whole.is_empty() { 0.0 } else { whole.low.abs().max(whole.high.abs()).max_element() };
    (whole, ROUND_OFF_ULPS * 2.0 * unit_round_off(mesh) * size)
}

fn unit_round_off(mesh: &MeshView<'_>) -> f64 {
    match mesh.positions().scalar() {
        Scalar::F32 => f64::from(f32::EPSILON) / 2.0,
        Scalar::F64 => f64::EPSILON / 2.0,
    }
}

/// Returns the largest distance between two copies of one vertex that rounding can explain.
pub(crate) fn coordinate_round_off(mesh: &MeshView<'_>, members: &[u32], job: &Job<'_>) -> Result<f64> {
    let at = |v: u32| mesh.positions().get(v);
    let (whole, by_type) = type_round_off(mesh, members);
    if whole.is_empty() {
        return Ok(0.0);
    }
    let size = whole.low.abs().max(whole.high.abs()).max_element();
    let extent = whole.size().max_element();
    let Some(steps) = CoordinateDecimals::new(extent, unit_round_off(mesh)) else { return Ok(by_type) };
    let mut decades = DecadeCounts::new(size);
    for (i, &v) in members.iter().enumerate() {
        job.step_every(ELEMENTS_PER_REPORT, i, 2 * members.len(), STAGE)?;
        at(v).to_array().iter().for_each(|&x| decades.count_number(x));
    }
    let largest = decades.largest_usual_decade(3 * members.len());
    let (mut coordinates, mut differences) = (DigitHistogram::default(), DigitHistogram::default());
    for (i, &v) in members.iter().enumerate() {
        job.step_every(ELEMENTS_PER_REPORT, members.len() + i, 2 * members.len(), STAGE)?;
        let before = at(members[i.saturating_sub(1)]);
        for (x, y) in at(v).to_array().into_iter().zip(before.to_array()) {
            if Some(decades.decade_index(x)) == largest {
                coordinates.count_coordinate(steps.classify_digits(x, x.abs()));
            }
            differences.count_coordinate(steps.classify_digits(x - y, x.abs() + y.abs()));
        }
    }
    let shown = [coordinates, differences].iter().filter_map(DigitHistogram::finest_visible_step).min();
    Ok(shown.map_or(by_type, |step| by_type.max(2.0 * steps.power_of_ten_of_step(step))))
}

/// The powers of ten to which coordinates may have been rounded, in descending order.
struct CoordinateDecimals {
    /// The exponent of the first step.
    first_exponent: i32,
    /// The relative error of a coordinate, due to conversions and a change of unit.
    relative_error: f64,
}

/// The digits of a coordinate.
#[derive(Clone, Copy)]
enum ShownDigits {
    /// It is a multiple of coarser steps too.
    Round,
    /// The coarsest step that it is a multiple of.
    Step(usize),
    /// It has digits at all visible places.
    AllDigits,
}

impl CoordinateDecimals {
    /// Returns `None` if powers of ten of this size are not exact.
    fn new(extent: f64, unit_round_off: f64) -> Option<Self> {
        let first = decade_exponent(extent)? - DECIMAL_PLACES_TO_FIRST_STEP;
        ((first + 1).abs() <= MAX_EXACT_POWER)
            .then_some(CoordinateDecimals { first_exponent: first, relative_error: 2.0 * unit_round_off })
    }

    fn power_of_ten_of_step(&self, step: usize) -> f64 {
        let exponent = self.first_exponent - step as i32;
        if exponent < 0 { 1.0 / 10f64.powi(-exponent) } else { 10f64.powi(exponent) }
    }

    /// Classifies `x`, which was computed from coordinates of magnitude `size`.
    fn classify_digits(&self, x: f64, size: f64) -> ShownDigits {
        let error = self.relative_error * size;
        for k in 0..=DECIMAL_STEP_COUNT {
            let exponent = self.first_exponent + 1 - k as i32;
            let power = 10f64.powi(exponent.abs());
            let [x, error] = [x, error].map(|x| if exponent < 0 { x * power } else { x / power });
            // Beyond this, one number in four is a multiple by chance, or the power is not exact.
            if error > 0.125 || exponent < -MAX_EXACT_POWER {
                return ShownDigits::AllDigits;
            }
            if (x - x.round()).abs() <= error {
                return if k == 0 { ShownDigits::Round } else { ShownDigits::Step(k - 1) };
            }
        }
        ShownDigits::AllDigits
    }
}

/// The number of coordinates of each class.
#[derive(Default)]
struct DigitHistogram {
    counts_by_step: [usize; DECIMAL_STEP_COUNT],
    other_count: usize,
}

impl DigitHistogram {
    fn count_coordinate(&mut self, shown: ShownDigits) {
        match shown {
            ShownDigits::Round => {}
            ShownDigits::Step(step) => self.counts_by_step[step] += 1,
            ShownDigits::AllDigits => self.other_count += 1,
        }
    }

    /// Returns the coarsest step of which a third of the coordinates are multiples.
    fn finest_visible_step(&self) -> Option<usize> {
        let count = self.other_count + self.counts_by_step.iter().sum::<usize>();
        let mut multiples = 0;
        self.counts_by_step.iter().position(|&more| {
            multiples += more;
            count >= MIN_NON_ROUND_COORDINATES && 3 * multiples >= count
        })
    }
}

/// The number of coordinates of each order of magnitude.
struct DecadeCounts {
    first_exponent: i32,
    counts: [usize; DECADE_COUNT],
}

impl DecadeCounts {
    fn new(size: f64) -> Self {
        DecadeCounts { first_exponent: decade_exponent(size).unwrap_or(0), counts: [0; DECADE_COUNT] }
    }

    /// Returns the index of a number's decade; [`DECADE_COUNT`] if it is below all.
    fn decade_index(&self, x: f64) -> usize {
        decade_exponent(x.abs())
            .map_or(DECADE_COUNT, |exponent| DECADE_COUNT.min((self.first_exponent - exponent).max(0) as usize))
    }

    fn count_number(&mut self, x: f64) {
        let decade = self.decade_index(x);
        if let Some(count) = self.counts.get_mut(decade) {
            *count += 1;
        }
    }

    /// Returns the largest decade that does not consist of outliers, among `total` coordinates.
    fn largest_usual_decade(&self, total: usize) -> Option<usize> {
        self.counts.iter().position(|&count| count >= MIN_NON_ROUND_COORDINATES.max(total / OUTLIER_SHARE_DIVISOR))
    }
}

/// Returns the exponent of the largest power of ten that does not exceed a positive number, up to
/// rounding of that power.
fn decade_exponent(x: f64) -> Option<i32> {
    // A power of ten that a change of unit rounded down still counts.
    (x > 0.0 && x.is_finite()).then(|| (libm::log10(x) + 1e-9).floor() as i32)
}

/// Returns for each vertex the length of the shortest edge at it that is longer than `min`. It is
/// infinite without such edges, and 0 for vertices that are not members.
pub(super) fn shortest_edge_lengths(mesh: &MeshView<'_>, members: &[u32], min: f64, job: &Job<'_>) -> Result<Vec<f64>> {
    let mut shortest: Vec<f64> = alloc::filled(0.0, mesh.positions().len())?;
    members.iter().for_each(|&v| shortest[v as usize] = f64::INFINITY);
    let faces = mesh.faces().len();
    for f in 0..faces {
        job.step_every(ELEMENTS_PER_REPORT, f, faces, STAGE)?;
        for (_, u, v) in half_edges(mesh, f) {
            if shortest[u as usize].max(shortest[v as usize]) == 0.0 {
                continue;
            }
            let length = overflow_safe_distance(mesh.positions().get(u), mesh.positions().get(v));
            if length > min {
                for end in [u, v] {
                    shortest[end as usize] = shortest[end as usize].min(length);
                }
            }
        }
    }
    Ok(shortest)
}
