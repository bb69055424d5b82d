//! Answers to impossible requests, and to options that are not read.

use crate::common::{Soup, cap, sheet};
use crate::pieces::cube;
use gusset::assemble::{self, MaxGap, Selector, assemble};
use gusset::error::{LoopPairFault, Side};
use gusset::fill::{self, LoopSelection, fill_holes};
use gusset::mesh::{MeshView, NONE};
use gusset::stitch::{self, Fairing, Orientation, Request, Rows, Stitch, stitch};
use gusset::{Error, Job, Progress};
use std::cell::RefCell;
use std::ops::ControlFlow;

/// Keeps the notes.
#[derive(Default)]
pub(crate) struct Notes(pub(crate) RefCell<Vec<String>>);

impl Progress for Notes {
    fn step(&self, _: f64, _: &'static str) -> ControlFlow<()> {
        ControlFlow::Continue(())
    }

    fn note(&self, message: &str) {
        self.0.borrow_mut().push(message.to_owned());
    }
}

fn within(soup: &Soup, options: &stitch::Options, job: &Job<'_>) -> Result<Stitch, Error> {
    let mesh = soup.view();
    stitch(&Request { a: &mesh, loop_a: None, b: None, loop_b: None }, options, job)
}

#[test]
fn a_request_with_one_mesh_never_mentions_a_second() {
    // No loop, one, two that share a vertex.
    let touching = {
        let mut soup = sheet(2, 2);
        (soup.offsets, soup.corners) = (vec![0], Vec::new());
        soup.face(&[0, 1, 4, 3]);
        soup.face(&[4, 5, 8, 7]);
        soup
    };
    for (soup, count, text) in
        [(cube(1), 0, "0 boundary loops"), (sheet(2, 1), 1, "1 boundary loop"), (touching, 2, "2 boundary loops")]
    {
        let error = within(&soup, &stitch::Options::default(), &Job::default()).unwrap_err();
        assert_eq!((error, error.side()), (Error::NoPairOfLoops { count }, None));
        let rest = "that can be stitched; two without a common vertex are needed";
        assert_eq!(error.to_string(), format!("the mesh has {text} {rest}"));
    }
    let both = cap(8, 2, 0.2, 1.0).and(&cap(8, 2, 0.2, -1.0).turned());
    let refuse = stitch::Options { orientation: Orientation::Refuse, ..stitch::Options::default() };
    let error = within(&both, &refuse, &Job::default()).unwrap_err();
    assert!(matches!(error, Error::OrientationConflict { .. }) && !error.to_string().contains("piece"), "{error}");
    let notes = Notes::default();
    assert!(within(&both, &stitch::Options::default(), &Job::new(1, &notes)).unwrap().turned);
    let note = "the loops' components disagree in orientation: the second loop's component was turned over";
    assert_eq!(*notes.0.borrow(), [note]);
    // Whichever of the two is inside out, the second is the one that is turned.
    let (inward, outward) = (cap(8, 2, 0.2, 1.0).turned(), cap(8, 2, 0.2, -1.0));
    for (first, second) in [(&inward, &outward), (&outward, &inward)] {
        let notes = Notes::default();
        let (first, second) = (first.view(), second.view());
        let request = Request { a: &first, loop_a: None, b: Some(&second), loop_b: None };
        assert!(stitch(&request, &stitch::Options::default(), &Job::new(1, &notes)).unwrap().turned);
        assert_eq!(*notes.0.borrow(), ["the pieces disagree in orientation: the second one was turned over"]);
    }
}

