//! Flattening: the visible nets of a scene joined to one, in the space of the scene, and the
//! inverse. O(entries + instances + nodes).

use super::arena::Scene;
use super::instances::Instance;
use crate::chunks::{lines_per_block, zip3};
use crate::join::{JoinOptions, first_lines_of_nets, interpolate_inner_rows, join_nets_to_be_transformed};
use crate::transform::is_orientation_reversing;
use crate::{Direction, Net, Real, XyzMatrices, each};
use glam::{DAffine3, DVec3};
use gusset_base::alloc;
use gusset_base::error::{Error, Result};
use gusset_base::job::Job;
use gusset_base::par;
use std::sync::Arc;

impl Scene {
    /// Joins the nets of all visible instances, in order, into one net in the space of the scene.
    /// Nets whose transforms mirror are flipped along the side where face orientations would
    /// differ, as if `options.turn` were true. O(entries + instances + nodes).
    ///
    /// [`Net::split_all`] and [`Scene::from_flat_net`] are the inverse. They return the nets in the
    /// space of the scene, bit for bit if the transforms are the identity.
    ///
    /// # Errors
    /// [`Error::EmptyScene`] if all nets are hidden, and the errors of [`Scene::instances`] and
    /// [`concatenate`](crate::concatenate).
    pub fn flatten(&self, options: &JoinOptions, job: &Job<'_>) -> Result<Net<'static>> {
        let mut instances = self.instances(&job.sub_job(0.0, 0.2))?;
        instances.retain(|instance| instance.visible && self.net(instance.entry).is_ok());
        if instances.is_empty() {
            return Err(Error::EmptyScene);
        }
        let nets = alloc::try_collect(instances.iter().map(|instance| Ok(&**self.net(instance.entry)?)))?;
        let is_mirrored =
            |instance: &Instance| instance.world.is_finite() && is_orientation_reversing(instance.world.matrix3);
        let mirrored = alloc::collect(instances.iter().map(is_mirrored))?;
        let options = JoinOptions { turn: true, ..*options };
        let mut net = join_nets_to_be_transformed(&nets, &mirrored, &options, &job.sub_job(0.2, 0.8))?;
        if instances.iter().any(|instance| instance.world != DAffine3::IDENTITY) {
            let starts = first_lines_of_nets(nets.iter().map(|net| net.shape()), options.direction, options.rows)?;
            let world = |k: usize| instances[k].world;
            each!(net.coordinates_mut(), planes => transform_nets(planes, options.direction, &starts, world, job))?;
            interpolate_inner_rows(&mut net, &job.sub_job(0.9, 1.0))?;
        }
        job.step(1.0, "nodes")?;
        Ok(net)
    }

    /// Creates a scene of the nets from which a flat net was joined, in one group. O(nodes).
    ///
    /// # Errors
    /// The errors of [`Net::split_all`].
    pub fn from_flat_net(net: &Net<'_>, direction: Direction, job: &Job<'_>) -> Result<Scene> {
        let mut scene = Scene::new();
        let group = scene.add_group()?;
        for net in net.split_all(direction, job)? {
            let child = scene.add_net(Arc::new(net))?;
            scene.add_child(group, child)?;
        }
        Ok(scene)
    }
}

/// Transforms each net k, between `starts[k]` and `starts[k + 1]` in the direction including the
/// inner rows after it, in double precision. Nodes of equal bits keep equal bits.
fn transform_nets<T: Real>(
    planes: &mut XyzMatrices<'static, T>,
    direction: Direction,
    starts: &[usize],
    world: impl Fn(usize) -> DAffine3 + Sync,
    job: &Job<'_>,
) -> Result<()> {
    let columns = planes.shape().columns();
    let height = lines_per_block(columns);
    let blocks = zip3(planes.matrices_mut().map(|matrix| matrix.chunks_mut(height * columns)));
    let threads = if blocks.len() < 4 { 1 } else { job.requested_threads() };
    par::map(threads, blocks.enumerate(), |(block, [x, y, z])| {
        let rows = x.chunks_mut(columns).zip(y.chunks_mut(columns)).zip(z.chunks_mut(columns));
        for (i, ((x, y), z)) in (block * height..).zip(rows) {
            match direction {
                Direction::Down => move_nodes(x, y, z, world(starts.partition_point(|&start| start <= i) - 1)),
                Direction::Right => {
                    for (k, ends) in starts.windows(2).enumerate() {
                        let here = ends[0]..ends[1].min(columns);
                        move_nodes(&mut x[here.clone()], &mut y[here.clone()], &mut z[here], world(k));
                    }
                }
            }
        }
    })?;
    Ok(())
}

fn move_nodes<T: Real>(x: &mut [T], y: &mut [T], z: &mut [T], map: DAffine3) {
    if map == DAffine3::IDENTITY {
        return;
    }
    for ((x, y), z) in x.iter_mut().zip(y).zip(z) {
        let p = DVec3::new((*x).into(), (*y).into(), (*z).into());
        let q = map.transform_point3(p);
        (*x, *y, *z) = (T::from_f64(q.x), T::from_f64(q.y), T::from_f64(q.z));
    }
}
