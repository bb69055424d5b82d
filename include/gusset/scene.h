/* Generated from src/capi; do not edit. See gusset.h. */

#ifndef GUSSET_SCENE_H
#define GUSSET_SCENE_H

#include "base.h"
#include "net.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ------------------------------------------------------------------------------------------------------------------ */
/* Scenes: Nets in nested groups. */

/// What an entry of a scene is.
typedef uint32_t gusset_scene_entry_kind;
/// A net.
#define GUSSET_SCENE_NET 0
/// A group of entries.
#define GUSSET_SCENE_GROUP 1

/// Nets in groups in groups, at any depth; an entry may be in several groups. Entries are known by indices, which are
/// never given twice. Functions that take it as const may run at the same time in many threads; those that change it
/// need it for themselves.
typedef struct gusset_scene gusset_scene;

/// An entry of a scene.
typedef struct gusset_scene_entry_report {
    size_t struct_size;
    /// Into the space of the groups that it is in.
    struct gusset_transform transform;
    /// The number of entries in a group; 0 for a net.
    size_t child_count;
    /// GUSSET_SCENE_NET or GUSSET_SCENE_GROUP.
    gusset_scene_entry_kind kind;
    /// 1 if it is shown; a group that it is in may hide it all the same.
    uint32_t visible;
} gusset_scene_entry_report;

/// How much is in a scene.
typedef struct gusset_scene_report {
    size_t struct_size;
    /// Instances of nets and groups: ways from entries in no group; UINT64_MAX if there are more.
    uint64_t instances;
    /// Instances of nets alone.
    uint64_t net_instances;
    /// Entries that are nets.
    uint32_t nets;
    /// Entries that are groups.
    uint32_t groups;
    /// The longest way from an entry in no group: 1 if no group has entries, 0 for an empty scene.
    uint32_t levels;
    uint32_t reserved;
} gusset_scene_report;

/// Makes an empty scene.
/// @complexity O(1).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_scene_create(const struct gusset_context *context,
    struct gusset_scene **scene);

/// Destroys a scene; NULL is allowed.
GUSSET_API void gusset_scene_destroy(struct gusset_scene *scene);

/// Adds a net as it is now, or an empty group, in no group yet. Later changes of the handle of the net do not change
/// the scene.
/// @param net the net; NULL for a group.
/// @param entry receives its index.
/// @errors TOO_LARGE
/// @complexity O(1), and O(nodes) for a net in the caller's memory.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_scene_add(const struct gusset_context *context,
    struct gusset_scene *scene, const struct gusset_net *net, uint32_t *entry);

/// Puts an entry into a group, behind what is in it; again, if it is in it already.
/// @param group the index of the group.
/// @param child the index of the entry.
/// @errors NO_SUCH_ELEMENT (no such entry, or group is a net), SCENE_CYCLE
/// @complexity O(1) for an entry without children or a group in no group; at most O(entries below the one or above the
///     other, whichever are fewer).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_scene_add_child(const struct gusset_context *context,
    struct gusset_scene *scene, uint32_t group, uint32_t child);

/// Takes an entry out of a group: the first one, if it is in it several times.
/// @param group the index of the group.
/// @param child the index of the entry.
/// @errors NO_SUCH_ELEMENT (if it is not in the group)
/// @complexity O(children of the group + groups of the child).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_scene_remove_child(const struct gusset_context *context,
    struct gusset_scene *scene, uint32_t group, uint32_t child);

/// Removes an entry from the scene and from all groups; what was in a group stays.
/// @param entry its index.
/// @errors NO_SUCH_ELEMENT
/// @complexity O(children of its groups + groups of its children).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_scene_remove(const struct gusset_context *context,
    struct gusset_scene *scene, uint32_t entry);

/// A change of the visibility of an entry.
typedef uint32_t gusset_visibility;
/// None.
#define GUSSET_VISIBILITY_KEEP 0
/// To visible.
#define GUSSET_VISIBILITY_SHOW 1
/// To hidden, with all that is in the entry.
#define GUSSET_VISIBILITY_HIDE 2

/// The changes of an entry of a scene. All zeros: none.
typedef struct gusset_scene_changes {
    size_t struct_size;
    /// The net that replaces the one of the entry, as it is now; NULL: it stays. The entry keeps its index, its groups
    /// and its transform.
    const struct gusset_net *net;
    /// The place of the entry in the space of the groups that it is in, twelve finite numbers; NULL: it stays.
    const struct gusset_transform *transform;
    gusset_visibility visibility;
    uint32_t reserved;
} gusset_scene_changes;

