//! Statuses: Results of functions. 1 to 999 are mistakes of the caller, 1000 to 1999 faults of the
//! data, 2000 to 2999 failures of the environment. Numbers never change their meaning.
//!
//! The first sentence of each comment is the text of its status or choice too: see `status_text.rs`
//! and `choice_text`. Each error of the core becomes a code with an element in one place,
//! `From<Error>`.

use super::choice_text::choice_text;
use crate::error::{Element, Error, LoopPairFault, Side};
use std::borrow::Cow;
use std::ffi::{CStr, c_char};
use std::fmt;

pub(super) use super::status_text::status_text;

/// Status that a function returns.
#[repr(i32)]
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[allow(missing_docs, reason = "cbindgen takes the comments below, one each")]
pub enum gusset_status {
    /// Success.
    GUSSET_OK = 0,
    /// A pointer that must not be NULL is NULL.
    GUSSET_ERROR_NULL_ARGUMENT = 1,
    /// A pointer to a struct, a handle or an output is misaligned.
    GUSSET_ERROR_MISALIGNED_ARGUMENT = 2,
    /// struct_size is not the size of the struct in any version.
    GUSSET_ERROR_BAD_STRUCT_SIZE = 3,
    /// A choice, a reserved field or a field unknown to this version has an unknown value.
    GUSSET_ERROR_UNKNOWN_VALUE = 4,
    /// An option is outside its range.
    GUSSET_ERROR_OUT_OF_RANGE = 5,
    /// The caller's buffer is too small; only the required size was written.
    GUSSET_ERROR_BUFFER_TOO_SMALL = 6,
    /// Another call uses the context, on another thread or further up the stack.
    GUSSET_ERROR_CONTEXT_BUSY = 7,
    /// The element with this index does not exist.
    GUSSET_ERROR_NO_SUCH_ELEMENT = 8,
    /// A stride is smaller than one element.
    GUSSET_ERROR_BAD_STRIDE = 9,
    /// Exactly one of face_offsets and face_size must be given.
    GUSSET_ERROR_BAD_FACE_LAYOUT = 10,
    /// An output array overlaps another array.
    GUSSET_ERROR_OVERLAP = 11,
    /// A handle is of the wrong kind or was destroyed. Reused memory and other invalid pointers
    /// stay undetected.
    GUSSET_ERROR_WRONG_HANDLE = 12,
    /// The number of inputs, or of elements of an array, is wrong.
    GUSSET_ERROR_COUNT_DIFFERS = 13,
    /// A count exceeds the limit of this version.
    GUSSET_ERROR_TOO_LARGE = 1000,
    /// An array exceeds the address space.
    GUSSET_ERROR_SIZE_OVERFLOW = 1001,
    /// A mesh lacks vertices or faces, or no mesh was given.
    GUSSET_ERROR_EMPTY_MESH = 1002,
    /// Offsets do not start at 0, decrease, or do not end at the number of elements.
    GUSSET_ERROR_BAD_OFFSETS = 1003,
    /// A face has fewer than three corners.
    GUSSET_ERROR_FACE_TOO_SMALL = 1004,
    /// A vertex index is out of range.
    GUSSET_ERROR_INDEX_OUT_OF_RANGE = 1005,
    /// A number is NaN or infinite. It belongs to a used vertex, point, tangent, query, node or
    /// channel.
    GUSSET_ERROR_NOT_FINITE = 1006,
    /// A later mesh or piece has 64-bit positions and the first has 32-bit positions.
    GUSSET_ERROR_MIXED_SCALARS = 1007,
    /// A record of a winged-edge table is inconsistent.
    GUSSET_ERROR_BAD_WINGS = 1008,
    /// A merge map names a vertex that does not exist or is merged into another.
    GUSSET_ERROR_BAD_MERGE = 1009,
    /// A face passes a vertex twice, which the operation does not allow.
    GUSSET_ERROR_REPEATED_CORNER = 1010,
    /// A mesh is not closed, or its faces are not oriented alike.
    GUSSET_ERROR_MESH_NOT_CLOSED = 1011,
    /// No boundary loop, or no pair of loops of one mesh, can be stitched.
    GUSSET_ERROR_NO_LOOP = 1100,
    /// A loop has fewer than three vertices.
    GUSSET_ERROR_LOOP_TOO_SHORT = 1101,
    /// A loop passes a vertex twice.
    GUSSET_ERROR_LOOP_REPEATS_VERTEX = 1102,
    /// Consecutive vertices of a loop are not joined by an edge with exactly one face.
    GUSSET_ERROR_LOOP_EDGE_NOT_FREE = 1103,
    /// Both loops pass the same vertex of one mesh.
    GUSSET_ERROR_LOOPS_SHARE_VERTEX = 1104,
    /// The faces along a loop disagree in orientation.
    GUSSET_ERROR_LOOP_NOT_ORIENTED = 1105,
    /// The second piece is oriented against the first, and the options forbid turning it over.
    GUSSET_ERROR_ORIENTATION_CONFLICT = 1106,
    /// Every strip through the first meridian would repeat an edge of the mesh.
    GUSSET_ERROR_NO_STRIP = 1107,
    /// The planes through the loops' centres do not show which vertices face each other. Join whole
    /// loops.
    GUSSET_ERROR_PLANES_UNDECIDED = 1108,
    /// Consecutive vertices of a cut are not connected by edges.
    GUSSET_ERROR_CUT_NOT_CONNECTED = 1109,
    /// A closed curve does not end where it begins.
    GUSSET_ERROR_CURVE_NOT_CLOSED = 1200,
    /// A control point of a plane curve has z other than 0.
    GUSSET_ERROR_CURVE_NOT_PLANE = 1201,
    /// A curve lacks segments or points.
    GUSSET_ERROR_EMPTY_CURVE = 1202,
    /// A section of a frame has a different number of points than the first.
    GUSSET_ERROR_SECTIONS_DIFFER = 1210,
    /// A section of a frame, or a plane, does not meet a column.
    GUSSET_ERROR_NO_NODE = 1211,
    /// A net has fewer than two rows or columns.
    GUSSET_ERROR_NET_TOO_SMALL = 1300,
    /// A gluing merges both pairs of opposite corners of a cell.
    GUSSET_ERROR_CROSSING_CELL = 1301,
    /// A seam is empty, leaves the net, or repeats one pair of nodes.
    GUSSET_ERROR_BAD_SEAM = 1302,
    /// Sides of nets to be joined have different numbers of nodes or do not coincide.
    GUSSET_ERROR_SIDES_DIFFER = 1303,
    /// Faces do not form a rectangular grid of quads, whole or split along diagonals.
    GUSSET_ERROR_NO_GRID = 1304,
    /// A stream is damaged, truncated or in another format.
    GUSSET_ERROR_BAD_STREAM = 1305,
    /// A group of a scene would contain itself.
    GUSSET_ERROR_SCENE_CYCLE = 1306,
    /// A scene has no nets.
    GUSSET_ERROR_EMPTY_SCENE = 1307,
    /// A deformation field is not defined at a node.
    GUSSET_ERROR_FIELD_UNDEFINED = 1320,
    /// A net is glued elsewhere than along whole sides, or has bridges.
    GUSSET_ERROR_GLUED_INSIDE = 1321,
    /// Two nets are glued differently.
    GUSSET_ERROR_GLUINGS_DIFFER = 1322,
    /// Knots of a spline have a wrong number, order or multiplicity.
    GUSSET_ERROR_BAD_KNOTS = 1410,
    /// Curves of a net do not meet, or meet out of order.
    GUSSET_ERROR_CURVES_APART = 1411,
    /// Memory could not be allocated.
    GUSSET_ERROR_OUT_OF_MEMORY = 2000,
    /// The caller cancelled the call.
    GUSSET_ERROR_CANCELLED = 2001,
    /// Internal error of the library; the context and all handles remain usable.
    GUSSET_ERROR_PANIC = 9999,
}

