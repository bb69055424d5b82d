//! Missing nodes of sections: interpolated along the body from the nodes that are present.
//!
//! A missing node lies on the Catmull-Rom curve through the two nodes before it and the two behind
//! it in its column, by the pyramid of Barry and Goldman (1988). Near the ends of the body, it lies
//! on the parabola through three nodes or on a line.
//!
//! Parameters are centripetal (Lee 1989): between sections they grow by the square root of the
//! distance. The column itself lacks the distance to its missing node. Its parameters are the mean
//! over the nearest columns on either side that have all nodes of these sections. Without such
//! columns, they are the mean over all columns that have both nodes. O(points), and O(nearby
//! columns) for each missing node.

use super::frame_options::{Correspondence, FrameOptions};
use crate::identify::Outlines;
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::{Element, Error, Result};
use gusset_base::geom::scale::overflow_safe_distance;

/// A present node and its parameter.
type KnownNode = (f64, DVec3);

/// The number of columns to either side that are searched for parameters.
const MAX_COLUMNS_SEARCHED_PER_SIDE: usize = 64;

/// The sections as rows of nodes.
struct SectionRows {
    nodes: Vec<[f64; 3]>,
    is_missing: Vec<bool>,
    rows: usize,
    columns: usize,
    /// Whether the first section follows the last, and the first column the last.
    ring: bool,
    closed: bool,
}

/// Returns all points of the sections with the missing ones filled in, and the indices of the
/// filled ones, ascending.
pub(super) fn fill_missing(sections: &Outlines<'_>, options: &FrameOptions<'_>) -> Result<(Vec<[f64; 3]>, Vec<u32>)> {
    let is_given = options.correspondence == Correspondence::Given;
    Error::require(is_given, "missing", options.missing.len() as f64, "0 unless all nodes are given")?;
    let mut rows = SectionRows::new(sections, options)?;
    let parameters = rows.section_parameters()?;
    let mut present = Vec::new();
    for column in 0..rows.columns {
        present.clear();
        let all = (0..rows.rows).filter(|row| !rows.is_missing[row * rows.columns + column]);
        alloc::extend(&mut present, all)?;
        if present.len() < rows.rows {
            rows.fill_column(column, &present, &parameters)?;
        }
    }
    let all = (0..rows.nodes.len()).filter(|&node| rows.is_missing[node]);
    let filled = alloc::gather(all.map(|node| node as u32))?;
    Ok((rows.nodes, filled))
}

impl SectionRows {
    fn new(sections: &Outlines<'_>, options: &FrameOptions<'_>) -> Result<Self> {
        let rows = sections.check_offsets_and_constraints()?;
        let columns = sections.points_per_section(rows)?;
        if let Some(pole) = (0..rows).find(|&k| sections.point_range(k).len() != columns) {
            return Err(Error::SectionsDiffer { section: pole as u32, count: 1, expected: columns as u32 });
        }
        let mut is_missing = alloc::filled(false, sections.points.len())?;
        for &point in options.missing {
            let Some(mark) = is_missing.get_mut(point as usize) else {
                let count = sections.points.len() as u64;
                return Err(Error::NoSuch { element: Element::Point, index: point.into(), count });
            };
            *mark = true;
        }
        let mut nodes = alloc::with_capacity(is_missing.len())?;
        for (k, &is_missing) in is_missing.iter().enumerate() {
            let point = sections.points.get(k);
            if !is_missing {
                Error::check_finite(Element::Point, k as u64, point)?;
            }
            nodes.push(point.to_array());
        }
        Ok(SectionRows { nodes, is_missing, rows, columns, ring: options.ring, closed: sections.closed })
    }

    fn node_if_present(&self, row: usize, column: usize) -> Option<DVec3> {
        let place = row * self.columns + column;
        (!self.is_missing[place]).then(|| DVec3::from_array(self.nodes[place]))
    }

    /// Returns the parameters of the sections, and of the first one after the last of a ring.
    fn section_parameters(&self) -> Result<Vec<f64>> {
        let mut steps = alloc::filled(0.0, self.rows)?;
        for (row, step) in steps.iter_mut().enumerate() {
            let next = (row + 1) % self.rows;
            let pairs = (0..self.columns)
                .filter_map(|column| self.node_if_present(row, column).zip(self.node_if_present(next, column)));
            let (sum, count) =
                pairs.fold((0.0, 0.0), |(sum, count), (p, q)| (sum + overflow_safe_distance(p, q).sqrt(), count + 1.0));
            *step = if count > 0.0 { sum / count } else { 0.0 };
        }
        // If no column has both nodes, or all such pairs coincide, use the mean of the other steps.
        let known = || steps.iter().filter(|&&step| step > 0.0);
        let mean = if known().next().is_some() { known().sum::<f64>() / known().count() as f64 } else { 1.0 };
        let mut parameters = alloc::with_capacity(self.rows + 1)?;
        let mut at = 0.0;
        parameters.push(at);
        for step in steps {
            at += if step > 0.0 { step } else { mean };
            parameters.push(at);
        }
        Ok(parameters)
    }

