//! One net of a scene, and back.

use super::{Content, Instance, Scene};
use crate::alloc;
use crate::error::{Error, Result};
use crate::job::Job;
use crate::net::join::{JoinOptions, join_mirrored};
use crate::net::transform::Affine;
use crate::net::{Coordinates, Direction, Net, Planes, Real};
use crate::par;
use glam::{DAffine3, DVec3};
use std::sync::Arc;

/// Nodes that one thread transforms at a time.
const BLOCK: usize = 1 << 15;

/// A scene as one net.
#[derive(Debug)]
pub struct Flattened {
    /// The nets of all visible instances, where they are in the space of the scene, with bridges between them.
    pub net: Net<'static>,
    /// For each of those nets in turn, the instance.
    pub instances: Vec<Instance>,
}

impl Scene {
    /// Joins the nets of all visible instances to one. Nets under transforms that mirror are flipped along the side where the
    /// others would be opposed to them; `options.turn` is taken to be true. O(entries + instances + nodes).
    ///
    /// [`Net::split_all`] and [`Scene::of_flat`] are the inverse: nets come back as they are in the space of the scene, bit for
    /// bit where transforms are the identity.
    ///
    /// # Errors
    /// [`Error::EmptyScene`] if no net is visible; those of [`Scene::instances`] and
    /// [`concatenate`](crate::net::concatenate).
    pub fn flatten(&self, options: &JoinOptions, job: &Job<'_>) -> Result<Flattened> {
        let mut instances = self.instances(&job.part(0.0, 0.2))?;
        instances.retain(|instance| instance.visible && self.net(instance.entry).is_ok());
        if instances.is_empty() {
            return Err(Error::EmptyScene);
        }
        let mut nets: Vec<&Net<'_>> = alloc::with_capacity(instances.len())?;
        for instance in &instances {
            nets.push(self.net(instance.entry)?);
        }
        let mirrors = |instance: &Instance| {
            let DAffine3 { matrix3, translation } = instance.world;
            let rows = [0, 1, 2].map(|k| matrix3.row(k).extend(translation[k]).to_array());
            Affine::new(rows).is_ok_and(|affine| affine.mirrors())
        };
        let mirrored = alloc::collect(instances.iter().map(mirrors))?;
        let options = JoinOptions { turn: true, ..*options };
        let mut net = join_mirrored(&nets, &mirrored, &options, &job.part(0.2, 0.8))?;
        if instances.iter().any(|instance| instance.world != DAffine3::IDENTITY) {
            let mut starts = alloc::with_capacity(nets.len() + 1)?;
            starts.push(0);
            for net in &nets {
                starts.push(starts[starts.len() - 1] + options.direction.extent(net.shape()).0);
            }
            let place = |k: usize| instances[k].world;
            match net.coordinates_mut() {
                Coordinates::F32(planes) => transform(planes, options.direction, &starts, place, job)?,
                Coordinates::F64(planes) => transform(planes, options.direction, &starts, place, job)?,
            }
        }
        job.step(1.0, "nodes")?;
        Ok(Flattened { net, instances })
    }

    /// A scene of the nets that a flat one was joined of, in one group. O(nodes).
    ///
    /// # Errors
    /// Those of [`Net::split_all`].
    pub fn of_flat(net: &Net<'_>, direction: Direction, job: &Job<'_>) -> Result<Scene> {
        let mut scene = Scene::new();
        let group = scene.add_group()?;
        for net in net.split_all(direction, job)? {
            let child = scene.add_net(Arc::new(net))?;
            scene.add_child(group, child)?;
        }
        Ok(scene)
    }

    /// The nets that are entries, each once, in order of their indices.
    pub fn nets(&self) -> impl Iterator<Item = (u32, &Arc<Net<'static>>)> {
        (0..).zip(&self.entries).filter_map(|(index, entry)| match &entry.as_ref()?.content {
            Content::Net(net) => Some((index, net)),
            Content::Group(_) => None,
        })
    }
}

/// Moves net k, which lies between `starts[k]` and `starts[k + 1]` in the direction, by its transform. Coordinates are computed in
/// double precision: nodes that are the same stay the same.
fn transform<T: Real>(
    planes: &mut Planes<'static, T>,
    direction: Direction,
    starts: &[usize],
    place: impl Fn(usize) -> DAffine3 + Sync,
    job: &Job<'_>,
) -> Result<()> {
    let shape = planes.shape();
    let (rows, columns) = (shape.rows(), shape.columns());
    let height = (BLOCK / columns).clamp(1, rows);
    let [x, y, z] = planes.matrices_mut().map(|matrix| matrix.chunks_mut(height * columns));
    let mut blocks = alloc::with_capacity(rows.div_ceil(height))?;
    blocks.extend(x.zip(y).zip(z).enumerate().map(|(k, ((x, y), z))| (k * height, [x, y, z])));
    let threads = if blocks.len() < 4 { 1 } else { job.threads() };
    par::map(threads, blocks.into_iter(), |(first, [x, y, z])| {
        let rows = x.chunks_mut(columns).zip(y.chunks_mut(columns)).zip(z.chunks_mut(columns));
        for (i, ((x, y), z)) in (first..).zip(rows) {
            match direction {
                Direction::Down => move_nodes(x, y, z, place(starts.partition_point(|&start| start <= i) - 1)),
                Direction::Right => {
                    for (k, ends) in starts.windows(2).enumerate() {
                        let here = ends[0]..ends[1];
                        move_nodes(&mut x[here.clone()], &mut y[here.clone()], &mut z[here], place(k));
                    }
                }
            }
        }
    });
    Ok(())
}

fn move_nodes<T: Real>(x: &mut [T], y: &mut [T], z: &mut [T], place: DAffine3) {
    if place == DAffine3::IDENTITY {
        return;
    }
    let [a, b, c] = [place.matrix3.x_axis, place.matrix3.y_axis, place.matrix3.z_axis];
    let origin = place.translation;
    for ((x, y), z) in x.iter_mut().zip(y).zip(z) {
        let p = DVec3::new((*x).into(), (*y).into(), (*z).into());
        let q = a * p.x + b * p.y + c * p.z + origin;
        (*x, *y, *z) = (T::of(q.x), T::of(q.y), T::of(q.z));
    }
}
