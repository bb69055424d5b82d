// Where the elements of a plugin's output come from, and what the inputs carry by that.
#pragma once

#include "plugin.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

/// The origins of an output, which must be there as long as they are.
class Origins {
public:
    Origins(const Plugin &plugin, const gusset_outputs *outputs_, uint32_t index_)
        : attributes(plugin.attributes()), outputs(outputs_), index(index_) {}

    /// Whether the plugin tells them of this output.
    bool are_known() const { return attributes != nullptr && attributes->has_origins(outputs, index) != 0; }
    /// For each element of a GUSSET_PLUGIN_... domain, its sources.
    gusset_plugin_origins of(uint32_t domain) const;
    /// The values of the output's elements: `width` for each, of `inputs`, one list for each of the run's inputs, by a
    /// GUSSET_PLUGIN_RULE_...
    std::vector<double> apply(uint32_t domain, uint32_t rule, uint32_t width,
                              const std::vector<std::vector<double>> &inputs) const;

private:
    const gusset_plugin_attributes *attributes;
    const gusset_outputs *outputs;
    uint32_t index;
};
