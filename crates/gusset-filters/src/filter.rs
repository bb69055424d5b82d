//! A filter: a named capability with typed inputs, outputs and parameters.

use super::data::{Input, InputKind, Output, OutputKind};
use super::extent::{extent_of, rounded};
use super::param::{Param, Values, range_of};
use gusset_base::error::{Error, Result};
use gusset_base::job::Job;

/// One capability.
pub struct Filter {
    /// Stable for ever: hosts store it, and scripts call the filter by it. Lower case, words joined
    /// by underscores.
    pub id: &'static str,
    /// For menus.
    pub name: &'static str,
    /// The group that a host shows it in.
    pub category: &'static str,
    /// Its effect, in whole sentences.
    pub help: &'static str,
    /// The source of the method.
    pub reference: &'static str,
    /// The kind of each input; the last kind repeats. None for filters without inputs.
    pub inputs: &'static [InputKind],
    /// The smallest number of inputs.
    pub min_inputs: usize,
    /// The largest number of inputs.
    pub max_inputs: usize,
    /// The kind of each output, in order.
    pub outputs: &'static [OutputKind],
    /// The first output is the first input repaired, moved or remeshed: an editor replaces it.
    /// Otherwise outputs are added beside the inputs.
    pub replaces: bool,
    /// The vertices, corners and faces of the first output, a mesh, come from those of the inputs as
    /// [`Filter::run_traced`] tells.
    pub has_origins: bool,
    /// The parameters, in the order of their values.
    pub params: &'static [Param],
    /// Defaults that depend on the inputs, beyond those of [`Param::size_ratio`].
    pub(super) suggest: Option<Suggest>,
    pub(super) run: Run,
}

/// The body of a filter.
pub(super) type Run = fn(&[Input<'_>], &Values<'_>, &Job<'_>) -> Result<Vec<Output>>;

/// Overwrites defaults by values that suit the inputs.
pub(super) type Suggest = fn(&[Input<'_>], &mut Defaults<'_>);

/// The defaults of a filter, by parameter.
pub(super) struct Defaults<'a> {
    params: &'static [Param],
    values: &'a mut [f64],
}

impl Defaults<'_> {
    /// Overwrites the default of parameter `id`.
    pub(super) fn set(&mut self, id: &str, values: &[f64]) {
        if let Some(range) = range_of(self.params, id) {
            self.values[range].copy_from_slice(values);
        }
    }
}

impl Filter {
    /// A filter without texts and parameters, which takes each of its inputs.
    pub(super) const fn new(inputs: &'static [InputKind], outputs: &'static [OutputKind], run: Run) -> Self {
        Filter {
            id: "",
            name: "",
            category: "",
            help: "",
            reference: "",
            inputs,
            min_inputs: inputs.len(),
            max_inputs: inputs.len(),
            outputs,
            replaces: false,
            has_origins: false,
            params: &[],
            suggest: None,
            run,
        }
    }

    /// The name in scripts, which is the id.
    pub fn script_name(&self) -> &'static str {
        self.id
    }

    /// True if defaults depend on the inputs.
    pub fn has_suggestions(&self) -> bool {
        self.suggest.is_some() || self.params.iter().any(|param| param.size_ratio > 0.0)
    }

    /// The defaults of the parameters without regard to inputs.
    pub fn plain_defaults(&self) -> Vec<f64> {
        self.params.iter().flat_map(|param| param.default).copied().collect()
    }

    /// The defaults for these inputs, each within the range of its parameter: the values of
    /// [`Filter::run`] where none are given.
    pub fn defaults(&self, inputs: &[Input<'_>]) -> Vec<f64> {
        let mut values = self.plain_defaults();
        if !self.has_suggestions() {
            return values;
        }
        let plain = values.clone();
        let mut defaults = Defaults { params: self.params, values: &mut values };
        if let Some(extent) = extent_of(inputs) {
            for param in self.params.iter().filter(|param| param.size_ratio > 0.0) {
                defaults.set(param.id, &[rounded(param.size_ratio * extent.diagonal())]);
            }
        }
        if let Some(suggest) = self.suggest {
            suggest(inputs, &mut defaults);
        }
        // Meshes may be of any size, even beyond all ranges.
        let params = self.params.iter().flat_map(|param| (0..param.kind.arity()).map(move |_| param));
        for ((value, plain), param) in values.iter_mut().zip(plain).zip(params) {
            *value = if value.is_nan() { plain } else { value.clamp(param.min, param.max) };
        }
        values
    }

    /// The number of values of all parameters.
    pub fn value_count(&self) -> usize {
        self.params.iter().map(|param| param.kind.arity()).sum()
    }

    /// Checks number and kinds of inputs.
    ///
    /// # Errors
    /// [`Error::InputCount`], [`Error::InputUnfit`] for the first of a wrong kind.
    pub fn check_inputs(&self, inputs: &[Input<'_>]) -> Result<()> {
        self.check_input_count(inputs.len())?;
        inputs.iter().enumerate().try_for_each(|(place, input)| self.check_input_kind(place, input.kind()))
    }

    /// Checks the number of inputs.
    ///
    /// # Errors
    /// [`Error::InputCount`].
    pub fn check_input_count(&self, count: usize) -> Result<()> {
        let fits = (self.min_inputs..=self.max_inputs).contains(&count);
        let [min, max] = [self.min_inputs, self.max_inputs].map(|count| count as u64);
        if fits { Ok(()) } else { Err(Error::InputCount { given: count as u64, min, max }) }
    }

    /// Checks the kind of input `place`.
    ///
    /// # Errors
    /// [`Error::InputUnfit`].
    pub fn check_input_kind(&self, place: usize, kind: InputKind) -> Result<()> {
        let wanted = self.inputs.get(place).or(self.inputs.last()).copied();
        if wanted == Some(kind) { Ok(()) } else { Err(kind.unfit(place)) }
    }

    /// Checks the number of values.
    ///
    /// # Errors
    /// [`Error::OptionOutOfRange`] with their number if there are more than the filter has.
    pub fn check_value_count(&self, count: usize) -> Result<()> {
        Error::require(count <= self.value_count(), "values", count as f64)
    }

    /// Runs the filter. Missing values at the end are defaults.
    ///
    /// # Errors
    /// [`Error::OptionOutOfRange`] for a value outside its parameter's range, and for more values
    /// than parameters; [`Error::InputCount`], [`Error::InputUnfit`]; those of the capability
    /// itself.
    pub fn run(&self, inputs: &[Input<'_>], values: &[f64], job: &Job<'_>) -> Result<Vec<Output>> {
        self.answer(inputs, values, false, job)
    }

    /// Runs the filter as [`Filter::run`] does, and tells where the elements of meshes come from if
    /// it [`has_origins`](Filter::has_origins).
    ///
    /// # Errors
    /// Those of [`Filter::run`].
    pub fn run_traced(&self, inputs: &[Input<'_>], values: &[f64], job: &Job<'_>) -> Result<Vec<Output>> {
        self.answer(inputs, values, true, job)
    }

    fn answer(&self, inputs: &[Input<'_>], values: &[f64], traced: bool, job: &Job<'_>) -> Result<Vec<Output>> {
        self.check_inputs(inputs)?;
        self.check_value_count(values.len())?;
        let mut all = if values.len() < self.value_count() { self.defaults(inputs) } else { values.to_vec() };
        all[..values.len()].copy_from_slice(values);
        (self.run)(inputs, &Values::check(self.params, &all)?.traced(traced), job)
    }
}
