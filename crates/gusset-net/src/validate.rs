//! Validation: whether glued nodes coincide (Deryagin: "the correctness of a topology must be
//! checked by the coincidence of the coordinates of glued nodes"), and warnings about legal but
//! suspicious gluings. O(nodes), plus a sort of the findings.

use super::coincidence::{are_coincident, for_each_coincident_link};
use super::topology::links_of_star;
use super::{Net, NodeClasses, Shape, Topology, each};
use gusset_base::alloc;
use gusset_base::error::{Error, Result};
use gusset_base::job::Job;
use gusset_base::sort;
use gusset_base::sort::sort_distinct;

/// The kind of a finding.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum FindingKind {
    /// A violation: the ends of a contracted link are apart, or one of them is missing.
    LinkApart,
    /// A violation: two nodes that a seam glues are apart, or one of them is missing.
    SeamApart,
    /// A warning: other gluings identify the two ends of a link between neighbours, so that the
    /// link is a loop unless it is contracted, as [`Topology::canonical_form`] does.
    Loop,
    /// A warning: the two ends of a link coincide and are not glued.
    ZeroLength,
    /// A warning: closed rows or columns of fewer than four nodes enclose nothing.
    FewNodes,
}

impl FindingKind {
    /// Returns true for an error of the gluing, false for a warning.
    pub fn is_violation(self) -> bool {
        matches!(self, FindingKind::LinkApart | FindingKind::SeamApart)
    }
}

/// One finding.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ValidationFinding {
    /// The kind.
    pub kind: FindingKind,
    /// The two nodes; the ends of the row or column for [`FindingKind::FewNodes`].
    pub nodes: [u32; 2],
    /// The link, or the number of the seam.
    pub element: u32,
    /// The distance of the two nodes; NaN if one is missing.
    pub distance: f64,
}

impl Net<'_> {
    /// Checks each contracted link and each pair of each seam. The two nodes must coincide, or both
    /// be missing. With tolerance 0 they must have equal coordinates (0 and -0 are equal).
    /// Violations come first, then warnings, each kind in the order of its elements. O(nodes), plus
    /// a sort of the findings.
    ///
    /// # Errors
    /// [`Error::OptionOutOfRange`](gusset_base::Error::OptionOutOfRange) for a tolerance that is
    /// negative or not finite, [`Error::OutOfMemory`](gusset_base::Error::OutOfMemory),
    /// [`Error::Cancelled`](gusset_base::Error::Cancelled).
    pub fn validate(&self, tolerance: f64, job: &Job<'_>) -> Result<Vec<ValidationFinding>> {
        Error::require(tolerance.is_finite() && tolerance >= 0.0, "tolerance", tolerance, "finite and at least 0")?;
        let (topology, shape) = (self.topology(), self.shape());
        let classes = NodeClasses::new(topology)?;
        let mut findings = Vec::new();
        let ends = |nodes: [u32; 2]| nodes.map(|node| self.position(node));
        let mut add = |kind, element, nodes| {
            let [a, b] = ends(nodes);
            alloc::push(&mut findings, ValidationFinding { kind, nodes, element, distance: (b - a).length() })
        };
        let apart = |nodes| {
            let [a, b] = ends(nodes);
            !are_coincident(a, b, tolerance) && (a.is_finite() || b.is_finite())
        };
        for link in topology.contracted_links().filter(|&link| apart(shape.ends_of_link(link))) {
            add(FindingKind::LinkApart, link, shape.ends_of_link(link))?;
        }
        for (number, seam) in (0..).zip(topology.seams()) {
            for pair in seam.pairs(shape).filter(|&pair| apart(pair)) {
                add(FindingKind::SeamApart, number, pair)?;
            }
        }
        for link in find_loop_links(topology, &classes)? {
            add(FindingKind::Loop, link, shape.ends_of_link(link))?;
        }
        each!(self.coordinates(), planes => for_each_coincident_link(planes, tolerance, job, |link| {
            if classes.has_identified_ends(link) { Ok(()) } else { add(FindingKind::ZeroLength, link, shape.ends_of_link(link)) }
        }))?;
        for link in find_links_closing_short_lines(topology) {
            add(FindingKind::FewNodes, link, shape.ends_of_link(link))?;
        }
        let key = |finding: &ValidationFinding| (finding.kind, finding.element, finding.nodes);
        sort::sort(&mut findings, |a, b| key(a).cmp(&key(b)), &job.sub_job(1.0, 1.0), "sorting findings")?;
        Ok(findings)
    }
}

/// Returns the links between neighbours that belong to one class but are not contracted by name.
fn find_loop_links(topology: &Topology, classes: &NodeClasses) -> Result<Vec<u32>> {
    let shape = topology.shape();
    let mut loops = Vec::new();
    classes.for_each_glued_node(|node, _| {
        let (i, j) = shape.row_and_column(node);
        let is_loop = |&link: &u32| {
            shape.joins_neighbours(link) && !topology.is_contracted(link) && classes.has_identified_ends(link)
        };
        links_of_star(shape, i, j).into_iter().filter(is_loop).try_for_each(|link| alloc::push(&mut loops, link))
    })?;
    sort_distinct(&mut loops);
    Ok(loops)
}

/// Returns the first link that closes a row of fewer than four nodes, and a column.
fn find_links_closing_short_lines(topology: &Topology) -> impl Iterator<Item = u32> {
    let shape: Shape = topology.shape();
    let (h, w) = (shape.rows(), shape.columns());
    let rows = (0..if w < 4 { h } else { 0 }).map(move |i| shape.horizontal_link(i, w - 1));
    let columns = (0..if h < 4 { w } else { 0 }).map(move |j| shape.vertical_link(h - 1, j));
    let contracted = |link: &u32| topology.is_contracted(*link);
    rows.filter(contracted).take(1).chain(columns.filter(contracted).take(1))
}
