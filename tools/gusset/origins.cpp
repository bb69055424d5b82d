#include "origins.hpp"

#include "failure.hpp"

gusset_plugin_origins Origins::of(uint32_t domain) const {
    gusset_plugin_origins origins{};
    origins.struct_size = sizeof origins;
    if (attributes->origins(outputs, index, domain, &origins) != GUSSET_PLUGIN_DONE) {
        throw Failure(Exit::plugin, "the plugin does not say where output " + std::to_string(index) + " comes from");
    }
    return origins;
}

std::vector<double> Origins::apply(uint32_t domain, uint32_t rule, uint32_t width,
                                   const std::vector<std::vector<double>> &inputs) const {
    gusset_plugin_channel channel{};
    channel.struct_size = sizeof channel;
    channel.domain = domain;
    channel.value_type = GUSSET_PLUGIN_VALUE_F64;
    channel.components = width;
    channel.rule = rule;
    std::vector<gusset_plugin_channel_values> given;
    for (const auto &values : inputs) {
        given.push_back({values.data(), values.size() / width, 0});
    }
    const std::size_t count = of(domain).count;
    std::vector<double> made(count * width);
    gusset_failure failure{};
    failure.struct_size = sizeof failure;
    const int32_t status = attributes->apply(outputs, index, nullptr, &channel, given.data(),
                                             static_cast<uint32_t>(given.size()), made.data(), count, 0, &failure);
    if (status != GUSSET_PLUGIN_DONE) {
        throw Failure(status == GUSSET_PLUGIN_OUT_OF_MEMORY ? Exit::memory : Exit::plugin,
                      std::string("what the inputs carry is not carried over: ") + failure.message);
    }
    return made;
}
