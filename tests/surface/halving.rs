//! Answers by the paper's search and by halving: every cell that the mask leaves is halved until it
//! is decided. An oracle for the index: they have nothing in common but the patches.

use glam::{DVec2, DVec3};
use gusset::Job;
use gusset::surface::line_intersection::Line;
use gusset::surface::reference::{
    CellMask, Diameters, PointPlaneOrLine, SearchGoal, SearchOptions, find_cells_near_object,
};
use gusset::surface::{Patch, Place, Sheet};

/// Halvings of a cell before it is left undecided.
const MAX_HALVINGS: u32 = 40;
/// Parts of a cell that are examined: at the centre of a sphere all are equally near.
const MAX_PARTS: usize = 1 << 16;

/// Evaluates an expression for the patch of a cell, of either degree.
macro_rules! with_patch {
    ($sheet:expr, [$i:expr, $j:expr], $patch:ident => $body:expr) => {
        match $sheet {
            Sheet::Grid(grid) => {
                let $patch = &grid.patch($i, $j);
                $body
            }
            Sheet::Cubic(patches) => {
                let $patch = patches.get($i, $j);
                $body
            }
            Sheet::High(patches) => {
                let $patch = patches.get($i, $j);
                $body
            }
        }
    };
}

/// The nearest point of a sheet.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Nearest {
    /// Its distance.
    pub(crate) distance: f64,
    /// Its place; the sheet is 0.
    pub(crate) place: Place,
    /// No point of the sheet is nearer: the distance minus the tolerance, or less without a proof.
    pub(crate) bound: f64,
}

/// The nearest point of a sheet, task a). The search by nodes leaves few cells; each is halved as
/// long as it may be nearer.
pub(crate) fn closest(sheet: &Sheet<'_>, diameters: &Diameters, query: DVec3, tolerance: f64) -> Nearest {
    let options = SearchOptions::new(SearchGoal::Least);
    let found =
        find_cells_near_object(sheet, diameters, PointPlaneOrLine::Point(query), &options, &Job::default()).unwrap();
    let (node, distance) = found.nearest_node_and_distance;
    let [(row, u), (column, v)] = [0, 1].map(|k| {
        let last = sheet.cells()[k] - 1;
        if node[k] <= last { (node[k] as u32, 0.0) } else { (last as u32, 1.0) }
    });
    let mut best = Nearest { distance, place: Place { sheet: 0, cell: [row, column], u, v }, bound: distance };
    for [i, j] in found.possible_cells.cells() {
        let near = sheet.corner(i, j).distance(query) - diameters.euclidean.get([i, j]);
        if near <= best.distance * (1.0 + 1e-12) {
            with_patch!(sheet, [i, j], patch => refine(patch, query, [i, j], tolerance, &mut best));
        }
    }
    Nearest { bound: best.bound.min(best.distance), ..best }
}

/// Looks for a nearer point in a patch.
fn refine<const N: usize>(patch: &Patch<N>, query: DVec3, cell: [usize; 2], tolerance: f64, best: &mut Nearest) {
    let mut parts = vec![(*patch, DVec2::ZERO, 1.0)];
    let mut examined = 0;
    while let Some((part, from, size)) = parts.pop() {
        examined += 1;
        let middle = part.point(0.5, 0.5);
        let distance = middle.distance(query);
        if distance < best.distance {
            let at = from + 0.5 * size;
            best.distance = distance;
            best.place = Place { sheet: 0, cell: cell.map(|k| k as u32), u: at.x, v: at.y };
        }
        // All of the part is on the far side of a plane across the direction of its middle.
        let direction = (query - middle).normalize_or_zero();
        let along = part.points.as_flattened().iter().map(|&point| (query - point).dot(direction));
        let bound = along.fold(f64::INFINITY, f64::min).max(0.0);
        if bound > best.distance - tolerance || size < 0.5_f64.powi(MAX_HALVINGS as i32) || examined > MAX_PARTS {
            best.bound = best.bound.min(bound);
            continue;
        }
        let half = 0.5 * size;
        let corners = [DVec2::ZERO, DVec2::Y, DVec2::X, DVec2::ONE];
        let quarters = part.quarters().into_iter().zip(corners);
        let first = parts.len();
        parts.extend(quarters.map(|(quarter, corner)| (quarter, from + half * corner, half)));
        // The nearest is looked at first.
        let far = |part: &Patch<N>| part.point(0.5, 0.5).distance_squared(query);
        parts[first..].sort_by(|a, b| far(&b.0).total_cmp(&far(&a.0)));
    }
}

