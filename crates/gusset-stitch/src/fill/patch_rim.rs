//! The loops of one patch and the faces around them, with their own vertex numbers.

use super::triangulation_cost::Polygon;
use crate::blend::{MAX_FAN_TRIANGLES, OldRing, SecondRing};
use crate::fair::Continuity;
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::scale::common_unit;

/// The rim of a patch. The vertices of its loops come first, loop by loop, in the direction in
/// which new faces run along the loop (with the surface on the right). The other old vertices
/// follow.
pub(super) struct PatchRim {
    /// The number of rim vertices.
    pub(super) rim_vertex_count: usize,
    /// The number of vertices of each loop.
    pub(super) loop_lengths: Vec<usize>,
    /// The coordinates are relative to this origin, one of the rim's points, in this unit.
    pub(super) origin: DVec3,
    pub(super) unit: f64,
    /// The rim's points and the other old points.
    pub(crate) points: Vec<DVec3>,
    /// The old faces with a vertex on the rim, as triangles.
    pub(super) first_ring: Vec<[u32; 3]>,
    /// The old faces next to these, as triangles; empty for tangent continuity.
    pub(super) second_ring_triangles: Vec<[u32; 3]>,
    /// Lists the sides of the old faces in `first_ring`, face by face. Each is a pair of vertices in
    /// the face's direction.
    pub(super) first_ring_sides: Vec<(u32, u32)>,
    /// The unit normal of the old face at the edge from each rim vertex to the next; 0 if it is not
    /// known.
    pub(super) normals_across_edges: Vec<DVec3>,
    /// The unit normal of the old surface at each rim vertex; 0 if it is undefined.
    pub(crate) normals: Vec<DVec3>,
    /// True for rim vertices that have a complete one-ring once the loops are closed.
    pub(super) has_complete_one_ring: Vec<bool>,
}

/// The old faces around a rim; see [`PatchRim`].
pub(super) struct OldFaces {
    pub(super) first_ring: Vec<[u32; 3]>,
    pub(super) second_ring_triangles: Vec<[u32; 3]>,
    pub(super) first_ring_sides: Vec<(u32, u32)>,
}

impl PatchRim {
    /// Creates a rim from points in mesh coordinates. `has_complete_one_ring` and `normals_across_edges` describe the rim's
    /// vertices.
    pub(super) fn new(
        points: &[DVec3],
        lengths: Vec<usize>,
        faces: OldFaces,
        normals_across_edges: Vec<DVec3>,
        has_complete_one_ring: Vec<bool>,
    ) -> Result<PatchRim> {
        let unit = common_unit(points);
        let origin = points[0] / unit;
        let points = alloc::collect(points.iter().map(|&p| p / unit - origin))?;
        PatchRim::from_scaled_points(
            (origin, unit),
            points,
            lengths,
            faces,
            (normals_across_edges, has_complete_one_ring),
        )
    }

    /// Creates the rim of a part with one loop, from points in the unit and from the origin of this
    /// rim.
    pub(super) fn rim_of_part(
        &self,
        points: Vec<DVec3>,
        faces: OldFaces,
        across: Vec<DVec3>,
        whole: Vec<bool>,
    ) -> Result<PatchRim> {
        let lengths = vec![whole.len()];
        PatchRim::from_scaled_points((self.origin, self.unit), points, lengths, faces, (across, whole))
    }

    fn from_scaled_points(
        (origin, unit): (DVec3, f64),
        points: Vec<DVec3>,
        lengths: Vec<usize>,
        OldFaces { first_ring: around, second_ring_triangles: beyond, first_ring_sides: sides }: OldFaces,
        (across, whole): (Vec<DVec3>, Vec<bool>),
    ) -> Result<PatchRim> {
        let count = whole.len();
        let mut normals = alloc::filled(DVec3::ZERO, count)?;
        for &triangle in &around {
            let [a, b, c] = triangle.map(|v| points[v as usize]);
            let area = (b - a).cross(c - a);
            for &v in triangle.iter().filter(|&&v| (v as usize) < count) {
                normals[v as usize] += area;
            }
        }
        normals.iter_mut().for_each(|normal| *normal = normal.normalize_or_zero());
        Ok(PatchRim {
            rim_vertex_count: count,
            loop_lengths: lengths,
            origin,
            unit,
            points,
            first_ring: around,
            second_ring_triangles: beyond,
            first_ring_sides: sides,
            normals_across_edges: across,
            normals,
            has_complete_one_ring: whole,
        })
    }

