//! Status codes. Numbers are fixed for ever: 1-999 mistakes of the caller, 1000-1999 data, 2000-2999 environment.

use crate::error::{Error, Side};
use std::borrow::Cow;

/// What a function returns; `GUSSET_OK` is 0.
#[repr(i32)]
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[allow(missing_docs, reason = "cbindgen takes the comments below, one each")]
pub enum gusset_status {
    /// Success.
    GUSSET_OK = 0,
    /// A pointer that must not be NULL is NULL.
    GUSSET_ERROR_NULL_ARGUMENT = 1,
    /// A pointer to a struct, a handle or an output is not aligned for it. (Element arrays may have any alignment.)
    GUSSET_ERROR_MISALIGNED_ARGUMENT = 2,
    /// struct_size is smaller than the first version of the struct.
    GUSSET_ERROR_BAD_STRUCT_SIZE = 3,
    /// An enumerator, a reserved field or a field unknown to this version has an unknown value.
    GUSSET_ERROR_UNKNOWN_VALUE = 4,
    /// An option is outside its range.
    GUSSET_ERROR_OUT_OF_RANGE = 5,
    /// The caller's buffer is too small; nothing was written but the size needed.
    GUSSET_ERROR_BUFFER_TOO_SMALL = 6,
    /// The context is in use by another call: on another thread, or further up this one's stack.
    GUSSET_ERROR_CONTEXT_BUSY = 7,
    /// There is no element of this index.
    GUSSET_ERROR_NO_SUCH_ELEMENT = 8,
    /// position_stride is smaller than one position.
    GUSSET_ERROR_BAD_STRIDE = 9,
    /// Exactly one of face_offsets and face_size must be given.
    GUSSET_ERROR_BAD_FACE_LAYOUT = 10,
    /// Arrays that the library would write to overlap.
    GUSSET_ERROR_OVERLAP = 11,
    /// More vertices, faces or half-edges than this version takes.
    GUSSET_ERROR_TOO_LARGE = 1000,
    /// The bytes of an array exceed the address space.
    GUSSET_ERROR_SIZE_OVERFLOW = 1001,
    /// A mesh without vertices or without faces.
    GUSSET_ERROR_EMPTY_MESH = 1002,
    /// Offsets, of faces, outlines or segments, do not start at 0, decrease, or end elsewhere than their elements.
    GUSSET_ERROR_BAD_OFFSETS = 1003,
    /// A face of fewer than three corners.
    GUSSET_ERROR_FACE_TOO_SMALL = 1004,
    /// A face names a vertex that does not exist.
    GUSSET_ERROR_INDEX_OUT_OF_RANGE = 1005,
    /// A vertex used by a face, or a point of a loop, has a coordinate that is NaN or infinite.
    GUSSET_ERROR_NOT_FINITE = 1006,
    /// Mesh B has f64 positions and mesh A f32.
    GUSSET_ERROR_MIXED_SCALARS = 1007,
    /// There is no boundary loop that can be stitched.
    GUSSET_ERROR_NO_LOOP = 1100,
    /// A loop of fewer than three vertices.
    GUSSET_ERROR_LOOP_TOO_SHORT = 1101,
    /// A loop passes a vertex twice.
    GUSSET_ERROR_LOOP_REPEATS_VERTEX = 1102,
    /// Consecutive vertices of a loop are not joined by an edge with exactly one face.
    GUSSET_ERROR_LOOP_EDGE_NOT_FREE = 1103,
    /// Both loops pass the same vertex of the same mesh.
    GUSSET_ERROR_LOOPS_SHARE_VERTEX = 1104,
    /// The faces along a loop disagree in orientation.
    GUSSET_ERROR_LOOP_NOT_ORIENTED = 1105,
    /// The second piece is oriented against the first, and the options refuse to turn it over.
    GUSSET_ERROR_ORIENTATION_CONFLICT = 1106,
    /// Every strip through the first meridian would repeat an edge that the mesh already has.
    GUSSET_ERROR_NO_STRIP = 1107,
    /// The planes through the loops' centres cannot tell which vertices face each other: such loops are joined whole.
    GUSSET_ERROR_PLANES_UNDECIDED = 1108,
    /// A closed curve does not end where it begins.
    GUSSET_ERROR_CURVE_NOT_CLOSED = 1200,
    /// A control point of what must be a plane curve has z other than 0.
    GUSSET_ERROR_CURVE_NOT_PLANE = 1201,
    /// A curve without segments, or without points, where one is needed.
    GUSSET_ERROR_EMPTY_CURVE = 1202,
    /// A section of a frame has another number of points than the first one.
    GUSSET_ERROR_SECTIONS_DIFFER = 1210,
    /// A section of a frame, or a plane, does not meet a column.
    GUSSET_ERROR_NO_NODE = 1211,
    /// A net of fewer than two rows or columns.
    GUSSET_ERROR_NET_TOO_SMALL = 1300,
    /// A gluing makes both pairs of opposite corners of a cell one each, which no surface allows.
    GUSSET_ERROR_CROSSING_CELL = 1301,
    /// A seam is empty or leaves the net.
    GUSSET_ERROR_BAD_SEAM = 1302,
    /// Sides of nets to be joined have different numbers of nodes, or do not lie on each other.
    GUSSET_ERROR_SIDES_DIFFER = 1303,
    /// Faces of a mesh are no rectangular grid of quads.
    GUSSET_ERROR_NO_GRID = 1304,
    /// A stream is damaged, cut off, or none of ours.
    GUSSET_ERROR_BAD_STREAM = 1305,
    /// A group of a scene would contain itself.
    GUSSET_ERROR_SCENE_CYCLE = 1306,
    /// A scene without nets.
    GUSSET_ERROR_EMPTY_SCENE = 1307,
    /// A field of deformation is not defined at a node.
    GUSSET_ERROR_FIELD_UNDEFINED = 1320,
    /// A net is glued elsewhere than along whole sides, or has bridges.
    GUSSET_ERROR_GLUED_INSIDE = 1321,
    /// Knots of a spline: their number does not fit, or one is out of order or repeated too often.
    GUSSET_ERROR_BAD_KNOTS = 1410,
    /// Curves of a net do not meet, or not in the order given.
    GUSSET_ERROR_CURVES_APART = 1411,
    /// Memory could not be had.
    GUSSET_ERROR_OUT_OF_MEMORY = 2000,
    /// The host cancelled.
    GUSSET_ERROR_CANCELLED = 2001,
    /// A defect of the library; the context and all handles remain usable.
    GUSSET_ERROR_PANIC = 9999,
}

