//! A strip between two polylines that belong to no mesh: meridians, the matrix P, and a mesh of
//! the points and the rows between them.

use super::facing::check_points;
use super::first_meridian::Start;
use super::meridian::{Meridians, Pair, Search};
use super::stitch_request::{Cells, Options, Rows};
use super::stitch_rim::{Bridges, Rim};
use super::strip::{Strip, from_given_start};
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::{Error, Result, Side};
use gusset_base::geom::scale::common_unit;
use gusset_base::job::Job;
use gusset_mesh::{Mesh, PositionBuffer, Scalar};

/// How the strip is made.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct RuledOptions {
    /// The choice of meridians.
    pub meridians: Meridians,
    /// How hard the best ones are looked for.
    pub search: Search,
    /// Closed polylines: which first meridians are tried; `None` for the one that joins their first
    /// points. Open ones always begin there.
    pub start: Option<Start>,
    /// The interior rows; the mean edge is that of both polylines.
    pub rows: Rows,
    /// The faces.
    pub cells: Cells,
}

/// A strip between two polylines.
#[derive(Debug, Clone, PartialEq)]
pub struct Ruled {
    /// The points that the first meridian joins.
    pub start: [u32; 2],
    /// The number of points of each polyline.
    pub counts: [u32; 2],
    /// The meridians as places counted from there: from (0, 0) to (N, M) between closed polylines
    /// of N and M points, place N being place 0 again, else to (N - 1, M - 1).
    pub meridians: Vec<Pair>,
    /// The points of A, those of B, then the new ones row by row. Faces run A_i+1, A_i, B_j:
    /// against polyline A, and along B.
    pub mesh: Mesh,
    /// The paper's matrix P, row by row, a column for each meridian: vertices of the mesh.
    pub matrix: Vec<u32>,
    /// The interior rows; P has two more.
    pub rows: u32,
    /// Of each new vertex the ends of its meridian, of A and of B.
    pub parents: Vec<[u32; 2]>,
    /// Of each new vertex how much its second parent counts, 0 to 1.
    pub weights: Vec<f64>,
}

/// A strip between two polylines that run side by side. `closed`: both are, and the last point is
/// not the first again.
///
/// Time and memory of [`stitch()`](super::stitch())'s meridians, and of the mesh.
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
    let rim = |points: &[DVec3]| Rim::bare(alloc::collect(points.iter().map(|&p| p / unit))?, closed);
    let (rim_a, rim_b) = (rim(a)?, rim(b)?);
    let mean_side = mean_segment([&rim_a, &rim_b]);
    let bridges = Bridges::none();
    let stitch = Options {
        meridians: options.meridians,
        search: options.search,
        start: options.start.unwrap_or_default(),
        rows: options.rows,
        cells: options.cells,
        ..Options::default()
    };
    let strip = if closed && options.start.is_some() {
        Strip::between(rim_a, rim_b, &bridges, &stitch, || mean_side, job)?
    } else {
        let found = from_given_start(&rim_a, &rim_b, &bridges, &stitch, job)?.ok_or(Error::NoStrip { vertex: 0 })?;
        Strip::on(rim_a, rim_b, found.pairs, &bridges, &stitch, || mean_side)?
    };
    job.step(1.0, "making faces")?;

    // The strip counts the points from the first meridian on, the mesh as they were given.
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

/// The mean length of the segments of both polylines; infinite if there are none.
fn mean_segment(rims: [&Rim; 2]) -> f64 {
    let count: u32 = rims.iter().map(|rim| rim.segments()).sum();
    if count == 0 {
        return f64::INFINITY;
    }
    let length = |rim: &Rim| (0..rim.segments()).map(|i| rim.at(i).distance(rim.at(i + 1))).sum::<f64>();
    rims.map(length).iter().sum::<f64>() / f64::from(count)
}
