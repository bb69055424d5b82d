use super::curve::{self, CATEGORY, INTERPOLATION};
use super::data::{Curves, Input, Output};
use super::filter::{Filter, FilterBody};
use super::report::{count_with_noun, push_line};
use super::signatures::{CURVES_ONLY, TO_CURVES_TEXT};
use super::typed_param::{NON_NEGATIVE_RANGE, Param, ParamValues, params};
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_curve::{Curve, CurveKind};

/// The largest number of intersections that the report lists.
const MAX_LISTED_MEETINGS: usize = 1000;

pub(super) const FILTER: Filter = Filter {
    id: "curve_meet",
    name: "Intersections of curves",
    category: CATEGORY,
    help: "Finds where curves intersect, or pass each other within a distance. Each place is a curve of one point, midway \
           between the two curves. Self-intersections are found for curves in the plane z = 0.",
    reference: "Bezier clipping by convex hulls, and Newton's method",
    ..Filter::new(CURVES_ONLY, TO_CURVES_TEXT, &FilterBody(run))
};

params! {
    between: Option<CurveKind> = INTERPOLATION;
    within: f64 = Param::length(
        "Distance",
        "The largest distance at which curves count as meeting. 0 finds intersections up to rounding.",
        NON_NEGATIVE_RANGE, &[0.0],
    ).with_size_ratio(1e-6);
}

/// The intersections found.
struct CurveMeetings {
    meeting_points: Curves,
    text: String,
    overlaps: usize,
    undecided: usize,
}

fn run(inputs: &[Input<'_>], values: &ParamValues<Params>, job: &Job<'_>) -> Result<Vec<Output>> {
    let curves = curve::fit_curves(inputs[0].curves()?, values.between, &job.sub_job(0.0, 0.3))?;
    let mut found =
        CurveMeetings { meeting_points: Curves::without_curves(), text: String::new(), overlaps: 0, undecided: 0 };
    let box_of = |curve: &Curve| match curve.view() {
        view if view.points().is_empty() => Ok(None),
        view => view.bounding_box(&job.sub_job(0.3, 0.3)).map(Some),
    };
    let boxes = alloc::try_collect(curves.iter().map(box_of))?;
    let (within, count) = (values.within, curves.len());
    for i in 0..count {
        let job = job.sub_job(0.3, 1.0).sub_job_of_item(i, count);
        job.step(0.0, "intersections")?;
        // Self-intersections are defined for curves in the plane z = 0 only.
        if curves[i].view().points().iter().all(|point| point.z == 0.0) {
            found.add_self_intersections(i, &curves[i], &job.sub_job(0.0, 0.5))?;
        }
        for k in i + 1..count {
            let (Some(a), Some(b)) = (&boxes[i], &boxes[k]) else { continue };
            let apart = (a.low - b.high).max(b.low - a.high).max_element() > within;
            if !apart && !curves[i].view().is_empty() && !curves[k].view().is_empty() {
                let part = job.sub_job(0.5, 1.0).sub_job_of_item(k - i - 1, count);
                found.add_near_misses([i, k], [&curves[i], &curves[k]], within, &part)?;
            }
        }
    }
    let CurveMeetings { meeting_points: places, mut text, overlaps, undecided } = found;
    push_line!(
        text,
        "{}, {} shared or within the distance, {} undecided",
        count_with_noun(places.closed.len(), ["place", "places"]),
        count_with_noun(overlaps, ["part", "parts"]),
        count_with_noun(undecided, ["pair of curves", "pairs of curves"])
    );
    Ok(vec![Output::Curves(places), Output::Text(text.into())])
}

impl CurveMeetings {
    fn add_self_intersections(&mut self, number: usize, curve: &Curve, job: &Job<'_>) -> Result<()> {
        let met = curve.view().self_intersections(job)?;
        for meeting in &met.points {
            self.meeting_points.add_curve([curve.view().point(meeting.a)?].into_iter(), false)?;
            self.push_listed_line(format_args!("curve {number} with itself: {} + {}", meeting.a.segment, meeting.a.t));
        }
        self.overlaps += met.overlaps.len();
        self.undecided += usize::from(met.undecided);
        Ok(())
    }

    fn add_near_misses(&mut self, [i, k]: [usize; 2], [a, b]: [&Curve; 2], within: f64, job: &Job<'_>) -> Result<()> {
        let near = a.view().near_misses(&b.view(), within, job)?;
        for place in &near.places {
            let middle = a.view().point(place.a)?.midpoint(b.view().point(place.b)?);
            self.meeting_points.add_curve([middle].into_iter(), false)?;
            self.push_listed_line(format_args!(
                "curves {i} and {k}: {} + {} and {} + {}, {:.1e} apart",
                place.a.segment, place.a.t, place.b.segment, place.b.t, place.distance
            ));
        }
        self.overlaps += near.overlaps.len();
        self.undecided += usize::from(near.undecided);
        Ok(())
    }

    /// Adds a line to the report, unless it is long already.
    fn push_listed_line(&mut self, line: std::fmt::Arguments<'_>) {
        if self.meeting_points.closed.len() <= MAX_LISTED_MEETINGS {
            push_line!(self.text, "{line}");
        }
    }
}
