//! The filter `stitch`.

use super::Filter;
use super::data::{Input, InputKind, Output, OutputKind};
use super::param::{Choice, Param, ParamKind, Values};
use crate::alloc;
use crate::boundary::{self, boundary_loops};
use crate::error::{Error, Result};
use crate::job::Job;
use crate::mesh::MeshView;
use crate::stitch::facing::Run;
use crate::stitch::{
    Cells, Extent, Fairing, Intersections, Meridians, Options, Orientation, Quality, Request, Rows, Stitch, stitch,
};

/// A twist beyond this is a mistake; no loop is longer.
const MOST: f64 = u32::MAX as f64;

pub(super) const FILTER: Filter = Filter {
    id: "stitch",
    name: "Stitch two loops",
    script_name: "stitch",
    category: "Stitching",
    help: "Joins two boundary loops, of two meshes or of one, by a closed band of new faces, or the arcs of them that face \
           each other by a strip. Vertices stay where they are and no face is lost.",
    reference: "S. Nesterenko, The algorithm for polygonal networks of cross-linking",
    inputs: &[InputKind::Mesh],
    min_inputs: 1,
    max_inputs: 2,
    outputs: &[OutputKind::Mesh, OutputKind::Text],
    replaces: false,
    params: &[
        loop_number("loop_a", "Loop of the first mesh"),
        loop_number("loop_b", "Loop of the second mesh"),
        Param::choice(
            "meridians",
            "Meridians",
            "How vertices of one loop are joined to vertices of the other.",
            MERIDIANS,
        ),
        Param::choice(
            "orientation",
            "Second piece inside out",
            "What happens if the second piece is oriented against the first.",
            &[
                Choice { label: "Turn it over", help: "The order of its faces' vertices is reversed." },
                Choice { label: "Refuse", help: "The filter fails." },
                Choice { label: "Do not compare", help: "The faces are taken as they are." },
            ],
        ),
        Param {
            id: "twist",
            label: "Twist",
            help: "The band starts at the closest pair of vertices; a twist shifts the start on the second loop by so many \
                   vertices.",
            kind: ParamKind::Int,
            min: -MOST,
            max: MOST,
            default: &[0.0],
            step: 1.0,
            choices: &[],
        },
        Param::choice(
            "extent",
            "Join",
            "How much of the loops is joined.",
            &[
                Choice { label: "Whole loops", help: "All of both, by a closed band." },
                Choice { label: "Facing arcs", help: "The vertices that face the other loop, as the paper has it." },
                Choice { label: "Automatic", help: "Whole loops if they face each other squarely, else facing arcs." },
            ],
        ),
        Param::choice(
            "run",
            "Facing arc",
            "Which arc is taken where several face the other loop.",
            &[
                Choice { label: "Closest", help: "The one with the closest pair of vertices." },
                Choice { label: "Longest", help: "The one of the most vertices." },
            ],
        ),
        Param {
            id: "tolerance",
            label: "Facing tolerance",
            help: "How far a vertex must be from the plane through its loop's centre to face the other loop; -1 takes what \
                   round-off can do.",
            kind: ParamKind::Real,
            min: -1.0,
            max: 1e15,
            default: &[-1.0],
            step: 0.0,
            choices: &[],
        },
        Param::choice(
            "rows",
            "Rows",
            "How many rows of new vertices lie between the rims.",
            &[
                Choice { label: "None", help: "Every meridian is one edge." },
                Choice { label: "By mean edge", help: "New edges are about as long as the mean edge of both pieces." },
                Choice { label: "Given number", help: "The number of rows below." },
            ],
        ),
        Param {
            id: "row_count",
            label: "Number of rows",
            help: "The number of rows of new vertices, if it is to be given.",
            kind: ParamKind::Int,
            min: 0.0,
            max: 10_000.0,
            default: &[1.0],
            step: 1.0,
            choices: &[],
        },
        Param::choice(
            "cells",
            "Faces",
            "What the strip is made of.",
            &[
                Choice { label: "Triangles", help: "Quads are split by their shorter diagonals." },
                Choice { label: "Quads", help: "Quads where four different neighbours meet, triangles elsewhere." },
            ],
        ),
        Param::choice("fairing", "Shape of the rows", "Where the new vertices lie.", FAIRING),
        Param::choice(
            "intersections",
            "Intersections",
            "Whether faces that cut each other are looked for.",
            INTERSECTIONS,
        ),
    ],
    suggest: None,
    run,
};

/// In the order of [`meridians`].
pub(super) const MERIDIANS: &[Choice] = &[
    Choice { label: "Least area", help: "The strip of triangles of least area, for rims of any shape." },
    Choice { label: "By index", help: "The rule of the paper: fastest, for evenly spaced rims." },
    Choice { label: "By arc length", help: "Both rims walked at the same pace: fast, for rims of similar shape." },
    Choice { label: "Greedy", help: "Always on to the shorter of the two next meridians: fast." },
    Choice { label: "Shortest meridians", help: "The strip of triangles with the shortest edges across." },
    Choice { label: "Least bends", help: "The strip of triangles that bends least, along the rims too." },
    Choice { label: "Quads", help: "Quads wherever both rims advance alike; for strips with rows." },
];

