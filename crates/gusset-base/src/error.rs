//! Causes of failure: a variant for each kind of cause, with its text and the element that it is
//! about.
//!
//! `src/capi/status.rs` of the root package gives each of them a number for C.

pub use crate::error_subject::{Element, PairFault, Side};
use std::fmt;

/// A number in a message: with an exponent where it would have many digits before or after the
/// point.
struct Number<'a>(&'a f64);

impl fmt::Display for Number<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let value = *self.0;
        if value == 0.0 || !value.is_finite() || (1e-4..1e9).contains(&value.abs()) {
            write!(f, "{value}")
        } else {
            write!(f, "{value:e}")
        }
    }
}

/// The causes of failure. Indices count from 0 and refer to the caller's own arrays.
#[allow(missing_docs, reason = "the texts say what the fields are")]
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum Error {
    /// A count is above the limit of this version.
    #[error("there are {count} {what}, and at most {limit} are taken")]
    TooLarge {
        /// What is counted.
        what: &'static str,
        count: u64,
        limit: u64,
    },
    /// The bytes of an array, count times stride, exceed what the machine can address.
    #[error("{count} {what} exceed the address space")]
    SizeOverflow {
        /// Which array.
        what: &'static str,
        count: u64,
    },
    /// An array has fewer bytes than its count and stride need.
    #[error("the array of {what} needs {needed} bytes and has {given}")]
    ArrayTooShort {
        /// Which array.
        what: &'static str,
        needed: u64,
        given: u64,
    },
    /// The distance between elements is smaller than one element.
    #[error("a stride of {stride} bytes: one element takes {min}")]
    StrideTooSmall {
        /// The stride given, in bytes.
        stride: u64,
        min: u64,
    },
    /// A mesh without vertices or without faces, or no mesh at all.
    #[error("{}", if *.what == "pieces" { "no pieces were given".to_owned() } else { format!("there are no {what}") })]
    EmptyMesh {
        /// What there are none of, in the plural.
        what: &'static str,
    },
    /// Offsets, of faces, outlines or segments, that do not start at 0, decrease, or end elsewhere
    /// than their elements.
    #[error("offset {entry} is {value}{}", if *.entry == 0 && *.value != 0 { " instead of 0" } else { ": offsets must not fall, and the last is the number of elements" })]
    BadOffsets {
        /// The first offending entry.
        entry: u32,
        value: u32,
    },
    /// A face of fewer than three corners.
    #[error("face {face} has {corners} corners; it needs three")]
    FaceTooSmall { face: u32, corners: u32 },
    /// A face names a vertex that does not exist.
    #[error("face {face}, corner {corner}: there is no vertex {vertex}")]
    IndexOutOfRange {
        face: u32,
        /// The corner: the position in the corner array.
        corner: u32,
        vertex: u32,
    },
    /// A face passes a vertex twice, where each face needs a shape.
    #[error("face {face} passes vertex {vertex} twice")]
    RepeatedCorner { face: u32, vertex: u32 },
    /// Two vertices that follow one another in a cut are not connected by edges.
    #[error("cut {cut}, place {place}: no edges connect vertex {vertex} with the one before it")]
    CutNotConnected {
        /// Which of the cuts given.
        cut: u32,
        /// The place in the cut.
        place: u32,
        vertex: u32,
    },
    /// A merge map leads to a vertex that does not exist, or to one that is not one with itself.
    #[error("vertex {vertex} is said to be one with vertex {value}, which does not exist or is one with another")]
    BadMerge { vertex: u32, value: u32 },
    /// An element has a coordinate that is NaN or infinite: a vertex that a face uses, a point, the
    /// tangent of a constraint, a node.
    #[error("{element} {index} has a coordinate that is {}", Number(.value))]
    NotFinite { element: Element, index: u64, value: f64 },
    /// Values are given for another number of inputs than there are.
    #[error("values of {given} inputs are given, of {needed} are needed")]
    InputsDiffer { given: u64, needed: u64 },
    /// An input has another number of elements than values are given for.
    #[error("input {input} has {needed} elements, and values of {given} are given")]
    ValuesDiffer { input: u32, given: u64, needed: u64 },
    /// A value that is NaN or infinite, or a share that is negative.
    #[error("{element} {index} of input {input} has the value {}", Number(.value))]
    BadValue { element: Element, index: u64, input: u32, value: f64 },
    /// An element has a coordinate whose square would overflow.
    #[error("{element} {index} has a coordinate beyond 1e150: {}", Number(.value))]
    CoordinateTooLarge { element: Element, index: u64, value: f64 },
    /// A section of a frame has another number of points than the first one.
    #[error("section {section} has {count} points and the first one {expected}")]
    SectionsDiffer {
        section: u32,
        count: u32,
        /// That of the first one.
        expected: u32,
    },
    /// A section of a frame, or a plane, has no node on a column: they do not meet, or the section
    /// is no curve.
    #[error("section {section} has no node in column {column}")]
    NoNode {
        /// The section, or the plane.
        section: u32,
        column: u32,
    },
    /// A closed curve does not end where it begins.
    #[error("a closed curve ends where it begins; this one does not")]
    CurveNotClosed,
    /// A plane curve is asked for, and a control point has z other than 0.
    #[error("control point {point} is not in the plane z = 0")]
    CurveNotPlane { point: u32 },
    /// A curve without segments, or without points, where one is needed.
    #[error("the curve is empty")]
    EmptyCurve,
    /// There is no such place on the curve.
    #[error("place {index}: there is no segment {segment} with parameter {}", Number(.t))]
    NoSuchPlace {
        /// Which of the places given.
        index: u32,
        segment: u32,
        t: f64,
    },
    /// A constraint names a point that does not exist, or that the one before it names or passes.
    #[error("constraint {constraint} is on point {point}, which does not exist or comes earlier")]
    BadConstraint { constraint: u32, point: u32 },
    /// The second mesh has `f64` positions and the first `f32`: the result, in the first one's
    /// type, would round them.
    #[error("the inputs have coordinates of different types, where the result would round those of one: convert it")]
    MixedScalars,
    /// There is no boundary loop that could be stitched.
    #[error("there is no boundary loop {side} that can be stitched")]
    NoLoop { side: Side },
    /// Two loops of one mesh are to be stitched, and it has no two.
    #[error("the mesh has {count} boundary loop{} that can be stitched; two without a common vertex are needed", if *.count == 1 { "" } else { "s" })]
    NoPairOfLoops { count: u32 },
    /// A loop of fewer than three vertices, or a polyline without points.
    #[error("loop {side} has {count} vertices; {}", if *.count == 0 { "it needs some" } else { "it needs three" })]
    LoopTooShort { side: Side, count: u32 },
    /// A loop passes a vertex twice.
    #[error("loop {side} passes vertex {vertex} twice")]
    LoopRepeatsVertex { side: Side, vertex: u32 },
    /// Two consecutive loop vertices are not the ends of a free edge: an edge with exactly one
    /// face.
    #[error("loop {side}: the edge that leaves place {place} (vertex {vertex}) is no free edge of the mesh")]
    LoopEdgeNotFree {
        side: Side,
        /// The place in the loop where the edge starts.
        place: u32,
        /// The vertex at that place.
        vertex: u32,
    },
    /// A loop passes a vertex that does not exist.
    #[error("loop {number}, place {place}: there is no vertex {vertex}")]
    LoopIndexOutOfRange {
        /// The number of the loop among those given.
        number: u32,
        /// The place in the loop.
        place: u32,
        vertex: u32,
    },
    /// Both loops pass the same vertex of the same mesh.
    #[error("both loops pass vertex {vertex}")]
    LoopsShareVertex { vertex: u32 },
    /// No vertex of a loop is clearly on the other loop's side of the plane through its centre, or
    /// the centres coincide: the paper's planes cannot tell which vertices face each other. Such
    /// loops are joined whole.
    #[error("no vertex of loop {side} is clearly on the other loop's side of the plane through its centre")]
    PlanesUndecided { side: Side },
    /// The faces along one loop disagree in orientation.
    #[error("the faces along loop {side} disagree in orientation, face {face} among them")]
    LoopNotOriented {
        side: Side,
        /// A face that runs against most others.
        face: u32,
    },
    /// The second piece is oriented against the first, and the options refuse to turn it over.
    #[error("what loop B bounds (face {face} and the rest) is oriented against what loop A bounds")]
    OrientationConflict {
        /// A face on the second loop.
        face: u32,
    },
    /// Every strip through the first meridian, or the strip of the chosen rule, would use an edge
    /// twice that the mesh already has.
    #[error("no strip between the loops avoids the edges that the mesh already has (vertex {vertex})")]
    NoStrip {
        /// The vertex of the first loop where the rule's meridian starts, if one is to blame.
        vertex: u32,
    },
    /// A net of fewer than two rows or columns.
    #[error("{rows} rows and {columns} columns of nodes: a net has two of each at least, a closed surface four")]
    NetTooSmall { rows: u64, columns: u64 },
    /// A gluing makes both pairs of opposite corners of a cell one each: no surface does that.
    #[error("cell {cell}: both pairs of opposite corners would be glued, which no surface allows")]
    CrossingCell {
        /// The first such cell.
        cell: u32,
    },
    /// A seam without nodes, with nodes outside the net, or of one pair again and again.
    #[error("seam {seam} is empty, leaves the net, or repeats one pair of nodes")]
    BadSeam { seam: u32 },
    /// An element that does not exist, or that is of another kind.
    #[error("there is no {element} {index}{}", if *.element == Element::Entry { " of this kind" } else { "" })]
    NoSuch { element: Element, index: u64 },
    /// Sides of nets that are to be joined have different numbers of nodes, and the options refuse
    /// to equalise them.
    #[error("the sides have {a} and {b} nodes")]
    SidesDiffer {
        /// Nodes of the first net's side.
        a: u32,
        b: u32,
    },
    /// Sides that are to coincide, of nets that are welded or of a closed sheet, do not.
    #[error("sides that are to coincide are {} apart at place {place}", Number(.distance))]
    SidesApart { place: u32, distance: f64 },
    /// A direction of a spline has another number of knots than its control points and degree need.
    #[error("direction {direction} has {given} knots; its control points and degree need {needed}")]
    WrongKnotCount {
        /// 0 for u, 1 for v.
        direction: u32,
        given: u64,
        needed: u64,
    },
    /// A knot of a spline is not finite, less than the one before, or repeated too often; or the
    /// spline has no range, or a span that is too short to be cut where that is needed.
    #[error("knot {knot} of direction {direction}, {}, is out of order, repeated too often, or begins a span too short to cut", Number(.value))]
    BadKnot {
        /// 0 for u, 1 for v.
        direction: u32,
        knot: u32,
        value: f64,
    },
    /// A weight of a rational spline is not finite, not positive, or below 2^-900 of the greatest.
    #[error("the weight of control point {index} is {}; weights are finite and above 0", Number(.value))]
    BadWeight { index: u64, value: f64 },
    /// A row and a column of a net of curves do not meet.
    #[error("row {row} and column {column} of the net are {} apart where they are nearest", Number(.distance))]
    CurvesApart {
        row: u32,
        column: u32,
        /// How far they are apart where they are nearest.
        distance: f64,
    },
    /// A curve of a net meets the others in another order than they are given in.
    #[error("row {row} and column {column} of the net meet out of order")]
    CurvesOutOfOrder {
        /// The row at the first crossing out of order.
        row: u32,
        column: u32,
    },
    /// Two nets cannot be joined, as faces of the one are to be taken the other way round.
    #[error("faces of the second net are taken the other way round than those of the first: flip it")]
    NetsOpposed,
    /// Faces of a mesh are no rectangular grid of quads, or triangles no such grid with diagonals.
    #[error("the faces are no rectangular grid of quads, whole or as two triangles each, face {face} among them")]
    NoGrid {
        /// The first face that shows it.
        face: u32,
    },
    /// A stream is damaged, cut off, or none of ours.
    #[error("the stream cannot be read at byte {byte}: {what}")]
    BadStream { what: &'static str, byte: u64 },
    /// A group of a scene would contain itself.
    #[error("entry {entry} of the scene would contain itself")]
    SceneCycle { entry: u32 },
    /// A scene without nets, where one is needed.
    #[error("the scene has no nets")]
    EmptyScene,
    /// A field of deformation is not defined at a node: the centre of a sphere, the plane of the
    /// eye of a projection.
    #[error("at node {node} the field is not defined, or what it gives is too large")]
    FieldUndefined {
        /// The first such node.
        node: u32,
    },
    /// A net is glued elsewhere than along whole sides, or has bridges: rows and columns cannot be
    /// added or left out evenly.
    #[error("the net is glued elsewhere than along whole sides, or has bridges")]
    GluedInside,
    /// Two nets that are to be glued in the same way are not.
    #[error("the nets are glued differently, first at node {node}")]
    GluingsDiffer {
        /// The first node that is one point with other nodes in the one than in the other.
        node: u32,
    },
    /// A line has an origin beyond 1e150, has no direction, or has no points between its ends.
    #[error("line {line} {why}{}", if *.value == 0.0 { String::new() } else { format!(": {}", Number(.value)) })]
    BadLine {
        line: u64,
        /// What is wrong with it, as the line's predicate.
        why: &'static str,
        /// The number that is wrong.
        value: f64,
    },
    /// A record of a winged-edge table fits no mesh.
    #[error("edge {edge}: {why}")]
    BadWings {
        edge: u64,
        /// What is wrong with it, as a sentence about the edge.
        why: &'static str,
    },
    /// The greatest absolute coordinate of a sheet is too large or too small for a surface.
    #[error("sheet {sheet}: its greatest coordinate, {}, is not 0 nor from 1e-30 to 1e37", Number(.value))]
    SheetOutOfRange {
        sheet: u64,
        /// The coordinate, or infinity.
        value: f64,
    },
    /// A filter takes another number of inputs.
    #[error("the number of inputs is {given}, and the filter takes {}", if .min == .max { min.to_string() } else { format!("{min} to {max}") })]
    InputCount { given: u64, min: u64, max: u64 },
    /// An input is not such as a filter takes.
    #[error("input {input}: {why}")]
    InputUnfit {
        input: u32,
        /// What is needed.
        why: &'static str,
    },
    /// A pair of loops that an option gives cannot be taken.
    #[error("pair {pair} of {option}: {}", .fault.text(*.piece, *.vertex))]
    BadLoopPair {
        option: &'static str,
        /// Its number among those given.
        pair: u32,
        /// Which of its loops is to blame.
        side: Side,
        /// The piece that is named there.
        piece: u32,
        /// The vertex that is named there.
        vertex: u32,
        fault: PairFault,
    },
    /// An option is outside its range.
    #[error("option {option} is out of range: {}", Number(.value))]
    OptionOutOfRange { option: &'static str, value: f64 },
    /// A property of a bridge is negative, NaN or infinite, or too large for the coordinates.
    #[error("bridge {bridge}: its {property} is {}", Number(.value))]
    BadProperty { bridge: u32, property: &'static str, value: f64 },
    /// A pose is no rotation and translation.
    #[error(
        "pose {pose} is no rotation and translation: it has a number that is not finite, scales, shears or mirrors"
    )]
    NotRigid { pose: u32 },
    /// Memory for an array could not be had.
    #[error("{bytes} bytes of memory could not be had")]
    OutOfMemory { bytes: u64 },
    /// The host asked to stop.
    #[error("the caller cancelled the call")]
    Cancelled,
}

impl Error {
    /// [`Error::NotFinite`], if a coordinate of an element is not.
    pub fn check_finite(element: Element, index: u64, p: glam::DVec3) -> Result<()> {
        match p.to_array().into_iter().find(|x| !x.is_finite()) {
            Some(value) => Err(Error::NotFinite { element, index, value }),
            None => Ok(()),
        }
    }

    /// [`Error::BadOffsets`] with the first of some offsets that does not fit: they start at 0, do
    /// not fall, and end with `count`.
    pub fn check_offsets(offsets: &[u32], count: usize) -> Result<()> {
        let bad = |entry: usize| {
            let value = offsets.get(entry).copied().unwrap_or(0);
            Err(Error::BadOffsets { entry: entry as u32, value })
        };
        if offsets.first() != Some(&0) {
            return bad(0);
        }
        if let Some(k) = (1..offsets.len()).find(|&k| offsets[k] < offsets[k - 1] || offsets[k] as usize > count) {
            return bad(k);
        }
        let last = offsets.len() - 1;
        if offsets[last] as usize == count { Ok(()) } else { bad(last) }
    }

    /// [`Error::TooLarge`], if the count is above the limit.
    pub fn check_count(what: &'static str, count: u64, limit: u64) -> Result<()> {
        if count <= limit { Ok(()) } else { Err(Error::TooLarge { what, count, limit }) }
    }

    /// Which of two pieces it is about, if it is about one of two.
    pub fn side(&self) -> Option<Side> {
        match *self {
            Error::NotFinite { element: Element::LoopPoint(side), .. }
            | Error::NoLoop { side }
            | Error::LoopTooShort { side, .. }
            | Error::LoopRepeatsVertex { side, .. }
            | Error::LoopEdgeNotFree { side, .. }
            | Error::PlanesUndecided { side }
            | Error::LoopNotOriented { side, .. }
            | Error::BadLoopPair { side, .. } => Some(side),
            Error::MixedScalars | Error::OrientationConflict { .. } | Error::NetsOpposed => Some(Side::B),
            _ => None,
        }
    }

    /// [`Error::OptionOutOfRange`] unless the value of an option is valid.
    pub fn require(is_valid: bool, option: &'static str, value: f64) -> Result<()> {
        if is_valid { Ok(()) } else { Err(Error::OptionOutOfRange { option, value }) }
    }
}

/// The result type of the library.
pub type Result<T, E = Error> = std::result::Result<T, E>;
