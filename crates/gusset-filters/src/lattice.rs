use super::data::{Input, InputKind, Output, require_same_faces};
use super::filter::{Filter, FilterBody};
use super::moving::{CATEGORY, STRENGTH, move_mesh, output_of_moved_mesh};
use super::signatures::TO_MESH;
use super::typed_param::{ParamValues, params};
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::{Error, Result};
use gusset_base::geom::Aabb;
use gusset_base::job::Job;
use gusset_mesh::MeshView;
use gusset_net::field::Lattice;

pub(super) const FILTER: Filter = Filter {
    id: "lattice",
    name: "Deform by a lattice",
    category: CATEGORY,
    help: "Deforms a mesh by a lattice around it. The second mesh is the lattice at rest: its vertices lie on a uniform grid \
           along the coordinate axes, like the vertices of a box or of a subdivided cube. The third mesh is the lattice with its \
           vertices moved. Vertices of the first mesh inside the lattice follow; vertices outside stay. Grid points without a \
           vertex follow the vertices around them.",
    reference: "T. Sederberg, S. Parry, Free-form deformation of solid geometric models (1986)",
    replaces: true,
    has_origins: true,
    ..Filter::new(&[InputKind::Mesh; 3], TO_MESH, &FilterBody(run))
};

params! {
    strength: f64 = STRENGTH;
}

/// The smallest distance of two distinct grid coordinates, as a fraction of the lattice's extent.
/// Closer ones count as one. It is far below 1/31, the spacing of the 32 grid points that an axis
/// has at most.
const MIN_RELATIVE_SPACING: f64 = 1e-3;

/// The largest distance of a vertex from its grid point, in spacings of the grid.
const MAX_GRID_ERROR_IN_SPACINGS: f64 = 0.02;

fn run(inputs: &[Input<'_>], values: &ParamValues<Params>, job: &Job<'_>) -> Result<Vec<Output>> {
    let (rest, changed) = (inputs[1].mesh()?, inputs[2].mesh()?);
    job.step(0.0, "lattice")?;
    require_same_faces(rest, changed, 2)?;
    let lattice = lattice_from_meshes(rest, changed, &job.sub_job(0.0, 0.1))?;
    let moved = move_mesh(inputs[0].mesh()?, &lattice, values.strength, &job.sub_job(0.1, 1.0))?;
    Ok(vec![output_of_moved_mesh(moved, inputs, values, job)?])
}

/// The error of a lattice at rest that is not a lattice.
fn bad_rest_lattice_error(why: &'static str) -> Error {
    Error::InputUnfit { input: 1, why }
}

/// The lattice that takes one mesh to another.
fn lattice_from_meshes(rest: &MeshView<'_>, changed: &MeshView<'_>, job: &Job<'_>) -> Result<Lattice> {
    let ends = (0..rest.positions().len() as u32).map(|v| [rest, changed].map(|mesh| mesh.positions().get(v)));
    let ends = alloc::gather(ends.filter(|ends| ends.iter().all(|point| point.is_finite())))?;
    let extent = Aabb::from_points(ends.iter().map(|[from, _]| *from));
    let size = extent.size();
    if extent.is_empty() || size.min_element() <= 0.0 || !size.is_finite() {
        return Err(bad_rest_lattice_error("a lattice has an extent along each coordinate axis"));
    }
    let mut counts = [1; 3];
    for (axis, count) in counts.iter_mut().enumerate() {
        job.step(0.2 + 0.2 * axis as f64, "lattice")?;
        let mut places = alloc::collect(ends.iter().map(|[from, _]| from[axis]))?;
        places.sort_unstable_by(f64::total_cmp);
        *count += places.windows(2).filter(|pair| pair[1] - pair[0] > MIN_RELATIVE_SPACING * size[axis]).count();
        if *count > Lattice::MAX_POINTS {
            return Err(bad_rest_lattice_error("a lattice has at most 32 grid points along each coordinate axis"));
        }
    }
    job.step(0.8, "lattice")?;
    let steps = DVec3::from(counts.map(|count| (count - 1) as f64));
    let mut offsets = alloc::filled(None, counts.iter().product())?;
    for [from, to] in &ends {
        let place = (*from - extent.low) / size * steps;
        if (place - place.round()).abs().max_element() > MAX_GRID_ERROR_IN_SPACINGS {
            return Err(bad_rest_lattice_error(
                "the vertices of a lattice lie on a uniform grid along the coordinate axes",
            ));
        }
        let [i, j, k] = place.round().to_array().map(|index| index as usize);
        offsets[(k * counts[1] + j) * counts[0] + i] = Some(*to - *from);
    }
    Lattice::new(extent.low, extent.high, counts, &fill_missing_offsets(counts, offsets)?)
}

/// The offsets of all grid points: a point without one gets the mean of the linear interpolations
/// between the nearest points along each axis that have one. Affine motions are kept.
fn fill_missing_offsets(counts: [usize; 3], mut offsets: Vec<Option<DVec3>>) -> Result<Vec<DVec3>> {
    while offsets.contains(&None) {
        let known = alloc::copied(&offsets)?;
        let mut strides = [(1, 1); 3];
        for axis in 0..3 {
            strides[axis] = (strides[..axis].iter().map(|stride| stride.1).product(), counts[axis]);
        }
        for place in (0..known.len()).filter(|&place| known[place].is_none()) {
            let between = strides.iter().filter_map(|&(stride, count)| {
                let index = place / stride % count;
                let nearest = |mut steps: std::ops::RangeInclusive<usize>, forward: bool| {
                    steps.find_map(|k| {
                        let other = if forward { place + k * stride } else { place - k * stride };
                        known[other].map(|offset| (k as f64, offset))
                    })
                };
                let ((back, low), (ahead, high)) = (nearest(1..=index, false)?, nearest(1..=count - 1 - index, true)?);
                Some(low.lerp(high, back / (back + ahead)))
            });
            let (sum, count) = between.fold((DVec3::ZERO, 0.0), |(sum, count), offset| (sum + offset, count + 1.0));
            offsets[place] = (count > 0.0).then_some(sum / count);
        }
        if offsets == known {
            return Err(bad_rest_lattice_error("too few vertices of the lattice: its corners are needed"));
        }
    }
    alloc::gather(offsets.into_iter().flatten())
}
