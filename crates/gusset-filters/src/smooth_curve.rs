use super::curve::{self, INTERPOLATION};
use super::data::{Curves, Input, InputKind, Output};
use super::filter::{Filter, FilterBody};
use super::report::{HIT, count_with_noun, format_short, format_short_point, push_line};
use super::signatures::TO_CURVES_TEXT;
use super::smooth::{self, CATEGORY, REFERENCE, SCHEME};
use super::typed_param::{ParamValues, params};
use gusset_base::error::{Error, Result};
use gusset_base::job::Job;
use gusset_curve::CurveKind;
use gusset_surface::Scheme;
use gusset_surface::line_intersection::HitSelection;

/// The largest number of intersections that the report lists.
const MAX_LISTED_HITS: usize = 1000;

pub(super) const FILTER: Filter = Filter {
    id: "smooth_curve",
    name: "Intersections of curves with a smooth surface",
    category: CATEGORY,
    help: "Finds where curves intersect the smooth surface through the vertices of a quad grid. Each intersection is a curve of \
           one point. No intersection is missed.",
    reference: REFERENCE,
    ..Filter::new(&[InputKind::Mesh, InputKind::Curves], TO_CURVES_TEXT, &FilterBody(run))
};

params! {
    scheme: Scheme = SCHEME;
    between: Option<CurveKind> = INTERPOLATION;
}

fn run(inputs: &[Input<'_>], values: &ParamValues<Params>, job: &Job<'_>) -> Result<Vec<Output>> {
    let curves = curve::fit_curves(inputs[1].curves()?, values.between, &job.sub_job(0.0, 0.2))?;
    let surface = smooth::surface_through_mesh(inputs[0].mesh()?, values.scheme, &job.sub_job(0.2, 0.6))?;
    let (mut points, mut text) = (Curves::without_curves(), String::new());
    let job = job.sub_job(0.6, 1.0);
    for (c, curve) in curves.iter().enumerate().filter(|(_, curve)| !curve.view().is_empty()) {
        let part = job.sub_job_of_item(c, curves.len());
        let hits = surface.curve(&curve.view(), HitSelection::All, &part).map_err(|error| match error {
            Error::OptionOutOfRange { .. } => Error::InputUnfit { input: 1, why: "coordinates up to 1e150 are needed" },
            error => error,
        })?;
        for hit in hits {
            points.add_curve([hit.point].into_iter(), false)?;
            if points.closed.len() <= MAX_LISTED_HITS {
                let touches = if hit.tangent { ", touches" } else { "" };
                let (t, point) = (format_short(hit.at.t), format_short_point(hit.point));
                push_line!(text, "curve {c} at {} + {t}: {point}{touches}", hit.at.segment);
            }
        }
    }
    push_line!(text, "{}", count_with_noun(points.closed.len(), HIT));
    Ok(vec![Output::Curves(points), Output::Text(text.into())])
}
