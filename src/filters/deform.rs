//! The filter `deform`.

use super::Filter;
use super::data::{Input, InputKind, Output, OutputKind, with_positions};
use super::extent::{extent_of, put, rounded};
use super::param::{Choice, Param, ParamKind, Values};
use crate::error::{Error, Result};
use crate::job::Job;
use crate::mesh::{Mesh, MeshView, PositionBuffer};
use crate::net::field::{Bend, Field, Shear, Spherify, Taper, Twist};
use crate::net::transform::Axis;
use glam::DVec3;
use std::f64::consts::PI;

/// Vertices that are moved at a time.
const PIECE: usize = 1024;

/// Pieces between two chances to cancel.
const PIECES: usize = 64;

pub(super) const FILTER: Filter = Filter {
    id: "deform",
    name: "Deform",
    script_name: "deform",
    category: "Nets",
    help: "Moves the vertices of a mesh by a field of deformation: twists it round an axis, tapers, bends or shears it, or draws it \
           towards a sphere. Faces stay what they are, and vertices that lie together move together.",
    reference: "A. A. Deryagin, Modelling of 3D objects and scenes by tetragonal regular networks, deformation fields",
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
    Param::choice(
        "field",
        "Field",
        "What is done to space.",
        &[
            Choice {
                label: "Twist",
                help: "Turns round the axis, the amount in radians for each unit of length along it.",
            },
            Choice {
                label: "Taper",
                help: "Scales across the axis by 1 and the amount for each unit of length along it.",
            },
            Choice {
                label: "Bend",
                help: "Bends the axis to an arc from the lowest vertex on; the amount is its curvature.",
            },
            Choice { label: "Shear", help: "Moves along the axis by the amount times the next coordinate." },
            Choice { label: "Spherify", help: "Draws towards the sphere round the origin whose radius is the amount." },
        ],
    ),
    Param::choice(
        "axis",
        "Axis",
        "The axis of the field, through the origin.",
        &[
            Choice { label: "z", help: "The third one." },
            Choice { label: "x", help: "The first one." },
            Choice { label: "y", help: "The second one." },
        ],
    ),
    Param {
        id: "amount",
        label: "Amount",
        help: "How much; what it means depends on the field, and 0 leaves all as it is. Suggested is what suits a twist.",
        kind: ParamKind::Real,
        min: -1e15,
        max: 1e15,
        default: &[0.1],
        step: 0.0,
        choices: &[],
    },
    Param {
        id: "strength",
        label: "Strength",
        help: "The part of the deformation that is done, from none to all of it.",
        kind: ParamKind::Real,
        min: 0.0,
        max: 1.0,
        default: &[1.0],
        step: 0.0,
        choices: &[],
    },
];

fn run(inputs: &[Input<'_>], values: &Values<'_>, job: &Job<'_>) -> Result<Vec<Output>> {
    let mesh = inputs[0].mesh()?;
    let (amount, strength) = (values.number("amount"), values.number("strength"));
    let axis = [Axis::Z, Axis::X, Axis::Y][values.chosen("axis")];
    let next = [Axis::X, Axis::Y, Axis::Z][values.chosen("axis")];
    if amount == 0.0 {
        return Ok(vec![Output::Mesh(copied(mesh, job)?)]);
    }
    let field: Box<dyn Field> = match values.chosen("field") {
        0 => Box::new(Twist::new(axis, amount, 0.0)?),
        1 => Box::new(Taper::new(axis, amount, 0.0)?),
        2 => Box::new(Bend::new(axis, amount, lowest(mesh, axis), f64::INFINITY)?),
        3 => Box::new(Shear::new(axis, next, amount)?),
        _ => Box::new(Spherify::new(DVec3::ZERO, amount.abs())?),
    };
    Ok(vec![Output::Mesh(moved(mesh, field.as_ref(), strength, job)?)])
}

/// The amount that turns the mesh by half a right angle from end to end, if it is twisted.
fn suggest(inputs: &[Input<'_>], values: &mut [f64]) {
    if let Some(extent) = extent_of(inputs) {
        put(PARAMS, values, "amount", &[rounded(0.25 * PI / extent.diagonal())]);
    }
}

/// A mesh moved by a field.
///
/// # Errors
/// [`Error::FieldUndefined`], [`Error::OutOfMemory`], [`Error::Cancelled`].
pub(super) fn moved(mesh: &MeshView<'_>, field: &dyn Field, strength: f64, job: &Job<'_>) -> Result<Mesh> {
    let mut moved = copied(mesh, &job.part(0.0, 0.2))?;
    // In no part at all, not even undefined places matter.
    if strength > 0.0 {
        let job = job.part(0.2, 1.0);
        match &mut moved.positions {
            PositionBuffer::F32(points) => map(field, strength, points, |x| x as f32, &job)?,
            PositionBuffer::F64(points) => map(field, strength, points, |x| x, &job)?,
        }
    }
    Ok(moved)
}

/// The least coordinate along an axis.
fn lowest(mesh: &MeshView<'_>, axis: Axis) -> f64 {
    let along = |point: DVec3| match axis {
        Axis::X => point.x,
        Axis::Y => point.y,
        Axis::Z => point.z,
    };
    let positions = mesh.positions();
    let all = (0..positions.len()).map(|v| along(positions.get(v as u32)));
    Some(all.fold(f64::INFINITY, f64::min)).filter(|low| low.is_finite()).unwrap_or(0.0)
}

/// Moves points, a piece at a time; [`Error::FieldUndefined`] for the first that the field is not
/// defined at.
fn map<T: Copy + Into<f64>>(
    field: &dyn Field,
    strength: f64,
    points: &mut [[T; 3]],
    round: impl Fn(f64) -> T,
    job: &Job<'_>,
) -> Result<()> {
    let mut scratch = [[0.0; PIECE]; 3];
    let pieces = points.len().div_ceil(PIECE);
    for (number, piece) in points.chunks_mut(PIECE).enumerate() {
        if number % PIECES == 0 {
            job.step(number as f64 / pieces as f64, "moving vertices")?;
        }
        let count = piece.len();
        for (k, point) in piece.iter().enumerate() {
            (0..3).for_each(|axis| scratch[axis][k] = point[axis].into());
        }
        let [x, y, z] = &mut scratch;
        field.map(strength, [&mut x[..count], &mut y[..count], &mut z[..count]]);
        for (k, point) in piece.iter_mut().enumerate() {
            let moved = [0, 1, 2].map(|axis| scratch[axis][k]);
            let was_finite = point.iter().all(|&x| x.into().is_finite());
            if was_finite && !moved.iter().all(|x| x.is_finite()) {
                return Err(Error::FieldUndefined { node: (number * PIECE + k) as u32 });
            }
            *point = moved.map(&round);
        }
    }
    Ok(())
}

/// The mesh as it is.
fn copied(mesh: &MeshView<'_>, job: &Job<'_>) -> Result<Mesh> {
    job.step(0.0, "copying the mesh")?;
    let positions = mesh.positions();
    let mut buffer = PositionBuffer::with_capacity(positions.scalar(), positions.len())?;
    buffer.append(positions)?;
    with_positions(mesh, buffer)
}
