//! The best place for a dart.
//!
//! A conformal map scales lengths by exp(u). The Laplacian of u is the Gaussian curvature, and u is
//! 0 at the border. The map is worst where |u| is greatest, and a dart from there to the border
//! releases the curvature (M. Ben-Chen, C. Gotsman, G. Bunin, *Conformal flattening by curvature
//! prescription and metric scaling*, 2008, place cones in this way).

use super::chart::ChartMesh;
use super::chart_system::ChartSystem;
use super::{STAGE, TRIANGLES_PER_REPORT};
use glam::{DMat2, DVec2};
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::bit_set::BitSet;
use gusset_base::job::Job;
use std::f64::consts::TAU;

/// Returns the vertex inside the chart at which a dart should end; `None` if the chart lacks inner
/// vertices or curvature.
pub(super) fn find_dart_tip(chart: &ChartMesh, system: &mut ChartSystem, job: &Job<'_>) -> Result<Option<u32>> {
    let n = chart.points.len();
    let mut on_border = BitSet::new(n)?;
    chart.border.iter().for_each(|&[v, _]| on_border.insert(v));
    let mut defects = alloc::filled(TAU, n)?;
    let zero = alloc::filled(DVec2::ZERO, n)?;
    system.clear_equations(&job.sub_job(0.0, 0.0))?;
    chart.border.iter().for_each(|&[v, _]| system.fix_vertex(v));
    for (k, (triangle, shape)) in chart.triangles.iter().zip(&chart.shapes).enumerate() {
        job.sub_job(0.0, 0.1).step_every(TRIANGLES_PER_REPORT, k, chart.triangles.len(), STAGE)?;
        for i in 0..3 {
            let [g, next] = [i, (i + 1) % 3].map(|k| shape.gradients[k]);
            let value = shape.area * g.dot(next);
            system.add_block(triangle[i], triangle[(i + 1) % 3], DMat2::from_diagonal(DVec2::splat(value)), &zero);
            system.add_diagonal_block(triangle[i], DMat2::from_diagonal(DVec2::splat(shape.area * g.length_squared())));
            let [a, b, c] = [i, (i + 1) % 3, (i + 2) % 3].map(|k| chart.points[triangle[k] as usize]);
            let (p, q) = (b - a, c - a);
            defects[triangle[i] as usize] -= libm::atan2(p.cross(q).length(), p.dot(q));
        }
    }
    for (v, &defect) in (0..n as u32).zip(&defects) {
        system.add_right_hand_side(v, DVec2::new(defect, 0.0));
    }
    let scale = system.solve_positions(&zero, &job.sub_job(0.1, 1.0))?;
    let inside = (0..n as u32).filter(|&v| !on_border.contains(v));
    let best = inside.fold(None, |best: Option<(f64, u32)>, v| {
        let size = scale[v as usize].x.abs();
        if best.is_none_or(|(largest, _)| size > largest) { Some((size, v)) } else { best }
    });
    Ok(best.filter(|&(size, _)| size > 1e-9).map(|(_, v)| v))
}
