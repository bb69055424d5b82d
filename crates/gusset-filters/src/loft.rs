use super::curve::REFERENCE;
use super::data::{Input, Output};
use super::extent::extent_of;
use super::filter::{Defaults, Filter};
use super::param::{COORDINATES, Param, ParamKind, Values};
use super::report::{Report, counted};
use super::signatures::{CURVES, TO_MESH_TEXT};
use super::smooth::{self, CATEGORY, FINENESS};
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::choice::Choice;
use gusset_base::error::{Error, Result};
use gusset_base::job::Job;
use gusset_curve::frame::{Axis, Correspondence, Frame, FrameOptions, frame};
use gusset_curve::{Outlines, Points};
use gusset_surface::construct::FrameSurface;
use gusset_surface::{Sheet, Surface};

pub(super) const FILTER: Filter = Filter {
    id: "loft",
    name: "Loft through sections",
    category: CATEGORY,
    help: "Draws a smooth surface through consecutive sections of a body, all closed or all open: nodes are placed on the sections, \
           curves are drawn along the body, and the surface through both is returned as a mesh.",
    reference: REFERENCE,
    params: &[
        Param::choice("nodes", "Nodes", CORRESPONDENCES)
            .with_help("The rule by which points of the sections correspond."),
        Param::int("columns", "Columns", [2.0, 100_000.0], &[32.0])
            .with_help("The number of nodes on each section; ignored if the nodes are the given points."),
        Param::choice("through", "Through", FrameSurface::CHOICES.texts)
            .with_help("The elements that the surface contains."),
        Param::flag("ring", "Ring").with_help("The last section is followed by the first."),
        Param::new(ParamKind::Point, "point", "Point of the axis", COORDINATES, &[0.0; 3])
            .with_help("A point on the axis of the angles; the centre of the sections is suggested."),
        Param::direction("direction", "Direction of the axis")
            .with_help("The direction of the axis of the angles; from the first section to the last is suggested."),
        FINENESS[0],
        FINENESS[1],
        FINENESS[2],
    ],
    suggest: Some(suggest),
    ..Filter::new(CURVES, TO_MESH_TEXT, run)
};

const CORRESPONDENCES: &[Choice] = &[
    Choice::new(
        "By arc length",
        "Points at equal fractions of the length; closed sections start where they are turned least.",
    ),
    Choice::new("By number", "The given points, of which all sections have equally many."),
    Choice::new("By angle", "Points at equal angles round an axis."),
];

fn suggest(inputs: &[Input<'_>], defaults: &mut Defaults<'_>) {
    let (Some(extent), Some(Input::Curves(curves))) = (extent_of(inputs), inputs.first()) else { return };
    defaults.set("point", &extent.centre().to_array());
    let middle = |ends: &[u32]| -> Option<DVec3> {
        let points = curves.points.get(ends[0] as usize..ends[1] as usize)?;
        let sum: DVec3 = points.iter().map(|&point| DVec3::from(point) / extent.diagonal()).sum();
        Some(sum / points.len() as f64).filter(|middle| middle.is_finite())
    };
    let mut sections = curves.offsets.windows(2);
    if let (Some(first), Some(last)) = (sections.next().and_then(middle), sections.next_back().and_then(middle))
        && let Some(direction) = (last - first).try_normalize()
    {
        defaults.set("direction", &direction.to_array());
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
    let correspondence = match values.place("nodes") {
        0 => Correspondence::ArcLength { columns },
        1 => Correspondence::Given,
        _ => Correspondence::Angle {
            columns,
            axis: Axis::Line { point: values.vector("point"), direction },
            reference: direction.any_orthonormal_vector(),
        },
    };
    let ring = values.is_set("ring");
    let offsets = alloc::copied(&given.offsets)?;
    let outlines =
        Outlines { points: Points::from(&given.points[..]), offsets: Some(&offsets), closed, constraints: &[] };
    let too_few = Error::InputUnfit { input: 0, why: "two curves are needed at least, three for a ring" };
    if sections.is_empty() {
        return Err(too_few);
    }
    let options = FrameOptions { ring, ..FrameOptions::new(correspondence) };
    let made = frame(&outlines, &options, &job.part(0.0, 0.4)).map_err(|error| match error {
        Error::OptionOutOfRange { option: "sections", .. } => too_few,
        error => error,
    })?;
    let kind = values.choice("through", FrameSurface::CHOICES);
    let sheet = Sheet::from_frame(&made, [ring, closed], kind, &job.part(0.4, 0.6))?;
    let surface = Surface::new(vec![sheet], None, &job.part(0.6, 0.7))?;
    let (mesh, meshed) = smooth::meshed(&surface, values, &job.part(0.7, 1.0))?;
    let text = format!("{meshed}{}", report(&made));
    Ok(vec![Output::Mesh(mesh, None), Output::Text(Report::new(text, meshed.values()))])
}

const NODE: [&str; 2] = ["node", "nodes"];

fn report(made: &Frame) -> String {
    let turned = made.grid.turned.iter().filter(|&&turned| turned != 0).count();
    format!(
        "{} of {}, {turned} of them taken backwards, {} ambiguous; twist at most {:.1} degrees\n",
        counted(made.grid.rows, ["section", "sections"]),
        counted(made.grid.columns, NODE),
        counted(made.grid.ambiguous.len(), NODE),
        made.grid.max_twist.to_degrees()
    )
}
