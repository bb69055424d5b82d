//! Instances of a scene and their transforms, counted in topological order and listed depth first.
//! O(entries + children) and O(instances).

use super::arena::{EntryContent, Scene, SceneCounts, SceneEntry};
use glam::DAffine3;
use gusset_base::alloc;
use gusset_base::error::{Error, Result};
use gusset_base::job::Job;
use gusset_mesh::NONE;

/// The largest number of instances that are listed, at 112 bytes each.
pub const MAX_INSTANCES: u64 = 1 << 24;

/// A path to an entry from a top-level entry.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Instance {
    /// The entry.
    pub entry: u32,
    /// The instance of its group, or `u32::MAX` at the top level.
    pub parent: u32,
    /// False if the entry or a group on the path is hidden.
    pub visible: bool,
    /// The transform into the space of the scene: the composition of the transforms on the path.
    pub world: DAffine3,
}

impl Scene {
    /// Returns the numbers of elements. O(entries + children).
    ///
    /// # Errors
    /// [`Error::OutOfMemory`].
    pub fn count_elements(&self) -> Result<SceneCounts> {
        let mut pending =
            alloc::collect(self.entries.iter().map(|entry| entry.as_ref().map_or(0, |e| e.parents.len())))?;
        let mut paths = alloc::filled(0u64, self.entries.len())?;
        let mut levels = alloc::filled(0u32, self.entries.len())?;
        let mut counts = SceneCounts::default();
        let mut ready = Vec::new();
        for (index, _) in self.root_entries() {
            (paths[index as usize], levels[index as usize]) = (1, 1);
            alloc::push(&mut ready, index)?;
        }
        // Each entry follows all groups that contain it.
        while let Some(index) = ready.pop() {
            let (here, level) = (paths[index as usize], levels[index as usize]);
            counts.instances = counts.instances.saturating_add(here);
            counts.levels = counts.levels.max(level);
            match self.content(index)? {
                EntryContent::Net(_) => {
                    counts.nets += 1;
                    counts.net_instances = counts.net_instances.saturating_add(here);
                }
                EntryContent::Group(children) => {
                    counts.groups += 1;
                    for &child in children {
                        let child = child as usize;
                        paths[child] = paths[child].saturating_add(here);
                        levels[child] = levels[child].max(level + 1);
                        pending[child] -= 1;
                        if pending[child] == 0 {
                            alloc::push(&mut ready, child as u32)?;
                        }
                    }
                }
            }
        }
        Ok(counts)
    }

    /// Returns the number of instances. O(entries + children).
    ///
    /// # Errors
    /// [`Error::TooLarge`] for more than [`MAX_INSTANCES`], [`Error::OutOfMemory`].
    pub fn instance_count(&self) -> Result<usize> {
        let count = self.count_elements()?.instances;
        Error::check_count("instances", count, MAX_INSTANCES)?;
        Ok(count as usize)
    }

    /// Returns all instances, each after its group, children in order. O(instances).
    ///
    /// # Errors
    /// [`Error::TooLarge`] for more than [`MAX_INSTANCES`], before any is listed;
    /// [`Error::OutOfMemory`], [`Error::Cancelled`].
    pub fn instances(&self, job: &Job<'_>) -> Result<Vec<Instance>> {
        let count = self.instance_count()?;
        let mut instances: Vec<Instance> = alloc::with_capacity(count)?;
        let mut open = Vec::new();
        for (root, _) in self.root_entries() {
            alloc::push(&mut open, (root, NONE))?;
            while let Some((index, parent)) = open.pop() {
                job.step_every(1 << 16, instances.len(), count, "finding instances")?;
                let entry = self.entry(index)?;
                let (world, visible) = match instances.get(parent as usize) {
                    Some(group) => (group.world * entry.local, group.visible && entry.visible),
                    None => (entry.local, entry.visible),
                };
                let here = instances.len() as u32;
                instances.push(Instance { entry: index, parent, visible, world });
                if let EntryContent::Group(children) = &entry.content {
                    alloc::reserve(&mut open, children.len())?;
                    open.extend(children.iter().rev().map(|&child| (child, here)));
                }
            }
        }
        Ok(instances)
    }

    /// Returns the entries in no group.
    fn root_entries(&self) -> impl Iterator<Item = (u32, &SceneEntry)> {
        let entries = (0..).zip(&self.entries).filter_map(|(index, entry)| Some((index, entry.as_ref()?)));
        entries.filter(|(_, entry)| entry.parents.is_empty())
    }
}
