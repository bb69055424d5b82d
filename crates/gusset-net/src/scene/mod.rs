//! Scenes: nets in nested groups (Deryagin, "an unlimited number of levels of grouping is
//! allowed").
//!
//! A scene is an arena of entries, nets and groups, each with a local transform into the space of
//! its group. An entry in several groups has several instances, one for each path to it from a
//! top-level entry. Invariant: the graph of groups is acyclic. Nothing recurses, so that a million
//! levels work as well as one.
//!
//! `arena` holds the entries, `reachability` detects cycles, `instances` lists instances, `flatten`
//! joins a scene into one net, `transfer` writes and reads scenes as bytes.

mod arena;
mod flatten;
mod instances;
mod reachability;
mod transfer;

pub use arena::{EntryChanges, EntryContent, Scene, SceneCounts};
pub use instances::{Instance, MAX_INSTANCES};
pub use transfer::{decode_scene_within, encode_scene};
