//! Lines through sheets, and local minima of the distance: hits are on the line and where they say; the nearest
//! of the minima is the nearest point.

use crate::agree::agreed;
use crate::distance;
use crate::input::{self, Point, SmallSheet};
use gusset::Job;
use gusset::surface::line_intersection::{HitSelection, Line};

/// Runs one case.
pub(crate) fn run(bytes: &[u8]) {
    let Some((sheet, a, b, kind, choice)) = input::taken::<(SmallSheet, Point, Point, u8, u8)>(bytes) else { return };
    let Some(surface) = sheet.surface() else { return };
    let (a, b) = (a.at(), b.at());
    let line = match kind % 3 {
        0 => Line::new(a, b - a),
        1 => Line::ray(a, b),
        _ => Line::segment(a, b),
    };
    let size = surface.bounds()[0].abs().max(surface.bounds()[1].abs()).max_element() + a.abs().max_element();
    let slack = 2.0 * surface.tolerance() + 1e-9 * size;
    if let Ok(found) = agreed(choice, |job| surface.lines(&[line], HitSelection::All, job)) {
        let hits = found.hits_of(0);
        assert!(hits.is_sorted_by(|one, next| one.at <= next.at));
        for hit in hits {
            assert!(
                surface.has_place(&hit.place) && distance(surface.jet(hit.place).point, hit.point) <= slack,
                "{hit:?}"
            );
            assert!((line.from..=line.to).contains(&hit.at), "{hit:?}");
            if !hit.tangent {
                let off = distance(line.origin + hit.at * line.direction, hit.point);
                assert!(off <= slack, "{off} from the line: {hit:?}");
            }
        }
    }
    let Ok(minima) = agreed(choice, |job| surface.local_minima(a, f64::INFINITY, 100, job)) else { return };
    if let (Some(first), Some(closest)) = (minima.points.first(), surface.closest(a, f64::INFINITY)) {
        assert!(!closest.proven || closest.distance <= first.distance + slack, "{closest:?} {first:?}");
    }
    let _ = surface.closest_all(&[a, b], f64::INFINITY, &Job::default());
}
