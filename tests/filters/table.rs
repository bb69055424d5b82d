//! The filter table, walked: what a host relies on holds for every entry, and every entry runs.

use crate::common::{self, Soup, Steady, cap};
use crate::editor::{Given, given, inputs, pieces, polylines, run_on, run_on_curves, values};
use gusset::filters::data::{Curves, Input, InputKind, Output, OutputKind};
use gusset::filters::param::{Param, ParamKind};
use gusset::filters::{FILTERS, Filter};
use gusset::{Element, Error, Job, Progress};
use std::cell::Cell;
use std::collections::HashSet;
use std::ops::ControlFlow;

/// Ids are stable for ever: an entry may be added here, none changed or taken away.
const IDS: &[&str] = &[
    "boundary_loops",
    "stitch",
    "weld",
    "orient",
    "fill",
    "join",
    "outline",
    "net_shape",
    "deform",
    "smooth_surface",
    "smooth_sections",
    "smooth_silhouette",
    "smooth_distance",
    "check",
    "facing_arcs",
    "strip",
    "net_resample",
    "net_decimate",
    "net_join",
    "net_measures",
    "net_analyse",
    "net_lathe",
    "displace",
    "project",
    "curve_measures",
    "curve_resample",
    "curve_offset",
    "curve_meet",
    "curve_nearest",
    "curve_svg",
    "loft",
    "smooth_net",
    "smooth_isophotes",
    "smooth_intersect",
    "smooth_line",
    "smooth_curve",
    "smooth_nearest",
    "sew",
    "align",
    "trim",
    "develop",
    "net_planarise",
    "net_settle",
    "morph",
    "lattice",
    "repair",
    "unite",
    "section",
];

/// Choices that need other inputs or values: nets that are welded lie on each other, and so on.
fn fits_any_input(filter: &Filter, param: &Param, choice: usize) -> bool {
    !matches!((filter.id, param.id, choice), ("net_join", "bridge", 2) | ("net_shape", "shape", 13))
}

fn is_word(text: &str) -> bool {
    !text.is_empty() && text.chars().all(|c| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '_')
}

#[test]
fn names_are_unique_stable_and_explained() {
    assert_eq!(FILTERS.iter().map(|f| f.id).collect::<Vec<_>>(), IDS);
    let distinct = |key: fn(&Filter) -> &str| FILTERS.iter().map(key).collect::<HashSet<_>>().len();
    assert_eq!([distinct(|f| f.id), distinct(|f| f.name), distinct(|f| f.script_name())], [FILTERS.len(); 3]);
    for filter in FILTERS {
        assert!(is_word(filter.id) && is_word(filter.script_name()), "{}", filter.id);
        assert!(filter.help.len() > 40 && filter.help.ends_with('.') && !filter.help.contains("  "), "{}", filter.help);
        assert!(!filter.reference.is_empty() && !filter.reference.contains("  "), "{}", filter.reference);
        assert!(!filter.category.is_empty() && !filter.name.is_empty());
        assert!(std::ptr::eq(Filter::find(filter.id).unwrap(), filter));
        assert!(!filter.outputs.is_empty());
        // A filter takes some meshes or curves, or nothing at all.
        assert_eq!(filter.inputs.is_empty(), filter.max_inputs == 0);
        assert_eq!(filter.inputs.is_empty(), filter.min_inputs == 0);
        assert!(filter.min_inputs <= filter.max_inputs);
        let params: HashSet<_> = filter.params.iter().map(|p| p.id).collect();
        assert_eq!(params.len(), filter.params.len(), "{}", filter.id);
        // The output that replaces the first input has its kind.
        if filter.replaces {
            let kinds = (filter.inputs[0], filter.outputs[0].to_owned());
            assert!(format!("{:?}", kinds.0) == format!("{:?}", kinds.1), "{}", filter.id);
        }
    }
    assert!(Filter::find("no such filter").is_none());
}

