//! Origins of the meshes of nets and of sheets, whose sources are nodes and cells.

use super::domain::Counts;
use super::origins::{Kept, Origins};
use super::table::{STAGE, Table};
use crate::error::Result;
use crate::job::Job;
use crate::net::convert::NetMesh;
use crate::surface::SurfaceMesh;

/// Of a grid of nodes: they are its vertices and its corners.
fn counts(rows: usize, columns: usize) -> Counts {
    let nodes = rows * columns;
    Counts { vertices: nodes, corners: nodes, faces: rows.saturating_sub(1) * columns.saturating_sub(1) }
}

impl Origins {
    /// Those of the mesh of a net: a vertex has the first of its nodes, a corner the node of its own
    /// face's cell, on either side of a seam another, and a face its cell.
    ///
    /// # Errors
    /// As [`Origins::of_stitch`].
    pub fn of_net_mesh(net: &NetMesh, job: &Job<'_>) -> Result<Origins> {
        let (mesh, columns) = (&net.mesh, net.columns);
        let vertices = Table::of_single(net.node_of_vertex.iter().copied(), &job.part(0.0, 0.2))?;
        let faces = Table::of_single(net.cell_of_face.iter().copied(), &job.part(0.2, 0.4))?;
        let mut corners = Table::with_capacity(mesh.face_corners.len(), mesh.face_corners.len())?;
        for (f, (&cell, face)) in net.cell_of_face.iter().zip(mesh.faces()).enumerate() {
            job.part(0.4, 1.0).step_within(f, STAGE)?;
            let cell = cell as usize;
            let first = cell / (columns - 1) * columns + cell % (columns - 1);
            let nodes = [first, first + columns, first + columns + 1, first + 1];
            for &v in face {
                let node = nodes.into_iter().find(|&node| net.vertex_of_node[node] == v);
                corners.push(node.map(|node| (node as u32, 1.0)))?;
            }
        }
        let inputs = vec![counts(net.vertex_of_node.len() / columns, columns)];
        Origins::of_kept(Kept { inputs, vertices, corners, faces })
    }

    /// Those of the mesh of a sheet: a vertex and a corner have the nodes of their cell, by its
    /// parameters; at a seam each corner has those of its own face's side. Faces have their cells.
    ///
    /// # Errors
    /// As [`Origins::of_stitch`].
    pub fn of_surface_mesh(sheet: &SurfaceMesh, job: &Job<'_>) -> Result<Origins> {
        let (mesh, lines) = (&sheet.mesh, &sheet.lines);
        let [rows, columns] = lines.cells;
        let nodes = |[i, j]: [u32; 2], [u, v]: [f64; 2]| {
            let first = i * (columns as u32 + 1) + j;
            let below = first + columns as u32 + 1;
            [(first, (1.0 - u) * (1.0 - v)), (below, u * (1.0 - v)), (first + 1, (1.0 - u) * v), (below + 1, u * v)]
        };
        let mut vertices = Table::with_capacity(sheet.places.len(), 4 * sheet.places.len())?;
        for (k, place) in sheet.places.iter().enumerate() {
            job.part(0.0, 0.3).step_within(k, STAGE)?;
            vertices.push(nodes(place.cell, [place.u, place.v]))?;
        }
        let mut corners = Table::with_capacity(mesh.face_corners.len(), 4 * mesh.face_corners.len())?;
        let mut faces = Table::with_capacity(mesh.face_count(), mesh.face_count())?;
        for (f, range) in mesh.face_offsets.windows(2).enumerate() {
            job.part(0.3, 1.0).step_within(f, STAGE)?;
            let (cell, parameters) = lines.of_face(range[0] as usize..range[1] as usize);
            for place in parameters {
                corners.push(nodes(cell, place))?;
            }
            faces.push([(cell[0] * columns as u32 + cell[1], 1.0)])?;
        }
        let inputs = vec![counts(rows + 1, columns + 1)];
        Origins::of_kept(Kept { inputs, vertices, corners, faces })
    }
}
