//! The scene: which nodes show which meshes, and where. Works without recursion in linear time.

use super::gltf_accessors::Accessors;
use super::gltf_buffers::{element, malformed};
use super::gltf_matrix::{Matrix, matrix_from_node, matrix_from_trs, product};
use crate::document::Placement;
use crate::error::{Note, Place, ReadError};
use crate::json_tape::Value;
use crate::text_encoding::owned_text;
use gusset_base::alloc;

/// The parent of a node without one.
const NO_PARENT: u32 = u32::MAX;

/// A mesh that a node shows.
pub(super) struct ShownMesh {
    /// Index in the file.
    pub(super) mesh: usize,
    pub(super) name: String,
    pub(super) transform: Matrix,
    pub(super) is_skinned: bool,
}

/// Finds the meshes of the shown scene: of the default one, or of the first one, or else all root nodes, or all meshes.
pub(super) fn shown_meshes<'a>(
    root: Value<'a>,
    accessors: &mut Accessors<'a>,
    notes: &mut Vec<Note>,
) -> Result<Vec<ShownMesh>, ReadError> {
    let (nodes, scenes) = (root.list("nodes")?, root.list("scenes")?);
    // Lists of values, parents and marks.
    accessors.buffers.budget.take_bytes_of::<[u64; 8]>(nodes.len() as u64)?;
    let parents = node_parents(&nodes, notes)?;
    let roots = match scenes.len() {
        0 if nodes.is_empty() => return unplaced_meshes(root, accessors),
        0 => {
            notes.push(Note::new(Place::Whole, "the file lacks a scene; all nodes are shown"));
            alloc::gather((0..nodes.len()).filter(|&node| parents[node] == NO_PARENT))?
        }
        count => {
            if count > 1 {
                let others = count - 1;
                let noun = if others == 1 { "scene is" } else { "scenes are" };
                notes.push(Note::new(Place::Whole, format!("{others} other {noun} not read")));
            }
            let shown = root.get("scene").and_then(Value::whole_number).unwrap_or(0);
            let scene = element(&scenes, usize::try_from(shown).unwrap_or(usize::MAX), "scene")?;
            scene_roots(scene, &nodes, &parents, notes)?
        }
    };
    list_shown_meshes(&nodes, &roots, accessors, notes)
}

fn unplaced_meshes<'a>(root: Value<'a>, accessors: &mut Accessors<'a>) -> Result<Vec<ShownMesh>, ReadError> {
    let count = root.get("meshes").map_or(0, |meshes| meshes.items().count());
    let mut made = accessors.buffers.budget.allocate_vector(count as u64)?;
    made.extend((0..count).map(|mesh| ShownMesh {
        mesh,
        name: String::new(),
        transform: Placement::IDENTITY,
        is_skinned: false,
    }));
    Ok(made)
}

fn node_index(value: Value<'_>, count: usize) -> Result<usize, ReadError> {
    value.whole_number().and_then(|index| usize::try_from(index).ok()).filter(|&index| index < count).ok_or_else(|| {
        let raw = String::from_utf8_lossy(&value.raw_text()[..value.raw_text().len().min(20)]);
        malformed(format!("node {raw} does not exist (the file has {count})"))
    })
}

