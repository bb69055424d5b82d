//! The filter `net_shape`.

use super::Filter;
use super::data::{Input, Output, OutputKind};
use super::param::{Choice, Param, ParamKind, Values};
use crate::error::Result;
use crate::job::Job;
use crate::net::closure::{BoxKind, Cuboid};
use crate::net::complex::{Cells, Complex};
use crate::net::convert::{Diagonal, MeshOptions};
use crate::net::primitive::{Primitive, Request};

pub(super) const FILTER: Filter = Filter {
    id: "net_shape",
    name: "Shape of quads",
    script_name: "net_shape",
    category: "Nets",
    help: "Makes a shape as a regular network of quads, closed by gluing: a mesh whose rows and columns of faces run on over its \
           seams, with one vertex where a side is drawn together to a pole.",
    reference: "A. A. Deryagin, Modelling of 3D objects and scenes by tetragonal regular networks",
    inputs: &[],
    min_inputs: 0,
    max_inputs: 0,
    outputs: &[OutputKind::Mesh, OutputKind::Text],
    replaces: false,
    params: &[
        Param::choice(
            "shape",
            "Shape",
            "What is made, round the z axis.",
            &[
                Choice { label: "Sphere", help: "Meridians and parallels, with two poles." },
                Choice { label: "One-pole sphere", help: "A disc whose rim is drawn together at the lowest point." },
                Choice { label: "Plane", help: "A square of twice the radius, seen from above." },
                Choice { label: "Tube", help: "A cylinder without caps." },
                Choice { label: "Cylinder", help: "A cylinder with caps." },
                Choice { label: "Cone", help: "A cone with its base." },
                Choice { label: "Torus", help: "A ring; its tube has the minor radius." },
                Choice {
                    label: "Cube",
                    help: "A cube of twice the radius; each face has as many quads along a side as there are rows.",
                },
                Choice { label: "Moebius strip", help: "A strip with one side, as wide as the minor radius." },
                Choice { label: "Klein bottle", help: "A closed surface with one side, which passes through itself." },
            ],
        ),
        count("rows", "Rows", "The number of rows of nodes, from one pole or rim to the other.", 33.0),
        count(
            "columns",
            "Columns",
            "The number of columns of nodes; of closed rows the last node is the first again.",
            65.0,
        ),
        length("radius", "Radius", "The radius, or for rings that of the middle of the tube.", 1.0),
        length("minor_radius", "Minor radius", "That of the tube of a ring, smaller than the radius.", 0.25),
        length("height", "Height", "The height of tubes, cylinders and cones.", 2.0),
        Param {
            id: "triangles",
            label: "Triangles",
            help: "Quads are cut along their shorter diagonals.",
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

const fn count(id: &'static str, label: &'static str, help: &'static str, usual: f64) -> Param {
    let default: &'static [f64] = if usual == 33.0 { &[33.0] } else { &[65.0] };
    Param { id, label, help, kind: ParamKind::Int, min: 5.0, max: 10_001.0, default, step: 1.0, choices: &[] }
}

const fn length(id: &'static str, label: &'static str, help: &'static str, usual: f64) -> Param {
    let default: &'static [f64] = if usual == 1.0 {
        &[1.0]
    } else if usual == 2.0 {
        &[2.0]
    } else {
        &[0.25]
    };
    Param { id, label, help, kind: ParamKind::Length, min: 1e-9, max: 1e9, default, step: 0.0, choices: &[] }
}

fn run(_: &[Input<'_>], values: &Values<'_>, job: &Job<'_>) -> Result<Vec<Output>> {
    let [radius, minor_radius, height] = ["radius", "minor_radius", "height"].map(|id| values.number(id));
    let [rows, columns] = ["rows", "columns"].map(|id| values.number(id) as usize);
    let side = 2.0 * radius;
    let cells = [rows as u32 - 1; 3];
    let shapes = [
        Primitive::Sphere { radius },
        Primitive::OnePoleSphere { radius },
        Primitive::Plane { size: [side; 2] },
        Primitive::Tube { radius, height },
        Primitive::Cylinder { radius, height },
        Primitive::Cone { radius, height },
        Primitive::Torus { radius, minor_radius },
        Primitive::Cuboid { cuboid: Cuboid { cells, kind: BoxKind::Slit }, size: [side; 3] },
        Primitive::Moebius { radius, width: minor_radius },
        Primitive::Klein { radius, minor_radius },
    ];
    let request = Request { rows, columns, ..Request::new(shapes[values.chosen("shape")]) };
    let net = request.net(&job.part(0.0, 0.5))?;
    let complex = Complex::of(&net, Cells::All, &job.part(0.5, 0.7))?;
    let triangles = (values.number("triangles") != 0.0).then_some(Diagonal::Shorter);
    let mesh = net.to_mesh(&MeshOptions { triangles, ..MeshOptions::default() }, &job.part(0.7, 1.0))?;
    let text = format!(
        "{} vertices, {} edges, {} quads, {} triangles\nEuler characteristic {}, {} boundary loops\n",
        complex.vertices,
        complex.edges,
        complex.quads,
        complex.triangles,
        complex.euler_characteristic(),
        complex.boundary.len()
    );
    Ok(vec![Output::Mesh(mesh.mesh), Output::Text(text)])
}