/// The meridians of a choice.
pub(super) fn meridians(choice: usize) -> Meridians {
    [
        Meridians::MinArea,
        Meridians::Index,
        Meridians::ArcLength,
        Meridians::Greedy,
        Meridians::MinDiagonal,
        Meridians::Smooth,
        Meridians::Quad,
    ][choice]
}

pub(super) const FAIRING: &[Choice] = &[
    Choice { label: "Straight", help: "They divide straight lines from rim to rim evenly." },
    Choice { label: "Fair", help: "The strip bends as a thin plate does and meets both pieces smoothly." },
];

const INTERSECTIONS: &[Choice] = &[
    Choice { label: "Automatic", help: "Where rows are faired, and there they are avoided." },
    Choice { label: "Ignore", help: "They are not looked for." },
    Choice { label: "Report", help: "They are always looked for." },
];

const fn loop_number(id: &'static str, label: &'static str) -> Param {
    Param {
        id,
        label,
        help: "The loop's number as the filter boundary_loops gives it; -1 takes the loops that lie nearest to each other.",
        kind: ParamKind::Int,
        min: -1.0,
        max: MOST,
        default: &[-1.0],
        step: 1.0,
        choices: &[],
    }
}

fn run(inputs: &[Input<'_>], values: &Values<'_>, job: &Job<'_>) -> Result<Vec<Output>> {
    let a = inputs[0].mesh()?;
    let b = inputs.get(1).map(Input::mesh).transpose()?;
    let loop_a = numbered(a, values, "loop_a", &job.part(0.0, 0.1))?;
    let loop_b = numbered(b.unwrap_or(a), values, "loop_b", &job.part(0.1, 0.2))?;
    let request = Request { a, loop_a: loop_a.as_deref(), b, loop_b: loop_b.as_deref() };
    let options = Options {
        meridians: meridians(values.chosen("meridians")),
        orientation: [Orientation::Fix, Orientation::Refuse, Orientation::Keep][values.chosen("orientation")],
        twist: values.number("twist") as i64,
        extent: [Extent::WholeLoops, Extent::OpenArcs, Extent::Auto][values.chosen("extent")],
        run: [Run::Closest, Run::Longest][values.chosen("run")],
        tolerance: Some(values.number("tolerance")).filter(|&t| t >= 0.0),
        rows: match values.chosen("rows") {
            0 => Rows::None,
            1 => Rows::MeanEdge,
            _ => Rows::Count(values.number("row_count") as u32),
        },
        cells: [Cells::Triangles, Cells::Quads][values.chosen("cells")],
        fairing: [Fairing::None, Fairing::ThinPlate][values.chosen("fairing")],
        intersections: [Intersections::Auto, Intersections::Ignore, Intersections::Report]
            [values.chosen("intersections")],
        ..Options::default()
    };
    let done = stitch(&request, &options, &job.part(0.2, 1.0))?;
    let text = report(&done);
    Ok(vec![Output::Mesh(done.mesh), Output::Text(text)])
}

/// The vertices of the loop that parameter `id` numbers; `None` for -1.
fn numbered(mesh: &MeshView<'_>, values: &Values<'_>, id: &'static str, job: &Job<'_>) -> Result<Option<Vec<u32>>> {
    let number = values.number(id);
    if number < 0.0 {
        return Ok(None);
    }
    let boundary = boundary_loops(mesh, &boundary::Options::default(), job)?;
    let found = boundary.get(number as usize).ok_or(Error::OptionOutOfRange { option: id, value: number })?;
    Ok(Some(alloc::copied(found.vertices)?))
}

fn report(done: &Stitch) -> String {
    let Quality { min_angle, max_aspect, max_edge, area, loops_left, .. } = done.quality;
    let turned = if done.turned { "the second piece was turned over\n" } else { "" };
    let parts = if done.closed { "loops" } else { "arcs" };
    let left = match loops_left {
        0 => "the result is closed".to_owned(),
        n => format!("{n} boundary loops are left"),
    };
    let cuts = match &done.intersections {
        None => String::new(),
        Some(pairs) => format!("{} pairs of faces cut each other\n", pairs.len()),
    };
    format!(
        "joined {parts} of {} and {} vertices by {} faces, {} interior rows\n{turned}\
         area {area}, longest edge {max_edge}, smallest angle {:.2} degrees, largest aspect ratio {max_aspect:.2}\n{cuts}{left}\n",
        done.rims[0].len(),
        done.rims[1].len(),
        done.strip_faces.len(),
        done.rows,
        min_angle.to_degrees()
    )
}
