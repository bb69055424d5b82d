//! Scenes: nets in groups in groups (paper, "an unlimited number of levels of grouping is allowed").
//!
//! A scene is an arena of entries, nets and groups, each with a transform of its own into the space of the group it is in. An
//! entry may be in several groups, and is then there several times: an instance for each way to it from an entry that is in no
//! group. No group contains itself. Nothing here calls itself, so that a million levels are as good as one.
//!
//! `cycle` keeps groups from containing themselves, `world` finds all instances, `flatten` makes one net of a scene.

mod cycle;
mod flatten;
mod world;

pub use flatten::Flattened;
pub use world::{Instance, MAX_INSTANCES};

use super::Net;
use crate::alloc;
use crate::error::{Element, Error, Result};
use crate::mesh::NONE;
use cycle::Marks;
use glam::DAffine3;
use std::sync::Arc;

/// Nets and groups of them.
#[derive(Debug, Default)]
pub struct Scene {
    entries: Vec<Option<Entry>>,
    marks: Marks,
}

#[derive(Debug)]
struct Entry {
    content: Content,
    /// Into the space of the group that it is in.
    local: DAffine3,
    visible: bool,
    /// The groups that it is in, once for each time; in no order.
    parents: Vec<u32>,
}

/// What an entry is.
#[derive(Debug, Clone)]
pub enum Content {
    /// A net.
    Net(Arc<Net<'static>>),
    /// A group of entries.
    Group(Vec<u32>),
}

/// How much is in a scene.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Counts {
    /// Entries that are nets.
    pub nets: u32,
    /// Entries that are groups.
    pub groups: u32,
    /// Instances of both; `u64::MAX` if there are more.
    pub instances: u64,
    /// Instances of nets; `u64::MAX` if there are more.
    pub net_instances: u64,
    /// The longest way from an entry in no group: 1 if there are no children.
    pub levels: u32,
}

impl Scene {
    /// Without entries.
    pub fn new() -> Self {
        Scene::default()
    }

    /// Adds a net, in no group yet. Its index, which no other entry ever gets.
    ///
    /// # Errors
    /// [`Error::TooLarge`], [`Error::OutOfMemory`].
    pub fn add_net(&mut self, net: Arc<Net<'static>>) -> Result<u32> {
        self.add(Content::Net(net))
    }

    /// Adds an empty group.
    ///
    /// # Errors
    /// [`Error::TooLarge`], [`Error::OutOfMemory`].
    pub fn add_group(&mut self) -> Result<u32> {
        self.add(Content::Group(Vec::new()))
    }

    fn add(&mut self, content: Content) -> Result<u32> {
        let index = self.entries.len();
        if index as u64 >= u64::from(NONE) {
            return Err(Error::TooLarge { what: "entries", count: index as u64 + 1, limit: NONE.into() });
        }
        self.marks.grow()?;
        let entry = Entry { content, local: DAffine3::IDENTITY, visible: true, parents: Vec::new() };
        alloc::push(&mut self.entries, Some(entry))?;
        Ok(index as u32)
    }

    /// Puts an entry into a group, behind what is in it; again, if it is in it already. O(1) for an entry without descendants
    /// or a group in no group; at most O(entries below the one or above the other, whichever are fewer).
    ///
    /// # Errors
    /// [`Error::NoSuch`], [`Error::SceneCycle`], [`Error::OutOfMemory`].
    pub fn add_child(&mut self, group: u32, child: u32) -> Result<()> {
        self.children(group)?;
        self.entry(child)?;
        if self.is_within(group, child)? {
            return Err(Error::SceneCycle { entry: child });
        }
        alloc::reserve(&mut self.entry_mut(child)?.parents, 1)?;
        if let Content::Group(children) = &mut self.entry_mut(group)?.content {
            alloc::push(children, child)?;
        }
        self.entry_mut(child)?.parents.push(group);
        Ok(())
    }

    /// Takes an entry out of a group: the first one, if it is in it several times. O(children + groups that it is in).
    ///
    /// # Errors
    /// [`Error::NoSuch`], also if it is not in the group.
    pub fn remove_child(&mut self, group: u32, child: u32) -> Result<()> {
        let no_such = Error::NoSuch { element: Element::Entry, index: child.into() };
        let at = self.children(group)?.iter().position(|&other| other == child).ok_or(no_such)?;
        if let Content::Group(children) = &mut self.entry_mut(group)?.content {
            children.remove(at);
        }
        let parents = &mut self.entry_mut(child)?.parents;
        if let Some(at) = parents.iter().position(|&other| other == group) {
            parents.swap_remove(at);
        }
        Ok(())
    }

