// The gusset plugin, opened at run time through gusset_plugin.h and nothing else.
#pragma once

#include <gusset_plugin.h>

#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

/// A plugin that stays open as long as the process runs.
class Plugin {
public:
    /// Looks for `path`, or for a file of its name in the folder of this library.
    explicit Plugin(const std::string &path);

    /// Why the plugin was not loaded; empty if it was.
    const std::string &error() const { return error_; }
    /// NULL if there is none.
    const gusset_plugin *tables() const { return tables_; }
    /// The filter of this number, which must be below the plugin's count.
    const gusset_filter &filter(int index) const { return *tables_->filter(static_cast<std::uint32_t>(index)); }

private:
    const gusset_plugin *tables_ = nullptr;
    std::string error_;
};

/// Callbacks of the host during a run.
struct Listener {
    /// False cancels.
    std::function<bool(double fraction, const char *stage)> progress;
    std::function<void(const char *message)> log;
};

/// The outputs of a run that succeeded.
class Outputs {
public:
    /// Runs the filter; throws std::runtime_error with the plugin's sentence, and the parameter's label if it is about
    /// one.
    Outputs(const gusset_plugin &plugin, const gusset_filter &filter, const std::vector<gusset_input> &inputs,
            const std::vector<double> &values, const Listener &listener);

    std::uint32_t count() const { return plugin_.output_count(held_.get()); }
    std::uint32_t kind(std::uint32_t index) const { return plugin_.output_kind(held_.get(), index); }
    gusset_plugin_mesh mesh(std::uint32_t index) const;
    gusset_plugin_curves curves(std::uint32_t index) const;
    const char *text(std::uint32_t index) const { return plugin_.output_text(held_.get(), index); }

    /// Whether the output tells where its elements come from.
    bool has_origins(std::uint32_t index) const;
    /// Where the output's elements of a GUSSET_PLUGIN_... domain come from, if it tells.
    gusset_plugin_origins origins(std::uint32_t index, std::uint32_t domain) const;
    /// Writes packed values of the `count` elements of the output, interpolated from the elements of the inputs.
    void carry(std::uint32_t index, const gusset_plugin_channel &channel,
               const std::vector<gusset_plugin_channel_values> &inputs, void *values, std::size_t count) const;

    /// The numbers in a text under their names; none if the plugin names none.
    std::vector<std::pair<std::string, double>> values(std::uint32_t index) const;

private:
    /// NULL if the plugin lacks these functions.
    const gusset_plugin_attributes *attributes() const {
        return static_cast<const gusset_plugin_attributes *>(plugin_.extension("attributes/1"));
    }

    const gusset_plugin &plugin_;
    std::unique_ptr<gusset_outputs, void (*)(gusset_outputs *)> held_;
};

/// The values that suit these inputs, or the plain defaults.
std::vector<double> suggested(const gusset_filter &filter, const std::vector<gusset_input> &inputs);