/// The cells with a point within a distance of an object: cells of the mask whose parts are not all
/// proved to be farther. No cell is missing. An extra cell is within the tolerance of the distance,
/// unless it was left undecided.
///
/// With a distance of 0 these are the cells that a plane crosses or a line meets, tasks c) and d).
/// Loops inside a cell count, and sides that are crossed twice: signs at nodes show neither
/// (erratum E7).
pub(crate) fn cells_within(
    sheet: &Sheet<'_>,
    diameters: &Diameters,
    object: PointPlaneOrLine,
    distance: f64,
    tolerance: f64,
) -> CellMask {
    let options = SearchOptions::new(SearchGoal::Within(distance));
    let left = find_cells_near_object(sheet, diameters, object, &options, &Job::default()).unwrap().possible_cells;
    let (object, mut within) = (ObjectBox::new(object), left.clone());
    for cell in left.cells() {
        let near = with_patch!(sheet, [cell[0], cell[1]], patch => object.comes_near(patch, distance, tolerance));
        within.set(cell, near);
    }
    within
}

/// An object as a box, perhaps infinite, in orthonormal axes; planes need one of them only.
struct ObjectBox {
    origin: DVec3,
    axes: Vec<DVec3>,
    intervals: [[f64; 2]; 3],
}

impl ObjectBox {
    fn new(object: PointPlaneOrLine) -> Self {
        let (origin, axes, along) = match object {
            PointPlaneOrLine::Point(point) => (point, DVec3::AXES.to_vec(), [0.0; 2]),
            PointPlaneOrLine::Plane { point, normal } => (point, vec![normal.normalize()], [0.0; 2]),
            PointPlaneOrLine::Line(Line { origin, direction, from, to }) => {
                let unit = direction.normalize();
                let (u, v) = unit.any_orthonormal_pair();
                (origin, vec![u, v, unit], [from, to].map(|t| t * direction.length()))
            }
        };
        ObjectBox { origin, axes, intervals: [[0.0; 2], [0.0; 2], along] }
    }

    /// The distance from the bounding box of some points: a lower bound for any point within it.
    fn distance(&self, points: &[DVec3]) -> f64 {
        let gaps = self.axes.iter().zip(self.intervals).map(|(axis, [from, to])| {
            let along = points.iter().map(|point| (point - self.origin).dot(*axis));
            let [low, high] =
                along.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], x| [low.min(x), high.max(x)]);
            (low - to).max(from - high).max(0.0)
        });
        gaps.map(|gap| gap * gap).sum::<f64>().sqrt()
    }

    /// False if no point of a patch is within a distance.
    fn comes_near<const N: usize>(&self, patch: &Patch<N>, distance: f64, tolerance: f64) -> bool {
        let far = |point: &DVec3| (point - self.origin).length();
        let rounding = 8.0 * f64::EPSILON * patch.points.as_flattened().iter().map(far).fold(0.0, f64::max);
        let mut parts = vec![(*patch, 0)];
        let mut examined = 0;
        while let Some((part, depth)) = parts.pop() {
            examined += 1;
            if self.distance(part.points.as_flattened()) - rounding > distance {
                continue;
            }
            // A corner is a point of the surface.
            let corner = self.distance(&part.points[0][..1]);
            if corner <= distance + tolerance || depth == MAX_HALVINGS || examined > MAX_PARTS {
                return true;
            }
            parts.extend(part.quarters().map(|quarter| (quarter, depth + 1)));
        }
        false
    }
}
