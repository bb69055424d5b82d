use super::data::{Input, Output};
use super::facing_arcs::RUN_HELP;
use super::fill_holes::{OUTWARD_HELP, cuts, turned_outwards};
use super::filter::Filter;
use super::param::{Param, Values};
use super::report::{BOUNDARY_LOOP, FACE};
use super::report::{Report, counted, short};
use super::signatures::{MESH, TO_MESH_TEXT};
use gusset_attributes::{KeepSplits, Origins};
use gusset_base::choice::Choice;
use gusset_base::error::{Error, Result};
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

/// A bound on numbers of loops and vertices.
const MAX_COUNT: f64 = u32::MAX as f64;

pub(super) const FILTER: Filter = Filter {
    id: "stitch",
    name: "Stitch two loops",
    category: "Stitching",
    help: "Joins two boundary loops, of two meshes or of one, by a closed band of new faces, or their facing arcs by a strip. \
           Vertices stay where they are and no face is lost.",
    reference: "S. Nesterenko, The algorithm for polygonal networks of cross-linking",
    max_inputs: 2,
    has_origins: true,
    params: &[
        loop_number("loop_a", "Loop of the first mesh"),
        loop_number("loop_b", "Loop of the second mesh"),
        Param::choice("meridians", "Meridians", Meridians::CHOICES.texts)
            .with_help("The rule that joins vertices of one loop to vertices of the other."),
        Param::choice("orientation", "Opposite orientation", Orientation::CHOICES.texts)
            .with_help("The treatment of a second piece of opposite orientation."),
        Param::int("twist", "Twist", [-MAX_COUNT, MAX_COUNT], &[0.0])
            .with_help("The number of vertices by which the start on the second loop is shifted from the closest pair."),
        Param::choice("extent", "Join", EXTENTS.texts).with_help("The parts of the loops that are joined."),
        Param::choice("run", "Facing arc", Run::CHOICES.texts).with_help(RUN_HELP),
        Param::real("tolerance", "Facing tolerance", [-1.0, 1e15], &[-1.0]).with_help(
            "The smallest distance from the plane through its loop's centre at which a vertex faces the other loop; -1 takes \
             the bound on rounding.",
        ),
        ROWS,
        ROW_COUNT,
        CELLS,
        Param::choice("fairing", "Shape of the rows", Fairing::CHOICES.texts).with_help(FAIRING_HELP),
        Param::choice("finish", "Finish", Finish::CHOICES.texts).with_help(FINISH_HELP),
        Param::choice("intersections", "Intersections", Intersections::CHOICES.texts)
            .with_help("The search for faces that intersect each other."),
        Param::flag("outward", "Turn outwards").with_help(OUTWARD_HELP),
    ],
    ..Filter::new(MESH, TO_MESH_TEXT, run)
};

pub(super) const FINISH_HELP: &str = "What lies between the rims in the end. A blend has no rows: the rows, their shape and the kind of face are not read.";
pub(super) const FAIRING_HELP: &str = "The positions of the new vertices.";

choices! {
    EXTENTS: Extent =
        Extent::WholeLoops => "Whole loops", "All of both, by a closed band.";
        Extent::OpenArcs => "Facing arcs", "The vertices that face the other loop, as in the paper.";
        Extent::Auto => "Automatic", "Whole loops if they face each other squarely, otherwise facing arcs.";
}

/// The rows and the faces of a strip, of polylines too.
pub(super) const ROWS: Param = Param::choice(
    "rows",
    "Rows",
    &[
        Choice::new("None", "Every meridian is one edge."),
        Choice::new("By mean edge", "New edges are about as long as the mean edge of both sides."),
        Choice::new("Given number", "The number of rows below."),
    ],
)
.with_help("The rows of new vertices between the rims.");
pub(super) const ROW_COUNT: Param = Param::int("row_count", "Number of rows", [0.0, 10_000.0], &[1.0])
    .with_help("The number of rows of new vertices, if given.");
pub(super) const CELLS: Param =
    Param::choice("cells", "Faces", Cells::CHOICES.texts).with_help("The faces of the strip.");

/// What [`ROWS`] and [`ROW_COUNT`] say.
pub(super) fn rows(values: &Values<'_>) -> Rows {
    match values.place("rows") {
        0 => Rows::None,
        1 => Rows::MeanEdge,
        _ => Rows::Count(values.number("row_count") as u32),
    }
}

