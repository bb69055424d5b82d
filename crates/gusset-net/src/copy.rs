//! Changed copies of nets: a part, a net without duplicate lines, an enlarged or turned net,
//! another type.
//!
//! Each step is a method of [`Net`]. A copy takes only the steps that the options ask for.
//! O(nodes).

use super::{GridSymmetry, Net, Replication};
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_mesh::Scalar;
use std::ops::Range;

/// The steps of a copy, in the order of the fields.
#[derive(Debug, Clone, Default)]
pub struct CopyOptions {
    /// Takes these rows and columns only; see [`Net::sub_net`].
    pub part: Option<[Range<usize>; 2]>,
    /// Removes rows and columns that duplicate the one before; see [`Net::compacted`].
    pub compact: bool,
    /// Enlarges the net to this many rows; see [`Net::enlarged_to`].
    pub rows: Option<usize>,
    /// Enlarges the net to this many columns.
    pub columns: Option<usize>,
    /// The rows and the columns that are replicated.
    pub replication: [Replication; 2],
    /// The symmetry that the rows and columns undergo.
    pub turn: GridSymmetry,
    /// The type of the coordinates; `None` keeps the net's type.
    pub scalar: Option<Scalar>,
}

impl Net<'_> {
    /// Makes a copy and changes it by the options; `None` if they request no change.
    ///
    /// # Errors
    /// Errors of [`Net::sub_net`], [`Net::compacted`], [`Net::enlarged_to`], [`Net::apply_symmetry`] and
    /// [`Net::converted`].
    pub fn changed_copy(&self, options: &CopyOptions, job: &Job<'_>) -> Result<Option<Net<'static>>> {
        let enlarges = options.rows.is_some() || options.columns.is_some();
        let scalar = options.scalar.filter(|&scalar| scalar != self.coordinates().scalar());
        let turns = options.turn != GridSymmetry::None;
        let wanted = [options.part.is_some(), options.compact, enlarges, turns, scalar.is_some()];
        let steps = wanted.into_iter().filter(|&wanted| wanted).count();
        let mut shares = (0..steps).map(|k| job.sub_job_of_item(k, steps));
        let mut share = || shares.next().unwrap_or_else(|| job.sub_job(1.0, 1.0));
        let mut made: Option<Net<'static>> = None;
        if let Some([rows, columns]) = options.part.clone() {
            made = Some(self.sub_net(rows, columns, &share())?);
        }
        if options.compact {
            made = Some(made.as_ref().unwrap_or(self).compacted(&share())?);
        }
        if enlarges {
            let net = made.as_ref().unwrap_or(self);
            let (rows, columns) = (net.shape().rows(), net.shape().columns());
            let (rows, columns) = (options.rows.unwrap_or(rows), options.columns.unwrap_or(columns));
            made = Some(net.enlarged_to(rows, columns, options.replication, &share())?);
        }
        if turns {
            made = Some(made.as_ref().unwrap_or(self).apply_symmetry(options.turn, &share())?);
        }
        if let Some(scalar) = scalar {
            share().step(0.0, "converting a net")?;
            made = Some(made.as_ref().unwrap_or(self).converted(scalar)?);
        }
        Ok(made)
    }
}
