//! Fields: Deforms and projects nets by chains of fields, fixed or in time.

use crate::capi::context::{guard_change, gusset_context};
use crate::capi::glue::{c_enum, versioned};
use crate::capi::input::{self, choice};
use crate::capi::net::transform::{gusset_axis, matrix, vector};
use crate::capi::net::{edit, gusset_net};
use crate::capi::status::{Failure, gusset_status};
use crate::error::Error;
use crate::mesh::MAX_ELEMENTS;
use crate::net::field::*;
use glam::DVec3;
use gusset_base::alloc;

/// What a field does, and what its values are. An axis and those that follow it: y and z after x, z
/// and x after y, x and y after z.
pub type gusset_field_kind = u32;
/// An affine map: values[0] to values[11], three rows of four. In part: that part of the straight
/// way. Unlike gusset_net_transform it leaves the net's flag `reversed` alone where it mirrors.
pub const GUSSET_FIELD_AFFINE: gusset_field_kind = 1;
/// Turns about `axis`, by the right hand, by values[0] radians for each unit along it from the
/// coordinate values[1] on. In part: by that part of the angle.
pub const GUSSET_FIELD_TWIST: gusset_field_kind = 2;
/// Distances from `axis` grow by values[0] times themselves for each unit along it from the
/// coordinate values[1] on. In part: at that part of the rate.
pub const GUSSET_FIELD_TAPER: gusset_field_kind = 3;
/// Bends `axis` from its coordinate values[1] to values[2] (only the latter may be infinite) to an
/// arc of the curvature values[0], towards the axis that follows; what lies beyond goes on
/// straight. In part: with that part of the curvature.
pub const GUSSET_FIELD_BEND: gusset_field_kind = 4;
/// The coordinate on `axis` grows by values[0] times that on `other_axis`. In part: at that part of
/// the rate.
pub const GUSSET_FIELD_SHEAR: gusset_field_kind = 5;
/// Moves points onto the sphere with the centre values[0] to values[2] and the radius values[3] >
/// 0, straight from its centre, where it is not defined. In part: that part of the way.
pub const GUSSET_FIELD_SPHERIFY: gusset_field_kind = 6;
/// Rolls space up about `axis`: of the two axes that follow, the first becomes the arc and the
/// second the height above a cylinder of the radius r = values[0] > 0: with the first u and the
/// second v they become (r + v) sin(u / r) and (r + v) cos(u / r). In part, t: rolled to the
/// curvature t / r, so that a sheet of height 0 keeps all its lengths.
pub const GUSSET_FIELD_CYLINDER_WRAP: gusset_field_kind = 7;
/// Rolls space up to a torus about `axis` with the radii values[0] > 0 (to the middle of the tube)
/// and values[1] > 0 (of the tube): of the two axes that follow, the first goes round the axis and
/// the second round the tube; the axis itself becomes the height above the torus. In part, t: up to
/// 1/2 the sheet rolls to a straight tube, to the curvature 2 t / values[1], and keeps all its
/// lengths; then the tube bends to the curvature (2 t - 1) / values[0] of its middle, and the circles
/// round it keep their lengths.
pub const GUSSET_FIELD_TORUS_WRAP: gusset_field_kind = 8;
/// Free-form deformation: the box from values[0..2] to values[3..5] has counts[0] x counts[1] x
/// counts[2] control points, 2 to 32 each way; offsets: how far each is moved, x, y, z, from its
/// place in the even grid, x running first, then y. Outside the box nothing moves. In part: that
/// part of the way.
pub const GUSSET_FIELD_LATTICE: gusset_field_kind = 9;
/// A map of homogeneous coordinates: four rows of four. Not defined where the fourth coordinate
/// becomes 0. In part: that part of the straight way, as for the other projections.
pub const GUSSET_FIELD_PROJECTION: gusset_field_kind = 10;
/// Onto the plane through values[0..2] with the normal values[3..5], along the direction
/// values[6..8].
pub const GUSSET_FIELD_PARALLEL: gusset_field_kind = 11;
/// Onto the plane through values[3..5] with the normal values[6..8], along the lines through the
/// eye values[0..2]. Not defined level with the eye.
pub const GUSSET_FIELD_PERSPECTIVE: gusset_field_kind = 12;
/// Rolls space up to a cone about `axis`: of the two axes that follow, the first becomes the arc of
/// the circle of the radius r = values[0] > 0 and the second the height above the cone; the axis
/// itself, w, becomes the length along the generators, which lean towards the axis by values[1],
/// from -pi / 2 to pi / 2: the apex is at w = r / sin(values[1]). In part, t: leaning by t values[1]
/// and rolled to the curvature t / r; generators keep their lengths, and the circle at w becomes
/// 1 - (t / r) w sin(t values[1]) times as long.
pub const GUSSET_FIELD_CONE_WRAP: gusset_field_kind = 13;
/// Rolls space up to a sphere about `axis` of the radius r = values[0] > 0: of the two axes that
/// follow, the first, from 0 to 2 pi r, goes round the equator, and the second, from -pi / 2 r to
/// pi / 2 r, along the meridians; the axis itself becomes the height above the sphere. In part, t: up
/// to 1/2 the sheet rolls to a tube, to the curvature 2 t / r, and keeps all its lengths; then the
/// meridians bend to the curvature q / r, q = 2 t - 1, and keep their lengths, and the parallel at v
/// becomes 1 - (1 - cos(q v / r)) / q times as long.
pub const GUSSET_FIELD_SPHERE_WRAP: gusset_field_kind = 14;

