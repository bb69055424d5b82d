use super::data::{Input, Output};
use super::filter::Filter;
use super::param::{Param, Values};
use super::report::{BOUNDARY_EDGE, EDGE, FACE, VERTEX};
use super::report::{Report, counted};
use super::signatures::{MESH, TO_MESH_TEXT};
use gusset_attributes::{KeepSplits, Origins};
use gusset_base::choices;
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_stitch::repair::weld::{Options, Vertices, Weld, weld};

pub(super) const FILTER: Filter = Filter {
    id: "weld",
    name: "Weld vertices",
    category: "Repair",
    help: "Merges coincident vertices. Coincident borders are welded edge to edge, whatever the orientation of their faces; or all \
           coincident vertices are merged, as a triangle soup requires.",
    reference: "Greedy clustering in the order of the vertices; edges are sewn two by two",
    replaces: true,
    has_origins: true,
    params: &[
        Param::choice("vertices", "Weld", Vertices::CHOICES.texts).with_help("The vertices that are welded."),
        Param::length("tolerance", "Tolerance", TOLERANCES, &[-1.0]).with_help(
            "The largest distance of coincident vertices, in the unit of the positions; 0 takes equal positions, -1 what \
             rounding of the positions can do, as their type and the digits that they show tell.",
        ),
        Param::choice("collapse", "Short edges", COLLAPSE.texts)
            .with_help("The treatment of coincident corners of one face."),
        UNUSED_PARAM,
    ],
    ..Filter::new(MESH, TO_MESH_TEXT, run)
};

/// Lengths from 0 on, and -1 for the one that the data call for.
pub(super) const TOLERANCES: [f64; 2] = [-1.0, 1e15];

/// What becomes of vertices that no face uses.
pub(super) const UNUSED_PARAM: Param =
    Param::choice("unused", "Unused vertices", UNUSED.texts).with_help("The treatment of vertices that no face uses.");

/// True if vertices that no face uses are left out.
pub(super) fn removes_unused(values: &Values<'_>) -> bool {
    values.choice("unused", UNUSED)
}

/// The tolerance given, if one is.
pub(super) fn tolerance(values: &Values<'_>) -> Option<f64> {
    Some(values.number("tolerance")).filter(|&tolerance| tolerance >= 0.0)
}

choices! {
    COLLAPSE: bool =
        false => "Keep", "They stay apart.";
        true => "Collapse", "They are merged, and a face of fewer than three corners is dropped.";
}

choices! {
    UNUSED: bool =
        false => "Keep", "They stay.";
        true => "Remove", "They are dropped.";
}

fn run(inputs: &[Input<'_>], values: &Values<'_>, job: &Job<'_>) -> Result<Vec<Output>> {
    let options = Options {
        vertices: values.choice("vertices", Vertices::CHOICES),
        tolerance: tolerance(values),
        collapse: values.choice("collapse", COLLAPSE),
        remove_unused: removes_unused(values),
    };
    let mut done = weld(inputs[0].mesh()?, &options, job)?;
    done.keep_splits(&[inputs[0].mesh()?], &job.part(1.0, 1.0))?;
    let report = report(&done);
    let origins = values.origins(|| Origins::from_weld(&done, &job.part(1.0, 1.0)))?;
    Ok(vec![Output::Mesh(done.mesh, origins), Output::Text(report)])
}

fn report(done: &Weld) -> Report {
    let [edges, vertices] = [done.left_edges.len(), done.left_vertices.len()];
    // Edges that lie on no other are boundary edges of the result as well, which `check` counts.
    let left = match (edges, vertices) {
        (0, 0) => "no coincident borders are left apart".to_owned(),
        _ => format!(
            "left apart: {} and {} that lie on others",
            counted(edges, BOUNDARY_EDGE),
            counted(vertices, VERTEX)
        ),
    };
    let text = format!(
        "{} welded, {} sewn, {} dropped\n{left}\n",
        counted(done.welded_vertices, VERTEX),
        counted(done.sewn_edges, EDGE),
        counted(done.dropped_faces, FACE)
    );
    let values = [
        ("welded_vertices", f64::from(done.welded_vertices)),
        ("tolerance", done.tolerance),
        ("sewn_edges", f64::from(done.sewn_edges)),
        ("dropped_faces", f64::from(done.dropped_faces)),
        ("coincident_boundary_edges", edges as f64),
        ("coincident_vertices", vertices as f64),
    ];
    Report::new(text, &values)
}
