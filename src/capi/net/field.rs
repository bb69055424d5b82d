//! Fields: Deforms and projects nets by chains of fields.

use crate::capi::context::{guard_changing_call, gusset_context};
use crate::capi::glue::{c_enum, constants, versioned};
use crate::capi::input::{self, read_choice};
use crate::capi::net::transform::{affine_from_numbers, first_three_numbers, gusset_axis};
use crate::capi::net::{gusset_net, net_of_handle_mut};
use crate::capi::status::{Failure, gusset_status};
use crate::error::Error;
use crate::mesh::MAX_ELEMENTS;
use crate::net::field::*;
use glam::DVec3;
use gusset_base::alloc;

/// Kind of a deformation field. It tells the values.
///
/// - t is the strength: from 0, no change, to 1, the whole map.
/// - w is the coordinate on axis; u and v follow in the cycle x, y, z.
/// - Linear in t: points move by t times their displacement.
pub type gusset_field_kind = u32;
/// Affine map, linear in t: three rows of four numbers. The net's reversed flag stays.
pub const GUSSET_FIELD_AFFINE: gusset_field_kind = 1;
/// Right-handed rotation about axis by the angle t values[0] (w - values[1]).
pub const GUSSET_FIELD_TWIST: gusset_field_kind = 2;
/// Scaling of u and v by 1 + t values[0] (w - values[1]).
pub const GUSSET_FIELD_TAPER: gusset_field_kind = 3;
/// Bends axis from w = values[1] to values[2] (maybe infinite) into an arc of curvature t values[0]
/// towards u. Straight beyond.
pub const GUSSET_FIELD_BEND: gusset_field_kind = 4;
/// Adds t values[0] times the coordinate on other_axis to w.
pub const GUSSET_FIELD_SHEAR: gusset_field_kind = 5;
/// Central projection onto the sphere of centre values[0..2], radius values[3] > 0; linear in t.
/// Undefined at the centre.
pub const GUSSET_FIELD_SPHERIFY: gusset_field_kind = 6;
/// Rolls space around a cylinder of radius r = values[0] > 0: u and v become (r + v) sin(u/r) and
/// (r + v) cos(u/r). For t < 1, the curvature is t/r. Lengths in the sheet v = 0 stay.
pub const GUSSET_FIELD_CYLINDER_WRAP: gusset_field_kind = 7;
/// Rolls space into a torus about axis: radius R = values[0] > 0, tube radius r = values[1] > 0.
/// Then u, v, w are the arcs around axis and tube, and the height above the torus.
///
/// - t <= 1/2: a sheet rolls into a straight tube of curvature 2t/r; lengths stay.
/// - t > 1/2: the tube bends to curvature (2t - 1) / R; its circles keep their lengths.
pub const GUSSET_FIELD_TORUS_WRAP: gusset_field_kind = 8;
/// Free-form deformation of the box from values[0..2] to values[3..5] by tensor-product Bernstein
/// polynomials, linear in t. Points outside stay. Offsets displace a uniform grid of 2 to 32
/// control points along each axis, x fastest, then y.
pub const GUSSET_FIELD_LATTICE: gusset_field_kind = 9;
/// Projective map by a 4 x 4 matrix, row by row; linear in t. Undefined where the fourth
/// homogeneous coordinate is 0.
pub const GUSSET_FIELD_PROJECTION: gusset_field_kind = 10;
/// Parallel projection onto the plane through values[0..2] with normal values[3..5], along
/// values[6..8]; linear in t.
pub const GUSSET_FIELD_PARALLEL: gusset_field_kind = 11;
/// Central projection from the eye values[0..2] onto the plane through values[3..5] with normal
/// values[6..8]; linear in t. Undefined in the parallel plane through the eye.
pub const GUSSET_FIELD_PERSPECTIVE: gusset_field_kind = 12;
/// Rolls space into a cone about axis, whose circle w = 0 has radius r = values[0] > 0. Then u, v,
/// w are the arc of this circle, the height above the cone, and the length along generators. These
/// lean towards axis by a = values[1], -pi/2 to pi/2; the apex is at w = r / sin(a).
///
/// For t < 1, generators lean by t a; the curvature is t/r. Generators keep their lengths; the
/// circle at w becomes 1 - (t/r) w sin(t a) times as long.
pub const GUSSET_FIELD_CONE_WRAP: gusset_field_kind = 13;
/// Rolls space into a sphere about axis, of radius r = values[0] > 0. Then u, v, w are the arcs of
/// equator and meridian, and the height above the sphere, which 0 <= u <= 2 pi r and |v| <= pi r /
/// 2 cover.
///
/// - t <= 1/2: a sheet rolls into a tube of curvature 2t/r; lengths stay.
/// - t > 1/2: meridians bend to curvature q/r, q = 2t - 1, and keep their lengths. The parallel at
///   v becomes 1 - (1 - cos(q v/r)) / q times as long.
pub const GUSSET_FIELD_SPHERE_WRAP: gusset_field_kind = 14;

