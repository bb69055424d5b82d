//! Options of stitching: How a strip is chosen, subdivided and smoothed.

use crate::capi::glue::{c_enum, versioned};
use crate::capi::input::choice;
use crate::capi::status::Failure;
use crate::repair::orient::Outward;
use crate::stitch::facing::{Arc, Centres, Run};
use crate::stitch::{
    Cells, Extent, Fairing, Finish, Intersections, Meridians, Options, Orientation, Rows, Search, Start,
};

/// The rule that chooses meridians.
pub type gusset_meridians = u32;
/// The strip of triangles that best continues both surfaces, near the strip of least area: little
/// turn between neighbours, along the rims above all, and meridians that lie on the surface which
/// the faces beside the rims suggest. Between lines without faces (gusset_strip) the strip
/// of least area.
pub const GUSSET_MERIDIANS_CONTINUATION: gusset_meridians = 0;
/// The paper's rule by index, O(N + M): good for evenly spaced rims.
pub const GUSSET_MERIDIANS_INDEX: gusset_meridians = 1;
/// Both rims walked at the same pace, by arc length, O(N + M).
pub const GUSSET_MERIDIANS_ARC_LENGTH: gusset_meridians = 2;
/// Always on to the shorter of the two next meridians, O(N + M).
pub const GUSSET_MERIDIANS_GREEDY: gusset_meridians = 3;
/// The strip of triangles whose meridians have the least total length.
pub const GUSSET_MERIDIANS_MIN_DIAGONAL: gusset_meridians = 4;
/// The strip of triangles with the least bends: the sum over its edges, rims included, of length
/// times (1 - cos of the angle between the normals).
pub const GUSSET_MERIDIANS_SMOOTH: gusset_meridians = 5;
/// The least sum of the meridians' squared lengths where steps on both rims at once are allowed
/// (dynamic time warping): quads where both sides advance, triangles elsewhere. Meant for strips
/// with interior rows.
pub const GUSSET_MERIDIANS_QUAD: gusset_meridians = 6;
/// The strip of triangles of least area through the first meridian.
pub const GUSSET_MERIDIANS_MIN_AREA: gusset_meridians = 7;

/// The effort of the search for the best strip.
pub type gusset_strip_search = u32;
/// The best meridians are found exactly for up to 2^21 pairs of vertices, beyond that coarse to
/// fine: nearly linear time, linear memory, and a result within a few hundredths of a per cent of
/// the best on all rims that were measured.
pub const GUSSET_SEARCH_AUTO: gusset_strip_search = 0;
/// Exactly: O(N M) time, and memory for each pair of vertices; see gusset_stitch.
pub const GUSSET_SEARCH_EXACT: gusset_strip_search = 1;

/// The first meridian of a closed strip.
pub type gusset_strip_start = u32;
/// The first meridian of a closed band joins the closest pair of vertices, or the closest pair
/// after rim B has been turned along rim A to where it fits best; the better strip of the two is
/// kept.
pub const GUSSET_START_AUTO: gusset_strip_start = 0;
/// The closest pair.
pub const GUSSET_START_CLOSEST: gusset_strip_start = 1;

/// gusset_strip only: the first points.
pub const GUSSET_START_GIVEN: gusset_strip_start = 2;

/// The positions of new vertices.
pub type gusset_fairing = u32;
/// New vertices stay where they were first put: those of a strip divide their meridians evenly, as
/// the paper has it, those of a patch lie on the triangles of its first triangulation.
pub const GUSSET_FAIRING_NONE: gusset_fairing = 0;
/// New vertices are moved so that the new surface bends as a thin plate does and meets the old one
/// smoothly: the sum of the squared Laplacians over them and the rims is least. The rims, and the
/// ends of an open strip, stay where they are.
pub const GUSSET_FAIRING_THIN_PLATE: gusset_fairing = 1;