use gusset_status::*;

/// What the index in a report counts.
pub type gusset_element = u32;
/// The report's index means nothing.
pub const GUSSET_ELEMENT_NONE: gusset_element = 0;
/// A vertex of the input mesh.
pub const GUSSET_ELEMENT_VERTEX: gusset_element = 1;
/// A face of the input mesh.
pub const GUSSET_ELEMENT_FACE: gusset_element = 2;
/// A half-edge: a position in face_corners.
pub const GUSSET_ELEMENT_HALF_EDGE: gusset_element = 3;
/// An entry of face_offsets.
pub const GUSSET_ELEMENT_OFFSET: gusset_element = 4;
/// A place in the loop given.
pub const GUSSET_ELEMENT_LOOP_PLACE: gusset_element = 5;
/// A count of elements or bytes.
pub const GUSSET_ELEMENT_COUNT: gusset_element = 6;
/// A point of an outline or a curve, counted over all outlines.
pub const GUSSET_ELEMENT_POINT: gusset_element = 7;
/// A constraint on an outline.
pub const GUSSET_ELEMENT_CONSTRAINT: gusset_element = 8;
/// One of the places on a curve or a surface that were given.
pub const GUSSET_ELEMENT_PLACE: gusset_element = 9;
/// A section of a frame, or a plane, counted from 0; the value is the column or the number of points.
pub const GUSSET_ELEMENT_SECTION: gusset_element = 12;
/// A node of a net, row after row.
pub const GUSSET_ELEMENT_NODE: gusset_element = 13;
/// A link of a net: twice its first node, and 1 if it is vertical.
pub const GUSSET_ELEMENT_LINK: gusset_element = 14;
/// A cell of a net, row after row.
pub const GUSSET_ELEMENT_CELL: gusset_element = 15;
/// One of the seams given.
pub const GUSSET_ELEMENT_SEAM: gusset_element = 16;
/// A bridge of a net.
pub const GUSSET_ELEMENT_BRIDGE: gusset_element = 17;
/// An entry of a scene.
pub const GUSSET_ELEMENT_ENTRY: gusset_element = 18;
/// A byte of a stream.
pub const GUSSET_ELEMENT_BYTE: gusset_element = 19;
/// One of the operations, fields, gluings, lines, sheets or curves that were given.
pub const GUSSET_ELEMENT_ITEM: gusset_element = 21;
/// A place along the side of a net; the value is a distance.
pub const GUSSET_ELEMENT_SIDE_PLACE: gusset_element = 20;
/// A knot of a spline, in u or in v as the message says.
pub const GUSSET_ELEMENT_KNOT: gusset_element = 30;
/// A row of a net of curves; the message has the column, the value is how far they are apart.
pub const GUSSET_ELEMENT_ROW: gusset_element = 31;

