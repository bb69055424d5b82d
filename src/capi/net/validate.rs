//! Validation: Checks coordinates against the gluing.

use crate::capi::context::{create_handle, gusset_context, lend};
use crate::capi::glue::{c_enum, fixed, versioned};
use crate::capi::handle::{self, handle};
use crate::capi::input::{Choice, lend_list};
use crate::capi::net::{gusset_net, net_of_handle};
use crate::capi::status::gusset_status;
use crate::net::{FindingKind, ValidationFinding};
use gusset_base::alloc;

/// Kind of a finding.
pub type gusset_net_finding_kind = u32;
/// Violation: ends of contracted link element are apart, or one is missing.
pub const GUSSET_NET_FINDING_LINK_APART: gusset_net_finding_kind = 0;
/// Violation: two nodes glued by seam element are apart, or one is missing.
pub const GUSSET_NET_FINDING_SEAM_APART: gusset_net_finding_kind = 1;
/// Warning: ends of link element are one point, but it is not contracted; see saturate of
/// gusset_glue_options.
pub const GUSSET_NET_FINDING_LOOP: gusset_net_finding_kind = 2;
/// Warning: the ends of link element coincide without being glued.
pub const GUSSET_NET_FINDING_ZERO_LENGTH: gusset_net_finding_kind = 3;
/// Warning: link element closes a row or column of fewer than four nodes.
pub const GUSSET_NET_FINDING_FEW_NODES: gusset_net_finding_kind = 4;

/// Finding of a validation.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_net_finding {
    /// Kind of a finding.
    pub kind: gusset_net_finding_kind,
    /// Link, or index of the seam.
    pub element: u32,
    /// The two nodes.
    pub nodes: [u32; 2],
    /// Distance of the nodes; NaN if one is missing.
    pub distance: f64,
}

/// Findings of a validation.
pub struct gusset_net_validation(Vec<gusset_net_finding>);

handle! { gusset_net_validation }

/// Violations, then warnings, sorted by kind and element.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_net_validation_view {
    /// sizeof(gusset_net_validation_view).
    pub struct_size: usize,
    /// The findings.
    /// @shape count
    pub findings: *const gusset_net_finding,
    /// Number of findings.
    pub count: usize,
    /// Number of violations.
    pub violation_count: usize,
}

versioned! { gusset_net_validation_view: 32 }
fixed! { gusset_net_finding: 24 }

c_enum! {
    kind: FindingKind {
        GUSSET_NET_FINDING_LINK_APART => LinkApart,
        GUSSET_NET_FINDING_SEAM_APART => SeamApart,
        GUSSET_NET_FINDING_LOOP => Loop,
        GUSSET_NET_FINDING_ZERO_LENGTH => ZeroLength,
        GUSSET_NET_FINDING_FEW_NODES => FewNodes,
    }
}

/// Checks that glued nodes coincide (as do missing ones), and warns of suspicious gluing.
///
/// @param tolerance largest distance of coincident nodes; 0: equal coordinates (0 equals -0).
/// @errors OUT_OF_RANGE (tolerance)
/// @complexity O(nodes), plus a sort of the findings.
/// @source Deryagin, "Non-spatial operations".
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_net_validation_create(
    context: *const gusset_context,
    net: *const gusset_net,
    tolerance: f64,
    validation: *mut *mut gusset_net_validation,
) -> gusset_status {
    create_handle(context, validation, "validation", |job| {
        let finding = |ValidationFinding { kind, element, nodes, distance }| gusset_net_finding {
            kind: kind.number(),
            element,
            nodes,
            distance,
        };
        let findings = net_of_handle(net)?.validate(tolerance, &job.sub_job(0.0, 0.9))?;
        let findings = findings.into_iter().map(finding);
        Ok(gusset_net_validation(alloc::collect_cancellable(findings, &job.sub_job(0.9, 1.0), "findings")?))
    })
}

/// Lends the findings.
///
/// @complexity O(log findings).
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_net_validation_get_view(
    validation: *const gusset_net_validation,
    view: *mut gusset_net_validation_view,
) -> gusset_status {
    lend!(validation, view, |gusset_net_validation(findings)| gusset_net_validation_view {
        struct_size: size_of::<gusset_net_validation_view>(),
        findings: lend_list(findings),
        count: findings.len(),
        violation_count: findings.partition_point(|finding| finding.kind < GUSSET_NET_FINDING_LOOP),
    })
}

/// Destroys a validation.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn gusset_net_validation_destroy(validation: *mut gusset_net_validation) {
    handle::destroy(validation);
}
