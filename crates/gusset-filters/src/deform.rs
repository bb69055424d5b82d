use super::data::{Input, Output};
use super::extent::round_to_two_digits;
use super::filter::{Filter, FilterBody};
use super::moving::{CATEGORY, STRENGTH, copy_mesh, move_mesh, output_of_moved_mesh};
use super::signatures::{ONE_MESH, TO_MESH};
use super::typed_param::{COORDINATE_RANGE, LENGTH_RANGE, Param, ParamValues, params};
use glam::DVec3;
use gusset_base::choices;
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_mesh::MeshView;
use gusset_net::field::{
    Field, bend, cone_wrap, cylinder_wrap, shear, sphere_wrap, spherify, taper, torus_wrap, twist,
};
use gusset_net::transform::Axis;
use std::f64::consts::{FRAC_PI_2, FRAC_PI_6, PI, TAU};

pub(super) const FILTER: Filter = Filter {
    id: "deform",
    name: "Deform",
    category: CATEGORY,
    help: "Moves the vertices of a mesh by a deformation field: twist, taper, bend or shear about an axis, projection towards a \
           sphere, or a wrap, which rolls a sheet onto a cylinder, a cone, a torus or a sphere. Faces do not change, and \
           coincident vertices stay coincident.",
    reference: "A. A. Deryagin, Modelling of 3D objects and scenes by tetragonal regular networks, deformation fields; A. Barr, \
                Global and local deformations of solid primitives (1984)",
    replaces: true,
    has_origins: true,
    ..Filter::new(ONE_MESH, TO_MESH, &FilterBody(run))
};

params! {
    field: MakeField = Param::choice("Field", "The deformation field.", FIELDS);
    axis: [Axis; 2] = Param::choice("Axis", "The axis of the field, through the origin.", AXES);
    amount: f64 = Param::real(
        "Amount",
        "The parameter of all fields except wraps; 0 leaves the mesh unchanged. The suggestion suits a twist.",
        COORDINATE_RANGE, &[0.1],
    ).suggested(|_, extent| Some(round_to_two_digits(0.25 * PI / extent.diagonal())));
    strength: f64 = STRENGTH;
    radius: f64 = Param::length(
        "Radius",
        "The radius of a wrap; for a torus, the radius of its centre line. A wrap about the z axis with the suggested radius \
         takes the extent of the mesh along x exactly once around.",
        LENGTH_RANGE, &[1.0],
    ).suggested(|_, extent| Some(radius_of_circumference(extent.size().x, extent.diagonal())));
    minor_radius: f64 = Param::length(
        "Minor radius",
        "The radius of the tube of a torus. With the suggested radius, the extent along y goes exactly once around the tube.",
        LENGTH_RANGE, &[0.25],
    ).suggested(|_, extent| Some(radius_of_circumference(extent.size().y, 0.25 * extent.diagonal())));
    lean: f64 = Param::angle(
        "Lean",
        "The angle by which the generators of a cone lean towards its axis.",
        [-FRAC_PI_2, FRAC_PI_2], &[FRAC_PI_6],
    );
}

/// The field that the parameters give for a mesh; `None` leaves the mesh unchanged.
type MakeField = fn(&Params, &MeshView<'_>) -> Result<Option<Box<dyn Field>>>;

choices! {
    FIELDS: MakeField =
        |values, _| boxed_field_unless_zero(values, twist(values.axis[0], values.amount, 0.0)) => "Twist",
            "Rotates about the axis, by the amount in radians for each unit of length along it.";
        |values, _| boxed_field_unless_zero(values, taper(values.axis[0], values.amount, 0.0)) => "Taper",
            "Scales across the axis, by 1 plus the amount for each unit of length along it.";
        |values, mesh| {
            let lowest = lowest_coordinate(mesh, values.axis[0]);
            boxed_field_unless_zero(values, bend(values.axis[0], values.amount, lowest, f64::INFINITY))
        } => "Bend", "Bends the axis into an arc from the lowest vertex on. The amount is its curvature.";
        |values, _| boxed_field_unless_zero(values, shear(values.axis[0], values.axis[1], values.amount)) => "Shear",
            "Moves along the axis by the amount times the next coordinate.";
        |values, _| boxed_field_unless_zero(values, spherify(DVec3::ZERO, values.amount.abs())) => "Spherify",
            "Projects towards the sphere about the origin whose radius is the amount.";
        |values, _| boxed_field(cylinder_wrap(values.axis[0], values.radius)) => "Cylinder wrap",
            "Rolls space about the axis. The next coordinate (x for the z axis) becomes the arc, and the one after it the height \
             above the cylinder.";
        |values, _| boxed_field(cone_wrap(values.axis[0], values.radius, values.lean)) => "Cone wrap",
            "Rolls space into a cone about the axis. The next coordinate (x for the z axis) becomes the arc of the circle of the \
             radius, the one after it the height above the cone, and the one along the axis the length along generators.";
        |values, _| boxed_field(torus_wrap(values.axis[0], values.radius, values.minor_radius)) => "Torus wrap",
            "Rolls space into a torus about the axis. The next two coordinates (x and y for the z axis) become the arcs around \
             the axis and around the tube, and the one along the axis the height above the torus.";
        |values, _| boxed_field(sphere_wrap(values.axis[0], values.radius)) => "Sphere wrap",
            "Rolls space into a sphere about the axis. The next two coordinates (x and y for the z axis) become the arcs along the \
             equator and along meridians, and the one along the axis the height above the sphere.";
}

choices! {
    /// The axis and the one that follows it.
    AXES: [Axis; 2] =
        [Axis::Z, Axis::X] => "z", "The third axis.";
        [Axis::X, Axis::Y] => "x", "The first axis.";
        [Axis::Y, Axis::Z] => "y", "The second axis.";
}

/// A field whose amount 0 is the identity, even where the field itself is undefined.
fn boxed_field_unless_zero(values: &Params, field: Result<impl Field + 'static>) -> Result<Option<Box<dyn Field>>> {
    if values.amount == 0.0 { Ok(None) } else { boxed_field(field) }
}

fn boxed_field(field: Result<impl Field + 'static>) -> Result<Option<Box<dyn Field>>> {
    field.map(|field| Some(Box::new(field) as Box<dyn Field>))
}

fn run(inputs: &[Input<'_>], values: &ParamValues<Params>, job: &Job<'_>) -> Result<Vec<Output>> {
    let mesh = inputs[0].mesh()?;
    let moved = match (values.field)(values, mesh)? {
        Some(field) => move_mesh(mesh, field.as_ref(), values.strength, job)?,
        None => copy_mesh(mesh, job)?,
    };
    Ok(vec![output_of_moved_mesh(moved, inputs, values, job)?])
}

/// The radius of a circle of the given length, or of another length if that is 0.
fn radius_of_circumference(length: f64, otherwise: f64) -> f64 {
    if length > 0.0 { length / TAU } else { otherwise / TAU }
}

/// The smallest coordinate along an axis.
fn lowest_coordinate(mesh: &MeshView<'_>, axis: Axis) -> f64 {
    let positions = mesh.positions();
    let all = (0..positions.len()).map(|v| positions.get(v as u32)[axis.index()]);
    Some(all.fold(f64::INFINITY, f64::min)).filter(|low| low.is_finite()).unwrap_or(0.0)
}
