//! Progress of filters that process one long curve: reports in proportion to the work, and a cancel
//! at any of them.

use crate::editor::{circle, polylines, values};
use gusset::filters::Filter;
use gusset::filters::data::{Curves, Input, Output};
use gusset::{Error, Job, Progress};
use std::cell::Cell;
use std::ops::ControlFlow;

/// Counts reports, and cancels at one of them.
struct Listener {
    count: Cell<usize>,
    last: Cell<f64>,
    stop_at: usize,
}

impl Progress for Listener {
    fn step(&self, fraction: f64, _: &'static str) -> ControlFlow<()> {
        assert!(self.last.get() <= fraction && fraction <= 1.0, "{} after {}", fraction, self.last.get());
        self.last.set(fraction);
        self.count.set(self.count.get() + 1);
        if self.count.get() == self.stop_at { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    }
}

fn run(id: &str, given: &[Curves], set: &[(&str, &[f64])], stop_at: usize) -> (Result<Vec<Output>, Error>, usize) {
    let inputs: Vec<Input<'_>> = given.iter().map(Input::Curves).collect();
    let listener = Listener { count: Cell::new(0), last: Cell::new(0.0), stop_at };
    let done = Filter::find(id).unwrap().run(&inputs, &values(id, &inputs, set), &Job::new(1, &listener));
    (done, listener.count.get())
}

/// One ring with this many points, or two rings for filters with two inputs.
fn rings(id: &str, count: u32) -> Vec<Curves> {
    let ring = |x: f64| circle(count, 1.0, [x, 0.0, 0.0]);
    match id {
        "facing_arcs" => vec![polylines(&[(ring(0.0), true), (ring(3.0), true)])],
        "curve_nearest" => vec![polylines(&[(ring(0.0), true)]), polylines(&[(ring(3.0), true)])],
        // The curve to revolve must not cross the axis.
        "net_lathe" => vec![polylines(&[(ring(3.0).iter().map(|&[x, y, _]| [x, 0.0, y]).collect(), true)])],
        _ => vec![polylines(&[(ring(0.0), true)])],
    }
}

/// A filter, and values for some of its parameters.
type Case = (&'static str, &'static [(&'static str, &'static [f64])]);

/// Filters whose work grows with the points of one curve, and the values that make it so.
const LONG: [Case; 10] = [
    ("facing_arcs", &[]),
    ("curve_nearest", &[]),
    ("curve_offset", &[]),
    ("curve_measures", &[]),
    ("curve_svg", &[]),
    ("curve_resample", &[("spacing", &[0.0])]),
    ("curve_resample", &[("spacing", &[2.0])]),
    ("curve_resample", &[("spacing", &[2.0]), ("between", &[1.0])]),
    ("outline", &[]),
    ("net_lathe", &[("columns", &[32.0])]),
];

#[test]
fn reports_are_as_many_as_there_is_work() {
    for (id, set) in LONG {
        let [few, many] = [1 << 13, 1 << 16].map(|count| {
            let (done, reports) = run(id, &rings(id, count), set, usize::MAX);
            assert!(done.is_ok(), "{id}: {done:?}");
            reports
        });
        // Eight times the points. A part of the reports is not of the curve.
        assert!(many > 2 * few && many > 16, "{id} {set:?}: {few} reports, then {many}");
    }
}

#[test]
fn reports_of_nets_of_curves_never_fall() {
    let line = |k: u32, along: bool| -> (Vec<[f64; 3]>, bool) {
        let point = |t: u32| {
            let [x, y] = if along { [t, k] } else { [k, t] }.map(f64::from);
            [x, y, 0.1 * (x - 1.0) * y]
        };
        ((0..3).map(point).collect(), false)
    };
    let curves = |along: bool| polylines(&[0, 1, 2].map(|k| line(k, along)));
    for given in [vec![curves(false), curves(true)], vec![curves(false)], vec![curves(true)]] {
        let (done, reports) = run("smooth_net", &given, &[], usize::MAX);
        assert!(done.is_ok() && reports > 10, "{done:?}");
    }
}

#[test]
fn a_cancel_stops_at_every_report() {
    for (id, set) in LONG {
        let given = rings(id, 1 << 13);
        let (_, reports) = run(id, &given, set, usize::MAX);
        for stop_at in (1..=reports).step_by(reports.div_ceil(20)) {
            let (done, reports) = run(id, &given, set, stop_at);
            assert_eq!((done, reports), (Err(Error::Cancelled), stop_at), "{id}");
        }
    }
}
