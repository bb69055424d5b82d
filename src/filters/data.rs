//! What goes into a filter and what comes out.

use crate::error::{Error, Result};
use crate::mesh::{Mesh, MeshView};

/// What an input is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum InputKind {
    /// A polygon mesh.
    Mesh,
    /// Polylines.
    Curves,
}

/// An input.
#[derive(Debug, Clone, Copy)]
pub enum Input<'a> {
    /// A polygon mesh.
    Mesh(MeshView<'a>),
    /// Polylines.
    Curves(&'a Curves),
}

impl<'a> Input<'a> {
    /// Its kind.
    pub fn kind(&self) -> InputKind {
        match self {
            Input::Mesh(_) => InputKind::Mesh,
            Input::Curves(_) => InputKind::Curves,
        }
    }

    /// The mesh.
    ///
    /// # Errors
    /// [`Error::OptionOutOfRange`]: it is none.
    pub(super) fn mesh(&self) -> Result<&MeshView<'a>> {
        match self {
            Input::Mesh(mesh) => Ok(mesh),
            Input::Curves(_) => Err(Error::OptionOutOfRange { option: "inputs", value: 0.0 }),
        }
    }

    /// The polylines.
    ///
    /// # Errors
    /// [`Error::OptionOutOfRange`]: they are none.
    pub(super) fn curves(&self) -> Result<&'a Curves> {
        match self {
            Input::Curves(curves) => Ok(curves),
            Input::Mesh(_) => Err(Error::OptionOutOfRange { option: "inputs", value: 0.0 }),
        }
    }
}

/// What an output is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum OutputKind {
    /// A polygon mesh.
    Mesh,
    /// Polylines.
    Curves,
    /// Lines of text for a log window.
    Text,
}

/// An output.
#[derive(Debug, Clone, PartialEq)]
pub enum Output {
    /// A polygon mesh.
    Mesh(Mesh),
    /// Polylines.
    Curves(Curves),
    /// Lines of text for a log window.
    Text(String),
}

impl Output {
    /// Its kind.
    pub fn kind(&self) -> OutputKind {
        match self {
            Output::Mesh(_) => OutputKind::Mesh,
            Output::Curves(_) => OutputKind::Curves,
            Output::Text(_) => OutputKind::Text,
        }
    }
}

/// Polylines: curve c has the points `offsets[c] .. offsets[c + 1]`, and if it is closed, an edge from the last to the first.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Curves {
    /// The points of all curves.
    pub points: Vec<[f64; 3]>,
    /// Where each curve's points start; one entry more than there are curves.
    pub offsets: Vec<u32>,
    /// Per curve.
    pub closed: Vec<bool>,
}

impl Curves {
    /// Whether the offsets fit the points, and there is a flag for each curve.
    ///
    /// # Errors
    /// [`Error::BadOffsets`] with the first entry that does not fit; without offsets, and with another number of flags than of
    /// curves, that is the entry after the last.
    pub fn check(&self) -> Result<()> {
        let bad = |entry: usize, value: u32| Err(Error::BadOffsets { entry: entry as u32, value });
        let mut before = 0;
        for (entry, &value) in self.offsets.iter().enumerate() {
            if value < before || (entry == 0 && value != 0) || value as usize > self.points.len() {
                return bad(entry, value);
            }
            before = value;
        }
        if self.offsets.len() != self.closed.len() + 1 {
            return bad(self.offsets.len(), before);
        }
        if before as usize != self.points.len() { bad(self.offsets.len() - 1, before) } else { Ok(()) }
    }
}
