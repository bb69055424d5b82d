//! The filter `project`.

use super::Filter;
use super::data::{Input, InputKind, Output, OutputKind};
use super::deform::moved;
use super::extent::{extent_of, put};
use super::param::{Choice, PLACES, Param, ParamKind, Values};
use crate::error::{Error, Result};
use crate::job::Job;
use crate::net::field::Projection;
use glam::DVec3;

pub(super) const FILTER: Filter = Filter {
    id: "project",
    name: "Project onto a plane",
    script_name: "project",
    category: "Nets",
    help: "Moves the vertices of a mesh onto a plane, along a direction or along the lines through a point, or a part of the way there. \
           Faces stay what they are.",
    reference: "A. A. Deryagin, Modelling of 3D objects and scenes by tetragonal regular networks, projections",
    inputs: &[InputKind::Mesh],
    min_inputs: 1,
    max_inputs: 1,
    outputs: &[OutputKind::Mesh],
    replaces: true,
    params: PARAMS,
    suggest: Some(suggest),
    run,
};

const PARAMS: &[Param] = &[
    Param::new(
        "plane",
        "Plane",
        "Where the vertices are moved to; suggested is the plane under the mesh.",
        ParamKind::Plane,
        PLACES,
        &[0.0, 0.0, 1.0, 0.0],
    ),
    Param::choice(
        "along",
        "Along",
        "Which way the vertices are moved.",
        &[
            Choice { label: "Normal", help: "Straight to the plane." },
            Choice { label: "Direction", help: "Along the given direction, which is not parallel to the plane." },
            Choice { label: "Lines through a point", help: "As seen from the given point, which is not in the plane." },
        ],
    ),
    Param::new(
        "direction",
        "Direction",
        "The direction, if one is to be given.",
        ParamKind::Direction,
        PLACES,
        &[0.0, 0.0, 1.0],
    ),
    Param::new(
        "eye",
        "Point",
        "The point, if one is to be given; suggested is one above the mesh.",
        ParamKind::Point,
        PLACES,
        &[0.0, 0.0, 1e3],
    ),
    Param::new(
        "strength",
        "Strength",
        "The part of the way that is gone: 0 leaves all as it is, 1 puts the vertices in the plane.",
        ParamKind::Real,
        [0.0, 1.0],
        &[1.0],
    ),
];

fn suggest(inputs: &[Input<'_>], values: &mut [f64]) {
    if let Some(extent) = extent_of(inputs) {
        put(PARAMS, values, "plane", &[0.0, 0.0, 1.0, extent.low.z]);
        let eye = extent.centre().with_z(extent.high.z + 2.0 * extent.diagonal());
        put(PARAMS, values, "eye", &eye.to_array());
    }
}

fn run(inputs: &[Input<'_>], values: &Values<'_>, job: &Job<'_>) -> Result<Vec<Output>> {
    let (normal, distance): (DVec3, f64) = values.plane("plane")?;
    let point = distance * normal;
    let field = match values.chosen("along") {
        0 => Projection::parallel(point, normal, normal)?,
        1 => {
            let direction = values.direction("direction")?;
            refuse("direction", normal.dot(direction), 1.0)?;
            Projection::parallel(point, normal, direction)?
        }
        _ => {
            let eye = values.vector("eye");
            refuse("eye", normal.dot(eye) - distance, eye.length() + distance.abs())?;
            Projection::perspective(eye, point, normal)?
        }
    };
    Ok(vec![Output::Mesh(moved(inputs[0].mesh()?, &field, values.number("strength"), job)?)])
}

/// [`Error::OptionOutOfRange`] for a height above the plane that is none but for rounding.
fn refuse(option: &'static str, height: f64, size: f64) -> Result<()> {
    if height.abs() > 64.0 * f64::EPSILON * size {
        Ok(())
    } else {
        Err(Error::OptionOutOfRange { option, value: height })
    }
}
