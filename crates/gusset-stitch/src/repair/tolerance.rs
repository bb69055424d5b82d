//! The tolerance that the data call for: how far apart two copies of one vertex can be that were
//! rounded apart.
//!
//! Two causes, and the larger counts:
//!
//! * **The scalar type.** [`ULPS`] units in the last place of the largest coordinate: 2^-19 of its
//!   magnitude for 32 bits, 2^-48 for 64. In 32 bits this covers what was written with seven
//!   significant digits, whatever the first one is: sqrt 3 units of 1e-6.
//! * **The digits that the data show**, where files had fewer than the type holds. Decimal step u =
//!   10^p is shown if at least a third of the coordinates that are no round numbers are its
//!   multiples, up to what rounding did to them; the coarsest counts. Of numbers with a further
//!   digit a tenth are multiples by chance. Looked at are the coordinates of the largest decade,
//!   where significant digits and decimals have the same step, and the differences of successive
//!   ones, which shifting leaves alone. Round numbers, the multiples of 1e-4 of the size, show
//!   nothing: a coarse grid is meant. Two copies rounded to neighbouring steps are u apart along
//!   each axis, sqrt 3 u in space; 2 u are taken, as conversions round too.
//!
//! **No edge collapses**: each vertex has a reach, the tolerance, but at most [`MAX_EDGE_SHARE`] of
//! the shortest edge that ends there. What is within the reach of one vertex, and it within theirs,
//! is half that edge apart at most. O(V + H) time.

use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::Aabb;
use gusset_base::geom::scale::distance;
use gusset_base::job::Job;
use gusset_mesh::{MeshView, Scalar, half_edges};

/// What computing can be off by, in units in the last place of the largest coordinate.
const ULPS: f64 = 16.0;

/// The share of the shortest edge at a vertex that its reach may be.
const MAX_EDGE_SHARE: f64 = 0.25;

/// How many decimal places below the first digit of the size the coarsest step is that counts as
/// a matter of rounding.
const FIRST_PLACE: i32 = 5;

/// Powers of ten up to this exponent are exact.
const MAX_EXACT_POWER: i32 = 22;

/// Coordinates that are no round numbers show something from this count on.
const MIN_COUNT: usize = 8;

/// The largest decade has at least this share of the coordinates: others are outliers.
const MIN_DECADE_SHARE: usize = 64;

/// Decades told apart below the largest coordinate's.
const DECADES: usize = 8;

/// Steps told apart.
const STEPS: usize = 16;

/// Vertices, or faces, between two progress reports.
const REPORT_INTERVAL: usize = 1 << 16;

const STAGE: &str = "tolerance";

/// Where the tolerance is from.
#[derive(Debug, Clone, Copy)]
pub(super) enum Source {
    /// The data call for it.
    Data,
    /// The data called for it before.
    Found(f64),
    /// The caller gave it, finite and not negative: it holds for short edges too.
    Given(f64),
}

/// How far apart vertices that lie together may be.
pub(super) struct Tolerance {
    /// The largest distance; 0 for equal positions.
    pub(super) length: f64,
    /// Per member, the largest distance from it; empty for equal positions.
    pub(super) reach: Vec<f64>,
}

impl Tolerance {
    /// The tolerance for `members`, which have finite positions.
    pub(super) fn of(mesh: &MeshView<'_>, members: &[u32], source: Source, job: &Job<'_>) -> Result<Self> {
        let length = match source {
            Source::Data => round_off(mesh, members, &job.part(0.0, 0.5))?,
            Source::Found(length) | Source::Given(length) => length,
        };
        let reach = match source {
            _ if length == 0.0 => Vec::new(),
            Source::Given(_) => alloc::filled(length, members.len())?,
            Source::Data | Source::Found(_) => {
                let edges = shortest_edges(mesh, members, &job.part(0.5, 1.0))?;
                alloc::collect(members.iter().map(|&v| length.min(MAX_EDGE_SHARE * edges[v as usize])))?
            }
        };
        Ok(Tolerance { length, reach })
    }
}

/// How far two copies of one vertex can be apart.
fn round_off(mesh: &MeshView<'_>, members: &[u32], job: &Job<'_>) -> Result<f64> {
    let at = |v: u32| mesh.positions().get(v);
    let whole = Aabb::from_points(members.iter().map(|&v| at(v)));
    if whole.is_empty() {
        return Ok(0.0);
    }
    let size = whole.low.abs().max(whole.high.abs()).max_element();
    let unit_round_off = match mesh.positions().scalar() {
        Scalar::F32 => f64::from(f32::EPSILON) / 2.0,
        Scalar::F64 => f64::EPSILON / 2.0,
    };
    let by_type = ULPS * 2.0 * unit_round_off * size;
    let extent = whole.size().max_element();
    let Some(steps) = Steps::new(extent, unit_round_off) else { return Ok(by_type) };
    let mut decades = Decades::new(size);
    for (i, &v) in members.iter().enumerate() {
        job.step_every(REPORT_INTERVAL, i, 2 * members.len(), STAGE)?;
        at(v).to_array().iter().for_each(|&x| decades.count(x));
    }
    let largest = decades.largest(3 * members.len());
    let (mut coordinates, mut differences) = (Histogram::default(), Histogram::default());
    for (i, &v) in members.iter().enumerate() {
        job.step_every(REPORT_INTERVAL, members.len() + i, 2 * members.len(), STAGE)?;
        let before = at(members[i.saturating_sub(1)]);
        for (x, y) in at(v).to_array().into_iter().zip(before.to_array()) {
            if Some(decades.of(x)) == largest {
                coordinates.enter(steps.of(x, x.abs()));
            }
            differences.enter(steps.of(x - y, x.abs() + y.abs()));
        }
    }
    let shown = [coordinates, differences].iter().filter_map(Histogram::shown).min();
    Ok(shown.map_or(by_type, |step| by_type.max(2.0 * steps.length(step))))
}

