use super::data::{Input, Output};
use super::filter::{Filter, FilterBody};
use super::moving::{CATEGORY, STRENGTH, move_mesh, output_of_moved_mesh};
use super::signatures::{ONE_MESH, TO_MESH};
use super::typed_param::{Param, ParamValues, PlaneValue, params};
use glam::DVec3;
use gusset_base::choices;
use gusset_base::error::{Error, Result};
use gusset_base::job::Job;
use gusset_net::field::{Field, parallel_projection, perspective_projection};

pub(super) const FILTER: Filter = Filter {
    id: "project",
    name: "Project onto a plane",
    category: CATEGORY,
    help: "Projects the vertices of a mesh onto a plane, along a direction or through a point, or moves them a fraction of the \
           way. Faces do not change.",
    reference: "A. A. Deryagin, Modelling of 3D objects and scenes by tetragonal regular networks, projections",
    replaces: true,
    has_origins: true,
    ..Filter::new(ONE_MESH, TO_MESH, &FilterBody(run))
};

params! {
    plane: PlaneValue = Param::plane("Plane", "The plane of projection. The plane below the mesh is suggested.")
        .suggested(|_, extent| Some([0.0, 0.0, 1.0, extent.low.z]));
    along: MakeProjection = Param::choice("Along", "The lines of projection.", PROJECTIONS);
    direction: DVec3 = Param::direction("Direction", "The direction of projection, if it is given.");
    eye: DVec3 = Param::point(
        "Point",
        "The centre of projection, if it is given. A point above the mesh is suggested.",
        &[0.0, 0.0, 1e3],
    ).suggested(|_, extent| Some(extent.centre().with_z(extent.high.z + 2.0 * extent.diagonal())));
    strength: f64 = STRENGTH;
}

/// The projection that the parameters give.
type MakeProjection = fn(&Params) -> Result<Box<dyn Field>>;

choices! {
    PROJECTIONS: MakeProjection =
        |values| parallel_projection_field(values.plane, values.plane.normal) => "Normal", "Perpendicular to the plane.";
        |values| {
            require_nonzero_height("direction", values.plane.normal.dot(values.direction), 1.0)?;
            parallel_projection_field(values.plane, values.direction)
        } => "Direction", "Along the given direction, which is not parallel to the plane.";
        |values| central_projection_field(values.plane, values.eye) => "Lines through a point",
            "Central projection from the given point, which is not in the plane.";
}

fn parallel_projection_field(PlaneValue { normal, distance }: PlaneValue, direction: DVec3) -> Result<Box<dyn Field>> {
    Ok(Box::new(parallel_projection(distance * normal, normal, direction)?))
}

fn central_projection_field(PlaneValue { normal, distance }: PlaneValue, eye: DVec3) -> Result<Box<dyn Field>> {
    require_nonzero_height("eye", normal.dot(eye) - distance, eye.length() + distance.abs())?;
    Ok(Box::new(perspective_projection(eye, distance * normal, normal)?))
}

fn run(inputs: &[Input<'_>], values: &ParamValues<Params>, job: &Job<'_>) -> Result<Vec<Output>> {
    let moved = move_mesh(inputs[0].mesh()?, (values.along)(values)?.as_ref(), values.strength, job)?;
    Ok(vec![output_of_moved_mesh(moved, inputs, values, job)?])
}

/// [`Error::OptionOutOfRange`] for a height above the plane that is 0 within rounding.
fn require_nonzero_height(option: &'static str, height: f64, size: f64) -> Result<()> {
    Error::require(height.abs() > 64.0 * f64::EPSILON * size, option, height, "outside the plane")
}
