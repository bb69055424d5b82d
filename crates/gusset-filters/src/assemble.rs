use super::align::why_not;
use super::data::{Input, Output};
use super::fill_holes::OUTWARD_HELP;
use super::filter::Filter;
use super::param::{Param, Values};
use super::report::{BOUNDARY_LOOP, EDGE, FACE, PIECE};
use super::report::{Report, counted, push_line, short};
use super::signatures::{MESH, TO_MESH_TEXT};
use super::stitch::{FAIRING_HELP, FINISH_HELP};
use super::weld::{TOLERANCES, tolerance};
use gusset_attributes::{KeepSplits, Origins};
use gusset_base::choice::Choice;
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_base::{alloc, choices};
use gusset_stitch::align::{self, Alignment, align};
use gusset_stitch::assemble::{Assembly, MaxGap, Options, Outcome, Overlaps, Reason, assemble};
use gusset_stitch::fill;
use gusset_stitch::repair::orient::Outward;
use gusset_stitch::repair::weld;
use gusset_stitch::stitch::{self, Fairing, Finish, Meridians, Rows};
use gusset_stitch::trim;

pub(super) const FILTER: Filter = Filter {
    id: "assemble",
    name: "Assemble pieces",
    category: "Stitching",
    help: "Joins many open pieces to one mesh: overlaps are trimmed on request, coincident borders sewn, orientations made \
           consistent, loops that face each other across a gap stitched, holes filled on request, and closed results turned \
           outwards. Loops that face none are left as they are.",
    reference: "S. Nesterenko, The algorithm for polygonal networks of cross-linking, for a single gap",
    max_inputs: 1 << 16,
    has_origins: true,
    params: &[
        Param::choice("weld", "Coincident borders", WELDS.texts).with_help("The treatment of borders that coincide."),
        Param::length("tolerance", "Welding distance", TOLERANCES, &[-1.0]).with_help(
            "The largest distance of border vertices that are welded; 0 takes equal positions, -1 what rounding of the \
             positions can do, as their type and the digits that they show tell.",
        ),
        Param::real("max_gap", "Widest gap", [-1.0, 1e15], &[-1.0]).with_help(
            "The largest mean width of a gap that is closed; 0 leaves all open, -1 decides by the size of the loops.",
        ),
        Param::choice("extent", "Join", EXTENTS.texts).with_help("The parts of the loops that are joined."),
        Param::choice("meridians", "Meridians", Meridians::CHOICES.texts)
            .with_help("The rule that joins vertices of one loop to vertices of the other."),
        Param::choice("rows", "Rows", ROWS.texts).with_help("The rows of new vertices between the rims."),
        Param::choice("fairing", "Shape of the rows", Fairing::CHOICES.texts).with_help(FAIRING_HELP),
        Param::choice("finish", "Finish", Finish::CHOICES.texts).with_help(FINISH_HELP),
        Param::choice("holes", "Remaining holes", HOLES).with_help("The treatment of holes that remain."),
        Param { default: &[1.0], ..Param::flag("outward", "Turn outwards") }.with_help(OUTWARD_HELP),
        Param::choice("overlaps", "Overlaps", OVERLAPS.texts).with_help("The treatment of pieces that overlap."),
        Param::flag("align", "Align first").with_help(
            "Pieces that overlap are moved to where they fit before all else, as the filter align moves them from where they \
             lie; the first one stays.",
        ),
    ],
    ..Filter::new(MESH, TO_MESH_TEXT, run)
};

choices! {
    /// Whether borders are welded, and only edge to edge.
    WELDS: Option<bool> =
        Some(false) => "Sew", "They are sewn, and edges are split where vertices of another border lie on them.";
        None => "Keep", "They stay apart.";
        Some(true) => "Edge to edge", "They are sewn where they match vertex by vertex.";
}

choices! {
    /// Whether only whole loops are joined.
    EXTENTS: bool =
        false => "Loops and parts of them", "Whole loops, and runs of vertices that face each other.";
        true => "Whole loops", "No parts.";
}

choices! {
    ROWS: Rows =
        Rows::None => "None", "Every meridian is one edge.";
        Rows::MeanEdge => "By mean edge", "New edges are about as long as the mean edge of the pieces.";
}

choices! {
    OVERLAPS: Overlaps<'static> =
        Overlaps::Keep => "Keep", "They stay as they are.";
        Overlaps::Trim(TRIM) => "Trim", "Of each overlap one piece is kept, and the narrow gap is closed as others are.";
}

const TRIM: trim::Options<'static> =
    trim::Options { max_distance: None, max_angle: 0.0, viewpoints: &[], min_faces: 0 };

const HOLES: &[Choice] = &[
    Choice::new("Leave", "They stay open."),
    Choice::new("Fill", "Triangles between the vertices of the rim."),
    Choice::new("Fill, refined and fair", "New vertices, placed so that the patch continues the surface smoothly."),
];