/// Returns the parent of each node. Refuses a node that two nodes contain, and nodes that contain themselves.
fn node_parents(nodes: &[Value<'_>], notes: &mut Vec<Note>) -> Result<Vec<u32>, ReadError> {
    let mut parents = alloc::filled(NO_PARENT, nodes.len())?;
    let mut repeated = 0;
    for (parent, node) in nodes.iter().enumerate() {
        for child in node.get("children").into_iter().flat_map(Value::items) {
            let child = node_index(child, nodes.len())?;
            if parents[child] == parent as u32 {
                repeated += 1;
            } else if parents[child] != NO_PARENT {
                let first = parents[child];
                return Err(malformed(format!("node {child} is a child of node {first} and of node {parent}")));
            }
            parents[child] = parent as u32;
        }
    }
    if repeated > 0 {
        notes.push(Note::new(Place::Whole, format!("{repeated} repeated entries in lists of children are ignored")));
    }
    refuse_cycles(&parents)?;
    Ok(parents)
}

fn refuse_cycles(parents: &[u32]) -> Result<(), ReadError> {
    // The walk up from a node marks it with the walk's number, and ends at any mark.
    let mut marks = alloc::filled(NO_PARENT, parents.len())?;
    for start in 0..parents.len() {
        let mut node = start as u32;
        while node != NO_PARENT && marks[node as usize] == NO_PARENT {
            marks[node as usize] = start as u32;
            node = parents[node as usize];
        }
        if node != NO_PARENT && marks[node as usize] == start as u32 {
            return Err(malformed(format!("node {node} is its own ancestor")));
        }
    }
    Ok(())
}

/// Returns the nodes that a scene lists. Lists no node twice, and no node below another listed one.
fn scene_roots(
    scene: Value<'_>,
    nodes: &[Value<'_>],
    parents: &[u32],
    notes: &mut Vec<Note>,
) -> Result<Vec<usize>, ReadError> {
    let mut listed = alloc::filled(false, nodes.len())?;
    let mut roots = Vec::new();
    for value in scene.get("nodes").into_iter().flat_map(Value::items) {
        let node = node_index(value, nodes.len())?;
        if !std::mem::replace(&mut listed[node], true) {
            alloc::push(&mut roots, node)?;
        }
    }
    if roots.iter().all(|&node| parents[node] == NO_PARENT) {
        return Ok(roots);
    }
    notes.push(Note::new(Place::Whole, "the scene lists nodes that are children of other nodes"));
    // Whether a listed node is above each node: known for marked nodes.
    let mut is_below: Vec<Option<bool>> = alloc::filled(None, nodes.len())?;
    let mut path = alloc::with_capacity(nodes.len())?;
    roots.retain(|&root| {
        let mut node = parents[root];
        path.clear();
        let found = loop {
            if node == NO_PARENT {
                break false;
            }
            if listed[node as usize] {
                break true;
            }
            if let Some(known) = is_below[node as usize] {
                break known;
            }
            path.push(node);
            node = parents[node as usize];
        };
        for &node in &path {
            is_below[node as usize] = Some(found);
        }
        !found
    });
    Ok(roots)
}

fn list_shown_meshes<'a>(
    nodes: &[Value<'a>],
    roots: &[usize],
    accessors: &mut Accessors<'a>,
    notes: &mut Vec<Note>,
) -> Result<Vec<ShownMesh>, ReadError> {
    let mut shown = Vec::new();
    // Matrices of nodes with children. An open node refers to its parent's one.
    let mut matrices: Vec<Matrix> = vec![Placement::IDENTITY];
    let mut open = alloc::collect(roots.iter().rev().map(|&root| (root as u32, 0)))?;
    let mut is_opened = alloc::filled(false, nodes.len())?;
    roots.iter().for_each(|&root| is_opened[root] = true);
    while let Some((index, parent)) = open.pop() {
        let index = index as usize;
        let node = nodes[index];
        let transform = product(&matrices[parent as usize], &matrix_from_node(node, index, notes)?);
        if let Some(mesh) = node.get("mesh") {
            let mesh =
                mesh.whole_number().ok_or_else(|| malformed(format!("node {index}: mesh is not a whole number")))?;
            append_shown_mesh(node, mesh as usize, &transform, accessors, notes, &mut shown)?;
        }
        alloc::check_reserve()?;
        let start = open.len();
        for child in node.get("children").into_iter().flat_map(Value::items) {
            let child = node_index(child, nodes.len())?;
            if !std::mem::replace(&mut is_opened[child], true) {
                alloc::push(&mut open, (child as u32, matrices.len() as u32))?;
            }
        }
        if open.len() > start {
            alloc::push(&mut matrices, transform)?;
            open[start..].reverse();
        }
    }
    Ok(shown)
}

/// Adds the mesh of a node, or the copies of it.
fn append_shown_mesh<'a>(
    node: Value<'a>,
    mesh: usize,
    transform: &Matrix,
    accessors: &mut Accessors<'a>,
    notes: &mut Vec<Note>,
    shown: &mut Vec<ShownMesh>,
) -> Result<(), ReadError> {
    let instances = instance_transforms(node, accessors, notes)?;
    let name = node.get("name").and_then(Value::text).unwrap_or_default();
    let count = instances.as_ref().map_or(1, Vec::len) as u64;
    accessors.buffers.budget.take_bytes_of::<(ShownMesh, Placement)>(count)?;
    accessors.buffers.budget.take_bytes_of::<u8>(count.saturating_mul(2 * name.len() as u64))?;
    let is_skinned = node.get("skin").is_some();
    let mut add = |transform| -> Result<(), ReadError> {
        let name = owned_text(name.as_bytes())?;
        alloc::check_reserve()?;
        Ok(alloc::push(shown, ShownMesh { mesh, name, transform, is_skinned })?)
    };
    match instances {
        None => add(*transform),
        Some(instances) => instances.iter().try_for_each(|own| add(product(transform, own))),
    }
}

/// Returns the transforms of the copies of a node's mesh (`EXT_mesh_gpu_instancing`); `None` if the node shows one.
fn instance_transforms<'a>(
    node: Value<'a>,
    accessors: &mut Accessors<'a>,
    notes: &mut Vec<Note>,
) -> Result<Option<Vec<Matrix>>, ReadError> {
    let attributes =
        node.get("extensions").and_then(|all| all.get("EXT_mesh_gpu_instancing")).and_then(|own| own.get("attributes"));
    let Some(attributes) = attributes else { return Ok(None) };
    let mut count = usize::MAX;
    let mut open = |name: &str| -> Result<_, ReadError> {
        let Some(index) = attributes.get(name).and_then(Value::whole_number) else { return Ok(None) };
        let accessor = accessors.open_accessor(index as usize, notes)?;
        count = count.min(accessor.count);
        Ok(Some(accessor))
    };
    let (translation, rotation, scale) = (open("TRANSLATION")?, open("ROTATION")?, open("SCALE")?);
    if count == usize::MAX {
        return Ok(None);
    }
    let buffers = &mut accessors.buffers;
    let translations = translation.map(|all| all.read_vectors::<3, f64>(buffers, |x| x)).transpose()?;
    let rotations = rotation.map(|all| all.read_vectors::<4, f64>(buffers, |x| x)).transpose()?;
    let scales = scale.map(|all| all.read_vectors::<3, f64>(buffers, |x| x)).transpose()?;
    let mut made = buffers.budget.allocate_vector(count as u64)?;
    made.extend((0..count).map(|k| {
        matrix_from_trs(
            translations.as_ref().map_or([0.0; 3], |all| all[k]),
            rotations.as_ref().map_or([0.0, 0.0, 0.0, 1.0], |all| all[k]),
            scales.as_ref().map_or([1.0; 3], |all| all[k]),
        )
    }));
    Ok(Some(made))
}
