//! Bridges: Joins nets into one, and splits them again.

use crate::capi::context::{create_handle, guard_changing_call, gusset_context, lend};
use crate::capi::glue::{c_enum, versioned};
use crate::capi::handle;
use crate::capi::input::{self, Choice, read_choice, read_flag};
use crate::capi::net::arrange::{GUSSET_REPLICATE_REFUSE, gusset_direction, gusset_replication, to_replication};
use crate::capi::net::{gusset_net, net_of_handle, net_of_handle_mut};
use crate::capi::status::gusset_status::GUSSET_ERROR_OVERLAP;
use crate::capi::status::{Failure, gusset_status};
use crate::error::{Element, Error};
use crate::net::{BridgeKind, BridgeMode, BridgeProperties, JoinOptions, MAX_NODES, Net, concatenate_all};
use gusset_base::alloc;
use std::ptr;

/// Treatment of the cells of a bridge.
pub type gusset_bridge_mode = u32;
/// Ordinary cells.
pub const GUSSET_BRIDGE_KEEP: gusset_bridge_mode = 0;
/// Absent cells.
pub const GUSSET_BRIDGE_HIDE: gusset_bridge_mode = 1;
/// The sides, coincident within a tolerance, become one. Positions stay; see snap of
/// gusset_glue_options.
pub const GUSSET_BRIDGE_WELD: gusset_bridge_mode = 2;

/// Form of a bridge.
pub type gusset_bridge_kind = u32;
/// Band between open sides.
pub const GUSSET_BRIDGE_RIBBON: gusset_bridge_kind = 0;
/// Closed band between closed sides.
pub const GUSSET_BRIDGE_TUBE: gusset_bridge_kind = 1;
/// Edge between sides that are a point each.
pub const GUSSET_BRIDGE_THREAD: gusset_bridge_kind = 2;

/// Properties of a bridge for gusset_net_settle, in any unit of force. Lines run across it along
/// links.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_bridge_properties {
    /// Force in each line of a thread or ribbon, or per length in a tube's film; at least 0.
    pub tension: f64,
    /// Force that doubles a line's length; at least 0.
    pub elasticity: f64,
    /// Bending stiffness of each line, force x length^2; at least 0. Infinity: rigid.
    pub stiffness: f64,
    /// For the caller's use.
    pub user: u64,
}

/// Options of gusset_net_concatenate_create. Default: nets from left to right, enlarged uniformly,
/// bridges kept.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_concatenate_options {
    /// sizeof(gusset_concatenate_options).
    pub struct_size: usize,
    /// For welding: largest distance of coincident nodes.
    pub tolerance: f64,
    /// Properties of every new bridge.
    pub properties: gusset_bridge_properties,
    /// Direction from each net to the next.
    pub direction: gusset_direction,
    /// Treatment of the cells of a bridge.
    pub mode: gusset_bridge_mode,
    /// For nets with fewer nodes along the side.
    pub equalise: gusset_replication,
    /// Row or column to replicate.
    /// @when equalise GUSSET_REPLICATE_AT
    pub equalise_index: u32,
    /// Rotation of each later net along its closed side, in nodes.
    pub twist: u32,
    /// 1: flips nets along the side if oriented unlike the first; 0: refuses them.
    /// @flag
    pub turn: u32,
    /// Inner rows or columns of new bridges, even on lines; 0 for GUSSET_BRIDGE_WELD.
    pub rows: u32,
    /// 0.
    pub reserved: u32,
}

/// The cells between two joined nets.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_bridge {
    /// sizeof(gusset_bridge).
    pub struct_size: usize,
    /// Properties given.
    pub properties: gusset_bridge_properties,
    /// Direction from first to second net.
    pub direction: gusset_direction,
    /// First column (RIGHT) or row (DOWN) of the second net.
    pub at: u32,
    /// First node along the side: row (RIGHT) or column (DOWN).
    pub start: u32,
    /// One past the last node.
    pub end: u32,
    /// Form of a bridge.
    pub kind: gusset_bridge_kind,
    /// Treatment of the cells of a bridge.
    pub mode: gusset_bridge_mode,
    /// Rows (DOWN) or columns (RIGHT) between the nets, to at - 1. The first net ends at at - rows
    /// - 1.
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
            direction: read_choice(self.direction)?,
            mode: read_choice(self.mode)?,
            tolerance: self.tolerance,
            equalise: if refuse { None } else { Some(to_replication(self.equalise, self.equalise_index)?) },
            twist: self.twist,
            turn: read_flag(self.turn, "turn")?,
            properties: self.properties.into(),
            rows: self.rows,
        })
    }
}

