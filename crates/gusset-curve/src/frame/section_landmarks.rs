//! The landmarks of sections: the corners of all sections, and their places on the sections that lack
//! them.
//!
//! From each section to the next, a map keeps the order of points and is linear between anchors. The
//! anchors are pairs of corners, matched by position, or the starts of least twist if a section lacks
//! corners. A corner whose image is close to a corner of the next section continues there. All other
//! corners begin a landmark, which the maps take to all sections. Landmarks therefore have the same
//! order on each section.
//!
//! O(landmarks^2) for each section, and O(n^3) for two adjacent sections of n corners.

use super::section_corners::choose_nearest_corners;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_base::sort;

/// A corner continues a landmark that is at most this fraction of the section's length away.
const MAX_LANDMARK_SHIFT: f64 = 1.0 / 64.0;
/// Further corners are drawn smooth.
const MAX_LANDMARKS: usize = 512;

/// A point of each section.
pub(super) struct Landmark {
    /// For each section the fraction of its length.
    pub(super) fractions: Vec<f64>,
    /// For each section its corner there, among its own points.
    pub(super) corners: Vec<Option<u32>>,
}

/// The corners of a section in its direction: indices among its points, and fractions of its length.
pub(super) type SectionCorners = Vec<(u32, f64)>;

/// Finds the landmarks of sections in the order of the sections' directions.
///
/// Closed sections without corners share one landmark, at `starts`. The ends of open sections are
/// landmarks. `squared_distance` compares corner i of a section with corner j of the next section.
pub(super) fn find_landmarks(
    corners: &[SectionCorners],
    closed: bool,
    starts: &[f64],
    squared_distance: &dyn Fn(usize, u32, u32) -> f64,
    job: &Job<'_>,
) -> Result<Vec<Landmark>> {
    // Open sections take half of a circle, so that their ends are apart.
    let circle = NumbersModuloLength { length: if closed { 1.0 } else { 2.0 } };
    let Some(first_corners) = corners.first() else { return Ok(Vec::new()) };
    let mut marks = alloc::with_capacity(first_corners.len() + 2)?;
    let ends = [0.0, 1.0];
    for &fraction in if closed { &starts[..1] } else { &ends[..] } {
        marks.push(Landmark {
            fractions: alloc::filled(fraction, corners.len())?,
            corners: alloc::filled(None, corners.len())?,
        });
    }
    for (k, own) in corners.iter().enumerate() {
        job.step(k as f64 / corners.len() as f64, "finding landmarks")?;
        if k > 0 {
            let distance = |i: u32, j: u32| squared_distance(k - 1, i, j);
            let mut anchors = match_corners(&corners[k - 1], own, closed, &distance)?;
            if !closed {
                alloc::extend(&mut anchors, ends.map(|end| (end, end)))?;
            } else if anchors.is_empty() {
                alloc::push(&mut anchors, (starts[k - 1], starts[k]))?;
            }
            marks.iter_mut().for_each(|mark| mark.fractions[k] = circle.map(&anchors, mark.fractions[k - 1]));
        }
        let begun = continue_landmarks(&mut marks, own, k, circle)?;
        begin_landmarks(&mut marks, begun, k, circle, corners.len())?;
    }
    if closed && marks.iter().any(Landmark::is_corner) {
        marks.retain(Landmark::is_corner);
    }
    sort::sort_stable(&mut marks, &|a, b| a.fractions[0].total_cmp(&b.fractions[0]));
    Ok(marks)
}

impl Landmark {
    fn is_corner(&self) -> bool {
        self.corners.iter().any(Option::is_some)
    }
}

/// Returns matched corners of two adjacent sections, by their fractions. The section with fewer
/// corners keeps all of them.
fn match_corners(
    before: &[(u32, f64)],
    own: &[(u32, f64)],
    closed: bool,
    squared_distance: &dyn Fn(u32, u32) -> f64,
) -> Result<Vec<(f64, f64)>> {
    let swapped = own.len() < before.len();
    let (few, many) = if swapped { (own, before) } else { (before, own) };
    let candidates = alloc::collect((0..many.len()).map(|j| j as u32))?;
    let distance = |i: usize, j: u32| {
        let (few, many) = (few[i].0, many[j as usize].0);
        if swapped { squared_distance(many, few) } else { squared_distance(few, many) }
    };
    let chosen = choose_nearest_corners(&candidates, few.len(), closed, &distance)?;
    alloc::collect(few.iter().zip(chosen).map(|(&(_, x), j)| {
        let y = many[j as usize].1;
        if swapped { (y, x) } else { (x, y) }
    }))
}

/// Gives the landmarks the corners of section k that are close to them, and moves the other landmarks
/// along. Returns the remaining corners.
fn continue_landmarks(
    marks: &mut [Landmark],
    own: &[(u32, f64)],
    k: usize,
    circle: NumbersModuloLength,
) -> Result<Vec<(u32, f64)>> {
    let mut rest = Vec::new();
    let images = alloc::collect(marks.iter().map(|mark| mark.fractions[k]))?;
    // Corners that the map hits come first, so that no other corner takes their landmark.
    for is_exact in [true, false] {
        for &(corner, fraction) in own {
            if marks.iter().any(|mark| mark.corners[k] == Some(corner)) {
                continue;
            }
            let distance = |mark: &Landmark| circle.distance(mark.fractions[k], fraction);
            let nearest = (0..marks.len()).min_by(|&i, &j| distance(&marks[i]).total_cmp(&distance(&marks[j])));
            let max = if is_exact { 0.0 } else { MAX_LANDMARK_SHIFT };
            match nearest.filter(|&i| marks[i].corners[k].is_none() && distance(&marks[i]) <= max) {
                Some(i) => (marks[i].fractions[k], marks[i].corners[k]) = (fraction, Some(corner)),
                None if !is_exact => alloc::push(&mut rest, (corner, fraction))?,
                None => {}
            }
        }
    }
    let is_fixed = |i: usize, mark: &Landmark| mark.corners[k].is_some() || (circle.length > 1.0 && i < 2);
    let fixed = marks.iter().enumerate().filter(|&(i, mark)| is_fixed(i, mark));
    let anchors = alloc::gather(fixed.map(|(i, mark)| (images[i], mark.fractions[k])))?;
    for (i, mark) in marks.iter_mut().enumerate() {
        if !anchors.is_empty() && !is_fixed(i, mark) {
            mark.fractions[k] = circle.map(&anchors, images[i]);
        }
    }
    Ok(rest)
}

