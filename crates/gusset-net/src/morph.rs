//! Morphs: nets between two nets of equal shape and gluing (Deryagin, "animation transformations").
//!
//! The path of a node depends only on its two positions and the time. Nodes that are equal in both
//! nets, such as glued ones, therefore stay equal bit for bit. O(nodes).

use super::{Net, NodeClasses, Real, each};
use glam::{DMat3, DVec3};
use gusset_base::choices;
use gusset_base::error::{Error, Result};
use gusset_base::geom::rotation::{fraction_of_rotation, rotation_maximising_trace};
use gusset_base::geom::scale::common_unit;
use gusset_base::job::Job;

/// The paths of the nodes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum MorphPath {
    /// Straight: (1 - t) a + t b.
    #[default]
    Linear,
    /// The best-fitting rotation between the nets turns at a uniform rate, and the remaining motion
    /// is straight in the turning frame.
    Rigid,
}

choices! { for MorphPath:
    Linear => "Straight", "Each vertex moves on a straight line.";
    Rigid => "With rotation", "The rotation that fits best is uniform, and the rest is straight in the rotating frame.";
}

/// Returns the net between `a` and `b` at the time `t`, from 0 to 1. At 0 it has the bits of `a`,
/// at 1 the bits of `b`. A node that is missing in either is missing in between. Gluing, bridges
/// and their properties come from `a`.
///
/// For [`MorphPath::Rigid`], let ma and mb be the means of the nodes that both nets have, and R the
/// rotation that minimises the sum of |R (a - ma) - (b - mb)|^2. Nodes are at (1 - t) ma + t mb +
/// R^t ((1 - t) (a - ma) + t R^-1 (b - mb)). If b is a rigid motion of a, so is every net between.
/// If two rotations fit equally well, as half a turn in either sense, the choice is fixed.
///
/// # Errors
/// [`Error::OptionOutOfRange`] for a time outside 0 to 1, [`Error::SidesDiffer`] with the rows or
/// the columns, [`Error::MixedScalars`], [`Error::GluingsDiffer`], [`Error::OutOfMemory`],
/// [`Error::Cancelled`].
pub fn morph(a: &Net<'_>, b: &Net<'_>, t: f64, path: MorphPath, job: &Job<'_>) -> Result<Net<'static>> {
    Error::require((0.0..=1.0).contains(&t), "t", t, "from 0 to 1")?;
    check_compatible_nets(a, b)?;
    job.step(0.0, "morph")?;
    let mut made = a.copied()?;
    if t == 0.0 {
        return Ok(made);
    }
    let way = MorphMotion::new(a, b, t, path, &job.sub_job(0.0, 0.3))?;
    let (shape, job) = (a.shape(), job.sub_job(0.3, 1.0));
    each!(made.coordinates_mut(), planes => {
        for i in 0..shape.rows() {
            job.step_every((1 << 16) / shape.columns() + 1, i, shape.rows(), "morph")?;
            way.move_nodes_of_row(b, i, planes.row_mut(i));
        }
    });
    Ok(made)
}

/// Checks that two nets have the same shape, type and gluing.
fn check_compatible_nets(a: &Net<'_>, b: &Net<'_>) -> Result<()> {
    let sizes = [a, b].map(|net| [net.shape().rows() as u32, net.shape().columns() as u32]);
    if let Some(k) = (0..2).find(|&k| sizes[0][k] != sizes[1][k]) {
        return Err(Error::SidesDiffer { a: sizes[0][k], b: sizes[1][k] });
    }
    if a.coordinates().scalar() != b.coordinates().scalar() {
        return Err(Error::MixedScalars);
    }
    let [first, second] = [NodeClasses::new(a.topology())?, NodeClasses::new(b.topology())?];
    let differ = |&node: &u32| first.representative(node) != second.representative(node);
    match (0..a.shape().node_count() as u32).find(differ) {
        Some(node) => Err(Error::GluingsDiffer { node }),
        None if a.topology().is_reversed() != b.topology().is_reversed() => Err(Error::NetsOpposed),
        None => Ok(()),
    }
}

/// The means of two nets, and the rotations of the first and the second net at a time.
struct MorphMotion {
    t: f64,
    /// A power of two in which products of coordinates are in range.
    unit: f64,
    /// In units of `unit`.
    means: [DVec3; 2],
    /// R^t and R^(t - 1); `None` on straight paths.
    rotations: Option<[DMat3; 2]>,
}

impl MorphMotion {
    fn new(a: &Net<'_>, b: &Net<'_>, t: f64, path: MorphPath, job: &Job<'_>) -> Result<Self> {
        if path == MorphPath::Linear {
            return Ok(MorphMotion { t, unit: 1.0, means: [DVec3::ZERO; 2], rotations: None });
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
        let turn = rotation_maximising_trace(covariance);
        let part = |t: f64| DMat3::from_quat(fraction_of_rotation(turn, t));
        Ok(MorphMotion { t, unit, means, rotations: Some([part(t), part(t - 1.0)]) })
    }

    /// Moves the nodes of a row of the first net.
    fn move_nodes_of_row<T: Real>(&self, b: &Net<'_>, i: usize, row: [&mut [T]; 3]) {
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
            (*x, *y, *z) = (T::from_f64(at.x), T::from_f64(at.y), T::from_f64(at.z));
        }
    }
}
