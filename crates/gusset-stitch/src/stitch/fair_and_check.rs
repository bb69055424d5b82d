//! Fairing of the strip's rows, and detection of intersections.
//!
//! **Fairing** moves the new vertices to the minimum of the sum of squared Laplacians over the new
//! vertices and the rims (a thin plate; see [`fair`](crate::fair)). The rims and the old vertices
//! around them stay fixed. Only the directions of these old vertices count, because their distances
//! may differ from the spacing of the rows. The ends of an open strip stay on their meridians.
//!
//! **Back-off.** If the faired strip intersects itself or a piece, its vertices return towards
//! their straight meridians: halfway in each round, and nearby vertices less. The rounds end when
//! nothing intersects, or when no fairing is left.
//!
//! **Blends** are tested in the same way, and return towards their positions without fairing.

use super::avoid_intersections::search_strip_without_intersections;
use super::existing_edges::ExistingEdges;
use super::meridian::Meridians;
use super::stitch_request::{Cells, Fairing, Finish, Intersections, Options, Rows};
use super::strip::Strip;
use super::strip_blend::{self, FAIRING_ATTEMPTS, StripBlend};
use super::strip_neighbourhood::{IntersectingTriangles, StripNeighbourhood};
use crate::blend::MAX_FAN_TRIANGLES;
use crate::fair::{Continuity, LaplacianWeights, Plate, minimise_plate_energy};
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::{Error, Result};
use gusset_base::job::Job;
use gusset_base::sort::sort_distinct;
use gusset_mesh::Mesh;

/// Largest number of rounds that reduce the fairing.
const MAX_BACK_OFF_ROUNDS: u32 = 12;

/// A vertex whose share of the fairing falls below this is no longer faired.
const MIN_FAIRING_SHARE: f64 = 0.1;

/// The fairing is reduced within this number of edges from an intersection.
const REDUCED_FAIRING_RINGS: u32 = 4;

pub(crate) struct CheckedStrip {
    /// See [`Stitch::intersections`](super::Stitch::intersections).
    pub(crate) intersections: Option<Vec<[u32; 2]>>,
    pub(super) back_offs: u32,
    pub(crate) finish: Finish,
}

/// Fairs the strip's rows, or replaces the strip by a blend, and looks for intersecting faces, as
/// the options request. `whole` has the pieces without the strip, and the rims are numbered as in
/// `whole`.
pub(crate) fn fair_and_check(
    whole: &Mesh,
    strip: &mut Strip,
    unit: f64,
    existing: &ExistingEdges,
    options: &Options,
    job: &Job<'_>,
) -> Result<CheckedStrip> {
    if options.finish == Finish::Blend && !strip.faces.corners.is_empty() {
        let checked = check_strip(whole, strip, unit, existing, options, &job.sub_job(0.0, 0.3))?;
        return check_blend(whole, strip, unit, checked, options, &job.sub_job(0.3, 1.0));
    }
    check_strip(whole, strip, unit, existing, options, job)
}

/// Fairs and checks a strip that is not replaced by a blend.
///
/// Rows over meridians by [`Meridians::Continuation`] use the meridians of a strip without
/// intersections, if the gap is wide or the rows would intersect.
fn check_strip(
    whole: &Mesh,
    strip: &mut Strip,
    unit: f64,
    existing: &ExistingEdges,
    options: &Options,
    job: &Job<'_>,
) -> Result<CheckedStrip> {
    let avoids = strip.meridians.len() > 1
        && options.meridians == Meridians::Continuation
        && options.intersections == Intersections::Auto;
    let rows = strip.grid.row_count();
    if rows == 0 {
        if avoids && options.cells == Cells::Triangles {
            let left = search_strip_without_intersections(whole, strip, existing, unit, options, job)?;
            return Ok(CheckedStrip { intersections: Some(left), back_offs: 0, finish: Finish::Strip });
        }
        return check_rows(whole, strip, unit, options, job);
    }
    let plain = Options { rows: Rows::None, cells: Cells::Triangles, ..*options };
    let better_meridians = |strip: &mut Strip, job: &Job<'_>| {
        let own = alloc::copied(&strip.meridians)?;
        match strip.set_meridians(own, 0, existing, &plain) {
            // Rows may run beside existing edges, which a strip without rows would repeat.
            Err(Error::NoStrip { .. }) => return Ok(()),
            other => other?,
        }
        search_strip_without_intersections(whole, strip, existing, unit, &plain, job)?;
        let found = std::mem::take(&mut strip.meridians);
        strip.set_meridians(found, rows, existing, options)
    };
    let is_wide = strip.has_wide_gap();
    if avoids && is_wide {
        better_meridians(strip, &job.sub_job(0.0, 0.3))?;
    }
    let checked = check_rows(whole, strip, unit, options, &job.sub_job(0.3, 0.6))?;
    if !avoids || is_wide || checked.intersections.as_ref().is_none_or(Vec::is_empty) {
        return Ok(checked);
    }
    better_meridians(strip, &job.sub_job(0.6, 0.7))?;
    check_rows(whole, strip, unit, options, &job.sub_job(0.7, 1.0))
}

