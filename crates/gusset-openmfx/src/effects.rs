//! The effects and their texts, created once from [`FILTERS`] and never changed, because hosts keep
//! pointers to the texts.

use super::abi::MAIN_INPUT;
use gusset::filters::data::{InputKind, OutputKind};
use gusset::filters::param::{Param, ParamKind};
use gusset::filters::{FILTERS, Filter};
use std::ffi::{CStr, CString};
use std::sync::OnceLock;

/// Largest number of inputs of an effect, which is fixed. Filters with any number of inputs get
/// this many.
const MAX_INPUTS: usize = 8;

/// A filter as an effect.
pub(super) struct Effect {
    pub(super) filter: &'static Filter,
    pub(super) label: CString,
    pub(super) help: CString,
    pub(super) inputs: Vec<Slot>,
    pub(super) knobs: Vec<Knob>,
    /// The index of the output that is a mesh or curves; an effect has only one. If the filter only
    /// outputs text, the effect returns its first input.
    pub(super) output: Option<usize>,
}

/// An input.
pub(super) struct Slot {
    pub(super) name: CString,
    pub(super) label: CString,
    pub(super) kind: InputKind,
}

/// The kind of parameter that a host sees.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum KnobKind {
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
pub(super) struct Knob {
    pub(super) kind: KnobKind,
    pub(super) name: CString,
    pub(super) label: CString,
    pub(super) hint: CString,
    pub(super) choices: Vec<CString>,
    /// The index of its first value among the filter's values.
    pub(super) first: usize,
    pub(super) param: &'static Param,
    /// The default values.
    pub(super) default: &'static [f64],
}

/// All effects.
pub(super) fn effects() -> &'static [Effect] {
    static EFFECTS: OnceLock<Vec<Effect>> = OnceLock::new();
    EFFECTS.get_or_init(|| FILTERS.iter().filter(|filter| filter.min_inputs <= MAX_INPUTS).map(Effect::new).collect())
}

pub(super) fn text(value: &str) -> CString {
    CString::new(value.replace('\0', " ")).unwrap_or_default()
}

impl Effect {
    fn new(filter: &'static Filter) -> Self {
        Effect {
            filter,
            label: text(filter.name),
            help: text(&format!("{}\n\n{}", filter.help, filter.reference)),
            inputs: (0..filter.max_inputs.min(MAX_INPUTS)).filter_map(|k| slot(filter, k)).collect(),
            knobs: knobs(filter),
            output: filter.outputs.iter().position(|&kind| kind != OutputKind::Text),
        }
    }
}

fn slot(filter: &Filter, number: usize) -> Option<Slot> {
    let kind = *filter.inputs.get(number).or(filter.inputs.last())?;
    let what = match kind {
        InputKind::Mesh => "Mesh",
        InputKind::Curves => "Curves",
    };
    let optional = if number < filter.min_inputs { "" } else { " (optional)" };
    let name = if number == 0 { MAIN_INPUT.to_owned() } else { text(&format!("Input{}", number + 1)) };
    Some(Slot { name, label: text(&format!("{what} {}{optional}", number + 1)), kind })
}

fn knobs(filter: &'static Filter) -> Vec<Knob> {
    let mut knobs = Vec::new();
    let mut first = 0;
    for param in filter.params {
        let default: &'static [f64] = param.default;
        let knob = |kind, suffix: &str, label: &str, at: usize, default| Knob {
            kind,
            name: text(&format!("{}{suffix}", param.id)),
            label: text(&format!("{}{label}", param.label)),
            hint: text(&hint(param)),
            choices: param.choices.iter().map(|choice| text(choice.label)).collect(),
            first: first + at,
            param,
            default,
        };
        match param.kind {
            ParamKind::Bool => knobs.push(knob(KnobKind::Boolean, "", "", 0, default)),
            ParamKind::Int => knobs.push(knob(KnobKind::Integer, "", "", 0, default)),
            ParamKind::Choice => knobs.push(knob(KnobKind::Choice, "", "", 0, default)),
            ParamKind::Real | ParamKind::Length => knobs.push(knob(KnobKind::Double, "", "", 0, default)),
            ParamKind::Angle => knobs.push(knob(KnobKind::Angle, "", "", 0, default)),
            ParamKind::Point | ParamKind::Direction => knobs.push(knob(KnobKind::Vector, "", "", 0, default)),
            ParamKind::Plane => {
                knobs.push(knob(KnobKind::Vector, "", ": normal", 0, &default[..3]));
                knobs.push(knob(KnobKind::Double, "_offset", ": offset", 3, &default[3..]));
            }
        }
        first += param.kind.arity();
    }
    knobs
}

/// The help text, followed by a description of each choice.
fn hint(param: &Param) -> String {
    let choices = param.choices.iter().map(|choice| format!("\n{}: {}", choice.label, choice.help));
    param.help.to_owned() + &choices.collect::<String>()
}

/// The additional parameter of filters whose defaults depend on the inputs.
pub(super) const SUIT: &CStr = c"suit_inputs";
pub(super) const SUIT_LABEL: &CStr = c"Suit the inputs";
pub(super) const SUIT_HINT: &CStr =
    c"Parameters that have their default values get values that suit the inputs instead.";