/// The treatment of faces that intersect each other.
pub type gusset_intersections = u32;
/// Faces of the strip that cut others are looked for, and what can be done about them is done:
/// - a strip of triangles without rows by GUSSET_MERIDIANS_CONTINUATION goes another way where it
///   cuts, and of the strips tried the one that cuts least is kept;
/// - faired rows are taken back in places, up to 12 times, until nothing cuts or nothing is left to
///   take back; if the straight rows cut less in the end, they are kept;
/// - blends are taken back likewise, and made with less fairing where they still cut; the one that
///   cuts least is kept, or the strip if that cuts less than every blend.
///
/// All other strips stay as they are: rows that are not faired, quads, and other meridians.
pub const GUSSET_INTERSECTIONS_AUTO: gusset_intersections = 0;
/// They are not looked for: rows are faired in full, and the first blend is kept.
pub const GUSSET_INTERSECTIONS_IGNORE: gusset_intersections = 1;
/// They are looked for. Faired rows and blends are taken back as with GUSSET_INTERSECTIONS_AUTO,
/// and no strip goes another way, nor does the strip that a blend follows.
pub const GUSSET_INTERSECTIONS_REPORT: gusset_intersections = 2;

/// The treatment of pieces that are oriented against each other.
pub type gusset_orientation = u32;
/// A second piece that is oriented against the first is turned over: the component that rim B is
/// on. Which of the two is inside out is not asked: see GUSSET_OUTWARD_CLOSED for what is closed in
/// the end. Two loops of one connected piece are taken as they are. Whole rims are compared as
/// curves, and by where their surfaces lie if both lead off them to the same side, as at the ends
/// of a U-bend; where nothing is clear, nothing is turned.
pub const GUSSET_ORIENTATION_FIX: gusset_orientation = 0;
/// Such a piece is GUSSET_ERROR_ORIENTATION_CONFLICT.
pub const GUSSET_ORIENTATION_REFUSE: gusset_orientation = 1;
/// The rims are not compared: the faces are taken to be right as they are.
pub const GUSSET_ORIENTATION_KEEP: gusset_orientation = 2;

/// The part of the loops that is joined.
pub type gusset_stitch_extent = u32;
/// All of both loops, by a closed band.
pub const GUSSET_EXTENT_WHOLE_LOOPS: gusset_stitch_extent = 0;
/// The runs of vertices that face the other loop, as the paper has it:
/// GUSSET_ERROR_PLANES_UNDECIDED where it cannot tell.
pub const GUSSET_EXTENT_OPEN_ARCS: gusset_stitch_extent = 1;
/// Whole loops if their normals make less than 60 degrees, in the mean of cosines, with the line of
/// their centres, or if the planes cannot tell; else open arcs.
pub const GUSSET_EXTENT_AUTO: gusset_stitch_extent = 2;
/// The arcs given in arc_a and arc_b. Of a loop that is not given, place 0 is where
/// gusset_boundary_get_loop has it.
pub const GUSSET_EXTENT_ARCS: gusset_stitch_extent = 3;

/// Which of several runs of facing vertices is joined.
pub type gusset_facing_run = u32;
/// Of several runs of facing vertices, on each loop the one with the closest pair.
pub const GUSSET_RUN_CLOSEST: gusset_facing_run = 0;
/// On each loop the one of the most vertices.
pub const GUSSET_RUN_LONGEST: gusset_facing_run = 1;

/// The definition of the centre of a loop.
pub type gusset_centres = u32;
/// The centre of a loop is the mean of its vertices, as the paper has it.
pub const GUSSET_CENTRES_VERTICES: gusset_centres = 0;
/// The mean of its points: vertices that lie close together do not draw it to them.
pub const GUSSET_CENTRES_LENGTH: gusset_centres = 1;

/// The number of interior rows.
pub type gusset_row_rule = u32;
/// No interior rows: every meridian is one edge.
pub const GUSSET_ROWS_NONE: gusset_row_rule = 0;
/// max(0, round(mean meridian / mean side of the faces of both meshes) - 1), as the paper suggests.
pub const GUSSET_ROWS_MEAN_EDGE: gusset_row_rule = 1;
/// As many as row_count says.
pub const GUSSET_ROWS_COUNT: gusset_row_rule = 2;