/// Decimal steps in descending order.
struct Steps {
    /// The exponent of the first.
    first: i32,
    /// The relative error of a coordinate: of its conversion, and of a change of unit.
    error: f64,
}

/// What is known of a coordinate.
#[derive(Clone, Copy)]
enum Shown {
    /// It is a multiple of coarser steps too.
    Round,
    /// The coarsest step that it is a multiple of.
    Step(usize),
    /// It has digits wherever it can be seen.
    All,
}

impl Steps {
    /// None if powers of ten of this size are not exact.
    fn new(extent: f64, unit_round_off: f64) -> Option<Self> {
        let first = decade(extent)? - FIRST_PLACE;
        ((first + 1).abs() <= MAX_EXACT_POWER).then_some(Steps { first, error: 2.0 * unit_round_off })
    }

    fn length(&self, step: usize) -> f64 {
        let exponent = self.first - step as i32;
        if exponent < 0 { 1.0 / 10f64.powi(-exponent) } else { 10f64.powi(exponent) }
    }

    /// What `x` shows, which was made from coordinates of magnitude `size`.
    fn of(&self, x: f64, size: f64) -> Shown {
        let error = self.error * size;
        for k in 0..=STEPS {
            let exponent = self.first + 1 - k as i32;
            let power = 10f64.powi(exponent.abs());
            let [x, error] = [x, error].map(|x| if exponent < 0 { x * power } else { x / power });
            // Farther on one in four is a multiple by chance, or the power is not exact.
            if error > 0.125 || exponent < -MAX_EXACT_POWER {
                return Shown::All;
            }
            if (x - x.round()).abs() <= error {
                return if k == 0 { Shown::Round } else { Shown::Step(k - 1) };
            }
        }
        Shown::All
    }
}

/// How many coordinates show what.
#[derive(Default)]
struct Histogram {
    steps: [usize; STEPS],
    others: usize,
}

impl Histogram {
    fn enter(&mut self, shown: Shown) {
        match shown {
            Shown::Round => {}
            Shown::Step(step) => self.steps[step] += 1,
            Shown::All => self.others += 1,
        }
    }

    /// The coarsest step that a third are multiples of.
    fn shown(&self) -> Option<usize> {
        let count = self.others + self.steps.iter().sum::<usize>();
        let mut multiples = 0;
        self.steps.iter().position(|&more| {
            multiples += more;
            count >= MIN_COUNT && 3 * multiples >= count
        })
    }
}

/// How many coordinates there are of each order of magnitude.
struct Decades {
    first: i32,
    counts: [usize; DECADES],
}

impl Decades {
    fn new(size: f64) -> Self {
        Decades { first: decade(size).unwrap_or(0), counts: [0; DECADES] }
    }

    /// The place of a number's decade; [`DECADES`] if it is below all.
    fn of(&self, x: f64) -> usize {
        decade(x.abs()).map_or(DECADES, |exponent| DECADES.min((self.first - exponent).max(0) as usize))
    }

    fn count(&mut self, x: f64) {
        let decade = self.of(x);
        if let Some(count) = self.counts.get_mut(decade) {
            *count += 1;
        }
    }

    /// The largest that is not one of outliers, among `total` coordinates.
    fn largest(&self, total: usize) -> Option<usize> {
        self.counts.iter().position(|&count| count >= MIN_COUNT.max(total / MIN_DECADE_SHARE))
    }
}

/// The exponent of the largest power of ten that does not exceed a number above 0, up to the
/// rounding of that power.
fn decade(x: f64) -> Option<i32> {
    // A power of ten that a change of unit has rounded down is still one.
    (x > 0.0 && x.is_finite()).then(|| (libm::log10(x) + 1e-9).floor() as i32)
}

/// Per vertex, the length of the shortest edge that ends there and has a length; infinite if there
/// is none, and 0 for others than members.
fn shortest_edges(mesh: &MeshView<'_>, members: &[u32], job: &Job<'_>) -> Result<Vec<f64>> {
    let mut shortest: Vec<f64> = alloc::filled(0.0, mesh.positions().len())?;
    members.iter().for_each(|&v| shortest[v as usize] = f64::INFINITY);
    let faces = mesh.faces().len();
    for f in 0..faces {
        job.step_every(REPORT_INTERVAL, f, faces, STAGE)?;
        for (_, u, v) in half_edges(mesh, f) {
            if shortest[u as usize].max(shortest[v as usize]) == 0.0 {
                continue;
            }
            let length = distance(mesh.positions().get(u), mesh.positions().get(v));
            if length > 0.0 {
                for end in [u, v] {
                    shortest[end as usize] = shortest[end as usize].min(length);
                }
            }
        }
    }
    Ok(shortest)
}
