//! Reads a package: its model parts, then the scene that its items and components describe.

use super::mf_attributes::attribute;
use super::mf_model::{Component, Matrix, Model, ResourceId};
use super::mf_package::{Package, part_key};
use super::read_mf_model::ModelReader;
use crate::budget::Budget;
use crate::document::{Document, Placement};
use crate::error::{Note, Place, ReadError, ReadErrorKind};
use crate::options::ReadOptions;
use gusset_base::alloc;
use quick_xml::Reader;
use quick_xml::events::Event;
use std::collections::{BTreeMap, BTreeSet};

/// The usual name of the main model part.
const USUAL_PART: &str = "3d/3dmodel.model";

/// Largest size of the part that names the main one.
const MAX_RELATIONS_BYTES: u64 = 1 << 20;

pub(crate) fn read_3mf(bytes: &[u8], _: &ReadOptions) -> Result<Document, ReadError> {
    let package = Package::open(bytes)?;
    let mut document = Document::default();
    let mut model = Model::default();
    let mut budget = Budget::new(bytes.len());
    let main = main_part(&package)?;
    model.known_parts.insert(part_key(&main), 0);
    model.parts.push(main);
    let mut part = 0;
    while part < model.parts.len() {
        ModelReader::new(&package, &mut model, &mut document, &mut budget, part as u32).read()?;
        part += 1;
    }
    document.metres_per_unit = model.metres_per_unit;
    place_items(model, &mut document, &mut budget)?;
    Ok(document)
}

/// Returns the name of the main model part: the one that the package names, or the usual one, or the only one.
fn main_part(package: &Package<'_>) -> Result<String, ReadError> {
    if package.has("_rels/.rels") {
        let text = package.part("_rels/.rels")?.read_all(MAX_RELATIONS_BYTES)?;
        if let Some(target) = model_target(&text).filter(|target| package.has(&part_key(target))) {
            return Ok(target);
        }
    }
    if package.has(USUAL_PART) {
        return Ok(USUAL_PART.to_owned());
    }
    let is_model = |name: &&str| std::path::Path::new(name).extension().is_some_and(|extension| extension == "model");
    let mut models = package.names().filter(is_model);
    match (models.next(), models.next()) {
        (Some(only), None) => Ok(only.to_owned()),
        (None, _) => {
            let message = "the ZIP package has no 3D model part; this is not a 3MF file";
            Err(ReadError::malformed(Place::Whole, message))
        }
        (Some(_), Some(_)) => {
            let message = "the package does not say which of its model parts is the main one";
            Err(ReadError::malformed(Place::Whole, message))
        }
    }
}

fn model_target(text: &[u8]) -> Option<String> {
    let mut xml = Reader::from_reader(text);
    let mut buffer = Vec::new();
    loop {
        buffer.clear();
        match xml.read_event_into(&mut buffer) {
            Ok(Event::Start(tag) | Event::Empty(tag)) => {
                if attribute(&tag, "Type").is_some_and(|kind| kind.ends_with("/3dmodel")) {
                    return attribute(&tag, "Target");
                }
            }
            Ok(Event::Eof) | Err(_) => return None,
            Ok(_) => {}
        }
    }
}

/// The size of an expanded object: the meshes that it places, and the objects that its expansion visits. Repeated components count each
/// time. Components that place no mesh are not visited.
#[derive(Clone, Copy)]
struct Size {
    meshes: u64,
    visits: u64,
}

/// Computes the sizes of all objects without expanding them: a short chain of components can double its meshes many times.
fn object_sizes(model: &Model) -> Result<BTreeMap<ResourceId, Size>, ReadError> {
    let mut sizes: BTreeMap<ResourceId, Size> = BTreeMap::new();
    let mut entered: BTreeSet<ResourceId> = BTreeSet::new();
    for &start in model.objects.keys() {
        let mut open = vec![start];
        alloc::check_reserve()?;
        while let Some(&id) = open.last() {
            if sizes.contains_key(&id) {
                open.pop();
                continue;
            }
            let Some(object) = model.objects.get(&id) else {
                return Err(ReadError::malformed(Place::Whole, format!("object {} does not exist", id.1)));
            };
            let is_new = entered.insert(id);
            let before = open.len();
            let mut size = Size { meshes: u64::from(object.mesh.is_some()), visits: 1 };
            for component in &object.components {
                match sizes.get(&component.object) {
                    Some(part) if part.meshes > 0 => {
                        size.meshes = size.meshes.saturating_add(part.meshes);
                        size.visits = size.visits.saturating_add(part.visits);
                    }
                    Some(_) => {}
                    None if is_new => alloc::push(&mut open, component.object)?,
                    None => {
                        let message = format!("object {} is a component of itself", id.1);
                        return Err(ReadError::malformed(Place::Whole, message));
                    }
                }
            }
            if open.len() == before {
                sizes.insert(id, size);
                open.pop();
            }
        }
    }
    Ok(sizes)
}