/// The faces of strips.
pub type gusset_strip_cells = u32;
/// Triangles throughout; quads are split by their shorter diagonals.
pub const GUSSET_CELLS_TRIANGLES: gusset_strip_cells = 0;
/// Quads where four different neighbours meet, and triangles where a rim repeats a vertex.
pub const GUSSET_CELLS_QUADS: gusset_strip_cells = 1;

/// The surface between the rims.
pub type gusset_finish = u32;
/// The strip of meridians, with its rows.
pub const GUSSET_FINISH_STRIP: gusset_finish = 0;
/// The best-looking joint: triangles about as fine as those round the rims, graded between them,
/// without sharp angles where the rims allow it, on a surface that leaves both pieces along their
/// tangents. The strip, without rows, says which way it goes: meridians and matrix are its own, and
/// no edges of the result; rows, cells and fairing are not read (the log says so if they are set).
/// Where every blend would cut more faces than the strip does, the strip stays; the log says so.
/// The surface bends as the strip does as a whole, without its ridges: a gap in a tube is bridged
/// by a tube, to within some per cent of its radius across a few radii. Time and memory grow with
/// the number of new triangles. Where sides as short as those round the rims would take more than
/// about 50,000 new vertices, or 16 for each of the rims', the sides are up to twice as long; where
/// that is not enough, the strip stays, and the log says so.
pub const GUSSET_FINISH_BLEND: gusset_finish = 1;

/// The source of a tolerance.
pub type gusset_tolerance_mode = u32;
/// No tolerance is given, and what rounding can do to the coordinates is taken. For vertices that
/// face another loop that is at most 2^-16 of the loops' largest coordinate for 32-bit positions,
/// 2^-45 for 64-bit ones; for vertices that are welded see gusset_weld_options.
pub const GUSSET_TOLERANCE_AUTO: gusset_tolerance_mode = 0;
/// The tolerance is the one given.
pub const GUSSET_TOLERANCE_GIVEN: gusset_tolerance_mode = 1;
/// The tolerance is 0: of vertices that are welded, the positions are equal.
pub const GUSSET_TOLERANCE_EXACT: gusset_tolerance_mode = 2;

/// The side that closed components of a result face.
pub type gusset_outward = u32;
/// As the operation does by default: gusset_join as GUSSET_OUTWARD_CLOSED, all others as GUSSET_OUTWARD_KEEP.
pub const GUSSET_OUTWARD_AUTO: gusset_outward = 0;
/// Closed components stay as they are; gusset_orient turns each to the side that most of its faces had.
pub const GUSSET_OUTWARD_KEEP: gusset_outward = 1;
/// Closed components face outwards, each by its own volume. A shell within another one encloses its own inside, and
/// the wall of a cavity is turned over too. A component whose volume is 0 up to rounding is as with
/// GUSSET_OUTWARD_KEEP. Except in gusset_orient, only components that are closed (every edge has two faces),
/// consistently oriented and inside out are turned over, each as a whole; all others stay as they are.
pub const GUSSET_OUTWARD_CLOSED: gusset_outward = 2;