/// A failure on its way to the host.
#[derive(Debug)]
pub(crate) struct Failure {
    pub(crate) status: gusset_status,
    pub(crate) message: Cow<'static, str>,
    pub(crate) element: gusset_element,
    pub(crate) index: u64,
    pub(crate) value: f64,
    /// Which mesh: 0 the first, 1 the second.
    pub(crate) input: u32,
}

impl Failure {
    pub(crate) fn new(status: gusset_status, message: impl Into<Cow<'static, str>>) -> Self {
        Failure { status, message: message.into(), element: GUSSET_ELEMENT_NONE, index: 0, value: 0.0, input: 0 }
    }

    pub(crate) fn null(argument: &'static str) -> Self {
        Failure::new(GUSSET_ERROR_NULL_ARGUMENT, format!("{argument} is NULL"))
    }

    pub(crate) fn unknown(what: &'static str, value: u64) -> Self {
        Failure {
            value: value as f64,
            ..Failure::new(GUSSET_ERROR_UNKNOWN_VALUE, format!("{what} has the unknown value {value}"))
        }
    }

    pub(crate) fn no_such(what: &'static str, index: usize) -> Self {
        let message = format!("there is no {what} {index}");
        Failure { index: index as u64, ..Failure::new(GUSSET_ERROR_NO_SUCH_ELEMENT, message) }
    }

    /// The same failure, of item `index` of an array of the caller's, unless it is about an element already.
    pub(crate) fn of_item(self, index: usize) -> Self {
        match self.element {
            GUSSET_ELEMENT_NONE => Failure { element: GUSSET_ELEMENT_ITEM, index: index as u64, ..self },
            _ => self,
        }
    }

    /// The same failure, of input mesh `input`.
    pub(crate) fn of_input(self, input: u32) -> Self {
        Failure { input, ..self }
    }
}

