use super::prelude::*;
use crate::boundary::{Boundary, LoopFlags, NonManifold, Options, boundary_loops};

/// The largest number of loops that the report lists.
const MAX_LISTED: usize = 20;

pub(super) const FILTER: Filter = Filter {
    id: "boundary_loops",
    name: "Boundary loops",
    category: "Boundary",
    help: "Finds every boundary loop of a mesh as a polyline: the chains of edges with a face on one side only. The surface \
           lies to the left of a loop. Where the boundary touches itself it is divided into simple loops.",
    reference: "S. Nesterenko, The algorithm for polygonal networks of cross-linking, algorithm 1",
    params: &[Param::choice("non_manifold", "Edges with three or more faces", NonManifold::CHOICES.texts)
        .help("The course of a loop at an edge with three or more faces.")],
    ..Filter::new(MESH, TO_CURVES_TEXT, run)
};

fn run(inputs: &[Input<'_>], values: &Values<'_>, job: &Job<'_>) -> Result<Vec<Output>> {
    let mesh = inputs[0].mesh()?;
    let non_manifold = values.choice("non_manifold", NonManifold::CHOICES);
    let boundary = boundary_loops(mesh, &Options { non_manifold, ..Options::default() }, job)?;
    let mut curves = Curves::none();
    for found in boundary.iter() {
        curves.add(found.vertices.iter().map(|&v| mesh.positions().get(v)), !found.flags.any(LoopFlags::OPEN))?;
    }
    Ok(vec![Output::Curves(curves), Output::Text(report(&boundary))])
}

fn report(boundary: &Boundary) -> String {
    let mut text = format!("{} boundary loops, {} edges\n", boundary.len(), boundary.edge_count());
    for (i, found) in boundary.iter().take(MAX_LISTED).enumerate() {
        let kind = if found.flags.any(LoopFlags::OPEN) { "chain" } else { "loop" };
        push_line!(text, "{kind} {i}: {} edges, length {}", found.half_edges.len(), found.length);
    }
    if boundary.len() > MAX_LISTED {
        push_line!(text, "and {} more", boundary.len() - MAX_LISTED);
    }
    if !boundary.defects().is_empty() {
        push_line!(text, "{} defects of the mesh", boundary.defects().len());
    }
    text
}
