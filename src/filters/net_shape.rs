//! The filter `net_shape`.

use super::Filter;
use super::data::{Input, Output, OutputKind};
use super::param::{Choice, LENGTHS, Param, ParamKind, Values};
use super::quads::{self, CATEGORY, REFERENCE, TRIANGLES};
use crate::error::{Error, Result};
use crate::job::Job;
use crate::net::closure::{BoxKind, Cuboid};
use crate::net::complex::{Cells, Complex};
use crate::net::primitive::{Primitive, Request};

pub(super) const FILTER: Filter = Filter {
    id: "net_shape",
    name: "Shape of quads",
    script_name: "net_shape",
    category: CATEGORY,
    help: "Makes a shape as a regular network of quads, closed by gluing: a mesh whose rows and columns of faces run on over its \
           seams, with one vertex where a side is drawn together to a pole.",
    reference: REFERENCE,
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
                Choice { label: "Prism", help: "An upright prism over a regular polygon, with caps." },
                Choice { label: "Pyramid", help: "An upright pyramid over a regular polygon, with its base." },
                Choice {
                    label: "Projective plane",
                    help: "Boy's surface: closed, with one side; it passes through itself.",
                },
                Choice {
                    label: "Pillow",
                    help: "Two square sheets of twice the radius, joined along their rim; as thick as the minor radius, and with an \
                           odd number of columns.",
                },
            ],
        ),
        count("rows", "Rows", "The number of rows of nodes, from one pole or rim to the other.", &[33.0]),
        count(
            "columns",
            "Columns",
            "The number of columns of nodes; of closed rows the last node is the first again.",
            &[65.0],
        ),
        length("radius", "Radius", "The radius, or for rings that of the middle of the tube.", &[1.0]),
        length("minor_radius", "Minor radius", "That of the tube of a ring, smaller than the radius.", &[0.25]),
        length("height", "Height", "The height of tubes, cylinders, cones, prisms and pyramids.", &[2.0]),
        TRIANGLES,
        Param::new(
            "sides",
            "Sides",
            "The number of sides of the polygon under prisms and pyramids, less than there are columns.",
            ParamKind::Int,
            [3.0, 10_000.0],
            &[6.0],
        ),
    ],
    suggest: None,
    run,
};

const fn count(id: &'static str, label: &'static str, help: &'static str, default: &'static [f64]) -> Param {
    Param::new(id, label, help, ParamKind::Int, [5.0, 10_001.0], default)
}

const fn length(id: &'static str, label: &'static str, help: &'static str, default: &'static [f64]) -> Param {
    Param::new(id, label, help, ParamKind::Length, LENGTHS, default)
}

fn run(_: &[Input<'_>], values: &Values<'_>, job: &Job<'_>) -> Result<Vec<Output>> {
    let [radius, minor_radius, height] = ["radius", "minor_radius", "height"].map(|id| values.number(id));
    let [rows, columns] = ["rows", "columns"].map(|id| values.number(id) as usize);
    let side = 2.0 * radius;
    let (cells, sides) = ([rows as u32 - 1; 3], values.number("sides") as u32);
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
        Primitive::Prism { sides, radius, height },
        Primitive::Pyramid { sides, radius, height },
        Primitive::ProjectivePlane { radius },
        Primitive::Pillow { size: [side; 2], thickness: minor_radius },
    ];
    let request = Request { rows, columns, ..Request::new(shapes[values.chosen("shape")]) };
    let net = request.net(&job.part(0.0, 0.5)).map_err(|error| match error {
        // The other measures are in their ranges, and always fit.
        Error::OptionOutOfRange { option: "minor radius", value } => {
            Error::OptionOutOfRange { option: "minor_radius", value }
        }
        error => error,
    })?;
    let complex = Complex::of(&net, Cells::All, &job.part(0.5, 0.7))?;
    let mesh = quads::mesh(&net, values, &job.part(0.7, 1.0))?;
    let text = format!(
        "{} vertices, {} edges, {} quads, {} triangles\nEuler characteristic {}, {} boundary loops\n",
        complex.vertices,
        complex.edges,
        complex.quads,
        complex.triangles,
        complex.euler_characteristic(),
        complex.boundary.len()
    );
    Ok(vec![Output::Mesh(mesh), Output::Text(text)])
}
