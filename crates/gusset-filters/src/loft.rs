use super::curve::REFERENCE;
use super::data::{Input, Output, Polyline};
use super::filter::{Filter, FilterBody};
use super::report::{Report, ReportValue, count_with_noun, push_line, push_unlisted_count};
use super::signatures::{CURVES_ONLY, TO_MESH_TEXT};
use super::smooth::{self, CATEGORY, DEVIATION, MIN_PARTS_PER_SIDE, TRIANGLES};
use super::typed_param::{Param, ParamValues, params};
use glam::DVec3;
use gusset_base::error::{Error, Result};
use gusset_base::geom::Aabb;
use gusset_base::job::Job;
use gusset_base::{alloc, choices};
use gusset_curve::frame::{Axis, Correspondence, Frame, FrameOptions, RepeatedSection, frame, repeated_sections};
use gusset_curve::{Outlines, Points};
use gusset_surface::construct::FrameSurface;
use gusset_surface::{Sheet, Surface};
use std::f64::consts::PI;

pub(super) const FILTER: Filter = Filter {
    id: "loft",
    name: "Loft through sections",
    category: CATEGORY,
    help: "Draws a smooth surface through consecutive sections of a body, all closed or all open. A section of one point is a \
           tip. Corners of sections stay sharp. Between two equal sections, the surface is their cylinder. Sections that \
           repeat the previous one are left out, and the report names them.",
    reference: REFERENCE,
    ..Filter::new(CURVES_ONLY, TO_MESH_TEXT, &FilterBody(run))
};

params! {
    nodes: MakeCorrespondence =
        Param::choice("Nodes", "The rule by which points of the sections correspond.", CORRESPONDENCES);
    columns: u32 = Param::int(
        "Columns",
        "The number of nodes on each section; more if there are more corners. Ignored if the nodes are the given points.",
        [2.0, 100_000.0], &[32.0],
    );
    corner_angle: Option<f64> = Param::angle(
        "Corners",
        "Points where a section turns by more than this angle are corners; pi makes all of them smooth. If negative, closed \
         sections of up to 6 points are polygons. So are sections whose points turn by more than 54 or less than 6 degrees. \
         Other corners turn by 40 degrees and far more than usual.",
        [-1.0, PI], &[-1.0],
    ).none_if_negative();
    through: FrameSurface = Param::choice("Through", "The elements that the surface contains.", FrameSurface::CHOICES);
    ring: bool = Param::flag("Ring", "The first section follows the last one.");
    point: DVec3 = Param::point(
        "Point of the axis",
        "A point on the axis of the angles. The centre of the sections is suggested.",
        &[0.0; 3],
    ).suggested(|_, extent| Some(extent.centre()));
    direction: DVec3 = Param::direction(
        "Direction of the axis",
        "The direction of the axis of the angles. The direction from the first section to the last is suggested.",
    ).suggested(direction_from_first_to_last);
    deviation: f64 = DEVIATION;
    parts: u32 = MIN_PARTS_PER_SIDE;
    triangles: bool = TRIANGLES;
}

/// The correspondence of the points of sections.
type MakeCorrespondence = fn(&Params) -> Correspondence<'static>;

choices! {
    CORRESPONDENCES: MakeCorrespondence =
        |values| Correspondence::ArcLength { columns: values.columns as usize } => "By arc length",
            "Points at equal fractions of the length. Closed sections start where they twist least.";
        |_| Correspondence::Given => "By number", "The given points, equally many on each section.";
        |values| Correspondence::Angle {
            columns: values.columns as usize,
            axis: Axis::Line { point: values.point, direction: values.direction },
            reference: values.direction.any_orthonormal_vector(),
        } => "By angle", "Points at equal angles about an axis.";
}

