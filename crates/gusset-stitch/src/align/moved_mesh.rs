//! The aligned pieces in one mesh.

use super::align_request::Alignment;
use super::pose::Pose;
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::{Element, Error, Result};
use gusset_base::job::Job;
use gusset_mesh::{Mesh, MeshView, PieceOffsets, PositionBuffer, Positions, concatenate};

const STAGE: &str = "moving the pieces";

impl Alignment {
    /// Returns one mesh of the aligned pieces, placed side by side like [`concatenate`], each moved
    /// by its pose.
    ///
    /// A piece that does not move keeps its bits. Other positions are rounded to the scalar type of
    /// the first piece. Positions that are not finite are copied. O(size).
    ///
    /// # Errors
    /// As for [`concatenate`]. [`Error::NotFinite`] for a vertex, counted through all pieces, whose
    /// new position overflows its type.
    pub fn move_pieces(&self, pieces: &[MeshView<'_>], job: &Job<'_>) -> Result<(Mesh, Vec<PieceOffsets>)> {
        let (mut whole, places) = concatenate(pieces, &job.sub_job(0.0, 0.0))?;
        for (k, (piece, aligned)) in pieces.iter().zip(&self.pieces).enumerate() {
            let (pose, first) = (&aligned.pose, places[k].first_vertex as usize);
            if *pose == Pose::IDENTITY {
                continue;
            }
            let (own, job) = (first..first + piece.positions().len(), job.sub_job_of_item(k, pieces.len()));
            match &mut whole.positions {
                PositionBuffer::F32(points) => move_points(pose, &mut points[own], first, |x| x as f32, &job)?,
                PositionBuffer::F64(points) => move_points(pose, &mut points[own], first, |x| x, &job)?,
            }
        }
        Ok((whole, places))
    }
}

/// Returns the pieces as views of the moved mesh, with their own faces.
pub fn views_of_moved_pieces<'a>(
    (whole, places): &'a (Mesh, Vec<PieceOffsets>),
    pieces: &[MeshView<'a>],
    job: &Job<'_>,
) -> Result<Vec<MeshView<'a>>> {
    let scalar = whole.positions.view().scalar();
    let bytes: &[u8] = match &whole.positions {
        PositionBuffer::F32(points) => bytemuck::cast_slice(points),
        PositionBuffer::F64(points) => bytemuck::cast_slice(points),
    };
    alloc::try_collect(pieces.iter().zip(places).map(|(piece, place)| {
        let own = &bytes[place.first_vertex as usize * scalar.position_size()..];
        MeshView::new(Positions::strided(own, 0, piece.positions().len(), scalar)?, *piece.faces(), job)
    }))
}

/// Moves points. The first one is vertex `first`.
fn move_points<T: Copy + Into<f64>>(
    pose: &Pose,
    points: &mut [[T; 3]],
    first: usize,
    round: impl Fn(f64) -> T,
    job: &Job<'_>,
) -> Result<()> {
    job.work_in_ranges(STAGE, points.len(), |range| {
        for v in range {
            let before = DVec3::from_array(points[v].map(Into::into));
            if before.is_finite() {
                points[v] = pose.transform_point(before).to_array().map(&round);
                let after = DVec3::from_array(points[v].map(Into::into));
                Error::check_finite(Element::Vertex, (first + v) as u64, after)?;
            }
        }
        Ok(())
    })
}
