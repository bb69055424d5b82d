use super::data::{Input, Output};
use super::facing_arcs_of_loops::{FACING_ARC, FACING_TOLERANCE};
use super::fill::{OUTWARD, intersections_line, turned_outwards_line};
use super::filter::{Filter, FilterBody};
use super::report::{BOUNDARY_LOOP, FACE, Report, ReportValue, count_with_noun, format_short};
use super::signatures::{ONE_MESH, TO_MESH_TEXT};
use super::typed_param::{MAX_COUNT, Param, ParamValues, TypedParam, params};
use gusset_attributes::{KeepSplitVertices, Origins};
use gusset_base::error::{Allowed, Error, Result};
use gusset_base::job::Job;
use gusset_base::{alloc, choices};
use gusset_mesh::MeshView;
use gusset_stitch::boundary::{self, boundary_loops};
use gusset_stitch::repair::orient::Outward;
use gusset_stitch::stitch::facing::Run;
use gusset_stitch::stitch::{
    Cells, Extent, Fairing, Finish, Intersections, Meridians, Options, Orientation, Quality, Request, Rows, Stitch,
    stitch,
};

params! {
    loop_a: Option<u32> = loop_number_param("Loop of the first mesh");
    loop_b: Option<u32> = loop_number_param("Loop of the second mesh");
    meridians: Meridians = MERIDIANS;
    orientation: Orientation = Param::choice(
        "Opposite orientation",
        "The treatment of a second piece of opposite orientation.",
        Orientation::CHOICES,
    );
    twist: i64 = Param::signed_int(
        "Twist",
        "The number of vertices by which the start on the second loop is shifted from the closest pair.",
        [-MAX_COUNT, MAX_COUNT], &[0.0],
    );
    extent: Extent = Param::choice("Join", "The parts of the loops that are joined.", EXTENTS);
    run: Run = FACING_ARC;
    tolerance: Option<f64> = FACING_TOLERANCE;
    rows: MakeRows = ROWS;
    row_count: u32 = ROW_COUNT;
    cells: Cells = CELLS;
    fairing: Fairing = FAIRING;
    finish: Finish = FINISH;
    intersections: Intersections =
        Param::choice("Intersections", "The search for faces that intersect each other.", Intersections::CHOICES);
    outward: bool = OUTWARD;
}

pub(super) const FILTER: Filter = Filter {
    id: "stitch",
    name: "Stitch two loops",
    category: "Stitching",
    help: "Joins two boundary loops, of two meshes or of one, by a closed band of new faces. On request a strip joins only the \
           arcs that face each other. All vertices keep their positions, and all faces stay.",
    reference: "S. Nesterenko, The algorithm for polygonal networks of cross-linking",
    max_inputs: 2,
    has_origins: true,
    ..Filter::new(ONE_MESH, TO_MESH_TEXT, &FilterBody(run))
};

/// Chooses the rule that places the meridians of a strip.
pub(super) const MERIDIANS: TypedParam<Meridians> = Param::choice(
    "Meridians",
    "The rule that joins vertices of one loop to vertices of the other.",
    Meridians::CHOICES,
);

/// Chooses the shape of the rows of a strip.
pub(super) const FAIRING: TypedParam<Fairing> =
    Param::choice("Shape of the rows", "The positions of the new vertices.", Fairing::CHOICES);

/// Chooses the surface between two loops: a strip or a blend.
pub(super) const FINISH: TypedParam<Finish> = Param::choice(
    "Finish",
    "The surface between the rims. A blend ignores the rows, their shape and the kind of face.",
    Finish::CHOICES,
);

choices! {
    EXTENTS: Extent =
        Extent::WholeLoops => "Whole loops", "Both loops as a whole, by a closed band.";
        Extent::OpenArcs => "Facing arcs", "The vertices that face the other loop, as in the paper.";
        Extent::Auto => "Automatic", "Whole loops if they face each other squarely, otherwise facing arcs.";
}

/// The rows of a strip for a given number of rows.
pub(super) type MakeRows = fn(u32) -> Rows;

choices! {
    ROW_RULES: MakeRows =
        |_| Rows::None => "None", "Every meridian is one edge.";
        |_| Rows::MeanEdge => "By mean edge", "New edges are about as long as the mean edge of both sides.";
        Rows::Count => "Given number", "The number of rows below.";
}

/// Chooses the rule for the number of rows of a strip.
pub(super) const ROWS: TypedParam<MakeRows> =
    Param::choice("Rows", "The rows of new vertices between the rims.", ROW_RULES);

/// Sets the number of rows of a strip, if the rule of rows asks for it.
pub(super) const ROW_COUNT: TypedParam<u32> =
    Param::int("Number of rows", "The number of rows of new vertices, if it is given.", [0.0, 10_000.0], &[1.0]);

