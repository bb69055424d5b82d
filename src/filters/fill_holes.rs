//! The filter `fill_holes`.

use super::Filter;
use super::data::{Input, InputKind, Output, OutputKind};
use super::param::{Choice, Param, ParamKind, Values};
use crate::error::Result;
use crate::fill::{Fairing, Filled, HoleStatus, Limits, Options, Refinement, Weight, fill_holes};
use crate::job::Job;

/// No length that is meant as a limit is greater.
const GREATEST: f64 = 1e15;

pub(super) const FILTER: Filter = Filter {
    id: "fill_holes",
    name: "Fill holes",
    script_name: "fill_holes",
    category: "Boundary",
    help: "Closes boundary loops of a mesh by new triangles: the triangulation of least weight, refined until it is as dense \
           as the surface round it, and made fair. Vertices stay where they are and no face is lost.",
    reference: "P. Liepa, Filling holes in meshes (2003); G. Barequet, M. Sharir, Filling gaps in the boundary of a polyhedron (1995)",
    inputs: &[InputKind::Mesh],
    min_inputs: 1,
    max_inputs: 1,
    outputs: &[OutputKind::Mesh, OutputKind::Text],
    replaces: true,
    params: &[
        Param::choice(
            "inside",
            "Inside the holes",
            "What the patches are made of.",
            &[
                Choice { label: "Rim only", help: "Triangles between the vertices of the rim." },
                Choice { label: "Refined", help: "New vertices, as dense as those round the hole." },
                Choice {
                    label: "Refined and fair",
                    help: "New vertices, moved until the patch goes on as the surface does.",
                },
            ],
        ),
        Param::choice(
            "weight",
            "Best triangulation",
            "What makes one triangulation of a rim better than another.",
            &[
                Choice {
                    label: "Least area and bend",
                    help: "The area, and the bends along edges by their squared length.",
                },
                Choice {
                    label: "Least bend",
                    help: "The largest angle between neighbouring faces, and then the area.",
                },
                Choice { label: "Least area", help: "The area alone." },
            ],
        ),
        limit(
            "max_edges",
            "Most edges",
            "Loops of more edges are left alone; 0 is no limit.",
            ParamKind::Int,
            u32::MAX as f64,
        ),
        limit(
            "max_length",
            "Greatest length",
            "Longer loops are left alone; 0 is no limit.",
            ParamKind::Length,
            GREATEST,
        ),
        limit(
            "keep_longest",
            "Keep the longest loop",
            "The outline of an open sheet is no hole.",
            ParamKind::Bool,
            1.0,
        ),
    ],
    suggest: None,
    run,
};

const fn limit(id: &'static str, label: &'static str, help: &'static str, kind: ParamKind, max: f64) -> Param {
    Param { id, label, help, kind, min: 0.0, max, default: &[0.0], step: 0.0, choices: &[] }
}

fn run(inputs: &[Input<'_>], values: &Values<'_>, job: &Job<'_>) -> Result<Vec<Output>> {
    let (edges, length) = (values.number("max_edges"), values.number("max_length"));
    let inside = values.chosen("inside");
    let options = Options {
        weight: [Weight::AreaAndBend, Weight::BendThenArea, Weight::Area][values.chosen("weight")],
        refinement: if inside > 0 { Refinement::RimDensity(0) } else { Refinement::None },
        fairing: if inside > 1 { Fairing::ThinPlate } else { Fairing::None },
        limits: Limits {
            edges: (edges > 0.0).then_some(edges as u32),
            length: (length > 0.0).then_some(length),
            diameter: None,
        },
        keep_longest: values.number("keep_longest") == 1.0,
    };
    let done = fill_holes(inputs[0].mesh()?, None, &options, job)?;
    let text = report(&done);
    Ok(vec![Output::Mesh(done.mesh), Output::Text(text)])
}

fn report(done: &Filled) -> String {
    let filled = done.holes.iter().filter(|hole| hole.status == HoleStatus::Filled);
    let (mut count, mut faces, mut vertices) = (0, 0, 0);
    for hole in filled {
        count += 1;
        faces += hole.faces.len();
        vertices += hole.vertices.len();
    }
    format!(
        "filled {count} of {} loops by {faces} faces and {vertices} new vertices\n\
         area {}, smallest angle {:.2} degrees\n{} boundary loops are left\n",
        done.holes.len(),
        done.quality.area,
        done.quality.min_angle.to_degrees(),
        done.quality.loops_left
    )
}
