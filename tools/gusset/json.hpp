// Reports for programs.
#pragma once

#include "failure.hpp"
#include "formats/files.hpp"
#include "plugin.hpp"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

using Json = nlohmann::ordered_json;

/// Whole numbers without a point; null for what is none.
Json json_of(double value);
Json json_of(const std::string &path, const Mesh &mesh);
Json json_of(const std::string &path, const Curves &curves);
Json json_of(const Failure &failure);
/// The values of all parameters as people write them.
Json json_of(const gusset_filter &filter, const std::vector<double> &values);
/// Everything about a filter; suggested: values for given inputs, or empty.
Json json_of(const gusset_filter &filter, const std::vector<double> &suggested, bool in_full);
