use super::data::{Curves, Input, Output};
use super::filter::Filter;
use super::param::{Param, Values};
use super::report::POINT;
use super::report::{counted, push_line};
use super::signatures::{CURVES, TO_CURVES_TEXT};
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::{Error, Result};
use gusset_base::job::Job;
use gusset_stitch::stitch::facing::{Centres, Options, Run, facing};

pub(super) const FILTER: Filter = Filter {
    id: "facing_arcs",
    name: "Facing arcs of two loops",
    category: "Boundary",
    help: "Finds the points of two loops that face each other: those on the other loop's side of the plane through their own \
           loop's centre. The arcs that stitching would join come first, then all others.",
    reference: "S. Nesterenko, The algorithm for polygonal networks of cross-linking, algorithm 2",
    params: &[
        Param::int("curve_a", "First loop", CURVE_NUMBERS, &[0.0]).with_help(CURVE_HELP),
        Param::int("curve_b", "Second loop", CURVE_NUMBERS, &[1.0]).with_help(CURVE_HELP),
        Param::choice("run", "Facing arc", Run::CHOICES.texts).with_help(RUN_HELP),
        Param::choice("centres", "Centres", Centres::CHOICES.texts).with_help("The definition of a loop's centre."),
        Param::real("tolerance", "Facing tolerance", [-1.0, 1e15], &[-1.0]).with_help(
            "The smallest distance from the plane at which a point faces the other loop; -1 takes the bound on rounding.",
        ),
    ],
    ..Filter::new(CURVES, TO_CURVES_TEXT, run)
};

const CURVE_NUMBERS: [f64; 2] = [0.0, u32::MAX as f64];
const CURVE_HELP: &str = "The number of the curve, from 0 on; the filter boundary_loops gives suitable curves.";
pub(super) const RUN_HELP: &str = "The arc that is taken where several face the other loop.";

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
        run: values.choice("run", Run::CHOICES),
        tolerance: Some(values.number("tolerance")).filter(|&t| t >= 0.0),
        centres: values.choice("centres", Centres::CHOICES),
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
        push_line!(
            text,
            "{kind} of the {name} loop: {} of {}, from point {} on",
            arc.count,
            counted(own.len(), POINT),
            arc.first
        );
    }
    Ok(vec![Output::Curves(arcs), Output::Text(text.into())])
}
