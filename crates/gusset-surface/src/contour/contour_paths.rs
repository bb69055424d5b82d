//! Joins the paths of single sheets across sheet boundaries, and adds points and normals.
//!
//! Cost: O(n log n) for n paths of sheets, and O(1) for each point.

use super::contour_chain::{ContourPath, ContourPaths, chain_arcs};
use super::contour_lattice::ContourLattice;
use super::contour_search::ContourArcs;
use crate::{Paths, Place, Surface};
use glam::{DVec2, DVec3};
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_base::sort;
use gusset_base::{alloc, par};

/// Number of places that a thread evaluates in one task.
const PLACES_PER_TASK: usize = 1024;

/// The paths of all sheets, and unresolved places.
#[derive(Default)]
pub(super) struct SheetContourSet {
    sheets: ContourPaths,
    pub(super) unresolved: Vec<Place>,
}

impl SheetContourSet {
    pub(super) fn add_sheet_arcs(
        &mut self,
        sheet: usize,
        mut found: ContourArcs,
        lattice: &ContourLattice,
        has_jumps: bool,
        threads: usize,
    ) -> Result<()> {
        let place = |&(cell, at): &([u32; 2], DVec2)| Place { sheet: sheet as u32, cell, u: at.x, v: at.y };
        alloc::extend(&mut self.unresolved, found.unresolved.iter().map(place))?;
        chain_arcs(sheet as u32, &mut found, lattice, has_jumps, threads, &mut self.sheets)
    }

    /// Joins the paths of all sheets. Sorts them by level, then by first path.
    pub(super) fn into_paths(self, surface: &Surface<'_>, job: &Job<'_>) -> Result<Paths> {
        let sheet_paths = EvaluatedContours::new(surface, self.sheets, job)?;
        let tolerance = surface.tolerance();
        let after = sheet_paths.link_ends_to_nearest_starts(tolerance)?;
        let mut entered = alloc::filled(false, after.len())?;
        after.iter().flatten().for_each(|&k| entered[k] = true);
        let mut used = alloc::filled(false, after.len())?;
        // First open sequences from their beginnings, then closed ones; both by their lowest parts.
        let mut sequences: Vec<(usize, usize)> = Vec::new();
        for k in (0..after.len()).filter(|&k| !entered[k]).chain(0..after.len()) {
            let (mut lowest, mut at) = (k, Some(k));
            if used[k] {
                continue;
            }
            while let Some(contour) = at.filter(|&contour| !used[contour]) {
                used[contour] = true;
                lowest = lowest.min(contour);
                at = after[contour];
            }
            alloc::push(&mut sequences, (lowest, k))?;
        }
        sequences.sort_unstable();
        let mut paths = Paths { ends: vec![0], unresolved: self.unresolved, ..Paths::default() };
        paths.reserve_points(sheet_paths.places.len())?;
        let mut sequence = Vec::new();
        for (_, first) in sequences {
            sequence.clear();
            let mut at = Some(first);
            while let Some(contour) = at {
                alloc::push(&mut sequence, contour)?;
                at = after[contour].filter(|&next| next != first);
            }
            let last = sequence[sequence.len() - 1];
            let closed = sheet_paths.contours[first].closed || after[last] == Some(first);
            if !closed {
                let ends = [sheet_paths.contours[first].place_range[0], sheet_paths.contours[last].place_range[1] - 1];
                sheet_paths.list_inner_ends_as_unresolved(surface, ends, &mut paths)?;
            }
            sheet_paths.add_joined_path(&sequence, closed, tolerance, &mut paths)?;
        }
        keep_first_of_each_cell(&mut paths.unresolved)?;
        Ok(paths)
    }
}

/// The paths of all sheets, with points and normals.
struct EvaluatedContours {
    contours: Vec<ContourPath>,
    places: Vec<Place>,
    points: Vec<DVec3>,
    normals: Vec<DVec3>,
}

impl EvaluatedContours {
    fn new(surface: &Surface<'_>, sheets: ContourPaths, job: &Job<'_>) -> Result<Self> {
        let ContourPaths { paths: mut contours, places } = sheets;
        sort::sort_stable(&mut contours, &|a, b| a.level.cmp(&b.level));
        let count = places.len();
        let (mut points, mut normals) = (alloc::filled(DVec3::ZERO, count)?, alloc::filled(DVec3::ZERO, count)?);
        let parts = places
            .chunks(PLACES_PER_TASK)
            .zip(points.chunks_mut(PLACES_PER_TASK))
            .zip(normals.chunks_mut(PLACES_PER_TASK));
        par::map_cancellable(job, "points", parts, |((places, points), normals)| {
            surface.points_and_normals(places, points, normals);
        })?;
        Ok(EvaluatedContours { contours, places, points, normals })
    }

    /// The successor of each path. Joins open paths whose ends are within `tolerance`, each to the
    /// nearest free one.
    fn link_ends_to_nearest_starts(&self, tolerance: f64) -> Result<Vec<Option<usize>>> {
        let mut after = alloc::filled(None, self.contours.len())?;
        let open = || (0..self.contours.len()).filter(|&k| !self.contours[k].closed);
        let head = |k: usize| self.points[self.contours[k].place_range[0]];
        let tail = |k: usize| self.points[self.contours[k].place_range[1] - 1];
        let mut heads = alloc::gather(open())?;
        sort::sort_stable(&mut heads, &|&a, &b| {
            let by = |k: usize| self.contours[k].level;
            by(a).cmp(&by(b)).then(head(a).x.total_cmp(&head(b).x)).then(a.cmp(&b))
        });
        let mut taken = alloc::filled(false, heads.len())?;
        for k in open() {
            let (level, end) = (self.contours[k].level, tail(k));
            let before = |&other: &usize| (self.contours[other].level, head(other).x) < (level, end.x - tolerance);
            let from = heads.partition_point(before);
            let mut best: Option<(f64, usize)> = None;
            for (at, &other) in heads.iter().enumerate().skip(from) {
                if self.contours[other].level != level || head(other).x > end.x + tolerance {
                    break;
                }
                let distance = head(other).distance(end);
                if !taken[at] && distance <= tolerance && best.is_none_or(|(min, _)| distance < min) {
                    best = Some((distance, at));
                }
            }
            if let Some((_, at)) = best {
                taken[at] = true;
                after[k] = Some(heads[at]);
            }
        }
        Ok(after)
    }

