//! A piece among those that are aligned with each other, and what it looks for.

use super::sampled_rim::Rim;
use super::scan::Scan;
use gusset_base::geom::kd_tree::KdTree;

/// A piece, and what it looks for.
#[derive(Clone, Copy)]
pub(super) struct Member<'a> {
    pub(super) scan: &'a Scan,
    pub(super) tree: &'a KdTree<'a>,
    /// Vertices, neighbours near each other.
    pub(super) samples: &'a [u32],
    /// Its rims, if they are what holds it.
    pub(super) rim: Option<(&'a Rim, &'a KdTree<'a>)>,
}
