//! The filter `facing_arcs`.

use super::Filter;
use super::data::{Curves, Input, InputKind, Output, OutputKind};
use super::param::{Choice, Param, ParamKind, Values};
use crate::alloc;
use crate::error::{Error, Result};
use crate::job::Job;
use crate::stitch::facing::{Centres, Options, Run, facing};
use glam::DVec3;
use std::fmt::Write;

pub(super) const FILTER: Filter = Filter {
    id: "facing_arcs",
    name: "Facing arcs of two loops",
    script_name: "facing_arcs",
    category: "Boundary",
    help: "Finds which points of two loops face each other, as the paper has it: those on the other loop's side of the plane through \
           their own loop's centre. The arcs of them that would be joined come out first, then all others.",
    reference: "S. Nesterenko, The algorithm for polygonal networks of cross-linking, algorithm 2",
    inputs: &[InputKind::Curves],
    min_inputs: 1,
    max_inputs: 1,
    outputs: &[OutputKind::Curves, OutputKind::Text],
    replaces: false,
    params: &[
        number("curve_a", "First loop", &[0.0]),
        number("curve_b", "Second loop", &[1.0]),
        Param::choice(
            "run",
            "Facing arc",
            "Which arc is taken where several face the other loop.",
            &[
                Choice { label: "Closest", help: "The one with the closest pair of points." },
                Choice { label: "Longest", help: "The one of the most points." },
            ],
        ),
        Param::choice(
            "centres",
            "Centres",
            "What the centre of a loop is.",
            &[
                Choice { label: "Mean of the points", help: "As the paper has it." },
                Choice { label: "Mean of the curve", help: "Whatever the spacing of the points." },
            ],
        ),
        Param::new(
            "tolerance",
            "Facing tolerance",
            "How far a point must be from the plane to face the other loop; -1 takes what round-off can do.",
            ParamKind::Real,
            [-1.0, 1e15],
            &[-1.0],
        ),
    ],
    suggest: None,
    run,
};

const fn number(id: &'static str, label: &'static str, default: &'static [f64]) -> Param {
    let help = "The loop's number among the curves, from 0 on; the filter boundary_loops gives curves that fit.";
    Param::new(id, label, help, ParamKind::Int, [0.0, u32::MAX as f64], default)
}

fn run(inputs: &[Input<'_>], values: &Values<'_>, job: &Job<'_>) -> Result<Vec<Output>> {
    job.step(0.0, "facing arcs")?;
    let each = inputs[0].curves()?.each()?;
    let points = |id: &'static str| {
        let value = values.number(id);
        let (points, _) = each.get(value as usize).ok_or(Error::OptionOutOfRange { option: id, value })?;
        alloc::collect(points.iter().map(|&point| DVec3::from(point)))
    };
    let loops = [points("curve_a")?, points("curve_b")?];
    let options = Options {
        run: [Run::Closest, Run::Longest][values.chosen("run")],
        tolerance: Some(values.number("tolerance")).filter(|&t| t >= 0.0),
        centres: [Centres::Vertices, Centres::Length][values.chosen("centres")],
    };
    let found = facing(&loops[0], &loops[1], &options, &job.part(0.1, 1.0))?;
    let (mut arcs, mut text) = (Curves::none(), String::new());
    let taken = (0..2).map(|side| (side, found.taken[side]));
    let others = (0..2).flat_map(|side| found.runs[side].iter().map(move |&arc| (side, arc)));
    let others = others.filter(|&(side, arc)| arc != found.taken[side]);
    for (side, arc) in taken.chain(others) {
        let own = &loops[side];
        // All of a loop is a loop.
        arcs.add(arc.places(own.len()).map(|place| own[place]), arc.count == own.len())?;
        let [name, kind] = [["first", "second"][side], if arc == found.taken[side] { "taken" } else { "left" }];
        // Writing to a string cannot fail.
        let _ = writeln!(
            text,
            "{kind} of the {name} loop: {} of {} points, from point {} on",
            arc.count,
            own.len(),
            arc.first
        );
    }
    Ok(vec![Output::Curves(arcs), Output::Text(text)])
}
