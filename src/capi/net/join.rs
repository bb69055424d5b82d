//! Bridges: Joins nets to one, and takes them apart again.

use crate::capi::context::{create, guard_change, gusset_context, lend};
use crate::capi::glue::{c_enum, versioned};
use crate::capi::handle;
use crate::capi::input::{self, Choice, choice, flag};
use crate::capi::net::arrange::{GUSSET_REPLICATE_REFUSE, gusset_direction, gusset_replication, replication};
use crate::capi::net::{edit, gusset_net, read};
use crate::capi::status::gusset_status::GUSSET_ERROR_OVERLAP;
use crate::capi::status::{Failure, gusset_status};
use crate::error::{Element, Error};
use crate::net::{BridgeKind, BridgeMode, BridgeProperties, JoinOptions, MAX_NODES, Net, concatenate_all};
use gusset_base::alloc;
use std::ptr;

/// What is done with the cells between two nets that were joined.
pub type gusset_bridge_mode = u32;
/// They are cells like others.
pub const GUSSET_BRIDGE_KEEP: gusset_bridge_mode = 0;
/// They are not there.
pub const GUSSET_BRIDGE_HIDE: gusset_bridge_mode = 1;
/// The two sides coincide, to a tolerance, and are one: the links between them are contracted.
/// Nodes stay where they are; where they coincide not quite, `snap` of gusset_glue_options makes
/// them equal.
pub const GUSSET_BRIDGE_WELD: gusset_bridge_mode = 2;

/// What a bridge looks like.
pub type gusset_bridge_kind = u32;
/// A band between open sides.
pub const GUSSET_BRIDGE_RIBBON: gusset_bridge_kind = 0;
/// A band between closed sides, which is closed itself.
pub const GUSSET_BRIDGE_TUBE: gusset_bridge_kind = 1;
/// One edge between sides that are a point each.
pub const GUSSET_BRIDGE_THREAD: gusset_bridge_kind = 2;

/// The physical properties of a bridge, under which gusset_net_settle finds its equilibrium. Units:
/// of length that of the coordinates, of force any one that all have.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_bridge_properties {
    /// At least 0: the force in each line of links across a thread or a ribbon, and the force per
    /// length in the film of a tube.
    pub tension: f64,
    /// At least 0: the force that doubles the length of a line of links across.
    pub elasticity: f64,
    /// At least 0, against bending: force times squared length, for each line of links across;
    /// infinity: rigid.
    pub stiffness: f64,
    /// The host's own.
    pub user: u64,
}

/// How nets are joined. All zeros: each right of the one before, the smaller ones enlarged
/// uniformly, bridges kept.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_concatenate_options {
    /// sizeof(gusset_concatenate_options), set by the caller.
    pub struct_size: usize,
    /// How far nodes that are welded may be apart, at least 0, in the unit of the coordinates.
    pub tolerance: f64,
    /// Given to every new bridge.
    pub properties: gusset_bridge_properties,
    /// Where each net lies from the one before.
    pub direction: gusset_direction,
    /// GUSSET_BRIDGE_KEEP, GUSSET_BRIDGE_HIDE or GUSSET_BRIDGE_WELD.
    pub mode: gusset_bridge_mode,
    /// How nets with fewer nodes along the side are enlarged.
    pub equalise: gusset_replication,
    /// Read for GUSSET_REPLICATE_AT: the row or column.
    /// @when equalise GUSSET_REPLICATE_AT
    pub equalise_index: u32,
    /// Each net but the first is turned by so many places along its side, which is closed then.
    pub twist: u32,
    /// 1: nets whose faces are taken the other way round than those of the first are flipped along
    /// the side; 0: refused.
    /// @flag
    pub turn: u32,
    /// How many rows or columns of nodes of its own each new bridge has, evenly on straight lines
    /// between the two sides; 0 for GUSSET_BRIDGE_WELD.
    pub rows: u32,
    /// 0.
    pub reserved: u32,
}

