//! The C interface: checks pointers, turns panics into status codes, computes nothing.
//!
//! | file | what it owns |
//! |---|---|
//! | [`status`] | the status codes, and which one each error of the core becomes |
//! | [`guard`](self) | what becomes of a panic, and of a context in use |
//! | [`input`](self) | raw pointers to slices, views and structs |
//! | [`context`] | threads, progress, cancel, log, message, report |
//! | [`version`] | what is loaded |
//! | [`mesh`] | the mesh view, in and out |
//! | [`boundary`], [`winged`], [`check`], [`facing`], [`strip`], [`stitch`] | one file for each module of the core |
//! | [`weld`], [`orient`], [`fill`], [`assembly`] | the same |
//! | [`stitch_options`] | how to stitch |
//! | [`outline`], [`outline_options`], [`frame`] | curves through points, and across and along a body |
//! | [`net`], [`net_gluing`] | the handle of a net and its coordinates; what is glued to what |
//! | [`net_glue`], [`net_complex`], [`net_validate`], [`net_primitive`] | gluing by hand and its types, surfaces, checks, shapes |
//! | [`net_transform`], [`net_field`], [`net_analyse`] | how nets are moved and deformed, and what that does to them |
//! | [`net_normals`], [`net_measure`], [`net_resample`] | normals, areas and volumes, other sizes |
//! | [`net_arrange`], [`net_join`] | nets arranged anew; nets joined and taken apart |
//! | [`net_mesh`], [`net_scene`], [`net_stream`] | nets to meshes and back; nets in groups; nets as bytes |
//! | [`sheet_make`], [`sheet_ask`], [`sheet_mesh`], [`surface_evaluate`] | other kinds of sheets, what they are, meshes of them, points on them |
//! | [`sheet`], [`surface`] | pieces of smooth surface; the handle of a surface with its index, places and curves on it |
//! | [`surface_line`], [`surface_curve`] | lines and curves that meet surfaces; curves through points and along surfaces |
//! | [`surface_leus`] | the paper's search, the documented reference |
//! | [`surface_meet`] | where two surfaces meet |
//! | [`surface_info`] | what surfaces and their sheets are |
//! | [`surface_level`] | sections, contours and isophotes of surfaces |
//! | [`surface_closest`] | nearest points of surfaces, places of locally least distance, regions of cells |
//! | [`plugin`] | the other interface: one symbol and tables of filters, with a header of its own |
//! | `openmfx` | with the feature of this name: the entry points of OpenMfx hosts |
//! | [`curve`] | the handle of a curve, and places on it |
//! | [`curve_ask`], [`curve_find`], [`curve_make`], [`curve_export`] | what is asked of curves, found on them, made of them,
//! written of them |
//!
//! This is the only part of the crate with unsafe code.

#![allow(unsafe_code, reason = "the border to C")]
#![allow(non_camel_case_types, reason = "these are the names that C sees")]
#![allow(rustdoc::broken_intra_doc_links, reason = "the comments are written for C, where brackets index arrays")]
#![allow(clippy::missing_safety_doc, reason = "each C function documents its pointers in C's terms")]

pub mod assembly;
pub mod boundary;
pub mod check;
pub mod context;
pub mod curve;
pub mod curve_ask;
pub mod curve_export;
pub mod curve_find;
pub mod curve_make;
pub mod facing;
pub mod fill;
pub mod frame;
mod guard;
mod input;
pub mod mesh;
pub mod net;
pub mod net_analyse;
pub mod net_arrange;
pub mod net_complex;
pub mod net_field;
pub mod net_glue;
pub mod net_gluing;
pub mod net_join;
pub mod net_measure;
pub mod net_mesh;
pub mod net_normals;
pub mod net_primitive;
pub mod net_resample;
pub mod net_scene;
pub mod net_stream;
pub mod net_transform;
pub mod net_validate;
/// cbindgen:ignore
// In unit tests always, so that it is tested and linted with the rest.
#[cfg(any(feature = "openmfx", test))]
pub mod openmfx;
pub mod orient;
pub mod outline;
pub mod outline_options;
/// cbindgen:ignore
pub mod plugin;
pub mod sheet;
pub mod sheet_ask;
pub mod sheet_make;
pub mod sheet_mesh;
pub mod status;
pub mod stitch;
pub mod stitch_options;
pub mod strip;
pub mod surface;
pub mod surface_closest;
pub mod surface_curve;
pub mod surface_evaluate;
pub mod surface_info;
pub mod surface_leus;
pub mod surface_level;
pub mod surface_line;
pub mod surface_meet;
pub mod version;
pub mod weld;
pub mod winged;
