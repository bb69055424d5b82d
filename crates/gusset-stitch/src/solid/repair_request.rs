//! Options and result of a repair.

use super::corner_place::CornerPlace;
use crate::check::Check;
use crate::fill;
use gusset_base::choices;
use gusset_mesh::Mesh;

/// Options of [`repair`](super::repair()). By default every stage runs.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Options {
    /// The largest distance between borders that are sewn, finite and at least 0; `None` derives it
    /// from the data, as [`weld`](crate::repair::weld::Options::tolerance) does.
    pub tolerance: Option<f64>,
    /// If true, borders are not sewn.
    pub leave_borders: bool,
    /// If true, faces without area stay.
    pub leave_flat_faces: bool,
    /// If true, duplicate faces stay.
    pub leave_duplicates: bool,
    /// If true, faces inside the solid stay, and edges with three or more faces too.
    pub leave_non_manifold: bool,
    /// If true, holes stay open.
    pub leave_holes: bool,
    /// If true, components keep their orientations.
    pub leave_orientation: bool,
    /// If true, faces that intersect stay.
    pub leave_intersections: bool,
    /// If true, open sheets stay that were attached to a closed component.
    pub leave_fins: bool,
    /// How holes are filled; `outward` and `plan_only` are not read.
    pub fill: fill::Options,
}

/// The reason why a face was dropped.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum DropReason {
    /// Fewer than three different vertices remain after sewing.
    Degenerate,
    /// Its area is 0 up to rounding.
    ZeroArea,
    /// Another face has the same vertices.
    Duplicate,
    /// The solid lies on both of its sides.
    Inside,
    /// The solid lies on neither side, and it belongs to an open sheet attached to a closed
    /// component.
    Fin,
    /// It lies in an overlapping part, or on an inverted part, and no part of it bounds the union.
    Overlap,
}

choices! { for DropReason:
    Degenerate => "Degenerate", "Fewer than three different vertices remain.";
    ZeroArea => "Without area", "The area is 0 up to rounding.";
    Duplicate => "Duplicate", "Another face has the same vertices.";
    Inside => "Inside", "The solid lies on both sides.";
    Fin => "Fin", "Part of an open sheet that was attached to a closed component.";
    Overlap => "Overlap", "The face lies in an overlapping part, or on an inverted part.";
}

/// A dropped face of the input.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct DroppedFace {
    /// The face.
    pub face: u32,
    /// The reason.
    pub reason: DropReason,
}

/// A repaired mesh, and what was changed.
#[derive(Debug, Clone, PartialEq)]
pub struct Repaired {
    /// The old faces in their order, or the parts of faces that sewing split, then the faces of
    /// patches. Vertices from the input come first and keep their bits. Unused vertices are removed.
    pub mesh: Mesh,
    /// For each face, the face of the input that it is or is a part of;
    /// [`NONE`](gusset_mesh::NONE) for the faces of patches.
    pub face_origin: Vec<u32>,
    /// For each vertex, the smallest vertex of the input that it is;
    /// [`NONE`](gusset_mesh::NONE) for new vertices.
    pub vertex_origin: Vec<u32>,
    /// For each face, true if it was turned over.
    pub turned: Vec<bool>,
    /// The dropped faces of the input, ascending. A face of which a part remains is not listed.
    pub dropped: Vec<DroppedFace>,
    /// The number of vertices that were merged into others.
    pub welded_vertices: u32,
    /// The number of edges with two faces that were boundary edges, or parts of them.
    pub sewn_edges: u32,
    /// The number of faces of the input that were split or gained corners.
    pub split_faces: u32,
    /// The number of copies of vertices that separate sheets of faces.
    pub split_vertices: u32,
    /// The number of holes that were filled.
    pub filled_holes: u32,
    /// The largest distance from a corner of a remaining face of the input to the vertex of the input in its place: the
    /// largest move of a vertex; 0 if no two vertices at different positions were merged.
    pub tolerance: f64,
    /// The defects that remain.
    pub after: Check,
    /// Pairs of faces that intersect in the result, ascending.
    pub intersections: Vec<[u32; 2]>,
    /// The origins of corners and new vertices.
    pub history: History,
}

/// The origins of corners and new vertices.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct History {
    /// The numbers of vertices, corners and faces of each piece of the input.
    pub inputs: Vec<[usize; 3]>,
    /// For each corner of the old faces, which come first, its place on its face of the input.
    pub corners: Vec<CornerPlace>,
    /// The places of the first new vertices: up to three vertices of the input, and their weights. Unused ones are
    /// [`NONE`](gusset_mesh::NONE), with weight 0.
    pub placed: Vec<([u32; 3], [f64; 3])>,
    /// Three parents of each other new vertex, which come last. Parents precede the vertex.
    pub parents: Vec<[u32; 3]>,
    /// The weight of each parent, at least 0, with sum 1.
    pub weights: Vec<[f64; 3]>,
}

impl Repaired {
    /// Returns true if the result bounds a solid: closed, manifold, oriented, without degenerate,
    /// duplicate or intersecting faces.
    #[must_use]
    pub fn is_valid(&self) -> bool {
        let after = &self.after;
        after.closed
            && after.manifold
            && after.oriented
            && after.degenerate_faces.is_empty()
            && after.zero_area_faces.is_empty()
            && after.duplicate_faces.is_empty()
            && self.intersections.is_empty()
    }
}
