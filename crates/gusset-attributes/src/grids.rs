//! Origins of the meshes of nets and sheets, whose sources are nodes and cells.

use super::domain::Counts;
use super::origins::{KeptElements, Origins};
use super::table::{STAGE, SourceTable};
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_mesh::MeshView;
use gusset_net::convert::{NetMesh, RecognisedNet};
use gusset_surface::SurfaceMesh;

/// The counts of a grid of nodes, which are both its vertices and its corners.
fn grid_counts(rows: usize, columns: usize) -> Counts {
    let nodes = rows * columns;
    Counts { vertices: nodes, corners: nodes, faces: rows.saturating_sub(1) * columns.saturating_sub(1) }
}

impl Origins {
    /// The origins of the mesh of a net. The source of a vertex is the first of its nodes. The
    /// source of a corner is the node of its face's cell, so both sides of a seam differ. The
    /// source of a face is its cell.
    ///
    /// # Errors
    /// The errors of [`Origins::from_stitch`].
    pub fn from_net_mesh(net: &NetMesh, job: &Job<'_>) -> Result<Origins> {
        let (mesh, columns) = (&net.mesh, net.columns);
        let vertices = SourceTable::from_single_sources(net.node_of_vertex.iter().copied(), &job.sub_job(0.0, 0.2))?;
        let faces = SourceTable::from_single_sources(net.cell_of_face.iter().copied(), &job.sub_job(0.2, 0.4))?;
        let mut corners = SourceTable::with_capacity(mesh.face_corners.len(), mesh.face_corners.len())?;
        for (f, (&cell, face)) in net.cell_of_face.iter().zip(mesh.faces()).enumerate() {
            job.sub_job(0.4, 1.0).step_within_list(f, STAGE)?;
            let cell = cell as usize;
            let first = cell / (columns - 1) * columns + cell % (columns - 1);
            let nodes = [first, first + columns, first + columns + 1, first + 1];
            for &v in face {
                let node = nodes.into_iter().find(|&node| net.vertex_of_node[node] == v);
                corners.push(node.map(|node| (node as u32, 1.0)))?;
            }
        }
        let inputs = vec![grid_counts(net.vertex_of_node.len() / columns, columns)];
        Origins::from_kept(KeptElements { inputs, vertices, corners, faces })
    }

    /// The origins of the mesh of a net that consists of some rows and columns of a mesh in rows
    /// and columns. Sources are the vertices, corners and faces of that mesh. The source of a cell
    /// between rows that were not adjacent is the old cell at its first node. Its corners come from
    /// the outermost old cells in it.
    ///
    /// # Errors
    /// The errors of [`Origins::from_stitch`].
    pub fn from_grid_mesh(
        input: &MeshView<'_>,
        grid: &RecognisedNet,
        [rows, columns]: [&[usize]; 2],
        made: &NetMesh,
        job: &Job<'_>,
    ) -> Result<Origins> {
        let (shape, faces) = (grid.net.shape(), input.faces());
        let wide = |[i, j]: [usize; 2], columns: usize| i * columns + j;
        let vertex_at = |node: [usize; 2]| {
            let old = [rows[node[0]], columns[node[1]]];
            grid.vertex_of_node[wide(old, shape.columns())]
        };
        let face_at = |cell: [usize; 2]| grid.face_of_cell[wide(cell, shape.columns() - 1)];
        let split = |k: u32, columns: usize| [k as usize / columns, k as usize % columns];
        let sources = made.node_of_vertex.iter().map(|&node| vertex_at(split(node, made.columns)));
        let vertices = SourceTable::from_single_sources(sources, &job.sub_job(0.0, 0.2))?;
        let count = made.mesh.face_count();
        let mut corners = SourceTable::with_capacity(made.mesh.face_corners.len(), made.mesh.face_corners.len())?;
        let mut of_faces = SourceTable::with_capacity(count, count)?;
        for (f, (&cell, face)) in made.cell_of_face.iter().zip(made.mesh.faces()).enumerate() {
            job.sub_job(0.2, 1.0).step_within_list(f, STAGE)?;
            let [i, j] = split(cell, made.columns - 1);
            of_faces.push([(face_at([rows[i], columns[j]]), 1.0)])?;
            for &v in face {
                let ends = [[0, 0], [1, 0], [1, 1], [0, 1]].into_iter();
                let end = ends
                    .map(|[down, right]| ([i + down, j + right], [down, right]))
                    .find(|&([i, j], _)| made.vertex_of_node[wide([i, j], made.columns)] == v);
                let corner = end.and_then(|([i, j], [down, right])| {
                    let old = face_at([rows[i] - down, columns[j] - right]);
                    faces.corner_range(old as usize).find(|&c| faces.corner(c as u32) == vertex_at([i, j]))
                });
                corners.push(corner.map(|corner| (corner as u32, 1.0)))?;
            }
        }
        let inputs = vec![Counts::from_mesh(input)];
        Origins::from_kept(KeptElements { inputs, vertices, corners, faces: of_faces })
    }

    /// The origins of the mesh of a sheet. The sources of a vertex or corner are the nodes of its
    /// cell, weighted by its parameters. At a seam, each corner uses the side of its own face. The
    /// source of a face is its cell.
    ///
    /// # Errors
    /// The errors of [`Origins::from_stitch`].
    pub fn from_surface_mesh(sheet: &SurfaceMesh, job: &Job<'_>) -> Result<Origins> {
        let (mesh, lines) = (&sheet.mesh, &sheet.lines);
        let [rows, columns] = lines.cells;
        let nodes = |[i, j]: [u32; 2], [u, v]: [f64; 2]| {
            let first = i * (columns as u32 + 1) + j;
            let below = first + columns as u32 + 1;
            [(first, (1.0 - u) * (1.0 - v)), (below, u * (1.0 - v)), (first + 1, (1.0 - u) * v), (below + 1, u * v)]
        };
        let mut vertices = SourceTable::with_capacity(sheet.places.len(), 4 * sheet.places.len())?;
        job.step(0.0, STAGE)?;
        for (k, place) in sheet.places.iter().enumerate() {
            job.sub_job(0.0, 0.3).step_within_list(k, STAGE)?;
            vertices.push(nodes(place.cell, [place.u, place.v]))?;
        }
        let mut corners = SourceTable::with_capacity(mesh.face_corners.len(), 4 * mesh.face_corners.len())?;
        let mut faces = SourceTable::with_capacity(mesh.face_count(), mesh.face_count())?;
        for (f, range) in mesh.face_offsets.windows(2).enumerate() {
            job.sub_job(0.3, 1.0).step_within_list(f, STAGE)?;
            let (cell, parameters) = lines.face_parameters(range[0] as usize..range[1] as usize);
            for place in parameters {
                corners.push(nodes(cell, place))?;
            }
            faces.push([(cell[0] * columns as u32 + cell[1], 1.0)])?;
        }
        let inputs = vec![grid_counts(rows + 1, columns + 1)];
        Origins::from_kept(KeptElements { inputs, vertices, corners, faces })
    }
}
