use super::align::explain_untrusted_pose;
use super::data::{Input, Output};
use super::fill::{KEEP_OPEN, MAX_AREA, MAX_DIAMETER, MAX_EDGES, MAX_LENGTH, OUTWARD, push_open_loops};
use super::filter::{Filter, FilterBody};
use super::report::{BOUNDARY_LOOP, EDGE, FACE, PIECE, Report, ReportValue, count_with_noun, format_short, push_line};
use super::signatures::{ONE_MESH, TO_MESH_TEXT};
use super::stitch::{FAIRING, FINISH, MERIDIANS};
use super::typed_param::{NON_NEGATIVE_OR_AUTO_RANGE, Param, ParamValues, params};
use super::weld::{TOLERANCE, push_hint};
use gusset_attributes::{KeepSplitVertices, Origins};
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_base::{alloc, choices};
use gusset_mesh::NONE;
use gusset_stitch::align::{self, Alignment, align};
use gusset_stitch::assemble::{Assembly, Extent, MaxGap, Options, Outcome, Overlaps, Reason, assemble};
use gusset_stitch::fill;
use gusset_stitch::repair::orient::Outward;
use gusset_stitch::repair::weld;
use gusset_stitch::stitch::{self, Fairing, Finish, Meridians, Rows};
use gusset_stitch::trim;

pub(super) const FILTER: Filter = Filter {
    id: "join",
    name: "Join pieces",
    category: "Stitching",
    help: "Joins many open pieces into one mesh. Overlaps are trimmed on request. Coincident borders are sewn, orientations are \
           made consistent, and loops that face each other across a gap are stitched. Holes are filled on request, and closed \
           results are turned outwards. Loops that face no other loop stay as they are.",
    reference: "S. Nesterenko, The algorithm for polygonal networks of cross-linking, for a single gap",
    max_inputs: 1 << 16,
    has_origins: true,
    ..Filter::new(ONE_MESH, TO_MESH_TEXT, &FilterBody(run))
};

params! {
    weld: Option<bool> = Param::choice("Coincident borders", "The treatment of coincident borders.", WELDS);
    tolerance: Option<f64> = TOLERANCE.with_label("Welding distance");
    max_gap: Option<f64> = Param::real(
        "Widest gap",
        "The largest mean width of a gap that is closed. 0 closes none; -1 decides by the size of the loops.",
        NON_NEGATIVE_OR_AUTO_RANGE, &[-1.0],
    ).none_if_negative();
    extent: Extent = Param::choice("Join", "The parts of the loops that are joined.", EXTENTS);
    meridians: Meridians = MERIDIANS;
    rows: Rows = Param::choice("Rows", "The rows of new vertices between the rims.", ROWS);
    fairing: Fairing = FAIRING;
    finish: Finish = FINISH;
    holes: Option<(fill::Refinement, fill::Fairing)> =
        Param::choice("Remaining holes", "The treatment of holes that remain.", HOLES);
    outward: bool = OUTWARD.on_by_default();
    overlaps: Overlaps<'static> = Param::choice("Overlaps", "The treatment of pieces that overlap.", OVERLAPS);
    align: bool = Param::flag(
        "Align first",
        "First moves overlapping pieces to where they fit, as the filter align does from where they lie.",
    );
    keep: fill::Keep = KEEP_OPEN.with_help(
        "The remaining loops that are not holes, if holes are filled. If overlaps are trimmed, Automatic acts as Borders.",
    );
    max_edges: Option<u32> = MAX_EDGES;
    max_length: Option<f64> = MAX_LENGTH;
    max_diameter: Option<f64> = MAX_DIAMETER;
    max_area: Option<f64> = MAX_AREA;
}

choices! {
    /// `None` keeps borders apart; true welds them edge to edge only.
    WELDS: Option<bool> =
        Some(false) => "Sew", "They are sewn. Edges are split where vertices of another border lie on them.";
        None => "Keep", "They stay apart.";
        Some(true) => "Edge to edge", "They are sewn where they match vertex by vertex.";
}