    /// Removes an entry from the scene and from all groups. What was in a group is then in one group fewer. O(children of its
    /// groups + groups of its children).
    ///
    /// # Errors
    /// [`Error::NoSuch`].
    pub fn remove(&mut self, index: u32) -> Result<()> {
        let no_such = Error::NoSuch { element: Element::Entry, index: index.into() };
        let entry = self.entries.get_mut(index as usize).and_then(Option::take).ok_or(no_such)?;
        let mut groups = entry.parents;
        groups.sort_unstable();
        groups.dedup();
        for group in groups {
            if let Content::Group(children) = &mut self.entry_mut(group)?.content {
                children.retain(|&child| child != index);
            }
        }
        let Content::Group(mut children) = entry.content else { return Ok(()) };
        children.sort_unstable();
        children.dedup();
        for child in children {
            self.entry_mut(child)?.parents.retain(|&group| group != index);
        }
        Ok(())
    }

    /// Places an entry in the space of the groups that it is in. Finite, or the transform is refused.
    ///
    /// # Errors
    /// [`Error::NoSuch`], [`Error::OptionOutOfRange`].
    pub fn set_transform(&mut self, index: u32, local: DAffine3) -> Result<()> {
        let entry = self.entry_mut(index)?;
        if let Some(&value) = local.to_cols_array().iter().find(|value| !value.is_finite()) {
            return Err(Error::OptionOutOfRange { option: "transform", value });
        }
        entry.local = local;
        Ok(())
    }

    /// Puts another net in the place of one: it keeps its index, its groups and its transform.
    ///
    /// # Errors
    /// [`Error::NoSuch`], also for a group.
    pub fn set_net(&mut self, index: u32, net: Arc<Net<'static>>) -> Result<()> {
        match &mut self.entry_mut(index)?.content {
            Content::Net(place) => *place = net,
            Content::Group(_) => return Err(Error::NoSuch { element: Element::Entry, index: index.into() }),
        }
        Ok(())
    }

    /// Shows an entry, or hides it and all that is in it.
    ///
    /// # Errors
    /// [`Error::NoSuch`].
    pub fn set_visible(&mut self, index: u32, visible: bool) -> Result<()> {
        self.entry_mut(index)?.visible = visible;
        Ok(())
    }

    /// Where an entry is in the space of its groups.
    ///
    /// # Errors
    /// [`Error::NoSuch`].
    pub fn transform(&self, index: u32) -> Result<DAffine3> {
        Ok(self.entry(index)?.local)
    }

    /// True if the entry is shown; a group that it is in may still hide it.
    ///
    /// # Errors
    /// [`Error::NoSuch`].
    pub fn is_visible(&self, index: u32) -> Result<bool> {
        Ok(self.entry(index)?.visible)
    }

    /// What an entry is.
    ///
    /// # Errors
    /// [`Error::NoSuch`].
    pub fn content(&self, index: u32) -> Result<&Content> {
        Ok(&self.entry(index)?.content)
    }

    /// A net.
    ///
    /// # Errors
    /// [`Error::NoSuch`], also for a group.
    pub fn net(&self, index: u32) -> Result<&Arc<Net<'static>>> {
        match self.content(index)? {
            Content::Net(net) => Ok(net),
            Content::Group(_) => Err(Error::NoSuch { element: Element::Entry, index: index.into() }),
        }
    }

    /// What is in a group, in order.
    ///
    /// # Errors
    /// [`Error::NoSuch`], also for a net.
    pub fn children(&self, index: u32) -> Result<&[u32]> {
        match self.content(index)? {
            Content::Group(children) => Ok(children),
            Content::Net(_) => Err(Error::NoSuch { element: Element::Entry, index: index.into() }),
        }
    }

    /// One more than the largest index that an entry ever had.
    pub fn len(&self) -> usize {
        self.entries.len()
    }

    /// True if nothing was ever added.
    pub fn is_empty(&self) -> bool {
        self.entries.is_empty()
    }

    fn entry(&self, index: u32) -> Result<&Entry> {
        let no_such = Error::NoSuch { element: Element::Entry, index: index.into() };
        self.entries.get(index as usize).and_then(Option::as_ref).ok_or(no_such)
    }

    fn entry_mut(&mut self, index: u32) -> Result<&mut Entry> {
        let no_such = Error::NoSuch { element: Element::Entry, index: index.into() };
        self.entries.get_mut(index as usize).and_then(Option::as_mut).ok_or(no_such)
    }
}
