//! The causes of failure. Each kind of cause is a variant with its message and the element at
//! fault.
//!
//! `src/capi/status.rs` of the root package assigns each variant a status number for C.

use crate::error_subject::NumberInMessage;
pub use crate::error_subject::{Allowed, Component, Element, LoopPairFault, Side};

/// The causes of failure. Indices count from 0 and refer to the caller's own arrays.
#[allow(missing_docs, reason = "the texts say what the fields are")]
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum Error {
    /// A count exceeds the limit of this version.
    #[error("{count} {what} were given; the limit is {limit}")]
    TooLarge {
        /// The counted elements, in the plural.
        what: &'static str,
        count: u64,
        limit: u64,
    },
    /// An array needs more bytes (count times stride) than the machine can address.
    #[error("{count} {what} exceed the address space; check the count and the stride")]
    SizeOverflow {
        /// The elements of the array, in the plural.
        what: &'static str,
        count: u64,
    },
    /// An array has fewer bytes than its count and stride need.
    #[error("the array of {what} needs {needed} bytes but has {given}")]
    ArrayTooShort {
        /// The elements of the array, in the plural.
        what: &'static str,
        needed: u64,
        given: u64,
    },
    /// The stride, the distance between elements, is smaller than one element.
    #[error("the stride of {what} is {stride}; it must be 0 or at least {min}")]
    StrideTooSmall {
        /// The elements of the array, in the plural.
        what: &'static str,
        /// The given stride.
        stride: u64,
        min: u64,
    },
    /// A mesh lacks vertices or faces, or the list of meshes is empty.
    #[error("no {what} were given; at least one is needed")]
    EmptyMesh {
        /// The missing elements, in the plural.
        what: &'static str,
    },
    /// Offsets (of faces, outlines or segments) do not start at 0, decrease, or do not end at the
    /// number of elements.
    #[error("offset {entry} is {value}{}", if *.entry == 0 && *.value != 0 { " instead of 0" } else { ": offsets must not decrease, and the last must be the number of elements" })]
    BadOffsets {
        /// The first offending entry.
        entry: u32,
        value: u32,
    },
    /// A face has fewer than three corners.
    #[error("face {face} has {corners} corners; it needs at least three")]
    FaceTooSmall { face: u32, corners: u32 },
    /// A face refers to a vertex that does not exist.
    #[error("face {face}, corner {corner}: vertex {vertex} does not exist (the mesh has {count})")]
    IndexOutOfRange {
        face: u32,
        /// The position in the corner array.
        corner: u32,
        vertex: u32,
        /// The number of vertices.
        count: u32,
    },
    /// A face passes a vertex twice, in an operation that needs simple faces.
    #[error("face {face} passes vertex {vertex} twice; split it into faces that pass each vertex once")]
    RepeatedCorner { face: u32, vertex: u32 },
    /// Two consecutive vertices of a cut are not connected by a path of edges.
    #[error(
        "cut {cut}, place {place}: no path of edges connects vertex {vertex} with the previous vertex; name vertices of one component"
    )]
    CutNotConnected {
        /// The index of the cut.
        cut: u32,
        /// The position in the cut.
        place: u32,
        vertex: u32,
    },
    /// A surface is not closed: faces pass an edge of this face more often in one direction than in
    /// the other. The edge is on a border, or its faces are not oriented alike.
    #[error(
        "input {input} is not closed at face {face}: an edge is on a border, or its faces are not oriented alike; fill its holes or orient its faces"
    )]
    MeshNotClosed { input: u32, face: u32 },
    /// A merge map sends a vertex to one that does not exist, or that is itself merged into
    /// another.
    #[error(
        "vertex {vertex} is merged into vertex {value}, which does not exist or is itself merged into another; name a vertex that stays"
    )]
    BadMerge { vertex: u32, value: u32 },
    /// An element has a coordinate that is NaN or infinite. The element is a vertex that a face
    /// uses, a point, the tangent of a constraint, or a node. A node may also have such a value.
    #[error("{component} of {element} {index} is {}; it must be finite", NumberInMessage(.value))]
    NotFinite { element: Element, index: u64, component: Component, value: f64 },
    /// The number of inputs that have values differs from the number of inputs.
    #[error("values are given for {given} inputs, but there are {needed}")]
    InputsDiffer { given: u64, needed: u64 },
    /// The number of values of an input differs from its number of elements.
    #[error("input {input} has {needed} elements, but {given} values are given")]
    ValuesDiffer { input: u32, given: u64, needed: u64 },
    /// A value is NaN or infinite, or a share is negative.
    #[error("{element} {index} of input {input} has the value {}; it must be {}", NumberInMessage(.value), if .value.is_finite() { "at least 0" } else { "finite" })]
    BadValue { element: Element, index: u64, input: u32, value: f64 },
    /// The square of a coordinate would overflow, or a result that contains such squares.
    #[error("{component} of {element} {index} is {}, so large that results overflow; scale the input down", NumberInMessage(.value))]
    CoordinateTooLarge { element: Element, index: u64, component: Component, value: f64 },
    /// A section of a frame has a different number of points than the first section.
    #[error("section {section} has {count} points, but the first section has {expected}")]
    SectionsDiffer {
        section: u32,
        count: u32,
        /// The number of points of the first section.
        expected: u32,
    },
    /// A section of a frame, or a plane, lacks a node on a column. Either the two do not meet, or
    /// the section is not a curve.
    #[error("section {section} has no node in column {column}; it must be a curve that meets the column")]
    NoNode {
        /// The index of the section or plane.
        section: u32,
        column: u32,
    },
    /// All sections of a frame are points.
    #[error("all sections are tips; a body needs at least one section that is a curve, between tips or beside one")]
    OnlyTips,
    /// A section of a frame coincides with an earlier one.
    #[error("section {section} repeats section {earlier}; leave one of them out")]
    RepeatedSection { section: u32, earlier: u32 },
    /// A closed curve does not end where it begins.
    #[error("the curve does not end where it begins; a closed curve must")]
    CurveNotClosed,
    /// An operation on plane curves got a control point whose z is not 0.
    #[error("control point {point} is {} away from the plane; move it into the plane (z = 0 for a plane curve)", NumberInMessage(.z))]
    CurveNotPlane {
        point: u32,
        /// The z coordinate, or the distance from the plane of the operation.
        z: f64,
    },
    /// An operation needs a curve with segments or points, and the curve has none.
    #[error("the curve is empty; it needs at least one segment or point")]
    EmptyCurve,
    /// A place on the curve does not exist.
    #[error("place {index}: segment {segment} with parameter {} does not exist; parameters are from 0 to 1", NumberInMessage(.t))]
    NoSuchPlace {
        /// The index among the given places.
        index: u32,
        segment: u32,
        t: f64,
    },
    /// A constraint names a point that does not exist, or that the previous constraint already
    /// names or passes.
    #[error(
        "constraint {constraint} names point {point}, which does not exist or does not come after the previous constraint's"
    )]
    BadConstraint { constraint: u32, point: u32 },
    /// The first mesh has `f32` positions and the second `f64`. The result has the first mesh's
    /// type and would round the second mesh's positions.
    #[error("the inputs have coordinates of different types, and the result would round one of them: convert one")]
    MixedScalars,
    /// A piece lacks a boundary loop that can be stitched.
    #[error("loop {side}: the piece lacks a boundary loop that can be stitched; open it, or repair its border")]
    NoLoop { side: Side },
    /// Two loops of one mesh are to be stitched, but the mesh has fewer than two.
    #[error("the mesh has {count} boundary loop{} that can be stitched; two without a common vertex are needed", if *.count == 1 { "" } else { "s" })]
    NoPairOfLoops { count: u32 },
    /// A loop has fewer than three vertices, or a polyline is empty.
    #[error("loop {side} has {count} vertices; {}", if *.count == 0 { "it needs at least one" } else { "it needs at least three" })]
    LoopTooShort { side: Side, count: u32 },
    /// A loop passes a vertex twice.
    #[error("loop {side} passes vertex {vertex} twice; it must pass each vertex once")]
    LoopRepeatsVertex { side: Side, vertex: u32 },
    /// Two consecutive loop vertices do not bound a free edge, which is an edge with exactly one
    /// face.
    #[error(
        "loop {side}: the edge that leaves place {place} (vertex {vertex}) is not a free edge of the mesh; a free edge has exactly one face"
    )]
    LoopEdgeNotFree {
        side: Side,
        /// The position in the loop where the edge starts.
        place: u32,
        /// The vertex at that position.
        vertex: u32,
    },
    /// A loop refers to a vertex that does not exist.
    #[error("loop {number}, place {place}: vertex {vertex} does not exist (the mesh has {count})")]
    LoopIndexOutOfRange {
        /// The index among the given loops.
        number: u32,
        /// The position in the loop.
        place: u32,
        vertex: u32,
        /// The number of vertices.
        count: u32,
    },
    /// Both loops pass the same vertex of the same mesh.
    #[error("both loops pass vertex {vertex}; choose loops without a common vertex")]
    LoopsShareVertex { vertex: u32 },
    /// The paper's planes cannot tell which vertices of two loops face each other. Either none of a
    /// loop's vertices is clearly on the other loop's side of the plane through its centre, or the
    /// centres coincide. Join such loops whole.
    #[error(
        "no vertex of loop {side} is clearly on the other loop's side of the plane through its centre; join whole loops"
    )]
    PlanesUndecided { side: Side },
    /// The faces along one loop disagree in orientation.
    #[error("the faces along loop {side} disagree in orientation, face {face} among them; orient the faces first")]
    LoopNotOriented {
        side: Side,
        /// A face that is oriented against most others.
        face: u32,
    },
    /// The second piece is oriented against the first, and the options forbid flipping it.
    #[error("the surface at loop B (face {face}) is oriented against the surface at loop A: flip one of them")]
    OrientationConflict {
        /// A face on the second loop.
        face: u32,
    },
    /// Every strip through the first meridian, or the strip of the chosen rule, would repeat an
    /// edge of the mesh.
    #[error(
        "no strip between the loops avoids the edges that the mesh already has (vertex {vertex}); choose other loops or arcs"
    )]
    NoStrip {
        /// The vertex of the first loop where the rule's meridian starts, if one vertex is to
        /// blame.
        vertex: u32,
    },
    /// A net has fewer than two rows or columns.
    #[error("{rows} rows and {columns} columns of nodes: a net needs at least two of each, a closed surface four")]
    NetTooSmall { rows: u64, columns: u64 },
    /// A gluing identifies both pairs of opposite corners of a cell, which is impossible on a
    /// surface.
    #[error(
        "cell {cell}: both pairs of opposite corners would be glued, which no surface allows; use more rows or columns"
    )]
    CrossingCell {
        /// The first such cell.
        cell: u32,
    },
    /// A seam is empty, leaves the net, or repeats one pair of nodes.
    #[error("seam {seam} is empty, leaves the net, or repeats one pair of nodes")]
    BadSeam { seam: u32 },
    /// An element does not exist, or is of a different kind.
    #[error("{element} {index} {}", .element.describe_absence(*.index, *.count))]
    NoSuch {
        element: Element,
        index: u64,
        /// The number of elements; the number of sheets for a place.
        count: u64,
    },
    /// The sides of two nets that are to be joined have different numbers of nodes, and the options
    /// forbid equalising them.
    #[error("the sides have {a} and {b} nodes; they need the same number, or the option to equalise them")]
    SidesDiffer {
        /// The number of nodes on the first net's side.
        a: u32,
        b: u32,
    },
    /// Sides that must coincide do not: the sides of nets that are welded, or of a closed sheet.
    #[error("sides that must coincide are {} apart at place {place}; move their nodes together", NumberInMessage(.distance))]
    SidesApart { place: u32, distance: f64 },
    /// The number of knots in one direction of a spline does not match its control points and
    /// degree.
    #[error("direction {direction} has {given} knots; its control points and degree need {needed}")]
    WrongKnotCount {
        /// 0 for u, 1 for v.
        direction: u32,
        given: u64,
        needed: u64,
    },
    /// A knot of a spline is not finite, smaller than the previous one, or repeated too often. Or
    /// the spline's range is empty, or a span that must be cut is too short.
    #[error("knot {knot} of direction {direction}, {}, is out of order, repeated too often, or begins a span too short to cut", NumberInMessage(.value))]
    BadKnot {
        /// 0 for u, 1 for v.
        direction: u32,
        knot: u32,
        value: f64,
    },
    /// A weight of a rational spline is not finite, not positive, or below 2^-900 of the largest
    /// weight.
    #[error("the weight of control point {index} is {}; weights are finite and above 0", NumberInMessage(.value))]
    BadWeight { index: u64, value: f64 },
    /// A row and a column of a net of curves do not meet.
    #[error("row {row} and column {column} of the net are {} apart where they are nearest; they must meet within the tolerance", NumberInMessage(.distance))]
    CurvesApart {
        row: u32,
        column: u32,
        /// The smallest distance between the two curves.
        distance: f64,
    },
    /// A curve of a net meets the crossing curves in a different order than other curves do.
    #[error(
        "row {row} and column {column} of the net meet out of order: the {curve} differs from the other {curve}s; list the curves in the order of their crossings"
    )]
    CurvesOutOfOrder {
        /// The row at the first crossing that is out of order.
        row: u32,
        column: u32,
        /// The curve that breaks the order: "row" or "column".
        curve: &'static str,
    },
    /// Two nets cannot be joined because their faces have opposite orientations.
    #[error("the second net is oriented against the first: flip it")]
    NetsOpposed,
    /// The faces of a mesh do not form a rectangular grid of quads, or of quads cut into two
    /// triangles.
    #[error(
        "the faces do not form a rectangular grid of quads, whole or as two triangles each: face {face} does not fit"
    )]
    NoGrid {
        /// The first face that does not fit the grid.
        face: u32,
    },
    /// A stream is damaged, truncated, or not a stream of a net.
    #[error("the stream cannot be read at byte {byte}: {what}")]
    BadStream { what: &'static str, byte: u64 },
    /// A group of a scene would contain itself.
    #[error("entry {entry} of the scene would contain itself; choose a parent outside it")]
    SceneCycle { entry: u32 },
    /// An operation needs nets, and the scene has none.
    #[error("the scene has no nets; add at least one")]
    EmptyScene,
    /// A deformation field is undefined at a node: at the centre of a sphere, or in the eye's plane
    /// of a projection.
    #[error("at node {node} the field is undefined or its value is too large; move the node or the field")]
    FieldUndefined {
        /// The first such node.
        node: u32,
    },
    /// Rows and columns cannot be added or removed evenly, because the net has bridges or is glued
    /// elsewhere than along whole sides.
    #[error(
        "the net has bridges or is glued elsewhere than along whole sides, so rows and columns cannot be added or removed; split the net first"
    )]
    GluedInside,
    /// A node lies outside the box that is given for the levels of a stream.
    #[error("node {node} lies outside the box of the levels; enlarge the box")]
    NodeOutsideBox {
        /// The first such node.
        node: u32,
    },
    /// Two nets must be glued in the same way and are not.
    #[error("the nets are glued differently, first at node {node}; they must be glued alike")]
    GluingsDiffer {
        /// The first node that the two nets identify with different nodes.
        node: u32,
    },
    /// A line starts beyond 1e150, lacks a direction, or ends before it begins.
    #[error("line {line} {why}{}", if *.value == 0.0 { String::new() } else { format!(": {}", NumberInMessage(.value)) })]
    BadLine {
        line: u64,
        /// The fault, as the predicate of a sentence about the line.
        why: &'static str,
        /// The offending number.
        value: f64,
    },
    /// A record of a winged-edge table does not fit any mesh.
    #[error("edge {edge}: {why}")]
    BadWings {
        edge: u64,
        /// The fault, as a sentence about the edge.
        why: &'static str,
    },
    /// The largest absolute coordinate of a sheet is too large or too small for a surface.
    #[error("sheet {sheet}: its largest coordinate, {}, must be 0 or from 1e-30 to 1e37", NumberInMessage(.value))]
    SheetOutOfRange {
        sheet: u64,
        /// The coordinate, or infinity.
        value: f64,
    },
    /// The number of inputs differs from the number that the filter takes.
    #[error("{given} inputs were given; the filter takes {}", if .min == .max { min.to_string() } else { format!("{min} to {max}") })]
    InputCount { given: u64, min: u64, max: u64 },
    /// An input does not meet the filter's requirements.
    #[error("input {input}: {why}")]
    InputUnfit {
        input: u32,
        /// The requirement.
        why: &'static str,
    },
    /// An input has a number of curves that the filter does not take.
    #[error("input {input} has {given} curve{}; the filter needs {needed}", if *.given == 1 { "" } else { "s" })]
    CurveCount {
        input: u32,
        given: u64,
        /// The number that it needs, in words.
        needed: &'static str,
    },
    /// A pair of loops in an option is unusable.
    #[error("pair {pair} of {option}: {}", .fault.describe_fault(*.piece, *.vertex))]
    BadLoopPair {
        option: &'static str,
        /// The index among the given pairs.
        pair: u32,
        /// The loop of the pair that is at fault.
        side: Side,
        /// The piece that the pair names for this loop.
        piece: u32,
        /// The vertex that the pair names for this loop.
        vertex: u32,
        fault: LoopPairFault,
    },
    /// An option is outside its range.
    #[error("{option} is {}; it must be {allowed}", NumberInMessage(.value))]
    OptionOutOfRange {
        option: &'static str,
        value: f64,
        /// The values in its range.
        allowed: Allowed,
    },
    /// A property of a bridge is negative, NaN or infinite, or too large for the coordinates.
    #[error("bridge {bridge}: its {property} is {}; it must be finite, at least 0, and not too large for the coordinates", NumberInMessage(.value))]
    BadProperty { bridge: u32, property: &'static str, value: f64 },
    /// A pose is not a rotation and translation.
    #[error(
        "pose {pose} is not a rotation and translation: it has a number that is not finite, scales, shears or mirrors"
    )]
    NotRigid { pose: u32 },
    /// Memory for an array could not be allocated.
    #[error("{bytes} bytes of memory could not be allocated; free memory or use a smaller input")]
    OutOfMemory { bytes: u64 },
    /// The caller cancelled the call.
    #[error("the caller cancelled the call")]
    Cancelled,
}

