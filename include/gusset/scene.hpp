/// @file
/// Scenes: nets in nested groups. Include gusset.hpp, not this.
#ifndef GUSSET_SCENE_HPP
#define GUSSET_SCENE_HPP

#include <gusset/net.hpp>

namespace gusset {

/// An entry of a scene; see gusset_scene_entry_report.
struct SceneEntry {
    /// A net or a group.
    SceneEntryKind kind;
    /// From its own space to the space of its groups.
    Transform transform;
    /// Its groups may hide it all the same.
    bool visible;
    /// The number of entries in a group.
    std::size_t child_count;
};

/// One path to an entry; see gusset_scene_instance.
using SceneInstance = gusset_scene_instance;

/// Nets in groups, nested at any depth; an entry may be in several groups. Entries are known by
/// indices, which are never given twice. Functions that are const may run at the same time in many
/// threads.
class Scene {
public:
    /// Takes ownership of a handle of the C interface.
    explicit Scene(gusset_scene *owned) : scene_(owned) {}
    /// See ::gusset_scene_create.
    explicit Scene(const Context &context = Context()) : scene_(context.result(gusset_scene_create)) {}
    /// A scene of the nets between all bridges of a direction that run from side to side, in one
    /// group, which is entry 0.
    static Scene unflatten(const Net &net, Direction direction = Direction::down, const Context &context = Context()) {
        return Scene(context.result(gusset_scene_unflatten_create, net.get(),
                                    static_cast<gusset_direction>(direction)));
    }

    /// Adds a net as it is now, in no group yet; returns its entry.
    uint32_t add(const Net &net, const Context &context = Context()) {
        return context.result(gusset_scene_add, get(), net.get());
    }
    /// Replaces a net by another as it is now.
    void set_net(uint32_t entry, const Net &net, const Context &context = Context()) {
        auto given = detail::sized<gusset_scene_changes>();
        given.net = net.get();
        context.call(gusset_scene_set_entry, get(), entry, &given);
    }
    /// Adds an empty group, in no group yet; returns its entry.
    uint32_t add_group(const Context &context = Context()) {
        return context.result(gusset_scene_add, get(), nullptr);
    }
    /// Appends an entry to a group.
    void add_child(uint32_t group, uint32_t child, const Context &context = Context()) {
        context.call(gusset_scene_add_child, get(), group, child);
    }
    /// See ::gusset_scene_remove_child.
    void remove_child(uint32_t group, uint32_t child, const Context &context = Context()) {
        context.call(gusset_scene_remove_child, get(), group, child);
    }
    /// Removes an entry from the scene and from all groups. The entries of a removed group stay.
    void remove(uint32_t entry, const Context &context = Context()) {
        context.call(gusset_scene_remove, get(), entry);
    }
    /// See ::gusset_scene_set_entry.
    void set_transform(uint32_t entry, const Transform &transform, const Context &context = Context()) {
        auto given = detail::sized<gusset_scene_changes>();
        given.transform = &transform;
        context.call(gusset_scene_set_entry, get(), entry, &given);
    }
    /// See ::gusset_scene_set_entry.
    void set_visible(uint32_t entry, bool visible, const Context &context = Context()) {
        auto given = detail::sized<gusset_scene_changes>();
        given.visibility = visible ? GUSSET_VISIBILITY_SHOW : GUSSET_VISIBILITY_HIDE;
        context.call(gusset_scene_set_entry, get(), entry, &given);
    }

    /// See ::gusset_scene_get_entry.
    SceneEntry entry(uint32_t entry) const {
        const gusset_scene_entry_report found = detail::lent(gusset_scene_get_entry, get(), entry);
        return {static_cast<SceneEntryKind>(found.kind), found.transform, found.visible != 0, found.child_count};
    }
    /// The net of an entry. It shares memory until it is changed.
    Net net(uint32_t entry, const Context &context = Context()) const {
        return Net(context.result(gusset_scene_net_create, get(), entry));
    }
    /// The entries in a group, in order.
    std::vector<uint32_t> children(uint32_t group, const Context &context = Context()) const {
        return detail::filled<uint32_t>([&](uint32_t *out, std::size_t capacity, std::size_t *written) {
            context.call(gusset_scene_get_children, get(), group, out, capacity, written);
        });
    }
    /// Its numbers of entries.
    gusset_scene_report report() const { return detail::lent(gusset_scene_get_report, get()); }
    /// All instances and their transforms to world space, each after its group.
    std::vector<SceneInstance> instances(const Context &context = Context()) const {
        return detail::filled<SceneInstance>([&](SceneInstance *out, std::size_t capacity, std::size_t *written) {
            context.call(gusset_scene_world_transforms, get(), out, capacity, written);
        });
    }
    /// The nets of all visible instances as one net. `options`: empty for each net below the one
    /// before, with hidden bridges.
    Net flatten(const std::optional<ConcatenateOptions> &options = std::nullopt, const Context &context = Context()) const {
        const gusset_concatenate_options given = detail::as_c(options.value_or(ConcatenateOptions()));
        return Net(context.result(gusset_scene_flatten_create, get(), options ? &given : nullptr));
    }

    /// The argument for the C interface, which this still owns.
    gusset_scene *get() const noexcept { return scene_.get(); }

private:
    detail::Handle<gusset_scene, gusset_scene_destroy> scene_;
};

} // namespace gusset

#endif // GUSSET_SCENE_HPP