/// Changes an entry: its net, its transform, its visibility. On failure the entry is as it was.
/// @param entry its index.
/// @param changes what changes.
/// @errors UNKNOWN_VALUE (visibility), NO_SUCH_ELEMENT (with the entry (also for a net in place of a group)),
///     OUT_OF_RANGE (the transform)
/// @complexity O(1), and O(nodes) for a net in the caller's memory.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_scene_set_entry(const struct gusset_context *context,
    struct gusset_scene *scene, uint32_t entry, const struct gusset_scene_changes *changes);

/// What an entry is.
/// @param entry its index.
/// @param report its struct_size set.
/// @errors NO_SUCH_ELEMENT
/// @complexity O(1).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_scene_get_entry(const struct gusset_scene *scene, uint32_t entry,
    struct gusset_scene_entry_report *report);

/// The net of an entry, as a handle that shares its memory until it is changed.
/// @param entry its index.
/// @errors NO_SUCH_ELEMENT (for a group)
/// @complexity O(1).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_scene_net_create(const struct gusset_context *context,
    const struct gusset_scene *scene, uint32_t entry, struct gusset_net **net);

/// The entries in a group, in order.
/// @param group its index.
/// @param children room for capacity indices, or NULL with capacity 0 to ask for their number.
/// @param capacity see children.
/// @param written receives it.
/// @errors NO_SUCH_ELEMENT (for a net), BUFFER_TOO_SMALL
/// @complexity O(children).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_scene_get_children(const struct gusset_context *context,
    const struct gusset_scene *scene, uint32_t group, uint32_t *children, size_t capacity, size_t *written);

/// How much is in a scene.
/// @param report its struct_size set.
/// @complexity O(entries + children), however many instances there are.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_scene_get_report(const struct gusset_scene *scene,
    struct gusset_scene_report *report);

/* ------------------------------------------------------------------------------------------------------------------ */
/* Visible nets of a scene: Where each net of a scene is in the world, and all of them as one net. */

/// One way to an entry from an entry in no group.
typedef struct gusset_scene_instance {
    /// Into the space of the scene.
    struct gusset_transform world;
    /// The entry.
    uint32_t entry;
    /// The instance of the group that it is in, by its place in the list; UINT32_MAX if it is in none.
    uint32_t parent;
    /// 1 unless it or a group on the way is hidden.
    uint32_t visible;
    uint32_t reserved;
} gusset_scene_instance;

/// All instances and where they are: each behind the group that it is in, children in order.
/// @param instances room for capacity of them, or NULL with capacity 0 to ask for their number.
/// @param capacity see instances.
/// @param written receives it.
/// @errors BUFFER_TOO_SMALL, TOO_LARGE (more than 2^24, as sharing can make of few entries: refused before any is
///     looked at)
/// @complexity O(entries + instances).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_scene_world_transforms(const struct gusset_context *context,
    const struct gusset_scene *scene, struct gusset_scene_instance *instances, size_t capacity, size_t *written);

/// Joins the nets of all visible instances, where they are in the space of the scene, to one. Nets under transforms
/// that mirror are flipped where the others would be opposed to them, as if options said turn.
/// gusset_scene_unflatten_create is the inverse.
/// @param options NULL for each net below the one before, with hidden bridges.
/// @errors EMPTY_SCENE (no visible net), TOO_LARGE (more than 2^24 instances, or nodes), as
///     gusset_net_concatenate_create
/// @complexity O(entries + instances + nodes).
/// @source Deryagin, scenes as "a single whole".
GUSSET_API GUSSET_MUST_USE gusset_status gusset_scene_flatten_create(const struct gusset_context *context,
    const struct gusset_scene *scene, const struct gusset_concatenate_options *options, struct gusset_net **net);

/// A scene of the nets between the bridges of a direction that run from side to side and were made last, all at once:
/// the inverse of gusset_scene_flatten_create, in one group (entry 0). Nets come back as they are in the space of the
/// flat one, bit for bit; copies that were made to equalise sizes are removed.
/// @param direction that of the bridges.
/// @errors CROSSING_CELL
/// @complexity O(nodes).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_scene_unflatten_create(const struct gusset_context *context,
    const struct gusset_net *net, gusset_direction direction, struct gusset_scene **scene);

#ifdef __cplusplus
}
#endif

#endif /* GUSSET_SCENE_H */
