//! The arena of a scene: entries with stable indices, and the groups that contain them.
//!
//! Invariant: an entry lists each of its groups as often as the group lists the entry. Edits cost
//! O(children + groups) of the entry.

use super::reachability::VisitMarks;
use crate::Net;
use glam::DAffine3;
use gusset_base::alloc;
use gusset_base::error::{Element, Error, Result};
use gusset_base::sort::sort_distinct;
use gusset_mesh::NONE;
use std::sync::Arc;

/// Nets and groups of them.
#[derive(Debug, Default)]
pub struct Scene {
    pub(super) entries: Vec<Option<SceneEntry>>,
    visit_marks: VisitMarks,
}

#[derive(Debug)]
pub(super) struct SceneEntry {
    pub(super) content: EntryContent,
    /// The transform into the space of its group.
    pub(super) local: DAffine3,
    pub(super) visible: bool,
    /// The groups that contain it, with repetitions, unordered.
    pub(super) parents: Vec<u32>,
}

/// The content of an entry.
#[derive(Debug, Clone)]
pub enum EntryContent {
    /// A net.
    Net(Arc<Net<'static>>),
    /// A group of entries.
    Group(Vec<u32>),
}

/// The changes of an entry; `None` for what stays.
#[derive(Debug, Clone, Default)]
pub struct EntryChanges {
    /// The replacement of the entry's net.
    pub net: Option<Arc<Net<'static>>>,
    /// The transform into the space of its groups.
    pub transform: Option<DAffine3>,
    /// Whether it is shown.
    pub visible: Option<bool>,
}

/// The numbers of elements of a scene.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct SceneCounts {
    /// Entries that are nets.
    pub nets: u32,
    /// Entries that are groups.
    pub groups: u32,
    /// Instances of both, saturating at `u64::MAX`.
    pub instances: u64,
    /// Instances of nets, saturating at `u64::MAX`.
    pub net_instances: u64,
    /// The longest path from a top-level entry, in entries: 1 without children.
    pub levels: u32,
}

impl Scene {
    /// Returns an empty scene.
    pub fn new() -> Self {
        Scene::default()
    }

    /// Returns the entries by their indices; `None` for removed ones.
    pub(super) fn slots(&self) -> &[Option<SceneEntry>] {
        &self.entries
    }

    /// Creates a scene from entries without parents. Children are indices below the number of
    /// entries. If a group contains a removed entry, or itself on any path, the inner error is its
    /// index. O(entries + children).
    pub(super) fn from_entries(entries: Vec<Option<SceneEntry>>) -> Result<Result<Scene, u32>> {
        let mut scene = Scene { entries, visit_marks: VisitMarks::default() };
        for group in 0..scene.entries.len() as u32 {
            scene.visit_marks.add_entry()?;
            for k in 0.. {
                let Some(EntryContent::Group(children)) = scene.slot(group).map(|entry| &entry.content) else { break };
                let Some(&child) = children.get(k) else { break };
                let Some(child) = &mut scene.entries[child as usize] else { return Ok(Err(group)) };
                alloc::push(&mut child.parents, group)?;
            }
        }
        Ok(match scene.find_entry_in_cycle()? {
            Some(entry) => Err(entry),
            None => Ok(scene),
        })
    }

    /// Returns an entry from which a cycle can be left upwards only into the cycle: the first one
    /// that stays after entries without remaining parents are removed one after another.
    fn find_entry_in_cycle(&self) -> Result<Option<u32>> {
        let mut parents_left =
            alloc::collect(self.entries.iter().map(|entry| entry.as_ref().map_or(0, |e| e.parents.len())))?;
        let mut free = alloc::gather((0..self.entries.len()).filter(|&index| parents_left[index] == 0))?;
        while let Some(index) = free.pop() {
            let Some(EntryContent::Group(children)) = self.slot(index as u32).map(|entry| &entry.content) else {
                continue;
            };
            for &child in children {
                parents_left[child as usize] -= 1;
                if parents_left[child as usize] == 0 {
                    alloc::push(&mut free, child as usize)?;
                }
            }
        }
        Ok(parents_left.iter().position(|&left| left > 0).map(|index| index as u32))
    }