    /// Adds one path that consists of successive paths of sheets. Skips points within `tolerance`
    /// of the previous one. A path as small as a point is listed as unresolved.
    fn add_joined_path(&self, contours: &[usize], closed: bool, tolerance: f64, paths: &mut Paths) -> Result<()> {
        let first = paths.points.len();
        let point_numbers =
            || contours.iter().flat_map(|&k| self.contours[k].place_range[0]..self.contours[k].place_range[1]);
        let push = |at: usize, paths: &mut Paths| paths.push_point(self.places[at], self.points[at], self.normals[at]);
        for at in point_numbers() {
            let near = paths.points.len() > first
                && paths.points.last().is_some_and(|last| last.distance(self.points[at]) <= tolerance);
            if !near {
                push(at, paths)?;
            }
        }
        let last = point_numbers().next_back();
        let ends = |paths: &Paths| paths.points.len() > first + 1;
        if closed {
            while ends(paths) && paths.points[paths.points.len() - 1].distance(paths.points[first]) <= tolerance {
                paths.truncate_points(paths.points.len() - 1);
            }
        } else if let Some(last) = last.filter(|&last| ends(paths) && paths.points.last() != Some(&self.points[last])) {
            // The end itself is kept, and points close to it are skipped.
            paths.truncate_points(paths.points.len() - 1);
            push(last, paths)?;
        }
        if paths.points.len() < first + if closed { 3 } else { 2 } {
            alloc::push(&mut paths.unresolved, paths.places[first])?;
            paths.truncate_points(first);
            return Ok(());
        }
        paths.finish_current_path(closed, self.contours[contours[0]].level)
    }

    /// Lists ends that are not on an open edge as unresolved. They occur where fields are
    /// discontinuous.
    fn list_inner_ends_as_unresolved(&self, surface: &Surface<'_>, ends: [usize; 2], paths: &mut Paths) -> Result<()> {
        for place in ends.map(|end| self.places[end]) {
            let sheet = ContourLattice::new(surface.sheet(place.sheet as usize));
            if !sheet.is_place_on_open_edge(place.cell, [place.u, place.v]) {
                alloc::push(&mut paths.unresolved, place)?;
            }
        }
        Ok(())
    }
}

/// Keeps the first place of each cell, in order. Several levels, or pieces of curves, may list the
/// same cell.
fn keep_first_of_each_cell(places: &mut Vec<Place>) -> Result<()> {
    let cell = |place: &Place| (place.sheet, place.cell);
    let mut by: Vec<usize> = alloc::collect(0..places.len())?;
    sort::sort_stable(&mut by, &|&a, &b| (cell(&places[a]), a).cmp(&(cell(&places[b]), b)));
    by.dedup_by_key(|&mut k| cell(&places[k]));
    by.sort_unstable();
    *places = alloc::collect(by.into_iter().map(|k| places[k]))?;
    Ok(())
}

/// Adds paths of one point each with the given levels, and sorts all paths by level. Points of one
/// level within the tolerance of each other are merged, because both cells find a point on their
/// common side.
pub(super) fn add_point_paths(surface: &Surface<'_>, points: &[(u32, Place)], paths: &mut Paths) -> Result<()> {
    if points.is_empty() {
        return Ok(());
    }
    let frames = alloc::collect(points.iter().map(|&(_, place)| surface.point_and_normal(place)))?;
    let mut by: Vec<usize> = alloc::collect(0..points.len())?;
    sort::sort_stable(&mut by, &|&a, &b| {
        points[a].0.cmp(&points[b].0).then(frames[a].0.x.total_cmp(&frames[b].0.x)).then(a.cmp(&b))
    });
    let mut dropped = alloc::filled(false, points.len())?;
    for (at, &k) in by.iter().enumerate() {
        for &other in &by[at + 1..] {
            if points[other].0 != points[k].0 || frames[other].0.x > frames[k].0.x + surface.tolerance() {
                break;
            }
            if frames[other].0.distance(frames[k].0) <= surface.tolerance() {
                dropped[other.max(k)] = true;
            }
        }
    }
    for k in (0..points.len()).filter(|&k| !dropped[k]) {
        paths.push_point(points[k].1, frames[k].0, frames[k].1)?;
        paths.finish_current_path(false, points[k].0)?;
    }
    *paths = sort_paths_by_level(std::mem::take(paths))?;
    Ok(())
}

/// The paths sorted by level.
fn sort_paths_by_level(mut given: Paths) -> Result<Paths> {
    let mut order: Vec<usize> = alloc::collect(0..given.len())?;
    sort::sort_stable(&mut order, &|&a, &b| (given.levels[a], a).cmp(&(given.levels[b], b)));
    let unresolved = std::mem::take(&mut given.unresolved);
    let mut sorted = Paths { ends: vec![0], unresolved, ..Paths::default() };
    for k in order {
        for at in given.point_range(k) {
            sorted.push_point(given.places[at], given.points[at], given.normals[at])?;
        }
        sorted.finish_current_path(given.closed[k], given.levels[k])?;
    }
    Ok(sorted)
}