use gusset_status::*;

/// Element that a report's index counts.
pub type gusset_element = u32;
/// The index means nothing.
pub const GUSSET_ELEMENT_NONE: gusset_element = 0;
/// Vertex of the input mesh.
pub const GUSSET_ELEMENT_VERTEX: gusset_element = 1;
/// Face of the input mesh.
pub const GUSSET_ELEMENT_FACE: gusset_element = 2;
/// Half-edge: a position in face_corners.
pub const GUSSET_ELEMENT_HALF_EDGE: gusset_element = 3;
/// Entry of an array of offsets.
pub const GUSSET_ELEMENT_OFFSET: gusset_element = 4;
/// Position in a given loop. Its number is the report's input.
pub const GUSSET_ELEMENT_LOOP_PLACE: gusset_element = 5;
/// Number of elements or bytes.
pub const GUSSET_ELEMENT_COUNT: gusset_element = 6;
/// Point of an outline or a curve, over all outlines.
pub const GUSSET_ELEMENT_POINT: gusset_element = 7;
/// Constraint on an outline: its place or tangent.
pub const GUSSET_ELEMENT_CONSTRAINT: gusset_element = 8;
/// Given place on a curve or a surface.
pub const GUSSET_ELEMENT_PLACE: gusset_element = 9;
/// Section of a frame, or plane. The value is the column or the number of points.
pub const GUSSET_ELEMENT_SECTION: gusset_element = 12;
/// Node of a net, row after row.
pub const GUSSET_ELEMENT_NODE: gusset_element = 13;
/// Link of a net: twice its first node, plus 1 if vertical.
pub const GUSSET_ELEMENT_LINK: gusset_element = 14;
/// Cell of a net, row after row.
pub const GUSSET_ELEMENT_CELL: gusset_element = 15;
/// Given seam.
pub const GUSSET_ELEMENT_SEAM: gusset_element = 16;
/// Bridge of a net.
pub const GUSSET_ELEMENT_BRIDGE: gusset_element = 17;
/// Entry of a scene.
pub const GUSSET_ELEMENT_ENTRY: gusset_element = 18;
/// Byte of a stream.
pub const GUSSET_ELEMENT_BYTE: gusset_element = 19;
/// Given operation, field, gluing, line, loop, pair, piece, sheet or curve.
pub const GUSSET_ELEMENT_ITEM: gusset_element = 21;
/// Place along the side of a net; the value is a distance.
pub const GUSSET_ELEMENT_SIDE_PLACE: gusset_element = 20;
/// Knot of a spline; the message names u or v.
pub const GUSSET_ELEMENT_KNOT: gusset_element = 30;
/// Row of a net of curves. The message has the column; the value is their distance.
pub const GUSSET_ELEMENT_ROW: gusset_element = 31;

