//! The filter `weld`.

use super::Filter;
use super::data::{Input, InputKind, Output, OutputKind};
use super::param::{Choice, Param, ParamKind, Values};
use crate::error::Result;
use crate::job::Job;
use crate::repair::weld::{Options, Vertices, Weld, weld};

pub(super) const FILTER: Filter = Filter {
    id: "weld",
    name: "Weld vertices",
    script_name: "weld",
    category: "Repair",
    help: "Makes one vertex of vertices that lie together. Borders that lie on one another are sewn edge to edge, whichever \
           way their faces look; or all vertices that lie together become one, as a triangle soup needs it.",
    reference: "Greedy clustering in the order of the vertices; edges are sewn two by two",
    inputs: &[InputKind::Mesh],
    min_inputs: 1,
    max_inputs: 1,
    outputs: &[OutputKind::Mesh, OutputKind::Text],
    replaces: true,
    params: &[
        Param::choice(
            "vertices",
            "Weld",
            "Which vertices are welded.",
            &[
                Choice { label: "Borders", help: "Free edges that lie on one another two by two become one edge." },
                Choice { label: "All vertices", help: "All that lie together, whatever comes of the edges." },
            ],
        ),
        Param {
            id: "tolerance",
            label: "Tolerance",
            help: "How far apart vertices that lie together may be, in the unit of the positions; 0 takes equal positions.",
            kind: ParamKind::Length,
            min: 0.0,
            max: 1e15,
            default: &[0.0],
            step: 0.0,
            choices: &[],
        },
        Param::choice(
            "collapse",
            "Short edges",
            "What becomes of two corners of one face that lie together.",
            &[
                Choice { label: "Keep", help: "They stay apart." },
                Choice {
                    label: "Collapse",
                    help: "They become one, and a face of fewer than three corners is dropped.",
                },
            ],
        ),
        Param::choice(
            "unused",
            "Unused vertices",
            "What becomes of vertices that no face uses.",
            &[Choice { label: "Keep", help: "They stay." }, Choice { label: "Remove", help: "They are left out." }],
        ),
    ],
    suggest: None,
    run,
};

fn run(inputs: &[Input<'_>], values: &Values<'_>, job: &Job<'_>) -> Result<Vec<Output>> {
    let options = Options {
        vertices: [Vertices::Boundary, Vertices::All][values.chosen("vertices")],
        tolerance: Some(values.number("tolerance")),
        collapse: values.chosen("collapse") == 1,
        remove_unused: values.chosen("unused") == 1,
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
