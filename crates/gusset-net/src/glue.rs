//! Gluing in one step: by coordinates, by pairs of nodes, by links, in canonical form, with
//! positions.
//!
//! [`find_gluing`] finds the new gluing before [`set_gluing`] sets it, so that a net changes as a
//! whole or not at all.

use super::Net;
use super::analyse::contract_links;
use super::detect_gluing::detect_gluing;
use super::field::snap_groups;
use super::topology::{Gluing, NodeClasses, Topology};
use gusset_base::error::Result;
use gusset_base::job::Job;

/// The steps of a gluing, in the order of the fields.
#[derive(Debug, Clone, Copy, Default)]
pub struct GlueOptions<'a> {
    /// Replaces the gluing by the one that coordinates imply within this tolerance; see
    /// [`detect_gluing()`].
    pub detect: Option<f64>,
    /// Glues these pairs of nodes; see [`Topology::glued`].
    pub gluings: &'a [Gluing],
    /// Contracts these links; see [`contract_links`].
    pub links: &'a [u32],
    /// Brings the gluing into its canonical form; see [`Topology::canonical_form`].
    pub saturate: bool,
}

/// Finds the gluing of a net after the steps of the options; `None` if the options request no step.
/// O(nodes).
///
/// # Errors
/// Errors of [`detect_gluing()`], [`Topology::glued`], [`contract_links`] and
/// [`Topology::canonical_form`].
pub fn find_gluing(net: &Net<'_>, options: &GlueOptions<'_>, job: &Job<'_>) -> Result<Option<Topology>> {
    let mut made: Option<Topology> = None;
    if let Some(tolerance) = options.detect {
        let topology = detect_gluing(net.coordinates(), tolerance, &job.sub_job(0.0, 0.5))?;
        made = Some(topology.with_reversed(net.topology().is_reversed()));
    }
    if !options.gluings.is_empty() {
        let old = made.as_ref().unwrap_or(net.topology());
        made = Some(old.glued_cancellable(options.gluings, &job.sub_job(0.5, 0.7), "gluing")?);
    }
    if !options.links.is_empty() {
        let old = made.as_ref().unwrap_or(net.topology());
        made = Some(contract_links(old, options.links.iter().copied(), &job.sub_job(0.7, 0.9))?);
    }
    if options.saturate {
        let old = made.as_ref().unwrap_or(net.topology());
        made = Some(old.canonical_form_cancellable(&job.sub_job(0.9, 1.0), "saturating")?);
    }
    Ok(made)
}

/// Sets the gluing of a net, unless it is `None`. If `snap`, all nodes of a class get the position
/// of the first of them. Returns the number of nodes whose bits changed. On an error the net is
/// unchanged.
///
/// # Errors
/// [`Error::OutOfMemory`](gusset_base::Error::OutOfMemory).
pub fn set_gluing(net: &mut Net<'_>, topology: Option<Topology>, snap: bool, job: &Job<'_>) -> Result<u64> {
    let classes = topology.as_ref().unwrap_or(net.topology());
    let groups = if snap { Some(NodeClasses::new(classes)?.glued_classes()?) } else { None };
    job.check_memory()?;
    if let Some(topology) = topology {
        net.set_topology(topology);
    }
    Ok(groups.map_or(0, |groups| snap_groups(&groups, net)))
}
