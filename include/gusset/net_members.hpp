// The longer functions of Net, and concatenate. Included by net.hpp.
#ifndef GUSSET_NET_MEMBERS_HPP
#define GUSSET_NET_MEMBERS_HPP

#include <gusset/net.hpp>

namespace gusset {

inline Decimated Net::decimated(double tolerance, const Context &context) const {
    std::vector<uint32_t> kept_rows(rows()), kept_columns(columns());
    double deviation = 0.0;
    Net net = made(context, [&](gusset_context *c, gusset_net **out) {
        return gusset_net_decimate_create(c, get(), tolerance, kept_rows.data(), kept_columns.data(), &deviation, out);
    });
    kept_rows.resize(net.rows());
    kept_columns.resize(net.columns());
    return {std::move(net), std::move(kept_rows), std::move(kept_columns), deviation};
}

inline std::vector<Net> Net::pyramid(Interpolation interpolation, const Context &context) const {
    std::array<gusset_net *, GUSSET_PYRAMID_LEVELS> levels{};
    std::size_t count = 0;
    std::vector<Net> nets;
    nets.reserve(levels.size()); // So that nothing throws once there are nets to own.
    context.call([&](gusset_context *c) {
        return gusset_net_pyramid_create(c, get(), static_cast<gusset_interpolation>(interpolation), levels.data(),
                                         levels.size(), &count);
    });
    for (std::size_t i = 0; i < count; ++i) {
        nets.emplace_back(levels[i]);
    }
    return nets;
}

inline Bridge Net::bridge(std::size_t index) const {
    gusset_bridge found{};
    found.struct_size = sizeof found;
    detail::check(gusset_net_get_bridge(get(), index, &found));
    return {static_cast<Direction>(found.direction), found.at,        found.start,
            found.end,                               static_cast<BridgeKind>(found.kind),
            static_cast<BridgeMode>(found.mode),     found.properties};
}

inline std::pair<Net, Net> Net::split(std::size_t bridge, const Context &context) const {
    gusset_net *first = nullptr, *second = nullptr;
    context.call([&](gusset_context *c) { return gusset_net_split_create(c, get(), bridge, &first, &second); });
    return {Net(first), Net(second)};
}

inline Planarity Net::planarity(double tolerance, const Context &context) const {
    const gusset_net_view arrays = view();
    Planarity found{};
    found.summary.struct_size = sizeof found.summary;
    found.cells.resize((arrays.rows - 1) * (arrays.columns - 1));
    std::size_t written = 0;
    context.call([&](gusset_context *c) {
        return gusset_net_planarity(c, get(), tolerance, found.cells.data(), found.cells.size(), &written, &found.summary);
    });
    return found;
}

template <class T>
Normals<T> Net::normals(const Context &context) const {
    require<T>(view());
    const std::size_t count = node_count();
    Normals<T> found{std::vector<T>(count), std::vector<T>(count), std::vector<T>(count)};
    context.call([&](gusset_context *c) {
        return gusset_net_normals(c, get(), found.x.data(), found.y.data(), found.z.data(), count, &found.without);
    });
    return found;
}

namespace detail {
/// The caller's function, and what it threw.
template <class T>
struct MoveNodesHost {
    const Net::MoveNodes<T> &move;
    std::exception_ptr thrown;

    static int call(void *user, std::size_t first, std::size_t count, void *x, void *y, void *z) noexcept {
        auto &host = *static_cast<MoveNodesHost *>(user);
        try {
            const auto span = [&](void *data) { return Span<T>(static_cast<T *>(data), count); };
            return host.move(first, span(x), span(y), span(z)) ? 0 : 1;
        } catch (...) {
            host.thrown = std::current_exception();
            return 1;
        }
    }
};
} // namespace detail

template <class T>
void Net::deform_rows(const MoveNodes<T> &move, const Context &context) {
    require<T>(view());
    detail::MoveNodesHost<T> host{move, nullptr};
    context.call([&](gusset_context *c) {
        const gusset_status status = gusset_net_deform_rows(c, get(), detail::MoveNodesHost<T>::call, &host);
        if (host.thrown) {
            std::rethrow_exception(host.thrown);
        }
        return status;
    });
}

/// Joins nets side by side to one; the same one may come several times. See gusset_net_concatenate_create.
inline Net concatenate(Span<const Net *const> nets, const JoinOptions &options = {}, const Context &context = Context()) {
    const gusset_join_options given = detail::as_c(options);
    std::vector<const gusset_net *> handles;
    for (const Net *net : nets) {
        handles.push_back(net != nullptr ? net->get() : nullptr);
    }
    gusset_net *joined = nullptr;
    context.call([&](gusset_context *c) {
        return gusset_net_concatenate_create(c, handles.data(), handles.size(), &given, &joined);
    });
    return Net(joined);
}
/// Joins nets side by side to one; see gusset_net_concatenate_create.
inline Net concatenate(Span<const Net> nets, const JoinOptions &options = {}, const Context &context = Context()) {
    std::vector<const Net *> pointers;
    for (const Net &net : nets) {
        pointers.push_back(&net);
    }
    return concatenate(Span<const Net *const>(pointers), options, context);
}
/// The same of nets that are where they are, and are not copied.
inline Net concatenate(std::initializer_list<const Net *> nets, const JoinOptions &options = {},
                       const Context &context = Context()) {
    return concatenate(Span<const Net *const>(nets.begin(), nets.size()), options, context);
}
/// Joins two nets.
inline Net concatenate(const Net &first, const Net &second, const JoinOptions &options = {},
                       const Context &context = Context()) {
    const Net *const nets[] = {&first, &second};
    return concatenate(Span<const Net *const>(nets, 2), options, context);
}

} // namespace gusset

#endif // GUSSET_NET_MEMBERS_HPP