/// Edge of a winged-edge table.
pub const GUSSET_ELEMENT_EDGE: gusset_element = 32;

/// A failure to report to the host.
#[derive(Debug)]
pub struct Failure {
    /// The status code.
    pub status: gusset_status,
    /// The message for the host.
    pub message: Cow<'static, str>,
    /// The kind of the element at fault.
    pub(crate) element: gusset_element,
    /// The index of the element at fault.
    pub(crate) index: u64,
    /// The value at fault.
    pub(crate) value: f64,
    /// The input at fault: 0 is the first, 1 the second.
    pub(crate) input: u32,
}

impl Failure {
    pub(crate) fn new(status: gusset_status, message: impl Into<Cow<'static, str>>) -> Self {
        Failure { status, message: message.into(), element: GUSSET_ELEMENT_NONE, index: 0, value: 0.0, input: 0 }
    }

    pub(crate) fn null_argument(argument: &'static str) -> Self {
        Failure::new(GUSSET_ERROR_NULL_ARGUMENT, format!("{argument} is NULL; it must not be"))
    }

    /// Returns the failure of a choice that is not one of its `constants`.
    pub(crate) fn unknown_choice(what: &str, value: u32, constants: &[&str]) -> Self {
        Failure::unknown_value(what, value.into(), constants.join(" or "))
    }

    /// Returns the failure of a field that must be 0.
    pub(crate) fn not_zero(what: impl fmt::Display, value: u64) -> Self {
        Failure::unknown_value(what, value, "0")
    }

