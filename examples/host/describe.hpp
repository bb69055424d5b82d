// What the plugin and its filters are, in words.
#pragma once

#include "plugin.hpp"

#include <ostream>
#include <vector>

/// One line for each filter: its id, what goes in and comes out, its name.
void list(std::ostream &out, const Plugin &plugin);
/// Everything about one filter. suggested: values for given inputs, or empty.
void describe(std::ostream &out, const gusset_filter &filter, const std::vector<double> &suggested);
