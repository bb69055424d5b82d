use super::curve::{self, CATEGORY, CHORD_ERROR, CurvePlane, INTERPOLATION, PLANE};
use super::data::{Curves, Input, Output};
use super::filter::{Filter, FilterBody};
use super::report::{count_with_noun, push_line};
use super::signatures::{CURVES_ONLY, TO_CURVES_TEXT};
use super::typed_param::{COORDINATE_RANGE, Param, ParamValues, PlaneValue, params};
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_curve::CurveKind;
use gusset_curve::ops::{OffsetOptions, SampleSpacing};

/// The largest number of segments of an offset.
const MAX_OFFSET_SEGMENTS: usize = 1 << 20;

pub(super) const FILTER: Filter = Filter {
    id: "curve_offset",
    name: "Offset curves",
    category: CATEGORY,
    help: "Draws the offset curves of plane curves, on their left as seen against the normal of the plane. Straight segments \
           join the corners. An offset intersects itself where the distance exceeds the radius of curvature.",
    reference: "Hermite interpolation of the exact offset, halved until the deviation measured is small enough",
    ..Filter::new(CURVES_ONLY, TO_CURVES_TEXT, &FilterBody(run))
};

params! {
    between: Option<CurveKind> = INTERPOLATION;
    plane: PlaneValue = PLANE;
    distance: f64 = Param::length(
        "Distance",
        "The signed distance of the offset: to the left if positive, to the right if negative.",
        COORDINATE_RANGE, &[0.1],
    ).with_size_ratio(0.02);
    chord_error: f64 = CHORD_ERROR;
}

fn run(inputs: &[Input<'_>], values: &ParamValues<Params>, job: &Job<'_>) -> Result<Vec<Output>> {
    let (given, flat) = (inputs[0].curves()?, CurvePlane::new(values.plane));
    let curves = flat.fit_curves_in_plane(given, values.between, &job.sub_job(0.0, 0.3))?;
    let tolerance = curve::absolute_chord_error(given, values.chord_error);
    let options = OffsetOptions { degree: 3, tolerance: 0.5 * tolerance, max_segments: MAX_OFFSET_SEGMENTS };
    let (mut drawn, mut text) = (Curves::without_curves(), String::new());
    for (c, curve) in curves.iter().enumerate() {
        let part = job.sub_job(0.3, 1.0).sub_job_of_item(c, curves.len());
        part.step(0.0, "offset")?;
        if curve.view().is_empty() {
            push_line!(text, "curve {c}: left out, as it has no length");
            continue;
        }
        let offset = curve.view().offset(values.distance, &options, &part.sub_job(0.0, 0.8))?;
        let points =
            curve::sample_curve(&offset.curve.view(), SampleSpacing::Chord(0.5 * tolerance), &part.sub_job(0.8, 1.0))?;
        drawn.add_curve(points.iter().map(|&point| flat.to_space(point)), offset.curve.view().is_closed())?;
        let tight = if offset.tight { ", some radii of curvature are less than the distance" } else { "" };
        let reached = if offset.reached { "" } else { ", more than the chord error allows" };
        push_line!(
            text,
            "curve {c}: {}, at most {:.1e} from the true offset{reached}{tight}",
            count_with_noun(offset.corners, ["corner", "corners"]),
            offset.deviation
        );
    }
    Ok(vec![Output::Curves(drawn), Output::Text(text.into())])
}
