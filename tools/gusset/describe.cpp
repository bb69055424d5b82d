#include "describe.hpp"

#include "values.hpp"

#include <algorithm>
#include <iomanip>
#include <string>

namespace {
std::string range_of(const gusset_param_info &param) {
    if (param.kind == GUSSET_PARAM_BOOL || param.kind == GUSSET_PARAM_CHOICE) {
        return "";
    }
    return ", from " + print_number(param.min) + " to " + print_number(param.max);
}

/// Lines of text of some 100 characters, the first after a heading, the others as far to the right.
void wrapped(std::ostream &out, const std::string &heading, const std::string &text) {
    constexpr std::size_t width = 100;
    for (std::size_t start = 0; start < text.size();) {
        std::size_t end = text.size() - start <= width ? text.size() : text.rfind(' ', start + width);
        if (end == std::string::npos || end <= start) {
            end = std::min(text.find(' ', start), text.size());
        }
        out << (start == 0 ? heading : std::string(heading.size(), ' ')) << text.substr(start, end - start) << '\n';
        start = end + 1;
    }
}
} // namespace

const char *kind_name(uint32_t kind) {
    switch (kind) {
    case GUSSET_KIND_MESH:
        return "mesh";
    case GUSSET_KIND_CURVES:
        return "curves";
    case GUSSET_KIND_TEXT:
        return "text";
    default:
        return "something unknown";
    }
}

const char *type_name(uint32_t type) {
    switch (type) {
    case GUSSET_PARAM_BOOL:
        return "true or false";
    case GUSSET_PARAM_INT:
        return "whole number";
    case GUSSET_PARAM_REAL:
        return "number";
    case GUSSET_PARAM_CHOICE:
        return "choice";
    case GUSSET_PARAM_LENGTH:
        return "length";
    case GUSSET_PARAM_ANGLE:
        return "angle in radians";
    case GUSSET_PARAM_POINT:
        return "point x,y,z";
    case GUSSET_PARAM_DIRECTION:
        return "direction x,y,z";
    case GUSSET_PARAM_PLANE:
        return "plane a,b,c,d: a x + b y + c z = d";
    default:
        return "something unknown";
    }
}

std::string inputs_of(const gusset_filter &filter) {
    constexpr uint32_t few = 4;
    const uint32_t told = std::max(filter.min_inputs, filter.input_kind_count);
    const uint32_t shown = filter.max_inputs <= few ? filter.max_inputs : std::min(filter.max_inputs, told);
    std::string text;
    for (uint32_t i = 0; i < shown; ++i) {
        const std::string one = (i == 0 ? "" : ", ") + std::string(kind_name(input_kind(filter, i)));
        text += i < filter.min_inputs ? one : '[' + one + ']';
    }
    return (text.empty() ? "-" : text) + (filter.max_inputs > shown ? "..." : "");
}

std::string outputs_of(const gusset_filter &filter) {
    std::string text;
    for (uint32_t i = 0; i < filter.output_count; ++i) {
        text += (i == 0 ? "" : ", ") + std::string(kind_name(filter.output_kinds[i]));
    }
    return text;
}

void list(std::ostream &out, const Plugin &plugin) {
    const auto filters = plugin.filters();
    std::size_t id = 0, in = 0, made = 0;
    for (const auto *filter : filters) {
        id = std::max(id, std::string(filter->id).size());
        in = std::max(in, inputs_of(*filter).size());
        made = std::max(made, outputs_of(*filter).size());
    }
    const auto column = [&](const std::string &text, std::size_t width) {
        out << std::left << std::setw(static_cast<int>(width)) << text << "  ";
    };
    for (const auto *filter : filters) {
        column(filter->id, id);
        column(inputs_of(*filter), in);
        column("-> " + outputs_of(*filter), made + 3);
        out << filter->category << ": " << filter->name << '\n';
    }
}

void describe(std::ostream &out, const gusset_filter &filter, const std::vector<double> &suggested) {
    out << filter.id << ": " << filter.name << '\n';
    wrapped(out, "  ", filter.help);
    out << "\n  category   " << filter.category << "\n  script     " << filter.script_name << "\n  inputs     "
        << inputs_of(filter) << "\n  outputs    " << outputs_of(filter)
        << ((filter.flags & GUSSET_FILTER_REPLACES) != 0 ? "; the first takes the place of the first input" : "")
        << '\n';
    wrapped(out, "  reference  ", filter.reference);
    for (const auto *param : params(filter)) {
        out << "\n  -p " << param->id << '=' << print_value(*param, param->default_values) << '\n'
            << "      " << param->label << ": " << type_name(param->kind) << range_of(*param) << '\n';
        if (!suggested.empty()) {
            out << "      for these inputs: " << print_value(*param, suggested.data() + param->first_value) << '\n';
        }
        wrapped(out, "      ", param->help);
        for (uint32_t c = 0; c < param->choice_count; ++c) {
            out << "        " << c << "  " << param->choices[c].label << ": " << param->choices[c].help << '\n';
        }
    }
}
