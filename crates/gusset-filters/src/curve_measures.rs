use super::curve::{self, CATEGORY, INTERPOLATION, REFERENCE};
use super::data::{Input, Output};
use super::filter::{Body, Filter};
use super::report::{CURVE, Report, counted, push_line, push_more, short, short_point};
use super::signatures::{CURVES, TO_TEXT};
use super::typed::{Values, params};
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_curve::{CurveView, Mode};

/// The largest number of curves that the report lists.
const MAX_LISTED: usize = 1000;

pub(super) const FILTER: Filter = Filter {
    id: "curve_measures",
    name: "Measure curves",
    category: CATEGORY,
    help: "Measures curves: length, bounding box and enclosed area. A curve that is not plane has the area of its largest \
           projection. An open curve is closed by its chord.",
    reference: REFERENCE,
    ..Filter::new(CURVES, TO_TEXT, &Body(run))
};

params! {
    between: Option<Mode> = INTERPOLATION;
}

fn run(inputs: &[Input<'_>], values: &Values<Params>, job: &Job<'_>) -> Result<Vec<Output>> {
    let curves = curve::curves(inputs[0].curves()?, values.between, &job.part(0.0, 0.5))?;
    let (mut text, mut total) = (String::new(), 0.0);
    for (c, curve) in curves.iter().enumerate() {
        let part = job.part(0.5, 1.0).share(c, curves.len());
        part.step(0.0, "measuring curves")?;
        let curve = curve.view();
        let length = if curve.is_empty() { 0.0 } else { curve.lengths(&part.part(0.0, 0.5))?.total() };
        total += length;
        if c < MAX_LISTED {
            push_line!(text, "curve {c}: {}", line(&curve, length, &part.part(0.5, 1.0))?);
        }
    }
    push_more(&mut text, curves.len(), MAX_LISTED);
    push_line!(text, "{}, length {}", counted(curves.len(), CURVE), short(total));
    let values = [("curves", curves.len() as f64), ("length", total)];
    Ok(vec![Output::Text(Report::new(text, &values))])
}

fn line(curve: &CurveView<'_>, length: f64, job: &Job<'_>) -> Result<String> {
    let kind = if curve.is_closed() { "closed" } else { "open" };
    if curve.points().is_empty() {
        return Ok(format!("{kind}, without points"));
    }
    let (area, bounds) = (curve.area_vector(&job.part(0.0, 0.5))?, curve.bounding_box(&job.part(0.5, 1.0))?);
    Ok(format!(
        "{kind}, length {}, area {}, seen along {}, box {} to {}",
        short(length),
        short(area.length()),
        short_point(area.normalize_or_zero()),
        short_point(bounds.low),
        short_point(bounds.high)
    ))
}
