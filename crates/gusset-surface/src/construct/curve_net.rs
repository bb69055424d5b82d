//! The surface through a net of curves.
//!
//! W. J. Gordon, *Spline-blended surface interpolation through curve networks* (1969). Let R_k(v)
//! be the rows, C_l(u) the columns, P_kl the nodes where they meet, and L_k, M_l cardinal
//! functions. The surface
//!   S(u, v) = sum L_k(u) R_k(v) + sum M_l(v) (C_l(u) - sum L_k(u) P_kl)
//! contains all curves. The Bernstein coefficients of a product of polynomials of u and of v are
//! the products of their coefficients. S is therefore a Bézier patch over each cell, of degree 3 or
//! the degree of the curves. With two rows and two columns, L and M are linear, and S is the Coons
//! patch. Without columns, S is the skin of the rows.

use super::cardinal_pieces::{CardinalPiece, cardinal_pieces};
use super::line_strips::{LineStrips, fill_zero_lengths};
use super::nearest_points::{SegmentBoxTree, nearest_points_of_curves};
use super::net_curve::{CurvePiece, CurvePlace, NetCurve, max_segment_degree};
use super::net_order::order_of_lines;
use crate::axis::NODES_PER_CUBIC;
use crate::{MAX_NODES, Patch, Patches, Sheet};
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::{Error, Result};
use gusset_base::geom::Aabb;
use gusset_base::job::Job;
use gusset_curve::CurveView;

/// Number of patches between two progress reports.
const PATCHES_PER_REPORT: usize = 1 << 13;
const NODE_STAGE: &str = "finding nodes";
const PATCH_STAGE: &str = "making patches";

/// Curves across (rows) and along (columns). Every row meets every column. Curves may run in either
/// direction, and may be listed in any order: if they do not meet in the given order, they are sorted
/// by the places where they meet. Rows alone, or columns alone, make a skin, in the given order. A
/// curve may be a single point, which makes a pole.
///
/// Ends of rows beyond the first and the last column are cut off; so are ends of columns. Polylines
/// are curves of degree 1, so the surface has a crease where they turn. For a smooth surface, first
/// fit curves through their points ([`fit`](gusset_curve::fit())).
#[derive(Debug, Clone, Copy)]
pub struct CurveNet<'a> {
    /// The curves in v: at least 2, or none. Without columns, in order of u.
    pub rows: &'a [CurveView<'a>],
    /// The curves in u: at least 2, or none. Without rows, in order of v.
    pub columns: &'a [CurveView<'a>],
    /// Whether the net is closed in u and in v. If closed in u, the columns are closed curves, and
    /// the first row follows the last one; at least 3 rows are needed, if there are any. Closed in
    /// v accordingly.
    pub closed: [bool; 2],
    /// Largest distance between curves where they meet. Both are then moved to the midpoint. `None`
    /// means 1e-6 times the diagonal of their bounding box.
    pub tolerance: Option<f64>,
}

