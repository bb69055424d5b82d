//! Names of formats that a file has under a wrong extension.

use crate::error::ReadError;

/// First bytes of formats, their names, and what turns them into a format that the library reads.
const SIGNATURES: [(&[u8], &str); 20] = [
    (b"\x1f\x8b", "a gzip archive; unpack it by gunzip"),
    (b"PK\x03\x04", "a ZIP archive; unpack it by unzip, or name it .3mf if it is a 3MF file"),
    (b"\xfd7zXZ\0", "an xz archive; unpack it by unxz"),
    (b"\x28\xb5\x2f\xfd", "a Zstandard archive; unpack it by unzstd"),
    (b"BZh", "a bzip2 archive; unpack it by bunzip2"),
    (b"7z\xbc\xaf\x27\x1c", "a 7z archive; unpack it by 7z x"),
    (b"glTF", "a binary glTF file; name it .glb"),
    (b"ply\n", "a PLY file; name it .ply"),
    (b"ply\r", "a PLY file; name it .ply"),
    (b"ISO-10303-21", "a STEP file; convert it by FreeCAD or Gmsh"),
    (b"3D Geometry File Format", "a Rhino 3DM file; convert it by Rhino"),
    (b"Kaydara FBX Binary", "an FBX file; convert it by Blender or Assimp"),
    (b"BLENDER", "a Blender file; convert it by Blender"),
    (b"AC10", "a DWG file; convert it to DXF by LibreDWG (dwg2dxf) or ODA File Converter"),
    (b"\x89HDF\r\n\x1a\n", "an HDF5 file; convert it by meshio"),
    (b"$MeshFormat", "a Gmsh file; convert it by meshio or Gmsh"),
    (b"# vtk DataFile", "a VTK file; convert it by meshio or ParaView"),
    (b"version https://git-lfs", "a pointer to a file in Git LFS; get the file by git lfs pull"),
    (b"<!DOCTYPE html", "a web page, not the file that it offers; download the file itself"),
    (b"<html", "a web page, not the file that it offers; download the file itself"),
];

/// Makes the error for a file that begins as files of a known other format do.
pub(crate) fn refuse_foreign_file(bytes: &[u8]) -> Option<ReadError> {
    let (_, text) = SIGNATURES.iter().find(|(signature, _)| bytes.starts_with(signature))?;
    Some(ReadError::unsupported(format!("this is {text}")))
}
