//! The unknowns that the equations of a plate couple.

use super::continuity::Continuity;
use super::one_rings::OneRings;
use gusset_base::sparse::UnknownCouplings;

/// The couplings of a plate.
pub(super) struct PlateCouplings<'a> {
    pub(super) rings: &'a OneRings,
    /// True for the rows of the Laplacian that the energy contains.
    pub(super) is_row: &'a [bool],
    pub(super) continuity: Continuity,
}

impl UnknownCouplings for PlateCouplings<'_> {
    fn for_each_row_with_unknown(&self, v: u32, mut visit: impl FnMut(usize)) {
        self.rings.laplacian_rows().row(v as usize).for_each(|(row, _)| visit(row));
    }

    fn coupling_reach(&self) -> usize {
        match self.continuity {
            Continuity::C1 => 2,
            Continuity::C2 => 3,
        }
    }

    fn is_coupled_to_marked(&self, v: u32, found: impl Fn(usize) -> bool) -> bool {
        let found = |row: usize| self.is_row[row] && found(row);
        let mut rows = self.rings.laplacian_rows().row(v as usize).filter(|&(row, _)| self.is_row[row]);
        match self.continuity {
            Continuity::C1 => rows.any(|(row, _)| found(row)),
            Continuity::C2 => rows.any(|(row, _)| self.rings.laplacian_rows().row(row).any(|(other, _)| found(other))),
        }
    }
}
