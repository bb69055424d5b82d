//! Stitching: a strip of new faces between two boundary loops.
//!
//! Source: S. Nesterenko, *The algorithm for polygonal networks of cross-linking*. The paper joins
//! two open meshes by a third, intermediate one. It is spanned by **meridians**, lines from a
//! vertex of one rim to a vertex of the other. The rims are the facing arcs of two loops, as in the
//! paper, or whole loops, so that the strip is a closed band. Loops repeat their start: loops of N
//! and M vertices have N + 1 and M + 1 points.
//!
//! The stages in order, one file each:
//!
//! | file | task |
//! |---|---|
//! | [`stitch_request`](self) | request, options and result |
//! | [`stitch_rim`](self) | validated loops, and their free edges |
//! | [`existing_edges`](self) | the edges that already join two rims |
//! | [`loop_pairing`](self) | choice of the nearest pair of loops |
//! | [`facing`] | facing arcs: algorithm 2 |
//! | [`extent`](self) | choice between whole loops and arcs |
//! | [`sense`](self) | relative direction of the rims around the gap |
//! | [`first_meridian`](self) | first meridian: the closest pair, or the best rotation |
//! | [`meridian`] | meridians, matrix H: the paper's rule, the strip of least area, and others |
//! | [`grid`](self) | rows between the rims, matrix P, and the faces between them |
//! | [`strip`](self) | strip between two rims: start, meridians, grid |
//! | [`fair_and_check`](self) | fairing of the rows, and intersections of the strip |
//! | [`avoid_intersections`](self) | another strip if one intersects |
//! | [`attach_strip`](self) | the strip in the combined mesh |
//! | [`common_points`](self) | vertices that both rims have in common |
//! | [`section_strips`](self) | strips between common points |
//! | [`strip_blend`](self) | finer triangles on a smooth surface in place of the strip |
//! | [`guide_curves`](self) | the surface that a blend follows across a wide gap |
//! | [`strip_neighbourhood`](self) | the faces around a strip |
//! | [`rim_order`](self) | the order of both rims, whatever the order of the pieces |
//! | [`ruled`](self) | a strip between polylines without meshes |
//! | [`combine`](self) | one mesh of both pieces and the strip, with maps from old to new |
//! | [`quality`](self) | quality measures of the result |
//! | [`join`](self) | all stages in order |

mod attach_strip;
mod avoid_intersections;
mod strip_blend;
pub mod combine;
mod common_points;
pub mod existing_edges;
mod extent;
pub mod facing;
pub mod fair_and_check;
mod first_meridian;
mod grid;
mod guide_curves;
mod join;
pub mod loop_pairing;
pub mod meridian;
mod strip_neighbourhood;
pub mod polyline;
mod quality;
pub mod rim_order;
mod ruled;
mod section_strips;
pub mod sense;
mod stitch_request;
pub mod stitch_rim;
pub mod strip;

pub(crate) use combine::faces_as_mesh;
pub(crate) use stitch_rim::{FreeEdges, check_loop_indices};

pub use extent::Extent;
pub use first_meridian::Start;
pub use join::stitch;
pub use meridian::{MeridianSearch, Meridians};
pub use quality::Quality;
pub use ruled::{Ruled, RuledOptions, ruled};
pub use stitch_request::{
    Cells, Fairing, Finish, IndexMap, Intersections, Options, Orientation, Request, Rows, Stitch,
};