/// Fairs and checks the rows of a strip.
fn check_rows(whole: &Mesh, strip: &mut Strip, unit: f64, options: &Options, job: &Job<'_>) -> Result<CheckedStrip> {
    let faired = options.fairing == Fairing::ThinPlate && !strip.grid.columns_and_fractions.is_empty();
    let rims = strip.rim_count();
    let mut neighbourhood = StripNeighbourhood::new(whole, strip, unit, alloc::copied(&strip.grid.points[rims..])?)?;
    // Round to the scalar type of the result, so that the tested positions are the returned ones.
    neighbourhood.round_new_vertices();
    let straight = alloc::copied(&neighbourhood.points)?;
    if faired {
        neighbourhood.fair_new_vertices(strip, &job.sub_job(0.0, 0.4))?;
        neighbourhood.round_new_vertices();
    }
    let checked = neighbourhood.check_and_back_off(straight, faired, options.intersections, &job.sub_job(0.4, 1.0))?;
    let points = neighbourhood.points;
    strip.grid.points.truncate(rims);
    alloc::append(&mut strip.grid.points, &points)?;
    Ok(checked)
}

/// Replaces a strip by the blend with the fewest intersections, the first of equals. Keeps the
/// strip if all blends have more intersections than the strip.
fn check_blend(
    whole: &Mesh,
    strip: &mut Strip,
    unit: f64,
    plain: CheckedStrip,
    options: &Options,
    job: &Job<'_>,
) -> Result<CheckedStrip> {
    let rims = strip.rim_count();
    let cuts = |checked: &CheckedStrip| checked.intersections.as_ref().map_or(0, Vec::len);
    let mut best: Option<(CheckedStrip, StripBlend)> = None;
    let Some(plan) = strip_blend::plan_strip_blend(whole, strip, unit, &job.sub_job(0.0, 0.2))? else {
        job.note(
            "a blend would need too many vertices, so the strip stays in its place: decimate the pieces, or set rows",
        );
        return Ok(plain);
    };
    let job = job.sub_job(0.2, 1.0);
    for (k, way) in FAIRING_ATTEMPTS.into_iter().enumerate() {
        let part = job.sub_job_of_item(k, FAIRING_ATTEMPTS.len());
        let mut found = strip_blend::create_strip_blend(&plan, strip, way, &part.sub_job(0.0, 0.5))?;
        // The strip's own faces are restored after this blend has been judged.
        let faces = std::mem::replace(&mut strip.faces, found.faces);
        let mut neighbourhood = StripNeighbourhood::new(whole, strip, unit, found.unfaired)?;
        neighbourhood.round_new_vertices();
        let straight = std::mem::replace(&mut neighbourhood.points, found.points);
        neighbourhood.round_new_vertices();
        let checked =
            neighbourhood.check_and_back_off(straight, true, options.intersections, &part.sub_job(0.5, 1.0))?;
        (found.points, found.unfaired) = (neighbourhood.points, Vec::new());
        found.faces = std::mem::replace(&mut strip.faces, faces);
        let count = cuts(&checked);
        if best.as_ref().is_none_or(|(best, _)| count < cuts(best)) {
            best = Some((checked, found));
        }
        if count == 0 {
            break;
        }
    }
    match best.filter(|(checked, _)| cuts(checked) <= cuts(&plain)) {
        None => {
            job.note("the blend would cut more faces than the strip, so the strip stays in its place");
            Ok(plain)
        }
        Some((checked, found)) => {
            let checked = CheckedStrip { finish: Finish::Blend, ..checked };
            strip.faces = found.faces;
            strip.grid.points.truncate(rims);
            alloc::append(&mut strip.grid.points, &found.points)?;
            strip.parents = found.parents;
            Ok(checked)
        }
    }
}

