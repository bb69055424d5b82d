//! Inputs of filters.

use crate::pieces::Piece;
use gusset::capi::plugin::descriptor::*;
use gusset_io::{Curves, Mesh, Positions};
use std::ffi::c_void;
use std::ptr;

/// A mesh or curves.
#[derive(Clone, Debug)]
pub(crate) enum Geometry {
    Mesh(Box<Piece>),
    Curves(Curves),
}

/// The inputs of a run, with the structs that show them to a plugin.
pub(crate) struct Inputs {
    // The structs point into `geometry`, whose arrays stay where they are because nobody changes them.
    geometry: Vec<Geometry>,
    /// For each curve 0 or 1; empty for meshes.
    _closed: Vec<Vec<u8>>,
    _structs: Vec<ViewStruct>,
    views: Vec<gusset_input>,
}

enum ViewStruct {
    Mesh(Box<gusset_plugin_mesh>),
    Curves(Box<gusset_plugin_curves>),
}

impl Inputs {
    pub(crate) fn new(geometry: Vec<Geometry>) -> Self {
        let closed: Vec<Vec<u8>> = geometry
            .iter()
            .map(|one| match one {
                Geometry::Mesh(_) => Vec::new(),
                Geometry::Curves(curves) => curves.closed.iter().map(|&closed| u8::from(closed)).collect(),
            })
            .collect();
        let structs: Vec<ViewStruct> = geometry
            .iter()
            .zip(&closed)
            .map(|(one, closed)| match one {
                Geometry::Mesh(piece) => ViewStruct::Mesh(Box::new(mesh_view(&piece.mesh))),
                Geometry::Curves(curves) => ViewStruct::Curves(Box::new(curves_view(curves, closed))),
            })
            .collect();
        let views = structs
            .iter()
            .map(|one| {
                let (kind, view) = match one {
                    ViewStruct::Mesh(view) => (GUSSET_KIND_MESH, ptr::from_ref(&**view).cast()),
                    ViewStruct::Curves(view) => (GUSSET_KIND_CURVES, ptr::from_ref(&**view).cast()),
                };
                gusset_input { struct_size: size_of::<gusset_input>(), view, kind, reserved: 0 }
            })
            .collect();
        Self { geometry, _closed: closed, _structs: structs, views }
    }

    pub(crate) fn geometry(&self) -> &[Geometry] {
        &self.geometry
    }

    pub(super) fn views(&self) -> &[gusset_input] {
        &self.views
    }
}

fn scalar_and_pointer(positions: &Positions) -> (u32, *const c_void) {
    match positions {
        Positions::F32(points) => (GUSSET_PLUGIN_F32, points.as_ptr().cast()),
        Positions::F64(points) => (GUSSET_PLUGIN_F64, points.as_ptr().cast()),
    }
}

fn mesh_view(mesh: &Mesh) -> gusset_plugin_mesh {
    let (scalar, positions) = scalar_and_pointer(&mesh.positions);
    gusset_plugin_mesh {
        struct_size: size_of::<gusset_plugin_mesh>(),
        positions,
        position_stride: 0,
        vertex_count: mesh.positions.len(),
        face_offsets: mesh.face_offsets.as_ptr().cast(),
        face_corners: mesh.corners.as_ptr().cast(),
        face_count: mesh.face_count(),
        scalar,
        index: 0,
        face_size: 0,
        reserved: 0,
        merge: if mesh.merge.is_empty() { ptr::null() } else { mesh.merge.as_ptr().cast() },
    }
}

fn curves_view(curves: &Curves, closed: &[u8]) -> gusset_plugin_curves {
    let (scalar, points) = scalar_and_pointer(&curves.positions);
    gusset_plugin_curves {
        struct_size: size_of::<gusset_plugin_curves>(),
        points,
        point_stride: 0,
        point_count: curves.positions.len(),
        offsets: curves.offsets.as_ptr().cast(),
        closed: closed.as_ptr(),
        curve_count: closed.len(),
        scalar,
        reserved: 0,
    }
}
