//! The quotient complex of a net: the surface after identifying glued nodes.
//!
//! Vertices are classes of nodes. Edges are pairs of vertices that links join; links with the same
//! ends are one edge. Faces are the quads and triangles to which cells reduce; digons, points and
//! folds do not count. An edge without a face is a wire, such as the thread between two closed
//! nets. An edge of one face is boundary, and an edge of three or more a branch. Invariant: V - E +
//! F is the Euler characteristic.
//!
//! One pass over the rows counts the regular part and collects the rest, which is sorted by vertex.
//! O(nodes), plus a sort of the edges and corners at glued nodes.

mod boundary;
mod connectivity;
mod edges;
mod presence;
mod quotient;
mod row_scan;

pub use boundary::{BoundaryChains, Edge};
pub use quotient::Complex;

use super::Net;
use super::topology::{NodeClasses, Topology};
use gusset_base::error::Result;
use gusset_base::job::Job;
use presence::ExistingCells;
use row_scan::IrregularElements;

impl Complex {
    /// Returns the complex of all cells of a topology.
    ///
    /// # Errors
    /// [`Error::TooLarge`](gusset_base::Error::TooLarge) (more than 2^31 edges of one face),
    /// [`Error::OutOfMemory`](gusset_base::Error::OutOfMemory),
    /// [`Error::Cancelled`](gusset_base::Error::Cancelled).
    pub fn from_topology(topology: &Topology, job: &Job<'_>) -> Result<Self> {
        Complex::new(topology, &ExistingCells::ALL_CELLS, job)
    }

    /// Returns the complex of the existing cells of a net; see [`Net`].
    ///
    /// # Errors
    /// [`Error::TooLarge`](gusset_base::Error::TooLarge) (more than 2^31 edges of one face),
    /// [`Error::OutOfMemory`](gusset_base::Error::OutOfMemory),
    /// [`Error::Cancelled`](gusset_base::Error::Cancelled).
    pub fn from_net(net: &Net<'_>, job: &Job<'_>) -> Result<Self> {
        Complex::new(net.topology(), &ExistingCells::from_net(net)?, job)
    }

    fn new(topology: &Topology, presence: &ExistingCells, job: &Job<'_>) -> Result<Self> {
        let classes = NodeClasses::new(topology)?;
        let mut complex = Complex::default();
        let mut scan = IrregularElements::new(&classes, presence, &mut complex, &job.sub_job(0.0, 0.5))?;
        edges::group_sides_into_edges(&mut scan, &mut complex)?;
        job.step(0.7, "complex")?;
        edges::group_corners_into_fans(&mut scan, &mut complex)?;
        complex.components = connectivity::count_components(&classes, presence)?;
        complex.orientable = complex.conflicts.is_empty() || connectivity::is_orientable(&scan, &classes, presence)?;
        complex.boundary_edges = scan.rim.len() as u64;
        let (count, reversed) = (scan.node_count(), topology.is_reversed());
        complex.boundary = BoundaryChains::from_boundary_edges(&scan.rim, &mut scan.fan_ends, count, reversed)?;
        job.step(1.0, "complex")?;
        Ok(complex)
    }
}
