//! Effects of a deformation: New gluing, tears, folds and stretching.

use crate::capi::context::{create_handle, gusset_context, lend};
use crate::capi::glue::versioned;
use crate::capi::handle::{self, handle};
use crate::capi::input::{self, lend_list};
use crate::capi::net::field::{GivenField, gusset_field, read_fields};
use crate::capi::net::{gusset_net, net_of_handle};
use crate::capi::status::{Failure, gusset_status};
use crate::error::Result;
use crate::net::analyse::{DeformationAnalysis, analyse, analyse_field};
use gusset_base::alloc;

/// Effects of a deformation.
pub struct gusset_net_analysis {
    analysis: DeformationAnalysis,
    contracted: Vec<u32>,
    stars: Vec<u32>,
}

handle! { gusset_net_analysis }

impl gusset_net_analysis {
    fn new(analysis: DeformationAnalysis) -> Result<Self> {
        let contracted = alloc::collect(analysis.contracted.iter().map(|found| found.link))?;
        let stars = alloc::collect(analysis.contracted.iter().map(|found| found.star.number() as u32))?;
        Ok(gusset_net_analysis { analysis, contracted, stars })
    }
}

/// Effects of a deformation.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_net_analysis_view {
    /// sizeof(gusset_net_analysis_view).
    pub struct_size: usize,
    /// New / old length of each link; NaN if the old is 0 or an end missing.
    /// @shape link_count
    pub links: *const f64,
    /// 2 * rows * columns.
    pub link_count: usize,
    /// New / old area of each cell; NaN if the old is 0 or the cell absent. Negative for folds,
    /// with fields for negative determinants.
    /// @shape cell_count
    pub cells: *const f64,
    /// The fields' Jacobian determinant at each cell's centre; NULL if nets are compared.
    /// @shape cell_count
    pub determinants: *const f64,
    /// (rows - 1) * (columns - 1).
    pub cell_count: usize,
    /// Newly contracted links, whose ends are not glued; links of gusset_glue_options glues them.
    /// @shape contracted_count
    pub contracted: *const u32,
    /// For each, the local gluing of its first node once all are contracted: 0 to 17.
    /// @shape contracted_count
    /// @choice gusset_gluing_type
    pub stars: *const u32,
    /// Number of contracted links.
    pub contracted_count: usize,
    /// Glued links whose ends separated.
    /// @shape torn_count
    pub torn: *const u32,
    /// Number of torn links.
    pub torn_count: usize,
    /// Cells oriented against the majority.
    /// @shape folded_count
    pub folded: *const u32,
    /// Number of folded cells.
    pub folded_count: usize,
    /// 1: soft, nothing newly glued, torn or folded; 0: hard.
    /// @flag
    pub soft: u32,
    /// 0.
    pub reserved: u32,
}

versioned! { gusset_net_analysis_view: 112 }

/// Deformation; default: none.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_net_analysis_options {
    /// sizeof(gusset_net_analysis_options).
    pub struct_size: usize,
    /// Deformed net of equal size; NULL: see fields.
    pub after: *const gusset_net,
    /// As for gusset_net_deform.
    /// @shape field_count
    pub fields: *const gusset_field,
    /// 0 beside after.
    pub field_count: usize,
    /// As for gusset_net_deform.
    pub time: f64,
    /// Lengths up to it count as 0.
    pub tolerance: f64,
}

versioned! { gusset_net_analysis_options: 48 }

/// Finds what a deformation glues, tears, folds and stretches. The net stays.
///
/// @errors OUT_OF_RANGE, SIDES_DIFFER (another size), CROSSING_CELL (new gluing), as
///     gusset_net_deform
/// @complexity O(nodes); 24 bytes a node. Fields: O(nodes x fields); a copy of the net and 8 bytes
///     a cell.
/// @source Deryagin, soft and hard deformations, by links: zeros of the Jacobian neither imply
///     gluing nor follow from it.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_net_analysis_create(
    context: *const gusset_context,
    net: *const gusset_net,
    options: *const gusset_net_analysis_options,
    analysis: *mut *mut gusset_net_analysis,
) -> gusset_status {
    create_handle(context, analysis, "analysis", |job| {
        let options = input::read_versioned_struct(options, true, "options")?;
        let given = read_fields(options.fields, options.field_count, options.time)?;
        let found = if options.after.is_null() {
            let steps = alloc::collect(given.iter().map(GivenField::to_step))?;
            analyse_field(net_of_handle(net)?, &steps, options.tolerance, job)?
        } else if given.is_empty() {
            analyse(net_of_handle(net)?, net_of_handle(options.after)?, options.tolerance, job)?
        } else {
            return Err(Failure::unknown_value("field_count", options.field_count as u64, "0 beside `after`"));
        };
        Ok(gusset_net_analysis::new(found)?)
    })
}

/// Lends an analysis.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_net_analysis_get_view(
    analysis: *const gusset_net_analysis,
    view: *mut gusset_net_analysis_view,
) -> gusset_status {
    lend!(analysis, view, |gusset_net_analysis { analysis, contracted, stars }| {
        let DeformationAnalysis { links, cells, determinants, torn, folded, .. } = analysis;
        gusset_net_analysis_view {
            struct_size: 0,
            links: lend_list(links),
            link_count: links.len(),
            cells: lend_list(cells),
            determinants: lend_list(determinants),
            cell_count: cells.len(),
            contracted: lend_list(contracted),
            stars: lend_list(stars),
            contracted_count: contracted.len(),
            torn: lend_list(torn),
            torn_count: torn.len(),
            folded: lend_list(folded),
            folded_count: folded.len(),
            soft: analysis.is_soft().into(),
            reserved: 0,
        }
    })
}

/// Destroys an analysis.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn gusset_net_analysis_destroy(analysis: *mut gusset_net_analysis) {
    handle::destroy(analysis);
}
