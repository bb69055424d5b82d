use super::data::{Input, Output};
use super::filter::{Filter, FilterBody};
use super::repair::solid_report;
use super::signatures::{ONE_MESH, TO_MESH_TEXT};
use super::typed_param::ParamValues;
use gusset_attributes::Origins;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_stitch::solid::unite_solids;

pub(super) const FILTER: Filter = Filter {
    id: "unite",
    name: "Unite solids",
    category: "Repair",
    help: "Replaces closed meshes by their union, without intersecting faces. Meshes may intersect, touch, coincide or lie within \
           each other. Faces that no other meets stay as they are. Lists how many faces were dropped.",
    reference: "Zhou, Grinspun, Zorin and Jacobson 2016",
    max_inputs: 1 << 16,
    has_origins: true,
    ..Filter::new(ONE_MESH, TO_MESH_TEXT, &FilterBody(run))
};

fn run(inputs: &[Input<'_>], values: &ParamValues<()>, job: &Job<'_>) -> Result<Vec<Output>> {
    let pieces = alloc::try_collect(inputs.iter().map(|input| input.mesh().copied()))?;
    let done = unite_solids(&pieces, job)?;
    let origins = values.trace_origins(|| Origins::from_repaired(&done, &job.sub_job(1.0, 1.0)))?;
    let report = solid_report(&done, "no faces dropped");
    Ok(vec![Output::Mesh(done.mesh, origins), Output::Text(report)])
}
