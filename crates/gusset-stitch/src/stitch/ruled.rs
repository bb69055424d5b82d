//! A strip between two polylines without meshes: meridians, the matrix P, and a mesh of the points
//! and the rows between them.

use super::existing_edges::ExistingEdges;
use super::facing::check_points;
use super::first_meridian::Start;
use super::meridian::{MeridianEnds, MeridianSearch, Meridians};
use super::stitch_request::{Cells, Options, Rows};
use super::stitch_rim::Rim;
use super::strip::{Strip, meridians_from_given_start};
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::{Error, Result, Side};
use gusset_base::geom::scale::common_unit;
use gusset_base::job::Job;
use gusset_mesh::{Mesh, PositionBuffer, Scalar};

/// Options of [`ruled`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct RuledOptions {
    /// The choice of meridians.
    pub meridians: Meridians,
    /// The effort of the search for the best meridians.
    pub search: MeridianSearch,
    /// The first meridians to try for closed polylines; `None` joins their first points. Open
    /// polylines always start there.
    pub start: Option<Start>,
    /// The interior rows. The mean edge is the mean over both polylines.
    pub rows: Rows,
    /// Triangles or quads.
    pub cells: Cells,
}

/// A strip between two polylines.
#[derive(Debug, Clone, PartialEq)]
pub struct Ruled {
    /// The points that the first meridian joins.
    pub start: [u32; 2],
    /// The number of points of each polyline.
    pub counts: [u32; 2],
    /// The meridians as places counted from the first meridian. Between closed polylines of N and M
    /// points they run from (0, 0) to (N, M), where place N is place 0 again. Between open ones
    /// they run to (N - 1, M - 1).
    pub meridians: Vec<MeridianEnds>,
    /// A's points, then B's, then the new ones row by row. Faces run A_i+1, A_i, B_j: against
    /// polyline A, and along B.
    pub mesh: Mesh,
    /// The paper's matrix P of mesh vertices, row by row, with a column for each meridian.
    pub matrix: Vec<u32>,
    /// The number of interior rows; P has two more.
    pub rows: u32,
    /// For each new vertex, the ends of its meridian on A and on B.
    pub parents: Vec<[u32; 2]>,
    /// For each new vertex, the weight of its second parent, 0 to 1.
    pub weights: Vec<f64>,
}

/// Creates a strip between two polylines that run side by side. If `closed`, both are closed, and
/// the last point does not repeat the first.
///
/// Takes the time and memory of the meridians in [`stitch()`](super::stitch()), and of the mesh.
///
/// # Errors
///
/// [`Error::LoopTooShort`] for a closed polyline of fewer than three points or an open one without
/// any, [`Error::NotFinite`], [`Error::TooLarge`], [`Error::NoStrip`], [`Error::OutOfMemory`],
/// [`Error::Cancelled`].
pub fn ruled(a: &[DVec3], b: &[DVec3], closed: bool, options: &RuledOptions, job: &Job<'_>) -> Result<Ruled> {
    let least = if closed { 3 } else { 1 };
    for (side, points) in [(Side::A, a), (Side::B, b)] {
        if points.len() < least {
            return Err(Error::LoopTooShort { side, count: points.len() as u32 });
        }
        check_points(side, points)?;
    }
    let unit = common_unit(a.iter().chain(b));
    let rim = |points: &[DVec3]| Rim::from_points(alloc::collect(points.iter().map(|&p| p / unit))?, closed);
    let (rim_a, rim_b) = (rim(a)?, rim(b)?);
    let mean_side = mean_segment_length([&rim_a, &rim_b]);
    let existing = ExistingEdges::empty();
    let stitch = Options {
        meridians: options.meridians,
        search: options.search,
        start: options.start.unwrap_or_default(),
        rows: options.rows,
        cells: options.cells,
        ..Options::default()
    };
    let strip = if closed && options.start.is_some() {
        Strip::build(rim_a, rim_b, &existing, &stitch, || mean_side, job)?
    } else {
        let found =
            meridians_from_given_start(&rim_a, &rim_b, &existing, &stitch, job)?.ok_or(Error::NoStrip { vertex: 0 })?;
        Strip::from_meridians(rim_a, rim_b, found.pairs, &existing, &stitch, || mean_side, job)?
    };
    job.step(1.0, "making faces")?;

    // The strip counts the points from the first meridian; the mesh keeps the given order.
    let (n, rims) = (a.len() as u32, strip.rim_count());
    let name = |k: u32| match k {
        k if k < n => strip.a.vertices[k as usize],
        k if (k as usize) < rims => n + strip.b.vertices[(k - n) as usize],
        new => new,
    };
    let mut positions = PositionBuffer::with_capacity(Scalar::F64, strip.grid.points.len())?;
    positions.extend(a.iter().chain(b).copied())?;
    positions.extend(strip.grid.points[rims..].iter().map(|&p| p * unit))?;
    let matrix = alloc::collect(strip.grid.matrix.iter().map(|&v| name(v)))?;
    let face_corners = alloc::collect(strip.faces.corners.iter().map(|&v| name(v)))?;
    Ok(Ruled {
        start: [strip.a.vertices[0], strip.b.vertices[0]],
        counts: [n, b.len() as u32],
        rows: (matrix.len() / strip.meridians.len()) as u32 - 2,
        matrix,
        parents: alloc::collect(strip.parents.iter().map(|parents| [0, 1].map(|k| name(parents.vertices[k]))))?,
        weights: alloc::collect(strip.parents.iter().map(|parents| parents.weights[1]))?,
        mesh: Mesh::new(positions, strip.faces.offsets, face_corners),
        meridians: strip.meridians,
    })
}

/// Returns the mean length of the segments of both polylines; infinity without segments.
fn mean_segment_length(rims: [&Rim; 2]) -> f64 {
    let count: u32 = rims.iter().map(|rim| rim.segment_count()).sum();
    if count == 0 {
        return f64::INFINITY;
    }
    let length = |rim: &Rim| (0..rim.segment_count()).map(|i| rim.point(i).distance(rim.point(i + 1))).sum::<f64>();
    rims.map(length).iter().sum::<f64>() / f64::from(count)
}
