use super::prelude::*;
use crate::repair::weld::{Options, Vertices, Weld, weld};

pub(super) const FILTER: Filter = Filter {
    id: "weld",
    name: "Weld vertices",
    category: "Repair",
    help: "Merges coincident vertices. Coincident borders are welded edge to edge, whatever the orientation of their faces; or all \
           coincident vertices are merged, as a triangle soup requires.",
    reference: "Greedy clustering in the order of the vertices; edges are sewn two by two",
    replaces: true,
    params: &[
        Param::choice("vertices", "Weld", Vertices::CHOICES.texts).help("The vertices that are welded."),
        Param::length("tolerance", "Tolerance", NON_NEGATIVE, &[0.0]).help(
            "The largest distance of coincident vertices, in the unit of the positions; 0 takes equal positions.",
        ),
        Param::choice("collapse", "Short edges", COLLAPSE.texts)
            .help("The treatment of coincident corners of one face."),
        Param::choice("unused", "Unused vertices", UNUSED.texts).help("The treatment of vertices that no face uses."),
    ],
    ..Filter::new(MESH, TO_MESH_TEXT, run)
};

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
        tolerance: Some(values.number("tolerance")),
        collapse: values.choice("collapse", COLLAPSE),
        remove_unused: values.choice("unused", UNUSED),
    };
    let done = weld(inputs[0].mesh()?, &options, job)?;
    let text = report(&done);
    Ok(vec![Output::Mesh(done.mesh), Output::Text(text)])
}

fn report(done: &Weld) -> String {
    format!(
        "{} vertices welded, {} edges sewn, {} faces dropped\n{} free edges and {} vertices that lie on others are left\n",
        done.welded_vertices,
        done.sewn_edges,
        done.dropped_faces,
        done.left_edges.len(),
        done.left_vertices.len()
    )
}