impl Error {
    /// Returns [`Error::NotFinite`] if a coordinate of the element is NaN or infinite.
    pub fn check_finite(element: Element, index: u64, p: glam::DVec3) -> Result<()> {
        match Component::find(p, |x| !x.is_finite()) {
            Some((component, value)) => Err(Error::NotFinite { element, index, component, value }),
            None => Ok(()),
        }
    }

    /// Returns [`Error::NotFinite`] or [`Error::CoordinateTooLarge`] if a coordinate of the element is
    /// not finite, or is larger than the limit.
    pub fn check_magnitude(element: Element, index: u64, p: glam::DVec3, limit: f64) -> Result<()> {
        Error::check_finite(element, index, p)?;
        match Component::find(p, |x| x.abs() > limit) {
            Some((component, value)) => Err(Error::CoordinateTooLarge { element, index, component, value }),
            None => Ok(()),
        }
    }

    /// Checks that offsets start at 0, do not decrease, and end with `count`. Otherwise returns
    /// [`Error::BadOffsets`] with the first bad entry.
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

    /// Returns [`Error::TooLarge`] if the count exceeds the limit.
    pub fn check_count(what: &'static str, count: u64, limit: u64) -> Result<()> {
        if count <= limit { Ok(()) } else { Err(Error::TooLarge { what, count, limit }) }
    }

    /// Returns the piece that the error concerns, if it concerns one of two pieces.
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

    /// Returns [`Error::OptionOutOfRange`] unless the value of the option is valid. `allowed`
    /// describes the valid values.
    pub fn require(is_valid: bool, option: &'static str, value: f64, allowed: impl Into<Allowed>) -> Result<()> {
        if is_valid { Ok(()) } else { Err(Error::OptionOutOfRange { option, value, allowed: allowed.into() }) }
    }
}

/// The result type of the library.
pub type Result<T, E = Error> = std::result::Result<T, E>;
