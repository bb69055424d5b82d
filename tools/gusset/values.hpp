// Values of parameters as people write them.
#pragma once

#include <gusset_plugin.h>

#include <string>
#include <vector>

/// The values of all parameters: those of `suggested`, overwritten by what `given` says, each as "name=value". Throws
/// Failure.
std::vector<double> parse_values(const gusset_filter &filter, std::vector<double> suggested,
                                 const std::vector<std::string> &given);

/// As parse_values reads them.
std::string print_value(const gusset_param_info &param, const double *values);
/// The shortest text that reads as the same number.
std::string print_number(double value);
