//! The crate parry3d-f64 behind a few functions in C, for the benchmarks of surfaces. The caller
//! keeps to the lengths it gives.

use parry3d_f64::math::Vector;
use parry3d_f64::partitioning::BvhNode;
use parry3d_f64::query::{IntersectResult, PointQuery, Ray, RayCast};
use parry3d_f64::shape::TriMesh;
use std::slice;

/// The arrays of a mesh.
pub struct Parts(Vec<Vector>, Vec<[u32; 3]>);

/// Receives a point of the answer to question `k`.
type Receive = extern "C" fn(user: *mut core::ffi::c_void, k: usize, point: *const f64);

fn vectors<'a>(numbers: *const f64, count: usize) -> impl Iterator<Item = Vector> + 'a {
    // SAFETY: the caller has `count` points there.
    unsafe { slice::from_raw_parts(numbers.cast::<[f64; 3]>(), count) }.iter().map(|&p| Vector::from(p))
}

fn rays<'a>(lines: *const f64, count: usize) -> impl Iterator<Item = Ray> + 'a {
    // SAFETY: the caller has `count` lines there, each an origin and a direction.
    let lines = unsafe { slice::from_raw_parts(lines.cast::<[[f64; 3]; 2]>(), count) };
    lines.iter().map(|&[origin, direction]| Ray::new(origin.into(), direction.into()))
}

/// Copies the arrays, as parry wants them for itself.
#[unsafe(no_mangle)]
pub extern "C" fn parry_parts(points: *const f64, count: usize, corners: *const u32, faces: usize) -> *mut Parts {
    // SAFETY: the caller has `faces` triangles there.
    let corners = unsafe { slice::from_raw_parts(corners.cast::<[u32; 3]>(), faces) };
    Box::into_raw(Box::new(Parts(vectors(points, count).collect(), corners.to_vec())))
}

/// The mesh with its hierarchy; null if parry makes none. The parts are used up.
#[unsafe(no_mangle)]
pub extern "C" fn parry_mesh(parts: *mut Parts) -> *mut TriMesh {
    // SAFETY: from `parry_parts`, once.
    let Parts(points, corners) = *unsafe { Box::from_raw(parts) };
    TriMesh::new(points, corners).map_or(std::ptr::null_mut(), |mesh| Box::into_raw(Box::new(mesh)))
}

/// Null is allowed.
#[unsafe(no_mangle)]
pub extern "C" fn parry_free(mesh: *mut TriMesh) {
    if !mesh.is_null() {
        // SAFETY: from `parry_mesh`, once.
        drop(unsafe { Box::from_raw(mesh) });
    }
}

#[unsafe(no_mangle)]
pub extern "C" fn parry_closest(mesh: &TriMesh, queries: *const f64, count: usize, feet: *mut f64) {
    // SAFETY: the caller has room for as many feet.
    let feet = unsafe { slice::from_raw_parts_mut(feet.cast::<[f64; 3]>(), count) };
    for (query, foot) in vectors(queries, count).zip(feet) {
        *foot = mesh.project_local_point(query, false).point.into();
    }
}

/// All hits of all lines, unordered along each: by a walk through the hierarchy.
#[unsafe(no_mangle)]
pub extern "C" fn parry_lines(mesh: &TriMesh, lines: *const f64, count: usize, user: *mut core::ffi::c_void, receive: Receive) {
    for (k, ray) in rays(lines, count).enumerate() {
        for leaf in mesh.bvh().leaves(|node: &BvhNode| node.cast_ray(&ray, f64::MAX) < f64::MAX) {
            if let Some(t) = mesh.triangle(leaf).cast_local_ray(&ray, f64::MAX, false) {
                receive(user, k, ray.point_at(t).as_ref().as_ptr());
            }
        }
    }
}

#[unsafe(no_mangle)]
pub extern "C" fn parry_rays(mesh: &TriMesh, lines: *const f64, count: usize, user: *mut core::ffi::c_void, receive: Receive) {
    for (k, ray) in rays(lines, count).enumerate() {
        if let Some(t) = mesh.cast_local_ray(&ray, f64::MAX, false) {
            receive(user, k, ray.point_at(t).as_ref().as_ptr());
        }
    }
}

/// The section by a plane: its segments one after the other, `k` the number of the curve.
#[unsafe(no_mangle)]
pub extern "C" fn parry_plane(mesh: &TriMesh, normal: *const f64, bias: f64, user: *mut core::ffi::c_void, receive: Receive) {
    let normal = vectors(normal, 1).next().unwrap_or_default();
    let IntersectResult::Intersect(section) = mesh.intersection_with_local_plane(normal, bias, 0.0) else { return };
    let point = |index: u32| section.vertices()[index as usize];
    let (mut curve, mut last) = (0, None);
    for &[a, b] in section.indices() {
        if last != Some(a) {
            curve += usize::from(last.is_some());
            receive(user, curve, point(a).as_ref().as_ptr());
        }
        receive(user, curve, point(b).as_ref().as_ptr());
        last = Some(b);
    }
}
