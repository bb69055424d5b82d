//! Morphs: nets between two nets of one shape and gluing (Deryagin, "animation transformations").
//!
//! Every node goes its own way, as a function of its two positions and the time alone: nodes that are
//! equal in both nets, such as glued ones, stay equal bit for bit. O(nodes).

use super::{Classes, Net, Real, each};
use glam::{DMat3, DVec3};
use gusset_base::choices;
use gusset_base::error::{Error, Result};
use gusset_base::geom::rotation::{best_rotation, part_of};
use gusset_base::geom::scale::common_unit;
use gusset_base::job::Job;

/// The way of the nodes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum MorphPath {
    /// Straight: (1 - t) a + t b.
    #[default]
    Linear,
    /// The rotation between the nets that fits best is done at an even rate, and the rest of the way
    /// goes straight in the frame that turns.
    Rigid,
}

choices! { for MorphPath:
    Linear => "Straight", "Each vertex moves on a straight line.";
    Rigid => "With rotation", "The rotation that fits best is uniform, and the rest is straight in the rotating frame.";
}

/// The net at the time `t`, from 0 to 1, on the way from `a` to `b`: at 0 the bits of `a`, at 1 those
/// of `b`. A node that is missing in one of them is missing between. Gluing, bridges and their
/// properties are those of `a`.
///
/// Rigid: with the means m of the nodes that both nets have, and the rotation R for which the sum of
/// |R (a - ma) - (b - mb)|^2 is least, nodes are at (1 - t) ma + t mb + R^t ((1 - t) (a - ma) +
/// t R^-1 (b - mb)). If b is a moved rigidly, so is every net between. Of two rotations that fit as
/// well, as by half a turn one way and the other, one is taken always.
///
/// # Errors
/// [`Error::OptionOutOfRange`] for a time outside of 0 to 1, [`Error::SidesDiffer`] with the rows or
/// the columns, [`Error::MixedScalars`], [`Error::GluingsDiffer`], [`Error::OutOfMemory`],
/// [`Error::Cancelled`].
pub fn morph(a: &Net<'_>, b: &Net<'_>, t: f64, path: MorphPath, job: &Job<'_>) -> Result<Net<'static>> {
    Error::require((0.0..=1.0).contains(&t), "t", t)?;
    check(a, b)?;
    job.step(0.0, "morph")?;
    let mut made = a.copied()?;
    if t == 0.0 {
        return Ok(made);
    }
    let way = Way::new(a, b, t, path, &job.part(0.0, 0.3))?;
    let (shape, job) = (a.shape(), job.part(0.3, 1.0));
    each!(made.coordinates_mut(), planes => {
        for i in 0..shape.rows() {
            job.step_every((1 << 16) / shape.columns() + 1, i, shape.rows(), "morph")?;
            way.row(b, i, planes.row_mut(i));
        }
    });
    Ok(made)
}

/// That two nets have the same shape, type and gluing.
fn check(a: &Net<'_>, b: &Net<'_>) -> Result<()> {
    let sizes = [a, b].map(|net| [net.shape().rows() as u32, net.shape().columns() as u32]);
    if let Some(k) = (0..2).find(|&k| sizes[0][k] != sizes[1][k]) {
        return Err(Error::SidesDiffer { a: sizes[0][k], b: sizes[1][k] });
    }
    if a.coordinates().scalar() != b.coordinates().scalar() {
        return Err(Error::MixedScalars);
    }
    let [first, second] = [Classes::of(a.topology())?, Classes::of(b.topology())?];
    let differ = |&node: &u32| first.representative(node) != second.representative(node);
    match (0..a.shape().node_count() as u32).find(differ) {
        Some(node) => Err(Error::GluingsDiffer { node }),
        None if a.topology().is_reversed() != b.topology().is_reversed() => Err(Error::NetsOpposed),
        None => Ok(()),
    }
}

/// The means of two nets, and the rotations of the first and of the second at a time.
struct Way {
    t: f64,
    /// A power of two in which products of coordinates are in range.
    unit: f64,
    /// In the unit.
    means: [DVec3; 2],
    /// R^t and R^(t - 1); `None` on straight ways.
    rotations: Option<[DMat3; 2]>,
}

impl Way {
    fn new(a: &Net<'_>, b: &Net<'_>, t: f64, path: MorphPath, job: &Job<'_>) -> Result<Self> {
        if path == MorphPath::Linear {
            return Ok(Way { t, unit: 1.0, means: [DVec3::ZERO; 2], rotations: None });
        }
        let (nodes, job) = (a.shape().node_count() as u32, *job);
        let exist = |pair: &[DVec3; 2]| pair.iter().all(|p| p.is_finite());
        let given = || (0..nodes).map(|n| [a.position(n), b.position(n)]).filter(exist);
        let largest = given().flatten().fold(DVec3::ZERO, |most, p| most.max(p.abs()));
        let unit = common_unit([&largest]);
        let pairs = || given().map(|pair| pair.map(|p| p / unit));
        let (mut sums, mut count) = ([DVec3::ZERO; 2], 0.0);
        pairs().for_each(|[p, q]| (sums, count) = ([sums[0] + p, sums[1] + q], count + 1.0));
        job.step(0.5, "morph")?;
        let means = sums.map(|sum| if count > 0.0 { sum / count } else { DVec3::ZERO });
        let mut covariance = DMat3::ZERO;
        pairs().for_each(|[p, q]| {
            let (p, q) = (p - means[0], q - means[1]);
            covariance += DMat3::from_cols(p.x * q, p.y * q, p.z * q);
        });
        let turn = best_rotation(covariance);
        let part = |t: f64| DMat3::from_quat(part_of(turn, t));
        Ok(Way { t, unit, means, rotations: Some([part(t), part(t - 1.0)]) })
    }

    /// Moves the nodes of a row of the first net.
    fn row<T: Real>(&self, b: &Net<'_>, i: usize, row: [&mut [T]; 3]) {
        let (t, [x, y, z]) = (self.t, row);
        for (j, ((x, y), z)) in x.iter_mut().zip(y).zip(z).enumerate() {
            let (from, to) = (DVec3::new((*x).into(), (*y).into(), (*z).into()), b.get(i, j));
            let at = match self.rotations {
                _ if t == 1.0 => to,
                None => (1.0 - t) * from + t * to,
                Some([first, second]) => {
                    let mean = (1.0 - t) * self.means[0] + t * self.means[1];
                    let [from, to] = [from / self.unit - self.means[0], to / self.unit - self.means[1]];
                    (mean + (1.0 - t) * (first * from) + t * (second * to)) * self.unit
                }
            };
            (*x, *y, *z) = (T::of(at.x), T::of(at.y), T::of(at.z));
        }
    }
}
