//! Surfaces through nets of polylines, skins and whole nets: an error, or a sheet that contains its curves to
//! the tolerance.

use crate::agree::agreed;
use crate::input::{self, Cloud};
use glam::DVec3;
use gusset::Job;
use gusset::curve::CurveView;
use gusset::surface::construct::CurveNet;
use gusset::surface::{Sheet, Surface};

/// Runs one case.
pub(crate) fn run(bytes: &[u8]) {
    let Some((nodes, size, skin, smooth, choice)) = input::taken::<(Cloud, [u8; 2], bool, bool, u8)>(bytes) else {
        return;
    };
    let [rows, columns] = size.map(|size| 2 + usize::from(size % 4));
    if nodes.is_empty() {
        return;
    }
    let node = |i: usize, j: usize| {
        nodes[(i * columns + j) % nodes.len()].at() + DVec3::new(200.0 * i as f64, 200.0 * j as f64, 0.0)
    };
    let lines = |count: usize, length: usize, at: &dyn Fn(usize, usize) -> DVec3| -> Vec<Vec<DVec3>> {
        (0..count).map(|k| (0..length).map(|l| at(k, l)).collect()).collect()
    };
    let (across, along) = (lines(rows, columns, &node), lines(columns, rows, &|j, i| node(i, j)));
    // One segment of a higher degree passes its first and last nodes alone: rows then are a skin.
    let ends = |length: usize| if smooth { vec![0, length as u32 - 1] } else { (0..length as u32).collect::<Vec<_>>() };
    let (row_ends, column_ends) = (ends(columns), ends(rows));
    fn views<'a>(lines: &'a [Vec<DVec3>], ends: &'a [u32]) -> Option<Vec<CurveView<'a>>> {
        lines.iter().map(|line| CurveView::new(line, ends, false).ok()).collect()
    }
    let (Some(across), Some(along)) = (views(&across, &row_ends), views(&along, &column_ends)) else { return };
    let columns = if skin || smooth { &[][..] } else { &along[..] };
    let net = CurveNet { rows: &across, columns, closed: [false; 2], tolerance: None };
    let Ok(sheet) = agreed(choice, |job| Sheet::from_curves(&net, job)) else { return };
    let Ok(surface) = Surface::new(vec![sheet], None, &Job::default()) else { return };
    let size = surface.bounds()[0].abs().max(surface.bounds()[1].abs()).max_element();
    // Rows go beyond the columns, if they meet these elsewhere too.
    if !columns.is_empty() {
        return;
    }
    for point in across.iter().flat_map(|row| [row.points()[0], row.points()[row.points().len() - 1]]) {
        let found = surface.closest(point, f64::INFINITY).expect("a surface has points");
        assert!(
            !found.proven || found.distance <= surface.tolerance() + 1e-6 * size,
            "{point} is {} away of {size}",
            found.distance
        );
    }
}