/// Interpolation of strengths between two keys.
pub type gusset_easing = u32;
/// Linear in time.
pub const GUSSET_EASING_LINEAR: gusset_easing = 0;
/// Smoothstep, at rest at both keys.
pub const GUSSET_EASING_SMOOTH: gusset_easing = 1;
/// Constant until the next key.
pub const GUSSET_EASING_HOLD: gusset_easing = 2;

/// Deformation field.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_field {
    /// sizeof(gusset_field), equal throughout an array.
    pub struct_size: usize,
    /// Kind of a deformation field.
    pub kind: gusset_field_kind,
    /// For kinds that name it; else 0.
    pub axis: gusset_axis,
    /// GUSSET_FIELD_SHEAR: another axis. Else 0.
    pub other_axis: gusset_axis,
    /// Interpolation of strengths between two keys.
    pub easing: gusset_easing,
    /// Strength t, times the keys'.
    pub strength: f64,
    /// As the kind says; the rest is not read.
    pub values: [f64; 16],
    /// Pairs of time and strength, by increasing time; constant before the first and after the
    /// last. NULL: constant.
    pub keys: *const f64,
    /// Number of pairs.
    pub key_count: usize,
    /// GUSSET_FIELD_LATTICE: three numbers a control point. Else NULL.
    pub offsets: *const f64,
    /// GUSSET_FIELD_LATTICE: control points along x, y and z. Else 0.
    pub counts: [u32; 3],
    /// 0.
    pub reserved: u32,
}

versioned! { gusset_field: 200 reserved }

/// A field of the caller, and its current strength.
pub(crate) struct GivenField {
    field: Box<dyn Field>,
    strength: f64,
}

impl GivenField {
    pub(crate) fn to_step(&self) -> DeformationStep<'_> {
        DeformationStep { field: &*self.field, strength: self.strength }
    }
}

/// Reads the caller's fields at a time.
pub(crate) fn read_fields(fields: *const gusset_field, count: usize, time: f64) -> Result<Vec<GivenField>, Failure> {
    Error::check_count("fields", count as u64, MAX_ELEMENTS)?;
    let given = |field: *const gusset_field| {
        let given = input::read_versioned_struct(field, false, "fields")?;
        let (field, strength) = (given.checked()?, given.strength_at(time)?);
        Error::require(strength.is_finite(), "strength", strength, "finite")?;
        Ok(GivenField { field, strength })
    };
    let fields = input::struct_pointers(fields, count, "fields")?.enumerate();
    alloc::try_collect(
        fields.map(|(k, field)| field.and_then(given).map_err(|failure: Failure| failure.with_item("fields", k))),
    )
}

/// Reads groups of N numbers, at any alignment.
fn read_number_groups<const N: usize>(
    data: *const f64,
    count: usize,
    name: &'static str,
) -> Result<Vec<[f64; N]>, Failure> {
    input::copy_input_items(data.cast(), count, name)
}

c_enum! { easing: Easing { GUSSET_EASING_LINEAR => Linear, GUSSET_EASING_SMOOTH => Smooth, GUSSET_EASING_HOLD => Hold } }