/// Adds landmarks that begin at corners of section k. On earlier sections, they are between the same
/// landmarks.
fn begin_landmarks(
    marks: &mut Vec<Landmark>,
    begun: Vec<(u32, f64)>,
    k: usize,
    circle: NumbersModuloLength,
    sections: usize,
) -> Result<()> {
    let before = marks.len();
    for (corner, fraction) in begun {
        if marks.len() >= MAX_LANDMARKS {
            break;
        }
        let mut fractions = alloc::filled(fraction, sections)?;
        let mut corners = alloc::filled(None, sections)?;
        corners[k] = Some(corner);
        for j in (0..k).rev() {
            let anchors =
                alloc::collect(marks[..before].iter().map(|mark| (mark.fractions[j + 1], mark.fractions[j])))?;
            fractions[j] = circle.map(&anchors, fractions[j + 1]);
        }
        alloc::push(marks, Landmark { fractions, corners })?;
    }
    Ok(())
}

/// Numbers modulo a length.
#[derive(Clone, Copy)]
struct NumbersModuloLength {
    length: f64,
}

impl NumbersModuloLength {
    /// Returns x within [0, length).
    fn wrap(self, x: f64) -> f64 {
        let wrapped = x - self.length * (x / self.length).floor();
        if wrapped < self.length { wrapped } else { 0.0 }
    }

    fn distance(self, x: f64, y: f64) -> f64 {
        let by = self.wrap(x - y);
        by.min(self.length - by)
    }

    /// Returns the image of x under the map that is linear between anchors, of which there is at least
    /// one. One anchor makes a rotation.
    fn map(self, anchors: &[(f64, f64)], x: f64) -> f64 {
        let least = |origin: f64, sign: f64, allowed: &dyn Fn(f64) -> bool| {
            let by = |i: usize| self.wrap(sign * (anchors[i].0 - origin));
            (0..anchors.len()).filter(|&i| allowed(by(i))).min_by(|&i, &j| by(i).total_cmp(&by(j)))
        };
        let Some(last) = least(x, -1.0, &|_| true) else { return x };
        let (from, image) = anchors[last];
        let Some(next) = least(from, 1.0, &|by| by > 0.0) else { return self.wrap(image + self.wrap(x - from)) };
        let (to, next_image) = anchors[next];
        self.wrap(image + self.wrap(next_image - image) * (self.wrap(x - from) / self.wrap(to - from)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn landmarks(corners: &[SectionCorners], closed: bool) -> Vec<Landmark> {
        let starts = vec![0.0; corners.len()];
        let at = |k: usize, i: u32| corners[k].iter().find(|corner| corner.0 == i).unwrap().1;
        let distance = |k: usize, i: u32, j: u32| {
            let by = (at(k, i) - at(k + 1, j)).abs();
            by.min(1.0 - by).powi(2)
        };
        find_landmarks(corners, closed, &starts, &distance, &Job::default()).unwrap()
    }

    /// Sections with and without corners: each section keeps its own corners, and landmarks have the
    /// same cyclic order on all sections.
    #[test]
    fn landmarks_keep_all_corners_in_order() {
        // A linear congruential generator.
        let mut state = 5_u64;
        let mut random = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 11) as f64 / (1_u64 << 53) as f64
        };
        for case in 0..400 {
            let closed = case % 2 == 0;
            let corners: Vec<SectionCorners> = (0..6)
                .map(|_| {
                    let count = (6.0 * random()) as usize;
                    let mut own: Vec<f64> = (0..count).map(|_| 0.05 + 0.9 * random()).collect();
                    own.sort_by(f64::total_cmp);
                    (0..).zip(own).collect()
                })
                .collect();
            let marks = landmarks(&corners, closed);
            for (k, own) in corners.iter().enumerate() {
                for &(corner, fraction) in own {
                    let found: Vec<&Landmark> = marks.iter().filter(|mark| mark.corners[k] == Some(corner)).collect();
                    assert!(found.len() == 1 && found[0].fractions[k] == fraction, "{case}: {k} {corner}");
                }
                let falls = (1..marks.len()).filter(|&i| marks[i].fractions[k] < marks[i - 1].fractions[k]).count();
                assert!(falls <= usize::from(closed), "{case}: section {k} out of order");
                assert!(closed || (marks[0].fractions[k] == 0.0 && marks[marks.len() - 1].fractions[k] == 1.0));
            }
        }
    }

    #[test]
    fn equal_corners_share_landmarks_across_a_section_without_corners() {
        let square: SectionCorners = vec![(0, 0.0), (1, 0.25), (2, 0.5), (3, 0.75)];
        let marks = landmarks(&[square.clone(), Vec::new(), square], true);
        assert_eq!(marks.len(), 4);
        assert!(marks.iter().all(|mark| mark.fractions[1] == mark.fractions[0]));
    }
}
