//! The table of filters: every capability of the library that makes sense in a mesh editor, under a
//! stable id, with typed parameters. Plugin hosts list it, and `docs/filters.md` is made from it.
//!
//! * [`filter`]: the type of an entry. [`param`]: parameters as hosts see them. `typed_param`: parameters
//!   as filters declare and read them. [`data`]: inputs and outputs. [`report`]: texts and the
//!   numbers in them.
//! * [`FILTERS`]: the table; each entry has a file of its name.
//!
//! Values are numbers, one for each component of each parameter, in the order of the table; missing
//! values at the end are defaults.

pub mod data;
pub mod param;
mod typed_param;

mod align;
mod boundary_loops;
mod check;
mod curve;
mod curve_measures;
mod curve_meet;
mod curve_nearest;
mod curve_offset;
mod curve_resample;
mod curve_svg;
mod deform;
mod develop;
mod displace;
mod extent;
mod facing_arcs_of_loops;
mod fill;
pub mod filter;
mod join;
mod lattice;
mod loft;
mod morph;
mod moving;
mod net_analyse;
mod net_decimate;
mod net_join;
mod net_lathe;
mod net_measures;
mod net_planarise;
mod net_resample;
mod net_settle;
mod net_shape;
mod orient;
mod outline;
mod project;
mod quads;
mod repair;
pub mod report;
mod section;
mod section_planes;
mod sew;
mod signatures;
mod smooth;
mod smooth_curve;
mod smooth_distance;
mod smooth_intersect;
mod smooth_isophotes;
mod smooth_line;
mod smooth_nearest;
mod smooth_net;
mod smooth_sections;
mod smooth_silhouette;
mod smooth_surface;
mod stitch;
mod strip;
mod trim;
mod unite;
mod weld;

pub use filter::Filter;

/// All filters.
pub static FILTERS: &[Filter] = &[
    boundary_loops::FILTER,
    stitch::FILTER,
    weld::FILTER,
    orient::FILTER,
    fill::FILTER,
    join::FILTER,
    outline::FILTER,
    net_shape::FILTER,
    deform::FILTER,
    smooth_surface::FILTER,
    smooth_sections::FILTER,
    smooth_silhouette::FILTER,
    smooth_distance::FILTER,
    check::FILTER,
    facing_arcs_of_loops::FACING_ARCS_OF_LOOPS,
    strip::FILTER,
    net_resample::FILTER,
    net_decimate::FILTER,
    net_join::FILTER,
    net_measures::FILTER,
    net_analyse::FILTER,
    net_lathe::FILTER,
    displace::FILTER,
    project::FILTER,
    curve_measures::FILTER,
    curve_resample::FILTER,
    curve_offset::FILTER,
    curve_meet::FILTER,
    curve_nearest::FILTER,
    curve_svg::FILTER,
    loft::FILTER,
    smooth_net::FILTER,
    smooth_isophotes::FILTER,
    smooth_intersect::FILTER,
    smooth_line::FILTER,
    smooth_curve::FILTER,
    smooth_nearest::FILTER,
    sew::FILTER,
    align::FILTER,
    trim::FILTER,
    develop::FILTER,
    net_planarise::FILTER,
    net_settle::FILTER,
    morph::FILTER,
    lattice::FILTER,
    repair::FILTER,
    unite::FILTER,
    section::FILTER,
];

impl Filter {
    /// The filter of this id.
    pub fn find(id: &str) -> Option<&'static Filter> {
        FILTERS.iter().find(|filter| filter.id == id)
    }
}