/// A bridge of a net.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_bridge {
    /// sizeof(gusset_bridge), set by the caller.
    pub struct_size: usize,
    /// What the host gave it.
    pub properties: gusset_bridge_properties,
    /// Where the second net lies.
    pub direction: gusset_direction,
    /// The first column (RIGHT) or row (DOWN) of the second net.
    pub at: u32,
    /// The first node along the side: a row (RIGHT) or column (DOWN).
    pub start: u32,
    /// One past the last one.
    pub end: u32,
    /// GUSSET_BRIDGE_RIBBON, GUSSET_BRIDGE_TUBE or GUSSET_BRIDGE_THREAD.
    pub kind: gusset_bridge_kind,
    /// GUSSET_BRIDGE_KEEP, GUSSET_BRIDGE_HIDE or GUSSET_BRIDGE_WELD.
    pub mode: gusset_bridge_mode,
    /// The rows (DOWN) or columns of its own, which lie before `at`: the side of the first net is
    /// at - rows - 1.
    pub rows: u32,
    /// 0.
    pub reserved: u32,
}

versioned! { gusset_concatenate_options: 72 reserved, gusset_bridge: 64 }

impl From<gusset_bridge_properties> for BridgeProperties {
    fn from(given: gusset_bridge_properties) -> Self {
        let gusset_bridge_properties { tension, elasticity, stiffness, user } = given;
        BridgeProperties { tension, elasticity, stiffness, user }
    }
}

c_enum! {
    mode: BridgeMode { GUSSET_BRIDGE_KEEP => Keep, GUSSET_BRIDGE_HIDE => Hide, GUSSET_BRIDGE_WELD => Weld }
    kind: BridgeKind { GUSSET_BRIDGE_RIBBON => Ribbon, GUSSET_BRIDGE_TUBE => Tube, GUSSET_BRIDGE_THREAD => Thread }
}

impl gusset_concatenate_options {
    pub(crate) fn checked(self) -> Result<JoinOptions, Failure> {
        let refuse = self.equalise == GUSSET_REPLICATE_REFUSE;
        Ok(JoinOptions {
            direction: choice(self.direction)?,
            mode: choice(self.mode)?,
            tolerance: self.tolerance,
            equalise: if refuse { None } else { Some(replication(self.equalise, self.equalise_index)?) },
            twist: self.twist,
            turn: flag(self.turn, "turn")?,
            properties: self.properties.into(),
            rows: self.rows,
        })
    }
}

/// The nets of an array of handles.
fn nets<'a>(handles: *const *const gusset_net, count: usize) -> Result<Vec<&'a Net<'static>>, Failure> {
    Error::check_count("nets", count as u64, MAX_NODES)?;
    let handles = handle::list(handles, count, "net")?;
    alloc::try_collect(handles.map(|handle| Ok(handle?.net())))
}

/// Joins nets side by side to one, in one pass.
///
/// Each net keeps what it is glued to: links that led back across the direction become seams. Its
/// bridges are kept; each net but the first gets a new one, between it and the one before, behind
/// its own. All can be undone: see gusset_net_split_create.
///
/// @param nets net_count handles, at least one, of one scalar type; the same one may come several
///     times.
/// @param net_count see nets.
/// @errors EMPTY_SCENE (no nets), MIXED_SCALARS, ORIENTATION_CONFLICT (see turn), SIDES_DIFFER
///     (sizes that are not to be equalised; or sides to be welded that are apart: the report has
///     the place and the distance), OUT_OF_RANGE (tolerance; a twist of an open side; rows of
///     bridges that are to be welded), CROSSING_CELL, TOO_LARGE
/// @complexity O(nodes of the result); memory for it, and once more for nets that are enlarged,
///     turned or flipped.
/// @source Deryagin, "Concatenation".
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_net_concatenate_create(
    context: *const gusset_context,
    nets: *const *const gusset_net,
    net_count: usize,
    options: *const gusset_concatenate_options,
    joined: *mut *mut gusset_net,
) -> gusset_status {
    create(context, joined, "joined", |job| {
        let options = input::read(options, true, "options")?.checked()?;
        Ok(gusset_net::new(concatenate_all(&self::nets(nets, net_count)?, &options, job)?))
    })
}

