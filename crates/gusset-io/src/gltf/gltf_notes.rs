//! Content of a file beyond meshes, counted for the notes.

use crate::error::{Note, Place};
use crate::json_tape::Value;
use std::collections::BTreeSet;

/// Content that the reader leaves out.
#[derive(Default)]
pub(super) struct Unread {
    attributes: BTreeSet<String>,
    pub(super) has_morph_targets: bool,
    pub(super) has_skins: bool,
}

/// Most names of attributes in notes.
const MAX_NAMES: usize = 20;

impl Unread {
    /// Records an attribute of vertices.
    pub(super) fn add_attribute(&mut self, name: &str) {
        if self.attributes.len() < MAX_NAMES && !self.attributes.contains(name) {
            self.attributes.insert(crate::error::printable(name));
        }
    }

    /// Makes the notes.
    pub(super) fn append_notes(&self, root: Value<'_>, notes: &mut Vec<Note>) {
        let mut add = |text: String| notes.push(Note::new(Place::Whole, text));
        for name in &self.attributes {
            add(format!("the vertex attribute {name} is not read"));
        }
        if self.has_morph_targets {
            add("morph targets are not read: meshes have their basic shape".into());
        }
        if self.has_skins {
            add("skins are not read: meshes have the pose of the file".into());
        }
        let has = |name: &str| root.get(name).is_some_and(|list| list.items().next().is_some());
        for name in ["animations", "cameras"] {
            if has(name) {
                add(format!("{name} are not read"));
            }
        }
    }
}
