use super::data::{Input, Output};
use super::filter::Filter;
use super::param::{Param, Values};
use super::report::FACE;
use super::report::counted;
use super::signatures::{CURVES, TO_MESH_TEXT};
use super::stitch::{CELLS, ROW_COUNT, ROWS, rows};
use glam::DVec3;
use gusset_base::error::{Error, Result};
use gusset_base::job::Job;
use gusset_base::{alloc, choices};
use gusset_stitch::stitch::{Cells, Meridians, RuledOptions, Start, ruled};

pub(super) const FILTER: Filter = Filter {
    id: "strip",
    name: "Strip between two curves",
    category: "Stitching",
    help: "Spans a strip of faces between two polylines of one direction that run side by side, both closed or both open.",
    reference: "H. Fuchs, Z. Kedem, S. Uselton, Optimal surface reconstruction from planar contours, 1977; S. Nesterenko for the rule \
                by index",
    params: &[
        Param::choice("meridians", "Meridians", Meridians::CHOICES.texts)
            .with_help("The rule that joins points of one curve to points of the other."),
        Param::choice("start", "First meridian", STARTS.texts)
            .with_help("The start of the strip between closed curves; between open ones it is at their first points."),
        Param::flag("reversed", "Reversed").with_help("Reverses the second curve."),
        ROWS,
        ROW_COUNT,
        CELLS,
    ],
    ..Filter::new(CURVES, TO_MESH_TEXT, run)
};

choices! {
    STARTS: Option<Start> =
        Some(Start::Auto) => "Automatic", "At the best strip of those tried.";
        Some(Start::Closest) => "Closest pair", "Between the two points nearest to each other.";
        None => "First points", "Between the first points.";
}

fn run(inputs: &[Input<'_>], values: &Values<'_>, job: &Job<'_>) -> Result<Vec<Output>> {
    job.step(0.0, "strip")?;
    let curves = inputs[0].curves()?.each()?;
    let &[(a, closed), (b, other)] = curves.as_slice() else {
        return Err(Error::InputUnfit { input: 0, why: "two curves are needed" });
    };
    if closed != other {
        return Err(Error::InputUnfit { input: 0, why: "both curves must be closed, or both open" });
    }
    let a = alloc::collect(a.iter().map(|&point| DVec3::from(point)))?;
    let mut b = alloc::collect(b.iter().map(|&point| DVec3::from(point)))?;
    if values.is_set("reversed") {
        b.reverse();
    }
    let options = RuledOptions {
        meridians: values.choice("meridians", Meridians::CHOICES),
        start: values.choice("start", STARTS),
        rows: rows(values),
        cells: values.choice("cells", Cells::CHOICES),
        ..RuledOptions::default()
    };
    let made = ruled(&a, &b, closed, &options, job)?;
    let text = format!(
        "{}, the first meridian from point {} to point {}\n",
        counted(made.mesh.face_count(), FACE),
        made.start[0],
        made.start[1]
    );
    Ok(vec![Output::Mesh(made.mesh, None), Output::Text(text.into())])
}