/// How to stitch; all zero is the default.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_stitch_options {
    /// sizeof(gusset_stitch_options), set by the caller.
    pub struct_size: usize,
    /// The rule that chooses meridians.
    pub meridians: gusset_meridians,
    /// The treatment of pieces that are oriented against each other.
    pub orientation: gusset_orientation,
    /// The first meridian joins the closest pair that is not joined by an edge already; with a
    /// twist, the vertex of rim B so many places later, counted in the direction in which rim A
    /// runs (negative: earlier), and no other start is tried. Any value; taken modulo the length of
    /// rim B. Must be 0 if arcs are joined (OUT_OF_RANGE), and with GUSSET_EXTENT_OPEN_ARCS also if
    /// there are none to join.
    pub twist: i64,
    /// The part of the loops that is joined.
    pub extent: gusset_stitch_extent,
    /// Which of several runs of facing vertices is joined.
    pub run: gusset_facing_run,
    /// The number of interior rows.
    pub rows: gusset_row_rule,
    /// Interior rows, read for GUSSET_ROWS_COUNT.
    /// @when rows GUSSET_ROWS_COUNT
    pub row_count: u32,
    /// The faces of strips.
    pub cells: gusset_strip_cells,
    /// The source of a tolerance.
    pub tolerance_mode: gusset_tolerance_mode,
    /// How far a vertex must be from its loop's plane to face the other loop, in the unit of the
    /// positions, at least 0; read for GUSSET_TOLERANCE_GIVEN.
    /// @when tolerance_mode GUSSET_TOLERANCE_GIVEN
    pub tolerance: f64,
    /// Read for GUSSET_EXTENT_ARCS: the first place on loop A, below its length, and the number of
    /// vertices, 1 to its length. The arc runs along the loop as it was given, and may pass its
    /// end.
    pub arc_a: [u32; 2],
    /// The same on loop B.
    pub arc_b: [u32; 2],
    /// The effort of the search for the best strip.
    pub search: gusset_strip_search,
    /// The first meridian of a closed strip.
    pub start: gusset_strip_start,
    /// Read if interior rows are asked for; otherwise the log says that it is not.
    pub fairing: gusset_fairing,
    /// The treatment of faces that intersect each other.
    pub intersections: gusset_intersections,
    /// The definition of the centre of a loop.
    pub centres: gusset_centres,
    /// What becomes of closed components of the result, the strip and all.
    pub outward: gusset_outward,
    /// What lies between the rims in the end.
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
    search: Search { GUSSET_SEARCH_AUTO => Auto, GUSSET_SEARCH_EXACT => Exact }
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
            other => return Err(Failure::unknown("extent", other.into())),
        };
        let rows = rows(self.rows, self.row_count)?;
        Ok(Options {
            meridians: choice(self.meridians)?,
            search: choice(self.search)?,
            start: choice(self.start)?,
            orientation: choice(self.orientation)?,
            twist: self.twist,
            extent,
            run: choice(self.run)?,
            tolerance: tolerance(self.tolerance_mode, self.tolerance)?,
            centres: choice(self.centres)?,
            rows,
            cells: choice(self.cells)?,
            fairing: choice(self.fairing)?,
            finish: choice(self.finish)?,
            intersections: choice(self.intersections)?,
            outward: outward(self.outward, Outward::Keep)?,
        })
    }
}

/// The side that closed components face, `default` if the caller leaves it open.
pub(crate) fn outward(given: gusset_outward, default: Outward) -> Result<Outward, Failure> {
    match given {
        GUSSET_OUTWARD_AUTO => Ok(default),
        GUSSET_OUTWARD_KEEP => Ok(Outward::Keep),
        GUSSET_OUTWARD_CLOSED => Ok(Outward::Closed),
        other => Err(Failure::unknown("outward", other.into())),
    }
}

/// The interior rows of a mode.
pub(crate) fn rows(mode: u32, count: u32) -> Result<Rows, Failure> {
    match mode {
        GUSSET_ROWS_NONE => Ok(Rows::None),
        GUSSET_ROWS_MEAN_EDGE => Ok(Rows::MeanEdge),
        GUSSET_ROWS_COUNT => Ok(Rows::Count(count)),
        other => Err(Failure::unknown("rows", other.into())),
    }
}

/// The tolerance of a mode, if one is given.
pub(crate) fn tolerance(mode: u32, given: f64) -> Result<Option<f64>, Failure> {
    match mode {
        GUSSET_TOLERANCE_AUTO => Ok(None),
        GUSSET_TOLERANCE_GIVEN => Ok(Some(given)),
        GUSSET_TOLERANCE_EXACT => Ok(Some(0.0)),
        other => Err(Failure::unknown("tolerance_mode", other.into())),
    }
}