    /// Returns the failure of a value that is not `allowed`, the words after "it must be".
    pub(crate) fn unknown_value(what: impl fmt::Display, value: u64, allowed: impl fmt::Display) -> Self {
        let message = format!("{what} is {value}; it must be {allowed}");
        Failure { value: value as f64, ..Failure::new(GUSSET_ERROR_UNKNOWN_VALUE, message) }
    }

    pub(crate) fn no_such_element(what: &'static str, index: usize, count: usize) -> Self {
        let message = format!("{what} {index} does not exist (there are {count})");
        Failure { index: index as u64, ..Failure::new(GUSSET_ERROR_NO_SUCH_ELEMENT, message) }
    }

    /// Returns the failure of an output that is not of the `wanted` kind.
    pub(crate) fn wrong_output(index: u32, wanted: &'static str) -> Self {
        let message = format!("output {index} is not {wanted}");
        Failure { index: index.into(), ..Failure::new(GUSSET_ERROR_NO_SUCH_ELEMENT, message) }
    }

    /// Adds an item of the caller's array `name`, unless the failure already has an element.
    pub(crate) fn with_item(self, name: &'static str, index: usize) -> Self {
        match self.element {
            GUSSET_ELEMENT_NONE => {
                Failure { element: GUSSET_ELEMENT_ITEM, index: index as u64, ..self.within_item(name, index) }
            }
            _ => self,
        }
    }

    /// Names an item of the caller's array `name` in the message.
    pub(crate) fn within_item(self, name: &'static str, index: usize) -> Self {
        let item = format!("{name}[{index}]");
        match self.message.strip_prefix(name) {
            // The message already names the item, or the array.
            Some(rest) if rest.starts_with('[') => self,
            Some(rest) if rest.starts_with(' ') => Failure { message: format!("{item}{rest}").into(), ..self },
            _ => self.within(&item),
        }
    }

    /// Names the argument that the failure concerns at the start of the message. A cancel or a lack
    /// of memory concerns none.
    pub(crate) fn within(self, argument: &str) -> Self {
        let is_named = self.message.strip_prefix(argument).is_some_and(|rest| rest.starts_with([' ', '.', '[']));
        match self.status {
            GUSSET_ERROR_CANCELLED | GUSSET_ERROR_OUT_OF_MEMORY => self,
            _ if is_named => self,
            _ => Failure { message: format!("{argument}: {}", self.message).into(), ..self },
        }
    }

    /// Prefixes the name of a nested struct in the options to the message.
    pub(crate) fn with_field(self, name: &'static str) -> Self {
        Failure { message: format!("{name}.{}", self.message).into(), ..self }
    }

    /// Sets the input at fault.
    pub(crate) fn with_input(self, input: u32) -> Self {
        Failure { input, ..self }
    }

    /// Returns a failure with an element at fault.
    fn with_element(
        status: gusset_status,
        element: gusset_element,
        index: impl Into<u64>,
        value: impl Into<f64>,
    ) -> Self {
        Failure { element, index: index.into(), value: value.into(), ..Failure::new(status, "") }
    }
}

/// Returns the constant of C for an element.
fn element_code(element: Element) -> gusset_element {
    match element {
        Element::Vertex => GUSSET_ELEMENT_VERTEX,
        Element::LoopPoint(_) => GUSSET_ELEMENT_LOOP_PLACE,
        Element::Point | Element::Query => GUSSET_ELEMENT_POINT,
        Element::Place => GUSSET_ELEMENT_PLACE,
        Element::Constraint => GUSSET_ELEMENT_CONSTRAINT,
        Element::Node => GUSSET_ELEMENT_NODE,
        Element::Link => GUSSET_ELEMENT_LINK,
        Element::Corner => GUSSET_ELEMENT_HALF_EDGE,
        Element::Face => GUSSET_ELEMENT_FACE,
        Element::Cell => GUSSET_ELEMENT_CELL,
        Element::Bridge => GUSSET_ELEMENT_BRIDGE,
        Element::Entry => GUSSET_ELEMENT_ENTRY,
    }
}