impl Sheet<'static> {
    /// Creates the Gordon surface of a net of curves. It contains all curves, within half the
    /// tolerance where they do not meet exactly.
    ///
    /// Node (k, l) is a corner of cells. Curves may have several segments between two nodes. If all
    /// rows have the same number of segments there, these are matched in order. Otherwise, all rows
    /// are cut where any row has a joint, so cells may be smaller than the meshes of the net. The
    /// knots of the cardinal functions follow from the curves. S is C1 if the curves are C1 in
    /// common knots, or if the curves lack joints between nodes. Otherwise S is only nearly C1;
    /// [`Sheet::largest_crease_angle`] measures it.
    ///
    /// O(rows x columns x log segments) for nodes, and 12 products for each control point; 384
    /// bytes for each cell up to degree 3, otherwise 1536.
    ///
    /// # Errors
    /// [`Error::NetTooSmall`] for a single row or column, or fewer than 3 in a closed direction;
    /// [`Error::EmptyCurve`]; [`Error::OptionOutOfRange`] if a degree is above 7, or the tolerance
    /// is negative or not finite; [`Error::CurveNotClosed`]; [`Error::CurvesApart`] with the row,
    /// the column and their distance; [`Error::CurvesOutOfOrder`]; [`Error::TooLarge`],
    /// [`Error::OutOfMemory`], [`Error::Cancelled`].
    pub fn from_curves(net: &CurveNet<'_>, job: &Job<'_>) -> Result<Self> {
        net.check_curves()?;
        if max_segment_degree(net.rows.iter().chain(net.columns).copied())? <= 3 {
            Ok(Sheet::Cubic(
                GordonSurface::from_net(net, &job.sub_job(0.0, 0.5))?.compute_patches(&job.sub_job(0.5, 1.0))?,
            ))
        } else {
            Ok(Sheet::High(
                GordonSurface::from_net(net, &job.sub_job(0.0, 0.5))?.compute_patches(&job.sub_job(0.5, 1.0))?,
            ))
        }
    }
}

impl CurveNet<'_> {
    fn check_curves(&self) -> Result<()> {
        let [rows, columns] = [self.rows.len(), self.columns.len()];
        let enough = |count: usize, closed: bool| count == 0 || count >= if closed { 3 } else { 2 };
        if rows + columns == 0 || !enough(rows, self.closed[0]) || !enough(columns, self.closed[1]) {
            return Err(Error::NetTooSmall { rows: rows as u64, columns: columns as u64 });
        }
        let tolerance = self.tolerance.unwrap_or(0.0);
        Error::require(tolerance >= 0.0 && tolerance.is_finite(), "tolerance", tolerance, "finite and at least 0")
    }

    /// The diagonal of the bounding box of all curves, and their largest absolute coordinate.
    fn diagonal_and_max_coordinate(&self) -> (f64, f64) {
        let bounds = Aabb::from_points(self.rows.iter().chain(self.columns).flat_map(CurveView::points));
        (bounds.diagonal(), bounds.low.abs().max(bounds.high.abs()).max_element())
    }
}

/// The curves of a net, cut at the nodes.
pub(super) struct GordonSurface<const N: usize> {
    closed: [bool; 2],
    /// Piece j of row k runs from column j to the next one. Without columns, each row is one piece.
    /// Columns accordingly.
    rows: Vec<Vec<CurvePiece<N>>>,
    columns: Vec<Vec<CurvePiece<N>>>,
    /// The nodes, row by row.
    nodes: Vec<DVec3>,
    /// For each row and each column, whether it is a single point. These curves do not affect
    /// lengths and breaks.
    is_curve_a_point: [Vec<bool>; 2],
}

impl<const N: usize> GordonSurface<N> {
    /// Finds the nodes, where the curves are nearest to each other, and cuts the curves there.
    fn from_net(net: &CurveNet<'_>, job: &Job<'_>) -> Result<Self> {
        let total = (net.rows.len() + net.columns.len()) as f64;
        let net_curves = |curves: &[CurveView<'_>], before: usize| {
            alloc::try_collect((0..curves.len()).map(|k| {
                job.step(0.1 * (before + k) as f64 / total, NODE_STAGE)?;
                NetCurve::new(&curves[k])
            }))
        };
        let (rows, columns) = (net_curves(net.rows, 0)?, net_curves(net.columns, net.rows.len())?);
        let boxes = |net_curves: &[NetCurve<N>], before: usize| {
            alloc::try_collect((0..net_curves.len()).map(|k| {
                job.step(0.1 + 0.1 * (before + k) as f64 / total, NODE_STAGE)?;
                SegmentBoxTree::from_curve(&net_curves[k])
            }))
        };
        let (row_boxes, column_boxes) = (boxes(&rows, 0)?, boxes(&columns, rows.len())?);
        let (size, max_coordinate) = net.diagonal_and_max_coordinate();
        let tolerance = net.tolerance.unwrap_or(1e-6 * size);
        let rounding_error = 4.0 * f64::EPSILON * max_coordinate;
        // Lengths below this are neither searched for nor cut off.
        let slack = (0.25 * tolerance).min(1e-9 * size) + rounding_error;
        let count = rows.len() * columns.len();
        let places = alloc::try_collect((0..count).map(|n| {
            let (k, l) = (n / columns.len(), n % columns.len());
            job.step(0.2 + 0.6 * n as f64 / count as f64, NODE_STAGE)?;
            let met = nearest_points_of_curves([&rows[k], &columns[l]], [&row_boxes[k], &column_boxes[l]], slack)?;
            if met.distance > tolerance.max(rounding_error) {
                return Err(Error::CurvesApart { row: k as u32, column: l as u32, distance: met.distance });
            }
            Ok::<_, Error>([
                snap_place_to_joint(&rows[k], met.places[0], slack),
                snap_place_to_joint(&columns[l], met.places[1], slack),
            ])
        }))?;
        GordonSurface::from_unsorted_curves(rows, columns, net.closed, &places, &job.sub_job(0.8, 1.0))
    }