/// Chooses the faces of a strip: triangles or quads.
pub(super) const CELLS: TypedParam<Cells> = Param::choice("Faces", "The faces of the strip.", Cells::CHOICES);

/// The number of a boundary loop; `None` takes the nearest pair of loops.
const fn loop_number_param(label: &'static str) -> TypedParam<Option<u32>> {
    const HELP: &str =
        "The number of the loop in the output of the filter boundary_loops. -1 takes the nearest pair of loops.";
    Param::int(label, HELP, [-1.0, MAX_COUNT], &[-1.0]).none_if_negative()
}

fn run(inputs: &[Input<'_>], values: &ParamValues<Params>, job: &Job<'_>) -> Result<Vec<Output>> {
    let a = inputs[0].mesh()?;
    let b = inputs.get(1).map(Input::mesh).transpose()?;
    let loop_a = boundary_loop_by_number(a, ("loop_a", values.loop_a), &job.sub_job(0.0, 0.1))?;
    let loop_b = boundary_loop_by_number(b.unwrap_or(a), ("loop_b", values.loop_b), &job.sub_job(0.1, 0.2))?;
    let request = Request { a, loop_a: loop_a.as_deref(), b, loop_b: loop_b.as_deref() };
    let options = Options {
        meridians: values.meridians,
        orientation: values.orientation,
        twist: values.twist,
        extent: values.extent,
        run: values.run,
        tolerance: values.tolerance,
        rows: (values.rows)(values.row_count),
        cells: values.cells,
        fairing: values.fairing,
        finish: values.finish,
        intersections: values.intersections,
        outward: if values.outward { Outward::Closed } else { Outward::Keep },
        ..Options::default()
    };
    let mut done = stitch(&request, &options, &job.sub_job(0.2, 1.0))?;
    done.keep_split_vertices(
        &alloc::gather([Some(request.a), request.b].into_iter().flatten())?,
        &job.sub_job(1.0, 1.0),
    )?;
    let report = report(&done);
    let origins = values.trace_origins(|| Origins::from_stitch(&done, &job.sub_job(1.0, 1.0)))?;
    Ok(vec![Output::Mesh(done.mesh, origins), Output::Text(report)])
}

/// The vertices of a loop by its number, if an option gives one.
fn boundary_loop_by_number(
    mesh: &MeshView<'_>,
    (option, number): (&'static str, Option<u32>),
    job: &Job<'_>,
) -> Result<Option<Vec<u32>>> {
    let Some(number) = number else { return Ok(None) };
    let boundary = boundary_loops(mesh, &boundary::Options::default(), job)?;
    let missing =
        Error::OptionOutOfRange { option, value: number.into(), allowed: Allowed::IndexBelow(boundary.len() as u64) };
    let found = boundary.get(number as usize).ok_or(missing)?;
    Ok(Some(alloc::copied(found.vertices)?))
}

fn report(done: &Stitch) -> Report {
    let Quality { min_angle, max_aspect, max_edge, area, loops_left, .. } = done.quality;
    let turned = if done.turned { "the second piece was reversed\n" } else { "" };
    let outwards = turned_outwards_line(&done.turned_outwards);
    let parts = if done.closed { "loops" } else { "arcs" };
    let left = match loops_left {
        0 => "the result is closed".to_owned(),
        n => format!("{} left", count_with_noun(n, BOUNDARY_LOOP)),
    };
    let cuts = intersections_line(done.intersections.as_deref());
    let [a, b] = done.rims.each_ref().map(Vec::len);
    let text = format!(
        "joined {parts} of {a} and {b} vertices by {}, {}\n{turned}\
         area {}, longest edge {}, smallest angle {:.2} degrees, largest aspect ratio {max_aspect:.2}\n\
         {cuts}{outwards}{left}\n",
        count_with_noun(done.strip_faces.len(), FACE),
        count_with_noun(done.rows, ["interior row", "interior rows"]),
        format_short(area),
        format_short(max_edge),
        min_angle.to_degrees()
    );
    let mut values = vec![
        ("rim_vertices_a", ReportValue::count(a)),
        ("rim_vertices_b", ReportValue::count(b)),
        ("strip_faces", ReportValue::count(done.strip_faces.len())),
        ("rows", ReportValue::count(done.rows)),
        ("turned", ReportValue::flag(done.turned)),
        ("area", ReportValue::area(area)),
        ("longest_edge", ReportValue::length(max_edge)),
        ("smallest_angle", ReportValue::angle(min_angle)),
        ("largest_aspect_ratio", ReportValue::number(max_aspect)),
        ("turned_outwards", ReportValue::count(done.turned_outwards.len())),
        ("boundary_loops", ReportValue::count(loops_left)),
        ("blended", ReportValue::flag(done.finish == Finish::Blend)),
    ];
    if let Some(pairs) = &done.intersections {
        values.push(("intersections", ReportValue::count(pairs.len())));
    }
    Report::new(text, &values)
}
