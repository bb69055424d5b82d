//! Meshes of the host: three arrays with any stride, positions in single precision, and faces of
//! two corners for loose edges.

use super::edge_chains;
use super::ofx_abi::{
    ATTRIB_CORNER, ATTRIB_FACE, ATTRIB_POINT, CORNER_POINT, FACE_SIZE, MESH_CONSTANT_FACE_SIZE, MESH_CORNER_COUNT,
    MESH_FACE_COUNT, MESH_NO_LOOSE_EDGE, MESH_POINT_COUNT, MESH_TRANSFORM, OfxStatus, POINT_POSITION, TYPE_FLOAT,
    TYPE_INT,
};
use super::suites::{EffectFault, HostMesh, MeshAttribute};
use glam::{DMat4, DVec3};
use gusset::capi::input;
use gusset::error::Error;
use gusset::filters::data::{Curves, Input};
use gusset::job::Job;
use gusset::mesh::{Faces, Mesh, MeshView, Positions, Scalar};
use gusset_base::alloc;
use std::ffi::{CStr, c_int};

/// A mesh of the host. Its positions are copied only if they must be transformed.
pub(super) struct HostMeshData<'a> {
    positions: Positions<'a>,
    moved: Option<Vec<[f32; 3]>>,
    /// Corners of each face, face by face, including faces of two corners.
    corners: Vec<u32>,
    sizes: Vec<u32>,
    transform: Option<DMat4>,
}

/// The number of elements that a mesh reports; 0 if the number is missing or negative.
fn element_count(mesh: &HostMesh<'_>, name: &CStr) -> usize {
    mesh.properties.get_int(name).and_then(|count| usize::try_from(count).ok()).unwrap_or(0)
}

impl<'a> HostMeshData<'a> {
    /// Reads a mesh. Returns `None` if it lacks faces.
    pub(super) fn new(mesh: &'a HostMesh<'_>, job: &Job<'_>) -> Result<Option<Self>, EffectFault> {
        let points = element_count(mesh, MESH_POINT_COUNT);
        let (corners, faces) = (element_count(mesh, MESH_CORNER_COUNT), element_count(mesh, MESH_FACE_COUNT));
        if points == 0 || faces == 0 {
            return Ok(None);
        }
        job.step(0.0, "reading meshes")?;
        let places = mesh.get_attribute(ATTRIB_POINT, POINT_POSITION, TYPE_FLOAT)?;
        let size = Positions::bytes_needed(places.stride, points, Scalar::F32)?;
        let bytes = input::input_bytes(places.data, size, 1, "positions")?;
        let positions = Positions::strided(bytes, places.stride, points, Scalar::F32)?;
        let sizes = match mesh.properties.get_int(MESH_CONSTANT_FACE_SIZE).and_then(|size| u32::try_from(size).ok()) {
            Some(size) if size > 0 => alloc::filled(size, faces)?,
            _ => read_integers(&mesh.get_attribute(ATTRIB_FACE, FACE_SIZE, TYPE_INT)?, faces, "face sizes")?,
        };
        check_face_sizes(&sizes, corners)?;
        let corners = read_integers(&mesh.get_attribute(ATTRIB_CORNER, CORNER_POINT, TYPE_INT)?, corners, "corners")?;
        Ok(Some(HostMeshData { positions, moved: None, corners, sizes, transform: read_transform(mesh)? }))
    }

    /// Transforms the mesh to the coordinate system of another one.
    pub(super) fn transform_to_space_of(&mut self, first: &HostMeshData<'_>) -> Result<(), Error> {
        let [here, there] = [self.transform, first.transform].map(Option::unwrap_or_default);
        if here != there {
            let map = there.inverse() * here;
            let places = (0..self.positions.len() as u32).map(|v| map.transform_point3(self.positions.get(v)));
            self.moved = Some(alloc::gather(places.map(|place| place.as_vec3().to_array()))?);
        }
        Ok(())
    }

