//! Effects of a deformation: What a deformation glues, tears, folds and stretches.

use crate::capi::context::{create, gusset_context, lend};
use crate::capi::glue::versioned;
use crate::capi::handle::{self, handle};
use crate::capi::input::{self, lent};
use crate::capi::net::field::{Given, fields, gusset_field};
use crate::capi::net::{gusset_net, read};
use crate::capi::status::{Failure, gusset_status};
use crate::error::Result;
use crate::net::analyse::{Analysis, analyse, analyse_field};
use gusset_base::alloc;

/// What a deformation does to a net. Immutable; may be read from many threads.
pub struct gusset_net_analysis {
    analysis: Analysis,
    contracted: Vec<u32>,
    stars: Vec<u32>,
}

handle! { gusset_net_analysis }

impl gusset_net_analysis {
    fn new(analysis: Analysis) -> Result<Self> {
        let contracted = alloc::collect(analysis.contracted.iter().map(|found| found.link))?;
        let stars = alloc::collect(analysis.contracted.iter().map(|found| found.star.number() as u32))?;
        Ok(gusset_net_analysis { analysis, contracted, stars })
    }
}

/// An analysis, lent: valid until gusset_net_analysis_destroy.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_net_analysis_view {
    /// sizeof(gusset_net_analysis_view), set by the caller.
    pub struct_size: usize,
    /// Of each link (node * 2, and 1 if it is vertical; those that lead back to the first column
    /// and row included), its new length divided by its old one; NaN if it had none, or an end is
    /// missing.
    pub links: *const f64,
    /// 2 * rows * columns.
    pub link_count: usize,
    /// Of each cell, its new area divided by its old one; negative where the surface is folded over
    /// or, if fields are analysed, space is mirrored; NaN if it had none, or is not there.
    pub cells: *const f64,
    /// Of each cell, the determinant of the fields' Jacobian at its centre; NULL if nets are
    /// compared.
    pub determinants: *const f64,
    /// (rows - 1) * (columns - 1).
    pub cell_count: usize,
    /// The links that have become a point and are not glued: see `links` of
    /// gusset_glue_options.
    pub contracted: *const u32,
    /// Of each of them, what the star of its first node has become with all of them contracted: the
    /// number of the local gluing, 0 to 17.
    pub stars: *const u32,
    /// How many.
    pub contracted_count: usize,
    /// The glued links whose ends have come apart.
    pub torn: *const u32,
    /// How many.
    pub torn_count: usize,
    /// The cells that are turned the other way than most.
    pub folded: *const u32,
    /// How many.
    pub folded_count: usize,
    /// 1 if nothing is newly glued, torn or folded: the paper's soft deformation; else it is hard.
    pub soft: u32,
    /// 0.
    pub reserved: u32,
}

versioned! { gusset_net_analysis_view: 112 }

/// The deformation that is analysed. All zeros: none.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_net_analysis_options {
    /// sizeof(gusset_net_analysis_options), set by the caller.
    pub struct_size: usize,
    /// The net after the deformation, of the same size; NULL: what the fields make of the net.
    pub after: *const gusset_net,
    /// The fields, as for gusset_net_deform; none beside `after`.
    pub fields: *const gusset_field,
    /// The number of fields.
    pub field_count: usize,
    /// The time, as for gusset_net_deform.
    pub time: f64,
    /// Lengths up to it, at least 0 and finite, are none.
    pub tolerance: f64,
}

versioned! { gusset_net_analysis_options: 48 }

/// Compares a net after a deformation with what it was before: what is newly glued, torn, folded
/// over, stretched.
///
/// The net stays as it is. The deformation is another net, or what fields would do: then the analysis
/// has the determinants of their Jacobian too.
///
/// @param net the net before the deformation; its gluing counts.
/// @param options the deformation; NULL for none.
/// @errors UNKNOWN_VALUE (fields beside `after`), OUT_OF_RANGE, SIDES_DIFFER (other sizes),
///     CROSSING_CELL (with the cell (what is newly glued is no surface)), as gusset_net_deform
/// @complexity O(nodes), 24 bytes a node. For fields O(nodes x fields), and 8 bytes a cell and a
///     copy of the net besides.
/// @source Deryagin, soft and hard deformations; links are measured, as a zero of the Jacobian
///     neither follows from gluing nor implies it.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_net_analysis_create(
    context: *const gusset_context,
    net: *const gusset_net,
    options: *const gusset_net_analysis_options,
    analysis: *mut *mut gusset_net_analysis,
) -> gusset_status {
    create(context, analysis, "analysis", |job| {
        let options = input::read(options, true, "options")?;
        let given = fields(options.fields, options.field_count, options.time)?;
        let found = if options.after.is_null() {
            let steps = alloc::collect(given.iter().map(Given::step))?;
            analyse_field(read(net)?, &steps, options.tolerance, job)?
        } else if given.is_empty() {
            analyse(read(net)?, read(options.after)?, options.tolerance, job)?
        } else {
            return Err(Failure::unknown("field_count, beside after,", options.field_count as u64));
        };
        Ok(gusset_net_analysis::new(found)?)
    })
}

/// Lends an analysis.
///
/// @param view its struct_size set.
/// @complexity O(1).
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_net_analysis_get_view(
    analysis: *const gusset_net_analysis,
    view: *mut gusset_net_analysis_view,
) -> gusset_status {
    lend!(analysis, view, |gusset_net_analysis { analysis, contracted, stars }| {
        let Analysis { links, cells, determinants, torn, folded, .. } = analysis;
        gusset_net_analysis_view {
            struct_size: 0,
            links: lent(links),
            link_count: links.len(),
            cells: lent(cells),
            determinants: lent(determinants),
            cell_count: cells.len(),
            contracted: lent(contracted),
            stars: lent(stars),
            contracted_count: contracted.len(),
            torn: lent(torn),
            torn_count: torn.len(),
            folded: lent(folded),
            folded_count: folded.len(),
            soft: analysis.is_soft().into(),
            reserved: 0,
        }
    })
}

/// Destroys an analysis; NULL is allowed.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn gusset_net_analysis_destroy(analysis: *mut gusset_net_analysis) {
    handle::destroy(analysis);
}
