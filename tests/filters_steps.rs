//! How long a host waits for a cancel: the time between two calls of its progress function.

mod common;
mod editor;

use editor::{Given, exploded, given, inputs};
use gusset::filters::data::InputKind;
use gusset::filters::{FILTERS, Filter};
use gusset::{Job, Progress};
use std::cell::RefCell;
use std::fs;
use std::ops::ControlFlow;
use std::time::{Duration, Instant};

/// Longer than this a cancel must not go unheard.
const MOST: Duration = Duration::from_millis(100);

/// What the calling thread has worked so far, whatever else the machine does; where that is not to be had, the time of day.
fn worked(start: Instant) -> Duration {
    let spent = fs::read_to_string("/proc/thread-self/schedstat");
    let nanoseconds = spent.ok().and_then(|line| line.split(' ').next()?.parse().ok());
    nanoseconds.map_or_else(|| start.elapsed(), Duration::from_nanos)
}

/// Notes the greatest time between two calls, and the stages at either end.
struct Watch {
    start: Instant,
    last: RefCell<(Duration, &'static str, f64)>,
    gaps: RefCell<Vec<(Duration, String)>>,
}

impl Watch {
    fn new() -> Self {
        let start = Instant::now();
        Watch { start, last: RefCell::new((worked(start), "start", 0.0)), gaps: RefCell::default() }
    }
}

impl Progress for Watch {
    fn step(&self, fraction: f64, stage: &'static str) -> ControlFlow<()> {
        let (now, mut last) = (worked(self.start), self.last.borrow_mut());
        let gap = now - last.0;
        if gap > MOST / 4 {
            self.gaps.borrow_mut().push((gap, format!("{} {:.3} - {stage} {fraction:.3}", last.1, last.2)));
        }
        *last = (now, stage, fraction);
        ControlFlow::Continue(())
    }
}

/// The gaps above a limit while a filter runs, the longest first.
fn gaps(filter: &Filter, given: &[Given]) -> Vec<(Duration, String)> {
    let inputs = inputs(given);
    let mut values = filter.defaults(&inputs);
    if filter.inputs.is_empty() {
        values = editor::values(filter.id, &inputs, &[("rows", &[1001.0]), ("columns", &[1001.0])]);
    }
    let watch = Watch::new();
    let begun = Instant::now();
    let outputs = filter.run(&inputs, &values, &Job::new(1, &watch));
    let _ = watch.step(1.0, "end");
    eprintln!("{}: {:.1?}{}", filter.id, begun.elapsed(), outputs.err().map_or(String::new(), |e| format!(", {e}")));
    let mut gaps = watch.gaps.into_inner();
    gaps.sort_by_key(|gap| std::cmp::Reverse(gap.0));
    gaps
}

#[test]
#[ignore = "minutes; for a release build"]
fn exhaustive_every_filter_hears_a_cancel() {
    let only = std::env::args().skip_while(|arg| arg != "--skip").nth(1);
    let mut slow = Vec::new();
    for filter in FILTERS.iter().filter(|filter| only.as_deref().is_none_or(|id| id == filter.id)) {
        // A million faces; of polylines ten thousand points, which few hosts have in one: what is done to a single curve is
        // done without asking.
        let size = if filter.inputs.first() == Some(&InputKind::Curves) { 10_000 } else { 1_000_000 };
        let mut all = vec![given(filter, size)];
        if let (1, [InputKind::Mesh], [Given::Mesh(soup), ..]) = (filter.max_inputs, filter.inputs, &all[0][..])
            && !["Nets", "Smooth surfaces"].contains(&filter.category)
        {
            let apart = exploded(soup);
            all.push(vec![Given::Mesh(apart)]);
        }
        for given in &all {
            for (gap, place) in gaps(filter, given).into_iter().take(12) {
                eprintln!("    {gap:.0?} {place}");
                if gap > MOST {
                    slow.push(format!("{}: {gap:.0?} at {place}", filter.id));
                }
            }
        }
    }
    assert!(slow.is_empty(), "{}", slow.join("\n"));
}
