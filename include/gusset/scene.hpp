// Scenes: nets in groups in groups. Include gusset.hpp, not this.
#ifndef GUSSET_SCENE_HPP
#define GUSSET_SCENE_HPP

#include <gusset/net.hpp>

namespace gusset {

/// What an entry of a scene is.
enum class EntryKind : uint32_t { net = GUSSET_SCENE_NET, group = GUSSET_SCENE_GROUP };

/// An entry of a scene; see gusset_scene_entry_report.
struct Entry {
    /// A net or a group.
    EntryKind kind;
    /// Into the space of the groups that it is in.
    Transform transform;
    /// A group that it is in may hide it all the same.
    bool visible;
    /// The number of entries in a group.
    std::size_t child_count;
};

/// One way to an entry; see gusset_scene_instance.
using Instance = gusset_scene_instance;

/// Nets in groups in groups, at any depth; an entry may be in several groups. Entries are known by indices, which are never given
/// twice. Functions that are const may run at the same time in many threads.
class Scene {
public:
    explicit Scene(gusset_scene *owned) : scene_(owned) {}
    explicit Scene(const Context &context = Context()) {
        gusset_scene *created = nullptr;
        context.call([&](gusset_context *c) { return gusset_scene_create(c, &created); });
        scene_.reset(created);
    }
    /// A scene of the nets between all bridges of a direction that run from side to side, in one group, which is entry 0.
    static Scene unflatten(const Net &net, Direction direction = Direction::down, const Context &context = Context()) {
        gusset_scene *created = nullptr;
        context.call([&](gusset_context *c) {
            return gusset_scene_unflatten_create(c, net.get(), static_cast<gusset_direction>(direction), &created);
        });
        return Scene(created);
    }

    /// Adds a net as it is now, in no group yet; returns its entry.
    uint32_t add(const Net &net, const Context &context = Context()) {
        uint32_t entry = 0;
        context.call([&](gusset_context *c) { return gusset_scene_add_net(c, get(), net.get(), &entry); });
        return entry;
    }
    /// Puts another net in the place of one, as it is now.
    void set_net(uint32_t entry, const Net &net, const Context &context = Context()) {
        context.call([&](gusset_context *c) { return gusset_scene_set_net(c, get(), entry, net.get()); });
    }
    /// Adds an empty group, in no group yet; returns its entry.
    uint32_t add_group(const Context &context = Context()) {
        uint32_t entry = 0;
        context.call([&](gusset_context *c) { return gusset_scene_add_group(c, get(), &entry); });
        return entry;
    }
    /// Puts an entry into a group, behind what is in it.
    void add_child(uint32_t group, uint32_t child, const Context &context = Context()) {
        context.call([&](gusset_context *c) { return gusset_scene_add_child(c, get(), group, child); });
    }
    void remove_child(uint32_t group, uint32_t child, const Context &context = Context()) {
        context.call([&](gusset_context *c) { return gusset_scene_remove_child(c, get(), group, child); });
    }
    /// Removes an entry from the scene and from all groups; what was in a group stays.
    void remove(uint32_t entry, const Context &context = Context()) {
        context.call([&](gusset_context *c) { return gusset_scene_remove(c, get(), entry); });
    }
    void set_transform(uint32_t entry, const Transform &transform, const Context &context = Context()) {
        context.call([&](gusset_context *c) { return gusset_scene_set_transform(c, get(), entry, &transform); });
    }
    void set_visible(uint32_t entry, bool visible, const Context &context = Context()) {
        context.call([&](gusset_context *c) { return gusset_scene_set_visible(c, get(), entry, visible ? 1 : 0); });
    }

    Entry entry(uint32_t entry) const {
        gusset_scene_entry_report found{};
        found.struct_size = sizeof found;
        detail::check(gusset_scene_get_entry(get(), entry, &found));
        return {static_cast<EntryKind>(found.kind), found.transform, found.visible != 0, found.child_count};
    }
    /// The net of an entry, which shares its memory until it is changed.
    Net net(uint32_t entry, const Context &context = Context()) const {
        gusset_net *found = nullptr;
        context.call([&](gusset_context *c) { return gusset_scene_net_create(c, get(), entry, &found); });
        return Net(found);
    }
    /// The entries in a group, in order.
    std::vector<uint32_t> children(uint32_t group, const Context &context = Context()) const {
        return detail::filled<uint32_t>([&](uint32_t *out, std::size_t capacity, std::size_t *written) {
            context.call([&](gusset_context *c) { return gusset_scene_get_children(c, get(), group, out, capacity, written); });
        });
    }
    /// How much is in it.
    gusset_scene_report count() const {
        gusset_scene_report found{};
        found.struct_size = sizeof found;
        detail::check(gusset_scene_get_report(get(), &found));
        return found;
    }
    /// All instances and where they are, each behind the group that it is in.
    std::vector<Instance> instances(const Context &context = Context()) const {
        return detail::filled<Instance>([&](Instance *out, std::size_t capacity, std::size_t *written) {
            context.call([&](gusset_context *c) { return gusset_scene_world_transforms(c, get(), out, capacity, written); });
        });
    }
    /// The nets of all visible instances as one net. options: nothing for each below the one before, with hidden bridges.
    Net flatten(const std::optional<JoinOptions> &options = std::nullopt, const Context &context = Context()) const {
        const gusset_join_options given = detail::as_c(options.value_or(JoinOptions()));
        gusset_net *joined = nullptr;
        context.call([&](gusset_context *c) {
            return gusset_scene_flatten_create(c, get(), options ? &given : nullptr, &joined);
        });
        return Net(joined);
    }

    gusset_scene *get() const noexcept { return scene_.get(); }

private:
    struct Destroy {
        void operator()(gusset_scene *scene) const noexcept { gusset_scene_destroy(scene); }
    };
    std::unique_ptr<gusset_scene, Destroy> scene_;
};

} // namespace gusset

#endif // GUSSET_SCENE_HPP
