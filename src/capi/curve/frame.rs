//! Frames: Curves across and along a body, through a common grid of nodes.
//!
//! @source Nadopta, introduction; the correspondences are our own.

use crate::capi::context::{create, gusset_context, lend};
use crate::capi::curve::outline::{Given, gusset_outline, gusset_outlines};
use crate::capi::curve::outline_options::gusset_outline_options;
use crate::capi::glue::{c_enum, versioned};
use crate::capi::handle::Tagged;
use crate::capi::handle::{self, handle};
use crate::capi::input::{self, choice, flag, lent};
use crate::capi::mesh::{self, gusset_indices};
use crate::capi::status::{Failure, gusset_status};
use crate::curve::Options;
use crate::curve::frame::{Axis, Correspondence, Frame, FrameOptions, NodeGrid, OffsetDirection, frame, slice};
use glam::DVec3;
use gusset_base::alloc;

/// Which points of a section belong to which of the next.
pub type gusset_correspondence_rule = u32;
/// The points of the sections by their places: all sections have equally many.
pub const GUSSET_CORRESPONDENCE_GIVEN: gusset_correspondence_rule = 0;
/// Equal parts of the arc length of each section, or of the lengths between corners that all sections
/// have. Closed sections start where they are turned least against each other, wherever their first
/// points are; one that runs the other way round than the first one is taken backwards. Open sections
/// go from their first points to their last.
pub const GUSSET_CORRESPONDENCE_ARC_LENGTH: gusset_correspondence_rule = 1;
/// Where half-planes at equal angles round the axis, straight or bent, meet each section; the
/// farthest place where there are several.
pub const GUSSET_CORRESPONDENCE_ANGLE: gusset_correspondence_rule = 2;
/// Landmarks of each section, and equal parts of the arc length between them.
pub const GUSSET_CORRESPONDENCE_LANDMARKS: gusset_correspondence_rule = 3;

/// Nodes, and curves across and along a body through them. Opaque and immutable; it keeps nothing
/// of the points.
pub struct gusset_frame {
    pub(crate) grid: NodeGrid,
    pub(crate) across: Tagged<gusset_outline>,
    pub(crate) along: Tagged<gusset_outline>,
    options: Options,
    options_along: Options,
    /// Whether the sections are closed, and whether the last one is followed by the first.
    pub(crate) closed: bool,
    pub(crate) ring: bool,
}

handle! { gusset_frame }

/// Where the nodes of a frame move.
pub type gusset_offset_direction = u32;
/// Nodes move along the normals of the body.
pub const GUSSET_OFFSET_NORMAL: gusset_offset_direction = 0;
/// Nodes move within the planes of their sections.
pub const GUSSET_OFFSET_IN_SECTION: gusset_offset_direction = 1;

c_enum! { direction: OffsetDirection {
    GUSSET_OFFSET_NORMAL => Normal, GUSSET_OFFSET_IN_SECTION => InSection
} }

/// How a frame is made; all zero is the default: the points themselves are the nodes.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_frame_options {
    /// sizeof(gusset_frame_options), set by the caller.
    pub struct_size: usize,
    /// Which points of a section belong to which of the next.
    pub correspondence: gusset_correspondence_rule,
    /// The number of nodes in a section, for ARC_LENGTH and ANGLE; for LANDMARKS the number of
    /// parts from each landmark to the next.
    pub columns: u32,
    /// 1: the last section is followed by the first one. 0 or 1.
    /// @flag
    pub ring: u32,
    /// 1: closed sections start at their first points, or at the corner after the first section's; read
    /// with ARC_LENGTH. 0 or 1.
    /// @flag
    pub given_starts: u32,
    /// 1: corners that only the points' polygon has are drawn smooth. 0: a point is a corner where that
    /// turns by 40 degrees and far more than usual, or by the `corner_angle` of the curves across if
    /// that is less than pi; there they turn sharply. 0 or 1.
    /// @flag
    pub smooth_corners: u32,
    /// 0.
    pub reserved: u32,
    /// For ANGLE: a point of the axis.
    pub axis_point: [f64; 3],
    /// For ANGLE: its direction; seen against it angles grow counter-clockwise.
    pub axis_direction: [f64; 3],
    /// For ANGLE: towards the nodes of column 0; any vector not along the axis, at its first point if
    /// it is bent.
    pub reference: [f64; 3],
    /// For ANGLE about a bent axis: a point of it for each section, x, y, z; axis_point and
    /// axis_direction are not read then. The axis passes them along the circles through three of them
    /// at a time, and the reference goes along without turning about it. NULL: the axis is straight.
    pub axis_points: *const f64,
    /// The number of these points: that of the sections.
    pub axis_point_count: usize,
    /// For LANDMARKS: for each section its landmarks in order, places among its own points; as many
    /// for each.
    pub landmarks: gusset_indices,
    /// How the curves across are made; NULL for the defaults.
    pub across: *const gusset_outline_options,
    /// How the curves along are made; NULL for the defaults.
    pub along: *const gusset_outline_options,
    /// For GIVEN: points that are missing, counted over all sections, in any order. What stands in
    /// their places is not read, and may be NaN. Each is filled along the body: on the curve of
    /// Catmull and Rom through the nodes of its column before and behind it, two of each if there
    /// are as many, by the centripetal parameters of the columns next to it.
    pub missing: gusset_indices,
}

