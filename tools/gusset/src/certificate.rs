//! Certificates of files: facts about a result and the files that it was made from, as JSON for `verify.py`.

use crate::failure::Failure;
use crate::pieces::Piece;
use crate::plugin::{Certificate, Plugin};
use crate::reading::{FileName, Reading};
use crate::steering::Steering;
use crate::writing::print;
use gusset_io::Mesh;
use serde_json::{Value, json};
use sha2::{Digest, Sha256};
use std::path::{Path, PathBuf};

/// The format of the file, which `verify.py` knows.
const FORMAT: &str = "gusset certificate 1";

/// Writes the certificate of a result to a file, or to standard output. Reads the files anew, because formats may round positions.
pub(crate) fn write_certificate(
    plugin: Plugin,
    [inputs, result]: [&[FileName]; 2],
    to: &FileName,
    reading: &Reading,
    threads: u32,
    steering: &Steering,
) -> Result<(), Failure> {
    let inputs = inputs.iter().map(|file| HashedMesh::read(file, reading)).collect::<Result<Vec<_>, Failure>>()?;
    let result = result.iter().map(|file| HashedMesh::read(file, reading)).next();
    let result = result.ok_or_else(|| Failure::usage("a certificate is about a result: name its file"))??;
    let meshes: Vec<&Mesh> = inputs.iter().map(|input| &input.piece.mesh).collect();
    let made = Certificate::new(plugin, &meshes, &result.piece.mesh, threads, steering)?;
    let text = format!("{}\n", describe(plugin, &inputs, &result, &made)?);
    match to {
        FileName::Standard => print(&text),
        FileName::Path(path) => {
            std::fs::write(path, text).map_err(|error| Failure::file(format!("{}: {error}", to.shown())))
        }
    }
}

/// Refuses inputs and results of which a certificate cannot state hashes.
pub(crate) fn check_files(inputs: &[FileName], result: &FileName) -> Result<(), Failure> {
    let path = |file: &FileName| if let FileName::Path(path) = file { Some(path.clone()) } else { None };
    let place = path(result).and_then(|path| path.canonicalize().ok());
    for file in inputs.iter().chain([result]) {
        if path(file).is_none() {
            return Err(Failure::usage("a certificate states the hashes of files: name files instead of -"));
        }
    }
    let is_replaced =
        |file: &FileName| place.is_some() && path(file).and_then(|path| path.canonicalize().ok()) == place;
    match inputs.iter().find(|file| is_replaced(file)) {
        Some(file) => Err(Failure::usage(format!(
            "{} would be replaced, and a certificate is about inputs and result: name another file for the result",
            file.shown()
        ))),
        None => Ok(()),
    }
}

/// Refuses to write a page or certificate over one of the meshes.
pub(crate) fn refuse_replacing_mesh<'f>(
    written: &FileName,
    mut meshes: impl Iterator<Item = &'f FileName>,
) -> Result<(), Failure> {
    /// The folder and name of a file that need not exist yet.
    fn place(file: &FileName) -> Option<PathBuf> {
        let FileName::Path(path) = file else { return None };
        let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
        path.canonicalize().ok().or_else(|| Some(folder.canonicalize().ok()?.join(path.file_name()?)))
    }
    let own = place(written);
    match meshes.find(|mesh| own.is_some() && place(mesh) == own) {
        Some(mesh) => Err(Failure::usage(format!("{} is a mesh of this command: name another file", mesh.shown()))),
        None => Ok(()),
    }
}

/// A mesh with the hash of its file.
struct HashedMesh {
    name: String,
    hash: String,
    piece: Piece,
}

impl HashedMesh {
    fn read(file: &FileName, reading: &Reading) -> Result<Self, Failure> {
        let FileName::Path(path) = file else {
            return Err(Failure::usage("a certificate states the hashes of files: name files instead of -"));
        };
        Ok(Self { name: path.to_string_lossy().into_owned(), hash: hash_file(path)?, piece: reading.mesh(file)? })
    }

    fn point(&self, vertex: u32) -> [f64; 3] {
        // JSON keeps the sign of -0, which nobody needs.
        self.piece.mesh.positions.get(vertex as usize).map(|x| x + 0.0)
    }

    fn describe(&self) -> Value {
        json!({ "file": self.name, "sha256": self.hash, "faces": self.piece.mesh.face_count() })
    }
}

fn hash_file(path: &Path) -> Result<String, Failure> {
    let failure = |error: std::io::Error| Failure::file(format!("{}: {error}", path.display()));
    let mut hasher = Sha256::new();
    std::io::copy(&mut std::fs::File::open(path).map_err(failure)?, &mut hasher).map_err(failure)?;
    Ok(hasher.finalize().iter().map(|byte| format!("{byte:02x}")).collect())
}

fn describe(plugin: Plugin, inputs: &[HashedMesh], result: &HashedMesh, made: &Certificate) -> Result<Value, Failure> {
    let view = made.view()?;
    let faces_by_input = |pairs: &[u32]| -> Vec<Vec<u32>> {
        let mut lists = vec![Vec::new(); inputs.len()];
        pairs.chunks_exact(2).for_each(|pair| lists[pair[0] as usize].push(pair[1]));
        lists
    };
    let farthest = inputs.get(view.farthest_piece as usize).map(|input| {
        json!({
            "distance": view.farthest_distance,
            "at": input.point(view.farthest_vertex),
            "nearest": result.point(view.nearest_vertex),
        })
    });
    let claims = json!({
        "vertices": view.vertex_count,
        "edges": view.edge_count,
        "faces": view.face_count,
        "components": view.component_count,
        "closed": view.closed != 0,
        "manifold": view.non_manifold_vertices == 0,
        "oriented": view.orientation_conflicts == 0,
        "outward": view.outward != 0,
        "no_intersecting_faces": view.intersecting_pairs == 0,
        "boundary_edges": view.boundary_edges,
        "non_manifold_edges": view.non_manifold_edges,
        "non_manifold_vertices": view.non_manifold_vertices,
        "orientation_conflicts": view.orientation_conflicts,
        "degenerate_faces": view.degenerate_faces,
        "duplicate_faces": view.duplicate_faces,
        "collinear_triangles": view.collinear_triangles,
        "intersecting_pairs": view.intersecting_pairs,
        "kept_faces": view.kept_faces,
        "new_faces": view.new_faces,
        "turned_faces": faces_by_input(made.list(view.turned_faces)),
        "lost_faces": faces_by_input(made.list(view.lost_faces)),
        "farthest_vertex": farthest,
    });
    let triangles: Vec<&[u32]> = made.list(view.polygon_triangles).chunks_exact(3).collect();
    Ok(json!({
        "format": FORMAT,
        "library": plugin.title(),
        "inputs": inputs.iter().map(HashedMesh::describe).collect::<Vec<_>>(),
        "result": result.describe(),
        "claims": claims,
        "polygon_triangles": triangles,
    }))
}
