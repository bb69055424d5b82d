//! Gluing of nodes: Glues and unglues nodes; the 18 local gluings.

use crate::capi::context::{guard_changing_call, gusset_context};
use crate::capi::glue::{constants, versioned};
use crate::capi::input::{self, read_flag};
use crate::capi::net::gluing::{gusset_seam, to_seam};
use crate::capi::net::{gusset_net, net_of_handle, net_of_handle_mut};
use crate::capi::status::{Failure, gusset_status};
use crate::error::Error;
use crate::net::MAX_NODES;
use crate::net::glue::{self, GlueOptions, find_gluing};
use crate::net::topology::{CellDiagonal, Gluing, GluingType};
use gusset_base::alloc;

/// Kind of a gluing. See gusset_net for indices.
pub type gusset_gluing_kind = u32;
/// The ends of link element.
pub const GUSSET_GLUING_LINK: gusset_gluing_kind = 0;
/// Node element and its neighbours in the mask: east 1, south 2, west 4, north 8. Links at sides
/// lead to the opposite ones.
pub const GUSSET_GLUING_STAR: gusset_gluing_kind = 1;
/// The ends of each link of cell element in the mask: top 1, right 2, bottom 4, left 8.
pub const GUSSET_GLUING_CELL: gusset_gluing_kind = 2;
/// Opposite corners of cell element: mask 1 for the first and third, 2 for the second and fourth.
pub const GUSSET_GLUING_DIAGONAL: gusset_gluing_kind = 3;
/// The runs of a seam.
pub const GUSSET_GLUING_SEAM: gusset_gluing_kind = 4;
/// The local gluing of type mask (GUSSET_TYPE_...) at node element, or cell element from
/// GUSSET_TYPE_TOP_BOTTOM on.
pub const GUSSET_GLUING_TYPE: gusset_gluing_kind = 5;

/// Place to glue or unglue.
#[repr(C)]
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
pub struct gusset_gluing {
    /// Kind of a gluing.
    pub kind: gusset_gluing_kind,
    /// Link, node or cell; seams: 0.
    pub element: u32,
    /// As the kind says; links and seams: 0.
    pub mask: u32,
    /// 0.
    pub reserved: u32,
    /// For GUSSET_GLUING_SEAM only.
    pub seam: gusset_seam,
}

const _: () = assert!(size_of::<gusset_gluing>() == 56);

/// Local gluing of Deryagin's figure 4. n(...) counts contracted links of a node, c(...) of a cell.
pub type gusset_gluing_type = u32;
/// Nothing is glued.
pub const GUSSET_TYPE_NONE: gusset_gluing_type = 0xffff_ffff;
/// n(1): one horizontal link.
pub const GUSSET_TYPE_HORIZONTAL: gusset_gluing_type = 0;
/// n(1): one vertical link.
pub const GUSSET_TYPE_VERTICAL: gusset_gluing_type = 1;
/// n(2,1): east and south links.
pub const GUSSET_TYPE_EAST_SOUTH: gusset_gluing_type = 2;
/// n(2,1): south and west links.
pub const GUSSET_TYPE_SOUTH_WEST: gusset_gluing_type = 3;
/// n(2,1): west and north links.
pub const GUSSET_TYPE_WEST_NORTH: gusset_gluing_type = 4;
/// n(2,1): north and east links.
pub const GUSSET_TYPE_NORTH_EAST: gusset_gluing_type = 5;
/// n(2,2): east and west links.
pub const GUSSET_TYPE_EAST_WEST: gusset_gluing_type = 6;
/// n(2,2): north and south links.
pub const GUSSET_TYPE_NORTH_SOUTH: gusset_gluing_type = 7;
/// n(3): east, south and west links.
pub const GUSSET_TYPE_BUT_NORTH: gusset_gluing_type = 8;
/// n(3): south, west and north links.
pub const GUSSET_TYPE_BUT_EAST: gusset_gluing_type = 9;
/// n(3): west, north and east links.
pub const GUSSET_TYPE_BUT_SOUTH: gusset_gluing_type = 10;
/// n(3): north, east and south links.
pub const GUSSET_TYPE_BUT_WEST: gusset_gluing_type = 11;
/// n(4): all four links.
pub const GUSSET_TYPE_ALL: gusset_gluing_type = 12;
/// c(2,1): top and bottom.
pub const GUSSET_TYPE_TOP_BOTTOM: gusset_gluing_type = 13;
/// c(2,1): right and left.
pub const GUSSET_TYPE_RIGHT_LEFT: gusset_gluing_type = 14;
/// c(3): three links, and so the fourth: all corners are one point.
pub const GUSSET_TYPE_POINT: gusset_gluing_type = 15;
/// c(1,2): first and third corner.
pub const GUSSET_TYPE_FALLING: gusset_gluing_type = 16;
/// c(1,2): second and fourth corner.
pub const GUSSET_TYPE_RISING: gusset_gluing_type = 17;

