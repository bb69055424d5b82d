//! Common parts of filters of smooth surfaces: the surface through the vertices of a quad grid.

use super::curve;
use super::data::Curves;
use super::report::{CURVE, FACE, POINT, Report, ReportValue, VERTEX, count_with_noun};
use super::typed_param::{Param, TypedParam};
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::{Component, Element, Error, Result};
use gusset_base::job::Job;
use gusset_mesh::{Mesh, MeshView};
use gusset_net::convert::net_of_grid;
use gusset_surface::contour::PointSpacing;
use gusset_surface::{Closest, Grid, Nodes, Paths, Scheme, Sheet, Surface, SurfaceMeshOptions};

pub(super) const CATEGORY: &str = "Smooth surfaces";
pub(super) const REFERENCE: &str = "V. A. Leus, Carcasses on smooth surfaces, 1976";

/// Chooses the interpolation of the surface.
pub(super) const SCHEME: TypedParam<Scheme> = Param::choice(
    "Surface",
    "The interpolation of the vertices. The quads must form a grid of rows and columns.",
    Scheme::CHOICES,
);

/// Limits the distance of chords from curves.
pub(super) const CHORD_ERROR: TypedParam<f64> = curve::CHORD_ERROR
    .with_help("The largest distance of the polylines from the curves, relative to the diagonal of the surface's box.");

/// Limits the relative deviation of meshes from the surface.
pub(super) const DEVIATION: TypedParam<f64> = Param::real(
    "Deviation",
    "The largest distance of faces from the surface, relative to the diagonal of its box.",
    [1e-7, 1.0],
    &[1e-3],
);

/// Sets the least number of parts along each side of a cell.
pub(super) const MIN_PARTS_PER_SIDE: TypedParam<u32> =
    Param::int("Parts", "The smallest number of parts of each side of a cell.", [1.0, 1000.0], &[1.0]);

/// Makes triangles instead of quads.
pub(super) const TRIANGLES: TypedParam<bool> = Param::flag("Triangles", "Makes triangles instead of quads.");

/// The surface through a mesh. Its normals point to the side from which faces run
/// counter-clockwise.
pub(super) fn surface_through_mesh(mesh: &MeshView<'_>, scheme: Scheme, job: &Job<'_>) -> Result<Surface<'static>> {
    let found = net_of_grid(mesh, None, &job.sub_job(0.0, 0.6))?;
    let (rows, columns) = (found.net.shape().rows(), found.net.shape().columns());
    let vertex = |i: usize, j: usize| found.vertex_of_node[i * columns + j];
    // The surface's first parameter runs along rows, as faces do.
    let closed_u = columns > 3 && (0..rows).all(|i| vertex(i, 0) == vertex(i, columns - 1));
    let closed_v = rows > 3 && (0..columns).all(|j| vertex(0, j) == vertex(rows - 1, j));
    let places = (0..columns).flat_map(|j| (0..rows).map(move |i| (i, j)));
    let data = alloc::gather(places.flat_map(|(i, j)| mesh.positions().get(vertex(i, j)).to_array()))?;
    let nodes = Nodes::strided(data, columns, rows, 0, 0)?;
    let sheet = Sheet::Grid(Grid::new(nodes, [closed_u, closed_v], scheme)?);
    Surface::new(vec![sheet], None, &job.sub_job(0.6, 1.0))
}

/// The largest distance of chords that a relative [`CHORD_ERROR`] allows.
pub(super) fn chord_spacing(surface: &Surface<'_>, chord_error: f64) -> PointSpacing {
    let [low, high] = surface.bounds();
    PointSpacing::Chord((chord_error * low.distance(high)).max(f64::MIN_POSITIVE))
}

/// The surface of one sheet as a mesh, and a report of one line. The fineness is the values of
/// [`DEVIATION`], [`MIN_PARTS_PER_SIDE`] and [`TRIANGLES`].
pub(super) fn mesh_surface(
    surface: &Surface<'_>,
    (deviation, parts, triangles): (f64, u32, bool),
    job: &Job<'_>,
) -> Result<(Mesh, Report)> {
    let [low, high] = surface.bounds();
    let options = SurfaceMeshOptions {
        tolerance: (deviation * low.distance(high)).max(f64::MIN_POSITIVE),
        least: [parts; 2],
        triangles,
    };
    let made = surface.sheet(0).to_mesh(&options, job)?;
    let (vertices, faces) = (made.places.len(), made.mesh.face_count());
    let text = format!(
        "{}, {}, at most {:.1e} from the surface\n",
        count_with_noun(vertices, VERTEX),
        count_with_noun(faces, FACE),
        made.deviation
    );
    let values = [
        ("vertices", ReportValue::count(vertices)),
        ("faces", ReportValue::count(faces)),
        ("deviation", ReportValue::length(made.deviation)),
    ];
    Ok((made.mesh, Report::new(text, &values)))
}

/// The nearest points of all queries, which are elements of the given kind.
pub(super) fn nearest_surface_points(
    surface: &Surface<'_>,
    queries: &[DVec3],
    element: Element,
    job: &Job<'_>,
) -> Result<Vec<Closest>> {
    let found = surface.closest_all(queries, f64::INFINITY, job).map_err(|error| match error {
        Error::NotFinite { index, component, value, .. } => Error::NotFinite { element, index, component, value },
        error => error,
    })?;
    alloc::try_collect((0..).zip(found).zip(queries).map(|((index, found), query)| {
        // Squares of distances would overflow.
        let most = query.abs().max_element();
        let (component, value) = Component::find(*query, |x| x.abs() == most).unwrap_or((Component::X, query.x));
        found.ok_or(Error::CoordinateTooLarge { element, index, component, value })
    }))
}

/// Paths as polylines.
pub(super) fn paths_to_curves(paths: &Paths) -> Result<Curves> {
    Ok(Curves {
        points: alloc::collect(paths.points.iter().map(DVec3::to_array))?,
        offsets: if paths.ends.is_empty() { vec![0] } else { alloc::copied(&paths.ends)? },
        closed: alloc::copied(&paths.closed)?,
    })
}

/// A line on the number of curves.
pub(super) fn paths_summary(paths: &Paths) -> String {
    let closed = paths.closed.iter().filter(|&&closed| closed).count();
    format!(
        "{}, {closed} of them closed, {}; {} unresolved\n",
        count_with_noun(paths.len(), CURVE),
        count_with_noun(paths.points.len(), POINT),
        count_with_noun(paths.unresolved.len(), ["cell", "cells"])
    )
}