/// Takes a net apart at a bridge that runs from side to side: the two nets come back bit for bit as
/// they were joined, unless they were changed since; copies that were made to equalise sizes, and
/// the rows of the bridge, are removed.
///
/// Of a net that was joined of joined ones, the last bridge is such a one; take nets apart in the
/// reverse order of joining. What is glued across the bridge is cut.
///
/// @param bridge its number, counted from 0.
/// @param second receives the other, likewise.
/// @errors OVERLAP (first and second are the same place), NO_SUCH_ELEMENT (no such bridge, or it is
///     within a part of the net only), CROSSING_CELL
/// @complexity O(nodes).
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_net_split_create(
    context: *const gusset_context,
    net: *const gusset_net,
    bridge: usize,
    first: *mut *mut gusset_net,
    second: *mut *mut gusset_net,
) -> gusset_status {
    let slots = [input::output(first, ptr::null_mut(), "first"), input::output(second, ptr::null_mut(), "second")];
    guard_change(context, |job| {
        let [first, second] = slots;
        let (first, second) = (first?, second?);
        if ptr::eq(first, second) {
            return Err(Failure::new(GUSSET_ERROR_OVERLAP, "first and second are the same place"));
        }
        let parts = read(net)?.split(bridge, job)?.map(|part| handle::boxed(gusset_net::new(part)));
        job.memory()?;
        [*first, *second] = parts.map(handle::give);
        Ok(())
    })
}

/// A bridge of a net.
///
/// @param index its number, below bridge_count of gusset_net_gluing_report.
/// @param bridge its struct_size set.
/// @errors NO_SUCH_ELEMENT
/// @complexity O(1).
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_net_get_bridge(
    net: *const gusset_net,
    index: usize,
    bridge: *mut gusset_bridge,
) -> gusset_status {
    lend!(net, bridge, |net| {
        let no_such = Error::NoSuch { element: Element::Bridge, index: index as u64 };
        let bridge = net.net().bridges().get(index).ok_or(no_such)?;
        let BridgeProperties { tension, elasticity, stiffness, user } = bridge.properties;
        gusset_bridge {
            struct_size: 0,
            properties: gusset_bridge_properties { tension, elasticity, stiffness, user },
            direction: bridge.direction.number(),
            at: bridge.at,
            start: bridge.start,
            end: bridge.end,
            kind: bridge.kind.number(),
            mode: bridge.mode.number(),
            rows: bridge.rows,
            reserved: 0,
        }
    })
}

/// Does something else with the cells of a bridge, and gives it other properties. A bridge that has
/// rows of its own cannot be welded: OUT_OF_RANGE.
///
/// @param index of the bridge, below bridge_count of gusset_net_gluing_report.
/// @param mode GUSSET_BRIDGE_KEEP, GUSSET_BRIDGE_HIDE or GUSSET_BRIDGE_WELD.
/// @param tolerance how far nodes that are welded may be apart, at least 0.
/// @param properties NULL leaves them.
/// @errors NO_SUCH_ELEMENT, OUT_OF_RANGE, SIDES_DIFFER (with the place and the distance),
///     CROSSING_CELL (the net is then as it was)
/// @complexity O(nodes) if welding begins or ends, or if the net is shared with a copy or a scene;
///     else O(1).
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_net_set_bridge(
    context: *const gusset_context,
    net: *mut gusset_net,
    index: usize,
    mode: gusset_bridge_mode,
    tolerance: f64,
    properties: *const gusset_bridge_properties,
) -> gusset_status {
    guard_change(context, |job| {
        let mode = choice(mode)?;
        let given = (!properties.is_null()).then(|| input::reference(properties, "properties")).transpose()?;
        let net = edit(net, job)?;
        net.set_bridge_mode(index, mode, tolerance)?;
        if let Some(&given) = given {
            net.bridges_mut()[index].properties = given.into();
        }
        Ok(())
    })
}