/// The direction from the mean point of the first section to the mean point of the last.
fn direction_from_first_to_last(inputs: &[Input<'_>], extent: &Aabb) -> Option<DVec3> {
    let Some(Input::Curves(curves)) = inputs.first() else { return None };
    let middle = |ends: &[u32]| -> Option<DVec3> {
        let points = curves.points.get(ends[0] as usize..ends[1] as usize)?;
        let sum: DVec3 = points.iter().map(|&point| DVec3::from(point) / extent.diagonal()).sum();
        Some(sum / points.len() as f64).filter(|middle| middle.is_finite())
    };
    let mut sections = curves.offsets.windows(2);
    let (first, last) = (sections.next().and_then(middle)?, sections.next_back().and_then(middle)?);
    (last - first).try_normalize()
}

fn run(inputs: &[Input<'_>], values: &ParamValues<Params>, job: &Job<'_>) -> Result<Vec<Output>> {
    let given = inputs[0].curves()?;
    let sections = given.polylines()?;
    // A section of one point is a tip, and counts as either.
    let has_extent = |section: &&Polyline<'_>| section.0.iter().any(|point| *point != section.0[0]);
    let closed = sections.iter().find(has_extent).is_some_and(|section| section.1);
    if sections.iter().filter(has_extent).any(|section| section.1 != closed) {
        return Err(Error::InputUnfit { input: 0, why: "all curves must be closed, or all open" });
    }
    let too_few = Error::CurveCount {
        input: 0,
        given: sections.len() as u64,
        needed: if values.ring { "at least three for a ring" } else { "at least two" },
    };
    if sections.is_empty() {
        return Err(too_few);
    }
    // Points of a section that is not a tip differ, or there are none.
    let is_tip = |section: &Polyline<'_>| !section.0.is_empty() && !has_extent(&section);
    if sections.len() > 1 && sections.iter().all(is_tip) {
        return Err(Error::OnlyTips);
    }
    let mut options = FrameOptions { ring: values.ring, ..FrameOptions::new((values.nodes)(values)) };
    if let Some(angle) = values.corner_angle {
        (options.across.corner_angle, options.smooth_corners) = (angle, angle >= PI);
    }
    let found = frame_of_distinct_sections(&sections, closed, &options, &job.sub_job(0.0, 0.4));
    let (made, repeats) = found.map_err(|error| match error {
        Error::OptionOutOfRange { option: "sections", .. } => too_few,
        error => error,
    })?;
    let sheet = Sheet::from_frame(&made, [values.ring, closed], values.through, &job.sub_job(0.4, 0.6))?;
    let surface = Surface::new(vec![sheet], None, &job.sub_job(0.6, 0.7))?;
    let (mesh, meshed) =
        smooth::mesh_surface(&surface, (values.deviation, values.parts, values.triangles), &job.sub_job(0.7, 1.0))?;
    let text = format!("{meshed}{}", report(&made, &repeats));
    let mut numbers = alloc::copied(meshed.values())?;
    alloc::push(&mut numbers, ("repeated_sections", ReportValue::count(repeats.len())))?;
    Ok(vec![Output::Mesh(mesh, None), Output::Text(Report::new(text, &numbers))])
}

/// Makes the frame of the sections that repeat no earlier one. Returns the others too, by their
/// places in the input.
fn frame_of_distinct_sections(
    sections: &[Polyline<'_>],
    closed: bool,
    options: &FrameOptions<'_>,
    job: &Job<'_>,
) -> Result<(Frame, Vec<RepeatedSection>)> {
    let least = if options.ring { 3 } else { 2 };
    let mut kept = alloc::collect(0..sections.len())?;
    let (mut left_out, mut done) = (Vec::new(), 0.0);
    loop {
        let points = alloc::gather(kept.iter().flat_map(|&k| sections[k].0).copied())?;
        let mut offsets = alloc::with_capacity(kept.len() + 1)?;
        offsets.push(0);
        offsets.extend(kept.iter().scan(0, |end, &k| {
            *end += sections[k].0.len() as u32;
            Some(*end)
        }));
        let outlines =
            Outlines { points: Points::from(&points[..]), offsets: Some(&offsets), closed, constraints: &[] };
        let until = 0.5 * (done + 1.0);
        let made = frame(&outlines, options, &job.sub_job(done, until))?;
        let repeats = repeated_sections(&made.grid, options.ring)?;
        if repeats.is_empty() {
            left_out.sort_unstable_by_key(|repeat: &RepeatedSection| repeat.section);
            return Ok((made, left_out));
        }
        let given = |section: u32| kept[section as usize] as u32;
        let in_input = |repeat: &RepeatedSection| RepeatedSection {
            section: given(repeat.section),
            earlier: given(repeat.earlier),
        };
        if kept.len() - repeats.len() < least {
            let RepeatedSection { section, earlier } = in_input(&repeats[0]);
            return Err(Error::RepeatedSection { section, earlier });
        }
        alloc::extend(&mut left_out, repeats.iter().map(in_input))?;
        let (mut next, mut place) = (repeats.iter().map(|repeat| repeat.section).peekable(), 0..);
        kept.retain(|_| next.next_if_eq(&place.next().unwrap_or_default()).is_none());
        done = until;
    }
}

const NODE_NOUN: [&str; 2] = ["node", "nodes"];
/// Repeated sections that the report names.
const MAX_LISTED_SECTIONS: usize = 20;

fn report(made: &Frame, repeats: &[RepeatedSection]) -> String {
    let turned = made.grid.turned.iter().filter(|&&turned| turned != 0).count();
    let mut text = format!(
        "{} of {}, {turned} of them reversed, {}, {} ambiguous; twist at most {:.1} degrees\n",
        count_with_noun(made.grid.rows, ["section", "sections"]),
        count_with_noun(made.grid.columns, NODE_NOUN),
        count_with_noun(made.grid.corners.len(), ["corner", "corners"]),
        count_with_noun(made.grid.ambiguous.len(), NODE_NOUN),
        made.grid.max_twist.to_degrees()
    );
    for RepeatedSection { section, earlier } in repeats.iter().take(MAX_LISTED_SECTIONS) {
        push_line!(text, "section {section} repeats section {earlier} and was left out");
    }
    push_unlisted_count(&mut text, repeats.len(), MAX_LISTED_SECTIONS);
    text
}
