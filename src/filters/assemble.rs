//! The filter `assemble`.

use super::Filter;
use super::data::{Input, InputKind, Output, OutputKind};
use super::param::{Choice, Param, ParamKind, Values};
use super::stitch::{FAIRING, MERIDIANS, meridians};
use crate::alloc;
use crate::error::Result;
use crate::fill;
use crate::job::Job;
use crate::repair::weld;
use crate::stitch::assemble::{Assembly, MaxGap, Options, Outcome, assemble};
use crate::stitch::{self, Fairing, Rows};

pub(super) const FILTER: Filter = Filter {
    id: "assemble",
    name: "Assemble pieces",
    script_name: "assemble",
    category: "Stitching",
    help: "Makes one mesh of many open pieces: borders that lie on one another are sewn, faces made to agree, loops that face \
           each other across a gap stitched, and holes filled if wanted. What faces nothing is left alone.",
    reference: "S. Nesterenko, The algorithm for polygonal networks of cross-linking, for a single gap",
    inputs: &[InputKind::Mesh],
    min_inputs: 1,
    max_inputs: 1 << 16,
    outputs: &[OutputKind::Mesh, OutputKind::Text],
    replaces: false,
    params: &[
        length(
            "tolerance",
            "Welding distance",
            "Borders are sewn where their vertices are no farther apart than this; 0 for equal positions, -1 for no welding.",
            -1.0,
            0.0,
        ),
        length(
            "max_gap",
            "Widest gap",
            "The mean width of the widest gap that is closed; 0 leaves all open, -1 decides by the size of the loops.",
            -1.0,
            -1.0,
        ),
        Param::choice(
            "extent",
            "Join",
            "What of the loops is joined.",
            &[
                Choice {
                    label: "Loops and parts of them",
                    help: "Whole loops, and runs of vertices that face each other.",
                },
                Choice { label: "Whole loops", help: "No parts." },
            ],
        ),
        Param::choice(
            "meridians",
            "Meridians",
            "How vertices of one loop are joined to vertices of the other.",
            MERIDIANS,
        ),
        Param::choice(
            "rows",
            "Rows",
            "Whether rows of new vertices lie between the rims.",
            &[
                Choice { label: "None", help: "Every meridian is one edge." },
                Choice { label: "By mean edge", help: "New edges are about as long as the mean edge of the pieces." },
            ],
        ),
        Param::choice("fairing", "Shape of the rows", "Where the new vertices lie.", FAIRING),
        Param::choice(
            "holes",
            "Holes that are left",
            "What becomes of them in the end.",
            &[
                Choice { label: "Leave", help: "They stay open." },
                Choice { label: "Fill", help: "Triangles between the vertices of the rim." },
                Choice {
                    label: "Fill, refined and fair",
                    help: "New vertices, moved until the patch goes on as the surface does.",
                },
            ],
        ),
    ],
    suggest: None,
    run,
};

const fn length(id: &'static str, label: &'static str, help: &'static str, min: f64, default: f64) -> Param {
    Param {
        id,
        label,
        help,
        kind: ParamKind::Real,
        min,
        max: 1e15,
        default: if default < 0.0 { &[-1.0] } else { &[0.0] },
        step: 0.0,
        choices: &[],
    }
}

fn run(inputs: &[Input<'_>], values: &Values<'_>, job: &Job<'_>) -> Result<Vec<Output>> {
    let mut pieces = alloc::with_capacity(inputs.len())?;
    for input in inputs {
        pieces.push(*input.mesh()?);
    }
    let (tolerance, max_gap) = (values.number("tolerance"), values.number("max_gap"));
    let options = Options {
        weld: (tolerance >= 0.0).then(|| weld::Options { tolerance: Some(tolerance), ..weld::Options::default() }),
        max_gap: if max_gap < 0.0 { MaxGap::Auto } else { MaxGap::Given(max_gap) },
        whole_loops_only: values.chosen("extent") == 1,
        strip: stitch::Options {
            meridians: meridians(values.chosen("meridians")),
            rows: [Rows::None, Rows::MeanEdge][values.chosen("rows")],
            fairing: [Fairing::None, Fairing::ThinPlate][values.chosen("fairing")],
            ..stitch::Options::default()
        },
        fill: match values.chosen("holes") {
            0 => None,
            1 => Some(fill::Options::default()),
            _ => Some(fill::Options {
                refinement: fill::Refinement::RimDensity(0),
                fairing: fill::Fairing::ThinPlate,
                ..fill::Options::default()
            }),
        },
        ..Options::default()
    };
    let done = assemble(&pieces, &options, job)?;
    let text = report(&done);
    Ok(vec![Output::Mesh(done.mesh), Output::Text(text)])
}

fn report(done: &Assembly) -> String {
    let mut text = format!("{} edges sewn\n", done.sewn_edges);
    for joint in &done.joints {
        let [n, m] = joint.sides.each_ref().map(Vec::len);
        let parts = if joint.whole { "loops" } else { "runs" };
        let outcome = match joint.outcome {
            Outcome::Joined => format!("joined by {} faces", joint.faces.len()),
            Outcome::OrientationConflict => "left: joining them would make a one-sided surface".to_owned(),
            Outcome::ShareVertex => "left: they pass the same vertex".to_owned(),
            Outcome::NoStrip => "left: no strip avoids the edges that the mesh has".to_owned(),
        };
        text += &format!("{parts} of {n} and {m} vertices, {} apart: {outcome}\n", joint.gap);
    }
    let filled = done.holes.iter().filter(|hole| hole.status == fill::HoleStatus::Filled).count();
    text + &format!("{filled} holes filled, {} boundary loops left\n", done.loops_left)
}