impl From<Error> for Failure {
    fn from(error: Error) -> Self {
        let at = |status, element, index: u32| (status, element, u64::from(index), 0.0);
        let count = |status, count| (status, GUSSET_ELEMENT_COUNT, count, 0.0);
        let none = |status| (status, GUSSET_ELEMENT_NONE, 0, 0.0);
        let (status, element, index, value) = match error {
            Error::TooLarge { count: n, limit, .. } => (GUSSET_ERROR_TOO_LARGE, GUSSET_ELEMENT_COUNT, n, limit as f64),
            Error::SizeOverflow { count: n, .. } => count(GUSSET_ERROR_SIZE_OVERFLOW, n),
            Error::ArrayTooShort { needed, .. } => count(GUSSET_ERROR_SIZE_OVERFLOW, needed),
            Error::StrideTooSmall { stride, .. } => count(GUSSET_ERROR_BAD_STRIDE, stride),
            Error::EmptyMesh { .. } => none(GUSSET_ERROR_EMPTY_MESH),
            Error::BadOffsets { entry, value } => {
                (GUSSET_ERROR_BAD_OFFSETS, GUSSET_ELEMENT_OFFSET, entry.into(), f64::from(value))
            }
            Error::FaceTooSmall { face, corners } => {
                (GUSSET_ERROR_FACE_TOO_SMALL, GUSSET_ELEMENT_FACE, face.into(), f64::from(corners))
            }
            Error::IndexOutOfRange { corner, vertex, .. } => {
                (GUSSET_ERROR_INDEX_OUT_OF_RANGE, GUSSET_ELEMENT_HALF_EDGE, corner.into(), f64::from(vertex))
            }
            Error::NotFinite { vertex, value } => {
                (GUSSET_ERROR_NOT_FINITE, GUSSET_ELEMENT_VERTEX, vertex.into(), value)
            }
            Error::PointNotFinite { place, value, .. } => {
                (GUSSET_ERROR_NOT_FINITE, GUSSET_ELEMENT_LOOP_PLACE, place.into(), value)
            }
            Error::OutlineNotFinite { point, value } => {
                (GUSSET_ERROR_NOT_FINITE, GUSSET_ELEMENT_POINT, point.into(), value)
            }
            Error::QueryNotFinite { query, value } => {
                (GUSSET_ERROR_NOT_FINITE, GUSSET_ELEMENT_POINT, query.into(), value)
            }
            Error::SectionsDiffer { section, count, .. } => {
                (GUSSET_ERROR_SECTIONS_DIFFER, GUSSET_ELEMENT_SECTION, section.into(), f64::from(count))
            }
            Error::NoNode { section, column } => {
                (GUSSET_ERROR_NO_NODE, GUSSET_ELEMENT_SECTION, section.into(), f64::from(column))
            }
            Error::CurveNotClosed => none(GUSSET_ERROR_CURVE_NOT_CLOSED),
            Error::CurveNotPlane { point } => at(GUSSET_ERROR_CURVE_NOT_PLANE, GUSSET_ELEMENT_POINT, point),
            Error::EmptyCurve => none(GUSSET_ERROR_EMPTY_CURVE),
            Error::NoSuchPlace { index, t, .. } => {
                (GUSSET_ERROR_NO_SUCH_ELEMENT, GUSSET_ELEMENT_PLACE, index.into(), t)
            }
            Error::NoSuchPoint { constraint, point } => {
                (GUSSET_ERROR_NO_SUCH_ELEMENT, GUSSET_ELEMENT_CONSTRAINT, constraint.into(), f64::from(point))
            }
            Error::MixedScalars => none(GUSSET_ERROR_MIXED_SCALARS),
            Error::NoLoop { .. } => none(GUSSET_ERROR_NO_LOOP),
            Error::LoopTooShort { count: n, .. } => count(GUSSET_ERROR_LOOP_TOO_SHORT, n.into()),
            Error::LoopRepeatsVertex { vertex, .. } => {
                at(GUSSET_ERROR_LOOP_REPEATS_VERTEX, GUSSET_ELEMENT_VERTEX, vertex)
            }
            Error::LoopEdgeNotFree { place, vertex, .. } => {
                (GUSSET_ERROR_LOOP_EDGE_NOT_FREE, GUSSET_ELEMENT_LOOP_PLACE, place.into(), f64::from(vertex))
            }
            Error::LoopsShareVertex { vertex } => at(GUSSET_ERROR_LOOPS_SHARE_VERTEX, GUSSET_ELEMENT_VERTEX, vertex),
            Error::PlanesUndecided { .. } => none(GUSSET_ERROR_PLANES_UNDECIDED),
            Error::LoopNotOriented { face, .. } => at(GUSSET_ERROR_LOOP_NOT_ORIENTED, GUSSET_ELEMENT_FACE, face),
            Error::OrientationConflict { face } => at(GUSSET_ERROR_ORIENTATION_CONFLICT, GUSSET_ELEMENT_FACE, face),
            Error::NoStrip { vertex } => at(GUSSET_ERROR_NO_STRIP, GUSSET_ELEMENT_VERTEX, vertex),
            Error::NetTooSmall { rows, columns } => count(GUSSET_ERROR_NET_TOO_SMALL, rows.min(columns)),
            Error::CrossingCell { cell } => at(GUSSET_ERROR_CROSSING_CELL, GUSSET_ELEMENT_CELL, cell),
            Error::BadSeam { seam } => at(GUSSET_ERROR_BAD_SEAM, GUSSET_ELEMENT_SEAM, seam),
            Error::NoSuchNode { node } => (GUSSET_ERROR_NO_SUCH_ELEMENT, GUSSET_ELEMENT_NODE, node, 0.0),
            Error::NoSuchLink { link } => (GUSSET_ERROR_NO_SUCH_ELEMENT, GUSSET_ELEMENT_LINK, link, 0.0),
            Error::NoSuchCell { cell } => (GUSSET_ERROR_NO_SUCH_ELEMENT, GUSSET_ELEMENT_CELL, cell, 0.0),
            Error::NoSuchBridge { bridge } => (GUSSET_ERROR_NO_SUCH_ELEMENT, GUSSET_ELEMENT_BRIDGE, bridge, 0.0),
            Error::NoSuchEntry { entry } => (GUSSET_ERROR_NO_SUCH_ELEMENT, GUSSET_ELEMENT_ENTRY, entry, 0.0),
            Error::NodeNotFinite { node, value } => (GUSSET_ERROR_NOT_FINITE, GUSSET_ELEMENT_NODE, node.into(), value),
            Error::SidesDiffer { a, b } => (GUSSET_ERROR_SIDES_DIFFER, GUSSET_ELEMENT_COUNT, a.into(), f64::from(b)),
            Error::SidesApart { place, distance } => {
                (GUSSET_ERROR_SIDES_DIFFER, GUSSET_ELEMENT_SIDE_PLACE, place.into(), distance)
            }
            Error::WrongKnotCount { given, .. } => count(GUSSET_ERROR_BAD_KNOTS, given),
            Error::BadKnot { knot, value, .. } => (GUSSET_ERROR_BAD_KNOTS, GUSSET_ELEMENT_KNOT, knot.into(), value),
            Error::CurvesApart { row, distance, .. } => {
                (GUSSET_ERROR_CURVES_APART, GUSSET_ELEMENT_ROW, row.into(), distance)
            }
            Error::CurvesOutOfOrder { row, .. } => at(GUSSET_ERROR_CURVES_APART, GUSSET_ELEMENT_ROW, row),
            Error::NoSuchSurfacePlace { index } => (GUSSET_ERROR_NO_SUCH_ELEMENT, GUSSET_ELEMENT_PLACE, index, 0.0),
            Error::NetsOpposed => none(GUSSET_ERROR_ORIENTATION_CONFLICT),
            Error::NoGrid { face } => at(GUSSET_ERROR_NO_GRID, GUSSET_ELEMENT_FACE, face),
            Error::BadStream { byte, .. } => (GUSSET_ERROR_BAD_STREAM, GUSSET_ELEMENT_BYTE, byte, 0.0),
            Error::SceneCycle { entry } => at(GUSSET_ERROR_SCENE_CYCLE, GUSSET_ELEMENT_ENTRY, entry),
            Error::EmptyScene => none(GUSSET_ERROR_EMPTY_SCENE),
            Error::FieldUndefined { node } => at(GUSSET_ERROR_FIELD_UNDEFINED, GUSSET_ELEMENT_NODE, node),
            Error::GluedInside => none(GUSSET_ERROR_GLUED_INSIDE),
            Error::BadLine { line, value } => (GUSSET_ERROR_OUT_OF_RANGE, GUSSET_ELEMENT_ITEM, line, value),
            Error::SheetOutOfRange { sheet, value } => (GUSSET_ERROR_OUT_OF_RANGE, GUSSET_ELEMENT_ITEM, sheet, value),
            Error::InputCount { given, .. } => (GUSSET_ERROR_OUT_OF_RANGE, GUSSET_ELEMENT_NONE, 0, given as f64),
            Error::InputUnfit { input, .. } => (GUSSET_ERROR_OUT_OF_RANGE, GUSSET_ELEMENT_NONE, 0, f64::from(input)),
            Error::OptionOutOfRange { value, .. } => (GUSSET_ERROR_OUT_OF_RANGE, GUSSET_ELEMENT_NONE, 0, value),
            Error::OutOfMemory { bytes } => count(GUSSET_ERROR_OUT_OF_MEMORY, bytes),
            Error::Cancelled => none(GUSSET_ERROR_CANCELLED),
        };
        let input = u32::from(error.side() == Some(Side::B));
        Failure { status, message: error.to_string().into(), element, index, value, input }
    }
}

