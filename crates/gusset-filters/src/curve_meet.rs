use super::curve::{self, CATEGORY, INTERPOLATION};
use super::data::{Curves, Input, Output};
use super::filter::Filter;
use super::param::{NON_NEGATIVE, Param, Values};
use super::report::{counted, push_line};
use super::signatures::{CURVES, TO_CURVES_TEXT};
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_curve::Curve;

/// The largest number of intersections that the report lists.
const MAX_LISTED: usize = 1000;

pub(super) const FILTER: Filter = Filter {
    id: "curve_meet",
    name: "Intersections of curves",
    category: CATEGORY,
    help: "Finds where curves intersect, or pass each other within a distance: a curve of one point for each place, midway between \
           the two. Self-intersections of curves in the plane z = 0 are found too.",
    reference: "Bezier clipping by convex hulls, and Newton's method",
    params: &[
        INTERPOLATION,
        Param::length("within", "Distance", NON_NEGATIVE, &[0.0])
            .with_help("The largest distance at which curves count as meeting; 0 for intersections up to rounding.")
            .with_size_ratio(1e-6),
    ],
    ..Filter::new(CURVES, TO_CURVES_TEXT, run)
};

/// The intersections found.
struct Found {
    places: Curves,
    text: String,
    overlaps: usize,
    undecided: usize,
}

fn run(inputs: &[Input<'_>], values: &Values<'_>, job: &Job<'_>) -> Result<Vec<Output>> {
    let curves = curve::curves(inputs[0].curves()?, values, &job.part(0.0, 0.3))?;
    let mut found = Found { places: Curves::none(), text: String::new(), overlaps: 0, undecided: 0 };
    let box_of = |curve: &Curve| match curve.view() {
        view if view.points().is_empty() => Ok(None),
        view => view.bounding_box(&job.part(0.3, 0.3)).map(Some),
    };
    let boxes = alloc::try_collect(curves.iter().map(box_of))?;
    let (within, count) = (values.number("within"), curves.len());
    for i in 0..count {
        let job = job.part(0.3, 1.0).share(i, count);
        job.step(0.0, "intersections")?;
        // Of curves in other planes than z = 0 there is no way to tell.
        if curves[i].view().points().iter().all(|point| point.z == 0.0) {
            found.with_itself(i, &curves[i], &job.part(0.0, 0.5))?;
        }
        for k in i + 1..count {
            let (Some(a), Some(b)) = (&boxes[i], &boxes[k]) else { continue };
            let apart = (a.low - b.high).max(b.low - a.high).max_element() > within;
            if !apart && !curves[i].view().is_empty() && !curves[k].view().is_empty() {
                let part = job.part(0.5, 1.0).share(k - i - 1, count);
                found.with_each_other([i, k], [&curves[i], &curves[k]], within, &part)?;
            }
        }
    }
    let Found { places, mut text, overlaps, undecided } = found;
    push_line!(
        text,
        "{}, {} in common or beside each other, {} undecided",
        counted(places.closed.len(), ["place", "places"]),
        counted(overlaps, ["part", "parts"]),
        counted(undecided, ["pair of curves", "pairs of curves"])
    );
    Ok(vec![Output::Curves(places), Output::Text(text.into())])
}

impl Found {
    fn with_itself(&mut self, number: usize, curve: &Curve, job: &Job<'_>) -> Result<()> {
        let met = curve.view().self_intersections(job)?;
        for meeting in &met.points {
            self.places.add([curve.view().point(meeting.a)?].into_iter(), false)?;
            self.note(format_args!("curve {number} with itself: {} + {}", meeting.a.segment, meeting.a.t));
        }
        self.overlaps += met.overlaps.len();
        self.undecided += usize::from(met.undecided);
        Ok(())
    }

    fn with_each_other(&mut self, [i, k]: [usize; 2], [a, b]: [&Curve; 2], within: f64, job: &Job<'_>) -> Result<()> {
        let near = a.view().near_misses(&b.view(), within, job)?;
        for place in &near.places {
            let middle = a.view().point(place.a)?.midpoint(b.view().point(place.b)?);
            self.places.add([middle].into_iter(), false)?;
            self.note(format_args!(
                "curves {i} and {k}: {} + {} and {} + {}, {:.1e} apart",
                place.a.segment, place.a.t, place.b.segment, place.b.t, place.distance
            ));
        }
        self.overlaps += near.overlaps.len();
        self.undecided += usize::from(near.undecided);
        Ok(())
    }

    /// A line of the report, as long as it is short.
    fn note(&mut self, line: std::fmt::Arguments<'_>) {
        if self.places.closed.len() <= MAX_LISTED {
            push_line!(self.text, "{line}");
        }
    }
}