choices! {
    EXTENTS: Extent =
        Extent::LoopsAndParts => "Loops and parts of them", "Whole loops, and arcs of vertices that face each other.";
        Extent::WholeLoops => "Whole loops", "Only whole loops.";
        Extent::Parts => "Parts", "Only arcs of vertices that face each other, and slits along seams.";
}

choices! {
    ROWS: Rows =
        Rows::None => "None", "Every meridian is one edge.";
        Rows::MeanEdge => "By mean edge", "New edges are about as long as the mean edge of the pieces.";
}

choices! {
    OVERLAPS: Overlaps<'static> =
        Overlaps::Keep => "Keep", "They stay as they are.";
        Overlaps::Trim(DEFAULT_TRIM_OPTIONS) => "Trim",
            "One piece of each overlap is kept. The narrow gap that remains is closed like any other gap.";
}

const DEFAULT_TRIM_OPTIONS: trim::Options<'static> =
    trim::Options { max_distance: None, max_angle: 0.0, viewpoints: &[], min_faces: 0 };

choices! {
    HOLES: Option<(fill::Refinement, fill::Fairing)> =
        None => "Leave", "They stay open.";
        Some((fill::Refinement::None, fill::Fairing::None)) => "Fill", "They get triangles between the vertices of the rim.";
        Some((fill::Refinement::RimDensity(0), fill::Fairing::ThinPlate)) => "Fill, refined and fair",
            "They get new vertices, so that the patch continues the surface smoothly.";
}