impl gusset_field {
    fn checked(&self) -> Result<Box<dyn Field>, Failure> {
        let (v, about) = (&self.values, || read_choice(self.axis));
        Ok(match self.kind {
            GUSSET_FIELD_AFFINE => Box::new(affine_from_numbers(v)?),
            GUSSET_FIELD_TWIST => Box::new(twist(about()?, v[0], v[1])?),
            GUSSET_FIELD_TAPER => Box::new(taper(about()?, v[0], v[1])?),
            GUSSET_FIELD_BEND => Box::new(bend(about()?, v[0], v[1], v[2])?),
            GUSSET_FIELD_SHEAR => Box::new(shear(about()?, read_choice(self.other_axis)?, v[0])?),
            GUSSET_FIELD_SPHERIFY => Box::new(spherify(first_three_numbers(v), v[3])?),
            GUSSET_FIELD_CYLINDER_WRAP => Box::new(cylinder_wrap(about()?, v[0])?),
            GUSSET_FIELD_TORUS_WRAP => Box::new(torus_wrap(about()?, v[0], v[1])?),
            GUSSET_FIELD_CONE_WRAP => Box::new(cone_wrap(about()?, v[0], v[1])?),
            GUSSET_FIELD_SPHERE_WRAP => Box::new(sphere_wrap(about()?, v[0])?),
            GUSSET_FIELD_LATTICE => Box::new(self.read_lattice()?),
            GUSSET_FIELD_PROJECTION => {
                Box::new(projection([0, 4, 8, 12].map(|k| [v[k], v[k + 1], v[k + 2], v[k + 3]]))?)
            }
            GUSSET_FIELD_PARALLEL => Box::new(parallel_projection(
                first_three_numbers(v),
                first_three_numbers(&v[3..]),
                first_three_numbers(&v[6..]),
            )?),
            GUSSET_FIELD_PERSPECTIVE => Box::new(perspective_projection(
                first_three_numbers(v),
                first_three_numbers(&v[3..]),
                first_three_numbers(&v[6..]),
            )?),
            other => {
                return Err(Failure::unknown_choice(
                    "kind",
                    other,
                    &constants![
                        GUSSET_FIELD_AFFINE,
                        GUSSET_FIELD_TWIST,
                        GUSSET_FIELD_TAPER,
                        GUSSET_FIELD_BEND,
                        GUSSET_FIELD_SHEAR,
                        GUSSET_FIELD_SPHERIFY,
                        GUSSET_FIELD_CYLINDER_WRAP,
                        GUSSET_FIELD_TORUS_WRAP,
                        GUSSET_FIELD_CONE_WRAP,
                        GUSSET_FIELD_SPHERE_WRAP,
                        GUSSET_FIELD_LATTICE,
                        GUSSET_FIELD_PROJECTION,
                        GUSSET_FIELD_PARALLEL,
                        GUSSET_FIELD_PERSPECTIVE
                    ],
                ));
            }
        })
    }

    fn read_lattice(&self) -> Result<Lattice, Failure> {
        let counts = self.counts.map(|count| count as usize);
        let (low, high) = (first_three_numbers(&self.values), first_three_numbers(&self.values[3..]));
        // Counts that will be rejected do not tell how much there is to read.
        let good = counts.iter().all(|count| (2..=Lattice::MAX_POINTS).contains(count));
        let count = if good { counts.iter().product() } else { 0 };
        let offsets: Vec<[f64; 3]> = read_number_groups(self.offsets, count, "offsets")?;
        Ok(Lattice::new(low, high, counts, &alloc::collect(offsets.into_iter().map(DVec3::from_array))?)?)
    }

    fn strength_at(&self, time: f64) -> Result<f64, Failure> {
        if self.keys.is_null() && self.key_count == 0 {
            return Ok(self.strength);
        }
        let keys = read_number_groups(self.keys, self.key_count, "keys")?;
        if !time.is_finite() {
            return Err(Error::OptionOutOfRange { option: "time", value: time, allowed: "finite".into() }.into());
        }
        Ok(self.strength * TimedStrength::new(&keys, read_choice(self.easing)?)?.strength_at(time))
    }
}

/// Moves a net by fields, in the given order.
///
/// - For other maps, use gusset_net_edit, then snap of gusset_glue_options.
/// - Computation is in doubles, rounded once.
/// - Strength 0 changes no bit.
/// - Equal bits of glued nodes stay equal, and missing nodes missing.
/// - A node that overflows becomes missing if all fields are defined everywhere.
///
/// @param time time of keys. To animate, deform copies of the net at rest.
/// @errors OUT_OF_RANGE (value, strength, time), FIELD_UNDEFINED (node where a partly undefined
///     chain is undefined or overflows)
/// @complexity O(nodes x fields), twice if a field is partly undefined.
/// @source Deryagin, "Spatial operations"; Barr 1984; Sederberg, Parry 1986.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_net_deform(
    context: *const gusset_context,
    net: *mut gusset_net,
    fields: *const gusset_field,
    count: usize,
    time: f64,
) -> gusset_status {
    guard_changing_call(context, |job| {
        let given = self::read_fields(fields, count, time)?;
        let steps = alloc::collect(given.iter().map(GivenField::to_step))?;
        Ok(deform(net_of_handle_mut(net, job)?, &steps, job)?)
    })
}

/// Moves nodes along their normals. Glued nodes stay together; nodes without a normal stay.
///
/// @param distance of either sign.
/// @errors OUT_OF_RANGE (distance), FIELD_UNDEFINED (first node to overflow)
/// @complexity O(nodes); memory as the coordinates.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_net_displace(
    context: *const gusset_context,
    net: *mut gusset_net,
    distance: f64,
) -> gusset_status {
    guard_changing_call(context, |job| Ok(displace_along_normals(net_of_handle_mut(net, job)?, distance, job)?))
}