/// Returns the matrix that applies `inner` first.
fn product(outer: &Matrix, inner: &Matrix) -> Matrix {
    if *outer == Placement::IDENTITY {
        return *inner;
    }
    outer.map(|row| {
        std::array::from_fn(|column| {
            let sum: f64 = (0..3).map(|k| row[k] * inner[k][column]).sum();
            if column == 3 { sum + row[3] } else { sum }
        })
    })
}

/// Items of a file that builds nothing: its objects that no component names.
fn free_objects(model: &Model) -> Result<Vec<Component>, ReadError> {
    let mut used: BTreeSet<ResourceId> = BTreeSet::new();
    for component in model.objects.values().flat_map(|object| &object.components) {
        used.insert(component.object);
        alloc::check_reserve()?;
    }
    let free = model.objects.keys().filter(|id| !used.contains(id));
    Ok(alloc::gather(free.map(|&object| Component { object, transform: Placement::IDENTITY }))?)
}

fn place_items(mut model: Model, document: &mut Document, budget: &mut Budget) -> Result<(), ReadError> {
    let sizes = object_sizes(&model)?;
    let mut items = std::mem::take(&mut model.items);
    if items.is_empty() && !model.objects.is_empty() {
        document.notes.push(Note::new(Place::Whole, "the file builds no object; all objects are shown"));
        items = free_objects(&model)?;
    }
    let (mut meshes, mut visits) = (0_u64, 0_u64);
    for item in &items {
        let Some(size) = sizes.get(&item.object) else {
            let message = format!("object {} does not exist", item.object.1);
            return Err(ReadError::malformed(Place::Whole, message));
        };
        meshes = meshes.saturating_add(size.meshes);
        visits = visits.saturating_add(size.visits);
    }
    if budget.take_bytes_of::<Placement>(meshes).is_err() || budget.take_bytes_of::<u64>(visits).is_err() {
        let message = format!("components place {meshes} meshes, which is too many for a file of this size");
        return Err(ReadError::new(ReadErrorKind::TooLarge, message));
    }
    let mut places: BTreeMap<ResourceId, u32> = BTreeMap::new();
    let mut open: Vec<(ResourceId, Matrix)> = Vec::new();
    for item in &items {
        alloc::push(&mut open, (item.object, item.transform))?;
        while let Some((id, transform)) = open.pop() {
            alloc::check_reserve()?;
            let Some(object) = model.objects.get_mut(&id) else { continue };
            if let Some(mesh) = object.mesh.take() {
                places.insert(id, document.meshes.len() as u32);
                alloc::push(&mut document.meshes, *mesh)?;
            }
            if let Some(&mesh) = places.get(&id) {
                budget.take_bytes_of::<u8>(object.name.len() as u64)?;
                let placement = Placement { name: object.name.clone(), mesh, transform };
                alloc::push(&mut document.placements, placement)?;
            }
            for component in object.components.iter().rev() {
                if sizes.get(&component.object).is_some_and(|size| size.meshes > 0) {
                    alloc::push(&mut open, (component.object, product(&transform, &component.transform)))?;
                }
            }
        }
    }
    note_objects(&model, document);
    Ok(())
}

fn note_objects(model: &Model, document: &mut Document) {
    let hidden = model.objects.values().filter(|object| object.mesh.is_some()).count();
    if hidden > 0 {
        let text = if hidden == 1 { "1 object is" } else { &format!("{hidden} objects are") };
        document.notes.push(Note::new(Place::Whole, format!("{text} not built and not read")));
    }
    let supports = model.objects.values().filter(|object| object.is_support).count();
    if supports > 0 {
        let text = if supports == 1 { "1 object is" } else { &format!("{supports} objects are") };
        document.notes.push(Note::new(Place::Whole, format!("{text} of a type that supports others during a print")));
    }
}
