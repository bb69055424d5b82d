//! The filter `boundary_loops`.

use super::Filter;
use super::data::{Curves, Input, InputKind, Output, OutputKind};
use super::param::{Choice, Param, Values};
use crate::boundary::{Boundary, LoopFlags, NonManifold, Options, boundary_loops};
use crate::error::Result;
use crate::job::Job;
use std::fmt::Write;

/// Loops that the report lists one by one.
const LISTED: usize = 20;

pub(super) const FILTER: Filter = Filter {
    id: "boundary_loops",
    name: "Boundary loops",
    script_name: "boundary_loops",
    category: "Boundary",
    help: "Finds every free boundary loop of a mesh, as polylines: the chains of edges that have a face on one side only. A \
           loop runs with the surface on its left. Where the boundary touches itself it is cut into simple loops.",
    reference: "S. Nesterenko, The algorithm for polygonal networks of cross-linking, algorithm 1",
    inputs: &[InputKind::Mesh],
    min_inputs: 1,
    max_inputs: 1,
    outputs: &[OutputKind::Curves, OutputKind::Text],
    replaces: false,
    params: &[Param::choice(
        "non_manifold",
        "Edges with three or more faces",
        "What a loop does where three or more faces meet at an edge.",
        &[
            Choice { label: "Cut", help: "Each face has a border of its own there: loops are always closed." },
            Choice { label: "Stop", help: "Loops end there, as open chains." },
        ],
    )],
    suggest: None,
    run,
};

fn run(inputs: &[Input<'_>], values: &Values<'_>, job: &Job<'_>) -> Result<Vec<Output>> {
    let mesh = inputs[0].mesh()?;
    let non_manifold = [NonManifold::Cut, NonManifold::Stop][values.chosen("non_manifold")];
    let boundary = boundary_loops(mesh, &Options { non_manifold, ..Options::default() }, job)?;
    let mut curves = Curves::none();
    for found in boundary.iter() {
        curves.add(found.vertices.iter().map(|&v| mesh.positions().get(v)), !found.flags.any(LoopFlags::OPEN))?;
    }
    Ok(vec![Output::Curves(curves), Output::Text(report(&boundary))])
}

fn report(boundary: &Boundary) -> String {
    let mut text = format!("{} boundary loops, {} edges\n", boundary.len(), boundary.edge_count());
    for (i, found) in boundary.iter().take(LISTED).enumerate() {
        let kind = if found.flags.any(LoopFlags::OPEN) { "chain" } else { "loop" };
        // Writing to a string cannot fail.
        let _ = writeln!(text, "{kind} {i}: {} edges, length {}", found.half_edges.len(), found.length);
    }
    if boundary.len() > LISTED {
        let _ = writeln!(text, "and {} more", boundary.len() - LISTED);
    }
    if !boundary.defects().is_empty() {
        let _ = writeln!(text, "{} defects of the mesh", boundary.defects().len());
    }
    text
}
