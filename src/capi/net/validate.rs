//! Validation: Whether coordinates agree with the gluing.

use crate::capi::context::{create, gusset_context, lend};
use crate::capi::glue::{c_enum, fixed, versioned};
use crate::capi::handle::{self, handle};
use crate::capi::input::{Choice, lent};
use crate::capi::net::{gusset_net, read};
use crate::capi::status::gusset_status;
use crate::net::{Finding, FindingKind};
use gusset_base::alloc;

/// What is found.
pub type gusset_net_finding_kind = u32;
/// A violation: the ends of contracted link `element` are apart, or one of them is missing.
pub const GUSSET_NET_FINDING_LINK_APART: gusset_net_finding_kind = 0;
/// A violation: two nodes that seam `element` glues are apart, or one of them is missing.
pub const GUSSET_NET_FINDING_SEAM_APART: gusset_net_finding_kind = 1;
/// A warning: the ends of link `element`, between neighbours, are one point by way of others, and
/// it is not contracted itself: see `saturate` of gusset_glue_options.
pub const GUSSET_NET_FINDING_LOOP: gusset_net_finding_kind = 2;
/// A warning: the ends of link `element` lie on each other and are not glued.
pub const GUSSET_NET_FINDING_ZERO_LENGTH: gusset_net_finding_kind = 3;
/// A warning: link `element` closes a row or column of fewer than four nodes, which has no inside
/// then.
pub const GUSSET_NET_FINDING_FEW_NODES: gusset_net_finding_kind = 4;

/// One finding.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_net_finding {
    /// What is found.
    pub kind: gusset_net_finding_kind,
    /// The link, or the number of the seam.
    pub element: u32,
    /// The two nodes.
    pub nodes: [u32; 2],
    /// How far they are apart; NaN if one is missing.
    pub distance: f64,
}

/// What a validation found. Opaque and immutable; it keeps nothing of the net.
pub struct gusset_net_validation(Vec<gusset_net_finding>);

handle! { gusset_net_validation }

/// All findings: violations first, then warnings, each kind in the order of its elements.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_net_validation_view {
    /// sizeof(gusset_net_validation_view), set by the caller.
    pub struct_size: usize,
    /// The findings, valid until the validation is destroyed; NULL if there are none.
    pub findings: *const gusset_net_finding,
    /// How many.
    pub count: usize,
    /// How many of them are violations; they come first.
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

/// Checks that glued nodes lie together, and looks for what is suspicious.
///
/// What it finds is no error.
///
/// Two missing nodes are no violation.
///
/// @param tolerance how far two nodes may be apart, at least 0; for 0 their coordinates must be
///     equal (0 and -0 are).
/// @errors OUT_OF_RANGE (tolerance)
/// @complexity O(nodes), and a sort of the findings.
/// @source Deryagin, "Non-spatial operations".
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_net_validation_create(
    context: *const gusset_context,
    net: *const gusset_net,
    tolerance: f64,
    validation: *mut *mut gusset_net_validation,
) -> gusset_status {
    create(context, validation, "validation", |job| {
        let finding = |Finding { kind, element, nodes, distance }| gusset_net_finding {
            kind: kind.number(),
            element,
            nodes,
            distance,
        };
        let findings = read(net)?.validate(tolerance, &job.part(0.0, 0.9))?;
        let findings = findings.into_iter().map(finding);
        Ok(gusset_net_validation(alloc::collect_cancellable(findings, &job.part(0.9, 1.0), "findings")?))
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
        findings: lent(findings),
        count: findings.len(),
        violation_count: findings.partition_point(|finding| finding.kind < GUSSET_NET_FINDING_LOOP),
    })
}

/// Destroys a validation; NULL is allowed.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn gusset_net_validation_destroy(validation: *mut gusset_net_validation) {
    handle::destroy(validation);
}
