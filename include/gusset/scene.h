/* Generated from src/capi; see gusset.h. */

#ifndef GUSSET_SCENE_H
#define GUSSET_SCENE_H
#include "base.h"
#include "net.h"

#ifdef __cplusplus
extern "C" {
#endif

/*** Scenes. Parameters called entry, group and child are indices of entries. */

typedef uint32_t gusset_scene_entry_kind;
/// Net.
#define GUSSET_SCENE_NET 0
/// Group of entries.
#define GUSSET_SCENE_GROUP 1

/// Nets in nested groups. Entries may belong to several groups; indices are never reused.
typedef struct gusset_scene gusset_scene;

/// Entry of a scene.
typedef struct gusset_scene_entry_report {
    size_t struct_size;
    /// Map into its groups' space.
    struct gusset_transform transform;
    /// Entries in a group; 0 for a net.
    size_t child_count;
    gusset_scene_entry_kind kind;
    /// 1: shown, unless an enclosing group is hidden.
    uint32_t visible;
} gusset_scene_entry_report;

/// Size of a scene. Top-level entries are outside all groups.
typedef struct gusset_scene_report {
    size_t struct_size;
    /// Paths from top-level entries; at most UINT64_MAX.
    uint64_t instances;
    /// Instances of nets.
    uint64_t net_instances;
    /// Entries that are nets.
    uint32_t nets;
    /// Entries that are groups.
    uint32_t groups;
    /// Entries of the longest path; 0 if empty.
    uint32_t levels;
    uint32_t reserved;
} gusset_scene_report;

/// Makes an empty scene.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_scene_create(const struct gusset_context *context,
    struct gusset_scene **scene);

GUSSET_API void gusset_scene_destroy(struct gusset_scene *scene);

/// Adds a net, as it is now, or an empty group, at top level.
/// @param net NULL adds a group.
/// @param entry its index.
/// @complexity O(1); O(nodes) for a net in the caller's memory.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_scene_add(const struct gusset_context *context,
    struct gusset_scene *scene, const struct gusset_net *net, uint32_t *entry);

/// Appends an entry to a group, perhaps repeatedly.
/// @errors NO_SUCH_ELEMENT (also if group is a net), SCENE_CYCLE
/// @complexity O(1) for a child without children or a top-level group, else O(the fewer of entries below child and
///     above group).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_scene_add_child(const struct gusset_context *context,
    struct gusset_scene *scene, uint32_t group, uint32_t child);

/// Removes the first occurrence of an entry from a group.
/// @errors NO_SUCH_ELEMENT (also if child is not in the group)
/// @complexity O(children of the group + groups of the child).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_scene_remove_child(const struct gusset_context *context,
    struct gusset_scene *scene, uint32_t group, uint32_t child);

/// Removes an entry and its places in groups; its children stay.
/// @errors NO_SUCH_ELEMENT
/// @complexity O(children of its groups + groups of its children).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_scene_remove(const struct gusset_context *context,
    struct gusset_scene *scene, uint32_t entry);

typedef uint32_t gusset_visibility;
/// No change.
#define GUSSET_VISIBILITY_KEEP 0
/// Shows the entry.
#define GUSSET_VISIBILITY_SHOW 1
/// Hides the entry and its children.
#define GUSSET_VISIBILITY_HIDE 2

/// Changes of an entry. Default: none.
typedef struct gusset_scene_changes {
    size_t struct_size;
    /// New net, as it is now; NULL: no change.
    const struct gusset_net *net;
    /// New map into its groups' space; NULL: no change.
    const struct gusset_transform *transform;
    gusset_visibility visibility;
    uint32_t reserved;
} gusset_scene_changes;

/// Changes the net, transform or visibility of an entry.
/// @errors NO_SUCH_ELEMENT (also if a group would get a net), OUT_OF_RANGE (transform)
/// @complexity O(1); O(nodes) for a net in the caller's memory.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_scene_set_entry(const struct gusset_context *context,
    struct gusset_scene *scene, uint32_t entry, const struct gusset_scene_changes *changes);