fn run(inputs: &[Input<'_>], values: &Values<'_>, job: &Job<'_>) -> Result<Vec<Output>> {
    let pieces = alloc::try_collect(inputs.iter().map(|input| input.mesh().copied()))?;
    let max_gap = values.number("max_gap");
    let edge_to_edge = values.choice("weld", WELDS);
    let weld = weld::Options { tolerance: tolerance(values), ..weld::Options::default() };
    let options = Options {
        overlaps: values.choice("overlaps", OVERLAPS),
        weld: edge_to_edge.map(|_| weld),
        edge_to_edge: edge_to_edge == Some(true),
        max_gap: if max_gap < 0.0 { MaxGap::Auto } else { MaxGap::Given(max_gap) },
        outward: if values.is_set("outward") { Outward::Closed } else { Outward::Keep },
        whole_loops_only: values.choice("extent", EXTENTS),
        strip: stitch::Options {
            meridians: values.choice("meridians", Meridians::CHOICES),
            rows: values.choice("rows", ROWS),
            fairing: values.choice("fairing", Fairing::CHOICES),
            finish: values.choice("finish", Finish::CHOICES),
            ..stitch::Options::default()
        },
        fill: match values.place("holes") {
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
    let aligned = match values.is_set("align") {
        true => Some(align(&pieces, &align::Options::default(), &job.part(0.0, 0.2))?),
        false => None,
    };
    let moved = aligned.as_ref().map(|found| found.moved(&pieces, &job.part(0.2, 0.2))).transpose()?;
    let placed = match &moved {
        Some(moved) => align::views_of(moved, &pieces, &job.part(0.2, 0.2))?,
        None => alloc::copied(&pieces)?,
    };
    let job = &if moved.is_some() { job.part(0.2, 1.0) } else { job.part(0.0, 1.0) };
    let mut done = assemble(&placed, &options, job)?;
    done.keep_splits(&alloc::gather(pieces.iter())?, &job.part(1.0, 1.0))?;
    let report = report(&done, aligned.as_ref());
    let origins = values.origins(|| Origins::from_assembly(&done, &job.part(1.0, 1.0)))?;
    Ok(vec![Output::Mesh(done.mesh, origins), Output::Text(report)])
}

fn report(done: &Assembly, aligned: Option<&Alignment>) -> Report {
    let mut text = String::new();
    let mut trusted = 0;
    for (k, piece) in aligned.iter().flat_map(|found| &found.pieces).enumerate() {
        trusted += u32::from(piece.reason == align::Reason::Trusted);
        if piece.reason != align::Reason::Trusted {
            push_line!(text, "piece {k} may lie wrong: {}", why_not(piece.reason));
        }
    }
    if let Some(found) = aligned {
        push_line!(text, "{trusted} of {} trusted to lie right", counted(found.pieces.len(), PIECE));
    }
    if done.trimmed_faces > 0 {
        push_line!(text, "{} trimmed from overlaps", counted(done.trimmed_faces, FACE));
    }
    push_line!(text, "{} sewn", counted(done.sewn_edges, EDGE));
    for joint in &done.joints {
        let [n, m] = joint.sides.each_ref().map(Vec::len);
        let parts = if joint.whole { "loops" } else { "runs" };
        let outcome = match joint.outcome {
            Outcome::Joined => format!("joined by {}", counted(joint.faces.len(), FACE)),
            Outcome::OrientationConflict => "left: joining them would make a one-sided surface".to_owned(),
            Outcome::ShareVertex => "left: they pass the same vertex".to_owned(),
            Outcome::NoStrip => "left: no strip avoids the edges that the mesh has".to_owned(),
            Outcome::WouldCut => "left to the holes: a strip would cut others".to_owned(),
        };
        text += &format!("{parts} of {n} and {m} vertices, {} apart: {outcome}\n", short(joint.gap));
    }
    let filled = done.holes.iter().filter(|hole| hole.status == fill::HoleStatus::Filled).count();
    push_line!(text, "{} filled, {} left", counted(filled, ["hole", "holes"]), counted(done.loops_left, BOUNDARY_LOOP));
    for left in &done.left {
        let why = match left.reason {
            Reason::Alone => "there is no other".to_owned(),
            Reason::TooFar => {
                format!("it is {} from the nearest, and {} is allowed", short(left.gap), short(left.allowed_gap))
            }
            Reason::SameComponent => "all others are of its own component".to_owned(),
            Reason::LooksAway => "it and the nearest do not look at each other".to_owned(),
            Reason::Taken => "the nearest is joined with another".to_owned(),
            Reason::Excluded => "it is not to be joined with the nearest".to_owned(),
            Reason::NotSimple => "it is open, or the faces along it disagree".to_owned(),
            Reason::TooShort => "it has fewer than three vertices".to_owned(),
            Reason::NotJoined => "no strip could be made".to_owned(),
        };
        text += &format!("loop of {} vertices left: {why}\n", left.vertices.len());
    }
    let turned = done.turned.iter().filter(|&&turned| turned).count();
    if turned > 0 {
        push_line!(text, "{} of the pieces turned over", counted(turned, FACE));
    }
    if !done.zero_volume.is_empty() {
        push_line!(text, "closed without any volume, as one piece given twice: {}", done.zero_volume.len());
    }
    let joined = done.joints.iter().filter(|joint| matches!(joint.outcome, Outcome::Joined)).count();
    let mut values = vec![
        ("sewn_edges", f64::from(done.sewn_edges)),
        ("joins", joined as f64),
        ("refused_joins", (done.joints.len() - joined) as f64),
        ("filled_holes", filled as f64),
        ("boundary_loops", f64::from(done.loops_left)),
        ("near_loops_left", f64::from(done.near_loops_left)),
        ("turned_faces", turned as f64),
        ("zero_volume_components", done.zero_volume.len() as f64),
        ("trimmed_faces", f64::from(done.trimmed_faces)),
        ("blends", done.joints.iter().filter(|joint| joint.finish == Finish::Blend).count() as f64),
    ];
    if aligned.is_some() {
        values.push(("trusted_pieces", f64::from(trusted)));
    }
    Report::new(text, &values)
}
