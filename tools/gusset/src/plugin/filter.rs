//! Filters and their parameters.

use super::host::{Callbacks, Watcher};
use super::inputs::Inputs;
use super::library::Plugin;
use super::outputs::{Outputs, RunError};
use super::static_text;
use gusset::capi::plugin::descriptor::*;
use std::ptr;

/// A filter of a plugin.
#[derive(Clone, Copy)]
pub(crate) struct Filter {
    plugin: Plugin,
    raw: &'static gusset_filter,
}

// SAFETY: the tables never change, and their functions may be called from any thread.
unsafe impl Send for Filter {}
// SAFETY: as above.
unsafe impl Sync for Filter {}

/// Kinds of inputs and outputs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum OutputKind {
    Mesh,
    Curves,
    Text,
    Unknown,
}

impl OutputKind {
    pub(super) fn from_code(code: u32) -> Self {
        match code {
            GUSSET_KIND_MESH => Self::Mesh,
            GUSSET_KIND_CURVES => Self::Curves,
            GUSSET_KIND_TEXT => Self::Text,
            _ => Self::Unknown,
        }
    }

    /// Returns the word for it.
    pub(crate) fn word(self) -> &'static str {
        match self {
            Self::Mesh => "mesh",
            Self::Curves => "curves",
            Self::Text => "text",
            Self::Unknown => "unknown",
        }
    }
}

impl Filter {
    pub(super) fn new(plugin: Plugin, raw: &'static gusset_filter) -> Self {
        Self { plugin, raw }
    }

    pub(crate) fn plugin(self) -> Plugin {
        self.plugin
    }

    pub(crate) fn id(self) -> &'static str {
        static_text(self.raw.id)
    }

    pub(crate) fn name(self) -> &'static str {
        static_text(self.raw.name)
    }

    pub(crate) fn script_name(self) -> &'static str {
        static_text(self.raw.script_name)
    }

    pub(crate) fn category(self) -> &'static str {
        static_text(self.raw.category)
    }

    pub(crate) fn help(self) -> &'static str {
        static_text(self.raw.help)
    }

    pub(crate) fn reference(self) -> &'static str {
        static_text(self.raw.reference)
    }

    pub(crate) fn min_inputs(self) -> usize {
        self.raw.min_inputs as usize
    }

    /// Returns the largest number of inputs, `None` for any.
    pub(crate) fn max_inputs(self) -> Option<usize> {
        (self.raw.max_inputs != u32::MAX).then_some(self.raw.max_inputs as usize)
    }

    /// Returns the kinds of inputs; the last repeats.
    pub(crate) fn input_kinds(self) -> Vec<OutputKind> {
        // SAFETY: the table has this many entries.
        unsafe { kinds(self.raw.input_kinds, self.raw.input_kind_count) }
    }

    /// Returns the kind of an input.
    pub(crate) fn input_kind(self, place: usize) -> OutputKind {
        let kinds = self.input_kinds();
        kinds.get(place).or(kinds.last()).copied().unwrap_or(OutputKind::Unknown)
    }

    pub(crate) fn output_kinds(self) -> Vec<OutputKind> {
        // SAFETY: the table has this many entries.
        unsafe { kinds(self.raw.output_kinds, self.raw.output_count) }
    }

    /// Returns whether the first output replaces the first input.
    pub(crate) fn replaces_input(self) -> bool {
        self.raw.flags & GUSSET_FILTER_REPLACES != 0
    }

    pub(crate) fn params(self) -> Vec<Param> {
        // SAFETY: the table's function takes these indices, and its structs live as long as the plugin.
        (0..self.raw.param_count)
            .filter_map(|index| unsafe { (self.raw.param)(self.raw, index).as_ref() })
            .map(|raw| Param { raw })
            .collect()
    }

    /// Returns the number of values of all parameters.
    pub(crate) fn value_count(self) -> usize {
        self.raw.value_count as usize
    }

    /// Returns the defaults of all values.
    pub(crate) fn default_values(self) -> Vec<f64> {
        let mut values = vec![0.0; self.value_count()];
        for param in self.params() {
            values[param.values()].copy_from_slice(param.default_values());
        }
        values
    }

    /// Returns values that suit the inputs, and whether the filter takes these inputs.
    pub(crate) fn suggest(self, inputs: &Inputs) -> (Vec<f64>, bool) {
        let mut values = vec![0.0; self.value_count()];
        let views = inputs.views();
        // SAFETY: the inputs are valid during the call, and there is room for all values.
        let status = unsafe { (self.raw.suggest)(self.raw, views.as_ptr(), views.len() as u32, values.as_mut_ptr()) };
        (values, status == GUSSET_PLUGIN_DONE)
    }

    /// Runs the filter. `watcher` receives progress and remarks, and may cancel.
    pub(crate) fn run(
        self,
        inputs: &Inputs,
        values: &[f64],
        threads: u32,
        origins: bool,
        watcher: &dyn Watcher,
    ) -> Result<Outputs, RunError> {
        assert_eq!(values.len(), self.value_count(), "one value for each component");
        let callbacks = Callbacks::new(watcher);
        let host = callbacks.host(threads, origins);
        let views = inputs.views();
        let mut raw = ptr::null_mut();
        // SAFETY: inputs, values and host are valid during the call.
        let status = unsafe {
            (self.raw.run)(
                self.raw,
                &host,
                views.as_ptr(),
                views.len() as u32,
                values.as_ptr(),
                values.len() as u32,
                &mut raw,
            )
        };
        let outputs = Outputs::new(self.plugin, raw);
        match status {
            GUSSET_PLUGIN_DONE => Ok(outputs),
            GUSSET_PLUGIN_CANCELLED => Err(RunError::Cancelled),
            status => Err(outputs.refusal(self, status)),
        }
    }
}

