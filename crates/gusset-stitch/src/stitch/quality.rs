//! Quality of a stitched mesh: angles, aspect ratios, areas, and remaining defects.

use crate::boundary::{self, boundary_loops};
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::polygon::triangulate_polygon;
use gusset_base::geom::{scale::common_unit, triangle};
use gusset_base::job::Job;
use gusset_mesh::{Defect, Mesh};
use std::f64::consts::FRAC_PI_3;

/// Faces between two progress reports.
const FACES_PER_REPORT: usize = 1 << 16;

/// Measures of the strip, and of the connectivity of the whole result.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Quality {
    /// The smallest angle of the strip's triangles, in radians; 0 if one is degenerate. Quads are
    /// measured as two triangles, split by the shorter diagonal.
    pub min_angle: f64,
    /// The largest aspect ratio of the strip's triangles: longest side / (2 sqrt(3) inscribed
    /// radius). It is 1 for an equilateral triangle, and infinite for a degenerate one.
    pub max_aspect: f64,
    /// The longest edge of the strip, in the unit of the positions.
    pub max_edge: f64,
    /// The strip's area, in the squared unit of the positions.
    pub area: f64,
    /// The number of degenerate triangles in the strip.
    pub degenerate_faces: u32,
    /// The number of boundary loops of the result; 0 if it is closed.
    pub loops_left: u32,
    /// The number of edges of the result with three or more faces.
    pub non_manifold_edges: u32,
    /// The number of edges of the result whose two faces have inconsistent orientations.
    pub orientation_conflicts: u32,
}

impl Quality {
    pub(crate) fn measure(whole: &Mesh, strip: &Mesh, job: &Job<'_>) -> Result<Self> {
        let mut quality = Quality { min_angle: FRAC_PI_3, max_aspect: 1.0, ..Quality::default() };
        quality.measure_strip(strip, &job.sub_job(0.0, 0.1))?;

        let boundary = boundary_loops(
            &whole.view(&job.sub_job(0.1, 0.3))?,
            &boundary::Options::default(),
            &job.sub_job(0.3, 1.0),
        )?;
        quality.loops_left = boundary.len() as u32;
        for defect in boundary.defects() {
            match defect {
                Defect::NonManifoldEdge { .. } => quality.non_manifold_edges += 1,
                Defect::OrientationConflict { .. } => quality.orientation_conflicts += 1,
                Defect::DegenerateFace { .. } | Defect::BowTie { .. } => {}
            }
        }
        Ok(quality)
    }

    fn measure_strip(&mut self, strip: &Mesh, job: &Job<'_>) -> Result<()> {
        job.step(0.0, "measuring new faces")?;
        let points = alloc::collect((0..strip.positions.len()).map(|v| strip.positions.get(v as u32)))?;
        let unit = common_unit(&points);
        let (mut longest, mut double_area): (f64, f64) = (0.0, 0.0);
        let (mut corners, mut triangles) = (Vec::new(), Vec::new());
        for (f, w) in strip.face_offsets.windows(2).enumerate() {
            job.step_every(FACES_PER_REPORT, f, strip.face_offsets.len(), "measuring new faces")?;
            let face = &strip.face_corners[w[0] as usize..w[1] as usize];
            let p = |k: usize| points[face[k % face.len()] as usize] / unit;
            longest = (0..face.len()).map(|k| p(k).distance(p(k + 1))).fold(longest, f64::max);
            corners.clear();
            alloc::extend(&mut corners, (0..face.len()).map(p))?;
            triangulate_polygon(&corners, &mut triangles, &job.sub_job_of_item(f, strip.face_offsets.len()))?;
            for &triangle in &triangles {
                let [a, b, c] = triangle.map(|k| corners[k as usize]);
                let area = triangle::double_area(a, b, c);
                self.min_angle = self.min_angle.min(triangle::min_angle(a, b, c));
                self.max_aspect = self.max_aspect.max(triangle::aspect_ratio(a, b, c));
                self.degenerate_faces += u32::from(area == 0.0);
                double_area += area;
            }
        }
        self.max_edge = longest * unit;
        self.area = 0.5 * double_area * unit * unit;
        Ok(())
    }
}
