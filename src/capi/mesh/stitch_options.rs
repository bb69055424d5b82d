//! Options of stitching: Choice, subdivision and fairing of strips.

use crate::capi::glue::{c_enum, constants, versioned};
use crate::capi::input::read_choice;
use crate::capi::status::Failure;
use crate::repair::orient::Outward;
use crate::stitch::facing::{Arc, Centres, Run};
use crate::stitch::{
    Cells, Extent, Fairing, Finish, Intersections, MeridianSearch, Meridians, Options, Orientation, Rows, Start,
};

/// Rule for the meridians. A meridian is a strip's edge from rim A to rim B. INDEX, ARC_LENGTH and
/// GREEDY take O(N + M). If ARC_LENGTH or GREEDY would repeat an edge, MIN_DIAGONAL applies.
pub type gusset_meridians = u32;
/// Triangle strip that best continues both surfaces. It bends little, above all along the rims, and
/// follows their tangent planes. The default search stays near the strip of least area;
/// gusset_strip makes that.
pub const GUSSET_MERIDIANS_CONTINUATION: gusset_meridians = 0;
/// Vertices paired in proportion to their indices; suits evenly spaced rims.
pub const GUSSET_MERIDIANS_INDEX: gusset_meridians = 1;
/// Vertices paired in proportion to arc length.
pub const GUSSET_MERIDIANS_ARC_LENGTH: gusset_meridians = 2;
/// Always the shorter of the two next meridians.
pub const GUSSET_MERIDIANS_GREEDY: gusset_meridians = 3;
/// Triangle strip of least total meridian length.
pub const GUSSET_MERIDIANS_MIN_DIAGONAL: gusset_meridians = 4;
/// Triangle strip of least bend: the sum, over its edges and rims, of length * (1 - cos(angle
/// between normals)).
pub const GUSSET_MERIDIANS_SMOOTH: gusset_meridians = 5;
/// Least sum of squared meridian lengths (dynamic time warping): quads where both rims advance,
/// else triangles. Suits interior rows.
pub const GUSSET_MERIDIANS_QUAD: gusset_meridians = 6;
/// Triangle strip of least area through the first meridian.
pub const GUSSET_MERIDIANS_MIN_AREA: gusset_meridians = 7;

/// Search effort.
pub type gusset_strip_search = u32;
/// Exact up to 2^21 vertex pairs. Beyond, coarse to fine in nearly linear time and linear memory,
/// usually within 0.1 % of the optimum.
pub const GUSSET_SEARCH_AUTO: gusset_strip_search = 0;
/// Exact, in O(N M) time; gusset_stitch states the memory.
pub const GUSSET_SEARCH_EXACT: gusset_strip_search = 1;

/// First meridian of a closed strip; open ones start at their first points.
pub type gusset_strip_start = u32;
/// The better strip from the closest pair of vertices, before or after rotating rim B along rim A
/// to the best fit.
pub const GUSSET_START_AUTO: gusset_strip_start = 0;
/// The closest pair of vertices.
pub const GUSSET_START_CLOSEST: gusset_strip_start = 1;

/// The first points; gusset_strip only.
pub const GUSSET_START_GIVEN: gusset_strip_start = 2;

/// Positions of new vertices.
pub type gusset_fairing = u32;
/// New vertices divide the meridians of a strip evenly, or lie on the first triangulation of a
/// patch.
pub const GUSSET_FAIRING_NONE: gusset_fairing = 0;
/// A thin plate that meets the old surface smoothly: least sum of squared Laplacians over new
/// vertices and rims. Rims and ends of open strips stay fixed.
pub const GUSSET_FAIRING_THIN_PLATE: gusset_fairing = 1;

/// Treatment of intersecting faces.
pub type gusset_intersections = u32;
/// Finds intersections of the strip, and reduces them:
/// - With GUSSET_MERIDIANS_CONTINUATION, a triangle strip without rows is rerouted; the best one is
///   kept. If the mean meridian is longer than a radius, GUSSET_MERIDIANS_SMOOTH competes by fewer
///   intersections, or as many and much smaller bends. Rows use this strip's meridians if the gap
///   is so wide, or they would intersect.
/// - Faired rows move back locally, at most 12 times. Straight rows that intersect less win.
/// - Blends move back likewise, then get less fairing. The best blend is kept, or a strip that
///   intersects less.
pub const GUSSET_INTERSECTIONS_AUTO: gusset_intersections = 0;
/// No search: rows are faired in full, and the first blend is kept.
pub const GUSSET_INTERSECTIONS_IGNORE: gusset_intersections = 1;
/// As GUSSET_INTERSECTIONS_AUTO, but no strip is rerouted.
pub const GUSSET_INTERSECTIONS_REPORT: gusset_intersections = 2;