impl From<Error> for Failure {
    fn from(error: Error) -> Self {
        use Error::*;
        let at = |status, element, index: u32, value: f64| Failure::with_element(status, element, index, value);
        let plain = |status, value: f64| Failure::with_element(status, GUSSET_ELEMENT_NONE, 0_u64, value);
        let count = |status, count: u64| Failure::with_element(status, GUSSET_ELEMENT_COUNT, count, 0.0);
        let failure = match error {
            TooLarge { count: n, limit, .. } => Failure { value: limit as f64, ..count(GUSSET_ERROR_TOO_LARGE, n) },
            SizeOverflow { count: n, .. } => count(GUSSET_ERROR_SIZE_OVERFLOW, n),
            ArrayTooShort { needed, given, .. } => {
                Failure { value: needed as f64, ..count(GUSSET_ERROR_COUNT_DIFFERS, given) }
            }
            StrideTooSmall { stride, .. } => count(GUSSET_ERROR_BAD_STRIDE, stride),
            EmptyMesh { .. } => plain(GUSSET_ERROR_EMPTY_MESH, 0.0),
            BadOffsets { entry, value } => at(GUSSET_ERROR_BAD_OFFSETS, GUSSET_ELEMENT_OFFSET, entry, value.into()),
            FaceTooSmall { face, corners } => {
                at(GUSSET_ERROR_FACE_TOO_SMALL, GUSSET_ELEMENT_FACE, face, corners.into())
            }
            IndexOutOfRange { corner, vertex, .. } => {
                at(GUSSET_ERROR_INDEX_OUT_OF_RANGE, GUSSET_ELEMENT_HALF_EDGE, corner, vertex.into())
            }
            BadMerge { vertex, value } => at(GUSSET_ERROR_BAD_MERGE, GUSSET_ELEMENT_VERTEX, vertex, value.into()),
            RepeatedCorner { face, vertex } => {
                at(GUSSET_ERROR_REPEATED_CORNER, GUSSET_ELEMENT_FACE, face, vertex.into())
            }
            MeshNotClosed { input, face } => {
                Failure { input, ..at(GUSSET_ERROR_MESH_NOT_CLOSED, GUSSET_ELEMENT_FACE, face, 0.0) }
            }
            CutNotConnected { cut, place, vertex } => Failure {
                input: cut,
                ..at(GUSSET_ERROR_CUT_NOT_CONNECTED, GUSSET_ELEMENT_LOOP_PLACE, place, vertex.into())
            },
            NotFinite { element, index, value, .. } => {
                Failure::with_element(GUSSET_ERROR_NOT_FINITE, element_code(element), index, value)
            }
            BadWeight { index, value } => {
                Failure::with_element(GUSSET_ERROR_OUT_OF_RANGE, GUSSET_ELEMENT_NODE, index, value)
            }
            InputsDiffer { given, needed } => {
                Failure { value: needed as f64, ..count(GUSSET_ERROR_COUNT_DIFFERS, given) }
            }
            ValuesDiffer { input, given, needed } => {
                Failure { input, value: needed as f64, ..count(GUSSET_ERROR_COUNT_DIFFERS, given) }
            }
            BadValue { element, index, input, value } => {
                let status = if value.is_finite() { GUSSET_ERROR_OUT_OF_RANGE } else { GUSSET_ERROR_NOT_FINITE };
                Failure { input, ..Failure::with_element(status, element_code(element), index, value) }
            }
            CoordinateTooLarge { element, index, value, .. } => {
                Failure::with_element(GUSSET_ERROR_OUT_OF_RANGE, element_code(element), index, value)
            }
            NoSuch { element, index, .. } => {
                Failure::with_element(GUSSET_ERROR_NO_SUCH_ELEMENT, element_code(element), index, 0.0)
            }
            SectionsDiffer { section, count, .. } => {
                at(GUSSET_ERROR_SECTIONS_DIFFER, GUSSET_ELEMENT_SECTION, section, count.into())
            }
            NoNode { section, column } => at(GUSSET_ERROR_NO_NODE, GUSSET_ELEMENT_SECTION, section, column.into()),
            OnlyTips => at(GUSSET_ERROR_NO_NODE, GUSSET_ELEMENT_SECTION, 0, 0.0),
            RepeatedSection { section, earlier } => {
                at(GUSSET_ERROR_CURVES_APART, GUSSET_ELEMENT_SECTION, section, earlier.into())
            }
            CurveNotClosed => plain(GUSSET_ERROR_CURVE_NOT_CLOSED, 0.0),
            CurveNotPlane { point, z } => at(GUSSET_ERROR_CURVE_NOT_PLANE, GUSSET_ELEMENT_POINT, point, z),
            EmptyCurve => plain(GUSSET_ERROR_EMPTY_CURVE, 0.0),
            NoSuchPlace { index, t, .. } => at(GUSSET_ERROR_NO_SUCH_ELEMENT, GUSSET_ELEMENT_PLACE, index, t),
            BadConstraint { constraint, point } => {
                at(GUSSET_ERROR_NO_SUCH_ELEMENT, GUSSET_ELEMENT_CONSTRAINT, constraint, point.into())
            }
            MixedScalars => plain(GUSSET_ERROR_MIXED_SCALARS, 0.0),
            NoLoop { .. } => plain(GUSSET_ERROR_NO_LOOP, 0.0),
            NoPairOfLoops { count } => plain(GUSSET_ERROR_NO_LOOP, count.into()),
            LoopTooShort { count: n, .. } => count(GUSSET_ERROR_LOOP_TOO_SHORT, n.into()),
            LoopRepeatsVertex { vertex, .. } => {
                at(GUSSET_ERROR_LOOP_REPEATS_VERTEX, GUSSET_ELEMENT_VERTEX, vertex, 0.0)
            }
            LoopEdgeNotFree { place, vertex, .. } => {
                at(GUSSET_ERROR_LOOP_EDGE_NOT_FREE, GUSSET_ELEMENT_LOOP_PLACE, place, vertex.into())
            }
            LoopIndexOutOfRange { number, place, vertex, .. } => Failure {
                input: number,
                ..at(GUSSET_ERROR_INDEX_OUT_OF_RANGE, GUSSET_ELEMENT_LOOP_PLACE, place, vertex.into())
            },
            LoopsShareVertex { vertex } => at(GUSSET_ERROR_LOOPS_SHARE_VERTEX, GUSSET_ELEMENT_VERTEX, vertex, 0.0),
            PlanesUndecided { .. } => plain(GUSSET_ERROR_PLANES_UNDECIDED, 0.0),
            LoopNotOriented { face, .. } => at(GUSSET_ERROR_LOOP_NOT_ORIENTED, GUSSET_ELEMENT_FACE, face, 0.0),
            OrientationConflict { face } => at(GUSSET_ERROR_ORIENTATION_CONFLICT, GUSSET_ELEMENT_FACE, face, 0.0),
            NoStrip { vertex } => at(GUSSET_ERROR_NO_STRIP, GUSSET_ELEMENT_VERTEX, vertex, 0.0),
            NetTooSmall { rows, columns } => count(GUSSET_ERROR_NET_TOO_SMALL, rows.min(columns)),
            CrossingCell { cell } => at(GUSSET_ERROR_CROSSING_CELL, GUSSET_ELEMENT_CELL, cell, 0.0),
            BadSeam { seam } => at(GUSSET_ERROR_BAD_SEAM, GUSSET_ELEMENT_SEAM, seam, 0.0),
            SidesDiffer { a, b } => at(GUSSET_ERROR_SIDES_DIFFER, GUSSET_ELEMENT_COUNT, a, b.into()),
            SidesApart { place, distance } => at(GUSSET_ERROR_SIDES_DIFFER, GUSSET_ELEMENT_SIDE_PLACE, place, distance),
            WrongKnotCount { given, .. } => count(GUSSET_ERROR_BAD_KNOTS, given),
            BadKnot { knot, value, .. } => at(GUSSET_ERROR_BAD_KNOTS, GUSSET_ELEMENT_KNOT, knot, value),
            CurvesApart { row, distance, .. } => at(GUSSET_ERROR_CURVES_APART, GUSSET_ELEMENT_ROW, row, distance),
            CurvesOutOfOrder { row, .. } => at(GUSSET_ERROR_CURVES_APART, GUSSET_ELEMENT_ROW, row, 0.0),
            NetsOpposed => plain(GUSSET_ERROR_ORIENTATION_CONFLICT, 0.0),
            NoGrid { face } => at(GUSSET_ERROR_NO_GRID, GUSSET_ELEMENT_FACE, face, 0.0),
            BadStream { byte, .. } => Failure::with_element(GUSSET_ERROR_BAD_STREAM, GUSSET_ELEMENT_BYTE, byte, 0.0),
            SceneCycle { entry } => at(GUSSET_ERROR_SCENE_CYCLE, GUSSET_ELEMENT_ENTRY, entry, 0.0),
            EmptyScene => plain(GUSSET_ERROR_EMPTY_SCENE, 0.0),
            FieldUndefined { node } => at(GUSSET_ERROR_FIELD_UNDEFINED, GUSSET_ELEMENT_NODE, node, 0.0),
            NodeOutsideBox { node } => at(GUSSET_ERROR_OUT_OF_RANGE, GUSSET_ELEMENT_NODE, node, 0.0),
            GluedInside => plain(GUSSET_ERROR_GLUED_INSIDE, 0.0),
            BadWings { edge, .. } => Failure::with_element(GUSSET_ERROR_BAD_WINGS, GUSSET_ELEMENT_EDGE, edge, 0.0),
            GluingsDiffer { node } => at(GUSSET_ERROR_GLUINGS_DIFFER, GUSSET_ELEMENT_NODE, node, 0.0),
            BadLine { line: item, value, .. } | SheetOutOfRange { sheet: item, value } => {
                Failure::with_element(GUSSET_ERROR_OUT_OF_RANGE, GUSSET_ELEMENT_ITEM, item, value)
            }
            NotRigid { pose } => at(GUSSET_ERROR_OUT_OF_RANGE, GUSSET_ELEMENT_ITEM, pose, 0.0),
            InputCount { given, .. } => plain(GUSSET_ERROR_OUT_OF_RANGE, given as f64),
            InputUnfit { input, .. } | CurveCount { input, .. } => plain(GUSSET_ERROR_OUT_OF_RANGE, input.into()),
            BadLoopPair { pair, piece, vertex, fault, .. } => {
                let value = if fault == LoopPairFault::NoPiece { piece } else { vertex };
                at(GUSSET_ERROR_OUT_OF_RANGE, GUSSET_ELEMENT_ITEM, pair, value.into())
            }
            BadProperty { bridge, value, .. } => at(GUSSET_ERROR_OUT_OF_RANGE, GUSSET_ELEMENT_BRIDGE, bridge, value),
            OptionOutOfRange { value, .. } => plain(GUSSET_ERROR_OUT_OF_RANGE, value),
            OutOfMemory { bytes } => count(GUSSET_ERROR_OUT_OF_MEMORY, bytes),
            Cancelled => plain(GUSSET_ERROR_CANCELLED, 0.0),
        };
        let input = error.side().map_or(failure.input, |side| u32::from(side == Side::B));
        Failure { message: error.to_string().into(), input, ..failure }
    }
}

/// Describes a status in English.
///
/// @param status an unknown one gives "unknown status".
/// @return a static string, never NULL.
/// @complexity O(1).
#[unsafe(no_mangle)]
pub extern "C" fn gusset_status_text(status: i32) -> *const c_char {
    status_text(status).as_ptr()
}

/// Describes a value of a choice in an English sentence.
///
/// @param choice name of the type, such as "gusset_hole_status".
/// @param value its constant.
/// @return a static UTF-8 string, never NULL: the comment's first sentence, or "unknown value".
/// @complexity O(number of choices).
#[unsafe(no_mangle)]
pub unsafe extern "C" fn gusset_choice_text(choice: *const c_char, value: u32) -> *const c_char {
    let of_choice = || {
        // SAFETY: the caller gives a text that ends with a NUL, or NULL.
        let choice = (!choice.is_null()).then(|| unsafe { CStr::from_ptr(choice) })?.to_str().ok()?;
        choice_text(choice, value)
    };
    of_choice().unwrap_or(c"unknown value").as_ptr()
}
