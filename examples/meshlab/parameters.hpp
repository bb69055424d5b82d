// Parameters of a filter as MeshLab's dialogs and scripts show them.
#pragma once

#include <common/parameters/rich_parameter_list.h>
#include <gusset_plugin.h>

#include <vector>

/// Adds the parameters of a filter, with these values. Lengths are also shown as parts of `diagonal`; angles are in
/// degrees; a plane is two parameters, its normal and its offset.
void describe(const gusset_filter &filter, const std::vector<double> &values, double diagonal, RichParameterList &list);

/// The values of a filter's parameters.
std::vector<double> values_of(const gusset_filter &filter, const RichParameterList &list);
