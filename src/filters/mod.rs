//! The table of filters: every capability of the library that makes sense in a mesh editor, under a
//! stable name, with typed parameters.
//!
//! Plugin hosts show it, documentation is made from it. Each module of the library adds its entries
//! here, one file each.
//!
//! * [`param`]: what a parameter is, and the check of its values. [`data`]: what goes in and what
//!   comes out.
//! * [`FILTERS`]: the table.
//!
//! Values are numbers, as many per parameter as its kind has components, one parameter after the
//! other in the table's order; whoever gives fewer gets the defaults for the rest.

pub mod data;
pub mod param;

mod assemble;
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
mod displace;
mod distances;
mod extent;
mod facing_arcs;
mod fill_holes;
mod loft;
mod net_analyse;
mod net_decimate;
mod net_join;
mod net_lathe;
mod net_measures;
mod net_resample;
mod net_shape;
mod orient;
mod outline;
mod project;
mod quads;
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
mod weld;

use crate::error::{Error, Result};
use crate::job::Job;
use data::{Input, InputKind, Output, OutputKind};
use param::{Param, Values};

/// One capability.
pub struct Filter {
    /// Stable for ever: hosts store it.
    pub id: &'static str,
    /// For menus.
    pub name: &'static str,
    /// For scripts: lower case, words joined by underscores.
    pub script_name: &'static str,
    /// The group that a host shows it in.
    pub category: &'static str,
    /// What it does, in whole sentences.
    pub help: &'static str,
    /// Where the method comes from.
    pub reference: &'static str,
    /// What each input is; the last kind repeats. None for filters that make something of nothing.
    pub inputs: &'static [InputKind],
    /// The least number of inputs.
    pub min_inputs: usize,
    /// The greatest number of inputs.
    pub max_inputs: usize,
    /// What comes out, in order.
    pub outputs: &'static [OutputKind],
    /// The first output is the first input, mended, moved or made anew with other faces: an editor
    /// puts it in its place. Else what comes out is something new beside the inputs, as what is
    /// joined from several of them is.
    pub replaces: bool,
    /// The parameters, in the order of their values.
    pub params: &'static [Param],
    /// Values better than the defaults for these inputs, if the filter knows any.
    pub suggest: Option<Suggest>,
    run: fn(&[Input<'_>], &Values<'_>, &Job<'_>) -> Result<Vec<Output>>,
}

/// Overwrites the defaults with values that suit the inputs.
pub type Suggest = fn(&[Input<'_>], &mut [f64]);

/// All filters.
pub static FILTERS: &[Filter] = &[
    boundary_loops::FILTER,
    stitch::FILTER,
    weld::FILTER,
    orient::FILTER,
    fill_holes::FILTER,
    assemble::FILTER,
    outline::FILTER,
    net_shape::FILTER,
    deform::FILTER,
    smooth_surface::FILTER,
    smooth_sections::FILTER,
    smooth_silhouette::FILTER,
    smooth_distance::FILTER,
    check::FILTER,
    facing_arcs::FILTER,
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
];

impl Filter {
    /// The filter of this id.
    pub fn find(id: &str) -> Option<&'static Filter> {
        FILTERS.iter().find(|filter| filter.id == id)
    }

    /// The defaults of the parameters, whatever the inputs are.
    pub fn plain_defaults(&self) -> Vec<f64> {
        self.params.iter().flat_map(|param| param.default).copied().collect()
    }

    /// The defaults, as the inputs suggest them, each within the range of its parameter; what
    /// [`Filter::run`] takes for values that are not given.
    pub fn defaults(&self, inputs: &[Input<'_>]) -> Vec<f64> {
        let mut values = self.plain_defaults();
        if let Some(suggest) = self.suggest {
            let usual = values.clone();
            suggest(inputs, &mut values);
            // Meshes may be of any size, even of one that no range was made for.
            let params = self.params.iter().flat_map(|param| (0..param.kind.arity()).map(move |_| param));
            for ((value, usual), param) in values.iter_mut().zip(usual).zip(params) {
                *value = if value.is_nan() { usual } else { value.clamp(param.min, param.max) };
            }
        }
        values
    }

    /// The number of values of all parameters.
    pub fn value_count(&self) -> usize {
        self.params.iter().map(|param| param.kind.arity()).sum()
    }

    /// Whether the filter takes so many inputs of these kinds.
    ///
    /// # Errors
    /// [`Error::InputCount`], [`Error::InputUnfit`] for the first of a wrong kind.
    pub fn check_inputs(&self, inputs: &[Input<'_>]) -> Result<()> {
        self.check_input_count(inputs.len())?;
        inputs.iter().enumerate().try_for_each(|(place, input)| self.check_input_kind(place, input.kind()))
    }

    /// Whether the filter takes so many inputs.
    ///
    /// # Errors
    /// [`Error::InputCount`].
    pub fn check_input_count(&self, count: usize) -> Result<()> {
        let fits = (self.min_inputs..=self.max_inputs).contains(&count);
        let [least, most] = [self.min_inputs, self.max_inputs].map(|count| count as u64);
        if fits { Ok(()) } else { Err(Error::InputCount { given: count as u64, min: least, max: most }) }
    }

    /// Whether input `place` may be of this kind.
    ///
    /// # Errors
    /// [`Error::InputUnfit`].
    pub fn check_input_kind(&self, place: usize, kind: InputKind) -> Result<()> {
        let wanted = self.inputs.get(place).or(self.inputs.last()).copied();
        if wanted == Some(kind) {
            return Ok(());
        }
        let why =
            if kind == InputKind::Mesh { "curves are needed, not a mesh" } else { "a mesh is needed, not curves" };
        Err(Error::InputUnfit { input: place as u32, why })
    }

    /// Whether there are so many values.
    ///
    /// # Errors
    /// [`Error::OptionOutOfRange`] with their number if not.
    pub fn check_value_count(&self, count: usize) -> Result<()> {
        if count <= self.value_count() {
            Ok(())
        } else {
            Err(Error::OptionOutOfRange { option: "values", value: count as f64 })
        }
    }

    /// Runs the filter.
    ///
    /// # Errors
    /// [`Error::OptionOutOfRange`] for a value outside its parameter's range, and for more values
    /// than parameters; [`Error::InputCount`], [`Error::InputUnfit`]; besides those of the
    /// capability itself.
    pub fn run(&self, inputs: &[Input<'_>], values: &[f64], job: &Job<'_>) -> Result<Vec<Output>> {
        self.check_inputs(inputs)?;
        self.check_value_count(values.len())?;
        let mut all = if values.len() < self.value_count() { self.defaults(inputs) } else { values.to_vec() };
        all[..values.len()].copy_from_slice(values);
        (self.run)(inputs, &Values::check(self.params, &all)?, job)
    }
}
