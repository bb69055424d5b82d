//! What can go wrong, one variant for each cause, each naming the element it is about.

use std::fmt;

/// Which of two pieces an error is about.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Side {
    /// The first piece.
    A,
    /// The second piece.
    B,
}

impl fmt::Display for Side {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Side::A => "A",
            Side::B => "B",
        })
    }
}

/// The causes of failure. Indices count from 0 and refer to the caller's own arrays.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Error {
    /// A count is above the limit of this version.
    TooLarge {
        /// What is counted.
        what: &'static str,
        /// The count asked for.
        count: u64,
        /// The largest count accepted.
        limit: u64,
    },
    /// The bytes of an array, count times stride, exceed what the machine can address.
    SizeOverflow {
        /// Which array.
        what: &'static str,
        /// Its element count.
        count: u64,
    },
    /// An array has fewer bytes than its count and stride need.
    ArrayTooShort {
        /// Which array.
        what: &'static str,
        /// Bytes needed.
        needed: u64,
        /// Bytes given.
        given: u64,
    },
    /// The distance between positions is smaller than one position.
    StrideTooSmall {
        /// The stride given, in bytes.
        stride: u64,
        /// The least stride, in bytes.
        least: u64,
    },
    /// A mesh without vertices or without faces.
    EmptyMesh {
        /// `"vertices"` or `"faces"`.
        what: &'static str,
    },
    /// Offsets, of faces, outlines or segments, that do not start at 0, decrease, or end elsewhere than their elements.
    BadOffsets {
        /// The first offending entry.
        entry: u32,
        /// Its value.
        value: u32,
    },
    /// A face of fewer than three corners.
    FaceTooSmall {
        /// The face.
        face: u32,
        /// Its corner count.
        corners: u32,
    },
    /// A face names a vertex that does not exist.
    IndexOutOfRange {
        /// The face.
        face: u32,
        /// The corner: the position in the corner array.
        corner: u32,
        /// The vertex index found there.
        vertex: u32,
    },
    /// A vertex used by a face has a coordinate that is NaN or infinite.
    NotFinite {
        /// The vertex.
        vertex: u32,
        /// The coordinate.
        value: f64,
    },
    /// A point of a loop has a coordinate that is NaN or infinite.
    PointNotFinite {
        /// The loop.
        side: Side,
        /// The place of the point.
        place: u32,
        /// The coordinate.
        value: f64,
    },
    /// A point of an outline or a curve, or a tangent there, has a coordinate that is NaN or infinite.
    OutlineNotFinite {
        /// The point, counted over all outlines.
        point: u32,
        /// The coordinate.
        value: f64,
    },
    /// A point that was asked about has a coordinate that is NaN or infinite.
    QueryNotFinite {
        /// Its number.
        query: u32,
        /// The coordinate.
        value: f64,
    },
    /// A section of a frame has another number of points than the first one.
    SectionsDiffer {
        /// The section.
        section: u32,
        /// Its number of points.
        count: u32,
        /// That of the first one.
        expected: u32,
    },
    /// A section of a frame, or a plane, has no node on a column: they do not meet, or the section is no curve.
    NoNode {
        /// The section, or the plane.
        section: u32,
        /// The column.
        column: u32,
    },
    /// A closed curve does not end where it begins.
    CurveNotClosed,
    /// A plane curve is asked for, and a control point has z other than 0.
    CurveNotPlane {
        /// The control point.
        point: u32,
    },
    /// A curve without segments, or without points, where one is needed.
    EmptyCurve,
    /// There is no such place on the curve.
    NoSuchPlace {
        /// Which of the places given.
        index: u32,
        /// Its segment.
        segment: u32,
        /// Its parameter.
        t: f64,
    },
    /// A constraint names a point that does not exist, or that the one before it names or passes.
    NoSuchPoint {
        /// The constraint.
        constraint: u32,
        /// The point.
        point: u32,
    },
    /// The second mesh has `f64` positions and the first `f32`: the result, in the first one's type, would round them.
    MixedScalars,
    /// There is no boundary loop that could be stitched.
    NoLoop {
        /// The piece without one.
        side: Side,
    },
    /// A loop of fewer than three vertices.
    LoopTooShort {
        /// The piece.
        side: Side,
        /// The number of vertices given.
        count: u32,
    },
    /// A loop passes a vertex twice.
    LoopRepeatsVertex {
        /// The piece.
        side: Side,
        /// The vertex.
        vertex: u32,
    },
    /// Two consecutive loop vertices are not the ends of a free edge: an edge with exactly one face.
    LoopEdgeNotFree {
        /// The piece.
        side: Side,
        /// The place in the loop where the edge starts.
        place: u32,
        /// The vertex at that place (it may be out of range, which is one way not to be on a free edge).
        vertex: u32,
    },
    /// Both loops pass the same vertex of the same mesh.
    LoopsShareVertex {
        /// The vertex.
        vertex: u32,
    },
    /// No vertex of a loop is clearly on the other loop's side of the plane through its centre, or the centres coincide: the
    /// paper's planes cannot tell which vertices face each other. Such loops are joined whole.
    PlanesUndecided {
        /// The loop.
        side: Side,
    },
    /// The faces along one loop disagree in orientation.
    LoopNotOriented {
        /// The piece.
        side: Side,
        /// A face that runs against most others.
        face: u32,
    },
    /// The second piece is oriented against the first, and the options refuse to turn it over.
    OrientationConflict {
        /// A face of the second piece.
        face: u32,
    },
    /// Every strip through the first meridian, or the strip of the chosen rule, would use an edge twice that the mesh already
    /// has.
    NoStrip {
        /// The vertex of the first loop where the rule's meridian starts, if one is to blame.
        vertex: u32,
    },
    /// A net of fewer than two rows or columns.
    NetTooSmall {
        /// The rows given.
        rows: u64,
        /// The columns given.
        columns: u64,
    },
    /// A gluing makes both pairs of opposite corners of a cell one each: no surface does that.
    CrossingCell {
        /// The first such cell.
        cell: u32,
    },
    /// A seam without nodes, or with nodes outside the net.
    BadSeam {
        /// The seam.
        seam: u32,
    },
    /// There is no such node.
    NoSuchNode {
        /// Its index.
        node: u64,
    },
    /// There is no such link.
    NoSuchLink {
        /// Its index.
        link: u64,
    },
    /// There is no such cell.
    NoSuchCell {
        /// Its index.
        cell: u64,
    },
    /// There is no such bridge.
    NoSuchBridge {
        /// Its index.
        bridge: u64,
    },
    /// A node has a coordinate that is NaN or infinite, where all must be finite.
    NodeNotFinite {
        /// The node.
        node: u32,
        /// The coordinate.
        value: f64,
    },
    /// Sides of nets that are to be joined have different numbers of nodes, and the options refuse to equalise them.
    SidesDiffer {
        /// Nodes of the first net's side.
        a: u32,
        /// Nodes of the second net's.
        b: u32,
    },
    /// Sides of nets that are to be welded do not lie on each other.
    SidesApart {
        /// The place along the side.
        place: u32,
        /// How far the two nodes there are apart.
        distance: f64,
    },
    /// A direction of a spline has another number of knots than its control points and degree need.
    WrongKnotCount {
        /// 0 for u, 1 for v.
        direction: u32,
        /// The knots given.
        given: u64,
        /// The knots needed.
        needed: u64,
    },
    /// A knot of a spline is not finite, less than the one before, or repeated too often; or the spline has no range.
    BadKnot {
        /// 0 for u, 1 for v.
        direction: u32,
        /// The knot.
        knot: u32,
        /// Its value.
        value: f64,
    },
    /// A row and a column of a net of curves do not meet.
    CurvesApart {
        /// The row.
        row: u32,
        /// The column.
        column: u32,
        /// How far they are apart where they are nearest.
        distance: f64,
    },
    /// A curve of a net meets the others in another order than they are given in.
    CurvesOutOfOrder {
        /// The row at the first crossing out of order.
        row: u32,
        /// The column.
        column: u32,
    },
    /// There is no such place on the surface.
    NoSuchSurfacePlace {
        /// Which of the places given.
        index: u64,
    },
    /// Two nets cannot be joined, as faces of the one are to be taken the other way round.
    NetsOpposed,
    /// Faces of a mesh are no rectangular grid of quads.
    NoGrid {
        /// The first face that shows it.
        face: u32,
    },
    /// A stream is damaged, cut off, or none of ours.
    BadStream {
        /// What is wrong.
        what: &'static str,
        /// Where: the byte.
        byte: u64,
    },
    /// A group of a scene would contain itself.
    SceneCycle {
        /// The entry.
        entry: u32,
    },
    /// There is no such entry in the scene, or it is of the other kind.
    NoSuchEntry {
        /// Its index.
        entry: u64,
    },
    /// A scene without nets, where one is needed.
    EmptyScene,
    /// A field of deformation is not defined at a node: the centre of a sphere, the plane of the eye of a projection.
    FieldUndefined {
        /// The first such node.
        node: u32,
    },
    /// A net is glued elsewhere than along whole sides, or has bridges: rows and columns cannot be added or left out evenly.
    GluedInside,
    /// A line is not finite, has no direction, or ends before it begins.
    BadLine {
        /// Which of the lines given.
        line: u64,
        /// The number that is wrong.
        value: f64,
    },
    /// The greatest absolute coordinate of a sheet is too large or too small for a carcass.
    SheetOutOfRange {
        /// Which of the sheets given.
        sheet: u64,
        /// The coordinate, or infinity.
        value: f64,
    },
    /// A filter takes another number of inputs.
    InputCount {
        /// How many there are.
        given: u64,
        /// The least number.
        least: u64,
        /// The greatest number.
        most: u64,
    },
    /// An input is not such as a filter takes.
    InputUnfit {
        /// Which of the inputs.
        input: u32,
        /// What is needed.
        why: &'static str,
    },
    /// An option is outside its range.
    OptionOutOfRange {
        /// The option's name.
        option: &'static str,
        /// Its value.
        value: f64,
    },
    /// Memory for an array could not be had.
    OutOfMemory {
        /// Bytes asked for.
        bytes: u64,
    },
    /// The host asked to stop.
    Cancelled,
}

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

impl std::error::Error for Error {}

impl Error {
    /// Which of two pieces it is about, if it is about one of two.
    pub fn side(&self) -> Option<Side> {
        match *self {
            Error::PointNotFinite { side, .. }
            | Error::NoLoop { side }
            | Error::LoopTooShort { side, .. }
            | Error::LoopRepeatsVertex { side, .. }
            | Error::LoopEdgeNotFree { side, .. }
            | Error::PlanesUndecided { side }
            | Error::LoopNotOriented { side, .. } => Some(side),
            Error::MixedScalars | Error::OrientationConflict { .. } | Error::NetsOpposed => Some(Side::B),
            _ => None,
        }
    }
}

/// The result type of the library.
pub type Result<T> = std::result::Result<T, Error>;