/// Reads the nets of an array of handles.
fn nets_of_handles<'a>(handles: *const *const gusset_net, count: usize) -> Result<Vec<&'a Net<'static>>, Failure> {
    Error::check_count("nets", count as u64, MAX_NODES)?;
    let handles = handle::get_objects(handles, count, "nets")?;
    alloc::try_collect(handles.map(|handle| Ok(handle?.net())))
}

/// Joins nets side by side into one.
///
/// Nets keep gluing and bridges; links that close them along the direction become seams. Bridges
/// join consecutive nets, numbered after the second net's. gusset_net_split_create is the inverse.
///
/// @param nets at least one, of one scalar type; may repeat.
/// @errors EMPTY_SCENE (no nets), MIXED_SCALARS, ORIENTATION_CONFLICT (see turn), SIDES_DIFFER
///     (sizes with GUSSET_REPLICATE_REFUSE; welded sides apart: place, distance), OUT_OF_RANGE
///     (tolerance, twist of open sides, rows of welded bridges), CROSSING_CELL, TOO_LARGE
/// @complexity O(nodes of the result); also memory for enlarged, rotated or flipped nets.
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
    create_handle(context, joined, "joined", |job| {
        let options = input::read_versioned_struct(options, true, "options")?.checked()?;
        Ok(gusset_net::new(concatenate_all(&self::nets_of_handles(nets, net_count)?, &options, job)?))
    })
}

/// Splits a net at a bridge from side to side, and removes it.
///
/// Unless changed since, both are as before joining, bit for bit, without copies that equalised
/// sizes. Split the last bridge first. Gluing across it is lost.
///
/// @param bridge its index.
/// @errors OVERLAP (first is second), NO_SUCH_ELEMENT (also a bridge not from side to side),
///     CROSSING_CELL
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
    let slots = [
        input::cleared_output(first, ptr::null_mut(), "first"),
        input::cleared_output(second, ptr::null_mut(), "second"),
    ];
    guard_changing_call(context, |job| {
        let [first, second] = slots;
        let (first, second) = (first?, second?);
        if ptr::eq(first, second) {
            return Err(Failure::new(GUSSET_ERROR_OVERLAP, "first and second point to one place; pass two"));
        }
        let parts = net_of_handle(net)?.split(bridge, job)?.map(|part| handle::box_with_kind(gusset_net::new(part)));
        job.finish()?;
        [*first, *second] = parts.map(handle::into_handle);
        Ok(())
    })
}

/// Describes a bridge.
///
/// @param index below bridge_count.
/// @errors NO_SUCH_ELEMENT
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_net_get_bridge(
    net: *const gusset_net,
    index: usize,
    bridge: *mut gusset_bridge,
) -> gusset_status {
    lend!(net, bridge, |net| {
        let bridges = net.net().bridges();
        let no_such = Error::NoSuch { element: Element::Bridge, index: index as u64, count: bridges.len() as u64 };
        let bridge = bridges.get(index).ok_or(no_such)?;
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

/// Changes the mode and properties of a bridge.
///
/// @param index as for gusset_net_get_bridge.
/// @param tolerance as in gusset_concatenate_options.
/// @param properties NULL: the old ones.
/// @errors NO_SUCH_ELEMENT, OUT_OF_RANGE (tolerance; welding with inner rows), SIDES_DIFFER (place,
///     distance), CROSSING_CELL
/// @complexity O(nodes) if welding begins or ends or memory is shared, else O(1).
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
    guard_changing_call(context, |job| {
        let mode = read_choice(mode)?;
        let given = (!properties.is_null()).then(|| input::checked_reference(properties, "properties")).transpose()?;
        let net = net_of_handle_mut(net, job)?;
        net.set_bridge_mode(index, mode, tolerance)?;
        if let Some(&given) = given {
            net.bridges_mut()[index].properties = given.into();
        }
        Ok(())
    })
}
