//! Files that are complete or unchanged: written under another name, and renamed at the end.

use crate::folder::folder_path;
use std::fs::{File, Metadata, OpenOptions};
use std::io::{self, Seek, Write};
use std::path::{Path, PathBuf};
#[cfg(unix)]
use std::time::{Duration, Instant};
use tempfile::NamedTempFile;

/// Largest number of links from one name to a file.
const MAX_LINKS: usize = 40;

/// A file that is being written.
pub(crate) enum PendingFile {
    /// A file in the folder of the target, which takes the target's name.
    Renamed { file: NamedTempFile, path: PathBuf, is_new: bool },
    /// A file elsewhere, whose bytes the existing target gets: in a folder where no file can be made, or if the target belongs to
    /// another user or has several names.
    Copied { file: File, target: File },
    /// A pipe or device, which gets the bytes at once.
    Direct(File),
}

impl PendingFile {
    /// Begins a file. Links are followed, so that the file that they lead to is replaced. A file that may not be written stays.
    pub(crate) fn create(path: &Path) -> io::Result<Self> {
        let existing = match std::fs::metadata(path) {
            Ok(status) => Some(status),
            Err(error) if error.kind() == io::ErrorKind::NotFound => None,
            Err(error) => return Err(error),
        };
        match existing {
            None => Self::create_new(followed(path)?),
            Some(status) if status.is_dir() => Err(io::Error::other("this is a folder")),
            Some(status) if status.is_file() => Self::create_over(followed(path)?, &status),
            Some(_) => open_stream(path).map(Self::Direct),
        }
    }

    fn create_new(path: PathBuf) -> io::Result<Self> {
        let file = file_beside(&path)?;
        Ok(Self::Renamed { file, path, is_new: true })
    }

    fn create_over(path: PathBuf, status: &Metadata) -> io::Result<Self> {
        let target = OpenOptions::new().write(true).open(&path)?;
        if !has_other_names(status)
            && let Ok(file) = file_beside(&path)
            && take_owner_and_permissions(file.as_file(), status).is_ok()
        {
            return Ok(Self::Renamed { file, path, is_new: false });
        }
        Ok(Self::Copied { file: tempfile::tempfile()?, target })
    }

    /// Gives the target the bytes. Its old bytes are lost only once the new ones are on the disk.
    pub(crate) fn commit(self) -> io::Result<()> {
        match self {
            Self::Direct(mut file) => file.flush(),
            Self::Copied { file, target } => copy_into(file, target),
            Self::Renamed { file, path, is_new } => {
                if !is_new {
                    file.as_file().sync_all()?;
                }
                let Err(refused) = file.persist(&path) else { return Ok(()) };
                if is_new {
                    return Err(refused.error);
                }
                // A file that is mounted by itself cannot be replaced.
                let target = OpenOptions::new().write(true).open(&path)?;
                copy_into(refused.file.reopen()?, target)
            }
        }
    }
}

impl Write for PendingFile {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        match self {
            Self::Renamed { file, .. } => file.write(bytes),
            Self::Copied { file, .. } | Self::Direct(file) => file.write(bytes),
        }
    }

    fn flush(&mut self) -> io::Result<()> {
        match self {
            Self::Renamed { file, .. } => file.flush(),
            Self::Copied { file, .. } | Self::Direct(file) => file.flush(),
        }
    }
}

/// Opens a pipe or device. A pipe that nobody reads would make the program wait without end.
#[cfg(unix)]
fn open_stream(path: &Path) -> io::Result<File> {
    use std::os::unix::fs::OpenOptionsExt;
    /// Time for the reader of a pipe to open it.
    const MAX_WAIT: Duration = Duration::from_secs(2);
    const PAUSE: Duration = Duration::from_millis(10);
    let end = Instant::now() + MAX_WAIT;
    loop {
        match OpenOptions::new().write(true).custom_flags(libc::O_NONBLOCK).open(path) {
            // Writing shall wait for the reader, unlike opening.
            Ok(_open_meanwhile) => return OpenOptions::new().write(true).open(path),
            Err(error) if error.raw_os_error() != Some(libc::ENXIO) => return Err(error),
            Err(_) if Instant::now() >= end => return Err(io::Error::other("no program reads this pipe")),
            Err(_) => std::thread::sleep(PAUSE),
        }
    }
}

#[cfg(not(unix))]
fn open_stream(path: &Path) -> io::Result<File> {
    OpenOptions::new().write(true).open(path)
}

/// Returns the path to which links lead; its file need not exist.
fn followed(path: &Path) -> io::Result<PathBuf> {
    let mut path = path.to_path_buf();
    for _ in 0..MAX_LINKS {
        match std::fs::read_link(&path) {
            Ok(link) => path = folder_path(&path).join(link),
            Err(_) => return Ok(path),
        }
    }
    Err(io::Error::other("links lead to each other without end"))
}

/// Creates a file with a name of its own in the folder of a file, with the permissions that new files get.
fn file_beside(path: &Path) -> io::Result<NamedTempFile> {
    let mut builder = tempfile::Builder::new();
    builder.prefix(".gusset-");
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
    // The error names the temporary file, which the user does not know.
    builder.tempfile_in(folder_path(path)).map_err(|error| error.kind().into())
}

#[cfg(unix)]
fn take_owner_and_permissions(file: &File, status: &Metadata) -> io::Result<()> {
    use std::os::unix::fs::{MetadataExt, fchown};
    let made = file.metadata()?;
    if (made.uid(), made.gid()) != (status.uid(), status.gid()) {
        fchown(file, Some(status.uid()), Some(status.gid()))?;
    }
    file.set_permissions(status.permissions())
}

/// Returns whether hard links give the file other names, which a new file would not have.
#[cfg(unix)]
fn has_other_names(status: &Metadata) -> bool {
    std::os::unix::fs::MetadataExt::nlink(status) > 1
}

#[cfg(not(unix))]
fn has_other_names(_: &Metadata) -> bool {
    false
}

#[cfg(not(unix))]
fn take_owner_and_permissions(file: &File, status: &Metadata) -> io::Result<()> {
    file.set_permissions(status.permissions())
}

fn copy_into(mut file: File, mut target: File) -> io::Result<()> {
    file.rewind()?;
    let length = io::copy(&mut file, &mut target)?;
    target.set_len(length)?;
    target.sync_all()
}