#[test]
fn parameters_have_defaults_in_range() {
    for param in FILTERS.iter().flat_map(|f| f.params) {
        assert!(is_word(param.id) && !param.label.is_empty(), "{}", param.id);
        assert!(param.help.len() > 20 && param.help.ends_with('.') && !param.help.contains("  "), "{}", param.help);
        assert_eq!(param.default.len(), param.kind.component_count(), "{}", param.id);
        assert!(param.min <= param.max && param.default.iter().all(|&v| param.accepts(v)), "{}", param.id);
        assert!(param.step >= 0.0);
        assert_eq!(param.kind == ParamKind::Choice, !param.choices.is_empty(), "{}", param.id);
        if param.kind == ParamKind::Choice {
            assert_eq!((param.min, param.max), (0.0, (param.choices.len() - 1) as f64));
            assert!(param.choices.iter().all(|c| !c.label.is_empty() && c.help.ends_with('.')));
        }
        // Meshes come in all units.
        let lengths = [ParamKind::Length, ParamKind::Point, ParamKind::Plane];
        if lengths.contains(&param.kind) {
            assert!([1e-9, 1e9].into_iter().all(|length| param.accepts(length)), "{}", param.id);
        }
    }
}

/// The same inputs, larger and elsewhere.
fn scaled(given: &[Given], by: f64, shift: f64) -> Vec<Given> {
    let moved = |points: &[[f64; 3]]| points.iter().map(|p| p.map(|x| (x + shift) * by)).collect();
    let input = |given: &Given| match given {
        Given::Mesh(soup) => Given::Mesh(Soup { points: moved(&soup.points), ..soup.clone() }),
        Given::Curves(curves) => Given::Curves(Curves { points: moved(&curves.points), ..curves.clone() }),
    };
    given.iter().map(input).collect()
}

#[test]
fn suggestions_are_in_range_whatever_the_mesh() {
    let flat = |point: [f64; 3]| {
        let soup = Soup::new(vec![point; 4], &[&[0, 1, 2, 3]]);
        let mut nan = soup.clone();
        nan.points.push([f64::NAN; 3]);
        [soup, nan]
    };
    for filter in FILTERS {
        let usual = given(filter, 100);
        let mut cases: Vec<Vec<Given>> =
            [(1e-9, 0.0), (1e9, 0.0), (1e300, 0.0), (1e-300, 0.0), (1.0, 1e14), (1e200, 1e100)]
                .into_iter()
                .map(|(by, shift)| scaled(&usual, by, shift))
                .collect();
        let all = |mesh: &Soup, curves: &Curves| -> Vec<Given> {
            let input = |given: &Given| match given {
                Given::Mesh(_) => Given::Mesh(mesh.clone()),
                Given::Curves(_) => Given::Curves(curves.clone()),
            };
            usual.iter().map(input).collect()
        };
        for mesh in flat([0.0; 3]).into_iter().chain(flat([1e5, 0.0, 0.0])) {
            let points = mesh.points.clone();
            cases.push(all(&mesh, &polylines(&[(points, true), (Vec::new(), false)])));
            cases.push(all(&mesh, &Curves::default()));
            cases.push(all(&mesh, &Curves { offsets: vec![3, 1, 9], ..Curves::default() }));
        }
        for case in &cases {
            let values = filter.defaults(&inputs(case));
            let params = filter.params.iter().flat_map(|param| (0..param.kind.component_count()).map(move |_| param));
            for (param, &value) in params.zip(&values) {
                assert!(param.accepts(value), "{} {} {value}", filter.id, param.id);
            }
        }
        // A mesh a thousand times as large has lengths a thousand times as large, to the digits
        // shown.
        let [small, large] = [&usual, &scaled(&usual, 1e3, 0.0)].map(|given| filter.defaults(&inputs(given)));
        let mut start = 0;
        for param in filter.params {
            if param.kind == ParamKind::Length && filter.has_suggestions() && param.default[0] != small[start] {
                let ratio = large[start] / small[start];
                assert!((ratio / 1e3 - 1.0).abs() < 0.02, "{} {} {ratio}", filter.id, param.id);
            }
            start += param.kind.component_count();
        }
    }
}

fn kind_of(output: &Output) -> OutputKind {
    match output {
        Output::Mesh(..) => OutputKind::Mesh,
        Output::Curves(_) => OutputKind::Curves,
        Output::Text(_) => OutputKind::Text,
    }
}

#[test]
fn every_filter_runs_with_its_defaults_and_with_every_choice() {
    for filter in FILTERS {
        let given = given(filter, 100);
        let inputs = inputs(&given);
        let defaults = filter.defaults(&inputs);
        let run = |values: &[f64]| filter.run(&inputs, values, &Job::new(1, &Steady::default()));
        let reference = run(&[]).unwrap_or_else(|error| panic!("{}: {error}", filter.id));
        assert_eq!(reference.iter().map(kind_of).collect::<Vec<_>>(), filter.outputs, "{}", filter.id);
        assert_eq!(filter.run(&inputs, &defaults, &Job::default()).unwrap(), reference);
        let mut start = 0;
        for param in filter.params {
            for choice in (0..param.choices.len()).filter(|&choice| fits_any_input(filter, param, choice)) {
                let mut values = defaults.clone();
                values[start] = choice as f64;
                let outputs = run(&values).unwrap_or_else(|e| panic!("{} {} {choice}: {e}", filter.id, param.id));
                assert_eq!(outputs.len(), reference.len(), "{} {} {choice}", filter.id, param.id);
            }
            start += param.kind.component_count();
        }
    }
}