#[test]
fn a_pair_that_names_nothing_is_told_why() {
    // Two sheets, and a third whose two squares touch: two loops pass its vertex 4.
    let mut above = sheet(2, 1);
    above.points.iter_mut().for_each(|p| p[2] += 9.0);
    let mut touching = sheet(2, 2);
    (touching.offsets, touching.corners) = (vec![0], Vec::new());
    touching.face(&[0, 1, 4, 3]);
    touching.face(&[4, 5, 8, 7]);
    touching.points.iter_mut().for_each(|p| p[0] += 100.0);
    let pieces = [sheet(2, 1), above, touching, cube(1)];
    let views: Vec<MeshView<'_>> = pieces.iter().map(Soup::view).collect();
    let at = |piece, vertex| Selector { piece, vertex };
    let run = |pairs: &[[Selector; 2]], excluded: &[[Selector; 2]]| {
        let options =
            assemble::Options { pairs, excluded, max_gap: MaxGap::Given(0.0), ..assemble::Options::default() };
        assemble(&views, &options, &Job::default()).unwrap_err()
    };
    let right = [at(0, 0), at(1, 0)];
    let cases = [
        ([at(4, 0), at(1, 0)], Side::A, LoopPairFault::NoPiece, "piece 4 does not exist"),
        ([at(0, 0), at(u32::MAX, 0)], Side::B, LoopPairFault::NoPiece, "piece 4294967295 does not exist"),
        ([at(0, 0), at(1, 6)], Side::B, LoopPairFault::NoVertex, "vertex 6 of piece 1 does not exist"),
        ([at(0, NONE), at(1, 0)], Side::A, LoopPairFault::VertexMissing, "it names piece 0 but none of its vertices"),
        ([at(0, 0), at(3, 5)], Side::B, LoopPairFault::NoLoop, "no loop that can be joined passes vertex 5 of piece 3"),
        ([at(2, 4), at(1, 0)], Side::A, LoopPairFault::SeveralLoops, "several loops pass vertex 4 of piece 2"),
        ([at(0, 0), at(0, 1)], Side::B, LoopPairFault::SameLoop, "vertex 1 of piece 0 is on the pair's other loop"),
    ];
    for (pair, side, fault, text) in cases {
        for pairs in [&[pair][..], &[[at(2, 0), at(2, 8)], pair]] {
            let error = run(pairs, &[]);
            let Selector { piece, vertex } = pair[usize::from(side == Side::B)];
            let number = pairs.len() as u32 - 1;
            assert_eq!(error, Error::BadLoopPair { option: "pairs", pair: number, side, piece, vertex, fault });
            assert_eq!(error.to_string(), format!("pair {number} of pairs: {text}"));
        }
        // An exclusion may name a whole piece, or a list that is not a loop.
        if matches!(fault, LoopPairFault::NoPiece | LoopPairFault::NoVertex) {
            let error = run(&[], &[right, right, pair]);
            assert_eq!(error.to_string(), format!("pair 2 of excluded: {text}"));
        } else {
            let options = assemble::Options { excluded: &[pair], ..assemble::Options::default() };
            assemble(&views, &options, &Job::default()).unwrap();
        }
    }
    for (pair, side, named) in
        [([at(0, 5), at(2, 0)], Side::A, "vertex 5 of piece 0"), ([at(2, 0), at(1, 5)], Side::B, "vertex 5 of piece 1")]
    {
        let error = run(&[right, pair], &[]);
        assert_eq!(
            (error.to_string(), error.side()),
            (format!("pair 1 of pairs: the loop through {named} is in a previous pair"), Some(side))
        );
    }
}

#[test]
fn an_assembly_of_nothing_says_so() {
    let error = assemble(&[], &assemble::Options::default(), &Job::default()).unwrap_err();
    assert_eq!(error.to_string(), "no pieces were given; at least one is needed");
}

#[test]
fn fairing_that_is_not_read_is_noted() {
    let (a, b) = (cap(8, 2, 0.2, 1.0), cap(8, 2, 0.2, -1.0));
    let both = a.and(&b);
    let (rows, refinement) = (Rows::Count(1), fill::Refinement::RimDensity(0));
    for fair in [false, true] {
        for read in [false, true] {
            let strip = stitch::Options {
                fairing: if fair { Fairing::ThinPlate } else { Fairing::None },
                rows: if read { rows } else { Rows::None },
                ..stitch::Options::default()
            };
            let filling = fill::Options {
                fairing: if fair { fill::Fairing::ThinPlate } else { fill::Fairing::None },
                refinement: if read { refinement } else { fill::Refinement::None },
                ..fill::Options::default()
            };
            let expected = usize::from(fair && !read);
            let count = |notes: &Notes| notes.0.borrow().iter().filter(|note| note.contains("fairing")).count();
            let notes = Notes::default();
            within(&both, &strip, &Job::new(1, &notes)).unwrap();
            assert_eq!(count(&notes), expected);
            let notes = Notes::default();
            fill_holes(&both.view(), LoopSelection::All, &filling, &Job::new(1, &notes)).unwrap();
            assert_eq!(count(&notes), expected);
            let notes = Notes::default();
            let options = assemble::Options { strip, fill: Some(filling), ..assemble::Options::default() };
            assemble(&[a.view(), b.view()], &options, &Job::new(1, &notes)).unwrap();
            assert_eq!(count(&notes), 2 * expected, "{:?}", notes.0.borrow());
        }
    }
    // No row is none, too.
    let none = stitch::Options { fairing: Fairing::ThinPlate, rows: Rows::Count(0), ..stitch::Options::default() };
    let notes = Notes::default();
    within(&both, &none, &Job::new(1, &notes)).unwrap();
    assert_eq!(notes.0.borrow().len(), 1);
}