    /// Sorts the curves if they cross each other in another order than given. Curves of a skin run in the
    /// direction of the first one. `places` holds, row by
    /// row, the places on the row and the column where they meet.
    fn from_unsorted_curves(
        rows: Vec<NetCurve<N>>,
        columns: Vec<NetCurve<N>>,
        closed: [bool; 2],
        places: &[[CurvePlace; 2]],
        job: &Job<'_>,
    ) -> Result<Self> {
        let width = columns.len();
        let points = |curves: &[NetCurve<N>]| alloc::collect(curves.iter().map(NetCurve::is_single_point));
        let row_order = order_of_lines(&points(&columns)?, rows.len(), closed[0], &|l, k| places[k * width + l][1])?;
        let column_order = order_of_lines(&points(&rows)?, width, closed[1], &|k, l| places[k * width + l][0])?;
        let sorted =
            alloc::gather(row_order.iter().flat_map(|&k| column_order.iter().map(move |&l| places[k * width + l])))?;
        let (mut rows, mut columns) = (permuted(rows, &row_order)?, permuted(columns, &column_order)?);
        if rows.is_empty() || columns.is_empty() {
            align_directions(&mut rows);
            align_directions(&mut columns);
        }
        GordonSurface::from_crossing_curves(rows, columns, closed, &sorted, job).map_err(|error| match error {
            Error::CurvesOutOfOrder { row, column, curve } => Error::CurvesOutOfOrder {
                row: row_order[row as usize] as u32,
                column: column_order[column as usize] as u32,
                curve,
            },
            error => error,
        })
    }

    /// `places` holds, row by row, the places on the row and the column where they meet.
    pub(super) fn from_crossing_curves(
        mut rows: Vec<NetCurve<N>>,
        mut columns: Vec<NetCurve<N>>,
        closed: [bool; 2],
        places: &[[CurvePlace; 2]],
        job: &Job<'_>,
    ) -> Result<Self> {
        let [height, width] = [rows.len(), columns.len()];
        let points = |curves: &[NetCurve<N>]| alloc::collect(curves.iter().map(NetCurve::is_single_point));
        let points = [points(&rows)?, points(&columns)?];
        let nodes = places.iter().enumerate().map(|(n, &[on_row, on_column])| {
            let (k, l) = (n / width, n % width);
            let (p, q) = (rows[k].point_at(on_row), columns[l].point_at(on_column));
            match (points[0][k], points[1][l]) {
                (true, _) => p,
                (false, true) => q,
                (false, false) => 0.5 * (p + q),
            }
        });
        let nodes = alloc::collect_cancellable(nodes, &job.sub_job(0.0, 0.0), NODE_STAGE)?;
        // Axis 0: cuts rows at the columns. Axis 1: cuts columns at the rows.
        let cut = |net_curves: &mut [NetCurve<N>], axis: usize| {
            let count = [width, height][axis];
            let place = |k: usize, l: usize| if axis == 0 { (k, l) } else { (l, k) };
            let number = |(row, column): (usize, usize)| row * width + column;
            alloc::try_collect((0..net_curves.len()).map(|k| {
                job.step((axis * height + k) as f64 / (height + width) as f64, NODE_STAGE)?;
                let at = alloc::collect((0..count).map(|l| places[number(place(k, l))][axis]))?;
                let ends = |l: usize| nodes[number(place(k, l % count.max(1)))];
                let out_of_order = |l: usize| {
                    let (row, column) = place(k, l);
                    Error::CurvesOutOfOrder { row: row as u32, column: column as u32, curve: ["row", "column"][axis] }
                };
                cut_curve_at_places(&mut net_curves[k], at, closed[1 - axis], ends, out_of_order)
            }))
        };
        let (along_rows, along_columns) = (cut(&mut rows, 0)?, cut(&mut columns, 1)?);
        Ok(GordonSurface { closed, rows: along_rows, columns: along_columns, nodes, is_curve_a_point: points })
    }

