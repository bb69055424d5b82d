//! An entry of the table: a capability with its texts, kinds and parameters, and the checks that go before its run.

use super::data::{Input, InputKind, Output, OutputKind};
use super::param::{Param, Values};
use crate::error::{Error, Result};
use crate::job::Job;

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
    pub(super) run: fn(&[Input<'_>], &Values<'_>, &Job<'_>) -> Result<Vec<Output>>,
}

/// Overwrites the defaults with values that suit the inputs.
pub type Suggest = fn(&[Input<'_>], &mut [f64]);

impl Filter {
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