/// Treatment of opposite orientations.
pub type gusset_orientation = u32;
/// Reverses the component of rim B if it is oriented against rim A, whichever is inside out;
/// nothing within one component. Whole rims are compared as curves. If both face one way, the sides
/// of their surfaces decide. An inconclusive comparison reverses nothing.
pub const GUSSET_ORIENTATION_FIX: gusset_orientation = 0;
/// Opposite orientations return GUSSET_ERROR_ORIENTATION_CONFLICT.
pub const GUSSET_ORIENTATION_REFUSE: gusset_orientation = 1;
/// Orientations are not compared.
pub const GUSSET_ORIENTATION_KEEP: gusset_orientation = 2;

/// Part of the loops to join.
pub type gusset_stitch_extent = u32;
/// Whole loops, by a closed band.
pub const GUSSET_EXTENT_WHOLE_LOOPS: gusset_stitch_extent = 0;
/// Runs of facing vertices, as in gusset_facing_create; may return GUSSET_ERROR_PLANES_UNDECIDED.
pub const GUSSET_EXTENT_OPEN_ARCS: gusset_stitch_extent = 1;
/// Whole loops if their normals make less than 60 degrees with the line of centres (mean of
/// cosines), or the planes are undecided. Else open arcs.
pub const GUSSET_EXTENT_AUTO: gusset_stitch_extent = 2;
/// The arcs arc_a and arc_b. Loops not given are indexed as by gusset_boundary_get_loop.
pub const GUSSET_EXTENT_ARCS: gusset_stitch_extent = 3;

/// Choice among runs of facing vertices.
pub type gusset_facing_run = u32;
/// On each loop the run with the closest pair.
pub const GUSSET_RUN_CLOSEST: gusset_facing_run = 0;
/// On each loop the run with the most vertices; of equal runs the first.
pub const GUSSET_RUN_LONGEST: gusset_facing_run = 1;

/// Centre of a loop.
pub type gusset_centres = u32;
/// Mean of the vertices.
pub const GUSSET_CENTRES_VERTICES: gusset_centres = 0;
/// Mean along the curve, independent of vertex spacing.
pub const GUSSET_CENTRES_LENGTH: gusset_centres = 1;

/// Number of interior rows.
pub type gusset_row_rule = u32;
/// 0: each meridian is one edge.
pub const GUSSET_ROWS_NONE: gusset_row_rule = 0;
/// max(0, round(mean meridian length / mean edge length of both sides) - 1). At most about 50,000
/// new vertices, or 16 rows if more; the log says if so limited.
pub const GUSSET_ROWS_MEAN_EDGE: gusset_row_rule = 1;
/// row_count.
pub const GUSSET_ROWS_COUNT: gusset_row_rule = 2;

/// Faces of the strip.
pub type gusset_strip_cells = u32;
/// Triangles; quads are split by their shorter diagonals.
pub const GUSSET_CELLS_TRIANGLES: gusset_strip_cells = 0;
/// Quads, and triangles where a rim repeats a vertex.
pub const GUSSET_CELLS_QUADS: gusset_strip_cells = 1;

/// Surface between the rims, or in a hole.
pub type gusset_finish = u32;
/// Strip of meridians, with interior rows. In a hole: the patch that other options describe.
pub const GUSSET_FINISH_STRIP: gusset_finish = 0;
/// Smooth joint, tangent to both pieces, which looks best. Triangles are about as fine as along the
/// rims, graded between, without sharp angles where the rims allow. Two tubes are joined by a tube,
/// within some per cent of the radius across a few radii. Across wider gaps than a radius it bends
/// as an arc between the axes. Meridians and matrix describe the strip, not edges of the result.
/// Ignores rows, cells, fairing and refine. In a hole: a faired patch as dense as its surroundings.
/// In a join, for strips and holes.
/// - Not for machined parts and flat walls, which it rounds. For CAD tolerances, printing or
///   volumes alone, a strip has far fewer faces.
///
/// The strip is kept if every blend intersects more, or exceeds about 50,000 new vertices, or 16 a
/// rim vertex if more. Edges up to twice as long keep to that limit.
pub const GUSSET_FINISH_BLEND: gusset_finish = 1;