    /// Computes the patches over all cells.
    pub(super) fn compute_patches(&self, job: &Job<'_>) -> Result<Patches<N>> {
        if self.rows.is_empty() {
            let skin = self.compute_skin_patches(
                &self.columns,
                &self.is_curve_a_point[1],
                self.closed[1],
                &job.sub_job(0.0, 0.8),
            )?;
            return transpose_patches(&skin, &job.sub_job(0.8, 1.0));
        }
        if self.columns.is_empty() {
            return self.compute_skin_patches(&self.rows, &self.is_curve_a_point[0], self.closed[0], job);
        }
        let u = LineStrips::from_curves(&self.columns, &self.is_curve_a_point[1], &job.sub_job(0.0, 0.1))?;
        let v = LineStrips::from_curves(&self.rows, &self.is_curve_a_point[0], &job.sub_job(0.1, 0.2))?;
        let (blend_u, blend_v) =
            (cardinal_pieces(&u.lengths, self.closed[0])?, cardinal_pieces(&v.lengths, self.closed[1])?);
        let rows = v.refine_curves_to_cells(&self.rows, &job.sub_job(0.2, 0.3))?;
        let columns = u.refine_curves_to_cells(&self.columns, &job.sub_job(0.3, 0.4))?;
        let cells_v = alloc::collect(v.strips_and_ranges_of_cells()?.into_iter().map(|(strip, part)| {
            let piece = &blend_v[strip];
            (piece.lines, piece.bernstein_weights::<N>(part))
        }))?;
        let mut patches = patches_with_capacity(u.cell_count(), v.cell_count())?;
        for (i, (strip, part)) in u.strips_and_ranges_of_cells()?.into_iter().enumerate() {
            let piece = &blend_u[strip];
            let across = piece.bernstein_weights::<N>(part);
            // C_l - sum L_k P_kl, which is 0 at nodes.
            let rest = alloc::collect((0..self.columns.len()).map(|l| {
                let nodes = piece.lines.map(|k| self.nodes[k * self.columns.len() + l]);
                let curve = columns[l][i];
                std::array::from_fn::<DVec3, N, _>(|a| curve[a] - weighted_point_sum(&across[a], &nodes))
            }))?;
            for (j, (lines, along)) in cells_v.iter().enumerate() {
                job.sub_job(0.4, 1.0).step_every(PATCHES_PER_REPORT, patches.len(), patches.capacity(), PATCH_STAGE)?;
                let (rows, rest) = (piece.lines.map(|k| &rows[k][j]), lines.map(|l| &rest[l]));
                let point = |a: usize, b: usize| {
                    weighted_point_sum(&across[a], &rows.map(|row| row[b]))
                        + weighted_point_sum(&along[b], &rest.map(|rest| rest[a]))
                };
                let points = std::array::from_fn(|a| std::array::from_fn(|b| point(a, b)));
                patches.push(Patch { points });
            }
        }
        Ok(Patches::from_patches(patches, u.cell_count(), v.cell_count()))
    }

