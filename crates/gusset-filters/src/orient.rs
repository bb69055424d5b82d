use super::data::{Input, Output};
use super::filter::{Filter, FilterBody};
use super::report::{FACE, PIECE, Report, ReportValue, count_with_noun, push_line, push_unlisted_count};
use super::signatures::{ONE_MESH, TO_MESH_TEXT};
use super::typed_param::{Param, ParamValues, params};
use gusset_attributes::{KeepSplitVertices, Origins};
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_stitch::repair::orient::{Options, Oriented, Outward, orient};

/// The largest number of components that the report lists.
const MAX_LISTED_PIECES: usize = 20;

pub(super) const FILTER: Filter = Filter {
    id: "orient",
    name: "Orient faces",
    category: "Repair",
    help: "Reverses the fewest faces of each component that make neighbours consistently oriented. One-sided components, such \
           as a Moebius strip, stay as they are.",
    reference: "Breadth-first search across edges of two faces",
    replaces: true,
    has_origins: true,
    ..Filter::new(ONE_MESH, TO_MESH_TEXT, &FilterBody(run))
};

params! {
    outward: Outward = Param::choice("Closed components", "The orientation of closed components.", Outward::CHOICES);
}

fn run(inputs: &[Input<'_>], values: &ParamValues<Params>, job: &Job<'_>) -> Result<Vec<Output>> {
    let options = Options { outward: values.outward };
    let mut done = orient(inputs[0].mesh()?, &options, job)?;
    done.keep_split_vertices(&[inputs[0].mesh()?], &job.sub_job(1.0, 1.0))?;
    let report = report(&done);
    let origins = values.trace_origins(|| Origins::from_oriented(&done, &job.sub_job(1.0, 1.0)))?;
    Ok(vec![Output::Mesh(done.mesh, origins), Output::Text(report)])
}

fn report(done: &Oriented) -> Report {
    let mut text = format!(
        "{} of {} reversed, {}\n",
        done.turned_faces,
        count_with_noun(done.turned.len(), FACE),
        count_with_noun(done.components, PIECE)
    );
    for found in done.one_sided.iter().take(MAX_LISTED_PIECES) {
        push_line!(text, "the piece of face {} is one-sided (half-edge {})", found.face, found.half_edge);
    }
    push_unlisted_count(&mut text, done.one_sided.len(), MAX_LISTED_PIECES);
    let values = [
        ("turned_faces", ReportValue::count(done.turned_faces)),
        ("pieces", ReportValue::count(done.components)),
        ("one_sided_pieces", ReportValue::count(done.one_sided.len())),
    ];
    Report::new(text, &values)
}
