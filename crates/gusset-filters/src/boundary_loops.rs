use super::data::{Curves, Input, Output};
use super::filter::{Filter, FilterBody};
use super::report::{
    BOUNDARY_LOOP, EDGE, Report, ReportValue, count_with_noun, format_short, push_line, push_unlisted_count,
};
use super::signatures::{ONE_MESH, TO_CURVES_TEXT};
use super::typed_param::{Param, ParamValues, params};
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_stitch::boundary::{Boundary, LoopFlags, NonManifold, Options, boundary_loops};

/// The largest number of loops that the report lists.
const MAX_LISTED_LOOPS: usize = 20;

pub(super) const FILTER: Filter = Filter {
    id: "boundary_loops",
    name: "Boundary loops",
    category: "Boundary",
    help: "Finds every boundary loop of a mesh as a polyline: a chain of edges with a face on one side only. The surface lies \
           to the left of a loop. Where the boundary touches itself, it is divided into simple loops.",
    reference: "S. Nesterenko, The algorithm for polygonal networks of cross-linking, algorithm 1",
    ..Filter::new(ONE_MESH, TO_CURVES_TEXT, &FilterBody(run))
};

params! {
    non_manifold: NonManifold = Param::choice(
        "Edges with three or more faces",
        "The course of a loop at an edge with three or more faces.",
        NonManifold::CHOICES,
    );
}

fn run(inputs: &[Input<'_>], values: &ParamValues<Params>, job: &Job<'_>) -> Result<Vec<Output>> {
    let mesh = inputs[0].mesh()?;
    let options = Options { non_manifold: values.non_manifold, ..Options::default() };
    let boundary = boundary_loops(mesh, &options, job)?;
    let mut curves = Curves::without_curves();
    for found in boundary.iter() {
        curves.add_curve(found.vertices.iter().map(|&v| mesh.positions().get(v)), !found.flags.any(LoopFlags::OPEN))?;
    }
    Ok(vec![Output::Curves(curves), Output::Text(report(&boundary))])
}

fn report(boundary: &Boundary) -> Report {
    let mut text = format!(
        "{}, {}\n",
        count_with_noun(boundary.len(), BOUNDARY_LOOP),
        count_with_noun(boundary.edge_count(), EDGE)
    );
    for (i, found) in boundary.iter().take(MAX_LISTED_LOOPS).enumerate() {
        let kind = if found.flags.any(LoopFlags::OPEN) { "chain" } else { "loop" };
        push_line!(
            text,
            "{kind} {i}: {}, length {}",
            count_with_noun(found.half_edges.len(), EDGE),
            format_short(found.length)
        );
    }
    push_unlisted_count(&mut text, boundary.len(), MAX_LISTED_LOOPS);
    if !boundary.defects().is_empty() {
        push_line!(text, "the mesh has {}", count_with_noun(boundary.defects().len(), ["defect", "defects"]));
    }
    let length = boundary.iter().map(|found| found.length).sum();
    let values = [
        ("boundary_loops", ReportValue::count(boundary.len())),
        ("boundary_edges", ReportValue::count(boundary.edge_count())),
        ("length", ReportValue::length(length)),
        ("defects", ReportValue::count(boundary.defects().len())),
    ];
    Report::new(text, &values)
}
