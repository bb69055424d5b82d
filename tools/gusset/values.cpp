#include "values.hpp"

#include "failure.hpp"
#include "plugin.hpp"
#include "specs.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <optional>
#include <set>
#include <sstream>
#include <string_view>

namespace {
bool same(std::string_view a, std::string_view b) {
    const auto equal = [](unsigned char x, unsigned char y) { return std::tolower(x) == std::tolower(y); };
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), equal);
}

std::optional<double> number(std::string_view text) {
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc() && end == text.data() + text.size() ? std::optional(value) : std::nullopt;
}

/// One component; nothing if it cannot be read.
std::optional<double> component(const gusset_param_info &param, std::string_view text) {
    if (param.kind == GUSSET_PARAM_BOOL && (same(text, "true") || same(text, "false"))) {
        return same(text, "true") ? 1.0 : 0.0;
    }
    for (uint32_t c = 0; c < param.choice_count; ++c) {
        if (slug(std::string(text)) == slug(param.choices[c].label)) {
            return static_cast<double>(c);
        }
    }
    return number(text);
}

/// What a value looks like.
std::string form(const gusset_param_info &param) {
    switch (param.kind) {
    case GUSSET_PARAM_BOOL:
        return "true or false";
    case GUSSET_PARAM_CHOICE: {
        std::string all;
        for (uint32_t c = 0; c < param.choice_count; ++c) {
            all += std::string(c == 0                        ? ""
                               : c + 1 == param.choice_count ? " or "
                                                             : ", ") +
                   '"' + param.choices[c].label + '"';
        }
        return all;
    }
    default:
        return param.arity == 1 ? "a number" : std::to_string(param.arity) + " numbers with commas between them";
    }
}

void parse(const gusset_param_info &param, const std::string &text, double *values) {
    // A label may have commas of its own.
    std::vector<std::string> parts;
    if (param.arity == 1) {
        parts.push_back(text);
    } else {
        std::istringstream list(text);
        for (std::string part; std::getline(list, part, ',');) {
            parts.push_back(part);
        }
    }
    bool good = parts.size() == param.arity && text.back() != ',';
    for (uint32_t k = 0; good && k < param.arity; ++k) {
        const auto value = component(param, parts[k]);
        good = value.has_value();
        values[k] = value.value_or(0);
    }
    if (!good) {
        throw Failure(Exit::usage,
                      std::string("parameter ") + param.id + " takes " + form(param) + ", not \"" + text + '"');
    }
}
} // namespace

std::vector<double> parse_values(const gusset_filter &filter, std::vector<double> suggested,
                                 const std::vector<std::string> &given) {
    const auto all = params(filter);
    std::set<std::string> seen;
    for (const std::string &one : given) {
        const std::size_t equals = one.find('=');
        if (equals == std::string::npos || equals == 0 || equals + 1 == one.size()) {
            throw Failure(Exit::usage, "a parameter is given as name=value, not as \"" + one + '"');
        }
        const std::string name = one.substr(0, equals);
        const auto found = std::find_if(all.begin(), all.end(), [&](const auto *param) { return name == param->id; });
        if (found == all.end()) {
            throw Failure(Exit::usage, std::string(filter.id) + " has no parameter " + name + "; 'gusset filters " +
                                           filter.id + "' shows what it has");
        }
        if (!seen.insert(name).second) {
            throw Failure(Exit::usage, "parameter " + name + " is given twice");
        }
        parse(**found, one.substr(equals + 1), suggested.data() + (*found)->first_value);
    }
    return suggested;
}

std::string print_number(double value) {
    char text[32];
    return std::string(text, std::to_chars(text, text + sizeof text, value).ptr);
}

std::string print_value(const gusset_param_info &param, const double *values) {
    if (param.kind == GUSSET_PARAM_BOOL) {
        return values[0] != 0 ? "true" : "false";
    }
    if (param.kind == GUSSET_PARAM_CHOICE && values[0] >= 0 && values[0] < param.choice_count) {
        return '"' + std::string(param.choices[static_cast<uint32_t>(values[0])].label) + '"';
    }
    std::string text;
    for (uint32_t k = 0; k < param.arity; ++k) {
        text += (k == 0 ? "" : ",") + print_number(values[k]);
    }
    return text;
}