/// Source of the tolerance.
pub type gusset_tolerance_mode = u32;
/// Uses the rounding error of the coordinates. For facing vertices: at most 2^-16 (32-bit) or 2^-45
/// (64-bit) times the loops' largest coordinate. For welding, see gusset_weld_options.
pub const GUSSET_TOLERANCE_AUTO: gusset_tolerance_mode = 0;
/// Uses the given tolerance.
pub const GUSSET_TOLERANCE_GIVEN: gusset_tolerance_mode = 1;
/// Uses tolerance 0; welding then requires equal positions.
pub const GUSSET_TOLERANCE_EXACT: gusset_tolerance_mode = 2;

/// Side that closed components face.
pub type gusset_outward = u32;
/// GUSSET_OUTWARD_CLOSED in gusset_join, else GUSSET_OUTWARD_KEEP.
pub const GUSSET_OUTWARD_AUTO: gusset_outward = 0;
/// Closed components stay unchanged; gusset_orient chooses the original side of most faces.
pub const GUSSET_OUTWARD_KEEP: gusset_outward = 1;
/// Closed components face outwards, and walls of cavities into the cavities. An odd number of
/// closed components enclose the wall of a cavity. Components that cross, or touch in more than
/// vertices and edges, do not enclose each other. If the volume is 0 up to rounding,
/// GUSSET_OUTWARD_KEEP applies. Except in gusset_orient, only components with two faces at every
/// edge and consistent orientation are reversed.
pub const GUSSET_OUTWARD_CLOSED: gusset_outward = 2;

/// Options of gusset_stitch.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_stitch_options {
    /// sizeof(gusset_stitch_options).
    pub struct_size: usize,
    /// Rule for the meridians.
    pub meridians: gusset_meridians,
    /// Treatment of opposite orientations.
    pub orientation: gusset_orientation,
    /// Vertices to shift the first meridian along rim B, in the direction of rim A, modulo rim B.
    /// The shift begins at the closest pair that no edge joins. If not 0, no other start is tried.
    /// 0 for arcs (OUT_OF_RANGE).
    pub twist: i64,
    /// Part of the loops to join.
    pub extent: gusset_stitch_extent,
    /// Choice among runs of facing vertices.
    pub run: gusset_facing_run,
    /// Number of interior rows.
    pub rows: gusset_row_rule,
    /// Interior rows.
    /// @when rows GUSSET_ROWS_COUNT
    pub row_count: u32,
    /// Faces of the strip.
    pub cells: gusset_strip_cells,
    /// Source of the tolerance.
    pub tolerance_mode: gusset_tolerance_mode,
    /// Facing vertices are farther than this from their loop's plane.
    /// @when tolerance_mode GUSSET_TOLERANCE_GIVEN
    pub tolerance: f64,
    /// First index on loop A as given, and number of vertices, 1 to the loop's length; may pass its
    /// end.
    /// @when extent GUSSET_EXTENT_ARCS
    pub arc_a: [u32; 2],
    /// As arc_a, for loop B.
    /// @when extent GUSSET_EXTENT_ARCS
    pub arc_b: [u32; 2],
    /// Search effort.
    pub search: gusset_strip_search,
    /// First meridian of a closed strip; open ones start at their first points.
    pub start: gusset_strip_start,
    /// Positions of new vertices; ignored without rows.
    pub fairing: gusset_fairing,
    /// Treatment of intersecting faces.
    pub intersections: gusset_intersections,
    /// Centre of a loop.
    pub centres: gusset_centres,
    /// Side that closed components face.
    pub outward: gusset_outward,
    /// Surface between the rims, or in a hole.
    pub finish: gusset_finish,
    /// 0.
    pub reserved: u32,
}

versioned! { gusset_stitch_options: 72 reserved }

c_enum! {
    meridians: Meridians {
        GUSSET_MERIDIANS_CONTINUATION => Continuation,
        GUSSET_MERIDIANS_INDEX => Index,
        GUSSET_MERIDIANS_ARC_LENGTH => ArcLength,
        GUSSET_MERIDIANS_GREEDY => Greedy,
        GUSSET_MERIDIANS_MIN_DIAGONAL => MinDiagonal,
        GUSSET_MERIDIANS_SMOOTH => Smooth,
        GUSSET_MERIDIANS_QUAD => Quad,
        GUSSET_MERIDIANS_MIN_AREA => MinArea,
    }
    search: MeridianSearch { GUSSET_SEARCH_AUTO => Auto, GUSSET_SEARCH_EXACT => Exact }
    start: Start { GUSSET_START_AUTO => Auto, GUSSET_START_CLOSEST => Closest }
    orientation: Orientation { GUSSET_ORIENTATION_FIX => Fix, GUSSET_ORIENTATION_REFUSE => Refuse, GUSSET_ORIENTATION_KEEP => Keep }
    run: Run { GUSSET_RUN_CLOSEST => Closest, GUSSET_RUN_LONGEST => Longest }
    centres: Centres { GUSSET_CENTRES_VERTICES => Vertices, GUSSET_CENTRES_LENGTH => Length }
    cells: Cells { GUSSET_CELLS_TRIANGLES => Triangles, GUSSET_CELLS_QUADS => Quads }
    fairing: Fairing { GUSSET_FAIRING_NONE => None, GUSSET_FAIRING_THIN_PLATE => ThinPlate }
    finish: Finish { GUSSET_FINISH_STRIP => Strip, GUSSET_FINISH_BLEND => Blend }
    intersections: Intersections {
        GUSSET_INTERSECTIONS_AUTO => Auto,
        GUSSET_INTERSECTIONS_IGNORE => Ignore,
        GUSSET_INTERSECTIONS_REPORT => Report,
    }
}

