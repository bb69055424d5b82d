//! The table of filters that hosts read, and what its filters give.

#[path = "../common/mod.rs"]
mod common;

mod cancel;
mod curve;
mod editor;
mod holes;
mod mesh;
mod moving;
mod net;
mod origins;
mod overlaps;
mod page;
mod section;
mod surface;
mod table;