    fn slot(&self, index: u32) -> Option<&SceneEntry> {
        self.entries[index as usize].as_ref()
    }

    /// Adds a net, in no group yet. Returns its index, which is never reused.
    ///
    /// # Errors
    /// [`Error::TooLarge`], [`Error::OutOfMemory`].
    pub fn add_net(&mut self, net: Arc<Net<'static>>) -> Result<u32> {
        self.add_entry(EntryContent::Net(net))
    }

    /// Adds an empty group.
    ///
    /// # Errors
    /// [`Error::TooLarge`], [`Error::OutOfMemory`].
    pub fn add_group(&mut self) -> Result<u32> {
        self.add_entry(EntryContent::Group(Vec::new()))
    }

    fn add_entry(&mut self, content: EntryContent) -> Result<u32> {
        let index = self.entries.len();
        Error::check_count("entries", index as u64 + 1, NONE.into())?;
        self.visit_marks.add_entry()?;
        let entry = SceneEntry { content, local: DAffine3::IDENTITY, visible: true, parents: Vec::new() };
        alloc::push(&mut self.entries, Some(entry))?;
        Ok(index as u32)
    }

    /// Appends an entry to a group, possibly again. O(1) if the entry lacks descendants or the
    /// group is in no other group. Otherwise at most O(entries below one or above the other,
    /// whichever are fewer).
    ///
    /// # Errors
    /// [`Error::NoSuch`], [`Error::SceneCycle`], [`Error::OutOfMemory`].
    pub fn add_child(&mut self, group: u32, child: u32) -> Result<()> {
        self.children(group)?;
        self.entry(child)?;
        let Scene { entries, visit_marks: marks } = self;
        let entry = |index: u32| entries[index as usize].as_ref();
        let child_of = |index: u32, k: usize| match &entry(index)?.content {
            EntryContent::Group(children) => children.get(k).copied(),
            EntryContent::Net(_) => None,
        };
        if marks.is_reachable(child, group, child_of, |index, k| entry(index)?.parents.get(k).copied())? {
            return Err(Error::SceneCycle { entry: child });
        }
        alloc::reserve(&mut self.entry_mut(child)?.parents, 1)?;
        if let EntryContent::Group(children) = &mut self.entry_mut(group)?.content {
            alloc::push(children, child)?;
        }
        self.entry_mut(child)?.parents.push(group);
        Ok(())
    }

    /// Removes the first occurrence of an entry from a group. O(children + groups that contain it).
    ///
    /// # Errors
    /// [`Error::NoSuch`], also if the group does not contain it.
    pub fn remove_child(&mut self, group: u32, child: u32) -> Result<()> {
        let at = self.children(group)?.iter().position(|&other| other == child).ok_or(self.no_such_entry(child))?;
        if let EntryContent::Group(children) = &mut self.entry_mut(group)?.content {
            children.remove(at);
        }
        let parents = &mut self.entry_mut(child)?.parents;
        if let Some(at) = parents.iter().position(|&other| other == group) {
            parents.swap_remove(at);
        }
        Ok(())
    }

    /// Removes an entry from the scene and from all groups; the children of a removed group remain.
    /// O(children of its groups + groups of its children).
    ///
    /// # Errors
    /// [`Error::NoSuch`].
    pub fn remove(&mut self, index: u32) -> Result<()> {
        let no_such = self.no_such_entry(index);
        let entry = self.entries.get_mut(index as usize).and_then(Option::take).ok_or(no_such)?;
        let mut groups = entry.parents;
        sort_distinct(&mut groups);
        for group in groups {
            if let EntryContent::Group(children) = &mut self.entry_mut(group)?.content {
                children.retain(|&child| child != index);
            }
        }
        let EntryContent::Group(mut children) = entry.content else { return Ok(()) };
        sort_distinct(&mut children);
        for child in children {
            self.entry_mut(child)?.parents.retain(|&group| group != index);
        }
        Ok(())
    }