/// How a strength goes from one key to the next.
pub type gusset_easing = u32;
/// Evenly.
pub const GUSSET_EASING_LINEAR: gusset_easing = 0;
/// Starting and ending at rest.
pub const GUSSET_EASING_SMOOTH: gusset_easing = 1;
/// Stays until it jumps.
pub const GUSSET_EASING_HOLD: gusset_easing = 2;

/// A field of deformation: a map of space, of which a part is done.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_field {
    /// sizeof(gusset_field), set by the caller; in an array the same for all.
    pub struct_size: usize,
    /// What a field does, and what its values are. An axis and those that follow it: y and
    /// z after x, z and x after y, x and y after z.
    pub kind: gusset_field_kind,
    /// For kinds that have one; else 0.
    pub axis: gusset_axis,
    /// For GUSSET_FIELD_SHEAR; else 0.
    pub other_axis: gusset_axis,
    /// Between keys; one of GUSSET_EASING_...
    pub easing: gusset_easing,
    /// How much of the map is done: 0 nothing at all, 1 all of it. With keys, it multiplies what
    /// they say.
    pub strength: f64,
    /// What the kind says; the rest is not read.
    pub values: [f64; 16],
    /// Pairs of time and strength, times increasing; before the first and after the last time the
    /// strength is that there. NULL: the strength does not depend on the time.
    pub keys: *const f64,
    /// The number of pairs.
    pub key_count: usize,
    /// For GUSSET_FIELD_LATTICE, three numbers for each control point; else NULL.
    pub offsets: *const f64,
    /// For GUSSET_FIELD_LATTICE; else 0.
    pub counts: [u32; 3],
    /// 0.
    pub reserved: u32,
}

versioned! { gusset_field: 200 reserved }

/// A field of the caller's, and how much of it is done now.
pub(crate) struct Given {
    field: Box<dyn Field>,
    strength: f64,
}

impl Given {
    pub(crate) fn step(&self) -> Step<'_> {
        Step { field: &*self.field, strength: self.strength }
    }
}

/// The fields of the caller's at a time.
pub(crate) fn fields(fields: *const gusset_field, count: usize, time: f64) -> Result<Vec<Given>, Failure> {
    Error::check_count("fields", count as u64, MAX_ELEMENTS)?;
    let given = |field: *const gusset_field| {
        let given = input::read(field, false, "fields")?;
        let (field, strength) = (given.checked()?, given.strength_at(time)?);
        Error::require(strength.is_finite(), "strength", strength)?;
        Ok(Given { field, strength })
    };
    let fields = input::structs(fields, count, "fields")?.enumerate();
    alloc::try_collect(fields.map(|(k, field)| field.and_then(given).map_err(|failure: Failure| failure.of_item(k))))
}

/// Groups of N numbers of the caller's, at any alignment.
fn groups<const N: usize>(data: *const f64, count: usize, name: &'static str) -> Result<Vec<[f64; N]>, Failure> {
    input::list(data.cast(), count, name)
}

c_enum! { easing: Easing { GUSSET_EASING_LINEAR => Linear, GUSSET_EASING_SMOOTH => Smooth, GUSSET_EASING_HOLD => Hold } }

