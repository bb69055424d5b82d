//! The old faces round a hole: their edges, which no new edge may repeat, their normals along
//! the rim, and the lengths of edges at its vertices. Linear in the mesh, once for all holes.

use super::patch::Rim;
use crate::alloc;
use crate::error::Result;
use crate::job::Job;
use crate::mesh::{MeshView, NONE};
use crate::sort::sort_distinct;
use glam::DVec3;

/// Which old faces and edges touch the rims of all holes.
pub(super) struct Surroundings {
    /// (rim vertex, face), sorted.
    corners: Vec<(u32, u32)>,
    /// The edges between two rim vertices, the smaller one first, sorted.
    edges: Vec<(u32, u32)>,
    /// Per vertex of the mesh, scratch.
    names: Vec<u32>,
}

/// Faces between two progress reports.
const REPORT_INTERVAL: usize = 1 << 16;

impl Surroundings {
    /// One pass over the faces. `on_rim`: per vertex of the mesh. Extra memory: 4 bytes a vertex of
    /// the mesh, and 16 a corner at a rim.
    pub(super) fn new(mesh: &MeshView<'_>, on_rim: &[bool], job: &Job<'_>) -> Result<Self> {
        let (mut corners, mut edges) = (Vec::new(), Vec::new());
        for f in 0..mesh.faces().len() {
            job.step_every(REPORT_INTERVAL, f, mesh.faces().len(), "looking round the holes")?;
            let face = mesh.face(f);
            if !face.clone().any(|v| on_rim[v as usize]) {
                continue;
            }
            for (u, v) in face.clone().zip(face.cycle().skip(1)) {
                if on_rim[u as usize] {
                    alloc::push(&mut corners, (u, f as u32))?;
                    if on_rim[v as usize] {
                        alloc::push(&mut edges, (u.min(v), u.max(v)))?;
                    }
                }
            }
        }
        sort_distinct(&mut corners);
        sort_distinct(&mut edges);
        Ok(Surroundings { corners, edges, names: alloc::filled(NONE, mesh.positions().len())? })
    }

    /// True if the mesh has an edge between two rim vertices.
    pub(super) fn has_edge(&self, u: u32, v: u32) -> bool {
        self.edges.binary_search(&(u.min(v), u.max(v))).is_ok()
    }

    fn faces_at(&self, v: u32) -> impl Iterator<Item = u32> + '_ {
        let start = self.corners.partition_point(|&(u, _)| u < v);
        self.corners[start..].iter().take_while(move |&&(u, _)| u == v).map(|&(_, f)| f)
    }

    /// A hole in numbers of its own. `vertices`: its loop with the surface on the left. `whole`:
    /// true of a vertex of the mesh that no other loop or chain passes.
    pub(super) fn rim(&mut self, mesh: &MeshView<'_>, vertices: &[u32], whole: impl Fn(u32) -> bool) -> Result<Rim> {
        let n = vertices.len();
        let mut names = alloc::collect(vertices.iter().rev().copied())?;
        let mut faces = alloc::gather(names.iter().flat_map(|&v| self.faces_at(v)))?;
        sort_distinct(&mut faces);
        names.iter().enumerate().for_each(|(i, &v)| self.names[v as usize] = i as u32);

        let mut rim = Rim {
            count: n,
            points: Vec::new(),
            around: Vec::new(),
            across: alloc::filled(DVec3::ZERO, n)?,
            scale: alloc::filled(0.0, n)?,
            whole: alloc::collect(names.iter().map(|&v| whole(v)))?,
        };
        let mut sides = alloc::filled(0u32, n)?;
        let mut own = Vec::new();
        for &f in &faces {
            own.clear();
            for v in mesh.face(f as usize) {
                let name = &mut self.names[v as usize];
                if *name == NONE {
                    *name = names.len() as u32;
                    alloc::push(&mut names, v)?;
                }
                alloc::push(&mut own, *name)?;
            }
            enter_face(mesh, &names, &own, &mut rim, &mut sides)?;
        }
        for (scale, &sides) in rim.scale.iter_mut().zip(&sides) {
            *scale /= f64::from(sides.max(1));
        }
        rim.points = alloc::collect(names.iter().map(|&v| mesh.positions().get(v)))?;
        names.iter().for_each(|&v| self.names[v as usize] = NONE);
        Ok(rim)
    }
}

/// Adds a face, whose vertices are `own`, to what is known round the rim.
fn enter_face(mesh: &MeshView<'_>, names: &[u32], own: &[u32], rim: &mut Rim, sides: &mut [u32]) -> Result<()> {
    let point = |name: u32| mesh.positions().get(names[name as usize]);
    let n = rim.count;
    alloc::extend(&mut rim.around, own[1..].windows(2).map(|pair| [own[0], pair[0], pair[1]]))?;
    // By Newell's formula, seen from a corner, at a scale of its own; only its direction counts.
    let reach = own.iter().map(|&v| (point(v) - point(own[0])).abs().max_element()).fold(f64::MIN_POSITIVE, f64::max);
    let leg = |v: u32| (point(v) - point(own[0])) / reach;
    let area: DVec3 = own[1..].windows(2).map(|pair| leg(pair[0]).cross(leg(pair[1]))).sum();
    for (k, &u) in own.iter().enumerate() {
        let v = own[(k + 1) % own.len()];
        let length = crate::geom::scale::distance(point(u), point(v));
        for end in [u as usize, v as usize].into_iter().filter(|&end| end < n) {
            rim.scale[end] += length;
            sides[end] += 1;
        }
        // The old face runs its rim edge against the new ones.
        if (v as usize) < n && (v as usize + 1) % n == u as usize {
            rim.across[v as usize] = area;
        }
    }
    Ok(())
}