fn run(inputs: &[Input<'_>], values: &ParamValues<Params>, job: &Job<'_>) -> Result<Vec<Output>> {
    let pieces = alloc::try_collect(inputs.iter().map(|input| input.mesh().copied()))?;
    let weld = weld::Options { tolerance: values.tolerance, ..weld::Options::default() };
    let options = Options {
        overlaps: values.overlaps,
        weld: values.weld.map(|_| weld),
        edge_to_edge: values.weld == Some(true),
        max_gap: values.max_gap.map_or(MaxGap::Auto, MaxGap::Given),
        outward: if values.outward { Outward::Closed } else { Outward::Keep },
        extent: values.extent,
        strip: stitch::Options {
            meridians: values.meridians,
            rows: values.rows,
            fairing: values.fairing,
            finish: values.finish,
            ..stitch::Options::default()
        },
        fill: values.holes.map(|(refinement, fairing)| fill::Options {
            refinement,
            fairing,
            keep: values.keep,
            limits: fill::Limits {
                edges: values.max_edges,
                length: values.max_length,
                diameter: values.max_diameter,
                area: values.max_area,
            },
            ..fill::Options::default()
        }),
        ..Options::default()
    };
    let aligned = match values.align {
        true => Some(align(&pieces, &align::Options::default(), &job.sub_job(0.0, 0.2))?),
        false => None,
    };
    let moved = aligned.as_ref().map(|found| found.move_pieces(&pieces, &job.sub_job(0.2, 0.2))).transpose()?;
    let placed = match &moved {
        Some(moved) => align::views_of_moved_pieces(moved, &pieces, &job.sub_job(0.2, 0.2))?,
        None => alloc::copied(&pieces)?,
    };
    let job = &if moved.is_some() { job.sub_job(0.2, 1.0) } else { job.sub_job(0.0, 1.0) };
    let mut done = assemble(&placed, &options, job)?;
    done.keep_split_vertices(&alloc::gather(pieces.iter())?, &job.sub_job(1.0, 1.0))?;
    let report = report(&done, aligned.as_ref(), values.holes.is_some());
    let origins = values.trace_origins(|| Origins::from_assembly(&done, &job.sub_job(1.0, 1.0)))?;
    Ok(vec![Output::Mesh(done.mesh, origins), Output::Text(report)])
}

fn report(done: &Assembly, aligned: Option<&Alignment>, fills: bool) -> Report {
    let mut text = String::new();
    let mut trusted = 0;
    for (k, piece) in aligned.iter().flat_map(|found| &found.pieces).enumerate() {
        trusted += u32::from(piece.reason == align::Reason::Trusted);
        if piece.reason != align::Reason::Trusted {
            push_line!(text, "piece {k} may be misplaced: {}", explain_untrusted_pose(piece.reason));
        }
    }
    if let Some(found) = aligned {
        push_line!(text, "{trusted} of {} trusted", count_with_noun(found.pieces.len(), PIECE));
    }
    if done.trimmed_faces > 0 {
        push_line!(text, "{} trimmed from overlaps", count_with_noun(done.trimmed_faces, FACE));
    }
    push_lost_faces(&done.lost_faces, &mut text);
    push_line!(text, "{} sewn", count_with_noun(done.sewn_edges, EDGE));
    push_hint(&done.near, &mut text);
    for joint in &done.joints {
        let [n, m] = joint.sides.each_ref().map(Vec::len);
        let parts = if joint.whole { "loops" } else { "arcs" };
        let outcome = match joint.outcome {
            Outcome::Joined => format!("joined by {}", count_with_noun(joint.faces.len(), FACE)),
            Outcome::OrientationConflict => "not joined: the surface would become one-sided".to_owned(),
            Outcome::ShareVertex => "not joined: they share a vertex".to_owned(),
            Outcome::NoStrip => "not joined: every strip would use an edge of the mesh again".to_owned(),
            Outcome::WouldCut => "left as holes: a strip would intersect others".to_owned(),
        };
        text += &format!("{parts} of {n} and {m} vertices, {} apart: {outcome}\n", format_short(joint.gap));
        if let Some(pairs) = joint.intersections.as_deref().filter(|pairs| !pairs.is_empty()) {
            push_line!(text, "the strip cuts {}", describe_cuts(pairs.len(), joint.cut_length));
            if joint.blend_avoids_cuts {
                push_line!(text, "a blend cuts nothing there: set the parameter finish to Blend");
            }
        }
    }
    for (hole, &length) in done.holes.iter().zip(&done.hole_cut_lengths) {
        let is_cut = |pair: &&[u32; 2]| hole.faces.contains(&pair[0]);
        let pairs = done.hole_intersections.iter().flatten().filter(is_cut).count();
        if pairs > 0 {
            push_line!(text, "the patch of a hole of {} edges cuts {}", hole.rim.len(), describe_cuts(pairs, length));
        }
    }
    let filled = done.holes.iter().filter(|hole| hole.status == fill::HoleStatus::Filled).count();
    push_line!(
        text,
        "{} filled, {} left",
        count_with_noun(filled, ["hole", "holes"]),
        count_with_noun(done.loops_left, BOUNDARY_LOOP)
    );
    if done.loops_left > 0 && !fills {
        push_line!(text, "holes stay open unless the parameter holes is set");
    }
    for left in done.left.iter().filter(|left| !left.filled) {
        let why = match left.reason {
            Reason::Alone => "there is no other loop".to_owned(),
            Reason::TooFar => {
                format!(
                    "the nearest loop is {} away, and {} is allowed: raise the parameter max_gap to join it",
                    format_short(left.gap),
                    format_short(left.allowed_gap)
                )
            }
            Reason::SameComponent => "all other loops belong to the same component".to_owned(),
            Reason::LooksAway => "it does not face the nearest loop".to_owned(),
            Reason::Taken => "the nearest loop is joined to another".to_owned(),
            Reason::Excluded => "joining it to the nearest loop is excluded".to_owned(),
            Reason::NotSimple => "it is open, or the faces along it disagree in orientation".to_owned(),
            Reason::TooShort => "it has fewer than three vertices".to_owned(),
            Reason::NotJoined => "no strip was possible".to_owned(),
        };
        let place = match left.origin {
            [NONE, _] => String::new(),
            [piece, vertex] => format!(" at vertex {vertex} of piece {piece}"),
        };
        push_line!(text, "loop of {} vertices{place} not joined: {why}", left.vertices.len());
    }
    let mut reasons = Vec::new();
    push_open_loops(&done.holes, &mut text, &mut reasons);
    let turned = done.turned.iter().filter(|&&turned| turned).count();
    if turned > 0 {
        push_line!(text, "{} of the pieces reversed", count_with_noun(turned, FACE));
    }
    if !done.zero_volume.is_empty() {
        push_line!(text, "components without volume, such as one piece given twice: {}", done.zero_volume.len());
    }
    let strip_pairs: usize = done.joints.iter().filter_map(|joint| joint.intersections.as_ref()).map(Vec::len).sum();
    let cut_length = done.joints.iter().map(|joint| joint.cut_length).chain(done.hole_cut_lengths.iter().copied());
    let joined = done.joints.iter().filter(|joint| matches!(joint.outcome, Outcome::Joined)).count();
    let mut values = vec![
        ("sewn_edges", ReportValue::count(done.sewn_edges)),
        ("near_edge_pairs", ReportValue::count(done.near.edge_pairs)),
        ("near_tolerance", ReportValue::length(done.near.tolerance)),
        ("joins", ReportValue::count(joined)),
        ("refused_joins", ReportValue::count(done.joints.len() - joined)),
        ("filled_holes", ReportValue::count(filled)),
        ("boundary_loops", ReportValue::count(done.loops_left)),
        ("near_loops_left", ReportValue::count(done.near_loops_left)),
        ("turned_faces", ReportValue::count(turned)),
        ("zero_volume_components", ReportValue::count(done.zero_volume.len())),
        ("trimmed_faces", ReportValue::count(done.trimmed_faces)),
        ("lost_faces", ReportValue::count(done.lost_faces.len())),
        ("strip_intersections", ReportValue::count(strip_pairs)),
        ("patch_intersections", ReportValue::count(done.hole_intersections.iter().flatten().count())),
        ("cut_length", ReportValue::length(cut_length.sum())),
        ("offered_blends", ReportValue::count(done.joints.iter().filter(|joint| joint.blend_avoids_cuts).count())),
        ("blends", ReportValue::count(done.joints.iter().filter(|joint| joint.finish == Finish::Blend).count())),
    ];
    values.extend(reasons);
    if aligned.is_some() {
        values.push(("trusted_pieces", ReportValue::count(trusted)));
    }
    Report::new(text, &values)
}

/// The largest number of runs of lost faces that a report lists.
const MAX_LISTED_RUNS: usize = 8;

/// Pushes the lines on trimmed faces that no kept face covers, by piece and face.
fn push_lost_faces(lost: &[[u32; 2]], text: &mut String) {
    for of_piece in lost.chunk_by(|a, b| a[0] == b[0]) {
        let runs = || of_piece.chunk_by(|a, b| a[1] + 1 == b[1]);
        let describe = |run: &[[u32; 2]]| match run {
            [[_, only]] => only.to_string(),
            [[_, first], .., [_, last]] => format!("{first} to {last}"),
            [] => String::new(),
        };
        let listed: Vec<String> = runs().take(MAX_LISTED_RUNS).map(describe).collect();
        let more = if runs().count() > MAX_LISTED_RUNS { ", ..." } else { "" };
        push_line!(
            text,
            "{} of piece {} lost by trimming, which nothing covers: {}{more}",
            count_with_noun(of_piece.len(), FACE),
            of_piece[0][0],
            listed.join(", ")
        );
    }
}

/// Describes cuts by the number of pairs of faces and by their length.
fn describe_cuts(pairs: usize, length: f64) -> String {
    let faces = count_with_noun(pairs, ["pair of faces", "pairs of faces"]);
    format!("other faces: {faces}, {} long in all", format_short(length))
}
