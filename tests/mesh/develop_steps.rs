//! The progress that a development reports.

use crate::common::{Soup, Steady, torus};
use gusset::develop::{Cuts, Options, develop};
use gusset::{Error, Job, Progress};
use std::cell::Cell;
use std::ops::ControlFlow;

/// Progress that never goes back, counted until the charts are laid out, and stopped then.
#[derive(Default)]
struct Opened {
    steady: Steady,
    count: Cell<usize>,
}

impl Progress for Opened {
    fn step(&self, fraction: f64, stage: &'static str) -> ControlFlow<()> {
        let _ = self.steady.step(fraction, stage);
        self.count.set(self.count.get() + 1);
        if fraction > 0.1 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    }
}

/// A torus of quads, or without its last ring of them: a tube of two loops.
fn surface(n: u32, m: u32, closed: bool) -> Soup {
    let mut soup = torus(n, m);
    if !closed {
        soup.offsets.truncate(soup.offsets.len() - m as usize);
        soup.corners.truncate(*soup.offsets.last().unwrap() as usize);
    }
    soup
}

#[test]
fn progress_never_goes_back_while_surfaces_are_opened() {
    for closed in [false, true] {
        let soup = surface(300, 200, closed);
        let opened = Opened::default();
        let done = develop(&soup.view(), &Options::default(), &Job::new(1, &opened));
        assert_eq!(done.err(), Some(Error::Cancelled));
    }
}

#[test]
fn long_paths_are_reported() {
    let soup = surface(300, 200, true);
    let opposite = 150 * 200 + 100;
    let cuts = [0, opposite, 0, opposite, 0];
    let options = Options { cuts: Cuts { vertices: &cuts, offsets: &[] }, ..Options::default() };
    let [without, with] = [&Options::default(), &options].map(|options| {
        let opened = Opened::default();
        develop(&soup.view(), options, &Job::new(1, &opened)).unwrap_err();
        opened.count.get()
    });
    // Each of the four paths is looked for among the 60,000 vertices.
    assert!(with - without >= 4 * 6, "{with} {without}");
}
