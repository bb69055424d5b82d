use super::data::{Input, Output};
use super::filter::{Filter, FilterBody};
use super::report::{FACE, count_with_noun};
use super::signatures::{CURVES_ONLY, TO_MESH_TEXT};
use super::stitch::{CELLS, MERIDIANS, MakeRows, ROW_COUNT, ROWS};
use super::typed_param::{Param, ParamValues, params};
use glam::DVec3;
use gusset_base::error::{Error, Result};
use gusset_base::job::Job;
use gusset_base::{alloc, choices};
use gusset_stitch::stitch::{Cells, Meridians, RuledOptions, Start, ruled};

pub(super) const FILTER: Filter = Filter {
    id: "strip",
    name: "Strip between two curves",
    category: "Stitching",
    help: "Spans a strip of faces between two polylines, both closed or both open, that run side by side in the same direction.",
    reference: "H. Fuchs, Z. Kedem, S. Uselton, Optimal surface reconstruction from planar contours, 1977; S. Nesterenko for \
                the rule by index",
    ..Filter::new(CURVES_ONLY, TO_MESH_TEXT, &FilterBody(run))
};

params! {
    meridians: Meridians =
        MERIDIANS.with_help("The rule that joins points of one curve to points of the other.");
    start: Option<Start> = Param::choice(
        "First meridian",
        "The start of the strip between closed curves. Between open curves it starts at their first points.",
        STARTS,
    );
    reversed: bool = Param::flag("Reversed", "Reverses the second curve.");
    rows: MakeRows = ROWS;
    row_count: u32 = ROW_COUNT;
    cells: Cells = CELLS;
}

choices! {
    STARTS: Option<Start> =
        Some(Start::Auto) => "Automatic", "At the best of several strips.";
        Some(Start::Closest) => "Closest pair", "Between the nearest two points.";
        None => "First points", "Between the first points.";
}

fn run(inputs: &[Input<'_>], values: &ParamValues<Params>, job: &Job<'_>) -> Result<Vec<Output>> {
    job.step(0.0, "strip")?;
    let curves = inputs[0].curves()?.polylines()?;
    let &[(a, closed), (b, other)] = curves.as_slice() else {
        return Err(Error::CurveCount { input: 0, given: curves.len() as u64, needed: "two" });
    };
    if closed != other {
        return Err(Error::InputUnfit { input: 0, why: "both curves must be closed, or both open" });
    }
    let a = alloc::collect(a.iter().map(|&point| DVec3::from(point)))?;
    let mut b = alloc::collect(b.iter().map(|&point| DVec3::from(point)))?;
    if values.reversed {
        b.reverse();
    }
    let options = RuledOptions {
        meridians: values.meridians,
        start: values.start,
        rows: (values.rows)(values.row_count),
        cells: values.cells,
        ..RuledOptions::default()
    };
    let made = ruled(&a, &b, closed, &options, job)?;
    let text = format!(
        "{}, the first meridian from point {} to point {}\n",
        count_with_noun(made.mesh.face_count(), FACE),
        made.start[0],
        made.start[1]
    );
    Ok(vec![Output::Mesh(made.mesh, None), Output::Text(text.into())])
}
