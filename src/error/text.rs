//! What errors say: one sentence for each cause, with the numbers that it was about.

use super::Error;
use std::fmt;

/// A number in a message: with an exponent where it would have many digits before or after the point.
struct Number(f64);

impl fmt::Display for Number {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let value = self.0;
        if value == 0.0 || !value.is_finite() || (1e-4..1e9).contains(&value.abs()) {
            write!(f, "{value}")
        } else {
            write!(f, "{value:e}")
        }
    }
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Error::TooLarge { what, count, limit } => {
                write!(f, "{count} {what}: this version takes at most {limit}")
            }
            Error::SizeOverflow { what, count } => {
                write!(f, "{count} {what} exceed the address space")
            }
            Error::ArrayTooShort { what, needed, given } => {
                write!(f, "the array of {what} needs {needed} bytes and has {given}")
            }
            Error::StrideTooSmall { stride, least } => {
                write!(f, "a position stride of {stride} bytes: one position takes {least}")
            }
            Error::EmptyMesh { what } => write!(f, "the mesh has no {what}"),
            Error::BadOffsets { entry: 0, value } => {
                write!(f, "offset 0 is {value} instead of 0")
            }
            Error::BadOffsets { entry, value } => {
                write!(f, "offset {entry} is {value}, which is out of order or out of range")
            }
            Error::FaceTooSmall { face, corners } => {
                write!(f, "face {face} has {corners} corners; it needs three")
            }
            Error::IndexOutOfRange { face, corner, vertex } => {
                write!(f, "face {face}, corner {corner}: there is no vertex {vertex}")
            }
            Error::NotFinite { vertex, value } => {
                write!(f, "vertex {vertex} has a coordinate that is {value}")
            }
            Error::PointNotFinite { side, place, value } => {
                write!(f, "point {place} of loop {side} has a coordinate that is {value}")
            }
            Error::QueryNotFinite { query, value } => write!(f, "query {query} has a coordinate that is {value}"),
            Error::OutlineNotFinite { point, value } => {
                write!(f, "point {point}, or a tangent there, has a coordinate that is {value}")
            }
            Error::SectionsDiffer { section, count, expected } => {
                write!(f, "section {section} has {count} points and the first one {expected}")
            }
            Error::NoNode { section, column } => {
                write!(f, "section {section} has no node in column {column}")
            }
            Error::CurveNotClosed => f.write_str("a closed curve ends where it begins; this one does not"),
            Error::CurveNotPlane { point } => write!(f, "control point {point} is not in the plane z = 0"),
            Error::EmptyCurve => f.write_str("the curve is empty"),
            Error::NoSuchPlace { index, segment, t } => {
                write!(f, "place {index}: there is no segment {segment} with parameter {}", Number(t))
            }
            Error::NoSuchPoint { constraint, point } => {
                write!(f, "constraint {constraint} is on point {point}, which does not exist or comes earlier")
            }
            Error::MixedScalars => f.write_str(
                "the inputs have coordinates of different types, where the result would round those of one: convert it",
            ),
            Error::NoLoop { side } => {
                write!(f, "mesh {side} has no boundary loop that can be stitched")
            }
            Error::LoopTooShort { side, count } => {
                write!(f, "loop {side} has {count} vertices; it needs three")
            }
            Error::LoopRepeatsVertex { side, vertex } => {
                write!(f, "loop {side} passes vertex {vertex} twice")
            }
            Error::LoopEdgeNotFree { side, place, vertex } => write!(
                f,
                "loop {side}: the edge that leaves place {place} (vertex {vertex}) is no free edge of the mesh"
            ),
            Error::LoopsShareVertex { vertex } => write!(f, "both loops pass vertex {vertex}"),
            Error::PlanesUndecided { side } => {
                write!(
                    f,
                    "no vertex of loop {side} is clearly on the other loop's side of the plane through its centre"
                )
            }
            Error::LoopNotOriented { side, face } => {
                write!(f, "the faces along loop {side} disagree in orientation, face {face} among them")
            }
            Error::OrientationConflict { face } => {
                write!(f, "piece B (face {face} and the rest) is oriented against piece A")
            }
            Error::NoStrip { vertex } => {
                write!(f, "no strip between the loops avoids the edges that the mesh already has (vertex {vertex})")
            }
            Error::NetTooSmall { rows, columns } => {
                write!(f, "{rows} rows and {columns} columns of nodes: a net has two of each at least")
            }
            Error::CrossingCell { cell } => {
                write!(f, "cell {cell}: both pairs of opposite corners would be glued, which no surface allows")
            }
            Error::BadSeam { seam } => write!(f, "seam {seam} is empty or leaves the net"),
            Error::NoSuchNode { node } => write!(f, "there is no node {node}"),
            Error::NoSuchLink { link } => write!(f, "there is no link {link}"),
            Error::NoSuchCell { cell } => write!(f, "there is no cell {cell}"),
            Error::NoSuchBridge { bridge } => write!(f, "there is no bridge {bridge}"),
            Error::NodeNotFinite { node, value } => write!(f, "node {node} has a coordinate that is {value}"),
            Error::SidesDiffer { a, b } => write!(f, "the sides to be joined have {a} and {b} nodes"),
            Error::SidesApart { place, distance } => {
                write!(f, "the sides to be welded are {} apart at place {place}", Number(distance))
            }
            Error::WrongKnotCount { direction, given, needed } => {
                write!(f, "direction {direction} has {given} knots; its control points and degree need {needed}")
            }
            Error::BadKnot { direction, knot, value } => {
                write!(
                    f,
                    "knot {knot} of direction {direction}, {}, is out of order or repeated too often",
                    Number(value)
                )
            }
            Error::CurvesApart { row, column, distance } => {
                let distance = Number(distance);
                write!(f, "row {row} and column {column} of the net are {distance} apart where they are nearest")
            }
            Error::CurvesOutOfOrder { row, column } => {
                write!(f, "row {row} and column {column} of the net meet out of order")
            }
            Error::NoSuchSurfacePlace { index } => write!(f, "place {index} is not on the surface"),
            Error::NetsOpposed => {
                f.write_str("faces of the second net are taken the other way round than those of the first: flip it")
            }
            Error::NoGrid { face } => write!(f, "the faces are no rectangular grid of quads, face {face} among them"),
            Error::BadStream { what, byte } => write!(f, "the stream is damaged at byte {byte}: {what}"),
            Error::SceneCycle { entry } => write!(f, "entry {entry} of the scene would contain itself"),
            Error::NoSuchEntry { entry } => write!(f, "the scene has no entry {entry} of this kind"),
            Error::EmptyScene => f.write_str("the scene has no nets"),
            Error::FieldUndefined { node } => {
                write!(f, "at node {node} the field is not defined, or what it gives is too large")
            }
            Error::GluedInside => f.write_str("the net is glued elsewhere than along whole sides, or has bridges"),
            Error::BadLine { line, value } => {
                write!(f, "line {line} is not finite, has no direction, or ends before it begins: {}", Number(value))
            }
            Error::SheetOutOfRange { sheet, value } => {
                let value = Number(value);
                write!(f, "sheet {sheet}: its greatest coordinate, {value}, is not 0 nor from 1e-30 to 1e37")
            }
            Error::InputCount { given, least, most } => {
                write!(f, "the number of inputs is {given}, and the filter takes ")?;
                if least == most { write!(f, "{least}") } else { write!(f, "{least} to {most}") }
            }
            Error::InputUnfit { input, why } => write!(f, "input {input}: {why}"),
            Error::OptionOutOfRange { option, value } => {
                write!(f, "option {option} is out of range: {}", Number(value))
            }
            Error::OutOfMemory { bytes } => write!(f, "{bytes} bytes of memory could not be had"),
            Error::Cancelled => f.write_str("cancelled by the host"),
        }
    }
}
