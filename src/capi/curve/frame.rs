//! Frames: Curves across and along a body, through a common grid of nodes.
//!
//! @source Nadopta.

use crate::capi::context::{create_handle, gusset_context, lend};
use crate::capi::curve::outline::{GivenOutlines, gusset_outline, gusset_outlines};
use crate::capi::curve::outline_options::gusset_outline_options;
use crate::capi::glue::{c_enum, constants, versioned};
use crate::capi::handle::TaggedObject;
use crate::capi::handle::{self, handle};
use crate::capi::input::{self, lend_list, read_choice, read_flag};
use crate::capi::mesh::{self, gusset_indices};
use crate::capi::status::{Failure, gusset_status};
use crate::curve::Options;
use crate::curve::frame::{Axis, Correspondence, Frame, FrameOptions, NodeGrid, OffsetDirection, frame, slice};
use glam::DVec3;
use gusset_base::alloc;

/// Correspondence of points between sections.
pub type gusset_correspondence_rule = u32;
/// By index; all sections have the same number of points.
pub const GUSSET_CORRESPONDENCE_GIVEN: gusset_correspondence_rule = 0;
/// Equal arc lengths of each section, or between corners. A corner of one section has a node on
/// all. Closed sections start where the twist is least, and are reversed if opposite to the
/// previous one; open ones run from first to last point.
pub const GUSSET_CORRESPONDENCE_ARC_LENGTH: gusset_correspondence_rule = 1;
/// Half-planes at equal angles round the axis; the farthest crossing of several.
pub const GUSSET_CORRESPONDENCE_ANGLE: gusset_correspondence_rule = 2;
/// Landmarks of each section, and equal arc lengths between them.
pub const GUSSET_CORRESPONDENCE_LANDMARKS: gusset_correspondence_rule = 3;

/// A grid of nodes on a body, with curves across its rows and along its columns.
pub struct gusset_frame {
    pub(crate) grid: NodeGrid,
    pub(crate) across: TaggedObject<gusset_outline>,
    pub(crate) along: TaggedObject<gusset_outline>,
    options: Options,
    options_along: Options,
    /// Whether the sections are closed, and whether the first section follows the last.
    pub(crate) closed: bool,
    pub(crate) ring: bool,
}

handle! { gusset_frame }

/// Direction in which nodes move.
pub type gusset_offset_direction = u32;
/// Along normals of the body.
pub const GUSSET_OFFSET_NORMAL: gusset_offset_direction = 0;
/// In the planes of sections.
pub const GUSSET_OFFSET_IN_SECTION: gusset_offset_direction = 1;

c_enum! { direction: OffsetDirection {
    GUSSET_OFFSET_NORMAL => Normal, GUSSET_OFFSET_IN_SECTION => InSection
} }

/// Options of gusset_frame_create. By default the points are the nodes. Fields name values of
/// `correspondence` without prefix.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_frame_options {
    /// sizeof(gusset_frame_options).
    pub struct_size: usize,
    /// Correspondence of points between sections.
    pub correspondence: gusset_correspondence_rule,
    /// ANGLE: nodes in each section. ARC_LENGTH: likewise, more if sections have more corners.
    /// LANDMARKS: parts between two landmarks.
    pub columns: u32,
    /// 1: the first section follows the last.
    /// @flag
    pub ring: u32,
    /// ARC_LENGTH. 1: closed sections start at their first points, or the corner after the first
    /// section's.
    /// @flag
    pub given_starts: u32,
    /// 1: only constraints make corners. 0: sections also have corners where they turn by more than
    /// `corner_angle` of `across`. If this is pi (not with ANGLE), corners are all points of
    /// polygons, and points that turn by 40 degrees and far more than usual. Polygons are closed
    /// sections of at most 6 points, and sections that turn by more than 54 or less than 6 degrees
    /// at points.
    /// @flag
    pub smooth_corners: u32,
    /// 0.
    pub reserved: u32,
    /// ANGLE: a point of the axis.
    pub axis_point: [f64; 3],
    /// ANGLE: direction of the axis; angles are right-handed about it.
    pub axis_direction: [f64; 3],
    /// ANGLE: direction of column 0, not parallel to the axis (at its first point if bent).
    pub reference: [f64; 3],
    /// ANGLE: a point of a bent axis for each section, in place of axis_point and axis_direction.
    /// The axis follows circles through three points each; the reference does not rotate about it.
    /// NULL: straight.
    /// @shape axis_point_count 3
    pub axis_points: *const f64,
    /// Number of sections.
    pub axis_point_count: usize,
    /// LANDMARKS: for each section the same number of indices of its points, in order.
    pub landmarks: gusset_indices,
    /// Options of the curves across.
    pub across: *const gusset_outline_options,
    /// Options of the curves along.
    pub along: *const gusset_outline_options,
    /// GIVEN: indices of missing points over all sections, in any order; their coordinates are not
    /// read. A Catmull-Rom curve through up to two nodes before and after in the column fills each,
    /// with centripetal parameters from adjacent columns.
    pub missing: gusset_indices,
}