/// The nodes of a frame, row by row, and its curves. Pointers are valid until the frame is destroyed.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_frame_view {
    /// sizeof(gusset_frame_view), set by the caller.
    pub struct_size: usize,
    /// The number of sections.
    pub rows: usize,
    /// The number of nodes in a section.
    pub columns: usize,
    /// x, y, z of each node.
    pub nodes: *const f64,
    /// The direction of the curve across at each node: x, y, z, of length 1, or 0 where there is
    /// none.
    pub across: *const f64,
    /// The direction of the curve along.
    pub along: *const f64,
    /// The curves across, one for each section: node i of row k is its point k columns + i. The frame
    /// owns them.
    pub curves_across: *const gusset_outline,
    /// The curves along, one for each column: node i of row k is its point i rows + k. The frame owns
    /// them.
    pub curves_along: *const gusset_outline,
    /// For each section 1 if it was taken backwards.
    pub turned: *const u8,
    /// Nodes that could have been elsewhere, as a half-plane meets their section more than once.
    pub ambiguous: gusset_indices,
    /// Nodes at which the curve across turns sharply, ascending.
    pub corners: gusset_indices,
    /// The largest angle, in radians, by which the nodes of a closed section are turned against those
    /// of the section before it: a body that is not meant to be wrung has a small one. 0 of open ones.
    pub max_twist: f64,
    /// The largest distance between the two curves at a node, relative to the size of the nodes'
    /// box.
    pub max_gap: f64,
    /// The smallest sine of the angle at which two curves cross at a node.
    pub min_sine: f64,
    /// Nodes that were missing and are filled, ascending.
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
        let ring = flag(self.ring, "ring")?;
        let given_starts = flag(self.given_starts, "given_starts")?;
        let smooth_corners = flag(self.smooth_corners, "smooth_corners")?;
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
            other => return Err(Failure::unknown("correspondence", other.into())),
        };
        let across = input::nested(self.across, "across", gusset_outline_options::checked)?;
        let along = input::nested(self.along, "along", gusset_outline_options::checked)?;
        Ok(FrameOptions { correspondence, across, along, ring, given_starts, smooth_corners, missing })
    }
}

