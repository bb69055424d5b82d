//! Filling holes: new faces that close boundary loops.
//!
//! Sources: G. Barequet, M. Sharir, *Filling gaps in the boundary of a polyhedron* (1995); P. Liepa, *Filling holes in
//! meshes* (2003). A hole is closed by the triangulation of its rim of least weight; then, if asked for, the triangles are
//! refined until they are as small as those round the hole, and the new vertices moved until the patch goes on as the surface
//! does.
//!
//! | file | what it does |
//! |---|---|
//! | [`request`](self) | what a caller asks for, and what comes back |
//! | [`choose`](self) | which loops are filled, and why others are not |
//! | [`surroundings`](self) | the old faces round a hole |
//! | [`patch`](self) | the plan for one hole: new points and triangles |
//! | [`triangulate`](self) | the triangulation of least weight |
//! | [`clip`](self) | loops too long for that: ear by ear |
//! | [`patch_mesh`](self) | triangles with neighbours: splits and flips |
//! | [`refine`](self) | new vertices, as dense as those round the hole |
//! | [`holes`](self) | all of these for every hole, and one mesh of it all |

mod choose;
mod clip;
mod holes;
mod patch;
mod patch_mesh;
mod refine;
mod request;
mod surroundings;
mod triangulate;

pub use holes::fill_holes;
pub use request::{Fairing, Filled, Hole, HoleStatus, Limits, Options, Refinement, Weight};