/// Cancels at the n-th call.
struct Impatient(Cell<u32>);

impl Progress for Impatient {
    fn step(&self, _: f64, _: &'static str) -> ControlFlow<()> {
        self.0.set(self.0.get().saturating_sub(1));
        if self.0.get() == 0 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    }
}

#[test]
fn every_filter_can_be_cancelled_wherever_it_asks() {
    for filter in FILTERS {
        let given = given(filter, 100);
        let inputs = inputs(&given);
        let mut calls = 0;
        loop {
            calls += 1;
            match filter.run(&inputs, &[], &Job::new(1, &Impatient(Cell::new(calls)))) {
                Err(Error::Cancelled) => {}
                Ok(_) => break,
                Err(error) => panic!("{} at call {calls}: {error}", filter.id),
            }
        }
        assert!(calls > 1, "{} never asks", filter.id);
    }
}

#[test]
fn values_and_inputs_out_of_range_are_refused() {
    for filter in FILTERS {
        let given = given(filter, 100);
        let inputs = inputs(&given);
        let defaults = filter.defaults(&inputs);
        let mut start = 0;
        for param in filter.params {
            let mut bad = vec![f64::NAN, param.min - 1.0, f64::INFINITY, f64::NEG_INFINITY];
            bad.push(param.max + param.max.abs().max(1.0));
            if matches!(param.kind, ParamKind::Bool | ParamKind::Int | ParamKind::Choice) {
                bad.push(param.min + 0.5);
            }
            for value in
                bad.into_iter().filter(|&value| !(param.min..=param.max).contains(&value) || value.fract() != 0.0)
            {
                let mut values = defaults.clone();
                values[start] = value;
                match filter.run(&inputs, &values, &Job::default()) {
                    Err(Error::OptionOutOfRange { option, .. }) => assert_eq!(option, param.id),
                    other => panic!("{} {} {value}: {other:?}", filter.id, param.id),
                }
            }
            // No direction, no plane.
            if matches!(param.kind, ParamKind::Direction | ParamKind::Plane) {
                let mut values = defaults.clone();
                values[start..start + 3].fill(0.0);
                match filter.run(&inputs, &values, &Job::default()) {
                    Ok(_) => {}
                    Err(Error::OptionOutOfRange { option, .. }) => assert_eq!(option, param.id, "{}", filter.id),
                    other => panic!("{} {}: {other:?}", filter.id, param.id),
                }
            }
            start += param.kind.component_count();
        }
        let too_many = vec![0.0; defaults.len() + 1];
        assert!(matches!(
            filter.run(&inputs, &too_many, &Job::default()),
            Err(Error::OptionOutOfRange { option: "values", .. })
        ));
        let refused = |inputs: &[Input<'_>]| {
            let refused = filter.run(inputs, &[], &Job::default());
            matches!(refused, Err(Error::InputCount { .. } | Error::InputUnfit { .. }))
        };
        let (mesh, curves) = (cap(5, 2, 0.0, 1.0), Curves::default());
        let too_many = vec![*inputs.first().unwrap_or(&Input::Mesh(mesh.view())); filter.max_inputs + 1];
        assert!((filter.min_inputs == 0 || refused(&[])) && refused(&too_many), "{}", filter.id);
        for (k, kind) in filter.inputs.iter().enumerate().take(inputs.len()) {
            let mut wrong = inputs.clone();
            wrong[k] = if *kind == InputKind::Mesh { Input::Curves(&curves) } else { Input::Mesh(mesh.view()) };
            assert!(refused(&wrong), "{} input {k}", filter.id);
        }
    }
}

