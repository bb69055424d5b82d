//! The effects and their texts, created once from [`FILTERS`] and never changed, because hosts keep
//! pointers to the texts.

use super::ofx_abi::MAIN_INPUT;
use gusset::filters::data::{InputKind, OutputKind};
use gusset::filters::param::{Param, ParamKind};
use gusset::filters::{FILTERS, Filter};
use std::ffi::{CStr, CString};
use std::sync::OnceLock;

/// Largest number of inputs of an effect, which is fixed. Filters with any number of inputs get
/// this many.
const MAX_INPUTS: usize = 8;

/// A filter as an effect.
pub(super) struct FilterEffect {
    pub(super) filter: &'static Filter,
    pub(super) label: CString,
    pub(super) help: CString,
    pub(super) inputs: Vec<InputSlot>,
    pub(super) knobs: Vec<EffectParameter>,
    /// The index of the output that is a mesh or curves; an effect has only one. If the filter only
    /// outputs text, the effect returns its first input.
    pub(super) output: Option<usize>,
}

/// An input.
pub(super) struct InputSlot {
    pub(super) name: CString,
    pub(super) label: CString,
    pub(super) kind: InputKind,
}

/// The kind of parameter that a host sees.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum ParameterKind {
    Boolean,
    Integer,
    Choice,
    Double,
    /// A double in degrees.
    Angle,
    /// Three doubles.
    Vector,
}

/// A parameter as a host sees it: a filter's parameter, or a part of one.
pub(super) struct EffectParameter {
    pub(super) kind: ParameterKind,
    pub(super) name: CString,
    pub(super) label: CString,
    pub(super) hint: CString,
    pub(super) choices: Vec<CString>,
    /// The index of its first value among the filter's values.
    pub(super) first_value: usize,
    pub(super) param: &'static Param,
    /// The default values.
    pub(super) default: &'static [f64],
}

/// All effects.
pub(super) fn effects() -> &'static [FilterEffect] {
    static EFFECTS: OnceLock<Vec<FilterEffect>> = OnceLock::new();
    EFFECTS.get_or_init(|| {
        FILTERS.iter().filter(|filter| filter.min_inputs <= MAX_INPUTS).map(FilterEffect::new).collect()
    })
}

pub(super) fn to_c_string(value: &str) -> CString {
    CString::new(value.replace('\0', " ")).unwrap_or_default()
}

impl FilterEffect {
    fn new(filter: &'static Filter) -> Self {
        FilterEffect {
            filter,
            label: to_c_string(filter.name),
            help: to_c_string(&format!("{}\n\n{}", filter.help, filter.reference)),
            inputs: (0..filter.max_inputs.min(MAX_INPUTS)).filter_map(|k| input_slot(filter, k)).collect(),
            knobs: effect_parameters(filter),
            output: filter.outputs.iter().position(|&kind| kind != OutputKind::Text),
        }
    }
}

fn input_slot(filter: &Filter, number: usize) -> Option<InputSlot> {
    let kind = *filter.inputs.get(number).or(filter.inputs.last())?;
    let what = match kind {
        InputKind::Mesh => "Mesh",
        InputKind::Curves => "Curves",
    };
    let optional = if number < filter.min_inputs { "" } else { " (optional)" };
    let name = if number == 0 { MAIN_INPUT.to_owned() } else { to_c_string(&format!("Input{}", number + 1)) };
    Some(InputSlot { name, label: to_c_string(&format!("{what} {}{optional}", number + 1)), kind })
}

fn effect_parameters(filter: &'static Filter) -> Vec<EffectParameter> {
    let mut knobs = Vec::new();
    let mut first = 0;
    for param in filter.params {
        let default: &'static [f64] = param.default;
        let knob = |kind, suffix: &str, label: &str, at: usize, default| EffectParameter {
            kind,
            name: to_c_string(&format!("{}{suffix}", param.id)),
            label: to_c_string(&format!("{}{label}", param.label)),
            hint: to_c_string(&help_with_choices(param)),
            choices: param.choices.iter().map(|choice| to_c_string(choice.label)).collect(),
            first_value: first + at,
            param,
            default,
        };
        match param.kind {
            ParamKind::Bool => knobs.push(knob(ParameterKind::Boolean, "", "", 0, default)),
            ParamKind::Int => knobs.push(knob(ParameterKind::Integer, "", "", 0, default)),
            ParamKind::Choice => knobs.push(knob(ParameterKind::Choice, "", "", 0, default)),
            ParamKind::Real | ParamKind::Length => knobs.push(knob(ParameterKind::Double, "", "", 0, default)),
            ParamKind::Angle => knobs.push(knob(ParameterKind::Angle, "", "", 0, default)),
            ParamKind::Point | ParamKind::Direction => knobs.push(knob(ParameterKind::Vector, "", "", 0, default)),
            ParamKind::Plane => {
                knobs.push(knob(ParameterKind::Vector, "", ": normal", 0, &default[..3]));
                knobs.push(knob(ParameterKind::Double, "_offset", ": offset", 3, &default[3..]));
            }
        }
        first += param.kind.component_count();
    }
    knobs
}

/// The help text, followed by a description of each choice.
fn help_with_choices(param: &Param) -> String {
    let choices = param.choices.iter().map(|choice| format!("\n{}: {}", choice.label, choice.help));
    param.help.to_owned() + &choices.collect::<String>()
}

/// The additional parameter of filters whose defaults depend on the inputs.
pub(super) const SUIT_INPUTS_NAME: &CStr = c"suit_inputs";
pub(super) const SUIT_INPUTS_LABEL: &CStr = c"Suit the inputs";
pub(super) const SUIT_INPUTS_HINT: &CStr =
    c"Parameters that have their default values get values that suit the inputs instead.";