const fn loop_number(id: &'static str, label: &'static str) -> Param {
    Param::int(id, label, [-1.0, MAX_COUNT], &[-1.0]).with_help(
        "The number of the loop in the output of the filter boundary_loops; -1 takes the nearest pair of loops.",
    )
}

fn run(inputs: &[Input<'_>], values: &Values<'_>, job: &Job<'_>) -> Result<Vec<Output>> {
    let a = inputs[0].mesh()?;
    let b = inputs.get(1).map(Input::mesh).transpose()?;
    let loop_a = loop_by_number(a, values, "loop_a", &job.part(0.0, 0.1))?;
    let loop_b = loop_by_number(b.unwrap_or(a), values, "loop_b", &job.part(0.1, 0.2))?;
    let request = Request { a, loop_a: loop_a.as_deref(), b, loop_b: loop_b.as_deref() };
    let options = Options {
        meridians: values.choice("meridians", Meridians::CHOICES),
        orientation: values.choice("orientation", Orientation::CHOICES),
        twist: values.number("twist") as i64,
        extent: values.choice("extent", EXTENTS),
        run: values.choice("run", Run::CHOICES),
        tolerance: Some(values.number("tolerance")).filter(|&t| t >= 0.0),
        rows: rows(values),
        cells: values.choice("cells", Cells::CHOICES),
        fairing: values.choice("fairing", Fairing::CHOICES),
        finish: values.choice("finish", Finish::CHOICES),
        intersections: values.choice("intersections", Intersections::CHOICES),
        outward: if values.is_set("outward") { Outward::Closed } else { Outward::Keep },
        ..Options::default()
    };
    let mut done = stitch(&request, &options, &job.part(0.2, 1.0))?;
    done.keep_splits(&alloc::gather([Some(request.a), request.b].into_iter().flatten())?, &job.part(1.0, 1.0))?;
    let report = report(&done);
    let origins = values.origins(|| Origins::from_stitch(&done, &job.part(1.0, 1.0)))?;
    Ok(vec![Output::Mesh(done.mesh, origins), Output::Text(report)])
}

/// The vertices of the loop that parameter `id` numbers; `None` for -1.
fn loop_by_number(
    mesh: &MeshView<'_>,
    values: &Values<'_>,
    id: &'static str,
    job: &Job<'_>,
) -> Result<Option<Vec<u32>>> {
    let number = values.number(id);
    if number < 0.0 {
        return Ok(None);
    }
    let boundary = boundary_loops(mesh, &boundary::Options::default(), job)?;
    let found = boundary.get(number as usize).ok_or(Error::OptionOutOfRange { option: id, value: number })?;
    Ok(Some(alloc::copied(found.vertices)?))
}

fn report(done: &Stitch) -> Report {
    let Quality { min_angle, max_aspect, max_edge, area, loops_left, .. } = done.quality;
    let turned = if done.turned { "the second piece was turned over\n" } else { "" };
    let outwards = turned_outwards(&done.turned_outwards);
    let parts = if done.closed { "loops" } else { "arcs" };
    let left = match loops_left {
        0 => "the result is closed".to_owned(),
        n => format!("{} left", counted(n, BOUNDARY_LOOP)),
    };
    let cuts = cuts(done.intersections.as_deref());
    let [a, b] = done.rims.each_ref().map(Vec::len);
    let text = format!(
        "joined {parts} of {a} and {b} vertices by {}, {}\n{turned}\
         area {}, longest edge {}, smallest angle {:.2} degrees, largest aspect ratio {max_aspect:.2}\n\
         {cuts}{outwards}{left}\n",
        counted(done.strip_faces.len(), FACE),
        counted(done.rows, ["interior row", "interior rows"]),
        short(area),
        short(max_edge),
        min_angle.to_degrees()
    );
    let mut values = vec![
        ("rim_vertices_a", a as f64),
        ("rim_vertices_b", b as f64),
        ("strip_faces", done.strip_faces.len() as f64),
        ("rows", f64::from(done.rows)),
        ("turned", f64::from(u8::from(done.turned))),
        ("area", area),
        ("longest_edge", max_edge),
        ("smallest_angle", min_angle),
        ("largest_aspect_ratio", max_aspect),
        ("turned_outwards", done.turned_outwards.len() as f64),
        ("boundary_loops", f64::from(loops_left)),
        ("blended", f64::from(u8::from(done.finish == Finish::Blend))),
    ];
    if let Some(pairs) = &done.intersections {
        values.push(("intersections", pairs.len() as f64));
    }
    Report::new(text, &values)
}