    /// Returns the parameters of sections `first` to `last`, counted modulo the sections in a ring.
    /// They come from the nearest columns on either side that have all their nodes.
    fn nearby_parameters(&self, column: usize, first: isize, last: isize) -> Result<Option<Vec<f64>>> {
        let count = (last - first + 1) as usize;
        let mut sum = alloc::filled(0.0, count)?;
        let mut found = false;
        for backwards in [false, true] {
            let away = (1..=MAX_COLUMNS_SEARCHED_PER_SIDE.min(self.columns - 1)).filter_map(|step| {
                let within = if backwards { step <= column } else { column + step < self.columns };
                let other = column + if backwards { self.columns - step } else { step };
                (within || self.closed).then_some(other % self.columns)
            });
            let step = |column: usize, k: usize| {
                let row = |k: usize| (first + k as isize).rem_euclid(self.rows as isize) as usize;
                let (p, q) = (self.node_if_present(row(k), column)?, self.node_if_present(row(k + 1), column)?);
                Some(overflow_safe_distance(p, q).sqrt()).filter(|&step| step > 0.0)
            };
            let mut complete = away.filter(|&other| (0..count - 1).all(|k| step(other, k).is_some()));
            if let Some(other) = complete.next() {
                let mut at = 0.0;
                for (k, sum) in sum[1..].iter_mut().enumerate() {
                    at += step(other, k).unwrap_or(0.0);
                    *sum += at;
                }
                found = true;
            }
        }
        Ok(found.then_some(sum))
    }

    /// Fills the nodes of a column whose rows are not `present`.
    fn fill_column(&mut self, column: usize, present: &[usize], parameters: &[f64]) -> Result<()> {
        let (count, all) = (present.len() as isize, self.rows as isize);
        // Indexes the present nodes, cyclically in a ring, and returns their rows.
        let known = |k: isize| {
            if count == 0 || (!self.ring && !(0..count).contains(&k)) {
                return None;
            }
            let row = present[k.rem_euclid(count) as usize];
            Some((row as isize + k.div_euclid(count) * all, self.node_if_present(row, column)?))
        };
        let mut found = Vec::new();
        for row in (0..self.rows).filter(|&row| self.node_if_present(row, column).is_none()) {
            let next = present.partition_point(|&other| other < row) as isize;
            let (Some(before), Some(after), true) = (known(next - 1), known(next), count > 1) else {
                return Err(Error::NoNode { section: row as u32, column: column as u32 });
            };
            let outer = [known(next - 2), known(next + 1)];
            let (first, last) = (outer[0].map_or(before.0, |node| node.0), outer[1].map_or(after.0, |node| node.0));
            let nearby = self.nearby_parameters(column, first, last)?;
            let parameter = |row: isize| match &nearby {
                Some(parameters) => parameters[(row - first) as usize],
                None => parameters[row.rem_euclid(all) as usize] + row.div_euclid(all) as f64 * parameters[self.rows],
            };
            let at = |(row, node): (isize, DVec3)| (parameter(row), node);
            let node = interpolate_catmull_rom(
                [before, after].map(at),
                outer.map(|node| node.map(at)),
                parameter(row as isize),
            );
            alloc::push(&mut found, (row, node))?;
        }
        for (row, node) in found {
            self.nodes[row * self.columns + column] = node.to_array();
        }
        Ok(())
    }
}

/// Returns the point at parameter x of the curve through the nodes before and after x and their
/// outer neighbours. Either outer neighbour may be absent.
fn interpolate_catmull_rom([(b, p), (c, q)]: [KnownNode; 2], [first, last]: [Option<KnownNode>; 2], x: f64) -> DVec3 {
    let between = |(a, p): KnownNode, (b, q): KnownNode| p.lerp(q, (x - a) / (b - a));
    let middle = between((b, p), (c, q));
    let left = first.map(|(a, o)| between((a, between((a, o), (b, p))), (c, middle)));
    let right = last.map(|(d, r)| between((b, middle), (d, between((c, q), (d, r)))));
    match (left, right) {
        (Some(left), Some(right)) => between((b, left), (c, right)),
        (left, right) => left.or(right).unwrap_or(middle),
    }
}
