//! Pairs of loops that the caller names: looks up the loops, or reports the fault.

use super::assemble_request::Selector;
use crate::stitch::IndexMap;
use gusset_base::error::{Error, LoopPairFault, Result, Side};
use gusset_mesh::NONE;

/// One of the pairs of an option.
pub(super) struct GivenLoopPair<'a> {
    pub(super) option: &'static str,
    /// The index of the pair in the option.
    pub(super) pair_index: u32,
    pub(super) pair: &'a [Selector; 2],
}

impl GivenLoopPair<'_> {
    fn pair_error(&self, k: usize, fault: LoopPairFault) -> Error {
        let (Selector { piece, vertex }, side) = (self.pair[k], [Side::A, Side::B][k]);
        Error::BadLoopPair { option: self.option, pair: self.pair_index, side, piece, vertex, fault }
    }

    /// Checks that both pieces exist, and the named vertices.
    pub(super) fn check_pieces_and_vertices_exist(&self, maps: &[IndexMap]) -> Result<()> {
        for (k, selector) in self.pair.iter().enumerate() {
            let map = maps.get(selector.piece as usize).ok_or_else(|| self.pair_error(k, LoopPairFault::NoPiece))?;
            if selector.vertex != NONE && selector.vertex as usize >= map.vertices.len() {
                return Err(self.pair_error(k, LoopPairFault::NoVertex));
            }
        }
        Ok(())
    }

    /// Returns the two rims that the pair names, each by a vertex. They must be different and not
    /// `taken` yet, or both the same slit. `named` returns the rims that a selector names.
    pub(super) fn find_named_rims(
        &self,
        named: impl Fn(Selector) -> Result<Vec<usize>>,
        taken: &[bool],
        is_slit: impl Fn(usize) -> bool,
    ) -> Result<[usize; 2]> {
        let mut rims = [0; 2];
        for (k, &selector) in self.pair.iter().enumerate() {
            let fault = match named(selector)?.as_slice() {
                _ if selector.vertex == NONE => LoopPairFault::VertexMissing,
                [] => LoopPairFault::NoLoop,
                &[r] if taken[r] => LoopPairFault::LoopTaken,
                &[r] if k == 1 && rims[0] == r && !is_slit(r) => LoopPairFault::SameLoop,
                &[r] => {
                    rims[k] = r;
                    continue;
                }
                _ => LoopPairFault::SeveralLoops,
            };
            return Err(self.pair_error(k, fault));
        }
        Ok(rims)
    }
}
