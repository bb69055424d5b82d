use super::data::{Curves, Input, Output};
use super::filter::{Filter, FilterBody};
use super::report::{POINT, count_with_noun, push_line};
use super::signatures::{CURVES_ONLY, TO_CURVES_TEXT};
use super::typed_param::{MAX_COUNT, NON_NEGATIVE_OR_AUTO_RANGE, Param, ParamValues, TypedParam, params};
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::{Allowed, Error, Result};
use gusset_base::job::Job;
use gusset_stitch::stitch::facing::{Centres, Options, Run, facing};

pub(super) const FACING_ARCS_OF_LOOPS: Filter = Filter {
    id: "facing_arcs",
    name: "Facing arcs of two loops",
    category: "Boundary",
    help: "Finds the points of two loops that face each other. A point faces the other loop if it lies on that side of the \
           plane through the centre of its own loop. The arcs that stitching would join come first, then the other arcs.",
    reference: "S. Nesterenko, The algorithm for polygonal networks of cross-linking, algorithm 2",
    ..Filter::new(CURVES_ONLY, TO_CURVES_TEXT, &FilterBody(run))
};

params! {
    curve_a: u32 = Param::int("First loop", CURVE_HELP, CURVE_NUMBER_RANGE, &[0.0]);
    curve_b: u32 = Param::int("Second loop", CURVE_HELP, CURVE_NUMBER_RANGE, &[1.0]);
    run: Run = FACING_ARC;
    centres: Centres = Param::choice("Centres", "The definition of a loop's centre.", Centres::CHOICES);
    tolerance: Option<f64> = FACING_TOLERANCE;
}

const CURVE_NUMBER_RANGE: [f64; 2] = [0.0, MAX_COUNT];
const CURVE_HELP: &str = "The number of the curve, from 0 on. The filter boundary_loops gives suitable curves.";

/// Chooses the arc to join where several face the other loop.
pub(super) const FACING_ARC: TypedParam<Run> =
    Param::choice("Facing arc", "The arc that is taken if several arcs face the other loop.", Run::CHOICES);

/// Sets the distance from its plane beyond which a vertex faces the other loop; `None` takes the
/// bound on rounding.
pub(super) const FACING_TOLERANCE: TypedParam<Option<f64>> = Param::real(
    "Facing tolerance",
    "The smallest distance from the plane through the centre of its own loop at which a point faces the other loop. -1 takes \
     the bound on rounding.",
    NON_NEGATIVE_OR_AUTO_RANGE,
    &[-1.0],
)
.none_if_negative();

fn run(inputs: &[Input<'_>], values: &ParamValues<Params>, job: &Job<'_>) -> Result<Vec<Output>> {
    job.step(0.0, "facing arcs")?;
    let each = inputs[0].curves()?.polylines()?;
    let points = |option: &'static str, number: u32| {
        let missing =
            Error::OptionOutOfRange { option, value: number.into(), allowed: Allowed::IndexBelow(each.len() as u64) };
        let (points, _) = each.get(number as usize).ok_or(missing)?;
        alloc::collect(points.iter().map(|&point| DVec3::from(point)))
    };
    let loops = [points("curve_a", values.curve_a)?, points("curve_b", values.curve_b)?];
    let options = Options { run: values.run, tolerance: values.tolerance, centres: values.centres };
    let found = facing(&loops[0], &loops[1], &options, &job.sub_job(0.1, 1.0))?;
    let (mut arcs, mut text) = (Curves::without_curves(), String::new());
    let taken = (0..2).map(|side| (side, found.taken[side]));
    let others = (0..2).flat_map(|side| found.runs[side].iter().map(move |&arc| (side, arc)));
    let others = others.filter(|&(side, arc)| arc != found.taken[side]);
    for (side, arc) in taken.chain(others) {
        let own = &loops[side];
        // An arc of all points is closed.
        arcs.add_curve(arc.places(own.len()).map(|place| own[place]), arc.count == own.len())?;
        let [name, kind] = [["first", "second"][side], if arc == found.taken[side] { "taken" } else { "left" }];
        push_line!(
            text,
            "{kind} of the {name} loop: {} of {}, from point {} on",
            arc.count,
            count_with_noun(own.len(), POINT),
            arc.first
        );
    }
    Ok(vec![Output::Curves(arcs), Output::Text(text.into())])
}
