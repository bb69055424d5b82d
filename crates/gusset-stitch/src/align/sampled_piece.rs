//! A piece in an alignment, with its samples.

use super::centred_piece::CentredPiece;
use super::sampled_rims::SampledRims;
use gusset_base::geom::kd_tree::KdTree;

/// A piece with its search structures and samples.
#[derive(Clone, Copy)]
pub(super) struct SampledPiece<'a> {
    pub(super) scan: &'a CentredPiece,
    pub(super) tree: &'a KdTree<'a>,
    /// The vertices to look for on other pieces, in spatial order.
    pub(super) samples: &'a [u32],
    /// The piece's rims, if the alignment uses rims.
    pub(super) rim: Option<(&'a SampledRims, &'a KdTree<'a>)>,
}
