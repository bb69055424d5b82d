//! The net: coordinates, topology and bridges (Deryagin, "Model").
//!
//! Invariant: coordinates and topology have one shape. Accessors are O(1).

use super::{Bridge, Real, Shape, Topology, XyzMatrices};
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_mesh::Scalar;

/// The coordinate matrices of a net, in one of two types.
#[derive(Debug)]
pub enum Coordinates<'a> {
    /// Single precision: 12 bytes a node.
    F32(XyzMatrices<'a, f32>),
    /// Double precision: 24 bytes a node.
    F64(XyzMatrices<'a, f64>),
}

/// Evaluates one body for coordinates of either type: `each!(&net.coordinates, planes => body)`.
#[doc(hidden)]
#[macro_export]
macro_rules! each {
    ($coordinates:expr, $planes:ident => $body:expr) => {
        match $coordinates {
            $crate::Coordinates::F32($planes) => $body,
            $crate::Coordinates::F64($planes) => $body,
        }
    };
}

impl<'a> From<XyzMatrices<'a, f32>> for Coordinates<'a> {
    fn from(planes: XyzMatrices<'a, f32>) -> Self {
        Coordinates::F32(planes)
    }
}

impl<'a> From<XyzMatrices<'a, f64>> for Coordinates<'a> {
    fn from(planes: XyzMatrices<'a, f64>) -> Self {
        Coordinates::F64(planes)
    }
}

impl Coordinates<'_> {
    /// Creates owned matrices of zeros.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`](gusset_base::Error::OutOfMemory).
    pub fn zeroed(shape: Shape, scalar: Scalar) -> Result<Coordinates<'static>> {
        Ok(match scalar {
            Scalar::F32 => Coordinates::F32(XyzMatrices::zeroed(shape)?),
            Scalar::F64 => Coordinates::F64(XyzMatrices::zeroed(shape)?),
        })
    }

    /// Returns the type.
    pub fn scalar(&self) -> Scalar {
        match self {
            Coordinates::F32(_) => Scalar::F32,
            Coordinates::F64(_) => Scalar::F64,
        }
    }

    /// Returns the size of the matrices.
    pub fn shape(&self) -> Shape {
        each!(self, planes => planes.shape())
    }

    /// Node (i, j) in double precision, which is exact.
    #[inline]
    pub fn get(&self, i: usize, j: usize) -> DVec3 {
        each!(self, planes => planes.get(i, j))
    }

    /// Moves node (i, j), rounding to the type of the coordinates.
    #[inline]
    pub fn set(&mut self, i: usize, j: usize, position: DVec3) {
        each!(self, planes => planes.set(i, j, position));
    }

    /// Returns true for borrowed memory.
    pub fn is_borrowed(&self) -> bool {
        each!(self, planes => planes.is_borrowed())
    }

    /// Returns an owned copy, bit for bit.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`](gusset_base::Error::OutOfMemory).
    pub fn copied(&self) -> Result<Coordinates<'static>> {
        each!(self, planes => planes.copied().map(Coordinates::from))
    }
}

/// A tetragonal regular network: H x W nodes in space, their gluing, and the bridges between the
/// nets from which it was joined.
///
/// A node with a coordinate that is NaN or infinite is missing. A cell exists if its four nodes
/// exist and no hidden bridge covers it. A missing node does not affect the nodes that are glued to
/// it: their cells exist, and the vertex lies at its first existing node.
/// [`Complex::from_net`](super::complex::Complex::from_net) and [`Net::to_mesh`] follow this rule.
#[derive(Debug)]
pub struct Net<'a> {
    coordinates: Coordinates<'a>,
    topology: Topology,
    bridges: Vec<Bridge>,
}

impl<'a> Net<'a> {
    /// Returns a net of coordinates and a topology of the same size.
    ///
    /// # Panics
    /// If the sizes differ.
    pub fn new(coordinates: Coordinates<'a>, topology: Topology) -> Self {
        assert_eq!(coordinates.shape(), topology.shape(), "coordinates and topology of one size");
        Net { coordinates, topology, bridges: Vec::new() }
    }

    /// Returns a net from a function of row and column.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`](gusset_base::Error::OutOfMemory).
    pub fn from_fn(
        topology: Topology,
        scalar: Scalar,
        mut position: impl FnMut(usize, usize) -> DVec3,
    ) -> Result<Net<'static>> {
        let shape = topology.shape();
        let mut coordinates = Coordinates::zeroed(shape, scalar)?;
        for i in 0..shape.rows() {
            (0..shape.columns()).for_each(|j| coordinates.set(i, j, position(i, j)));
        }
        Ok(Net::new(coordinates, topology))
    }

    /// Returns the size.
    pub fn shape(&self) -> Shape {
        self.topology.shape()
    }

    /// Returns the coordinate matrices.
    pub fn coordinates(&self) -> &Coordinates<'a> {
        &self.coordinates
    }

    /// Returns the coordinate matrices, mutable.
    pub fn coordinates_mut(&mut self) -> &mut Coordinates<'a> {
        &mut self.coordinates
    }

    /// Returns the gluing.
    pub fn topology(&self) -> &Topology {
        &self.topology
    }

    /// Replaces the gluing. Positions stay.
    ///
    /// # Panics
    /// If the sizes differ.
    pub fn set_topology(&mut self, topology: Topology) {
        assert_eq!(self.shape(), topology.shape(), "coordinates and topology of one size");
        self.topology = topology;
    }

    /// Returns the bridges between the nets from which this one was joined.
    pub fn bridges(&self) -> &[Bridge] {
        &self.bridges
    }

    /// Returns the bridges, mutable.
    pub fn bridges_mut(&mut self) -> &mut Vec<Bridge> {
        &mut self.bridges
    }

    /// Node (i, j) in double precision.
    #[inline]
    pub fn get(&self, i: usize, j: usize) -> DVec3 {
        self.coordinates.get(i, j)
    }

    /// Returns the position of a node in double precision.
    #[inline]
    pub(crate) fn position(&self, node: u32) -> DVec3 {
        let (i, j) = self.shape().row_and_column(node);
        self.get(i, j)
    }

    /// Returns a copy with coordinates of the given type. Rounding to single precision keeps glued
    /// nodes equal; a coordinate that overflows becomes infinite, and the node missing.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`](gusset_base::Error::OutOfMemory).
    pub fn converted(&self, scalar: Scalar) -> Result<Net<'static>> {
        fn convert_matrices<A: Real, B: Real>(from: &XyzMatrices<'_, A>) -> Result<XyzMatrices<'static, B>> {
            from.converted(|to, from| to.iter_mut().zip(from).for_each(|(to, &from)| *to = B::from_f64(from.into())))
        }
        let coordinates = match scalar {
            _ if scalar == self.coordinates.scalar() => self.coordinates.copied()?,
            Scalar::F32 => Coordinates::F32(each!(&self.coordinates, from => convert_matrices(from)?)),
            Scalar::F64 => Coordinates::F64(each!(&self.coordinates, from => convert_matrices(from)?)),
        };
        let bridges = alloc::collect(self.bridges.iter().cloned())?;
        Ok(Net { coordinates, topology: self.topology.copied()?, bridges })
    }

    /// Returns an owned copy.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`](gusset_base::Error::OutOfMemory).
    pub fn copied(&self) -> Result<Net<'static>> {
        self.converted(self.coordinates.scalar())
    }
}
