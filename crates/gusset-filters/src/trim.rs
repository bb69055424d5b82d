use super::data::{Input, Output};
use super::filter::Filter;
use super::param::{Param, ParamKind, Values};
use super::report::{FACE, VERTEX};
use super::report::{Report, counted, push_line};
use super::signatures::{MESH, TO_MESH_TEXT};
use super::weld::TOLERANCES;
use gusset_attributes::{KeepSplits, Origins};
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_mesh::MeshView;
use gusset_stitch::trim::{Options, Remains, Trimmed, trim};
use std::f64::consts::FRAC_PI_3;

pub(super) const FILTER: Filter = Filter {
    id: "trim",
    name: "Trim overlaps",
    category: "Stitching",
    help: "Keeps of each overlap of pieces, which must lie where they belong, one piece, and leaves a narrow gap to the others. The \
           result is one mesh of the faces that are kept, side by side and not joined. No vertex moves and no face is cut. The \
           report counts pieces from 0.",
    reference: "G. Turk, M. Levoy, Zippered polygon meshes from range images (1994), for the idea",
    max_inputs: 1 << 16,
    has_origins: true,
    params: &[
        Param::length("max_distance", "Greatest distance", TOLERANCES, &[-1.0]).with_help(
            "Surfaces that are no farther apart are one; 0 takes those that touch, -1 takes four mean edges of the coarser \
             piece.",
        ),
        Param::new(ParamKind::Angle, "max_angle", "Greatest angle", [0.001, 1.57], &[FRAC_PI_3])
            .with_help("Surfaces whose normals differ by more are two."),
        Param::int("min_faces", "Fewest faces", [1.0, u32::MAX as f64], &[30.0])
            .with_help("Parts of fewer faces go, but for whole components of the pieces."),
    ],
    ..Filter::new(MESH, TO_MESH_TEXT, run)
};

fn run(inputs: &[Input<'_>], values: &Values<'_>, job: &Job<'_>) -> Result<Vec<Output>> {
    let pieces = alloc::try_collect(inputs.iter().map(|input| input.mesh().copied()))?;
    let options = Options {
        max_distance: Some(values.number("max_distance")).filter(|&distance| distance >= 0.0),
        max_angle: values.number("max_angle"),
        min_faces: values.number("min_faces") as u32,
        ..Options::default()
    };
    let trimmed = trim(&pieces, &options, &job.part(0.0, 0.9))?;
    let mut left = Remains::new(&pieces, &trimmed, &job.part(0.9, 1.0))?;
    left.keep_splits(&alloc::gather(pieces.iter())?, &job.part(1.0, 1.0))?;
    let report = report(&pieces, &trimmed);
    let origins = values.origins(|| Origins::from_remains(&pieces, &left, &job.part(1.0, 1.0)))?;
    Ok(vec![Output::Mesh(left.mesh, origins), Output::Text(report)])
}

fn report(pieces: &[MeshView<'_>], trimmed: &Trimmed) -> Report {
    let kept: usize = trimmed.kept.iter().map(Vec::len).sum();
    let all: usize = pieces.iter().map(|piece| piece.faces().len()).sum();
    let mut text = format!("{kept} of {} kept\n", counted(all, FACE));
    for (k, (piece, (kept, &covered))) in pieces.iter().zip(trimmed.kept.iter().zip(&trimmed.covered)).enumerate() {
        let verb = if covered == 1 { "lies" } else { "lie" };
        let (faces, vertices) = (counted(piece.faces().len(), FACE), counted(covered, VERTEX));
        push_line!(text, "piece {k}: {} of {faces} kept, {vertices} {verb} on others", kept.len());
    }
    if trimmed.crossings > 0 {
        push_line!(text, "{} cut those of other pieces and went", counted(trimmed.crossings, FACE));
    }
    let values = [
        ("kept_faces", kept as f64),
        ("trimmed_faces", (all - kept) as f64),
        ("covered_vertices", trimmed.covered.iter().map(|&count| f64::from(count)).sum()),
        ("crossing_faces", f64::from(trimmed.crossings)),
    ];
    Report::new(text, &values)
}
