use super::curve::{self, CATEGORY, INTERPOLATION, REFERENCE};
use super::data::{Input, Output};
use super::filter::{Filter, FilterBody};
use super::report::{
    CURVE, Report, ReportValue, count_with_noun, format_short, format_short_point, push_line, push_unlisted_count,
};
use super::signatures::{CURVES_ONLY, TO_TEXT};
use super::typed_param::{ParamValues, params};
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_curve::{CurveKind, CurveView};

/// The largest number of curves that the report lists.
const MAX_LISTED_CURVES: usize = 1000;

pub(super) const FILTER: Filter = Filter {
    id: "curve_measures",
    name: "Measure curves",
    category: CATEGORY,
    help: "Measures curves: length, bounding box and enclosed area. A curve that is not plane has the area of its largest \
           projection. An open curve is closed by its chord.",
    reference: REFERENCE,
    ..Filter::new(CURVES_ONLY, TO_TEXT, &FilterBody(run))
};

params! {
    between: Option<CurveKind> = INTERPOLATION;
}

fn run(inputs: &[Input<'_>], values: &ParamValues<Params>, job: &Job<'_>) -> Result<Vec<Output>> {
    let curves = curve::fit_curves(inputs[0].curves()?, values.between, &job.sub_job(0.0, 0.5))?;
    let (mut text, mut total) = (String::new(), 0.0);
    for (c, curve) in curves.iter().enumerate() {
        let part = job.sub_job(0.5, 1.0).sub_job_of_item(c, curves.len());
        part.step(0.0, "measuring curves")?;
        let curve = curve.view();
        let length = if curve.is_empty() { 0.0 } else { curve.arc_lengths(&part.sub_job(0.0, 0.5))?.total_length() };
        total += length;
        if c < MAX_LISTED_CURVES {
            push_line!(text, "curve {c}: {}", measures_line(&curve, length, &part.sub_job(0.5, 1.0))?);
        }
    }
    push_unlisted_count(&mut text, curves.len(), MAX_LISTED_CURVES);
    push_line!(text, "{}, length {}", count_with_noun(curves.len(), CURVE), format_short(total));
    let values = [("curves", ReportValue::count(curves.len())), ("length", ReportValue::length(total))];
    Ok(vec![Output::Text(Report::new(text, &values))])
}

fn measures_line(curve: &CurveView<'_>, length: f64, job: &Job<'_>) -> Result<String> {
    let kind = if curve.is_closed() { "closed" } else { "open" };
    if curve.points().is_empty() {
        return Ok(format!("{kind}, without points"));
    }
    let (area, bounds) = (curve.area_vector(&job.sub_job(0.0, 0.5))?, curve.bounding_box(&job.sub_job(0.5, 1.0))?);
    Ok(format!(
        "{kind}, length {}, area {}, seen along {}, box {} to {}",
        format_short(length),
        format_short(area.length()),
        format_short_point(area.normalize_or_zero()),
        format_short_point(bounds.low),
        format_short_point(bounds.high)
    ))
}
