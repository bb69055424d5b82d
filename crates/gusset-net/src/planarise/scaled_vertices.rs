//! The vertices of a net, one for each class of glued nodes. O(nodes).

use super::planarise_options::PlanariseOptions;
use super::planarise_options::STAGE;
use crate::complex::Complex;
use crate::{Net, NodeClasses};
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::scale::common_unit;
use gusset_base::job::Job;
use gusset_mesh::Scalar;

/// Nodes between two progress reports.
const NODES_PER_REPORT: usize = 1 << 16;

/// Holds the scaled positions of a net's vertices, and which stay. Representatives of node classes
/// are the indices; other entries are unused.
pub(crate) struct ScaledVertices {
    pub(crate) classes: NodeClasses,
    /// The position of the class's first existing node, scaled and relative to the origin.
    pub(crate) positions: Vec<DVec3>,
    /// True for vertices that stay.
    pub(crate) is_fixed_vertex: Vec<bool>,
    /// The diagonal of the bounding box of all existing nodes, scaled.
    pub(crate) box_diagonal: f64,
    /// The scale, a power of two with which products of coordinates neither overflow nor underflow.
    pub(crate) unit: f64,
    /// The centre of the bounding box, scaled. Positions are relative to it, because distant nets
    /// would lose digits.
    box_centre: DVec3,
}

impl ScaledVertices {
    pub(crate) fn new(net: &Net<'_>, options: &PlanariseOptions<'_>, job: &Job<'_>) -> Result<Self> {
        let nodes = 0..net.shape().node_count() as u32;
        let classes = NodeClasses::new_cancellable(net.topology(), &job.sub_job(0.0, 0.3), STAGE)?;
        let mut fixed = alloc::filled(false, nodes.len())?;
        let (mut low, mut high) = (DVec3::INFINITY, DVec3::NEG_INFINITY);
        for node in nodes {
            let position = net.position(node);
            if position.is_finite() {
                (low, high) = (low.min(position), high.max(position));
            }
            let stays = options.fixed.get(node as usize).is_some_and(|&stays| stays);
            fixed[classes.representative(node) as usize] |= stays;
        }
        if options.keep_boundary {
            let boundary = Complex::from_net(net, &job.sub_job(0.3, 0.8))?.boundary;
            boundary.nodes().iter().for_each(|&node| fixed[classes.representative(node) as usize] = true);
        }
        let (mut unit, mut origin, mut size) = (1.0, DVec3::ZERO, 0.0);
        if low.x <= high.x {
            // Depends on the size instead of the distance from 0, which may be far larger.
            let coarse = common_unit([&low, &high]);
            let extent = high / coarse - low / coarse;
            unit = (coarse * common_unit([&extent])).max(f64::MIN_POSITIVE);
            (origin, size) = ((low / unit).midpoint(high / unit), (low / unit).distance(high / unit));
        }
        let mut surface = ScaledVertices {
            classes,
            positions: Vec::new(),
            is_fixed_vertex: fixed,
            box_diagonal: size,
            unit,
            box_centre: origin,
        };
        surface.positions = surface.vertex_positions(net, &job.sub_job(0.8, 1.0))?;
        Ok(surface)
    }

    /// Returns the positions of the vertices of a net of the same topology.
    pub(crate) fn vertex_positions(&self, net: &Net<'_>, job: &Job<'_>) -> Result<Vec<DVec3>> {
        let count = net.shape().node_count();
        let mut positions = alloc::filled(DVec3::NAN, count)?;
        for node in 0..count as u32 {
            job.step_every(NODES_PER_REPORT, node as usize, count, STAGE)?;
            let (class, position) = (self.classes.representative(node) as usize, net.position(node));
            if positions[class].is_nan() && position.is_finite() {
                positions[class] = self.scale_position(position);
            }
        }
        Ok(positions)
    }

    /// Scales a position relative to the origin.
    pub(crate) fn scale_position(&self, position: DVec3) -> DVec3 {
        position / self.unit - self.box_centre
    }

    /// Rounds the new positions of moved vertices to the net's type.
    pub(crate) fn round_to_scalar(&self, moved: &mut [DVec3], scalar: Scalar) {
        for (moved, &before) in moved.iter_mut().zip(&self.positions) {
            if moved.is_finite() && *moved != before {
                let mut there = (*moved + self.box_centre) * self.unit;
                if scalar == Scalar::F32 {
                    there = there.as_vec3().as_dvec3();
                }
                *moved = there / self.unit - self.box_centre;
            }
        }
    }

    /// Moves all existing nodes of the moved vertices.
    pub(crate) fn move_nodes(&self, net: &mut Net<'_>, moved: &[DVec3]) {
        for node in 0..net.shape().node_count() as u32 {
            let class = self.classes.representative(node) as usize;
            if moved[class].is_finite() && moved[class] != self.positions[class] && net.position(node).is_finite() {
                let (i, j) = net.shape().row_and_column(node);
                net.coordinates_mut().set(i, j, (moved[class] + self.box_centre) * self.unit);
            }
        }
    }
}
