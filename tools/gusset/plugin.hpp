// A plugin, loaded: its tables, and what owns what they give.
#pragma once

#include "formats/files.hpp"
#include "formats/placed.hpp"
#include "mesh.hpp"

#include <gusset_plugin.h>

#include <memory>
#include <string>
#include <variant>
#include <vector>

/// Keeps the library open while it lives. Throws Failure.
class Plugin {
public:
    explicit Plugin(const std::string &library);
    const gusset_plugin *operator->() const { return tables; }
    std::vector<const gusset_filter *> filters() const;
    /// By id, or by name for scripts.
    const gusset_filter *find(const std::string &name) const;
    const gusset_filter *find_or_null(const std::string &name) const;
    /// The numbers in texts, if the plugin names them.
    const gusset_plugin_values *values() const;
    /// What carries values of the inputs over to outputs, if the plugin has it.
    const gusset_plugin_attributes *attributes() const;

private:
    struct Close {
        void operator()(void *library) const;
    };
    std::unique_ptr<void, Close> library;
    const gusset_plugin *tables = nullptr;
};

std::vector<const gusset_param_info *> params(const gusset_filter &filter);
/// The kind that input `place` must have; 0 if there may be none.
uint32_t input_kind(const gusset_filter &filter, std::size_t place);

/// Throws Failure if the filter takes another number of inputs.
void check_count(const gusset_filter &filter, std::size_t count);

/// The inputs of a run: what was read from files, and the structs that show it to the plugin.
class Inputs {
public:
    /// Reads each file as the filter wants that input to be. Throws Failure.
    Inputs(const gusset_filter &filter, const std::vector<InputFile> &files);
    const gusset_input *data() const { return inputs.data(); }
    uint32_t count() const { return static_cast<uint32_t>(inputs.size()); }
    const std::vector<std::variant<Mesh, Curves>> &geometry() const { return read; }

private:
    std::vector<std::variant<Mesh, Curves>> read;
    std::vector<std::variant<gusset_plugin_mesh, gusset_plugin_curves>> views;
    std::vector<gusset_input> inputs;
};