unsafe fn kinds(codes: *const u32, count: u32) -> Vec<OutputKind> {
    if codes.is_null() {
        return Vec::new();
    }
    // SAFETY: the caller's promise.
    let codes = unsafe { std::slice::from_raw_parts(codes, count as usize) };
    codes.iter().copied().map(OutputKind::from_code).collect()
}

/// A parameter of a filter.
#[derive(Clone, Copy)]
pub(crate) struct Param {
    raw: &'static gusset_param_info,
}

/// Kinds of parameters.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum ParamKind {
    Bool,
    Integer,
    Real,
    Choice,
    Length,
    Angle,
    Point,
    Direction,
    Plane,
    Unknown,
}

impl Param {
    pub(crate) fn id(self) -> &'static str {
        static_text(self.raw.id)
    }

    pub(crate) fn label(self) -> &'static str {
        static_text(self.raw.label)
    }

    pub(crate) fn help(self) -> &'static str {
        static_text(self.raw.help)
    }

    pub(crate) fn kind(self) -> ParamKind {
        match self.raw.kind {
            GUSSET_PARAM_BOOL => ParamKind::Bool,
            GUSSET_PARAM_INT => ParamKind::Integer,
            GUSSET_PARAM_REAL => ParamKind::Real,
            GUSSET_PARAM_CHOICE => ParamKind::Choice,
            GUSSET_PARAM_LENGTH => ParamKind::Length,
            GUSSET_PARAM_ANGLE => ParamKind::Angle,
            GUSSET_PARAM_POINT => ParamKind::Point,
            GUSSET_PARAM_DIRECTION => ParamKind::Direction,
            GUSSET_PARAM_PLANE => ParamKind::Plane,
            _ => ParamKind::Unknown,
        }
    }

    /// Returns the places of its values among the filter's values.
    pub(crate) fn values(self) -> std::ops::Range<usize> {
        let start = self.raw.first_value as usize;
        start..start + self.raw.arity as usize
    }

    pub(crate) fn default_values(self) -> &'static [f64] {
        // SAFETY: the table has this many values, which live as long as the plugin.
        unsafe { std::slice::from_raw_parts(self.raw.default_values, self.raw.arity as usize) }
    }

    /// Returns the smallest and largest value of each component.
    pub(crate) fn range(self) -> [f64; 2] {
        [self.raw.min, self.raw.max]
    }

    /// Returns the choices: label and effect.
    pub(crate) fn choices(self) -> Vec<(&'static str, &'static str)> {
        if self.raw.choices.is_null() {
            return Vec::new();
        }
        // SAFETY: the table has this many choices, with texts that live as long as the plugin.
        unsafe {
            let choices = std::slice::from_raw_parts(self.raw.choices, self.raw.choice_count as usize);
            choices.iter().map(|choice| (static_text(choice.label), static_text(choice.help))).collect()
        }
    }
}
