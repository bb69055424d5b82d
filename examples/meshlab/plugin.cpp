#include "plugin.hpp"

#include <dlfcn.h>

#include <cstring>
#include <filesystem>

namespace {

/// A file of this name beside the library that holds this code.
std::string beside(const std::string &path) {
    Dl_info here{};
    static const char inside = 0;
    if (dladdr(&inside, &here) == 0 || here.dli_fname == nullptr) {
        return path;
    }
    return (std::filesystem::path(here.dli_fname).parent_path() / std::filesystem::path(path).filename()).string();
}

int32_t on_progress(void *user, double fraction, const char *stage) {
    const auto &listener = *static_cast<const Listener *>(user);
    return listener.progress && !listener.progress(fraction, stage) ? 1 : 0;
}

void on_log(void *user, const char *message) {
    const auto &listener = *static_cast<const Listener *>(user);
    if (listener.log) {
        listener.log(message);
    }
}

std::string sentence(const gusset_plugin &plugin, const gusset_filter &filter, const gusset_outputs *outputs) {
    gusset_failure failure{};
    failure.struct_size = sizeof failure;
    if (outputs == nullptr || plugin.output_failure(outputs, &failure) != GUSSET_PLUGIN_DONE) {
        return "out of memory";
    }
    std::string text = failure.message;
    if (const gusset_param_info *param = filter.param(&filter, failure.param)) {
        text = std::string(param->label) + " (" + param->id + "): " + text;
    }
    return text;
}

} // namespace

Plugin::Plugin(const std::string &path) {
    const std::string found = std::filesystem::exists(path) ? path : beside(path);
    void *library = dlopen(found.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (library == nullptr) {
        error_ = dlerror();
        return;
    }
    void *symbol = dlsym(library, "gusset_plugin_entry");
    gusset_plugin_entry_fn entry = nullptr;
    // The one way from an object pointer to a function pointer that every compiler accepts.
    std::memcpy(&entry, &symbol, sizeof entry);
    tables_ = entry != nullptr ? entry(GUSSET_PLUGIN_ABI) : nullptr;
    if (tables_ == nullptr) {
        error_ = found + " is no plugin of version " + std::to_string(GUSSET_PLUGIN_ABI);
    }
}

Outputs::Outputs(const gusset_plugin &plugin, const gusset_filter &filter, const std::vector<gusset_input> &inputs,
                 const std::vector<double> &values, const Listener &listener)
    : plugin_(plugin), held_(nullptr, plugin.output_free) {
    gusset_host host{};
    host.struct_size = sizeof host;
    host.user = const_cast<Listener *>(&listener);
    host.progress = on_progress;
    host.log = on_log;
    host.origins = 1;
    gusset_outputs *made = nullptr;
    const int32_t status = filter.run(&filter, &host, inputs.data(), static_cast<std::uint32_t>(inputs.size()),
                                      values.data(), static_cast<std::uint32_t>(values.size()), &made);
    held_.reset(made);
    if (status != GUSSET_PLUGIN_DONE) {
        throw std::runtime_error(status == GUSSET_PLUGIN_CANCELLED ? "cancelled" : sentence(plugin, filter, made));
    }
}

gusset_plugin_mesh Outputs::mesh(std::uint32_t index) const {
    gusset_plugin_mesh mesh{};
    mesh.struct_size = sizeof mesh;
    if (plugin_.output_mesh(held_.get(), index, &mesh) != GUSSET_PLUGIN_DONE) {
        throw std::runtime_error("an output is no mesh");
    }
    return mesh;
}

gusset_plugin_curves Outputs::curves(std::uint32_t index) const {
    gusset_plugin_curves curves{};
    curves.struct_size = sizeof curves;
    if (plugin_.output_curves(held_.get(), index, &curves) != GUSSET_PLUGIN_DONE) {
        throw std::runtime_error("an output is no set of curves");
    }
    return curves;
}

bool Outputs::has_origins(std::uint32_t index) const {
    return attributes() != nullptr && attributes()->has_origins(held_.get(), index) != 0;
}

gusset_plugin_origins Outputs::origins(std::uint32_t index, std::uint32_t domain) const {
    gusset_plugin_origins origins{};
    origins.struct_size = sizeof origins;
    if (attributes()->origins(held_.get(), index, domain, &origins) != GUSSET_PLUGIN_DONE) {
        throw std::runtime_error("an output does not tell where it comes from");
    }
    return origins;
}

void Outputs::carry(std::uint32_t index, const gusset_plugin_channel &channel,
                    const std::vector<gusset_plugin_channel_values> &inputs, void *values, std::size_t count) const {
    gusset_failure failure{};
    failure.struct_size = sizeof failure;
    if (attributes()->apply(held_.get(), index, nullptr, &channel, inputs.data(),
                            static_cast<std::uint32_t>(inputs.size()), values, count, 0,
                            &failure) != GUSSET_PLUGIN_DONE) {
        throw std::runtime_error(std::string("attributes are not carried over: ") + failure.message);
    }
}

std::vector<std::pair<std::string, double>> Outputs::values(std::uint32_t index) const {
    const auto *named = static_cast<const gusset_plugin_values *>(plugin_.extension("values/1"));
    std::vector<std::pair<std::string, double>> all;
    for (std::uint32_t k = 0; named != nullptr && k < named->count(held_.get(), index); ++k) {
        all.emplace_back(named->name(held_.get(), index, k), named->value(held_.get(), index, k));
    }
    return all;
}

std::vector<double> suggested(const gusset_filter &filter, const std::vector<gusset_input> &inputs) {
    std::vector<double> values(filter.value_count);
    // After a failure they are the plain defaults, and the run reports the error.
    (void)filter.suggest(&filter, inputs.data(), static_cast<std::uint32_t>(inputs.size()), values.data());
    return values;
}