/// Makes the frame of some sections, closed or open, one behind another: a grid of nodes, a curve
/// across through each row of it, and a curve along through each column.
///
/// @param sections at least 2, 3 of a ring.
/// @errors as gusset_outline_create, OUT_OF_RANGE (too few sections or columns; landmarks that are
///     not as many for each section, or not in order; an axis without direction, or points of it
///     that are not as many as sections; missing points of another correspondence than GIVEN),
///     NO_SUCH_ELEMENT (a missing point), SECTIONS_DIFFER, NO_NODE (a section that a half-plane
///     does not meet, or that is no curve; with the section and the column, a missing node with
///     none before it, or none behind, in its column)
/// @complexity O(points), with ANGLE O(columns x points); with corners O(n^3) a section for n <=
///     128 of them, none are shared by sections with more.
/// @source Nadopta, introduction; the correspondences are ours.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_frame_create(
    context: *const gusset_context,
    sections: *const gusset_outlines,
    options: *const gusset_frame_options,
    frame: *mut *mut gusset_frame,
) -> gusset_status {
    create(context, frame, "frame", |job| {
        let options = input::read(options, true, "options")?;
        let landmarks = mesh::indices(&raw const options.landmarks, "landmarks")?.unwrap_or_default();
        let axis = input::list::<[f64; 3]>(options.axis_points.cast(), options.axis_point_count, "axis_points")?;
        let axis = alloc::collect(axis.into_iter().map(DVec3::from_array))?;
        let axis = if options.axis_points.is_null() { None } else { Some(axis.as_slice()) };
        let missing = mesh::indices(&raw const options.missing, "missing")?.unwrap_or_default();
        let options = options.checked(&landmarks, &missing, axis)?;
        let given = Given::read(sections)?;
        let Frame { grid, across, along } = self::frame(&given.outlines(), &options, job)?;
        let closed = given.outlines().closed;
        let (across, along) = (Tagged::part(gusset_outline(across)), Tagged::part(gusset_outline(along)));
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

/// Makes the frame beside a frame: room for comfort round a body, more in some places than in
/// others.
///
/// Each node moves by its distance: outwards, if sections are closed, inwards if it is negative; of
/// open sections along the derivative from section to section crossed with that along them, or,
/// within sections, away from the chord between their ends. Directions come from circles through
/// neighbouring nodes, so that planes, round cylinders with sections square to their axes, and
/// spheres become such, exactly. Curves are drawn through the new nodes as through the old ones. Nodes where
/// nothing tells a direction stay.
///
/// @param frame may be destroyed afterwards.
/// @param distances in the unit of the points, finite.
/// @param distance_count 1: all nodes move by the same; the number of rows: each section by its
///     own; rows x columns: each node by its own, row by row.
/// @errors COUNT_DIFFERS (distances), NOT_FINITE (the index is the distance's), as
///     gusset_frame_create (for the new nodes)
/// @complexity O(nodes), and that of the curves.
/// @source Nadopta, introduction, for the aim; the directions are ours.
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
    create(context, offset, "offset", |job| {
        let frame = handle::get(frame, "frame")?;
        let distances = input::list(distances, distance_count, "distances")?;
        let options = FrameOptions {
            across: frame.options,
            along: frame.options_along,
            ring: frame.ring,
            ..FrameOptions::new(Correspondence::Given)
        };
        let Frame { grid, across, along } =
            crate::curve::frame::offset(&frame.grid, frame.closed, &distances, choice(direction)?, &options, job)?;
        let (across, along) = (Tagged::part(gusset_outline(across)), Tagged::part(gusset_outline(along)));
        let (options, options_along, closed, ring) = (frame.options, frame.options_along, frame.closed, frame.ring);
        Ok(gusset_frame { grid, across, along, options, options_along, closed, ring })
    })
}

/// Destroys what gusset_frame_create or gusset_frame_offset_create made; NULL is allowed.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn gusset_frame_destroy(frame: *mut gusset_frame) {
    handle::destroy(frame);
}

/// Lends the nodes and the curves, valid until the frame is destroyed.
///
/// @complexity O(1).
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
            nodes: lent(&grid.nodes).cast(),
            across: lent(&grid.across).cast(),
            along: lent(&grid.along).cast(),
            curves_across: frame.across.lent(),
            curves_along: frame.along.lent(),
            turned: lent(&grid.turned),
            ambiguous: gusset_indices::lend(&grid.ambiguous),
            corners: gusset_indices::lend(&grid.corners),
            max_twist: grid.max_twist,
            max_gap: grid.max_gap,
            min_sine: grid.min_sine,
            filled: gusset_indices::lend(&grid.filled),
        }
    })
}

/// Cuts the curves along by the plane through a point across a normal, and draws a curve through
/// the crossings as the curves across were made: a new section.
///
/// @param point x, y, z.
/// @param normal x, y, z, of any length but 0.
/// @param section receives one outline, for gusset_outline_destroy; NULL on failure; point i of it
///     is on the curve along column i, at its first crossing.
/// @errors as gusset_outline_create, OUT_OF_RANGE (the normal), NOT_FINITE, NO_NODE (the value in
///     the report is the column that the plane does not cross)
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
    create(context, section, "section", |job| {
        let frame = handle::get(frame, "frame")?;
        let (point, normal) = (input::vector(point, "point")?, input::vector(normal, "normal")?);
        let cut = slice(&frame.along.0, point, normal, frame.closed, &frame.options, job)?;
        Ok(gusset_outline(cut.curve))
    })
}
