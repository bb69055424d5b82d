//! Names of files: from the file that refers to them, and from a folder to which a document moves.

use crate::document::Document;
use crate::error::{Note, Place, ReadError, ReadErrorKind, printable};
use crate::material::ImageData;
use crate::regular_file::load;
use crate::resources::Resources;
use std::path::{Component, Path, PathBuf};
use std::sync::Arc;

/// Files that names may lead to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum AllowedFolders {
    /// Files of the folder and of its folders.
    Folder,
    /// Also files with absolute names, which `read_file` has checked.
    FolderAndAbsoluteNames,
    /// All files.
    Everywhere,
}

/// The folder of a file, in which the names of other files in that file are looked up.
pub(crate) struct Folder {
    path: PathBuf,
    /// The path without links, if the folder exists.
    absolute: PathBuf,
    allowed_folders: AllowedFolders,
}

impl Folder {
    /// Returns the folder of a file that is read. `follow_outside` allows names that lead out of the folder.
    pub(crate) fn for_reading(file: &Path, follow_outside: bool) -> Self {
        Self::new(file, if follow_outside { AllowedFolders::Everywhere } else { AllowedFolders::Folder })
    }

    /// Returns the folder of a file that is written. Allows absolute names, which `read_file` has checked.
    pub(crate) fn for_writing(file: &Path) -> Self {
        Self::new(file, AllowedFolders::FolderAndAbsoluteNames)
    }

    fn new(file: &Path, reach: AllowedFolders) -> Self {
        let path = folder_path(file);
        let absolute = path.canonicalize().or_else(|_| std::path::absolute(&path)).unwrap_or_else(|_| path.clone());
        Self { path, absolute, allowed_folders: reach }
    }

    /// Returns the path of a named file. Fails if the file is outside of the reach.
    fn path_from_name(&self, name: &str) -> Result<PathBuf, ReadError> {
        let relative = Path::new(name);
        let path = self.path.join(relative);
        let is_allowed = match self.allowed_folders {
            AllowedFolders::Folder => false,
            AllowedFolders::FolderAndAbsoluteNames => relative.is_absolute(),
            AllowedFolders::Everywhere => true,
        };
        let is_inside = || {
            lexically_normal(relative).components().all(|part| matches!(part, Component::Normal(_)))
                // A link inside of the folder may lead out of it.
                && path.canonicalize().map_or(true, |file| file.starts_with(&self.absolute))
        };
        if is_allowed || is_inside() {
            return Ok(path);
        }
        Err(ReadError::new(
            ReadErrorKind::Unreadable,
            format!("the file {name} is outside of the folder, and is not followed"),
        ))
    }

    /// Makes the names of the document's files absolute. Drops images outside of the folder, unless they may be followed.
    pub(crate) fn make_names_absolute(&self, document: &mut Document) -> Result<(), ReadError> {
        for image in &mut document.images {
            let ImageData::File(name) = &image.data else { continue };
            if let Err(error) = self.path_from_name(&name.replace('\\', "/")) {
                document.notes.push(Note::new(Place::Whole, format!("image left out: {}", error.message)));
                image.data = ImageData::Bytes(Arc::default());
            }
        }
        document.rename_files(|name| self.absolute_name(name))
    }

    fn absolute_name(&self, name: &str) -> String {
        if name.is_empty() || name.contains("://") || has_drive(name) {
            return name.to_owned();
        }
        let path = lexically_normal(&self.absolute.join(name.replace('\\', "/")));
        path.to_str().map_or_else(|| name.to_owned(), str::to_owned)
    }
}

impl Resources for Folder {
    fn load(&self, name: &str) -> Result<Vec<u8>, ReadError> {
        let name = name.replace('\\', "/");
        let path = self.path_from_name(&name)?;
        load(&path).map_err(|error| ReadError { message: format!("{}: {}", printable(&name), error.message), ..error })
    }

    fn written_name(&self, name: &str) -> String {
        let path = Path::new(name);
        if !path.is_absolute() {
            return name.to_owned();
        }
        let relative = relative_path(&lexically_normal(path), &self.absolute);
        relative.unwrap_or_else(|| name.to_owned())
    }
}

/// Returns the folder of a file: `.` for a name alone.
pub(crate) fn folder_path(path: &Path) -> PathBuf {
    match path.parent() {
        Some(parent) if !parent.as_os_str().is_empty() => parent.to_path_buf(),
        _ => PathBuf::from("."),
    }
}

/// Returns whether a name begins like `C:`, as absolute names do on Windows.
fn has_drive(name: &str) -> bool {
    matches!(name.as_bytes(), [drive, b':', ..] if drive.is_ascii_alphabetic())
}

/// Removes `.` and each folder before `..`, without a look at the disk.
fn lexically_normal(path: &Path) -> PathBuf {
    let mut made = PathBuf::new();
    for part in path.components() {
        let is_after_folder = matches!(made.components().next_back(), Some(Component::Normal(_)));
        match part {
            Component::CurDir => {}
            Component::ParentDir if is_after_folder => {
                made.pop();
            }
            Component::ParentDir if made.has_root() => {}
            _ => made.push(part),
        }
    }
    made
}

/// Returns a file as it is named from a folder, with slashes. Both are absolute. Returns `None` if they are on different drives, or if
/// the name is not Unicode.
fn relative_path(file: &Path, folder: &Path) -> Option<String> {
    let [files, folders] = [file, folder].map(|path| path.components().collect::<Vec<_>>());
    let common = files.iter().zip(&folders).take_while(|(a, b)| a == b).count();
    let is_one_drive = common > 0 && folders[common..].iter().all(|part| matches!(part, Component::Normal(_)));
    let up = folders[common..].iter().map(|_| Some(".."));
    let down = files[common..].iter().map(|part| part.as_os_str().to_str());
    let parts: Option<Vec<&str>> = up.chain(down).collect();
    parts.filter(|_| is_one_drive).map(|parts| parts.join("/"))
}