impl gusset_field {
    fn checked(&self) -> Result<Box<dyn Field>, Failure> {
        let (v, about) = (&self.values, || choice(self.axis));
        Ok(match self.kind {
            GUSSET_FIELD_AFFINE => Box::new(matrix(v)?),
            GUSSET_FIELD_TWIST => Box::new(twist(about()?, v[0], v[1])?),
            GUSSET_FIELD_TAPER => Box::new(taper(about()?, v[0], v[1])?),
            GUSSET_FIELD_BEND => Box::new(bend(about()?, v[0], v[1], v[2])?),
            GUSSET_FIELD_SHEAR => Box::new(shear(about()?, choice(self.other_axis)?, v[0])?),
            GUSSET_FIELD_SPHERIFY => Box::new(spherify(vector(v), v[3])?),
            GUSSET_FIELD_CYLINDER_WRAP => Box::new(cylinder_wrap(about()?, v[0])?),
            GUSSET_FIELD_TORUS_WRAP => Box::new(torus_wrap(about()?, v[0], v[1])?),
            GUSSET_FIELD_CONE_WRAP => Box::new(cone_wrap(about()?, v[0], v[1])?),
            GUSSET_FIELD_SPHERE_WRAP => Box::new(sphere_wrap(about()?, v[0])?),
            GUSSET_FIELD_LATTICE => Box::new(self.lattice()?),
            GUSSET_FIELD_PROJECTION => {
                Box::new(projection([0, 4, 8, 12].map(|k| [v[k], v[k + 1], v[k + 2], v[k + 3]]))?)
            }
            GUSSET_FIELD_PARALLEL => Box::new(parallel_projection(vector(v), vector(&v[3..]), vector(&v[6..]))?),
            GUSSET_FIELD_PERSPECTIVE => Box::new(perspective_projection(vector(v), vector(&v[3..]), vector(&v[6..]))?),
            other => return Err(Failure::unknown("kind", other.into())),
        })
    }

    fn lattice(&self) -> Result<Lattice, Failure> {
        let counts = self.counts.map(|count| count as usize);
        let (low, high) = (vector(&self.values), vector(&self.values[3..]));
        // Counts that will be refused say nothing of how much there is to read.
        let good = counts.iter().all(|count| (2..=Lattice::MAX_POINTS).contains(count));
        let count = if good { counts.iter().product() } else { 0 };
        let offsets: Vec<[f64; 3]> = groups(self.offsets, count, "offsets")?;
        Ok(Lattice::new(low, high, counts, &alloc::collect(offsets.into_iter().map(DVec3::from_array))?)?)
    }

    fn strength_at(&self, time: f64) -> Result<f64, Failure> {
        if self.keys.is_null() && self.key_count == 0 {
            return Ok(self.strength);
        }
        let keys = groups(self.keys, self.key_count, "keys")?;
        if !time.is_finite() {
            return Err(Error::OptionOutOfRange { option: "time", value: time }.into());
        }
        Ok(self.strength * Timed::new(&keys, choice(self.easing)?)?.strength(time))
    }
}

/// Moves all nodes of a net by fields, the first one first, in one pass over the memory: shaping,
/// animation and projection.
///
/// The fields work in double; the result is rounded once. Fields of strength 0 do nothing at all,
/// to the bit. Nodes that are glued and have equal bits keep them equal; missing nodes stay
/// missing. Fields that are defined everywhere are not watched for overflow: a node that they make
/// too large for its type is infinite then, and missing. Whatever the error, no node is moved.
///
/// @param fields `count` of them.
/// @param count see fields.
/// @param time for fields with keys; a net is deformed from what it is now, so that animations
///     deform a copy of the net at rest.
/// @errors UNKNOWN_VALUE (kind, axis, easing), OUT_OF_RANGE (a value, strength or time),
///     FIELD_UNDEFINED (with the node)
/// @complexity O(nodes x fields), twice that if a field is not defined everywhere.
/// @threads The same bits for any number of threads.
/// @source Deryagin, "Spatial operations"; Barr 1984; Sederberg and Parry 1986.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_net_deform(
    context: *const gusset_context,
    net: *mut gusset_net,
    fields: *const gusset_field,
    count: usize,
    time: f64,
) -> gusset_status {
    guard_change(context, |job| {
        let given = self::fields(fields, count, time)?;
        let steps = alloc::collect(given.iter().map(Given::step))?;
        Ok(deform(edit(net, job)?, &steps, job)?)
    })
}

/// Moves every node of a net along its normal by `distance`, which may be negative; glued nodes
/// stay together, nodes without a normal stay.
///
/// @param distance a length of either sign, finite.
/// @errors OUT_OF_RANGE (distance)
/// @complexity O(nodes), and as much memory as the coordinates take.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_net_displace(
    context: *const gusset_context,
    net: *mut gusset_net,
    distance: f64,
) -> gusset_status {
    guard_change(context, |job| Ok(displace(edit(net, job)?, distance, job)?))
}
