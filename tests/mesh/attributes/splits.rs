//! Vertices split at seams: with a merge map, the surface equals the unsplit mesh.

use super::fields::job;
use crate::common::{Soup, cap, data, edge_counts, some_of, torus};
use gusset::Error;
use gusset::assemble::{self, assemble};
use gusset::attributes::{Domain, KeepSplitVertices, Origins, Rule};
use gusset::boundary::{self, boundary_loops};
use gusset::fill::{self, LoopSelection, fill_holes};
use gusset::mesh::merge::map_to_equal_vertices;
use gusset::mesh::{Mesh, MeshView};
use gusset::repair::orient::{self, orient};
use gusset::repair::sew::sew;
use gusset::repair::weld::{self, weld};
use gusset::stitch::{Options, Request, Rows, stitch};
use std::collections::{BTreeSet, HashMap};

/// A mesh whose vertices are split between charts of its faces.
struct Split {
    whole: Soup,
    split: Soup,
    /// For each split vertex its vertex of the whole.
    original: Vec<u32>,
    merge: Vec<u32>,
    merged: Vec<u32>,
}

impl Split {
    /// Charts by chance; split vertices in an order by chance.
    fn by_chance(whole: Soup, seed: u64) -> Split {
        let mut random = fastrand::Rng::with_seed(seed);
        let charts = random.usize(1..5);
        let centres: Vec<_> = (0..charts).map(|_| whole.points[random.usize(..whole.points.len())]).collect();
        let chart_of = |face: &[u32]| {
            let p = whole.points[face[0] as usize];
            let square = |c: &[f64; 3]| (0..3).map(|k| (p[k] - c[k]).powi(2)).sum::<f64>();
            (0..charts).min_by(|&a, &b| square(&centres[a]).total_cmp(&square(&centres[b]))).unwrap_or(0)
        };
        let mut pairs: Vec<(u32, usize)> =
            whole.faces().flat_map(|face| face.iter().map(|&v| (v, chart_of(face))).collect::<Vec<_>>()).collect();
        pairs.extend((0..whole.points.len() as u32).map(|v| (v, usize::MAX)));
        pairs.sort_unstable();
        pairs.dedup_by(|next, before| next.0 == before.0 && next.1 == usize::MAX || next == before);
        random.shuffle(&mut pairs);
        let names: HashMap<(u32, usize), u32> = pairs.iter().copied().zip(0..).collect();
        let points = pairs.iter().map(|&(v, _)| whole.points[v as usize]).collect();
        let mut split = Soup { points, offsets: vec![0], ..Soup::default() };
        for face in whole.faces() {
            let chart = chart_of(face);
            split.face(&face.iter().map(|&v| names[&(v, chart)]).collect::<Vec<_>>());
        }
        let original: Vec<u32> = pairs.iter().map(|&(v, _)| v).collect();
        let merge = map_to_equal_vertices(&split.view(), Some(&original), &job()).unwrap();
        let merged = merged(&split, &merge).unwrap();
        Split { whole, split, original, merge, merged }
    }

    fn view(&self) -> MeshView<'_> {
        self.split.view().merged(bytemuck::cast_slice(&self.merge), &self.merged)
    }
}

fn merged(soup: &Soup, merge: &[u32]) -> Result<Vec<u32>, Error> {
    soup.view().merged_corners(bytemuck::cast_slice(merge), &job())
}

/// A torus with a window, a cap, or both.
fn shapes(seed: u64) -> Soup {
    let ring = torus(9 + (seed % 5) as u32, 7);
    let mut open = Soup { points: ring.points.clone(), offsets: vec![0], ..Soup::default() };
    let window = (seed as usize * 3) % 40;
    ring.faces().enumerate().filter(|&(f, _)| f != window && f != window + 1).for_each(|(_, face)| open.face(face));
    match seed % 3 {
        0 => open,
        1 => cap(11, 4, 0.3, 1.0),
        _ => {
            let mut lid = cap(9, 3, 0.5, -1.0);
            lid.points.iter_mut().for_each(|p| p[2] -= 9.0);
            open.and(&lid)
        }
    }
}

/// The faces of a result by vertices of the whole; new vertices follow.
fn by_original(mesh: &Mesh, original: &[u32], whole: usize, take: impl Fn(usize) -> u32) -> Vec<Vec<u32>> {
    let name = |v: u32| match (v as usize).checked_sub(original.len()) {
        None => original[v as usize],
        Some(k) => (whole + k) as u32,
    };
    let corners: Vec<u32> = (0..mesh.face_corners.len()).map(|c| name(take(c))).collect();
    mesh.face_offsets.windows(2).map(|w| corners[w[0] as usize..w[1] as usize].to_vec()).collect()
}

