//! The inner rows of bridges: evenly spaced on the straight lines between the two sides.
//! O(inner nodes).

use crate::{Bridge, Net};
use glam::DVec3;
use gusset_base::error::Result;
use gusset_base::job::Job;

/// Inner rows laid between two progress reports.
const ROWS_PER_REPORT: usize = 64;

/// Lays the inner rows of the newest bridges. A node between missing ones is missing. If the nodes
/// on both sides have equal bits, so do the nodes between.
pub(crate) fn interpolate_inner_rows(net: &mut Net<'_>, job: &Job<'_>) -> Result<()> {
    for index in 0..net.bridges().len() {
        let bridge = &net.bridges()[index];
        if bridge.nesting == 0 && bridge.rows > 0 {
            let (first, bridge) = (bridge.last_line_of_first_net(), bridge.clone());
            for i in 1..=bridge.rows {
                job.step_every(ROWS_PER_REPORT, i as usize, bridge.rows as usize, "inner rows")?;
                interpolate_inner_row(net, &bridge, (first + i) as usize, f64::from(i) / f64::from(bridge.rows + 1));
            }
        }
    }
    Ok(())
}

/// Lays one inner row or column at a fraction of the way.
fn interpolate_inner_row(net: &mut Net<'_>, bridge: &Bridge, row: usize, fraction: f64) {
    for k in bridge.start as usize..bridge.end as usize {
        let at = |i: usize| bridge.direction.swap_unless_down(i, k);
        let [p, q] = [bridge.last_line_of_first_net() as usize, bridge.at as usize].map(|i| net.get(at(i).0, at(i).1));
        let exists = p.is_finite() && q.is_finite();
        let position = if exists { (1.0 - fraction) * p + fraction * q } else { DVec3::NAN };
        net.coordinates_mut().set(at(row).0, at(row).1, position);
    }
}
