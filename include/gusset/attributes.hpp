/// @file
/// Values of vertices, corners and faces, carried over to results. Include gusset.hpp, not this.
#ifndef GUSSET_ATTRIBUTES_HPP
#define GUSSET_ATTRIBUTES_HPP

#include <gusset/context.hpp>

#include <array>
#include <vector>

namespace gusset {

namespace detail {
template <class Value>
constexpr uint32_t value_type() {
    static_assert(std::is_same_v<Value, float> || std::is_same_v<Value, double> || std::is_unsigned_v<Value>,
                  "values are floats, doubles or unsigned integers of up to 32 bits");
    if constexpr (std::is_same_v<Value, float>) {
        return GUSSET_VALUE_F32;
    } else if constexpr (std::is_same_v<Value, double>) {
        return GUSSET_VALUE_F64;
    } else {
        static_assert(sizeof(Value) <= 4, "values are unsigned integers of up to 32 bits");
        return sizeof(Value) == 1 ? GUSSET_VALUE_U8 : sizeof(Value) == 2 ? GUSSET_VALUE_U16 : GUSSET_VALUE_U32;
    }
}
/// The values of one element: one number, or an array of them.
template <class Element>
struct ValuesOf {
    using Value = Element;
    static constexpr uint32_t count = 1;
};
template <class T, std::size_t N>
struct ValuesOf<std::array<T, N>> {
    using Value = T;
    static constexpr uint32_t count = N;
};
} // namespace detail

/// Where the elements of a result come from; see gusset_origins. Results make it by origins().
class Origins {
public:
    /// How many elements the result has.
    std::size_t size(Domain domain) const { return view(domain).offsets.count - 1; }
    /// Element k has the entries offsets[k] to offsets[k + 1] - 1 of sources and weights.
    Indices offsets(Domain domain) const & { return detail::indices(view(domain).offsets); }
    Indices offsets(Domain domain) const && = delete;
    /// The sources, numbered through all inputs.
    Indices sources(Domain domain) const & { return detail::indices(view(domain).sources); }
    Indices sources(Domain domain) const && = delete;
    /// How much each counts.
    Span<const double> weights(Domain domain) const & {
        const gusset_origins_view found = view(domain);
        return {found.weights, found.sources.count};
    }
    Span<const double> weights(Domain domain) const && = delete;
    /// The elements of input i are the sources starts[i] to starts[i + 1] - 1.
    Indices starts(Domain domain) const & { return detail::indices(view(domain).starts); }
    Indices starts(Domain domain) const && = delete;

    /// The values of the result's elements: numbers, or arrays of them. `inputs`: the values of each input, in order;
    /// empty for an input without values. `max_influences`: of Rule::skin_weights, how many are
    /// kept; 0 for all.
    template <class Element>
    std::vector<Element> apply(Domain domain, Rule rule, const std::vector<Span<const Element>> &inputs,
                               const Context &context = Context(), uint32_t max_influences = 0) const {
        using Values = detail::ValuesOf<Element>;
        static_assert(sizeof(Element) == Values::count * sizeof(typename Values::Value), "elements have gaps");
        auto channel = detail::sized<gusset_channel>();
        channel.domain = static_cast<uint32_t>(domain);
        channel.value_type = detail::value_type<typename Values::Value>();
        channel.components = Values::count;
        channel.rule = static_cast<uint32_t>(rule);
        channel.max_influences = max_influences;
        std::vector<gusset_channel_values> given;
        for (const Span<const Element> &values : inputs) {
            given.push_back({values.empty() ? nullptr : values.data(), values.size(), 0});
        }
        std::vector<Element> made(size(domain));
        context.call(gusset_attributes_apply, get(), &channel, given.data(), given.size(), made.data(), made.size(),
                     std::size_t{0});
        return made;
    }

    /// The argument for the C interface, which this still owns.
    const gusset_origins *get() const noexcept { return origins_.get(); }
    /// Takes over origins of the C interface.
    explicit Origins(gusset_origins *made) { origins_.reset(made); }

private:
    gusset_origins_view view(Domain domain) const {
        return detail::lent(gusset_origins_get_view, origins_.get(), static_cast<uint32_t>(domain));
    }
    detail::Handle<gusset_origins, gusset_origins_destroy> origins_;
};

} // namespace gusset

#endif // GUSSET_ATTRIBUTES_HPP