/// Lent nodes, row by row, and curves.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_frame_view {
    /// sizeof(gusset_frame_view).
    pub struct_size: usize,
    /// Sections.
    pub rows: usize,
    /// Nodes in a section.
    pub columns: usize,
    /// Nodes.
    /// @shape rows columns 3
    pub nodes: *const f64,
    /// Unit tangents of the curves across; 0 if undefined.
    /// @shape rows columns 3
    pub across: *const f64,
    /// Unit tangents of the curves along.
    /// @shape rows columns 3
    pub along: *const f64,
    /// The frame's curve of each section. Node i of row k is its point k columns + i.
    pub curves_across: *const gusset_outline,
    /// The frame's curve of each column. Node i of row k is its point i rows + k.
    pub curves_along: *const gusset_outline,
    /// By section: 1 if it was reversed.
    /// @shape rows
    /// @flag
    pub turned: *const u8,
    /// Nodes whose half-plane meets the section several times.
    pub ambiguous: gusset_indices,
    /// Nodes that are corners of the curve across, ascending.
    pub corners: gusset_indices,
    /// Largest rotation of a closed section's nodes from the previous section; 0 for open ones.
    pub max_twist: f64,
    /// Largest distance between two curves at a node, relative to the nodes' box.
    pub max_gap: f64,
    /// Smallest sine of the angle between two curves at a node.
    pub min_sine: f64,
    /// Interpolated missing nodes, ascending.
    pub filled: gusset_indices,
}

versioned! { gusset_frame_options: 152 reserved, gusset_frame_view: 128 }

impl gusset_frame_options {
    fn checked<'a>(
        &self,
        landmarks: &'a [u32],
        missing: &'a [u32],
        axis: Option<&'a [DVec3]>,
    ) -> Result<FrameOptions<'a>, Failure> {
        let ring = read_flag(self.ring, "ring")?;
        let given_starts = read_flag(self.given_starts, "given_starts")?;
        let smooth_corners = read_flag(self.smooth_corners, "smooth_corners")?;
        let columns = self.columns as usize;
        let correspondence = match self.correspondence {
            GUSSET_CORRESPONDENCE_GIVEN => Correspondence::Given,
            GUSSET_CORRESPONDENCE_ARC_LENGTH => Correspondence::ArcLength { columns },
            GUSSET_CORRESPONDENCE_ANGLE => Correspondence::Angle {
                columns,
                axis: axis.map_or(
                    Axis::Line {
                        point: DVec3::from_array(self.axis_point),
                        direction: DVec3::from_array(self.axis_direction),
                    },
                    Axis::Points,
                ),
                reference: DVec3::from_array(self.reference),
            },
            GUSSET_CORRESPONDENCE_LANDMARKS => Correspondence::Landmarks { points: landmarks, parts: columns },
            other => {
                return Err(Failure::unknown_choice(
                    "correspondence",
                    other,
                    &constants![
                        GUSSET_CORRESPONDENCE_GIVEN,
                        GUSSET_CORRESPONDENCE_ARC_LENGTH,
                        GUSSET_CORRESPONDENCE_ANGLE,
                        GUSSET_CORRESPONDENCE_LANDMARKS
                    ],
                ));
            }
        };
        let across = input::read_nested_or_default(self.across, "across", gusset_outline_options::checked)?;
        let along = input::read_nested_or_default(self.along, "along", gusset_outline_options::checked)?;
        Ok(FrameOptions { correspondence, across, along, ring, given_starts, smooth_corners, missing })
    }
}

/// Makes the frame of consecutive sections.
///
/// A section of one point, or coincident points, is a pole: all its nodes are there.
///
/// @param sections at least 2, for a ring 3.
/// @errors as gusset_outline_create, OUT_OF_RANGE (sections, columns, landmarks, axis; missing
///     points without GIVEN), NO_SUCH_ELEMENT (missing point), SECTIONS_DIFFER, NO_NODE (section
///     and column: half-plane misses the section, no curve, or no node before or after a missing
///     one)
/// @complexity O(points), with ANGLE O(columns x points). Sections of n <= 128 corners take O(n^3);
///     with more, all are smooth.
/// @source Nadopta.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_frame_create(
    context: *const gusset_context,
    sections: *const gusset_outlines,
    options: *const gusset_frame_options,
    frame: *mut *mut gusset_frame,
) -> gusset_status {
    create_handle(context, frame, "frame", |job| {
        let options = input::read_versioned_struct(options, true, "options")?;
        let landmarks = mesh::read_indices(&raw const options.landmarks, "landmarks")?.unwrap_or_default();
        let axis =
            input::copy_input_items::<[f64; 3]>(options.axis_points.cast(), options.axis_point_count, "axis_points")?;
        let axis = alloc::collect(axis.into_iter().map(DVec3::from_array))?;
        let axis = if options.axis_points.is_null() { None } else { Some(axis.as_slice()) };
        let missing = mesh::read_indices(&raw const options.missing, "missing")?.unwrap_or_default();
        let options = options.checked(&landmarks, &missing, axis)?;
        let given = GivenOutlines::read_outlines(sections)?;
        let Frame { grid, across, along } = self::frame(&given.as_outlines(), &options, job)?;
        let closed = given.as_outlines().closed;
        let (across, along) =
            (TaggedObject::new_embedded(gusset_outline(across)), TaggedObject::new_embedded(gusset_outline(along)));
        Ok(gusset_frame {
            grid,
            across,
            along,
            options: options.across,
            options_along: options.along,
            closed,
            ring: options.ring,
        })
    })
}

