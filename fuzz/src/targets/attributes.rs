//! Attributes through repairs and fills, also on meshes with split vertices: weights sum to 1,
//! values of one source are kept bit for bit, old corners stay at vertices that come from their
//! own.

use crate::agree::agreed;
use crate::input::{self, Soup};
use bytemuck::cast_slice;
use gusset::attributes::{Channel, Domain, KeepSplitVertices, Origins, Output, Rule, ValueType, carry_values_over};
use gusset::fill::{self, LoopSelection, fill_holes};
use gusset::mesh::merge::map_to_equal_vertices;
use gusset::mesh::{Mesh, MeshView};
use gusset::repair::orient::{self, Outward, orient};
use gusset::repair::sew::sew;
use gusset::repair::weld::{self, Vertices, weld};
use gusset::{Error, Job};

/// Runs one case.
pub(crate) fn run(bytes: &[u8]) {
    let Some((soup, seams, way, choice)) = input::taken::<(Soup, Option<[u8; 8]>, u8, u8)>(bytes) else { return };
    soup.visit(|mesh| {
        let Some(seams) = seams else { return carried(mesh, way, choice) };
        // Vertices at equal positions, or any that some bytes name.
        let keys: Vec<u32> = (0..mesh.positions().len()).map(|v| v as u32 >> (seams[v % 8] % 32 / 31)).collect();
        let keys = (seams[0] % 2 == 1).then_some(&keys[..]);
        let merge = map_to_equal_vertices(mesh, keys, &Job::default()).expect("a map of any keys");
        let Ok(corners) = mesh.merged_corners(cast_slice(&merge), &Job::default()) else { return };
        carried(&mesh.merged(cast_slice(&merge), &corners), way, choice);
    });
}

type Made = (Mesh, Origins, Vec<f64>);

fn carried(mesh: &MeshView<'_>, way: u8, choice: u8) {
    let count = mesh.positions().len();
    let points: Vec<[f64; 3]> = (0..count).map(|v| mesh.positions().get(v as u32).to_array()).collect();
    let values = |made: Mesh, origins: Origins, job: &Job<'_>| -> Result<Made, Error> {
        let mut channel = Channel::new(Domain::Vertices, ValueType::F64, 3, Rule::Linear)?;
        channel.push(cast_slice(&points), 0, count)?;
        let mut all = vec![0.0; 3 * made.positions.len()];
        let mut out = Output::new(
            bytemuck::cast_slice_mut(&mut all),
            0,
            made.positions.len(),
            channel.value_type_and_components(),
        )?;
        carry_values_over(&origins, &channel, &mut out, job)?;
        Ok((made, origins, all))
    };
    let welding = weld::Options {
        vertices: if way & 16 == 0 { Vertices::Boundary } else { Vertices::All },
        tolerance: (way & 32 == 0).then_some(f64::from(way >> 6)),
        collapse: way & 64 != 0,
        remove_unused: way & 128 != 0,
    };
    let made = agreed(choice, |job| {
        let (work, rest) = (job.sub_job(0.0, 0.5), job.sub_job(0.5, 1.0));
        match way % 4 {
            0 => {
                let mut done = weld(mesh, &welding, &work)?;
                done.keep_split_vertices(&[mesh], &rest.sub_job(0.0, 0.3))?;
                let origins = Origins::from_weld(&done, &rest.sub_job(0.3, 0.6))?;
                values(done.mesh, origins, &rest.sub_job(0.6, 1.0))
            }
            1 => {
                let mut done = sew(mesh, &welding, &work)?;
                done.keep_split_vertices(&[mesh], &rest.sub_job(0.0, 0.3))?;
                let origins = Origins::from_sew(&done, &rest.sub_job(0.3, 0.6))?;
                values(done.mesh, origins, &rest.sub_job(0.6, 1.0))
            }
            2 => {
                let outward = if way & 16 == 0 { Outward::Keep } else { Outward::Closed };
                let mut done = orient(mesh, &orient::Options { outward }, &work)?;
                done.keep_split_vertices(&[mesh], &rest.sub_job(0.0, 0.3))?;
                let origins = Origins::from_oriented(&done, &rest.sub_job(0.3, 0.6))?;
                values(done.mesh, origins, &rest.sub_job(0.6, 1.0))
            }
            _ => {
                let mut done = fill_holes(mesh, LoopSelection::All, &fill::Options::default(), &work)?;
                done.keep_split_vertices(&[mesh], &rest.sub_job(0.0, 0.3))?;
                let origins = Origins::from_filled(&done, &rest.sub_job(0.3, 0.6))?;
                values(done.mesh, origins, &rest.sub_job(0.6, 1.0))
            }
        }
    });
    let Ok((made, origins, values)) = made else { return };
    input::expect_origins(&origins, &made);
    let (vertices, corners) = (origins.table(Domain::Vertices), origins.table(Domain::Corners));
    for v in 0..made.positions.len() {
        if let &[source] = vertices.row(v).0 {
            let (was, is) = (points[source as usize], &values[3 * v..3 * v + 3]);
            assert!((0..3).all(|k| was[k].to_bits() == is[k].to_bits()), "vertex {v}: {is:?} of {was:?}");
        }
    }
    for (c, &v) in made.face_corners.iter().enumerate() {
        let (sources, row) = (corners.row(c).0, vertices.row(v as usize).0);
        let is_old = made.face_offsets.partition_point(|&end| end as usize <= c) <= mesh.faces().len();
        if let (&[source], true) = (sources, is_old && way % 4 != 1) {
            let vertex = mesh.faces().corner_vertex_before_merging(source);
            assert!(
                row.contains(&vertex),
                "corner {c}: of vertex {vertex}, at one of {row:?}, way {way} {}",
                mesh.faces().is_merged()
            );
        }
    }
}
