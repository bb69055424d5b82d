//! The normal form of a topology, and its canonical form, which depends only on the classes.
//!
//! In normal form, links that sides can express are sides, and seams that links can express are
//! links. Seams are sorted, each in its smallest spelling, and no cell is crossed. O(nodes).

use super::{ContractedLinks, LinkMatrix, NodeClasses, Seam, Topology, canonical_seams};
use crate::Shape;
use gusset_base::alloc;
use gusset_base::error::{Error, Result};
use gusset_base::job::Job;

impl Topology {
    /// From contracted links and seams. O(nodes + pairs of seams).
    ///
    /// # Errors
    /// [`Error::BadSeam`], [`Error::CrossingCell`], [`Error::OutOfMemory`].
    pub fn new(shape: Shape, links: ContractedLinks, seams: &[Seam]) -> Result<Self> {
        Self::new_cancellable(shape, links, seams, &Job::default(), "")
    }

    /// [`Topology::new`] for large nets and many seams.
    ///
    /// # Errors
    /// Also [`Error::Cancelled`].
    pub fn new_cancellable(
        shape: Shape,
        links: ContractedLinks,
        seams: &[Seam],
        job: &Job<'_>,
        stage: &'static str,
    ) -> Result<Self> {
        job.step(0.0, stage)?;
        seams.iter().enumerate().try_for_each(|(index, seam)| seam.check_in_net(shape, index))?;
        let (mut links, mut kept) = (links, Vec::new());
        for seam in Seam::iter_with_reports(seams, &job.sub_job(0.0, 0.3), stage) {
            let seam = seam?;
            if seam.pairs(shape).all(|[a, b]| a == b) {
                continue;
            }
            let link = |pair: [u32; 2]| shape.links_between(pair).next();
            if seam.pairs(shape).all(|pair| link(pair).is_some()) {
                let mut matrix = links.into_matrix(shape)?;
                seam.pairs(shape).filter_map(link).for_each(|link| matrix.set_contracted(link, true));
                links = ContractedLinks::Matrix(matrix);
            } else {
                alloc::push(&mut kept, seam)?;
            }
        }
        let topology = Topology::assemble_unchecked(shape, links, kept, false);
        topology.check_crossed_cells_cancellable(&job.sub_job(0.3, 1.0), stage)?;
        Ok(topology)
    }

    /// From stored parts of a topology in normal form; `None` if they are in another form.
    /// O(nodes + pairs of seams).
    ///
    /// # Errors
    /// [`Error::BadSeam`], [`Error::CrossingCell`], [`Error::OutOfMemory`].
    pub(crate) fn from_canonical_parts(shape: Shape, links: ContractedLinks, seams: Vec<Seam>) -> Result<Option<Self>> {
        seams.iter().enumerate().try_for_each(|(index, seam)| seam.check_in_net(shape, index))?;
        if !seams.is_sorted_by(|a, b| a < b) || seams.iter().any(|seam| seam.canonical_spelling() != *seam) {
            return Ok(None);
        }
        if let ContractedLinks::Matrix(matrix) = &links
            && matrix.to_equal_sides(shape).is_some()
        {
            return Ok(None);
        }
        let topology = Topology { shape, links, seams, reversed: false };
        topology.check_crossed_cells()?;
        Ok(Some(topology))
    }

    /// Returns the canonical form: every link whose ends belong to one class is contracted, and
    /// seams express the rest. It depends only on the classes and the face orientation: two
    /// topologies of equal size that agree in both have equal canonical forms. O(nodes), plus a
    /// sort of the classes that seams glue.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`].
    pub fn canonical_form(&self) -> Result<Self> {
        self.canonical_form_cancellable(&Job::default(), "")
    }

    /// [`Topology::canonical_form`] for large nets.
    ///
    /// # Errors
    /// Also [`Error::Cancelled`].
    pub fn canonical_form_cancellable(&self, job: &Job<'_>, stage: &'static str) -> Result<Self> {
        let classes = NodeClasses::new_cancellable(self, &job.sub_job(0.0, 0.3), stage)?;
        let table = classes.representatives_cancellable(&job.sub_job(0.3, 0.5), stage)?;
        let matrix = LinkMatrix::from_representatives(self.shape, &table)?;
        let links = ContractedLinks::Matrix(matrix).into_sides_if_possible(self.shape);
        let mut saturated = Topology { shape: self.shape, links, seams: Vec::new(), reversed: self.reversed };
        if !self.seams.is_empty() {
            let pieces = NodeClasses::new_cancellable(&saturated, &job.sub_job(0.5, 0.8), stage)?;
            let pieces = pieces.representatives_cancellable(&job.sub_job(0.8, 1.0), stage)?;
            saturated.seams = canonical_seams::find_seams(self.shape, &table, &pieces)?;
        }
        Ok(saturated)
    }

    /// Returns [`Error::CrossingCell`] for the first cell whose opposite corners are glued
    /// crosswise.
    pub(crate) fn check_crossed_cells(&self) -> Result<()> {
        self.check_crossed_cells_cancellable(&Job::default(), "")
    }

    fn check_crossed_cells_cancellable(&self, job: &Job<'_>, stage: &'static str) -> Result<()> {
        if matches!(self.links, ContractedLinks::Sides(_)) && self.seams.is_empty() {
            return Ok(());
        }
        let classes = NodeClasses::new_cancellable(self, &job.sub_job(0.0, 0.8), stage)?;
        let (table, w) = (classes.representatives_cancellable(&job.sub_job(0.8, 1.0), stage)?, self.shape.columns());
        for (i, rows) in table.chunks_exact(w).zip(table[w..].chunks_exact(w)).enumerate() {
            let crosses = |j: usize| {
                let ([a, b], [d, c]) = ([rows.0[j], rows.0[j + 1]], [rows.1[j], rows.1[j + 1]]);
                (a == c) & (b == d) & (a != b)
            };
            // Branch-free, as crossings are rare.
            if (0..w - 1).fold(false, |any, j| any | crosses(j)) {
                let j = (0..w - 1).find(|&j| crosses(j)).unwrap_or(0);
                return Err(Error::CrossingCell { cell: self.shape.cell(i, j) });
            }
        }
        Ok(())
    }
}