    /// Converts a point back to mesh coordinates.
    pub(super) fn to_mesh_coordinates(&self, p: DVec3) -> DVec3 {
        (p + self.origin) * self.unit
    }

    /// Returns each loop as a polygon.
    pub(super) fn loop_polygons(&self) -> Result<Vec<Polygon>> {
        let mut first = 0;
        alloc::try_collect(self.loop_lengths.iter().map(|&n| {
            let own = first..first + n;
            first += n;
            let part = |of: &[DVec3]| alloc::copied(&of[own.clone()]);
            Ok(Polygon::new(part(&self.points)?, part(&self.normals_across_edges)?, part(&self.normals)?))
        }))
    }

    /// Returns the number of smoothing steps for the curvature of a patch. The curvature then
    /// spreads over about a third of a round hole. The number grows with the square of the longest
    /// loop's length in edges.
    fn curvature_smoothing_steps(&self) -> u32 {
        let radius = self.loop_lengths.iter().copied().max().unwrap_or(0) as f64 / std::f64::consts::TAU;
        (0.5 * radius * radius).clamp(10.0, 400.0) as u32
    }

    /// Returns the old surface to which a blend is clamped.
    pub(super) fn old_ring(&self, continuity: Continuity) -> Result<OldRing> {
        let mut valence = alloc::filled(0usize, self.points.len())?;
        self.first_ring.as_flattened().iter().for_each(|&v| valence[v as usize] += 1);
        let is_centre = |(&whole, &valence): (&bool, &usize)| whole && valence <= MAX_FAN_TRIANGLES;
        Ok(OldRing {
            points: alloc::copied(&self.points)?,
            origin: DVec3::ZERO,
            triangles: alloc::copied(&self.first_ring)?,
            sides: alloc::copied(&self.first_ring_sides)?,
            has_laplacian_in_energy: alloc::collect(self.has_complete_one_ring.iter().zip(&valence).map(is_centre))?,
            rim_lengths_and_closedness: alloc::collect(self.loop_lengths.iter().map(|&n| (n, true)))?,
            max_width_without_springs: f64::INFINITY,
            smoothing_passes_of_rest_curvature: (continuity == Continuity::C1)
                .then(|| self.curvature_smoothing_steps()),
            second_ring: self.second_ring(continuity)?,
        })
    }

    /// Returns the faces beyond the rim. A vertex outside the rim gets a Laplacian only if its
    /// one-ring is complete.
    fn second_ring(&self, continuity: Continuity) -> Result<SecondRing> {
        if continuity == Continuity::C1 {
            return Ok(SecondRing::default());
        }
        let triangles = self.first_ring.iter().chain(&self.second_ring_triangles);
        let mut sides = alloc::with_capacity(3 * (self.first_ring.len() + self.second_ring_triangles.len()))?;
        sides.extend(triangles.flat_map(|&[a, b, c]| [(a, b), (b, c), (c, a)]));
        sides.sort_unstable();
        let mut valence = alloc::filled(0usize, self.points.len())?;
        let mut is_whole = alloc::filled(true, self.points.len())?;
        let once = |side: &(u32, u32)| {
            let first = sides.partition_point(|other| other < side);
            sides.get(first) == Some(side) && sides.get(first + 1) != Some(side)
        };
        for &(u, v) in &sides {
            valence[u as usize] += 1;
            if !once(&(u, v)) || !once(&(v, u)) {
                is_whole[u as usize] = false;
                is_whole[v as usize] = false;
            }
        }
        let is_centre = |v: usize| is_whole[v] && (1..=MAX_FAN_TRIANGLES).contains(&valence[v]);
        let centred = alloc::collect((self.rim_vertex_count..self.points.len()).map(is_centre))?;
        Ok(SecondRing {
            continuity,
            triangles: alloc::copied(&self.second_ring_triangles)?,
            is_laplacian_known: centred,
        })
    }
}
