/// @file
/// Shared by the adapters: carries values of a host's elements over. Include an adapter, not this.
#ifndef GUSSET_HOST_VALUES_HPP
#define GUSSET_HOST_VALUES_HPP

#include <gusset/attributes.hpp>

#include <string>

namespace gusset::detail {

/// One channel: for each input an address and a number of elements, or NULL for an input without values.
struct HostChannel {
    Domain domain;
    Rule rule;
    uint32_t value_type, components;
    std::vector<gusset_channel_values> inputs;

    void apply(const Origins &origins, void *out, std::size_t count, const Context &context) const {
        auto channel = sized<gusset_channel>();
        channel.domain = static_cast<uint32_t>(domain);
        channel.value_type = value_type;
        channel.components = components;
        channel.rule = static_cast<uint32_t>(rule);
        context.call(gusset_attributes_apply, origins.get(), &channel, inputs.data(), inputs.size(), out, count, std::size_t{0});
    }
};

/// The rule for a property, by its type and name: normals are directions, integers are copied, texture coordinates of
/// corners continue as charts; other properties are averaged. Colours of bytes are mixed, too.
inline Rule rule_of(const std::string &name, Domain domain, uint32_t value_type, uint32_t components) {
    const auto has = [&](const char *word) { return name.find(word) != std::string::npos; };
    const bool floats = value_type == GUSSET_VALUE_F32 || value_type == GUSSET_VALUE_F64;
    if (floats && components == 3 && has("normal")) {
        return Rule::normal;
    }
    if (domain == Domain::corners && (has("texcoord") || has("uv"))) {
        return Rule::texture;
    }
    return floats || has("color") || has("colour") ? Rule::linear : Rule::nearest;
}

/// Integers are carried bit for bit, those with 64 bits in two halves.
template <class Value>
constexpr uint32_t host_value_type() {
    if constexpr (std::is_floating_point_v<Value>) {
        return value_type<Value>();
    } else if constexpr (sizeof(Value) > sizeof(uint32_t)) {
        return GUSSET_VALUE_U32;
    } else {
        return value_type<std::make_unsigned_t<Value>>();
    }
}
template <class Value>
constexpr uint32_t host_components(uint32_t count) {
    return std::is_integral_v<Value> && sizeof(Value) > sizeof(uint32_t) ? 2 * count : count;
}

} // namespace gusset::detail

#endif // GUSSET_HOST_VALUES_HPP