impl gusset_stitch_options {
    pub(crate) fn checked(self) -> Result<Options, Failure> {
        let extent = match self.extent {
            GUSSET_EXTENT_WHOLE_LOOPS => Extent::WholeLoops,
            GUSSET_EXTENT_OPEN_ARCS => Extent::OpenArcs,
            GUSSET_EXTENT_AUTO => Extent::Auto,
            GUSSET_EXTENT_ARCS => Extent::Arcs(
                [self.arc_a, self.arc_b].map(|[first, count]| Arc { first: first as usize, count: count as usize }),
            ),
            other => {
                return Err(Failure::unknown_choice(
                    "extent",
                    other,
                    &constants![
                        GUSSET_EXTENT_WHOLE_LOOPS,
                        GUSSET_EXTENT_OPEN_ARCS,
                        GUSSET_EXTENT_AUTO,
                        GUSSET_EXTENT_ARCS
                    ],
                ));
            }
        };
        let rows = to_rows(self.rows, self.row_count)?;
        Ok(Options {
            meridians: read_choice(self.meridians)?,
            search: read_choice(self.search)?,
            start: read_choice(self.start)?,
            orientation: read_choice(self.orientation)?,
            twist: self.twist,
            extent,
            run: read_choice(self.run)?,
            tolerance: to_tolerance(self.tolerance_mode, self.tolerance)?,
            centres: read_choice(self.centres)?,
            rows,
            cells: read_choice(self.cells)?,
            fairing: read_choice(self.fairing)?,
            finish: read_choice(self.finish)?,
            intersections: read_choice(self.intersections)?,
            outward: to_outward(self.outward, Outward::Keep)?,
        })
    }
}

/// Returns the orientation of closed components, `default` if the caller leaves it open.
pub(crate) fn to_outward(given: gusset_outward, default: Outward) -> Result<Outward, Failure> {
    match given {
        GUSSET_OUTWARD_AUTO => Ok(default),
        GUSSET_OUTWARD_KEEP => Ok(Outward::Keep),
        GUSSET_OUTWARD_CLOSED => Ok(Outward::Closed),
        other => Err(Failure::unknown_choice(
            "outward",
            other,
            &constants![GUSSET_OUTWARD_AUTO, GUSSET_OUTWARD_KEEP, GUSSET_OUTWARD_CLOSED],
        )),
    }
}

/// Returns the inner rows for a mode.
pub(crate) fn to_rows(mode: u32, count: u32) -> Result<Rows, Failure> {
    match mode {
        GUSSET_ROWS_NONE => Ok(Rows::None),
        GUSSET_ROWS_MEAN_EDGE => Ok(Rows::MeanEdge),
        GUSSET_ROWS_COUNT => Ok(Rows::Count(count)),
        other => Err(Failure::unknown_choice(
            "rows",
            other,
            &constants![GUSSET_ROWS_NONE, GUSSET_ROWS_MEAN_EDGE, GUSSET_ROWS_COUNT],
        )),
    }
}

/// Returns the tolerance for a mode, if one is given.
pub(crate) fn to_tolerance(mode: u32, given: f64) -> Result<Option<f64>, Failure> {
    match mode {
        GUSSET_TOLERANCE_AUTO => Ok(None),
        GUSSET_TOLERANCE_GIVEN => Ok(Some(given)),
        GUSSET_TOLERANCE_EXACT => Ok(Some(0.0)),
        other => Err(Failure::unknown_choice(
            "tolerance_mode",
            other,
            &constants![GUSSET_TOLERANCE_AUTO, GUSSET_TOLERANCE_GIVEN, GUSSET_TOLERANCE_EXACT],
        )),
    }
}