/// What a status means, in a few English words. status: any number; for one that is no status, "unknown status". Never
/// NULL; static. O(1). From any thread.
#[unsafe(no_mangle)]
pub extern "C" fn gusset_status_text(status: i32) -> *const libc::c_char {
    let text = match status {
        0 => c"success",
        1 => c"a pointer that must not be NULL is NULL",
        2 => c"a pointer is misaligned",
        3 => c"struct_size is too small",
        4 => c"a field has an unknown value",
        5 => c"an option is out of range",
        6 => c"the buffer is too small",
        7 => c"the context is in use",
        8 => c"there is no such element",
        9 => c"a stride does not fit",
        10 => c"exactly one of face_offsets and face_size must be given",
        11 => c"arrays overlap",
        1000 => c"an input is too large",
        1001 => c"an array exceeds the address space",
        1002 => c"the mesh is empty",
        1003 => c"offsets are not monotone from 0 to their elements",
        1004 => c"a face has fewer than three corners",
        1005 => c"a vertex index is out of range",
        1006 => c"a coordinate is not finite",
        1007 => c"the scalar types of the meshes cannot be combined",
        1100 => c"there is no loop to stitch",
        1101 => c"a loop has fewer than three vertices",
        1102 => c"a loop passes a vertex twice",
        1103 => c"a loop runs along an edge that is not free",
        1104 => c"the loops share a vertex",
        1105 => c"the faces along a loop disagree in orientation",
        1106 => c"the second piece is oriented against the first",
        1107 => c"no strip avoids the edges that the mesh already has",
        1108 => c"the planes through the centres cannot tell which vertices face each other",
        1200 => c"a closed curve does not end where it begins",
        1201 => c"the curve is not in the plane z = 0",
        1202 => c"the curve is empty",
        1210 => c"the sections have different numbers of points",
        1211 => c"a section does not meet a column",
        1300 => c"a net has fewer than two rows or columns",
        1301 => c"opposite corners of a cell are glued crosswise",
        1302 => c"a seam is empty or leaves the net",
        1303 => c"the sides of the nets do not fit",
        1304 => c"the faces are no rectangular grid of quads",
        1305 => c"the stream is damaged",
        1306 => c"a group would contain itself",
        1307 => c"the scene has no nets",
        1320 => c"field not defined at a node",
        1321 => c"glued elsewhere than along sides",
        1410 => c"knots do not fit",
        1411 => c"curves of a net do not meet",
        2000 => c"out of memory",
        2001 => c"cancelled",
        9999 => c"internal error",
        _ => c"unknown status",
    };
    text.as_ptr()
}
