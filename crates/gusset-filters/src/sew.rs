use super::data::{Input, Output};
use super::filter::{Filter, FilterBody};
use super::report::{EDGE, FACE, Report, ReportValue, VERTEX, count_with_noun};
use super::signatures::{ONE_MESH, TO_MESH_TEXT};
use super::typed_param::{ParamValues, params};
use super::weld::{DROP_UNUSED_VERTICES, TOLERANCE, push_hint};
use gusset_attributes::{KeepSplitVertices, Origins};
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_stitch::repair::sew::{Sew, sew};
use gusset_stitch::repair::weld::Options;

pub(super) const FILTER: Filter = Filter {
    id: "sew",
    name: "Sew borders",
    category: "Repair",
    help: "Welds coincident borders, even if their vertices do not match. An edge is split where a vertex of another border \
           lies on it, if the parts then coincide in pairs. Triangles with split edges are cut into triangles; larger faces \
           gain corners.",
    reference: "Greedy clustering in the order of the vertices; edges are sewn in pairs",
    replaces: true,
    has_origins: true,
    ..Filter::new(ONE_MESH, TO_MESH_TEXT, &FilterBody(run))
};

params! {
    tolerance: Option<f64> = TOLERANCE;
    unused: bool = DROP_UNUSED_VERTICES;
}

fn run(inputs: &[Input<'_>], values: &ParamValues<Params>, job: &Job<'_>) -> Result<Vec<Output>> {
    let options = Options { tolerance: values.tolerance, remove_unused: values.unused, ..Options::default() };
    let mut done = sew(inputs[0].mesh()?, &options, job)?;
    done.keep_split_vertices(&[inputs[0].mesh()?], &job.sub_job(1.0, 1.0))?;
    let report = report(&done);
    let origins = values.trace_origins(|| Origins::from_sew(&done, &job.sub_job(1.0, 1.0)))?;
    Ok(vec![Output::Mesh(done.mesh, origins), Output::Text(report)])
}

fn report(done: &Sew) -> Report {
    let mut text = format!(
        "{} welded, {} sewn, {} split at {}\nnot welded: {} that lie on other vertices or on edges\n",
        count_with_noun(done.welded_vertices, VERTEX),
        count_with_noun(done.sewn_edges, EDGE),
        count_with_noun(done.split_faces, FACE),
        count_with_noun(done.splits, ["point", "points"]),
        count_with_noun(done.left_vertices.len(), VERTEX)
    );
    push_hint(&done.near, &mut text);
    let values = [
        ("welded_vertices", ReportValue::count(done.welded_vertices)),
        ("tolerance", ReportValue::length(done.tolerance)),
        ("sewn_edges", ReportValue::count(done.sewn_edges)),
        ("splits", ReportValue::count(done.splits)),
        ("split_faces", ReportValue::count(done.split_faces)),
        ("left_vertices", ReportValue::count(done.left_vertices.len())),
        ("near_edge_pairs", ReportValue::count(done.near.edge_pairs)),
        ("near_tolerance", ReportValue::length(done.near.tolerance)),
    ];
    Report::new(text, &values)
}