    fn positions(&self) -> Positions<'_> {
        self.moved.as_deref().map_or(self.positions, Positions::from)
    }

    /// The corners of each face.
    fn faces(&self) -> impl Iterator<Item = &[u32]> {
        let mut end = 0;
        self.sizes.iter().map(move |&size| {
            let start = end;
            end += size as usize;
            &self.corners[start..end]
        })
    }

    /// The faces without loose edges.
    pub(super) fn faces_without_loose_edges(&self) -> Result<PolygonFaces, Error> {
        let mut found = PolygonFaces { offsets: alloc::with_capacity(self.sizes.len() + 1)?, corners: Vec::new() };
        found.offsets.push(0);
        alloc::reserve(&mut found.corners, self.corners.len())?;
        for face in self.faces().filter(|face| face.len() > 2) {
            found.corners.extend_from_slice(face);
            found.offsets.push(found.corners.len() as u32);
        }
        Ok(found)
    }

    /// The mesh as input of a filter.
    pub(super) fn to_mesh_input<'b>(&'b self, polygons: &'b PolygonFaces, job: &Job<'_>) -> Result<Input<'b>, Error> {
        let faces = Faces::polygons(&polygons.offsets, &polygons.corners)?;
        if faces.is_empty() {
            return Err(Error::EmptyMesh { what: "faces" });
        }
        Ok(Input::Mesh(MeshView::new(self.positions(), faces, job)?))
    }

    /// The loose edges, chained to curves.
    pub(super) fn to_curves(&self) -> Result<Curves, Error> {
        let mut edges = Vec::new();
        let positions = self.positions();
        let mut start = 0;
        for (f, face) in self.faces().enumerate() {
            let corner = start;
            start += face.len() as u32;
            let Ok(edge) = <[u32; 2]>::try_from(face) else { continue };
            if let Some(end) = edge.iter().position(|&vertex| vertex as usize >= positions.len()) {
                return Err(Error::IndexOutOfRange {
                    face: f as u32,
                    corner: corner + end as u32,
                    vertex: edge[end],
                    count: positions.len() as u32,
                });
            }
            alloc::push(&mut edges, edge)?;
        }
        edge_chains::chain_edges(&edges, positions.len(), |vertex| positions.get(vertex))
    }

    /// Writes the mesh unchanged.
    pub(super) fn write_unchanged(&self, to: &HostMesh<'_>) -> Result<(), EffectFault> {
        write_arrays(to, self.positions.len(), |v| self.positions.get(v), &self.corners, &self.sizes)
    }
}

/// Faces of three or more corners.
pub(super) struct PolygonFaces {
    offsets: Vec<u32>,
    corners: Vec<u32>,
}

/// Checks that faces of these sizes have `corners` corners in total, and at least two each.
fn check_face_sizes(sizes: &[u32], corners: usize) -> Result<(), Error> {
    let mut sum = 0u64;
    for (face, &size) in sizes.iter().enumerate() {
        if size < 2 {
            return Err(Error::FaceTooSmall { face: face as u32, corners: size });
        }
        sum += u64::from(size);
    }
    if sum == corners as u64 {
        Ok(())
    } else {
        Err(Error::BadOffsets { entry: sizes.len() as u32, value: u32::try_from(sum).unwrap_or(u32::MAX) })
    }
}

/// The elements of an array of 32-bit integers. Negative ones become very large, and are refused as
/// out of range.
fn read_integers(array: &MeshAttribute, count: usize, name: &'static str) -> Result<Vec<u32>, EffectFault> {
    let size = byte_span(array.stride, count, 4, name)?;
    let bytes = input::input_bytes(array.data, size, 1, name)?;
    let number = |k: usize| bytemuck::pod_read_unaligned::<u32>(&bytes[k * array.stride..][..4]);
    Ok(alloc::collect((0..count).map(number))?)
}

/// Number of bytes from the first element to the end of the last.
fn byte_span(stride: usize, count: usize, size: usize, what: &'static str) -> Result<usize, Error> {
    let last = count.saturating_sub(1).checked_mul(stride).and_then(|bytes| bytes.checked_add(size));
    let bytes = if count == 0 { Some(0) } else { last };
    bytes.ok_or(Error::SizeOverflow { what, count: count as u64 })
}

