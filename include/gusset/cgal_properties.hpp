/// @file
/// Property maps of CGAL surface meshes, carried over to results. Include cgal.hpp, not this.
#ifndef GUSSET_CGAL_PROPERTIES_HPP
#define GUSSET_CGAL_PROPERTIES_HPP

#include <gusset/host_values.hpp>

#include <CGAL/IO/Color.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/version.h>

#include <algorithm>

namespace gusset::cgal::detail {

#if CGAL_VERSION_NR < 1050400000
using Color = CGAL::Color;
#else
using Color = CGAL::IO::Color;
#endif

/// A property map, if there is one of the name and the type: a pair before CGAL 6, and optional since.
template <class T, class Element, class Mesh>
auto find_map(const Mesh &mesh, const std::string &name) {
    auto found = mesh.template property_map<Element, T>(name);
    using Map = typename Mesh::template Property_map<Element, T>;
    if constexpr (std::is_same_v<decltype(found), std::pair<Map, bool>>) {
        return found;
    } else {
        return std::pair<Map, bool>(found ? *found : Map(), static_cast<bool>(found));
    }
}

/// The values of an element of a property map: one number, an array of them, a colour, or a vector of a kernel of doubles.
template <class T>
struct Values {
    using Value = std::conditional_t<std::is_arithmetic_v<T>, T, double>;
    static constexpr uint32_t count = sizeof(T) / sizeof(Value);
};
template <class T, std::size_t N>
struct Values<std::array<T, N>> {
    using Value = T;
    static constexpr uint32_t count = N;
};
template <>
struct Values<Color> {
    using Value = unsigned char;
    static constexpr uint32_t count = 4;
};

/// Maps that are not carried: positions, connectivity, states, and normals of faces, which depend on positions.
inline bool is_own(const std::string &name) {
    return name == "v:point" || name == "f:normal" || name.find(":removed") != std::string::npos || name.find(":connectivity") != std::string::npos;
}

/// Carries property maps of the type T from the inputs to a mesh, `to[k]` of which is element k of the result. `from[i][k]`: element k
/// of input i.
template <class T, class Mesh, class Element>
void carry(Mesh &mesh, Domain domain, const std::vector<Element> &to, const Origins &origins, const std::vector<const Mesh *> &inputs,
           const std::vector<std::vector<Element>> &from, const Context &context) {
    using Value = typename Values<T>::Value;
    static_assert(sizeof(T) == Values<T>::count * sizeof(Value), "elements have gaps");
    std::vector<std::string> done;
    for (const Mesh *input : inputs) {
        for (const std::string &name : input->template properties<Element>()) {
            const auto own = find_map<T, Element>(*input, name);
            if (!own.second || is_own(name) || std::find(done.begin(), done.end(), name) != done.end()) {
                continue;
            }
            done.push_back(name);
            std::vector<std::vector<T>> values(inputs.size());
            gusset::detail::HostChannel channel{domain, gusset::Rule::linear, gusset::detail::host_value_type<Value>(),
                                                gusset::detail::host_components<Value>(Values<T>::count), {}};
            channel.rule = gusset::detail::rule_of(name, domain, channel.value_type, channel.components);
            for (std::size_t i = 0; i < inputs.size(); ++i) {
                const auto map = find_map<T, Element>(*inputs[i], name);
                for (std::size_t k = 0; map.second && k < from[i].size(); ++k) {
                    values[i].push_back(map.first[from[i][k]]);
                }
                channel.inputs.push_back({values[i].empty() ? nullptr : values[i].data(), values[i].size(), 0});
            }
            std::vector<T> made(to.size());
            channel.apply(origins, made.data(), made.size(), context);
            const auto map = mesh.template add_property_map<Element, T>(name).first;
            for (std::size_t k = 0; k < to.size(); ++k) {
                if (to[k].is_valid()) {
                    map[to[k]] = made[k];
                }
            }
        }
    }
}

/// The same of all types that the library carries.
template <class Mesh, class Element>
void carry_all(Mesh &mesh, Domain domain, const std::vector<Element> &to, const Origins &origins, const std::vector<const Mesh *> &inputs,
               const std::vector<std::vector<Element>> &from, const Context &context) {
    using Vector = typename CGAL::Kernel_traits<typename Mesh::Point>::Kernel::Vector_3;
    const auto each = [&](auto... types) { (carry<decltype(types)>(mesh, domain, to, origins, inputs, from, context), ...); };
    each(0.0F, 0.0, 0, 0U, 0L, 0UL, static_cast<unsigned short>(0), static_cast<unsigned char>(0), Color(), Vector(), std::array<float, 2>(),
         std::array<float, 3>(), std::array<float, 4>(), std::array<double, 2>(), std::array<double, 3>(), std::array<double, 4>(),
         std::array<unsigned char, 3>(), std::array<unsigned char, 4>(), std::array<int, 2>(), std::array<int, 3>(), std::array<int, 4>());
}

} // namespace gusset::cgal::detail

#endif // GUSSET_CGAL_PROPERTIES_HPP
