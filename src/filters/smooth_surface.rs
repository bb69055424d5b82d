//! The filter `smooth_surface`.

use super::Filter;
use super::data::{Input, InputKind, Output, OutputKind};
use super::param::{Param, ParamKind, Values};
use super::smooth::{self, CATEGORY, REFERENCE, SCHEME};
use crate::carcass::SurfaceMeshOptions;
use crate::error::Result;
use crate::job::Job;

pub(super) const FILTER: Filter = Filter {
    id: "smooth_surface",
    name: "Smooth surface through quads",
    script_name: "smooth_surface",
    category: CATEGORY,
    help: "Draws a smooth surface through the vertices of a grid of quads and returns it as a finer mesh, whose vertices lie on the \
           surface and whose faces are as near to it as is asked for.",
    reference: REFERENCE,
    inputs: &[InputKind::Mesh],
    min_inputs: 1,
    max_inputs: 1,
    outputs: &[OutputKind::Mesh, OutputKind::Text],
    replaces: false,
    params: &[
        SCHEME,
        Param {
            id: "deviation",
            label: "Deviation",
            help: "How far faces may be from the surface, relative to the diagonal of its box.",
            kind: ParamKind::Real,
            min: 1e-7,
            max: 1.0,
            default: &[1e-3],
            step: 0.0,
            choices: &[],
        },
        Param {
            id: "parts",
            label: "Parts",
            help: "The fewest parts that each side of a quad is cut into.",
            kind: ParamKind::Int,
            min: 1.0,
            max: 1000.0,
            default: &[1.0],
            step: 1.0,
            choices: &[],
        },
        Param {
            id: "triangles",
            label: "Triangles",
            help: "The mesh is made of triangles instead of quads.",
            kind: ParamKind::Bool,
            min: 0.0,
            max: 1.0,
            default: &[0.0],
            step: 1.0,
            choices: &[],
        },
    ],
    suggest: None,
    run,
};

fn run(inputs: &[Input<'_>], values: &Values<'_>, job: &Job<'_>) -> Result<Vec<Output>> {
    let surface = smooth::surface(inputs[0].mesh()?, values, &job.part(0.0, 0.4))?;
    let [low, high] = surface.bounds();
    let options = SurfaceMeshOptions {
        tolerance: (values.number("deviation") * low.distance(high)).max(f64::MIN_POSITIVE),
        least: [values.number("parts") as u32; 2],
        triangles: values.number("triangles") != 0.0,
    };
    let made = surface.sheet(0).to_mesh(&options, &job.part(0.4, 1.0))?;
    let faces = made.mesh.face_offsets.len().saturating_sub(1);
    let text =
        format!("{} vertices, {faces} faces, at most {:.1e} from the surface\n", made.places.len(), made.deviation);
    Ok(vec![Output::Mesh(made.mesh), Output::Text(text)])
}