/// Compares the results on the split mesh and on the whole. The surfaces are equal, faces keep
/// split vertices, the merge map has one vertex for each of the whole, and corners keep their
/// values.
fn assert_kept(split: &Split, made: &Mesh, origins: &Origins, expected: Option<&Mesh>) {
    let (old, whole) = (split.split.points.len(), split.whole.points.len());
    let merge = &made.merge;
    assert!(!merge.is_empty());
    let named = by_original(made, &split.original, whole, |c| made.face_corners[c]);
    if let Some(expected) = expected {
        // New faces depend on the numbers of vertices where they are as good as others; borders do not.
        let faces: Vec<_> = expected.faces().map(<[u32]>::to_vec).collect();
        let count = split.whole.faces().count();
        assert_eq!(named[..count], faces[..count]);
        let open = |faces: &[Vec<u32>]| {
            let counts = edge_counts(faces.iter().map(Vec::as_slice));
            assert!(counts.values().all(|&(forward, backward)| forward <= 1 && backward <= 1));
            counts.into_iter().filter(|&(_, (f, b))| f + b == 1).map(|(edge, _)| edge).collect::<BTreeSet<_>>()
        };
        assert_eq!(open(&named), open(&faces));
    }
    // Old corners are unchanged.
    assert_eq!(made.face_corners[..split.split.corners.len()], split.split.corners);
    for (v, &of) in merge.iter().enumerate() {
        assert_eq!(merge[of as usize], of);
        assert_eq!(of, split.merge.get(v).copied().unwrap_or(v as u32));
    }
    // The corners of old faces have values of split vertices bit for bit; a new corner has the
    // value of one copy.
    let values: Vec<f64> = (0..old).map(|v| (v as f64 * 0.7).sin()).collect();
    let at = super::carried(origins, Domain::Vertices, Rule::Nearest, 1, std::slice::from_ref(&values));
    assert_eq!(at[..old], values);
    let of_corners: Vec<f64> = split.split.corners.iter().map(|&v| values[v as usize]).collect();
    let corners = super::carried(origins, Domain::Corners, Rule::Texture, 1, std::slice::from_ref(&of_corners));
    assert_eq!(corners[..of_corners.len()], of_corners);
    for (c, &v) in made.face_corners.iter().enumerate().filter(|&(_, &v)| (v as usize) < old) {
        let (sources, _) = origins.table(Domain::Corners).row(c);
        assert_eq!(split.split.corners[sources[0] as usize], v);
    }
}

/// The loops of the split mesh, which equal the loops of the whole.
fn assert_same_loops(split: &Split) {
    let loops = |mesh: &MeshView<'_>, name: &dyn Fn(u32) -> u32| {
        let found = boundary_loops(mesh, &boundary::Options::default(), &job()).unwrap();
        let loops = (0..found.len()).map(|k| found.get(k).unwrap());
        loops
            .map(|l| (l.half_edges.to_vec(), l.vertices.iter().map(|&v| name(v)).collect()))
            .collect::<Vec<(_, Vec<u32>)>>()
    };
    assert_eq!(loops(&split.view(), &|v| split.original[v as usize]), loops(&split.whole.view(), &|v| v));
}

/// Real meshes split by a seed each: loops, filled holes, and the values of old corners.
#[test]
fn real_meshes_are_what_they_were_before() {
    let names = ["elephant-with-holes", "nefertiti", "head", "lion", "mech-holes-shark", "double-torus-3-holes"];
    let others = ["pig", "patch-01", "boeing", "hole_capsule", "b9_mesh", "oblong-shuffled", "ALSTOM_TEST4"];
    let meshes = names.iter().chain(&others).filter_map(|name| data::off(&format!("meshes/{name}.off")));
    let meshes: Vec<Soup> = meshes.collect();
    for (seed, whole) in some_of(15, (0..200).zip(meshes.iter().cycle())) {
        let split = Split::by_chance(whole.clone(), seed);
        assert_same_loops(&split);
        let view = split.view();
        let plain = fill::Options { refinement: fill::Refinement::None, ..fill::Options::default() };
        let mut made = fill_holes(&view, LoopSelection::All, &plain, &job()).unwrap();
        made.keep_split_vertices(&[&view], &job()).unwrap();
        if made.turned_outwards.is_empty() {
            assert_kept(&split, &made.mesh, &Origins::from_filled(&made, &job()).unwrap(), None);
        }
    }
}