impl StripNeighbourhood<'_> {
    /// Looks for intersecting faces if requested. If the new vertices are `faired`, moves them back
    /// towards `straight` until the faired strip adds no intersections.
    fn check_and_back_off(
        &mut self,
        straight: Vec<DVec3>,
        faired: bool,
        intersections: Intersections,
        job: &Job<'_>,
    ) -> Result<CheckedStrip> {
        let mut checked = CheckedStrip { intersections: None, back_offs: 0, finish: Finish::Strip };
        if intersections == Intersections::Ignore {
            return Ok(checked);
        }
        let look = |round: u32| job.sub_job_of_item(round as usize, MAX_BACK_OFF_ROUNDS as usize + 2);
        let old = self.old_triangles_nearby(&straight, job)?;
        let mut found = self.find_intersections(&old, &look(0))?;
        let plate = alloc::copied(&self.points)?;
        let mut share = alloc::filled(1.0, plate.len())?;
        while faired && checked.back_offs < MAX_BACK_OFF_ROUNDS && self.reduce_fairing_shares(&found, &mut share)? {
            for (k, point) in self.points.iter_mut().enumerate() {
                *point = straight[k].lerp(plate[k], share[k]);
            }
            self.round_new_vertices();
            checked.back_offs += 1;
            found = self.find_intersections(&old, &look(checked.back_offs))?;
        }
        if faired && !found.pairs.is_empty() {
            // Use the straight rows if they have fewer intersections.
            let faired = std::mem::replace(&mut self.points, straight);
            let intersections = self.find_intersections(&old, &look(MAX_BACK_OFF_ROUNDS + 1))?;
            if intersections.pairs.len() < found.pairs.len() {
                found = intersections;
            } else {
                self.points = faired;
            }
        }
        checked.intersections = Some(self.pairs_of_faces(&old, &found)?);
        Ok(checked)
    }

    /// Moves the new vertices to the minimum of the thin plate's energy.
    fn fair_new_vertices(&mut self, strip: &Strip, job: &Job<'_>) -> Result<()> {
        let mut triangles = self.strip_triangles(&job.sub_job(0.0, 0.0))?.corners;
        let round = self.old_triangles(|face| face.iter().any(|&v| self.rim.contains(v)), job)?.corners;
        alloc::append(&mut triangles, &round)?;
        // Number the vertices of the patch consecutively.
        let mut vertices = alloc::collect(triangles.as_flattened().iter().copied())?;
        sort_distinct(&mut vertices);
        let number = |v: u32| vertices.binary_search(&v).unwrap_or(0) as u32;
        triangles.iter_mut().for_each(|t| *t = t.map(number));
        let mut valence = alloc::filled(0usize, vertices.len())?;
        triangles.as_flattened().iter().for_each(|&k| valence[k as usize] += 1);

        let mut points = alloc::collect(vertices.iter().map(|&v| self.position(v)))?;
        let is_end = |v: u32| self.end_vertices.binary_search(&v).is_ok();
        let is_new = |v: u32| v >= self.old_vertex_count;
        let on_rim = |v: u32| v < self.old_vertex_count && self.rim.contains(v);
        let free = alloc::collect(vertices.iter().map(|&v| is_new(v) && !is_end(v)))?;
        // A large fan says little about slopes, and its apex would tie all neighbours to each
        // other.
        let is_centre =
            |(k, &v): (usize, &u32)| (is_new(v) || (on_rim(v) && valence[k] <= MAX_FAN_TRIANGLES)) && !is_end(v);
        let centres = alloc::collect(vertices.iter().enumerate().map(is_centre))?;
        self.space_old_vertices_like_rows(strip, &vertices, &triangles, &mut points)?;
        let layout = alloc::collect(vertices.iter().map(|&v| match v.checked_sub(self.old_vertex_count) {
            Some(k) => strip.grid.regular_grid_position(k as usize),
            None => DVec3::ZERO,
        }))?;
        let plate = Plate {
            triangles: &triangles,
            is_free_vertex: &free,
            has_laplacian_in_energy: &centres,
            weights: LaplacianWeights::Uniform,
            continuity: Continuity::C1,
            shape: None,
            ordering_positions: Some(&layout),
        };
        minimise_plate_energy(&mut points, &plate, job)?;
        for (&v, &p) in vertices.iter().zip(&points) {
            if is_new(v) {
                self.points[(v - self.old_vertex_count) as usize] = p;
            }
        }
        Ok(())
    }

    /// Moves the old vertices beyond the rims, in the patch only, to the spacing of the rows. The
    /// plate assumes edges of equal length, and needs only the slope at the rim from these
    /// vertices.
    fn space_old_vertices_like_rows(
        &self,
        strip: &Strip,
        vertices: &[u32],
        triangles: &[[u32; 3]],
        points: &mut [DVec3],
    ) -> Result<()> {
        let lengths = strip.meridians.iter().map(|&[i, j]| strip.a.point(i).distance(strip.b.point(j)));
        let parts = strip.grid.matrix.len() / strip.meridians.len() - 1;
        let spacing = lengths.sum::<f64>() / strip.meridians.len() as f64 / parts as f64;
        let on_rim = |k: u32| vertices[k as usize] < self.old_vertex_count && self.rim.contains(vertices[k as usize]);
        let beyond = |k: u32| vertices[k as usize] < self.old_vertex_count && !self.rim.contains(vertices[k as usize]);
        let mut anchors = alloc::filled((DVec3::ZERO, 0.0), vertices.len())?;
        for triangle in triangles {
            for &k in triangle.iter().filter(|&&k| beyond(k)) {
                for &rim in triangle.iter().filter(|&&rim| on_rim(rim)) {
                    let (sum, count) = anchors[k as usize];
                    anchors[k as usize] = (sum + points[rim as usize], count + 1.0);
                }
            }
        }
        for (point, (sum, count)) in points.iter_mut().zip(anchors) {
            if count > 0.0 {
                let anchor = sum / count;
                *point = anchor + (*point - anchor).normalize_or_zero() * spacing;
            }
        }
        Ok(())
    }

    /// Reduces the plate's share at the new vertices of intersecting faces, and a little nearby.
    /// Returns false if no share is left at these vertices.
    fn reduce_fairing_shares(&self, found: &IntersectingTriangles, share: &mut [f64]) -> Result<bool> {
        let mut distance = alloc::filled(REDUCED_FAIRING_RINGS, share.len())?;
        let index = |v: u32| v.checked_sub(self.old_vertex_count).map(|k| k as usize);
        let intersecting = found.pairs.as_flattened().iter().filter_map(|&k| found.strip.corners.get(k as usize));
        for k in intersecting.flatten().filter_map(|&v| index(v)) {
            distance[k] = 0;
        }
        if !distance.iter().zip(&*share).any(|(&d, &s)| d == 0 && s > 0.0) {
            return Ok(false);
        }
        for _ in 1..REDUCED_FAIRING_RINGS {
            for triangle in &found.strip.corners {
                let least = triangle
                    .iter()
                    .filter_map(|&v| index(v))
                    .map(|k| distance[k])
                    .min()
                    .unwrap_or(REDUCED_FAIRING_RINGS);
                for k in triangle.iter().filter_map(|&v| index(v)) {
                    distance[k] = distance[k].min(least + 1);
                }
            }
        }
        for (s, d) in share.iter_mut().zip(distance) {
            *s *= 1.0 - 0.5 * f64::from(REDUCED_FAIRING_RINGS - d) / f64::from(REDUCED_FAIRING_RINGS);
            if *s < MIN_FAIRING_SHARE {
                *s = 0.0;
            }
        }
        Ok(true)
    }
}
