use super::data::with_positions;
use super::data::{Input, Output};
use super::extent::extent_of;
use super::extent::rounded;
use super::filter::{Defaults, Filter};
use super::param::{COORDINATES, Param, Values};
use super::signatures::{MESH, TO_MESH};
use glam::DVec3;
use gusset_attributes::Origins;
use gusset_base::choice::Choice;
use gusset_base::error::{Error, Result};
use gusset_base::job::Job;
use gusset_base::{alloc, choices};
use gusset_mesh::{Mesh, MeshView, PositionBuffer};
use gusset_net::field::{Field, bend, shear, spherify, taper, twist};
use gusset_net::transform::Axis;
use std::f64::consts::PI;

/// Vertices that are moved at a time.
const CHUNK: usize = 1024;

/// Chunks between two progress reports.
const CHUNKS_PER_REPORT: usize = 64;

pub(super) const FILTER: Filter = Filter {
    id: "deform",
    name: "Deform",
    category: "Deformation",
    help: "Moves the vertices of a mesh by a deformation field: twist, taper, bend or shear about an axis, or projection towards a \
           sphere. Faces are unchanged, and coincident vertices stay coincident.",
    reference: "A. A. Deryagin, Modelling of 3D objects and scenes by tetragonal regular networks, deformation fields",
    replaces: true,
    has_origins: true,
    params: &[
        Param::choice("field", "Field", FIELDS).with_help("The deformation field."),
        Param::choice("axis", "Axis", AXES.texts).with_help("The axis of the field, through the origin."),
        Param::real("amount", "Amount", COORDINATES, &[0.1])
            .with_help("The parameter of the field; 0 leaves the mesh unchanged. The suggestion suits a twist."),
        Param::real("strength", "Strength", [0.0, 1.0], &[1.0])
            .with_help("The fraction of the deformation that is applied, from 0 to 1."),
    ],
    suggest: Some(suggest),
    ..Filter::new(MESH, TO_MESH, run)
};

const FIELDS: &[Choice] = &[
    Choice::new("Twist", "Rotates about the axis, by the amount in radians for each unit of length along it."),
    Choice::new("Taper", "Scales across the axis by 1 plus the amount for each unit of length along it."),
    Choice::new("Bend", "Bends the axis to an arc from the lowest vertex on; the amount is its curvature."),
    Choice::new("Shear", "Moves along the axis by the amount times the next coordinate."),
    Choice::new("Spherify", "Projects towards the sphere about the origin whose radius is the amount."),
];

choices! {
    /// The axis and the one that follows it.
    AXES: [Axis; 2] =
        [Axis::Z, Axis::X] => "z", "The third axis.";
        [Axis::X, Axis::Y] => "x", "The first axis.";
        [Axis::Y, Axis::Z] => "y", "The second axis.";
}

fn run(inputs: &[Input<'_>], values: &Values<'_>, job: &Job<'_>) -> Result<Vec<Output>> {
    let mesh = inputs[0].mesh()?;
    let (amount, strength) = (values.number("amount"), values.number("strength"));
    let [axis, next] = values.choice("axis", AXES);
    if amount == 0.0 {
        return Ok(vec![moved_output(copied(mesh, job)?, inputs, values, job)?]);
    }
    let field: Box<dyn Field> = match values.place("field") {
        0 => Box::new(twist(axis, amount, 0.0)?),
        1 => Box::new(taper(axis, amount, 0.0)?),
        2 => Box::new(bend(axis, amount, lowest(mesh, axis), f64::INFINITY)?),
        3 => Box::new(shear(axis, next, amount)?),
        _ => Box::new(spherify(DVec3::ZERO, amount.abs())?),
    };
    let moved = moved(mesh, field.as_ref(), strength, job)?;
    Ok(vec![moved_output(moved, inputs, values, job)?])
}

/// The amount at which a twist rotates one end of the mesh by pi / 4 against the other.
fn suggest(inputs: &[Input<'_>], defaults: &mut Defaults<'_>) {
    if let Some(extent) = extent_of(inputs) {
        defaults.set("amount", &[rounded(0.25 * PI / extent.diagonal())]);
    }
}

/// A mesh moved by a field.
///
/// # Errors
/// [`Error::FieldUndefined`], [`Error::OutOfMemory`], [`Error::Cancelled`].
pub(super) fn moved(mesh: &MeshView<'_>, field: &dyn Field, strength: f64, job: &Job<'_>) -> Result<Mesh> {
    let mut moved = copied(mesh, &job.part(0.0, 0.2))?;
    // At strength 0 the domain of the field does not matter.
    if strength > 0.0 {
        let job = job.part(0.2, 1.0);
        match &mut moved.positions {
            PositionBuffer::F32(points) => map(field, strength, points, |x| x as f32, &job)?,
            PositionBuffer::F64(points) => map(field, strength, points, |x| x, &job)?,
        }
    }
    Ok(moved)
}

/// The smallest coordinate along an axis.
fn lowest(mesh: &MeshView<'_>, axis: Axis) -> f64 {
    let positions = mesh.positions();
    let all = (0..positions.len()).map(|v| positions.get(v as u32)[axis.index()]);
    Some(all.fold(f64::INFINITY, f64::min)).filter(|low| low.is_finite()).unwrap_or(0.0)
}

/// Moves points, a chunk at a time; [`Error::FieldUndefined`] for the first that the field is not
/// defined at.
fn map<T: Copy + Into<f64>>(
    field: &dyn Field,
    strength: f64,
    points: &mut [[T; 3]],
    round: impl Fn(f64) -> T,
    job: &Job<'_>,
) -> Result<()> {
    let mut scratch = [[0.0; CHUNK]; 3];
    let chunks = points.len().div_ceil(CHUNK);
    for (number, chunk) in points.chunks_mut(CHUNK).enumerate() {
        job.step_every(CHUNKS_PER_REPORT, number, chunks, "moving vertices")?;
        let count = chunk.len();
        for (k, point) in chunk.iter().enumerate() {
            (0..3).for_each(|axis| scratch[axis][k] = point[axis].into());
        }
        let [x, y, z] = &mut scratch;
        field.map(strength, [&mut x[..count], &mut y[..count], &mut z[..count]]);
        for (k, point) in chunk.iter_mut().enumerate() {
            let moved = [0, 1, 2].map(|axis| scratch[axis][k]);
            let was_finite = point.iter().all(|&x| x.into().is_finite());
            if was_finite && !moved.iter().all(|x| x.is_finite()) {
                return Err(Error::FieldUndefined { node: (number * CHUNK + k) as u32 });
            }
            *point = moved.map(&round);
        }
    }
    Ok(())
}

/// A mesh with the faces of the first input, as an output.
pub(super) fn moved_output(mesh: Mesh, inputs: &[Input<'_>], values: &Values<'_>, job: &Job<'_>) -> Result<Output> {
    let origins = values.origins(|| {
        let meshes = alloc::try_collect(inputs.iter().map(|input| input.mesh().copied()))?;
        Origins::from_moved(&meshes, &job.part(1.0, 1.0))
    })?;
    Ok(Output::Mesh(mesh, origins))
}

/// A copy of the mesh.
fn copied(mesh: &MeshView<'_>, job: &Job<'_>) -> Result<Mesh> {
    job.step(0.0, "copying the mesh")?;
    let positions = mesh.positions();
    let mut buffer = PositionBuffer::with_capacity(positions.scalar(), positions.len())?;
    buffer.append(positions, 0..positions.len())?;
    with_positions(mesh, buffer)
}
