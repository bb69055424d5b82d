//! DXF, Drawing Exchange Format: outlines, points and faces.
//!
//! The source is the DXF reference of Autodesk. `LINE`, `LWPOLYLINE`, `POLYLINE`, `ARC`, `CIRCLE`, `ELLIPSE` and `SPLINE` become
//! polylines; `POINT` becomes a point; `3DFACE`, polyface meshes and polygon meshes become faces. Blocks are inserted (`INSERT`), also in
//! rows and columns. Entities with an extrusion direction are taken out of their own coordinate systems.
//!
//! - Curves are drawn within 1e-5 of the drawing's diagonal.
//! - Open polylines are joined where exactly two of them meet, within 1e-7 of the diagonal, because most programs write an outline as
//!   single lines and arcs. A chain that meets itself becomes closed. The first entity gives the direction.
//! - The variable `$INSUNITS` gives the unit.
//! - Text, hatches, dimensions, solids and the paper space are left out and noted. Layers are not regarded.
//!
//! Binary DXF files are refused. The writer makes text of release 12, which most programs read. Reading takes time linear in the file,
//! times the number of readings (2 if there are curves).

mod dxf_curves;
mod dxf_entity;
mod dxf_faces;
mod dxf_pairs;
mod dxf_spline;
#[cfg(test)]
mod dxf_tests;
mod dxf_units;
mod join_outlines;
mod read_dxf;
mod write_dxf;

pub(crate) use read_dxf::read_dxf;
pub(crate) use write_dxf::write_dxf;
