//! The filter `loft`.

use super::Filter;
use super::curve::REFERENCE;
use super::data::{Input, InputKind, Output, OutputKind};
use super::extent::{extent_of, put};
use super::param::{Choice, PLACES, Param, ParamKind, Values};
use super::smooth::{self, CATEGORY, FINENESS};
use crate::alloc;
use crate::error::{Error, Result};
use crate::job::Job;
use crate::outline::frame::{Correspondence, Frame, FrameOptions, frame};
use crate::outline::{Options, Outlines, Points};
use crate::surface::construct::FrameSurface;
use crate::surface::{Sheet, Surface};
use glam::DVec3;

pub(super) const FILTER: Filter = Filter {
    id: "loft",
    name: "Smooth surface through sections",
    script_name: "loft",
    category: CATEGORY,
    help: "Draws a smooth surface through sections of a body, curves one behind another, all closed or all open: nodes are placed on the \
           sections, curves are drawn along the body, and the surface through both comes out as a mesh.",
    reference: REFERENCE,
    inputs: &[InputKind::Curves],
    min_inputs: 1,
    max_inputs: 1,
    outputs: &[OutputKind::Mesh, OutputKind::Text],
    replaces: false,
    params: PARAMS,
    suggest: Some(suggest),
    run,
};

const PARAMS: &[Param] = &[
    Param::choice(
        "nodes",
        "Nodes",
        "Which points of the sections belong together.",
        &[
            Choice {
                label: "By arc length",
                help: "Those at equal parts of the length from each section's first point on.",
            },
            Choice { label: "By number", help: "The points themselves, of which all sections have equally many." },
            Choice { label: "By angle", help: "Those at equal angles round an axis." },
        ],
    ),
    Param::new(
        "columns",
        "Columns",
        "The number of nodes on each section; not read if nodes are the points themselves.",
        ParamKind::Int,
        [2.0, 100_000.0],
        &[32.0],
    ),
    Param::choice(
        "through",
        "Through",
        "What the surface contains.",
        &[
            Choice { label: "Nodes", help: "The nodes: bicubic pieces from 6 x 6 of them each." },
            Choice { label: "Curves", help: "All curves through the nodes, across and along." },
        ],
    ),
    Param::flag("ring", "Ring", "The last section is followed by the first one."),
    Param::new(
        "point",
        "Point of the axis",
        "The axis of the angles passes this point; suggested is the middle of the sections.",
        ParamKind::Point,
        PLACES,
        &[0.0; 3],
    ),
    Param::new(
        "direction",
        "Direction of the axis",
        "The axis of the angles runs along this direction; suggested is that from the first section to the last.",
        ParamKind::Direction,
        PLACES,
        &[0.0, 0.0, 1.0],
    ),
    FINENESS[0],
    FINENESS[1],
    FINENESS[2],
];

fn suggest(inputs: &[Input<'_>], values: &mut [f64]) {
    let (Some(extent), Some(Input::Curves(curves))) = (extent_of(inputs), inputs.first()) else { return };
    put(PARAMS, values, "point", &extent.centre().to_array());
    let middle = |ends: &[u32]| -> Option<DVec3> {
        let points = curves.points.get(ends[0] as usize..ends[1] as usize)?;
        let sum: DVec3 = points.iter().map(|&point| DVec3::from(point) / extent.diagonal()).sum();
        Some(sum / points.len() as f64).filter(|middle| middle.is_finite())
    };
    let mut sections = curves.offsets.windows(2);
    if let (Some(first), Some(last)) = (sections.next().and_then(middle), sections.next_back().and_then(middle))
        && let Some(direction) = (last - first).try_normalize()
    {
        put(PARAMS, values, "direction", &direction.to_array());
    }
}

fn run(inputs: &[Input<'_>], values: &Values<'_>, job: &Job<'_>) -> Result<Vec<Output>> {
    let given = inputs[0].curves()?;
    let sections = given.each()?;
    let closed = sections.first().is_some_and(|section| section.1);
    if sections.iter().any(|section| section.1 != closed) {
        return Err(Error::InputUnfit { input: 0, why: "all curves must be closed, or all open" });
    }
    let columns = values.number("columns") as usize;
    let direction = values.direction("direction")?;
    let correspondence = match values.chosen("nodes") {
        0 => Correspondence::ArcLength { columns },
        1 => Correspondence::Given,
        _ => Correspondence::Angle {
            columns,
            point: values.vector("point"),
            direction,
            reference: direction.any_orthonormal_vector(),
        },
    };
    let (across, along, ring) = (Options::default(), Options::default(), values.is_set("ring"));
    let offsets = alloc::copied(&given.offsets)?;
    let outlines =
        Outlines { points: Points::from(&given.points[..]), offsets: Some(&offsets), closed, constraints: &[] };
    let too_few = Error::InputUnfit { input: 0, why: "two curves are needed at least, three for a ring" };
    if sections.is_empty() {
        return Err(too_few);
    }
    let options = FrameOptions { correspondence, across, along, ring };
    let made = frame(&outlines, &options, &job.part(0.0, 0.4)).map_err(|error| match error {
        Error::OptionOutOfRange { option: "sections", .. } => too_few,
        error => error,
    })?;
    let kind = [FrameSurface::Nodes, FrameSurface::Curves][values.chosen("through")];
    let sheet = Sheet::from_frame(&made, [ring, closed], kind, &job.part(0.4, 0.6))?;
    let surface = Surface::new(vec![sheet], None, &job.part(0.6, 0.7))?;
    let (mesh, text) = smooth::meshed(&surface, values, &job.part(0.7, 1.0))?;
    Ok(vec![Output::Mesh(mesh), Output::Text(text + &report(&made))])
}

fn report(made: &Frame) -> String {
    let turned = made.grid.turned.iter().filter(|&&turned| turned != 0).count();
    format!(
        "{} sections of {} nodes, {turned} of them taken backwards, {} nodes ambiguous\n",
        made.grid.rows,
        made.grid.columns,
        made.grid.ambiguous.len()
    )
}
