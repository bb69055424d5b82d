//! The inputs and outputs of filters.

use super::report::Report;
use glam::DVec3;
use gusset_attributes::Origins;
use gusset_base::alloc;
use gusset_base::error::{Element, Error, Result};
use gusset_mesh::{Mesh, MeshView, PositionBuffer};

/// The kind of an input.
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
    /// [`Error::InputUnfit`] for curves.
    pub(super) fn mesh(&self) -> Result<&MeshView<'a>> {
        match self {
            Input::Mesh(mesh) => Ok(mesh),
            Input::Curves(_) => Err(InputKind::Curves.wrong_kind_error(0)),
        }
    }

    /// The polylines.
    ///
    /// # Errors
    /// [`Error::InputUnfit`] for a mesh.
    pub(super) fn curves(&self) -> Result<&'a Curves> {
        match self {
            Input::Curves(curves) => Ok(curves),
            Input::Mesh(_) => Err(InputKind::Mesh.wrong_kind_error(0)),
        }
    }
}

impl InputKind {
    /// The error of an input of this kind where the other kind is needed.
    pub(super) fn wrong_kind_error(self, place: usize) -> Error {
        let why = match self {
            InputKind::Mesh => "curves are needed, not a mesh",
            InputKind::Curves => "a mesh is needed, not curves",
        };
        Error::InputUnfit { input: place as u32, why }
    }
}

/// The kind of an output.
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
#[derive(Debug, PartialEq)]
pub enum Output {
    /// A polygon mesh, and the origins of its elements if the filter has them and was asked for
    /// them.
    Mesh(Mesh, Option<Box<Origins>>),
    /// Polylines.
    Curves(Curves),
    /// Lines of text for a log window, and the numbers in them.
    Text(Report),
}

/// Polylines: curve c has the points `offsets[c] .. offsets[c + 1]`, and if it is closed, an edge
/// from the last to the first.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Curves {
    /// The points of all curves.
    pub points: Vec<[f64; 3]>,
    /// The first point of each curve, and the number of all points at the end.
    pub offsets: Vec<u32>,
    /// Per curve.
    pub closed: Vec<bool>,
}

impl Curves {
    /// Checks that the offsets fit the points, and that each curve has a flag.
    ///
    /// # Errors
    /// [`Error::BadOffsets`] with the first entry that does not fit. It is the entry after the last
    /// without offsets, or if the numbers of flags and curves differ.
    pub fn check(&self) -> Result<()> {
        Error::check_offsets(&self.offsets, self.points.len())?;
        if self.offsets.len() == self.closed.len() + 1 {
            return Ok(());
        }
        Err(Error::BadOffsets { entry: self.offsets.len() as u32, value: self.points.len() as u32 })
    }
}

/// The points of one curve, and whether it is closed.
pub(super) type Polyline<'a> = (&'a [[f64; 3]], bool);

impl Curves {
    /// No curves yet.
    pub(super) fn without_curves() -> Self {
        Curves { offsets: vec![0], ..Curves::default() }
    }

    /// Appends a curve.
    ///
    /// # Errors
    /// [`Error::TooLarge`], [`Error::OutOfMemory`].
    pub(super) fn add_curve(&mut self, points: impl ExactSizeIterator<Item = DVec3>, closed: bool) -> Result<()> {
        alloc::extend(&mut self.points, points.map(|point| point.to_array()))?;
        Error::check_count("points", self.points.len() as u64, u32::MAX.into())?;
        alloc::push(&mut self.offsets, self.points.len() as u32)?;
        alloc::push(&mut self.closed, closed)
    }

    /// The points of each curve, and whether it is closed.
    ///
    /// # Errors
    /// [`Error::BadOffsets`], [`Error::NotFinite`] with an index among all points.
    pub(super) fn polylines(&self) -> Result<Vec<Polyline<'_>>> {
        // Without offsets the list is empty.
        if self.offsets.is_empty() && self.points.is_empty() {
            return Ok(Vec::new());
        }
        (0..).zip(&self.points).try_for_each(|(k, &p)| Error::check_finite(Element::Point, k, p.into()))?;
        self.check()?;
        let curves = self.offsets.windows(2).zip(&self.closed);
        alloc::collect(curves.map(|(ends, &closed)| (&self.points[ends[0] as usize..ends[1] as usize], closed)))
    }
}

/// Checks that two meshes have the same faces, and as many vertices.
///
/// # Errors
/// [`Error::InputUnfit`] for the second mesh, which is input `place`.
pub(super) fn require_same_faces(a: &MeshView<'_>, b: &MeshView<'_>, place: u32) -> Result<()> {
    let (faces, others) = (a.faces(), b.faces());
    let same = a.positions().len() == b.positions().len()
        && faces.len() == others.len()
        && faces.half_edge_count() == others.half_edge_count()
        && (0..faces.len()).all(|f| faces.corner_range(f) == others.corner_range(f))
        && faces.corners(0..faces.half_edge_count()).eq(others.corners(0..faces.half_edge_count()));
    let unfit = Error::InputUnfit { input: place, why: "a mesh with the same faces as the one before is needed" };
    if same { Ok(()) } else { Err(unfit) }
}

/// A mesh with the faces of another mesh and its own positions.
pub(super) fn mesh_with_positions(mesh: &MeshView<'_>, positions: PositionBuffer) -> Result<Mesh> {
    let faces = mesh.faces();
    let offsets = (0..faces.len() + 1).map(|f| if f == 0 { 0 } else { faces.corner_range(f - 1).end as u32 });
    let face_corners = alloc::collect(faces.corners(0..faces.half_edge_count()))?;
    Ok(Mesh::new(positions, alloc::collect(offsets)?, face_corners))
}
