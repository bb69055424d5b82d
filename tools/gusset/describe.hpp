// What the plugin and its filters are, in words.
#pragma once

#include "plugin.hpp"

#include <ostream>
#include <string>
#include <vector>

/// "mesh", "curves" or "text".
const char *kind_name(uint32_t kind);
/// The kind of a parameter.
const char *type_name(uint32_t type);
/// "mesh, mesh", "mesh[, mesh]" if the second need not be, "mesh..." if there may be many more, "-" for none.
std::string inputs_of(const gusset_filter &filter);
std::string outputs_of(const gusset_filter &filter);

/// One line for each filter: its id, what goes in and comes out, its name.
void list(std::ostream &out, const Plugin &plugin);
/// Everything about one filter. suggested: values for given inputs, or empty.
void describe(std::ostream &out, const gusset_filter &filter, const std::vector<double> &suggested);
