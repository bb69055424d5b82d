//! Sections, intersections and self-intersections of sheets: points are where their places say, on the planes,
//! and paths are complete.

use crate::agree::agreed;
use crate::distance;
use crate::input::{self, SmallSheet};
use glam::DVec3;
use gusset::surface::contour::{Planes, PointSpacing};
use gusset::surface::surface_intersection::Options;
use gusset::surface::{Paths, Surface};

/// Runs one case.
pub(crate) fn run(bytes: &[u8]) {
    let Some((a, b, [x, y, z, at], choice)) = input::taken::<(SmallSheet, SmallSheet, [i8; 4], u8)>(bytes) else {
        return;
    };
    let Some(a) = a.surface() else { return };
    let (point, normal) = (DVec3::splat(f64::from(at)), DVec3::new(x.into(), y.into(), z.into()));
    let spacing = if choice < 128 { PointSpacing::CellEdges } else { PointSpacing::Auto };
    let offsets = [-1.5, 0.0, 20.0];
    let planes = Planes { point, normal, levels: &offsets };
    if let Ok(paths) = agreed(choice, |job| a.section(&planes, spacing, job)) {
        check(&a, &paths);
        for (k, &level) in paths.levels.iter().enumerate() {
            for p in paths.points_of(k) {
                let off = (*p - point).dot(normal.normalize()) - offsets[level as usize];
                let size = a.bounds()[0].abs().max(a.bounds()[1].abs()).max_element() + point.abs().max_element();
                assert!(off.abs() <= a.tolerance() + 1e-6 * size, "{off} of {size} from the plane");
            }
        }
    }
    let options = Options { chord: Some(f64::INFINITY), tolerance: None };
    if let Ok(paths) = agreed(choice, |job| a.meet_itself(&options, job)) {
        check(&a, &paths);
    }
    let Some(b) = b.surface() else { return };
    if let Ok(paths) = agreed(choice, |job| a.meet(&b, &options, job)) {
        check(&a, &paths);
    }
}

fn check(surface: &Surface<'_>, paths: &Paths) {
    assert_eq!(paths.ends.last().copied().unwrap_or(0) as usize, paths.points.len());
    assert_eq!(paths.places.len(), paths.points.len());
    let size = surface.bounds()[0].abs().max(surface.bounds()[1].abs()).max_element();
    for (place, point) in paths.places.iter().zip(&paths.points) {
        assert!(surface.has_place(place) && point.is_finite(), "{place:?} {point}");
        let off = distance(surface.jet(*place).point, *point);
        assert!(off <= surface.tolerance() + 1e-9 * size, "{off} of {size} from its place");
    }
}
