//! A carcass: sheets of a surface, with an index for questions.

use super::cells::Cells;
use super::closest::{Scratch, search};
use super::index::Pyramid;
use super::{Grid, Jet};
use crate::error::Result;
use crate::job::Job;
use glam::DVec3;

/// A place on a surface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Place {
    /// The sheet.
    pub sheet: u32,
    /// Row and column of the cell.
    pub cell: [u32; 2],
    /// Parameters within the cell, 0 to 1.
    pub u: f64,
    /// The same across.
    pub v: f64,
}

/// The nearest point of a surface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Closest {
    /// Where it is.
    pub place: Place,
    /// The point.
    pub point: DVec3,
    /// Its distance.
    pub distance: f64,
    /// No point of the surface is nearer than this.
    pub bound: f64,
}

/// A surface and its index. Immutable: any number of threads may ask.
#[derive(Debug)]
pub struct Carcass<'a> {
    sheet: Grid<'a>,
    index: Pyramid,
    tolerance: f64,
}

impl<'a> Carcass<'a> {
    /// Builds the index.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`](crate::Error::OutOfMemory), [`Error::Cancelled`](crate::Error::Cancelled).
    pub fn new(sheet: Grid<'a>, job: &Job<'_>) -> Result<Self> {
        let index = Pyramid::build(&sheet, job)?;
        let bounds = index.bounds();
        Ok(Carcass { sheet, tolerance: 1e-9 * bounds.low.distance(bounds.high), index })
    }

    /// The position and the derivatives at a place, by the parameters of its cell.
    pub fn jet(&self, place: Place) -> Jet {
        let [i, j] = place.cell;
        Cells::patch(&self.sheet, i as usize, j as usize).jet(place.u, place.v)
    }

    /// Bytes of the index.
    pub fn index_bytes(&self) -> usize {
        self.index.bytes()
    }

    /// The nearest point that is no farther than `limit`.
    pub fn closest(&self, query: DVec3, limit: f64) -> Option<Closest> {
        let mut scratch = Scratch::default();
        let nearest = search(&self.sheet, &self.index, query, limit, self.tolerance, &mut scratch)?;
        let [i, j] = nearest.cell.map(|k| k as u32);
        let place = Place { sheet: 0, cell: [i, j], u: nearest.found.place.x, v: nearest.found.place.y };
        let (point, distance) = (nearest.found.point, nearest.found.distance);
        Some(Closest { place, point, distance, bound: nearest.bound })
    }
}
