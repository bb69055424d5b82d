//! What filters of smooth surfaces have in common: the surface through the vertices of a mesh of
//! quads in rows and columns.

use super::data::Curves;
use super::param::{Choice, PLACES, Param, ParamKind, Values};
use crate::alloc;
use crate::error::Result;
use crate::job::Job;
use crate::mesh::{Mesh, MeshView};
use crate::net::convert::net_of_grid;
use crate::surface::contour::PointSpacing;
use crate::surface::{Grid, Nodes, Paths, Scheme, Sheet, Surface, SurfaceMeshOptions};
use glam::DVec3;

pub(super) const CATEGORY: &str = "Smooth surfaces";
pub(super) const REFERENCE: &str = "V. A. Leus, Carcasses on smooth surfaces, 1976";

/// How the surface is drawn.
pub(super) const SCHEME: Param = Param::choice(
    "scheme",
    "Surface",
    "How the surface is drawn through the vertices of the quads, which must be in rows and columns.",
    &[
        Choice { label: "Smooth", help: "Bicubic pieces from 6 x 6 vertices each, with continuous tangents." },
        Choice { label: "Four points", help: "The bicubic through the 4 x 4 vertices round a quad; tangents jump." },
    ],
);

/// How fine curves are.
pub(super) const CHORD: Param = Param::relative(
    "chord_error",
    "Chord error",
    "How far the polylines may be from the curves, relative to the diagonal of the surface's box.",
);

/// How fine meshes are: relative deviation, fewest parts of a cell, triangles or quads.
pub(super) const FINENESS: [Param; 3] = [
    Param::new(
        "deviation",
        "Deviation",
        "How far faces may be from the surface, relative to the diagonal of its box.",
        ParamKind::Real,
        [1e-7, 1.0],
        &[1e-3],
    ),
    Param::new(
        "parts",
        "Parts",
        "The fewest parts that each side of a cell is cut into.",
        ParamKind::Int,
        [1.0, 1000.0],
        &[1.0],
    ),
    Param::flag("triangles", "Triangles", "The mesh is made of triangles instead of quads."),
];

/// A direction; the z axis by default.
pub(super) const fn direction(help: &'static str) -> Param {
    Param::new("direction", "Direction", help, ParamKind::Direction, PLACES, &[0.0, 0.0, 1.0])
}

/// The surface through a mesh, with its normals on the side that the faces are counter-clockwise
/// from.
pub(super) fn surface(mesh: &MeshView<'_>, values: &Values<'_>, job: &Job<'_>) -> Result<Surface<'static>> {
    let scheme = [Scheme::SixTap, Scheme::FourPoint][values.chosen("scheme")];
    let found = net_of_grid(mesh, None, &job.part(0.0, 0.6))?;
    let (rows, columns) = (found.net.shape().rows(), found.net.shape().columns());
    let vertex = |i: usize, j: usize| found.vertex_of_node[i * columns + j];
    // Faces run along rows first, so that the surface's first parameter goes along them too.
    let closed_u = columns > 3 && (0..rows).all(|i| vertex(i, 0) == vertex(i, columns - 1));
    let closed_v = rows > 3 && (0..columns).all(|j| vertex(0, j) == vertex(rows - 1, j));
    let mut data = alloc::with_capacity(3 * rows * columns)?;
    for j in 0..columns {
        for i in 0..rows {
            data.extend(mesh.positions().get(vertex(i, j)).to_array());
        }
    }
    let nodes = Nodes::strided(data, columns, rows, 0, 0)?;
    let sheet = Sheet::Grid(Grid::new(nodes, [closed_u, closed_v], scheme)?);
    Surface::new(vec![sheet], None, &job.part(0.6, 1.0))
}

/// The length that chords are held to.
pub(super) fn chord(surface: &Surface<'_>, values: &Values<'_>) -> PointSpacing {
    let [low, high] = surface.bounds();
    PointSpacing::Chord((values.number("chord_error") * low.distance(high)).max(f64::MIN_POSITIVE))
}

/// The surface of one sheet as a mesh, and what there is to say of it.
pub(super) fn meshed(surface: &Surface<'_>, values: &Values<'_>, job: &Job<'_>) -> Result<(Mesh, String)> {
    let [low, high] = surface.bounds();
    let options = SurfaceMeshOptions {
        tolerance: (values.number("deviation") * low.distance(high)).max(f64::MIN_POSITIVE),
        least: [values.number("parts") as u32; 2],
        triangles: values.is_set("triangles"),
    };
    let made = surface.sheet(0).to_mesh(&options, job)?;
    let (vertices, faces) = (made.places.len(), made.mesh.face_count());
    let text = format!("{vertices} vertices, {faces} faces, at most {:.1e} from the surface\n", made.deviation);
    Ok((made.mesh, text))
}

/// Paths as polylines.
pub(super) fn polylines(paths: &Paths) -> Result<Curves> {
    Ok(Curves {
        points: alloc::collect(paths.points.iter().map(DVec3::to_array))?,
        offsets: if paths.ends.is_empty() { vec![0] } else { alloc::copied(&paths.ends)? },
        closed: alloc::copied(&paths.closed)?,
    })
}

/// Says how many curves there are.
pub(super) fn account(paths: &Paths) -> String {
    let closed = paths.closed.iter().filter(|&&closed| closed).count();
    format!(
        "{} curves, {closed} of them closed, {} points; {} cells unresolved\n",
        paths.len(),
        paths.points.len(),
        paths.unresolved.len()
    )
}
