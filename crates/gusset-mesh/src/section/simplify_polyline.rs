//! Fewer points on a polyline, within a tolerance.
//!
//! The method is by D. Douglas and T. Peucker, 1973: if a point between two kept points is farther
//! from their segment than the tolerance, the farthest such point is kept too. All points that are
//! left are points of the given polyline, so they keep their sources. No given point is farther
//! from the result than the tolerance, and no point of the result is farther from the given
//! polyline.
//!
//! Splits near an end of a span would make the method quadratic. A span that many splits led to is
//! therefore split in its middle, which keeps the bounds, and bounds the work by O(n log n). Parts of
//! the result may cross each other, because each span is judged alone.

use super::section_request::STAGE;
use super::sections::Sections;
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::job::Job;

/// Points that are judged between two progress reports.
const POINTS_PER_REPORT: usize = 1 << 16;

/// Simplifies paths. The memory serves path after path.
pub(super) struct PolylineSimplifier {
    tolerance: f64,
    is_kept: Vec<bool>,
    spans: Vec<Span>,
}

/// Two kept points, between which points are to be judged.
#[derive(Clone, Copy)]
struct Span {
    from: usize,
    to: usize,
    /// The number of splits that led to the span.
    depth: u32,
}

impl PolylineSimplifier {
    pub(super) fn new(tolerance: f64) -> Self {
        PolylineSimplifier { tolerance, is_kept: Vec::new(), spans: Vec::new() }
    }

    /// Simplifies the paths from `first_path` on.
    pub(super) fn simplify_paths(&mut self, sections: &mut Sections, first_path: usize, job: &Job<'_>) -> Result<()> {
        let mut write = sections.starts[first_path] as usize;
        for path in first_path..sections.paths.len() {
            job.step_within_heavy_list(4, path, STAGE)?;
            let range = sections.range(path);
            self.choose_points(&sections.points[range.clone()], sections.paths[path].is_closed, job)?;
            sections.starts[path] = write as u32;
            for (k, read) in range.enumerate() {
                if self.is_kept[k] {
                    sections.points[write] = sections.points[read];
                    sections.edges[write] = sections.edges[read];
                    sections.parameters[write] = sections.parameters[read];
                    sections.faces[write] = sections.faces[read];
                    write += 1;
                }
            }
        }
        sections.truncate_points(write);
        if let Some(end) = sections.starts.last_mut() {
            *end = write as u32;
        }
        Ok(())
    }

    /// Marks the points that are kept. A loop keeps its first point, the farthest point from it,
    /// and the farthest point from the chord between both.
    fn choose_points(&mut self, points: &[DVec3], is_closed: bool, job: &Job<'_>) -> Result<()> {
        let count = points.len();
        alloc::reset(&mut self.is_kept, count, false)?;
        self.spans.clear();
        if is_closed {
            let (opposite, _) = find_farthest(1..count, |k| points[k].distance_squared(points[0]));
            let to_chord = |k: usize| squared_distance_from_segment(points[k], [points[0], points[opposite]]);
            let (third, _) = find_farthest((1..count).filter(|&k| k != opposite), to_chord);
            let mut corners = [0, opposite, third];
            corners.sort_unstable();
            for [from, to] in [[corners[0], corners[1]], [corners[1], corners[2]], [corners[2], count]] {
                self.keep_span(Span { from, to, depth: 0 })?;
            }
        } else {
            self.is_kept[count - 1] = true;
            self.keep_span(Span { from: 0, to: count - 1, depth: 0 })?;
        }
        // Balanced splits lead to spans of one segment after ilog2(count) splits.
        let max_depth = 2 * count.ilog2() + 8;
        let mut judged = 0;
        while let Some(Span { from, to, depth }) = self.spans.pop() {
            judged += to - from;
            if judged > POINTS_PER_REPORT {
                job.step(0.0, STAGE)?;
                judged = 0;
            }
            let chord = [points[from], points[to % count]];
            let (farthest, distance) = find_farthest(from + 1..to, |k| squared_distance_from_segment(points[k], chord));
            if distance > self.tolerance * self.tolerance {
                let split = if depth < max_depth { farthest } else { usize::midpoint(from, to) };
                self.keep_span(Span { from, to: split, depth: depth + 1 })?;
                self.keep_span(Span { from: split, to, depth: depth + 1 })?;
            }
        }
        Ok(())
    }

    /// Keeps the first point of a span, and plans to judge the points inside.
    fn keep_span(&mut self, span: Span) -> Result<()> {
        if span.from < span.to {
            self.is_kept[span.from] = true;
            alloc::push(&mut self.spans, span)?;
        }
        Ok(())
    }
}

/// Returns the first number with the largest value, and the value; 0 and -1 if there is none.
fn find_farthest(range: impl Iterator<Item = usize>, value: impl Fn(usize) -> f64) -> (usize, f64) {
    range.fold((0, -1.0), |(best, largest), k| {
        let value = value(k);
        if value > largest { (k, value) } else { (best, largest) }
    })
}

fn squared_distance_from_segment(p: DVec3, [a, b]: [DVec3; 2]) -> f64 {
    let along = b - a;
    let length_squared = along.length_squared();
    let share = if length_squared > 0.0 { ((p - a).dot(along) / length_squared).clamp(0.0, 1.0) } else { 0.0 };
    p.distance_squared(a + along * share)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The farthest point from each chord is next to its end, so that splits there would be as many
    /// as points.
    #[test]
    fn points_are_near_where_splits_are_uneven() {
        let points: Vec<DVec3> = (0..300).map(|k| DVec3::new(f64::from(k), f64::from(k).exp2().recip(), 0.0)).collect();
        for (tolerance, is_closed) in [1e-3, 1e-30, 1e-60].into_iter().flat_map(|t| [(t, false), (t, true)]) {
            let mut simplifier = PolylineSimplifier::new(tolerance);
            simplifier.choose_points(&points, is_closed, &Job::default()).unwrap();
            let kept: Vec<DVec3> = (0..300).filter(|&k| simplifier.is_kept[k]).map(|k| points[k]).collect();
            assert!(kept.len() < 300 && simplifier.is_kept[0]);
            for &p in &points {
                let distances = kept.windows(2).map(|pair| squared_distance_from_segment(p, [pair[0], pair[1]]));
                assert!(distances.fold(f64::INFINITY, f64::min).sqrt() <= tolerance * (1.0 + 1e-9), "{p}");
            }
        }
    }
}
