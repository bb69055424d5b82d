use super::data::{Input, Output};
use super::filter::Filter;
use super::param::{Param, Values};
use super::report::PIECE;
use super::report::{Report, counted, push_line, short};
use super::signatures::{MESH, TO_MESH_TEXT};
use super::weld::TOLERANCES;
use gusset_attributes::{KeepSplits, Origins};
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_base::{alloc, choices};
use gusset_stitch::align::{Alignment, Options, Overlap, Pose, Reason, Start, align};

pub(super) const FILTER: Filter = Filter {
    id: "align",
    name: "Align pieces",
    category: "Stitching",
    help: "Moves pieces that overlap, or that are parts of one broken surface, rigidly to where they fit, all at once; the first one \
           stays. The result is one mesh of all pieces side by side, not joined. The report says of each piece, counted from 0, \
           whether it can be trusted to lie right, and gives its motion as three rows of four numbers, a rotation and a shift. \
           Normals that vertices carry are not turned with them.",
    reference: "P. Besl, N. McKay, A method for registration of 3-D shapes (1992); Y. Chen, G. Medioni, Object modelling by registration \
                of multiple range images (1992); P. Neugebauer, Reconstruction of real-world objects via simultaneous registration \
                (1997); S. Rusinkiewicz, A symmetric objective function for ICP (2019)",
    max_inputs: 1 << 16,
    has_origins: true,
    params: &[
        Param::choice("start", "Start", STARTS.texts).with_help("Where the pieces are to begin with."),
        Param::length("max_distance", "Greatest distance", TOLERANCES, &[-1.0]).with_help(
            "Points that are farther from another piece are no pair with it; the pieces must begin that near to where they \
             belong. 0 and -1 take a tenth of the diagonal of the largest piece's box.",
        ),
        Param::int("samples", "Points", [1.0, u32::MAX as f64], &[2000.0])
            .with_help("So many points of each piece are looked for on the others."),
        Param::int("max_rounds", "Most rounds", [1.0, 1e6], &[100.0])
            .with_help("The largest number of rounds in each of two stages; they end before once nothing moves."),
    ],
    ..Filter::new(MESH, TO_MESH_TEXT, run)
};

choices! {
    STARTS: Start<'static> =
        Start::AsGiven => "As they lie", "Each piece begins where its positions say.";
        Start::PrincipalAxes => "Principal axes", "Those of each on those of the first: pieces that show the same object whole.";
        Start::Rims => "Rims", "By rims that run alike: pieces of one surface that was cut or broken, which need not overlap.";
}

fn run(inputs: &[Input<'_>], values: &Values<'_>, job: &Job<'_>) -> Result<Vec<Output>> {
    let pieces = alloc::try_collect(inputs.iter().map(|input| input.mesh().copied()))?;
    let options = Options {
        start: values.choice("start", STARTS),
        max_distance: Some(values.number("max_distance")).filter(|&distance| distance > 0.0),
        samples: values.number("samples") as u32,
        max_rounds: values.number("max_rounds") as u32,
    };
    let found = align(&pieces, &options, &job.part(0.0, 0.9))?;
    let mut moved = found.moved(&pieces, &job.part(0.9, 1.0))?;
    moved.keep_splits(&alloc::gather(pieces.iter())?, &job.part(1.0, 1.0))?;
    let origins = values.origins(|| Origins::from_side_by_side(&pieces, &job.part(1.0, 1.0)))?;
    Ok(vec![Output::Mesh(moved.0, origins), Output::Text(report(&found))])
}

/// Why a piece is not trusted to lie right.
pub(super) fn why_not(reason: Reason) -> &'static str {
    match reason {
        Reason::Trusted => "",
        Reason::NoOverlap => "it lies on no other piece, or on too little of one",
        Reason::PoorFit => "too much of it lies off the pieces that it is near",
        Reason::Undetermined => "the overlaps leave it free to slide or to turn",
        Reason::FacesOtherWay => "it faces the other way than the pieces that it lies on",
        Reason::OtherSize => "its unit of length seems to be another",
        Reason::TrustedByNone => "it fits pieces only that are not trusted",
    }
}

fn report(found: &Alignment) -> Report {
    let trusted = found.pieces.iter().filter(|piece| piece.reason == Reason::Trusted).count();
    let mut text = format!(
        "{trusted} of {} trusted to lie right\n{}: {}\n",
        counted(found.pieces.len(), PIECE),
        counted(found.rounds, ["round", "rounds"]),
        if found.converged { "nothing moves any more" } else { "they still move" }
    );
    for (k, piece) in found.pieces.iter().enumerate() {
        let why = match piece.reason {
            Reason::Trusted => String::from("trusted"),
            reason => format!("not trusted: {}", why_not(reason)),
        };
        push_line!(text, "piece {k}: {why}");
        push_pose(&mut text, &piece.pose);
    }
    found.overlaps.iter().for_each(|overlap| push_overlap(&mut text, overlap));
    let mut values = vec![
        ("pieces", found.pieces.len() as f64),
        ("trusted_pieces", trusted as f64),
        ("rounds", f64::from(found.rounds)),
        ("converged", f64::from(u8::from(found.converged))),
        ("overlaps", found.overlaps.len() as f64),
    ];
    let count: f64 = found.overlaps.iter().map(|overlap| f64::from(overlap.count)).sum();
    if count > 0.0 {
        let sum: f64 = found.overlaps.iter().map(|overlap| f64::from(overlap.count) * overlap.mean).sum();
        values.push(("mean_residual", sum / count));
    }
    Report::new(text, &values)
}

/// A motion with all digits, for use elsewhere: a row for each coordinate.
fn push_pose(text: &mut String, pose: &Pose) {
    for k in 0..3 {
        let ([x, y, z], shift) = (pose.rotation.row(k).to_array(), pose.translation[k]);
        // No sign before 0.
        let [x, y, z, shift] = [x, y, z, shift].map(|number| number + 0.0);
        push_line!(text, "  {x:?} {y:?} {z:?} {shift:?}");
    }
}

fn push_overlap(text: &mut String, overlap: &Overlap) {
    let ([i, k], [share, other]) = (overlap.pieces, overlap.shares.map(|share| 100.0 * share));
    let fit = if overlap.trusted { "" } else { "; they do not fit" };
    push_line!(
        text,
        "pieces {i} and {k}: {share:.1} % and {other:.1} % of their points on each other, mean distance {}, root mean \
         square {}{fit}",
        short(overlap.mean),
        short(overlap.rms)
    );
}