    /// Computes the sum of L_k R_k only.
    fn compute_skin_patches(
        &self,
        rows: &[Vec<CurvePiece<N>>],
        points: &[bool],
        closed: bool,
        job: &Job<'_>,
    ) -> Result<Patches<N>> {
        let v = LineStrips::from_curves(rows, points, &job.sub_job(0.0, 0.2))?;
        let refined = v.refine_curves_to_cells(rows, &job.sub_job(0.2, 0.4))?;
        let blend = cardinal_pieces(&row_distances(&refined, closed)?, closed)?;
        blend_rows(&refined, &blend, &job.sub_job(0.4, 1.0))
    }
}

/// The mean distance of each row from the next one; in a closed direction, also of the last row from
/// the first one. `rows` are the segments of each row.
pub(super) fn row_distances<const N: usize>(rows: &[Vec<[DVec3; N]>], closed: bool) -> Result<Vec<f64>> {
    let apart = |k: usize| {
        let (row, next) = (&rows[k], &rows[(k + 1) % rows.len()]);
        let sum: f64 = row.iter().zip(next).map(|(a, b)| a[0].distance(b[0]) + a[N - 1].distance(b[N - 1])).sum();
        sum / (2 * row.len()) as f64
    };
    Ok(fill_zero_lengths(alloc::collect((0..rows.len() - usize::from(!closed)).map(apart))?))
}

/// Computes the patches between rows of segments. `blend` has the functions that blend the rows in each
/// interval between them.
pub(super) fn blend_rows<const N: usize>(
    rows: &[Vec<[DVec3; N]>],
    blend: &[CardinalPiece],
    job: &Job<'_>,
) -> Result<Patches<N>> {
    let cells = rows.first().map_or(0, Vec::len);
    let mut patches = patches_with_capacity(blend.len(), cells)?;
    for piece in blend {
        let across = piece.bernstein_weights::<N>([0.0, 1.0]);
        let patch = |j: usize| {
            let segments = piece.lines.map(|k| &rows[k][j]);
            let point = |a: usize, b: usize| weighted_point_sum(&across[a], &segments.map(|segment| segment[b]));
            Patch { points: std::array::from_fn(|a| std::array::from_fn(|b| point(a, b))) }
        };
        for j in 0..cells {
            job.step_every(PATCHES_PER_REPORT, patches.len(), patches.capacity(), PATCH_STAGE)?;
            patches.push(patch(j));
        }
    }
    Ok(Patches::from_patches(patches, blend.len(), cells))
}

/// Reverses open curves of a skin that run against the curve before them.
fn align_directions<const N: usize>(curves: &mut [NetCurve<N>]) {
    let ends = |curve: &NetCurve<N>| {
        let last = curve.segments.len() - 1;
        [curve.segments[0][0], curve.segments[last][N - 1]]
    };
    for k in 1..curves.len() {
        let ([a, b], [c, d]) = (ends(&curves[k - 1]), ends(&curves[k]));
        if !curves[k].closed && a.distance(d) + b.distance(c) < a.distance(c) + b.distance(d) {
            curves[k].reverse_direction();
        }
    }
}

/// Returns the elements of a list in an order.
fn permuted<T>(list: Vec<T>, order: &[usize]) -> Result<Vec<T>> {
    let mut slots = alloc::collect(list.into_iter().map(Some))?;
    alloc::gather(order.iter().filter_map(|&k| slots[k].take()))
}

