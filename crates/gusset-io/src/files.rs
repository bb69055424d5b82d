//! Files by their paths: regular files only, nothing outside of a file's folder, and complete or unchanged.

use crate::dispatch::{read, write};
use crate::document::Document;
use crate::error::{Loss, ReadError, WriteError, WriteErrorKind, write_reason};
use crate::folder::{Folder, folder_path};
use crate::format::Format;
use crate::options::{ReadOptions, WriteOptions};
use crate::pending_file::PendingFile;
use crate::regular_file::load;
use crate::resources::Target;
use std::ffi::OsStr;
use std::io::{BufWriter, Write};
use std::path::Path;

/// Reads a file, in the format of its extension.
///
/// Names of images become absolute, so that the document can be written to another folder. Images outside of the file's folder are left
/// out with a note, unless `follow_outside` is set.
///
/// # Errors
/// `Unreadable` if it is not a regular file, `Unsupported` if the extension is unknown, and the errors of [`read`](crate::read).
pub fn read_file(path: &Path, options: &ReadOptions) -> Result<Document, ReadError> {
    let format = format_from_path(path).ok_or_else(|| ReadError::unsupported(unknown_extension(path)))?;
    let bytes = load(path)?;
    let folder = Folder::for_reading(path, options.follow_outside);
    let mut document = read(&bytes, format, &folder, options)?;
    folder.make_names_absolute(&mut document)?;
    Ok(document)
}

/// Writes a file, in the format of its extension. The old file stays until the new one is complete. Returns what was lost.
///
/// Absolute names of images become relative to the folder of the file.
///
/// # Errors
/// `Unsupported` if the extension is unknown, `Unwritable`, and the errors of [`write`](crate::write).
pub fn write_file(path: &Path, document: &Document, options: &WriteOptions) -> Result<Vec<Loss>, WriteError> {
    let format =
        format_from_path(path).ok_or_else(|| WriteError::new(WriteErrorKind::Unsupported, unknown_extension(path)))?;
    let mut main = PendingFile::create(path)?;
    let mut beside: Vec<PendingFile> = Vec::new();
    let stem = path.file_stem().map_or_else(|| "mesh".into(), OsStr::to_string_lossy);
    let mut out = BufWriter::new(Stoppable { file: &mut main, stop: options.stop.as_deref() });
    let mut add = |name: &str, bytes: &[u8]| {
        let mut add_pending = || {
            let mut file = PendingFile::create(&folder_path(path).join(name))?;
            file.write_all(bytes)?;
            beside.push(file);
            Ok(())
        };
        add_pending()
            .map_err(|error: std::io::Error| std::io::Error::other(format!("{name}: {}", write_reason(&error))))
    };
    let resources = Folder::for_writing(path);
    let mut target = Target { main_file: &mut out, stem: &stem, beside: &mut add, resources: &resources };
    let losses = write(document, format, &mut target, options)?;
    out.flush()?;
    drop(out);
    // Files that the main one refers to come first.
    for file in beside.into_iter().chain([main]) {
        file.commit()?;
    }
    Ok(losses)
}

/// A file whose writing can be stopped.
struct Stoppable<'a> {
    file: &'a mut PendingFile,
    stop: Option<&'a (dyn Fn() -> bool + Send + Sync)>,
}

impl Write for Stoppable<'_> {
    fn write(&mut self, bytes: &[u8]) -> std::io::Result<usize> {
        if self.stop.is_some_and(|stop| stop()) {
            return Err(std::io::Error::other("stopped"));
        }
        self.file.write(bytes)
    }

    fn flush(&mut self) -> std::io::Result<()> {
        self.file.flush()
    }
}

fn format_from_path(path: &Path) -> Option<Format> {
    Format::from_extension(&path.extension()?.to_str()?.to_ascii_lowercase())
}

fn unknown_extension(path: &Path) -> String {
    let known: Vec<String> = Format::ALL.iter().map(|(format, _)| format!(".{}", format.extension())).collect();
    let known = known.join(", ");
    let Some(extension) = path.extension() else { return format!("the name lacks an extension; use {known}") };
    let extension = extension.to_string_lossy();
    let remedy = match &*extension.to_ascii_lowercase() {
        "gz" | "tgz" => "it is compressed; decompress it by gunzip",
        "zip" | "7z" | "rar" => "it is an archive; extract it",
        "xz" => "it is compressed; decompress it by unxz",
        "zst" => "it is compressed; decompress it by unzstd",
        "bz2" => "it is compressed; decompress it by bunzip2",
        "fbx" | "blend" | "dae" | "3ds" | "usd" | "usda" | "usdc" | "usdz" | "abc" | "x3d" | "wrl" | "vrml" | "lwo" => {
            "convert it by Blender or assimp"
        }
        "step" | "stp" | "iges" | "igs" | "brep" | "fcstd" | "x_t" | "sldprt" | "ifc" => "convert it by FreeCAD",
        "vtk" | "vtu" | "vtp" | "msh" | "inp" | "nas" | "bdf" | "xdmf" => "convert it by meshio",
        "las" | "laz" | "e57" | "pcd" => "convert it by CloudCompare",
        _ => return format!("the extension .{extension} is unknown; use {known}"),
    };
    format!("files with the extension .{extension} are not supported; {remedy}")
}
