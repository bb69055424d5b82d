//! The filter `smooth_distance`.

use super::data::with_positions;
use super::prelude::*;
use super::report::distances;
use super::smooth::{self, CATEGORY, REFERENCE, SCHEME};
use crate::error::Element;
use crate::mesh::{MeshView, PositionBuffer};
use crate::par;
use crate::surface::Surface;

pub(super) const FILTER: Filter = Filter {
    id: "smooth_distance",
    name: "Distance from a smooth surface",
    category: CATEGORY,
    help: "Measures the distances of the vertices of a mesh from the smooth surface through the vertices of a quad grid, the second \
           mesh, and moves them towards their nearest points on it.",
    reference: REFERENCE,
    replaces: true,
    params: &[
        SCHEME,
        Param::real("strength", "Strength", [0.0, 1.0], &[1.0])
            .help("The fraction of the way that vertices are moved: 0 leaves them, 1 puts them on the surface."),
    ],
    ..Filter::new(TWO_MESHES, TO_MESH_TEXT, run)
};

/// Vertices that are looked at between two chances to cancel, and by a thread at a time.
const ROUND: usize = 1 << 12;
const TAKEN: usize = 1 << 9;

fn run(inputs: &[Input<'_>], values: &Values<'_>, job: &Job<'_>) -> Result<Vec<Output>> {
    let mesh = inputs[0].mesh()?;
    let surface = smooth::surface(inputs[1].mesh()?, values, &job.part(0.0, 0.3))?;
    let nearest = nearest(mesh, &surface, &job.part(0.3, 1.0))?;
    let strength = values.number("strength");
    let positions = mesh.positions();
    let from = |v: usize| positions.get(v as u32);
    let mut moved = PositionBuffer::with_capacity(positions.scalar(), positions.len())?;
    moved.extend(nearest.iter().enumerate().map(|(v, &to)| from(v).lerp(to, strength)))?;
    let lengths = nearest.iter().enumerate().map(|(v, &to)| from(v).distance(to));
    let text = distances("vertices", lengths);
    Ok(vec![Output::Mesh(with_positions(mesh, moved)?), Output::Text(text)])
}

/// The nearest points of all vertices.
fn nearest(mesh: &MeshView<'_>, surface: &Surface<'_>, job: &Job<'_>) -> Result<Vec<DVec3>> {
    let positions = mesh.positions();
    let mut nearest = alloc::with_capacity(positions.len())?;
    while nearest.len() < positions.len() {
        let first = nearest.len();
        job.step(first as f64 / positions.len() as f64, "nearest points")?;
        let parts = par::chunks(job.threads(), ROUND.min(positions.len() - first), TAKEN, |range| {
            let closest = |v: usize| {
                let query = positions.get((first + v) as u32);
                let bad = Error::NotFinite {
                    element: Element::Vertex,
                    index: (first + v) as u64,
                    value: query.element_sum(),
                };
                let found = if query.is_finite() { surface.closest(query, f64::INFINITY) } else { None };
                found.map(|found| found.point).ok_or(bad)
            };
            range.map(closest).collect::<Result<Vec<_>>>()
        });
        for part in parts {
            nearest.extend(part?);
        }
    }
    Ok(nearest)
}
