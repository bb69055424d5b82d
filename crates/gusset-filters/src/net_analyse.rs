use super::data::{Curves, Input, Output, require_same_faces};
use super::filter::{Filter, FilterBody};
use super::quads::CATEGORY;
use super::report::{EDGE, FACE, count_with_noun, format_short};
use super::signatures::{TO_CURVES_TEXT, TWO_MESHES};
use super::typed_param::{LISTED_COUNT_RANGE, NON_NEGATIVE_RANGE, Param, ParamValues, params};
use gusset_base::error::Result;
use gusset_base::geom::aabb;
use gusset_base::job::Job;
use gusset_mesh::MeshView;
use gusset_net::analyse::analyse;
use gusset_net::convert::{RecognisedNet, net_of_grid};
use gusset_net::{Coordinates, Net};

pub(super) const FILTER: Filter = Filter {
    id: "net_analyse",
    name: "Analyse a deformation of a quad grid",
    category: CATEGORY,
    help: "Compares a quad grid before a deformation with the same mesh after it. It returns the edges that were contracted or \
           torn, as segments of the original grid, and lists the quads that were folded. A deformation without any of these is \
           soft.",
    reference: "A. A. Deryagin, Modelling of 3D objects and scenes by tetragonal regular networks, soft and hard deformations",
    ..Filter::new(TWO_MESHES, TO_CURVES_TEXT, &FilterBody(run))
};

params! {
    tolerance: f64 = Param::length(
        "Tolerance",
        "The largest length that counts as 0. A billionth of the size is suggested.",
        NON_NEGATIVE_RANGE, &[0.0],
    ).with_size_ratio(1e-9);
    listed: u32 = Param::int("Faces listed", "The largest number of folded faces that are listed.", LISTED_COUNT_RANGE, &[20.0]);
}

fn run(inputs: &[Input<'_>], values: &ParamValues<Params>, job: &Job<'_>) -> Result<Vec<Output>> {
    let (before, after) = (inputs[0].mesh()?, inputs[1].mesh()?);
    let grid = net_of_grid(before, None, &job.sub_job(0.0, 0.4))?;
    let moved = net_with_positions(&grid, before, after, &job.sub_job(0.4, 0.5))?;
    let found = analyse(&grid.net, &moved, values.tolerance, &job.sub_job(0.5, 1.0))?;
    let mut edges = Curves::without_curves();
    let shape = grid.net.shape();
    for link in found.contracted.iter().map(|contracted| contracted.link).chain(found.torn.iter().copied()) {
        let ends = shape.ends_of_link(link).map(|node| before.positions().get(grid.vertex_of_node[node as usize]));
        edges.add_curve(ends.into_iter(), false)?;
    }
    let kind = if found.is_soft() { "soft" } else { "hard" };
    let mut text = format!(
        "a {kind} deformation: {} contracted to points, {} torn, {} folded\n\
         lengths of edges times {}, areas of faces times {}\n",
        count_with_noun(found.contracted.len(), EDGE),
        found.torn.len(),
        count_with_noun(found.folded.len(), FACE),
        ratio_range_text(&found.links),
        ratio_range_text(&found.cells)
    );
    let most = values.listed as usize;
    if !found.folded.is_empty() && most > 0 {
        text += "folded:";
        for &cell in found.folded.iter().take(most) {
            text += &format!(" {}", grid.face_of_cell[cell as usize]);
        }
        text += if found.folded.len() > most { " ...\n" } else { "\n" };
    }
    Ok(vec![Output::Curves(edges), Output::Text(text.into())])
}

/// The smallest and the largest of some ratios.
fn ratio_range_text(ratios: &[f64]) -> String {
    let [min, max] = aabb::range_of_values(ratios.iter().copied());
    format!("{} to {}", format_short(min), format_short(max))
}

/// The net with the positions of another mesh, which must have the same faces.
fn net_with_positions(
    grid: &RecognisedNet,
    before: &MeshView<'_>,
    after: &MeshView<'_>,
    job: &Job<'_>,
) -> Result<Net<'static>> {
    job.step(0.0, "looking for the same faces")?;
    require_same_faces(before, after, 1)?;
    let shape = grid.net.shape();
    let mut coordinates = Coordinates::zeroed(shape, after.positions().scalar())?;
    for i in 0..shape.rows() {
        job.step(0.1 + 0.9 * i as f64 / shape.rows() as f64, "positions to nodes")?;
        for j in 0..shape.columns() {
            let vertex = grid.vertex_of_node[shape.node(i, j) as usize];
            coordinates.set(i, j, after.positions().get(vertex));
        }
    }
    Ok(Net::new(coordinates, grid.net.topology().copied()?))
}