/// Inputs that mean nothing: whatever a filter says of them, it says it.
#[test]
fn degenerate_inputs_are_answered_or_refused_clearly() {
    let point = Soup::new(vec![[1.0, 2.0, 3.0]; 4], &[&[0, 1, 2, 3]]);
    let line = Soup::new((0..6).map(|k| [f64::from(k), 0.0, 0.0]).collect(), &[&[0, 1, 4, 3], &[1, 2, 5, 4]]);
    let open = common::sheet(3, 2);
    let three = Soup::new(
        vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [0.0, -1.0, 0.0]],
        &[&[0, 1, 2], &[0, 1, 3], &[0, 1, 4]],
    );
    let meshes = [point, line, open, three];
    let nan = Curves { points: vec![[0.0, f64::NAN, 0.0]], offsets: vec![0, 1], closed: vec![false] };
    let wrong = [
        Curves { offsets: vec![0, 9], closed: vec![true], ..Curves::default() },
        Curves { points: vec![[0.0; 3]; 3], offsets: vec![0, 2, 1], closed: vec![true; 2] },
        Curves { points: vec![[0.0; 3]; 3], offsets: vec![1, 3], closed: vec![true] },
        Curves { points: vec![[0.0; 3]; 3], offsets: vec![0, 2], closed: vec![true] },
        Curves { points: vec![[0.0; 3]; 3], ..Curves::default() },
    ];
    let fine = [
        Curves::default(),
        polylines(&[(Vec::new(), false), (Vec::new(), true)]),
        polylines(&[(vec![[1.0, 2.0, 3.0]], false)]),
        polylines(&[(vec![[1.0, 2.0, 3.0]; 5], true), (vec![[1.0, 2.0, 3.0]; 5], true)]),
        polylines(&[(vec![[0.0; 3], [1.0; 3], [0.0; 3]], true), (vec![[0.0; 3], [1.0; 3]], true)]),
        polylines(&[(vec![[0.0; 3], [1e200; 3]], false), (vec![[-1e-200; 3], [1e-200; 3]], false)]),
    ];
    for filter in FILTERS.iter().filter(|filter| !filter.inputs.is_empty()) {
        let usual = given(filter, 100);
        for k in 0..usual.len() {
            let mut all = inputs(&usual);
            let run = |all: &[Input<'_>]| filter.run(all, &[], &Job::default());
            match &usual[k] {
                Given::Mesh(_) => {
                    for mesh in &meshes {
                        all[k] = Input::Mesh(mesh.view());
                        let _ = run(&all);
                    }
                }
                Given::Curves(_) => {
                    for curves in &fine {
                        all[k] = Input::Curves(curves);
                        for choice in 0..3 {
                            let between =
                                if filter.params.iter().any(|p| p.id == "between") { f64::from(choice) } else { 0.0 };
                            let set: &[(&str, &[f64])] = &[("between", &[between])];
                            let set = if between > 0.0 { set } else { &[] };
                            let done = filter.run(&all, &values(filter.id, &all, set), &Job::default());
                            if let Err(Error::OptionOutOfRange { option, .. }) = done {
                                let known = filter.params.iter().any(|p| p.id == option);
                                assert!(known, "{}: {option}", filter.id);
                            }
                        }
                    }
                    all[k] = Input::Curves(&nan);
                    let refused = run(&all);
                    assert!(
                        matches!(refused, Err(Error::NotFinite { element: Element::Point, index: 0, .. })),
                        "{}: {refused:?}",
                        filter.id
                    );
                    for curves in &wrong {
                        all[k] = Input::Curves(curves);
                        let refused = run(&all);
                        assert!(matches!(refused, Err(Error::BadOffsets { .. })), "{}: {refused:?}", filter.id);
                    }
                }
            }
        }
    }
}

#[test]
fn what_is_no_grid_is_refused_by_filters_of_grids() {
    let [first, second] = pieces(100);
    let both = [first.and(&second), crate::editor::sphere(6, 9)];
    for filter in FILTERS.iter().filter(|f| f.inputs.first() == Some(&InputKind::Mesh)) {
        let grids = ["Quad grids", "Smooth surfaces"].contains(&filter.category);
        let any = ["deform", "project", "smooth_distance"].contains(&filter.id);
        if grids && !any && filter.inputs.iter().all(|&kind| kind == InputKind::Mesh) {
            let refused = run_on(filter.id, &both[..filter.max_inputs.min(2)], &[]);
            assert!(matches!(refused, Err(Error::NoGrid { .. })), "{}: {refused:?}", filter.id);
        }
    }
    let twice = run_on_curves("outline", &[Curves::default(), Curves::default()], &[]);
    assert_eq!(twice, Err(Error::InputCount { given: 2, min: 1, max: 1 }));
}
