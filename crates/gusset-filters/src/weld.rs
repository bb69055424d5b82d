use super::data::{Input, Output};
use super::filter::{Filter, FilterBody};
use super::report::{BOUNDARY_EDGE, EDGE, FACE, Report, ReportValue, VERTEX, count_with_noun, push_line};
use super::signatures::{ONE_MESH, TO_MESH_TEXT};
use super::typed_param::{NON_NEGATIVE_OR_AUTO_RANGE, Param, ParamValues, TypedParam, params};
use gusset_attributes::{KeepSplitVertices, Origins};
use gusset_base::choices;
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_stitch::repair::near_borders::NearBorders;
use gusset_stitch::repair::weld::{Options, Vertices, Weld, weld};

pub(super) const FILTER: Filter = Filter {
    id: "weld",
    name: "Weld vertices",
    category: "Repair",
    help: "Merges coincident vertices. Either coincident borders are welded edge to edge, whatever the orientation of their \
           faces, or all coincident vertices are merged, as a triangle soup requires.",
    reference: "Greedy clustering in the order of the vertices; edges are sewn in pairs",
    replaces: true,
    has_origins: true,
    ..Filter::new(ONE_MESH, TO_MESH_TEXT, &FilterBody(run))
};

params! {
    vertices: Vertices = Param::choice("Weld", "The vertices that are welded.", Vertices::CHOICES);
    tolerance: Option<f64> = TOLERANCE;
    collapse: bool = Param::choice("Short edges", "The treatment of coincident corners of one face.", COLLAPSE);
    unused: bool = DROP_UNUSED_VERTICES;
}

/// Appends the hint which tolerance sews further borders.
pub(super) fn push_hint(near: &NearBorders, text: &mut String) {
    if let Some(hint) = near.hint() {
        push_line!(text, "not sewn: {hint}");
    }
}

/// Sets the distance up to which vertices coincide; `None` takes the rounding of the positions.
pub(super) const TOLERANCE: TypedParam<Option<f64>> = Param::length(
    "Tolerance",
    "The largest distance at which vertices coincide, or a vertex and an edge if borders are sewn. 0 takes equal positions; \
     -1 takes the rounding of the positions, judged by their type and digits.",
    NON_NEGATIVE_OR_AUTO_RANGE,
    &[-1.0],
)
.none_if_negative();

/// Drops vertices that no face uses.
pub(super) const DROP_UNUSED_VERTICES: TypedParam<bool> =
    Param::choice("Unused vertices", "The treatment of vertices that no face uses.", UNUSED_VERTICES);

choices! {
    COLLAPSE: bool =
        false => "Keep", "They stay apart.";
        true => "Collapse", "They are merged. A face that has fewer than three corners left is dropped.";
}

choices! {
    UNUSED_VERTICES: bool =
        false => "Keep", "They stay.";
        true => "Remove", "They are dropped.";
}

fn run(inputs: &[Input<'_>], values: &ParamValues<Params>, job: &Job<'_>) -> Result<Vec<Output>> {
    let options = Options {
        vertices: values.vertices,
        tolerance: values.tolerance,
        collapse: values.collapse,
        remove_unused: values.unused,
    };
    let mut done = weld(inputs[0].mesh()?, &options, job)?;
    done.keep_split_vertices(&[inputs[0].mesh()?], &job.sub_job(1.0, 1.0))?;
    let report = report(&done);
    let origins = values.trace_origins(|| Origins::from_weld(&done, &job.sub_job(1.0, 1.0)))?;
    Ok(vec![Output::Mesh(done.mesh, origins), Output::Text(report)])
}

fn report(done: &Weld) -> Report {
    let [edges, vertices] = [done.left_edges.len(), done.left_vertices.len()];
    // Boundary edges that coincide with no other edge are left out; the filter `check` counts them.
    let left = match (edges, vertices) {
        (0, 0) => "all coincident borders are welded".to_owned(),
        _ => format!(
            "not welded: {} and {} that coincide with others",
            count_with_noun(edges, BOUNDARY_EDGE),
            count_with_noun(vertices, VERTEX)
        ),
    };
    let mut text = format!(
        "{} welded, {} sewn, {} dropped\n{left}\n",
        count_with_noun(done.welded_vertices, VERTEX),
        count_with_noun(done.sewn_edges, EDGE),
        count_with_noun(done.dropped_faces, FACE)
    );
    push_hint(&done.near, &mut text);
    let values = [
        ("welded_vertices", ReportValue::count(done.welded_vertices)),
        ("tolerance", ReportValue::length(done.tolerance)),
        ("sewn_edges", ReportValue::count(done.sewn_edges)),
        ("dropped_faces", ReportValue::count(done.dropped_faces)),
        ("coincident_boundary_edges", ReportValue::count(edges)),
        ("coincident_vertices", ReportValue::count(vertices)),
        ("near_edge_pairs", ReportValue::count(done.near.edge_pairs)),
        ("near_tolerance", ReportValue::length(done.near.tolerance)),
    ];
    Report::new(text, &values)
}
