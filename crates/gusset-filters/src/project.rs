use super::data::{Input, Output};
use super::deform::{moved, moved_output};
use super::extent::extent_of;
use super::filter::{Defaults, Filter};
use super::param::{COORDINATES, Param, ParamKind, Values};
use super::signatures::{MESH, TO_MESH};
use gusset_base::choice::Choice;
use gusset_base::error::{Error, Result};
use gusset_base::job::Job;
use gusset_net::field::{Field, parallel_projection, perspective_projection};

pub(super) const FILTER: Filter = Filter {
    id: "project",
    name: "Project onto a plane",
    category: "Deformation",
    help: "Projects the vertices of a mesh onto a plane, along a direction or through a centre, or moves them a fraction of the way. \
           Faces are unchanged.",
    reference: "A. A. Deryagin, Modelling of 3D objects and scenes by tetragonal regular networks, projections",
    replaces: true,
    has_origins: true,
    params: &[
        Param::plane("plane", "Plane").with_help("The plane of projection; the plane below the mesh is suggested."),
        Param::choice("along", "Along", PROJECTIONS).with_help("The lines of projection."),
        Param::direction("direction", "Direction").with_help("The direction of projection, if given."),
        Param::new(ParamKind::Point, "eye", "Point", COORDINATES, &[0.0, 0.0, 1e3])
            .with_help("The centre of projection, if given; a point above the mesh is suggested."),
        Param::real("strength", "Strength", [0.0, 1.0], &[1.0])
            .with_help("The fraction of the way: 0 leaves the mesh unchanged, 1 puts the vertices in the plane."),
    ],
    suggest: Some(suggest),
    ..Filter::new(MESH, TO_MESH, run)
};

const PROJECTIONS: &[Choice] = &[
    Choice::new("Normal", "Perpendicular to the plane."),
    Choice::new("Direction", "Along the given direction, which is not parallel to the plane."),
    Choice::new("Lines through a point", "Central projection from the given point, which is not in the plane."),
];

fn suggest(inputs: &[Input<'_>], defaults: &mut Defaults<'_>) {
    if let Some(extent) = extent_of(inputs) {
        defaults.set("plane", &[0.0, 0.0, 1.0, extent.low.z]);
        let eye = extent.centre().with_z(extent.high.z + 2.0 * extent.diagonal());
        defaults.set("eye", &eye.to_array());
    }
}

fn run(inputs: &[Input<'_>], values: &Values<'_>, job: &Job<'_>) -> Result<Vec<Output>> {
    let (normal, distance) = values.plane("plane")?;
    let point = distance * normal;
    let field: Box<dyn Field> = match values.place("along") {
        0 => Box::new(parallel_projection(point, normal, normal)?),
        1 => {
            let direction = values.direction("direction")?;
            require_height("direction", normal.dot(direction), 1.0)?;
            Box::new(parallel_projection(point, normal, direction)?)
        }
        _ => {
            let eye = values.vector("eye");
            require_height("eye", normal.dot(eye) - distance, eye.length() + distance.abs())?;
            Box::new(perspective_projection(eye, point, normal)?)
        }
    };
    let moved = moved(inputs[0].mesh()?, field.as_ref(), values.number("strength"), job)?;
    Ok(vec![moved_output(moved, inputs, values, job)?])
}

/// [`Error::OptionOutOfRange`] for a height above the plane that vanishes within rounding.
fn require_height(option: &'static str, height: f64, size: f64) -> Result<()> {
    Error::require(height.abs() > 64.0 * f64::EPSILON * size, option, height)
}
