//! The filter `strip`.

use super::Filter;
use super::data::{Input, InputKind, Output, OutputKind};
use super::param::{Choice, Param, Values};
use super::stitch::{MERIDIANS, meridians};
use crate::alloc;
use crate::error::{Error, Result};
use crate::job::Job;
use crate::mesh::{Mesh, PositionBuffer, Scalar};
use crate::stitch::{RuledOptions, Start, ruled};
use glam::DVec3;

pub(super) const FILTER: Filter = Filter {
    id: "strip",
    name: "Strip between two curves",
    script_name: "strip",
    category: "Stitching",
    help: "Spans a strip of triangles between two polylines, both closed or both open, which run side by side in one direction.",
    reference: "H. Fuchs, Z. Kedem, S. Uselton, Optimal surface reconstruction from planar contours, 1977; S. Nesterenko for the rule \
                by index",
    inputs: &[InputKind::Curves],
    min_inputs: 1,
    max_inputs: 1,
    outputs: &[OutputKind::Mesh, OutputKind::Text],
    replaces: false,
    params: &[
        Param::choice(
            "meridians",
            "Meridians",
            "How points of one curve are joined to points of the other.",
            MERIDIANS,
        ),
        Param::choice(
            "start",
            "First meridian",
            "Where the strip between closed curves begins; between open ones it begins at their first points.",
            &[
                Choice { label: "Automatic", help: "Where it gives the best strip of those tried." },
                Choice { label: "Closest pair", help: "Between the two points nearest to each other." },
                Choice { label: "First points", help: "Between the first points." },
            ],
        ),
        Param::flag("reversed", "Backwards", "The second curve is taken the other way round."),
    ],
    suggest: None,
    run,
};

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
        meridians: meridians(values.chosen("meridians")),
        start: [Some(Start::Auto), Some(Start::Closest), None][values.chosen("start")],
        ..RuledOptions::default()
    };
    let made = ruled(&a, &b, closed, &options, job)?;
    let mut positions = PositionBuffer::with_capacity(Scalar::F64, a.len() + b.len())?;
    positions.extend(a.into_iter().chain(b))?;
    let count = made.triangles.len();
    let mesh = Mesh {
        positions,
        face_offsets: alloc::collect((0..count + 1).map(|f| 3 * f as u32))?,
        face_corners: alloc::copied(made.triangles.as_flattened())?,
    };
    let text =
        format!("{count} triangles, the first meridian from point {} to point {}\n", made.start[0], made.start[1]);
    Ok(vec![Output::Mesh(mesh), Output::Text(text)])
}
