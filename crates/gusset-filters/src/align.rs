use super::data::{Input, Output};
use super::filter::{Filter, FilterBody};
use super::report::{PIECE, Report, ReportValue, count_with_noun, format_short, push_line};
use super::signatures::{ONE_MESH, TO_MESH_TEXT};
use super::typed_param::{MAX_COUNT, NON_NEGATIVE_OR_AUTO_RANGE, Param, ParamValues, params};
use gusset_attributes::{KeepSplitVertices, Origins};
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_base::{alloc, choices};
use gusset_stitch::align::{Alignment, Options, Overlap, Pose, Reason, Start, align};

pub(super) const FILTER: Filter = Filter {
    id: "align",
    name: "Align pieces",
    category: "Stitching",
    help: "Moves all pieces rigidly to where they fit: pieces that overlap, or parts of one broken surface. The first piece \
           stays. The result is one mesh of all pieces, not joined. The report says whether the place of each piece, counted \
           from 0, can be trusted. It gives the motion of the piece as three rows of four numbers: a rotation and a \
           translation. Normals that vertices carry keep their directions.",
    reference: "P. Besl, N. McKay, A method for registration of 3-D shapes (1992); Y. Chen, G. Medioni, Object modelling by \
                registration of multiple range images (1992); P. Neugebauer, Reconstruction of real-world objects via \
                simultaneous registration (1997); R. Rusu, N. Blodow, M. Beetz, Fast point feature histograms (2009); S. Rusinkiewicz, A symmetric objective \
                function for ICP (2019); Z. Chen, K. Sun, F. Yang, W. Tao, SC2-PCR (2022)",
    max_inputs: 1 << 16,
    has_origins: true,
    ..Filter::new(ONE_MESH, TO_MESH_TEXT, &FilterBody(run))
};

params! {
    start: Start<'static> = Param::choice("Start", "The positions that the pieces start from.", STARTS);
    max_distance: Option<f64> = Param::length(
        "Greatest distance",
        "Points farther than this from another piece form no pair with it, so the pieces must start this near to their \
         places. 0 and -1 take a tenth of the diagonal of the largest piece's box.",
        NON_NEGATIVE_OR_AUTO_RANGE, &[-1.0],
    ).none_unless_positive();
    samples: u32 = Param::int(
        "Points",
        "The number of points of each piece for which the nearest points of the others are found.",
        [1.0, MAX_COUNT], &[2000.0],
    );
    max_rounds: u32 = Param::int(
        "Most rounds",
        "The largest number of rounds in each of two stages. A stage ends early once nothing moves.",
        [1.0, 1e6], &[100.0],
    );
}

choices! {
    STARTS: Start<'static> =
        Start::AsGiven => "As they lie", "Each piece starts where it lies.";
        Start::PrincipalAxes => "Principal axes",
            "The principal axes of each piece are placed on the axes of the first, for pieces that each show the whole object.";
        Start::Rims => "Rims",
            "Rims of the same course are placed on each other, for pieces of one cut or broken surface. They need not overlap.";
        Start::Features => "Features",
            "Surfaces of the same shape are placed on each other, for overlapping pieces in any positions. A piece whose place \
             is not certain stays where it lies.";
}

fn run(inputs: &[Input<'_>], values: &ParamValues<Params>, job: &Job<'_>) -> Result<Vec<Output>> {
    let pieces = alloc::try_collect(inputs.iter().map(|input| input.mesh().copied()))?;
    let options = Options {
        start: values.start,
        max_distance: values.max_distance,
        samples: values.samples,
        max_rounds: values.max_rounds,
    };
    let found = align(&pieces, &options, &job.sub_job(0.0, 0.9))?;
    let mut moved = found.move_pieces(&pieces, &job.sub_job(0.9, 1.0))?;
    moved.keep_split_vertices(&alloc::gather(pieces.iter())?, &job.sub_job(1.0, 1.0))?;
    let origins = values.trace_origins(|| Origins::from_side_by_side(&pieces, &job.sub_job(1.0, 1.0)))?;
    Ok(vec![Output::Mesh(moved.0, origins), Output::Text(report(&found))])
}

/// The reason why the place of a piece is not trusted.
pub(super) fn explain_untrusted_pose(reason: Reason) -> &'static str {
    match reason {
        Reason::Trusted => "",
        Reason::NoOverlap => "it overlaps no other piece, or too little of one",
        Reason::PoorFit => "too many of its points lie off the pieces near it",
        Reason::Undetermined => "its overlaps let it slide or rotate, or fit in several ways",
        Reason::FacesOtherWay => "it faces the opposite way to the pieces that it overlaps",
        Reason::OtherSize => "its unit of length seems to differ",
        Reason::TrustedByNone => "it fits only pieces that are not trusted",
    }
}

fn report(found: &Alignment) -> Report {
    let trusted = found.pieces.iter().filter(|piece| piece.reason == Reason::Trusted).count();
    let mut text = format!(
        "{trusted} of {} trusted\n{}: {}\n",
        count_with_noun(found.pieces.len(), PIECE),
        count_with_noun(found.rounds, ["round", "rounds"]),
        if found.converged { "the pieces are at rest" } else { "the pieces still move" }
    );
    for (k, piece) in found.pieces.iter().enumerate() {
        let why = match piece.reason {
            Reason::Trusted => String::from("trusted"),
            reason => format!("not trusted: {}", explain_untrusted_pose(reason)),
        };
        push_line!(text, "piece {k}: {why}");
        push_pose_line(&mut text, &piece.pose);
    }
    found.overlaps.iter().for_each(|overlap| push_overlap_line(&mut text, overlap));
    let mut values = vec![
        ("pieces", ReportValue::count(found.pieces.len())),
        ("trusted_pieces", ReportValue::count(trusted)),
        ("rounds", ReportValue::count(found.rounds)),
        ("converged", ReportValue::flag(found.converged)),
        ("overlaps", ReportValue::count(found.overlaps.len())),
    ];
    let count: f64 = found.overlaps.iter().map(|overlap| f64::from(overlap.count)).sum();
    if count > 0.0 {
        let sum: f64 = found.overlaps.iter().map(|overlap| f64::from(overlap.count) * overlap.mean).sum();
        values.push(("mean_residual", ReportValue::length(sum / count)));
    }
    Report::new(text, &values)
}

/// A motion with all digits, for use elsewhere: a row for each coordinate.
fn push_pose_line(text: &mut String, pose: &Pose) {
    for k in 0..3 {
        let ([x, y, z], shift) = (pose.rotation.row(k).to_array(), pose.translation[k]);
        // No sign before 0.
        let [x, y, z, shift] = [x, y, z, shift].map(|number| number + 0.0);
        push_line!(text, "  {x:?} {y:?} {z:?} {shift:?}");
    }
}

fn push_overlap_line(text: &mut String, overlap: &Overlap) {
    let ([i, k], [share, other]) = (overlap.pieces, overlap.shares.map(|share| 100.0 * share));
    let fit = if overlap.trusted { "" } else { "; they do not fit" };
    push_line!(
        text,
        "pieces {i} and {k}: {share:.1} % and {other:.1} % of their points on each other, mean distance {}, root mean \
         square {}{fit}",
        format_short(overlap.mean),
        format_short(overlap.rms)
    );
}
