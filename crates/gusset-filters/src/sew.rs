use super::data::{Input, Output};
use super::filter::Filter;
use super::param::{Param, Values};
use super::report::{EDGE, FACE, VERTEX};
use super::report::{Report, counted};
use super::signatures::{MESH, TO_MESH_TEXT};
use super::weld::{TOLERANCES, UNUSED_PARAM, removes_unused, tolerance};
use gusset_attributes::{KeepSplits, Origins};
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_stitch::repair::sew::{Sew, sew};
use gusset_stitch::repair::weld::Options;

pub(super) const FILTER: Filter = Filter {
    id: "sew",
    name: "Sew borders",
    category: "Repair",
    help: "Welds borders that lie on one another, also where their vertices do not match: edges are split where vertices of \
           another border lie on them, if the parts then coincide two by two. Triangles with split edges are cut into triangles, \
           larger faces gain corners.",
    reference: "Greedy clustering in the order of the vertices; edges are sewn two by two",
    replaces: true,
    has_origins: true,
    params: &[
        Param::length("tolerance", "Tolerance", TOLERANCES, &[-1.0]).with_help(
            "The largest distance of vertices from others or from edges that they lie on; 0 takes equal positions, -1 what \
             rounding of the positions can do, as their type and the digits that they show tell.",
        ),
        UNUSED_PARAM,
    ],
    ..Filter::new(MESH, TO_MESH_TEXT, run)
};

fn run(inputs: &[Input<'_>], values: &Values<'_>, job: &Job<'_>) -> Result<Vec<Output>> {
    let options = Options { tolerance: tolerance(values), remove_unused: removes_unused(values), ..Options::default() };
    let mut done = sew(inputs[0].mesh()?, &options, job)?;
    done.keep_splits(&[inputs[0].mesh()?], &job.part(1.0, 1.0))?;
    let report = report(&done);
    let origins = values.origins(|| Origins::from_sew(&done, &job.part(1.0, 1.0)))?;
    Ok(vec![Output::Mesh(done.mesh, origins), Output::Text(report)])
}

fn report(done: &Sew) -> Report {
    let text = format!(
        "{} welded, {} sewn, {} split at {}\n{} left that lie on others or on edges\n",
        counted(done.welded_vertices, VERTEX),
        counted(done.sewn_edges, EDGE),
        counted(done.split_faces, FACE),
        counted(done.splits, ["point", "points"]),
        counted(done.left_vertices.len(), VERTEX)
    );
    let values = [
        ("welded_vertices", f64::from(done.welded_vertices)),
        ("tolerance", done.tolerance),
        ("sewn_edges", f64::from(done.sewn_edges)),
        ("splits", f64::from(done.splits)),
        ("split_faces", f64::from(done.split_faces)),
        ("left_vertices", done.left_vertices.len() as f64),
    ];
    Report::new(text, &values)
}