/// Describes an entry.
/// @errors NO_SUCH_ELEMENT
GUSSET_API GUSSET_MUST_USE gusset_status gusset_scene_get_entry(const struct gusset_scene *scene, uint32_t entry,
    struct gusset_scene_entry_report *report);

/// Makes a handle of an entry's net, which shares memory until changed.
/// @errors NO_SUCH_ELEMENT (also for a group)
GUSSET_API GUSSET_MUST_USE gusset_status gusset_scene_net_create(const struct gusset_context *context,
    const struct gusset_scene *scene, uint32_t entry, struct gusset_net **net);

/// Writes the entries of a group, in order.
/// @errors NO_SUCH_ELEMENT (also for a net)
/// @complexity O(children).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_scene_get_children(const struct gusset_context *context,
    const struct gusset_scene *scene, uint32_t group, uint32_t *children, size_t capacity, size_t *written);

/// Counts the contents.
/// @complexity O(entries + children).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_scene_get_report(const struct gusset_scene *scene,
    struct gusset_scene_report *report);

/*** Visible nets of a scene */

/// Path from top level to an entry.
typedef struct gusset_scene_instance {
    /// Map into the scene's space.
    struct gusset_transform world;
    /// The entry.
    uint32_t entry;
    /// Instance of the enclosing group, or UINT32_MAX.
    uint32_t parent;
    /// 1 unless the entry or an enclosing group is hidden.
    uint32_t visible;
    uint32_t reserved;
} gusset_scene_instance;

/// Writes all instances: each after its group, children in order.
/// @errors TOO_LARGE (more than 2^24 instances)
/// @complexity O(entries + instances).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_scene_world_transforms(const struct gusset_context *context,
    const struct gusset_scene *scene, struct gusset_scene_instance *instances, size_t capacity, size_t *written);

/// Joins all visible nets into one, in the scene's space.
/// Mirrored nets are flipped: turn counts as 1. gusset_scene_unflatten_create is the inverse.
/// @param options NULL: nets from top to bottom, with hidden bridges.
/// @errors EMPTY_SCENE (no visible net), TOO_LARGE (more than 2^24 instances, or nodes), as
///     gusset_net_concatenate_create
/// @complexity O(entries + instances + nodes).
/// @source Deryagin, scenes as "a single whole".
GUSSET_API GUSSET_MUST_USE gusset_status gusset_scene_flatten_create(const struct gusset_context *context,
    const struct gusset_scene *scene, const struct gusset_concatenate_options *options, struct gusset_net **net);

/// Splits a net at the last-made bridges of a direction from side to side, into one group, entry 0.
/// Parts keep their bits in net's space; copies that equalised sizes are removed.
/// @errors CROSSING_CELL
/// @complexity O(nodes).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_scene_unflatten_create(const struct gusset_context *context,
    const struct gusset_net *net, gusset_direction direction, struct gusset_scene **scene);

/*** Scenes as bytes */

struct gusset_stream;

struct gusset_stream_options;

/// Encodes a scene as a stream: entries with their indices, groups, transforms and visibility, and each distinct net
/// once.
/// @param options of gusset_net_encode_create, for each net.
/// @errors as gusset_net_encode_create
/// @complexity O(nodes + entries + children), parallel by blocks of nets.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_scene_encode_create(const struct gusset_context *context,
    const struct gusset_scene *scene, const struct gusset_stream_options *options, struct gusset_stream **stream);

/// Decodes the stream of a scene. Entries keep their indices; shared nets stay shared.
/// Damaged and malicious streams do no harm: memory is at most 4096 nodes, or 96 KiB, a byte.
/// @param data the whole stream.
/// @param node_limit most nodes of all nets together; 0: no limit.
/// @errors BAD_STREAM (byte)
/// @complexity O(nodes + entries + children), parallel by blocks of nets.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_scene_decode_create(const struct gusset_context *context,
    const void *data, size_t size, uint64_t node_limit, struct gusset_scene **scene);

#ifdef __cplusplus
}
#endif
#endif
