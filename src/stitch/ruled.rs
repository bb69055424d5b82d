//! A strip between two polylines that belong to no mesh: meridians and triangles only.

use super::facing::check_points;
use super::grid::Grid;
use super::meridian::{Meridians, Pair, Search};
use super::request::Options;
use super::rim::{Bridges, Rim};
use super::start::Start;
use super::strip::{Strip, from_given_start};
use crate::alloc;
use crate::error::{Error, Result, Side};
use crate::geom::scale::common_unit;
use crate::job::Job;
use glam::DVec3;

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
}

/// A strip between two polylines.
#[derive(Debug, Clone, PartialEq)]
pub struct Ruled {
    /// The points that the first meridian joins.
    pub start: [u32; 2],
    /// The meridians as places counted from there: from (0, 0) to (N, M) between closed polylines
    /// of N and M points, place N being place 0 again, else to (N - 1, M - 1).
    pub meridians: Vec<Pair>,
    /// The triangles over the points of A, then those of B; where both sides advance at once a quad
    /// is split by its shorter diagonal. They run A_i+1, A_i, B_j: against polyline A, and along B.
    pub triangles: Vec<[u32; 3]>,
}

/// A strip of triangles between two polylines that run side by side. `closed`: both are, and the
/// last point is not the first again.
///
/// Time and memory of [`stitch()`](super::stitch())'s meridians.
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
    let (mut a, mut b) = (rim(a)?, rim(b)?);
    let bridges = Bridges::none();
    let stitch = Options {
        meridians: options.meridians,
        search: options.search,
        start: options.start.unwrap_or_default(),
        ..Options::default()
    };
    let (meridians, faces) = if closed && options.start.is_some() {
        let strip = Strip::between(a, b, &bridges, &stitch, || f64::INFINITY, job)?;
        (a, b) = (strip.a, strip.b);
        (strip.meridians, strip.faces)
    } else {
        let found = from_given_start(&a, &b, &bridges, &stitch, job)?.ok_or(Error::NoStrip { vertex: 0 })?.pairs;
        let faces = Grid::new(&a, &b, &found, 0)?.faces(&a, &b, &bridges, false)?;
        (found, faces)
    };
    job.step(1.0, "making triangles")?;
    let n = a.vertices.len() as u32;
    let name = |k: u32| if k < n { a.vertices[k as usize] } else { n + b.vertices[(k - n) as usize] };
    Ok(Ruled {
        start: [a.vertices[0], b.vertices[0]],
        meridians,
        triangles: alloc::collect(faces.corners.chunks_exact(3).map(|t| [name(t[0]), name(t[1]), name(t[2])]))?,
    })
}