impl gusset_gluing {
    fn checked(self) -> Result<Gluing, Failure> {
        let has_mask = !matches!(self.kind, GUSSET_GLUING_LINK | GUSSET_GLUING_SEAM);
        if self.reserved != 0 || (!has_mask && self.mask != 0) {
            let (name, value) = if self.reserved != 0 { ("reserved", self.reserved) } else { ("mask", self.mask) };
            return Err(Failure::not_zero(name, value.into()));
        }
        let unknown = || Failure::unknown_value("mask", self.mask.into(), "one that the kind of gluing has");
        let mask = u8::try_from(self.mask).map_err(|_| unknown())?;
        Ok(match self.kind {
            GUSSET_GLUING_LINK => Gluing::Link(self.element),
            GUSSET_GLUING_STAR => Gluing::Star { node: self.element, mask },
            GUSSET_GLUING_CELL => Gluing::Cell { cell: self.element, mask },
            GUSSET_GLUING_DIAGONAL => {
                let diagonal =
                    [CellDiagonal::Falling, CellDiagonal::Rising].get(usize::from(mask).wrapping_sub(1)).copied();
                Gluing::CellDiagonal { cell: self.element, diagonal: diagonal.ok_or_else(unknown)? }
            }
            GUSSET_GLUING_SEAM => Gluing::Seam(to_seam(&self.seam)?),
            GUSSET_GLUING_TYPE => {
                Gluing::from_type(GluingType::from_number(self.mask).ok_or_else(unknown)?, self.element)
            }
            other => {
                return Err(Failure::unknown_choice(
                    "kind",
                    other,
                    &constants![
                        GUSSET_GLUING_LINK,
                        GUSSET_GLUING_STAR,
                        GUSSET_GLUING_CELL,
                        GUSSET_GLUING_DIAGONAL,
                        GUSSET_GLUING_SEAM,
                        GUSSET_GLUING_TYPE
                    ],
                ));
            }
        })
    }
}

/// Reads the caller's gluings, at any alignment.
fn read_gluings(data: *const gusset_gluing, count: usize) -> Result<Vec<Gluing>, Failure> {
    Error::check_count("gluings", count as u64, MAX_NODES)?;
    let given = input::input_items(data, count, "gluings")?.enumerate();
    alloc::try_collect(given.map(|(k, gluing)| gluing.checked().map_err(|failure| failure.with_item("gluings", k))))
}

/// Options of gusset_net_glue. Steps: detect, gluings, links, saturate, snap.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_glue_options {
    /// sizeof(gusset_glue_options).
    pub struct_size: usize,
    /// For detect: largest distance of coincident nodes.
    pub tolerance: f64,
    /// Gluings to add.
    /// @shape gluing_count
    pub gluings: *const gusset_gluing,
    /// Number of gluings.
    pub gluing_count: usize,
    /// Links to contract, as in gusset_net_analysis_view.
    /// @shape link_count
    pub links: *const u32,
    /// Number of links.
    pub link_count: usize,
    /// 1: replaces the gluing by the one that coordinates imply: coincident neighbours, and
    /// coincident runs of two or more side nodes in either direction. The orientation stays.
    /// @flag
    pub detect: u32,
    /// 1: contracts links with ends in one point, and drops redundant seams; detect implies it.
    /// Nets that glue equal neighbours then have equal matrices.
    /// @flag
    pub saturate: u32,
    /// 1: moves a point's nodes to its first, bit for bit.
    /// @flag
    pub snap: u32,
    /// 0.
    pub reserved: u32,
}

versioned! { gusset_glue_options: 64 reserved }

/// Glues nodes.
///
/// @param moved receives the number of moved nodes, or NULL.
/// @errors OUT_OF_RANGE (tolerance, mask above 15), NO_SUCH_ELEMENT (link, node, cell), BAD_SEAM
///     (gluing), CROSSING_CELL, TOO_LARGE
/// @complexity O(nodes + glued pairs); detect sorts side nodes. snap alone: O(rows + columns) if
///     only sides are glued.
/// @source Deryagin, "Local gluings of nodes".
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_net_glue(
    context: *const gusset_context,
    net: *mut gusset_net,
    options: *const gusset_glue_options,
    moved: *mut u64,
) -> gusset_status {
    let moved = input::cleared_optional_output(moved, 0, "moved");
    guard_changing_call(context, |job| {
        let (moved, options) = (moved?, input::read_versioned_struct(options, false, "options")?);
        let detect = read_flag(options.detect, "detect")?.then_some(options.tolerance);
        let (saturate, snap) = (read_flag(options.saturate, "saturate")?, read_flag(options.snap, "snap")?);
        let gluings = read_gluings(options.gluings, options.gluing_count)?;
        Error::check_count("links", options.link_count as u64, 2 * MAX_NODES)?;
        let links = input::copy_input_items(options.links, options.link_count, "links")?;
        let topology =
            find_gluing(net_of_handle(net)?, &GlueOptions { detect, gluings: &gluings, links: &links, saturate }, job)?;
        input::set_optional_output(moved, glue::set_gluing(net_of_handle_mut(net, job)?, topology, snap, job)?);
        Ok(())
    })
}

/// Unglues nodes: frees their links and cuts their seams.
///
/// Nodes that other gluings connect stay one point. Pairs not glued are ignored.
///
/// @param separation gap between the pieces of a point, at least 0. Each moves by half of it
///     towards the mean of its neighbours, preferably unsplit ones. Without neighbours, or at their
///     mean, it stays.
/// @param moved receives the count of moved pieces, or NULL.
/// @errors as gusset_net_glue, OUT_OF_RANGE (separation)
/// @complexity O(nodes), plus a sort of pairs.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_net_unglue(
    context: *const gusset_context,
    net: *mut gusset_net,
    gluings: *const gusset_gluing,
    count: usize,
    separation: f64,
    moved: *mut u64,
) -> gusset_status {
    let moved = input::cleared_optional_output(moved, 0, "moved");
    guard_changing_call(context, |job| {
        let (moved, gluings) = (moved?, self::read_gluings(gluings, count)?);
        input::set_optional_output(moved, net_of_handle_mut(net, job)?.unglue(&gluings, separation)? as u64);
        Ok(())
    })
}