fn read_transform(mesh: &HostMesh<'_>) -> Result<Option<DMat4>, EffectFault> {
    let Some(matrix) = mesh.properties.get_pointer(MESH_TRANSFORM).filter(|matrix| !matrix.is_null()) else {
        return Ok(None);
    };
    let rows: [f64; 16] = bytemuck::pod_read_unaligned(input::input_bytes(matrix, 16, 8, "transform")?);
    Ok(Some(DMat4::from_cols_array(&rows).transpose()))
}

/// Writes a mesh to the host's output.
pub(super) fn write_mesh(to: &HostMesh<'_>, mesh: &Mesh) -> Result<(), EffectFault> {
    let sizes = alloc::collect(mesh.face_offsets.windows(2).map(|ends| ends[1] - ends[0]))?;
    write_arrays(to, mesh.positions.len(), |v| mesh.positions.get(v), &mesh.face_corners, &sizes)
}

/// Writes curves to the host's output.
pub(super) fn write_curves(to: &HostMesh<'_>, curves: &Curves) -> Result<(), EffectFault> {
    let edges = edge_chains::edges_of_curves(curves)?;
    let place = |v: u32| DVec3::from_array(curves.points[v as usize]);
    write_arrays(to, curves.points.len(), place, edges.as_flattened(), &alloc::filled(2, edges.len())?)
}

fn write_arrays(
    to: &HostMesh<'_>,
    points: usize,
    place: impl Fn(u32) -> DVec3,
    corners: &[u32],
    sizes: &[u32],
) -> Result<(), EffectFault> {
    let same = sizes.first().filter(|&&first| sizes.iter().all(|&size| size == first));
    for (name, count) in
        [(MESH_POINT_COUNT, points), (MESH_CORNER_COUNT, corners.len()), (MESH_FACE_COUNT, sizes.len())]
    {
        Error::check_count("elements", count as u64, c_int::MAX as u64)?;
        to.properties.set_int(name, 0, count as c_int)?;
    }
    let loose = sizes.contains(&2);
    to.properties.set_int(MESH_NO_LOOSE_EDGE, 0, c_int::from(!loose))?;
    to.properties.set_int(MESH_CONSTANT_FACE_SIZE, 0, same.map_or(-1, |&size| size as c_int))?;
    to.allocate_arrays()?;
    let positions = (0..points as u32).map(|v| bytemuck::cast(place(v).as_vec3().to_array()));
    write_elements::<12>(&to.get_attribute(ATTRIB_POINT, POINT_POSITION, TYPE_FLOAT)?, positions, "positions")?;
    write_elements::<4>(
        &to.get_attribute(ATTRIB_CORNER, CORNER_POINT, TYPE_INT)?,
        corners.iter().map(|n| n.to_ne_bytes()),
        "corners",
    )?;
    let size_array = to.get_attribute(ATTRIB_FACE, FACE_SIZE, TYPE_INT)?;
    // If all faces have the same size, the host need not provide memory for sizes.
    if same.is_none() || !size_array.data.is_null() {
        write_elements::<4>(&size_array, sizes.iter().map(|n| n.to_ne_bytes()), "face sizes")?;
    }
    Ok(())
}

/// Writes elements of `N` bytes to an array of the host.
fn write_elements<const N: usize>(
    to: &MeshAttribute,
    elements: impl ExactSizeIterator<Item = [u8; N]>,
    name: &'static str,
) -> Result<(), EffectFault> {
    let count = elements.len();
    if count > 1 && to.stride < N {
        return Err(OfxStatus::BAD_HANDLE.into());
    }
    let bytes = input::result_buffer(to.data.cast::<u8>(), byte_span(to.stride, count, N, name)?, name)?;
    for (k, element) in elements.enumerate() {
        bytes[k * to.stride..][..N].copy_from_slice(&element);
    }
    Ok(())
}
