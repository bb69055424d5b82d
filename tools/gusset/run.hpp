// A run of a filter, from files to files, and a mesh from one format to another.
#pragma once

#include "failure.hpp"
#include "json.hpp"
#include "plugin.hpp"

#include <optional>
#include <string>
#include <vector>

struct RunRequest {
    std::string command;
    std::string filter;
    std::vector<InputFile> inputs;
    /// "name=value".
    std::vector<std::string> params;
    std::vector<std::string> outputs;
    bool dry = false;
    bool text = false;
    bool json = false;
    uint32_t threads = 0;
    bool progress = false;
    std::optional<double> cancel_after;
};

/// How the program ends after this status of the plugin, which is neither success nor a cancel.
Exit exit_of(int32_t status);

/// The values that the filter suggests for these inputs, or if it refuses them, its status and the defaults.
struct Suggested {
    std::vector<double> values;
    int32_t status;
};
Suggested suggest(const gusset_filter &filter, const Inputs &inputs);

/// Runs the filter, prints its texts or the report, and writes the rest to files. Throws Failure.
void run(const Plugin &plugin, const RunRequest &request);

/// Reads a mesh and writes it. Throws Failure.
void convert(const RunRequest &request);
