use super::data::{Input, Output};
use super::filter::{Filter, FilterBody};
use super::report::{FACE, Report, ReportValue, VERTEX, count_with_noun, push_line};
use super::signatures::{ONE_MESH, TO_MESH_TEXT};
use super::typed_param::{MAX_COUNT, NON_NEGATIVE_OR_AUTO_RANGE, Param, ParamValues, params};
use gusset_attributes::{KeepSplitVertices, Origins};
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_mesh::MeshView;
use gusset_stitch::trim::{KeptFacesOfPieces, Options, TrimmedPieces, trim};
use std::f64::consts::FRAC_PI_3;

pub(super) const FILTER: Filter = Filter {
    id: "trim",
    name: "Trim overlaps",
    category: "Stitching",
    help: "Keeps one piece of each overlap, and leaves a narrow gap to the other pieces. The pieces must be in their final \
           places. The result is one mesh of all kept faces, not joined. No vertex moves, and no face is cut. The report counts \
           pieces from 0.",
    reference: "G. Turk, M. Levoy, Zippered polygon meshes from range images (1994), for the idea",
    max_inputs: 1 << 16,
    has_origins: true,
    ..Filter::new(ONE_MESH, TO_MESH_TEXT, &FilterBody(run))
};

params! {
    max_distance: Option<f64> = Param::length(
        "Greatest distance",
        "Surfaces at most this far apart overlap. 0 takes surfaces that touch; -1 takes four mean edges of the coarser piece.",
        NON_NEGATIVE_OR_AUTO_RANGE, &[-1.0],
    ).none_if_negative();
    max_angle: f64 = Param::angle(
        "Greatest angle",
        "Surfaces whose normals differ by a larger angle do not overlap.",
        [0.001, 1.57], &[FRAC_PI_3],
    );
    min_faces: u32 = Param::int(
        "Fewest faces",
        "Remaining parts of fewer faces are dropped, unless they are whole components of a piece.",
        [1.0, MAX_COUNT], &[30.0],
    );
}

fn run(inputs: &[Input<'_>], values: &ParamValues<Params>, job: &Job<'_>) -> Result<Vec<Output>> {
    let pieces = alloc::try_collect(inputs.iter().map(|input| input.mesh().copied()))?;
    let options = Options {
        max_distance: values.max_distance,
        max_angle: values.max_angle,
        min_faces: values.min_faces,
        ..Options::default()
    };
    let trimmed = trim(&pieces, &options, &job.sub_job(0.0, 0.9))?;
    let mut left = TrimmedPieces::new(&pieces, &trimmed, &job.sub_job(0.9, 1.0))?;
    left.keep_split_vertices(&alloc::gather(pieces.iter())?, &job.sub_job(1.0, 1.0))?;
    let report = report(&pieces, &trimmed);
    let origins = values.trace_origins(|| Origins::from_trimmed(&pieces, &left, &job.sub_job(1.0, 1.0)))?;
    Ok(vec![Output::Mesh(left.mesh, origins), Output::Text(report)])
}

fn report(pieces: &[MeshView<'_>], trimmed: &KeptFacesOfPieces) -> Report {
    let kept: usize = trimmed.kept.iter().map(Vec::len).sum();
    let all: usize = pieces.iter().map(|piece| piece.faces().len()).sum();
    let mut text = format!("{kept} of {} kept\n", count_with_noun(all, FACE));
    for (k, (piece, (kept, &covered))) in pieces.iter().zip(trimmed.kept.iter().zip(&trimmed.covered)).enumerate() {
        let verb = if covered == 1 { "lies" } else { "lie" };
        let (faces, vertices) = (count_with_noun(piece.faces().len(), FACE), count_with_noun(covered, VERTEX));
        push_line!(text, "piece {k}: {} of {faces} kept, {vertices} {verb} on other pieces", kept.len());
    }
    if trimmed.crossings > 0 {
        push_line!(text, "{} dropped that intersected other pieces", count_with_noun(trimmed.crossings, FACE));
    }
    let values = [
        ("kept_faces", ReportValue::count(kept)),
        ("trimmed_faces", ReportValue::count(all - kept)),
        ("covered_vertices", ReportValue::count(trimmed.covered.iter().map(|&count| u64::from(count)).sum::<u64>())),
        ("crossing_faces", ReportValue::count(trimmed.crossings)),
    ];
    Report::new(text, &values)
}
