//! The handle of a net: Indices of nodes, cells and links.

use crate::capi::context::{guard_changing_call, gusset_context};
use crate::capi::handle::{self, handle};
use crate::capi::status::{Failure, gusset_status};
use crate::job::Job;
use crate::net::{Net, Topology};
use std::sync::Arc;

/// A matrix of nodes with coordinates, and its gluing.
///
/// - Node (i, j) has index i * columns + j; cell (i, j) has i * (columns - 1) + j.
/// - Link 2 * node leads to the row's next node, 2 * node + 1 to the column's; the last links to
///   the first.
/// - A node with a NaN or infinite coordinate is missing. A cell with a missing corner or of a
///   hidden bridge is absent.
pub struct gusset_net(Arc<Net<'static>>);

handle! { gusset_net }

impl gusset_net {
    /// Creates a handle of a net that owns or borrows its memory.
    pub(crate) fn new(net: Net<'static>) -> Self {
        gusset_net(Arc::new(net))
    }

    /// Returns the net, for reading.
    pub(crate) fn net(&self) -> &Net<'static> {
        &self.0
    }

    /// Returns the net, for changes. A scene or a copy that shares it keeps the old state.
    pub(crate) fn edit_unshared(&mut self, job: &Job<'_>) -> Result<&mut Net<'static>, Failure> {
        let own = if Arc::get_mut(&mut self.0).is_none() { Some(Arc::new(self.0.copied()?)) } else { None };
        job.check_memory()?;
        if let Some(own) = own {
            self.0 = own;
        }
        Ok(Arc::get_mut(&mut self.0).expect("a new Arc has one owner"))
    }

    /// Returns the current net, to be shared. A net in the host's memory is copied.
    pub(crate) fn share_net(&self) -> Result<Arc<Net<'static>>, Failure> {
        if self.0.coordinates().is_borrowed() { Ok(Arc::new(self.0.copied()?)) } else { Ok(self.0.clone()) }
    }

    /// Creates a handle of a shared net.
    pub(crate) fn from_shared(net: Arc<Net<'static>>) -> Self {
        gusset_net(net)
    }
}

/// Returns the net of a handle, for reading.
pub(crate) fn net_of_handle<'a>(net: *const gusset_net) -> Result<&'a Net<'static>, Failure> {
    Ok(handle::get_object(net, "net")?.net())
}

/// Returns the net of a handle, for changes.
pub(crate) fn net_of_handle_mut<'a>(net: *mut gusset_net, job: &Job<'_>) -> Result<&'a mut Net<'static>, Failure> {
    handle::get_object_mut(net, "net")?.edit_unshared(job)
}

/// Replaces the gluing of a net.
pub(crate) fn replace_gluing(
    context: *const gusset_context,
    net: *mut gusset_net,
    topology: impl FnOnce(&Net<'_>, &Job<'_>) -> Result<Topology, Failure>,
) -> gusset_status {
    guard_changing_call(context, |job| {
        let topology = topology(net_of_handle(net)?, job)?;
        net_of_handle_mut(net, job)?.set_topology(topology);
        Ok(())
    })
}