/// Makes the offset of a frame.
///
/// Directions come from circles through neighbouring nodes, exact on planes, spheres, and round
/// cylinders with perpendicular sections. Curves keep their options.
///
/// Each node moves by its distance:
/// - Closed sections: outwards, or inwards if negative.
/// - Open sections: along D x d, derivatives across and within sections; GUSSET_OFFSET_IN_SECTION:
///   away from the ends' chord.
/// - Nodes without a direction stay.
///
/// @param distances lengths.
/// @param distance_count 1: for all; rows: for each section; rows x columns: for each node, row by
///     row.
/// @errors COUNT_DIFFERS (distances), NOT_FINITE (distance), as gusset_frame_create (new nodes)
/// @complexity O(nodes), plus curves.
/// @source Nadopta.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_frame_offset_create(
    context: *const gusset_context,
    frame: *const gusset_frame,
    distances: *const f64,
    distance_count: usize,
    direction: gusset_offset_direction,
    offset: *mut *mut gusset_frame,
) -> gusset_status {
    create_handle(context, offset, "offset", |job| {
        let frame = handle::get_object(frame, "frame")?;
        let distances = input::copy_input_items(distances, distance_count, "distances")?;
        let options = FrameOptions {
            across: frame.options,
            along: frame.options_along,
            ring: frame.ring,
            ..FrameOptions::new(Correspondence::Given)
        };
        let Frame { grid, across, along } =
            crate::curve::frame::offset(&frame.grid, frame.closed, &distances, read_choice(direction)?, &options, job)?;
        let (across, along) =
            (TaggedObject::new_embedded(gusset_outline(across)), TaggedObject::new_embedded(gusset_outline(along)));
        let (options, options_along, closed, ring) = (frame.options, frame.options_along, frame.closed, frame.ring);
        Ok(gusset_frame { grid, across, along, options, options_along, closed, ring })
    })
}

/// Frees a frame.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn gusset_frame_destroy(frame: *mut gusset_frame) {
    handle::destroy(frame);
}

/// Lends nodes and curves.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_frame_get_view(
    frame: *const gusset_frame,
    view: *mut gusset_frame_view,
) -> gusset_status {
    lend!(frame, view, |frame| {
        let grid = &frame.grid;
        gusset_frame_view {
            struct_size: size_of::<gusset_frame_view>(),
            rows: grid.rows,
            columns: grid.columns,
            nodes: lend_list(&grid.nodes).cast(),
            across: lend_list(&grid.across).cast(),
            along: lend_list(&grid.along).cast(),
            curves_across: frame.across.as_handle(),
            curves_along: frame.along.as_handle(),
            turned: lend_list(&grid.turned),
            ambiguous: gusset_indices::lend_indices(&grid.ambiguous),
            corners: gusset_indices::lend_indices(&grid.corners),
            max_twist: grid.max_twist,
            max_gap: grid.max_gap,
            min_sine: grid.min_sine,
            filled: gusset_indices::lend_indices(&grid.filled),
        }
    })
}

/// Cuts the curves along by a plane, and makes a section through the crossings.
///
/// It has the options of the curves across; point i is the first crossing of column i.
///
/// @param point of the plane.
/// @param normal not 0.
/// @param section receives one outline.
/// @errors as gusset_outline_create, OUT_OF_RANGE (normal), NOT_FINITE, NO_NODE (value: column not
///     crossed)
/// @complexity O(segments).
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_frame_slice_create(
    context: *const gusset_context,
    frame: *const gusset_frame,
    point: *const f64,
    normal: *const f64,
    section: *mut *mut gusset_outline,
) -> gusset_status {
    create_handle(context, section, "section", |job| {
        let frame = handle::get_object(frame, "frame")?;
        let (point, normal) = (input::read_vector(point, "point")?, input::read_vector(normal, "normal")?);
        let cut = slice(&frame.along.0, point, normal, frame.closed, &frame.options, job)?;
        Ok(gusset_outline(cut.curve))
    })
}
