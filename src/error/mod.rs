//! What can go wrong, one variant for each cause, each naming the element it is about.

mod text;

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
    /// The greatest absolute coordinate of a sheet is too large or too small for a surface.
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