/// The place, or the joint of segments if it is within `max_distance`.
fn snap_place_to_joint<const N: usize>(net_curve: &NetCurve<N>, at: CurvePlace, max_distance: f64) -> CurvePlace {
    let here = net_curve.point_at(at);
    let close = |t: f64| net_curve.point_at(CurvePlace { parameter: t, ..at }).distance(here) <= max_distance;
    let count = net_curve.segments.len();
    if at.parameter < 0.5 && close(0.0) {
        CurvePlace { parameter: 0.0, ..at }
    } else if at.parameter >= 0.5 && close(1.0) {
        // The start of the next segment, if it exists.
        let next = if net_curve.closed { (at.segment + 1) % count } else { at.segment + 1 };
        if next < count { CurvePlace { segment: next, parameter: 0.0 } } else { CurvePlace { parameter: 1.0, ..at } }
    } else {
        at
    }
}

/// Cuts a curve into the pieces between its places, and moves their ends to the nodes. Reverses the
/// curve if it runs against the order.
pub(super) fn cut_curve_at_places<const N: usize>(
    net_curve: &mut NetCurve<N>,
    mut at: Vec<CurvePlace>,
    closed: bool,
    ends: impl Fn(usize) -> DVec3,
    out_of_order: impl Fn(usize) -> Error,
) -> Result<Vec<CurvePiece<N>>> {
    let point = net_curve.is_single_point();
    if closed && !net_curve.closed && !point {
        return Err(Error::CurveNotClosed);
    }
    net_curve.closed = closed;
    if at.is_empty() {
        return alloc::try_collect([net_curve.whole_piece()]);
    }
    if !point {
        let falls = |at: &[CurvePlace]| (1..at.len()).filter(|&k| at[k] < at[k - 1]).count();
        if 2 * falls(&at) > at.len() - 1 || (closed && falls(&at) == 1 && at.len() == 3 && are_places_reversed(&at)) {
            at.iter_mut().for_each(|at| *at = net_curve.reversed_place(*at));
            net_curve.reverse_direction();
        }
        // On a closed curve, the places may begin anywhere.
        let count = if closed { at.len() } else { at.len() - 1 };
        let mut wraps = usize::from(closed);
        for k in 0..count {
            let (here, next) = (at[k], at[(k + 1) % at.len()]);
            if next <= here {
                if wraps == 0 || next == here {
                    return Err(out_of_order((k + 1) % at.len()));
                }
                wraps -= 1;
            }
        }
    }
    let mut pieces = net_curve.cut_at_places(&at)?;
    for (k, piece) in pieces.iter_mut().enumerate() {
        piece.move_ends(ends(k), ends(k + 1));
    }
    Ok(pieces)
}

/// True if three places on a closed curve are in reverse order.
fn are_places_reversed(at: &[CurvePlace]) -> bool {
    // The parameter falls once in forward order, and twice in reverse order.
    (0..3).filter(|&k| at[(k + 1) % 3] < at[k]).count() == 2
}

/// Allocates memory for patches. Fails if there are too many.
fn patches_with_capacity<const N: usize>(rows: usize, columns: usize) -> Result<Vec<Patch<N>>> {
    let count = (rows as u64).saturating_mul(columns as u64);
    Error::check_count("cells", count, MAX_NODES / (N * N) as u64)?;
    alloc::with_capacity(rows * columns)
}

/// Exchanges u and v.
fn transpose_patches<const N: usize>(patches: &Patches<N>, job: &Job<'_>) -> Result<Patches<N>> {
    let [rows, columns] = patches.cells();
    let mut turned = patches_with_capacity(columns, rows)?;
    for (j, i) in (0..columns).flat_map(|j| (0..rows).map(move |i| (j, i))) {
        job.step_every(PATCHES_PER_REPORT, turned.len(), turned.capacity(), PATCH_STAGE)?;
        turned.push(patches.get(i, j).transposed());
    }
    Ok(Patches::from_patches(turned, columns, rows))
}

/// The weighted sum of points.
fn weighted_point_sum(weights: &[f64; NODES_PER_CUBIC], points: &[DVec3; NODES_PER_CUBIC]) -> DVec3 {
    (1..NODES_PER_CUBIC).fold(weights[0] * points[0], |sum, k| sum + weights[k] * points[k])
}