    /// Changes an entry. On an error it is unchanged.
    ///
    /// # Errors
    /// Errors of [`Scene::set_net`] and [`Scene::set_transform`].
    pub fn set_entry(&mut self, index: u32, changes: EntryChanges) -> Result<()> {
        self.entry(index)?;
        if changes.net.is_some() {
            self.net(index)?;
        }
        // From here on only the transform may be rejected.
        if let Some(local) = changes.transform {
            self.set_transform(index, local)?;
        }
        if let Some(net) = changes.net {
            self.set_net(index, net)?;
        }
        changes.visible.map_or(Ok(()), |visible| self.set_visible(index, visible))
    }

    /// Sets the transform of an entry into the space of its groups, which must be finite.
    ///
    /// # Errors
    /// [`Error::NoSuch`], [`Error::OptionOutOfRange`].
    pub fn set_transform(&mut self, index: u32, local: DAffine3) -> Result<()> {
        let entry = self.entry_mut(index)?;
        local
            .to_cols_array()
            .into_iter()
            .try_for_each(|value| Error::require(value.is_finite(), "transform", value, "finite"))?;
        entry.local = local;
        Ok(())
    }

    /// Replaces a net. The index, groups and transform of the entry stay.
    ///
    /// # Errors
    /// [`Error::NoSuch`], also for a group.
    pub fn set_net(&mut self, index: u32, net: Arc<Net<'static>>) -> Result<()> {
        self.net(index)?;
        self.entry_mut(index)?.content = EntryContent::Net(net);
        Ok(())
    }

    /// Shows or hides an entry and its descendants.
    ///
    /// # Errors
    /// [`Error::NoSuch`].
    pub fn set_visible(&mut self, index: u32, visible: bool) -> Result<()> {
        self.entry_mut(index)?.visible = visible;
        Ok(())
    }

    /// Returns the transform of an entry into the space of its groups.
    ///
    /// # Errors
    /// [`Error::NoSuch`].
    pub fn transform(&self, index: u32) -> Result<DAffine3> {
        Ok(self.entry(index)?.local)
    }

    /// Returns true if the entry itself is visible. A group that contains it may still hide it.
    ///
    /// # Errors
    /// [`Error::NoSuch`].
    pub fn is_visible(&self, index: u32) -> Result<bool> {
        Ok(self.entry(index)?.visible)
    }

    /// Returns the content of an entry.
    ///
    /// # Errors
    /// [`Error::NoSuch`].
    pub fn content(&self, index: u32) -> Result<&EntryContent> {
        Ok(&self.entry(index)?.content)
    }

    /// Returns a net.
    ///
    /// # Errors
    /// [`Error::NoSuch`], also for a group.
    pub fn net(&self, index: u32) -> Result<&Arc<Net<'static>>> {
        match self.content(index)? {
            EntryContent::Net(net) => Ok(net),
            EntryContent::Group(_) => Err(self.no_such_entry(index)),
        }
    }

    /// Returns the children of a group, in order.
    ///
    /// # Errors
    /// [`Error::NoSuch`], also for a net.
    pub fn children(&self, index: u32) -> Result<&[u32]> {
        match self.content(index)? {
            EntryContent::Group(children) => Ok(children),
            EntryContent::Net(_) => Err(self.no_such_entry(index)),
        }
    }

    /// One more than the largest index ever given.
    pub fn len(&self) -> usize {
        self.entries.len()
    }

    /// Returns true if the scene never had an entry.
    pub fn is_empty(&self) -> bool {
        self.entries.is_empty()
    }

    pub(super) fn entry(&self, index: u32) -> Result<&SceneEntry> {
        self.entries.get(index as usize).and_then(Option::as_ref).ok_or(self.no_such_entry(index))
    }

    fn no_such_entry(&self, index: u32) -> Error {
        Error::NoSuch { element: Element::Entry, index: index.into(), count: self.len() as u64 }
    }

    fn entry_mut(&mut self, index: u32) -> Result<&mut SceneEntry> {
        let no_such = self.no_such_entry(index);
        self.entries.get_mut(index as usize).and_then(Option::as_mut).ok_or(no_such)
    }
}