#[test]
fn loops_and_results_are_those_of_the_mesh_before() {
    for seed in some_of(5, 0..200) {
        let split = Split::by_chance(shapes(seed), seed);
        assert_same_loops(&split);
        let (view, whole) = (split.view(), split.whole.view());
        let options = fill::Options { refinement: fill::Refinement::RimDensity(500), ..fill::Options::default() };
        let expected = fill_holes(&whole, LoopSelection::All, &options, &job()).unwrap();
        let mut made = fill_holes(&view, LoopSelection::All, &options, &job()).unwrap();
        made.keep_split_vertices(&[&view], &job()).unwrap();
        assert_kept(&split, &made.mesh, &Origins::from_filled(&made, &job()).unwrap(), Some(&expected.mesh));

        let mut made = orient(&view, &orient::Options::default(), &job()).unwrap();
        made.keep_split_vertices(&[&view], &job()).unwrap();
        assert_kept(
            &split,
            &made.mesh,
            &Origins::from_oriented(&made, &job()).unwrap(),
            Some(&orient(&whole, &orient::Options::default(), &job()).unwrap().mesh),
        );

        if seed % 3 == 2 {
            let rows = Options { rows: Rows::Count(2), ..Options::default() };
            let within = |a| stitch(&Request { a, loop_a: None, b: None, loop_b: None }, &rows, &job());
            if let (Ok(mut made), Ok(expected)) = (within(&view), within(&whole)) {
                made.keep_split_vertices(&[&view], &job()).unwrap();
                let turned = made.turned || !made.turned_outwards.is_empty();
                if !turned {
                    assert_kept(
                        &split,
                        &made.mesh,
                        &Origins::from_stitch(&made, &job()).unwrap(),
                        Some(&expected.mesh),
                    );
                }
            }
            let views = [view];
            let mut made =
                assemble(&views, &assemble::Options { keep_orientation: true, ..Default::default() }, &job()).unwrap();
            made.keep_split_vertices(&[&views[0]], &job()).unwrap();
            assert_kept(&split, &made.mesh, &Origins::from_assembly(&made, &job()).unwrap(), None);
        }
    }
}

#[test]
fn maps_are_found_by_keys_and_by_positions() {
    let mut soup = cap(7, 2, 0.3, 1.0).and(&cap(7, 2, 0.3, 1.0));
    let half = soup.points.len() / 2;
    soup.points[half] = [-0.0, 0.0, 1.0];
    let merge = map_to_equal_vertices(&soup.view(), None, &job()).unwrap();
    assert!((0..half).all(|v| merge[v] == v as u32 && merge[half + v] == v as u32));
    // Vertices that no face uses may hold anything.
    soup.points.extend([[f64::NAN; 3]; 2]);
    let merge = map_to_equal_vertices(&soup.view(), None, &job()).unwrap();
    assert_eq!(merge[2 * half..], [2 * half as u32, 2 * half as u32 + 1]);
    let keys: Vec<u32> = (0..soup.points.len() as u32).map(|v| 1000 - v / 3).collect();
    let merge = map_to_equal_vertices(&soup.view(), Some(&keys), &job()).unwrap();
    assert!(merge.iter().enumerate().all(|(v, &of)| of as usize == v / 3 * 3));
}

#[test]
fn bad_maps_are_refused() {
    let soup = cap(5, 2, 0.3, 1.0);
    let count = soup.points.len() as u32;
    let own: Vec<u32> = (0..count).collect();
    assert!(merged(&soup, &own).is_ok());
    assert!(matches!(merged(&soup, &own[1..]), Err(Error::ArrayTooShort { .. })));
    for (v, of) in [(3, count), (7, u32::MAX), (4, 5)] {
        let mut merge = own.clone();
        merge[5] = 6;
        merge[v] = of;
        assert_eq!(merged(&soup, &merge).err(), Some(Error::BadMerge { vertex: v as u32, value: of }));
    }
}

/// Vertices that faces refer to directly count as used, whatever they are merged with.
#[test]
fn split_vertices_are_no_unused_ones() {
    for seed in 0..20 {
        let split = Split::by_chance(shapes(seed), seed);
        let used = split.split.corners.iter().collect::<BTreeSet<_>>().len();
        let options = weld::Options { remove_unused: true, ..weld::Options::default() };
        let mut welded = weld(&split.view(), &options, &job()).unwrap();
        welded.keep_split_vertices(&[&split.view()], &job()).unwrap();
        let mut sewn = sew(&split.view(), &options, &job()).unwrap();
        sewn.keep_split_vertices(&[&split.view()], &job()).unwrap();
        for (mesh, map) in [(&welded.mesh, &welded.vertex_map), (&sewn.mesh, &sewn.vertex_map)] {
            assert_eq!(mesh.positions.len(), used, "{seed}");
            let was = split.split.corners.iter().map(|&v| map[v as usize]);
            assert!(was.eq(mesh.face_corners.iter().copied()), "{seed}");
        }
    }
}
