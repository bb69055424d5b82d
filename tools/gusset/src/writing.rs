//! Output files and standard output.

use crate::failure::{Exit, Failure};
use crate::pieces::write_failure;
use crate::reading::FileName;
use gusset_io::{Content, Document, Format, Loss, NoResources, Target, WriteErrorKind, WriteOptions};
use std::io::{self, BufWriter, Write};

/// How files are written.
#[derive(Clone, Debug, Default)]
pub(crate) struct Writing {
    pub(crate) options: WriteOptions,
    /// Format of standard output.
    pub(crate) to: Option<Format>,
}

impl Writing {
    /// Refuses a file whose format cannot hold the content, before any work is done.
    pub(crate) fn check(&self, file: &FileName, content: Content) -> Result<(), Failure> {
        let format = self.format(file)?;
        if format.holds(content) {
            return Ok(());
        }
        let what = match content {
            Content::Meshes => "meshes",
            Content::Curves => "curves",
            Content::Points => "points",
        };
        let able: Vec<String> = Format::ALL
            .iter()
            .filter(|(format, _)| format.holds(content))
            .map(|(format, _)| format!(".{}", format.extension()))
            .collect();
        Err(Failure::file(format!(
            "{}: .{} files do not hold {what}; use {}",
            file.shown(),
            format.extension(),
            able.join(", ")
        )))
    }

    fn format(&self, file: &FileName) -> Result<Format, Failure> {
        match file {
            FileName::Standard => {
                self.to.ok_or_else(|| Failure::usage("-o - needs the format: --to, such as --to ply"))
            }
            FileName::Path(path) => {
                let name = path.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
                Format::from_name(&name).ok_or_else(|| {
                    let known: Vec<String> =
                        Format::ALL.iter().map(|(format, _)| format!(".{}", format.extension())).collect();
                    Failure::file(format!("{}: the format is unknown; use {}", file.shown(), known.join(", ")))
                })
            }
        }
    }

    /// Writes a document. Tells what was lost on standard error, after `lost_before`, and returns it.
    pub(crate) fn write(
        &self,
        file: &FileName,
        document: &Document,
        lost_before: Vec<String>,
    ) -> Result<Vec<String>, Failure> {
        let shown = file.shown();
        let losses = match file {
            FileName::Path(path) => gusset_io::write_file(path, document, &self.options),
            FileName::Standard => self.write_standard(document, self.format(file)?),
        };
        let losses = losses.map_err(|error| {
            let is_stopped = error.kind == WriteErrorKind::Unwritable && crate::steering::is_stopped();
            if is_stopped { Failure::new(Exit::Cancelled, "cancelled") } else { write_failure(&shown, &error) }
        })?;
        let mut lost = lost_before;
        lost.extend(losses.into_iter().map(|Loss(what)| what));
        for what in &lost {
            crate::writing::tell!("gusset: {shown}: lost: {what}");
        }
        Ok(lost)
    }

    fn write_standard(&self, document: &Document, format: Format) -> Result<Vec<Loss>, gusset_io::WriteError> {
        let mut out = BufWriter::new(io::stdout().lock());
        let mut refuse = |name: &str, _: &[u8]| {
            let text = format!("standard output cannot hold the file {name} beside it");
            Err(io::Error::new(io::ErrorKind::Unsupported, text))
        };
        let mut target = Target { main_file: &mut out, stem: "mesh", beside: &mut refuse, resources: &NoResources };
        let losses = gusset_io::write(document, format, &mut target, &self.options)?;
        out.flush()?;
        Ok(losses)
    }
}

/// Writes a line to standard error. If that fails, nobody can be told.
macro_rules! tell {
    ($($argument:tt)*) => {{
        use std::io::Write as _;
        let _ = writeln!(std::io::stderr(), $($argument)*);
    }};
}
pub(crate) use tell;

/// Writes a report to standard output. A reader that has closed the pipe wants no more of it.
pub(crate) fn print(text: &str) -> Result<(), Failure> {
    let mut out = io::stdout().lock();
    match out.write_all(text.as_bytes()).and_then(|()| out.flush()) {
        Err(error) if error.kind() != io::ErrorKind::BrokenPipe => {
            Err(Failure::file(format!("standard output cannot be written: {error}")))
        }
        _ => Ok(()),
    }
}
