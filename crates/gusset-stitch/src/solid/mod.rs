//! From any polygons towards a valid solid, least changed.
//!
//! [`repair`] runs stages in a fixed order, each of which can be left out. A stage changes only the
//! faces at the defects that it removes; other faces keep their vertices, and vertices their bits.
//! Faces that are dropped are listed with their reasons.
//!
//! 1. Borders that coincide are sewn, and without a given tolerance borders that nearly match.
//! 2. Faces without area are dropped; their neighbours meet in their place.
//! 3. Duplicate faces are dropped.
//! 4. Components that share vertices, but no edges, get their own vertices. Holes are filled.
//! 5. Where edges have three or more faces, the faces divide space into cells. Faces with the solid
//!    on both sides are dropped. The remaining faces are separated into sheets.
//! 6. Holes that separate sheets show are filled. Open sheets that were attached to a closed one
//!    of larger area, by an edge or a vertex, are dropped.
//! 7. Closed components are turned outwards.
//! 8. If faces of closed components intersect, these are replaced by their [union](crate::arrange).
//!
//! The stages run again until nothing changes: at most four rounds in each of at most 16 passes. A pass starts like
//! another repair of the mesh, so that a second repair changes nothing. A stage is skipped if the mesh has not changed
//! since its last run.
//!
//! [`unite_solids`] is the last stage alone, for several closed pieces.
//!
//! | file | subject |
//! |---|---|
//! | [`repair_request`](self) | options and result |
//! | [`repair_run`](self) | the stages in order |
//! | [`corner_place`](self) | places on faces of the input |
//! | [`repair_state`](self) | the mesh between stages, with origins |
//! | [`settled_stages`](self) | stages that have nothing more to do |
//! | [`sew_borders`](self) | sewing |
//! | [`near_gaps`](self) | borders that nearly match |
//! | [`flat_faces`](self) | faces without area |
//! | [`duplicate_removal`](self) | duplicate faces |
//! | [`filled_holes`](self) | holes |
//! | [`vertex_contacts`](self) | components that share vertices |
//! | [`edge_fans`](self) | the radial order of faces around an edge |
//! | [`patches`](self) | faces that are connected across edges with two faces |
//! | [`solid_sides`](self) | the cells between faces, and the faces around the solid |
//! | [`sheet_pairs`](self) | sheets of faces, and their own vertices |
//! | [`united_parts`](self) | faces that intersect |
//! | [`twin_edges`](self) | edges of one sheet that coincide |
//! | [`largest_move`](self) | the largest move of a vertex |
//! | [`mesh_shape`](self) | the faces without the numbers of vertices |
//!
//! Source: Q. Zhou, E. Grinspun, D. Zorin, A. Jacobson, *Mesh arrangements for solid geometry*
//! (2016), for the cells and their winding numbers; M. Attene, *A lightweight approach to repairing
//! digitized polygon meshes* (2010), for the order of stages.

mod corner_place;
mod duplicate_removal;
mod edge_fans;
mod filled_holes;
mod flat_faces;
mod largest_move;
mod mesh_shape;
mod near_gaps;
mod patches;
mod repair_request;
mod repair_run;
mod repair_state;
mod sew_borders;
mod settled_stages;
mod sheet_pairs;
mod solid_sides;
mod twin_edges;
mod united_parts;
mod vertex_contacts;

pub use corner_place::CornerPlace;
pub use repair_request::{DropReason, DroppedFace, History, Options, Repaired};
pub use repair_run::{repair, unite_solids};
