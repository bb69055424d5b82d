//! A filter: a named capability with typed inputs, outputs and parameters.

use super::data::{Input, InputKind, Output, OutputKind};
use super::extent::bounding_box_of_inputs;
use super::param::Param;
use super::typed_param::{ParamValues, Parameters};
use gusset_base::error::{Allowed, Error, Result};
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
    /// The kind of each input; the last kind repeats. Empty for filters without inputs.
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
    /// The first output is a mesh made of elements of the inputs. [`Filter::run_traced`] gives the
    /// origins of its vertices, corners and faces.
    pub has_origins: bool,
    /// The parameters, in the order of their values.
    pub params: &'static [Param],
    pub(super) run_function: &'static dyn RunFilter,
}

/// A function of the inputs of a filter and of the values of its parameters.
type FilterFunction<P> = fn(&[Input<'_>], &ParamValues<P>, &Job<'_>) -> Result<Vec<Output>>;

/// The body of a filter.
pub(super) struct FilterBody<P>(pub(super) FilterFunction<P>);

/// A body without the type of its parameters.
pub(super) trait RunFilter: Sync {
    /// Runs the body. `components` holds the numbers of all parameter values one after the other,
    /// in range. If `traced`, outputs get origins.
    fn run(&self, inputs: &[Input<'_>], components: &[f64], traced: bool, job: &Job<'_>) -> Result<Vec<Output>>;
}

impl<P: Parameters> RunFilter for FilterBody<P> {
    fn run(&self, inputs: &[Input<'_>], components: &[f64], traced: bool, job: &Job<'_>) -> Result<Vec<Output>> {
        (self.0)(inputs, &ParamValues::new(components, traced), job)
    }
}

impl Filter {
    /// A filter without texts, which takes each of its inputs.
    pub(super) const fn new<P: Parameters>(
        inputs: &'static [InputKind],
        outputs: &'static [OutputKind],
        body: &'static FilterBody<P>,
    ) -> Self {
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
            params: P::PARAMS,
            run_function: body,
        }
    }

    /// The name in scripts, which is the id.
    pub fn script_name(&self) -> &'static str {
        self.id
    }

    /// True if defaults depend on the inputs.
    pub fn has_suggestions(&self) -> bool {
        self.params.iter().any(|param| param.suggestion.is_some())
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
        if let Some(extent) = bounding_box_of_inputs(inputs) {
            self.components_of_params_mut(&mut values).for_each(|(param, own)| param.suggest(inputs, &extent, own));
        }
        values
    }

    /// Each parameter with its part of the components of all parameters.
    fn components_of_params_mut<'a>(
        &self,
        mut rest: &'a mut [f64],
    ) -> impl Iterator<Item = (&'static Param, &'a mut [f64])> {
        self.params.iter().map(move |param| {
            let (own, next) = std::mem::take(&mut rest).split_at_mut(param.kind.component_count());
            rest = next;
            (param, own)
        })
    }

    /// The number of values of all parameters.
    pub fn value_count(&self) -> usize {
        self.params.iter().map(|param| param.kind.component_count()).sum()
    }

    /// Checks number and kinds of inputs.
    ///
    /// # Errors
    /// [`Error::InputCount`], [`Error::InputUnfit`] for the first of a wrong kind.
    pub fn check_inputs(&self, inputs: &[Input<'_>]) -> Result<()> {
        self.check_input_count(inputs.len())?;
        inputs.iter().enumerate().try_for_each(|(place, input)| self.check_input_kind(place, input.kind()))
    }

    /// Checks that the filter takes this number of inputs: `min_inputs` to `max_inputs`.
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
        if wanted == Some(kind) { Ok(()) } else { Err(kind.wrong_kind_error(place)) }
    }

    /// Checks the number of values.
    ///
    /// # Errors
    /// [`Error::OptionOutOfRange`] with their number if there are more than the filter has.
    pub fn check_value_count(&self, count: usize) -> Result<()> {
        Error::require(count <= self.value_count(), "values", count as f64, Allowed::AtMost(self.value_count() as f64))
    }

    /// Runs the filter. Missing values at the end are defaults.
    ///
    /// # Errors
    /// [`Error::OptionOutOfRange`] for a value outside its parameter's range, and for more values
    /// than the filter has; [`Error::InputCount`], [`Error::InputUnfit`]; the errors of the body.
    pub fn run(&self, inputs: &[Input<'_>], values: &[f64], job: &Job<'_>) -> Result<Vec<Output>> {
        self.check_and_run(inputs, values, false, job)
    }

    /// Runs the filter as [`Filter::run`] does, and tells where the elements of meshes come from if
    /// it [`has_origins`](Filter::has_origins).
    ///
    /// # Errors
    /// The errors of [`Filter::run`].
    pub fn run_traced(&self, inputs: &[Input<'_>], values: &[f64], job: &Job<'_>) -> Result<Vec<Output>> {
        self.check_and_run(inputs, values, true, job)
    }

    fn check_and_run(&self, inputs: &[Input<'_>], values: &[f64], traced: bool, job: &Job<'_>) -> Result<Vec<Output>> {
        self.check_inputs(inputs)?;
        self.check_value_count(values.len())?;
        let mut all = if values.len() < self.value_count() { self.defaults(inputs) } else { values.to_vec() };
        all[..values.len()].copy_from_slice(values);
        self.components_of_params_mut(&mut all).try_for_each(|(param, own)| param.check(own))?;
        self.run_function.run(inputs, &all, traced, job)
    }
}
