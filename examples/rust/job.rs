//! Progress, cancelling, threads and errors.

use gusset::mesh::{Faces, MeshView, Positions};
use gusset::{Element, Error, Job, Progress, Result};
use std::ops::ControlFlow;
use std::sync::atomic::{AtomicBool, Ordering};

// ! [progress]
/// Prints the stages, and stops the computation when another thread says so.
#[derive(Default)]
struct Watcher {
    cancelled: AtomicBool,
}

impl Progress for Watcher {
    fn step(&self, fraction: f64, stage: &'static str) -> ControlFlow<()> {
        println!("{:3.0} % {stage}", 100.0 * fraction);
        if self.cancelled.load(Ordering::Relaxed) { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    }

    fn note(&self, message: &str) {
        println!("note: {message}");
    }
}
// ! [progress]

fn main() -> Result<()> {
    let points = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];

    // ! [run]
    // 1 thread: the calling one. 0 would take as many as the machine has.
    let watcher = Watcher::default();
    let job = Job::new(1, &watcher);
    let mesh = MeshView::new(Positions::from(&points[..]), Faces::triangles(&[[0, 1, 2]])?, &job)?;

    // Any thread may set this; the call returns at its next step.
    watcher.cancelled.store(true, Ordering::Relaxed);
    assert_eq!(gusset::check::check(&mesh, &job), Err(Error::Cancelled));
    // ! [run]

    // ! [errors]
    let broken = [points[0], [1.0, f64::NAN, 0.0], points[2]];
    match MeshView::new(Positions::from(&broken[..]), Faces::triangles(&[[0, 1, 2]])?, &Job::default()) {
        Err(error @ Error::NotFinite { element: Element::Vertex, index, .. }) => {
            println!("look at vertex {index}: {error}");
        }
        other => panic!("an error was expected, not {other:?}"),
    }
    // ! [errors]
    Ok(())
}

#[test]
fn it_runs() {
    main().unwrap();
}
