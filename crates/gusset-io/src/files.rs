//! Files by their paths: regular files only, nothing outside of a file's folder, and complete or unchanged.

use crate::document::Document;
use crate::error::{Loss, ReadError, ReadErrorKind, WriteError, WriteErrorKind};
use crate::format::{Format, read, write};
use crate::options::{ReadOptions, WriteOptions};
use crate::resources::{Resources, Target};
use std::fs::File;
use std::io::{BufWriter, Read};
use std::path::{Component, Path, PathBuf};

/// Reads a file, in the format of its extension.
///
/// # Errors
/// `Unreadable` if it is not a regular file, `Unsupported` if the extension is unknown, and the errors of [`read`](crate::read).
pub fn read_file(path: &Path, options: &ReadOptions) -> Result<Document, ReadError> {
    let format = format_from_path(path).ok_or_else(|| ReadError::unsupported(unknown_extension(path)))?;
    let bytes = load(path)?;
    let folder = Folder { path: folder_path(path), follow_outside: options.follow_outside };
    read(&bytes, format, &folder, options)
}

/// Writes a file, in the format of its extension. The old file stays until the new one is complete. Returns what was lost.
///
/// # Errors
/// `Unsupported` if the extension is unknown, `Unwritable`, and the errors of [`write`](crate::write).
pub fn write_file(path: &Path, document: &Document, options: &WriteOptions) -> Result<Vec<Loss>, WriteError> {
    let format =
        format_from_path(path).ok_or_else(|| WriteError::new(WriteErrorKind::Unsupported, unknown_extension(path)))?;
    let folder = folder_path(path);
    let mut pending = vec![(PendingFile::create(path)?, path.to_path_buf())];
    let mut beside: Vec<(PendingFile, PathBuf)> = Vec::new();
    let stem = path.file_stem().map_or_else(|| "mesh".into(), std::ffi::OsStr::to_string_lossy);
    let losses = {
        let mut out = BufWriter::new(Stoppable { file: &mut pending[0].0.file, stop: options.stop.as_deref() });
        let mut add = |name: &str, bytes: &[u8]| {
            let path = folder.join(name);
            let mut file = PendingFile::create(&path)?;
            std::io::Write::write_all(&mut file.file, bytes)?;
            beside.push((file, path));
            Ok(())
        };
        let resources = Folder { path: folder.clone(), follow_outside: true };
        let losses = write(
            document,
            format,
            &mut Target { main: &mut out, stem: &stem, beside: &mut add, resources: &resources },
            options,
        )?;
        std::io::Write::flush(&mut out)?;
        losses
    };
    // Files that the main one refers to come first.
    for (file, path) in beside.into_iter().chain(pending) {
        file.replace(&path)?;
    }
    Ok(losses)
}

/// A file whose writing can be stopped.
struct Stoppable<'a> {
    file: &'a mut tempfile::NamedTempFile,
    stop: Option<&'a (dyn Fn() -> bool + Send + Sync)>,
}

impl std::io::Write for Stoppable<'_> {
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
    match path.extension() {
        Some(extension) => {
            format!("the extension .{} is unknown; use {}", extension.to_string_lossy(), known.join(", "))
        }
        None => format!("the name lacks an extension; use {}", known.join(", ")),
    }
}

fn folder_path(path: &Path) -> PathBuf {
    match path.parent() {
        Some(parent) if !parent.as_os_str().is_empty() => parent.to_path_buf(),
        _ => PathBuf::from("."),
    }
}

/// Loads a regular file. Pipes, devices and folders are refused without being opened for reading.
fn load(path: &Path) -> Result<Vec<u8>, ReadError> {
    let unreadable = |why: String| ReadError::new(ReadErrorKind::Unreadable, why);
    let status = std::fs::metadata(path).map_err(|error| unreadable(reason(&error)))?;
    if !status.is_file() {
        return Err(unreadable("this is not a regular file".into()));
    }
    let mut file = File::open(path).map_err(|error| unreadable(reason(&error)))?;
    let size = file.metadata().map_err(|error| unreadable(reason(&error)))?.len();
    let mut bytes = Vec::new();
    let size = usize::try_from(size).map_err(|_| ReadError::out_of_memory())?;
    bytes.try_reserve_exact(size)?;
    std::io::Read::by_ref(&mut file)
        .take(size as u64)
        .read_to_end(&mut bytes)
        .map_err(|error| unreadable(reason(&error)))?;
    Ok(bytes)
}

fn reason(error: &std::io::Error) -> String {
    match error.kind() {
        std::io::ErrorKind::NotFound => "the file does not exist".into(),
        std::io::ErrorKind::PermissionDenied => "permission denied".into(),
        _ => error.to_string(),
    }
}

/// Files of a folder and of its folders.
struct Folder {
    path: PathBuf,
    follow_outside: bool,
}

impl Resources for Folder {
    fn load(&self, name: &str) -> Result<Vec<u8>, ReadError> {
        let name = name.replace('\\', "/");
        let relative = Path::new(&name);
        let outside = || {
            ReadError::new(
                ReadErrorKind::Unreadable,
                format!("the file {name} is outside of the folder; allow it with follow_outside"),
            )
        };
        if !self.follow_outside {
            if relative.components().any(|part| !matches!(part, Component::Normal(_) | Component::CurDir)) {
                return Err(outside());
            }
            // A link inside of the folder may lead out of it.
            if let (Ok(folder), Ok(file)) = (self.path.canonicalize(), self.path.join(relative).canonicalize())
                && !file.starts_with(&folder)
            {
                return Err(outside());
            }
        }
        load(&self.path.join(relative)).map_err(|error| ReadError {
            message: format!("{}: {}", crate::error::printable(&name), error.message),
            ..error
        })
    }
}

/// A file under another name until it is complete.
struct PendingFile {
    file: tempfile::NamedTempFile,
}

impl PendingFile {
    fn create(path: &Path) -> std::io::Result<Self> {
        if std::fs::metadata(path).is_ok_and(|status| status.is_dir()) {
            return Err(std::io::Error::other("this is a folder"));
        }
        let mut builder = tempfile::Builder::new();
        builder.prefix(".gusset-");
        #[cfg(unix)]
        builder.permissions(
            std::fs::metadata(path)
                .map_or_else(|_| std::os::unix::fs::PermissionsExt::from_mode(0o666), |status| status.permissions()),
        );
        let file = builder.tempfile_in(folder_path(path))?;
        Ok(Self { file })
    }

    /// Gives the file its name, once its bytes are on the disk.
    fn replace(self, path: &Path) -> std::io::Result<()> {
        self.file.as_file().sync_all()?;
        // A link is followed, so that the file that it leads to is replaced.
        let path = path.canonicalize().unwrap_or_else(|_| path.to_path_buf());
        self.file.persist(path).map(|_| ()).map_err(|error| error.error)
    }
}
