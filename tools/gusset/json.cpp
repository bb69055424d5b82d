#include "json.hpp"

#include "attributes.hpp"
#include "describe.hpp"
#include "values.hpp"

#include <algorithm>
#include <cmath>

namespace {
Json kinds_of(const uint32_t *kinds, uint32_t count) {
    Json made = Json::array();
    for (uint32_t k = 0; k < count; ++k) {
        made.push_back(kind_name(kinds[k]));
    }
    return made;
}
} // namespace

Json json_of(double value) {
    // Doubles hold all whole numbers up to this.
    constexpr double most = 9007199254740992.0;
    if (!std::isfinite(value)) {
        return nullptr;
    }
    if (value == std::floor(value) && std::abs(value) <= most) {
        return static_cast<int64_t>(value);
    }
    return value;
}

Json json_of(const std::string &path, const Mesh &mesh) {
    return {{"file", path},
            {"kind", "mesh"},
            {"vertices", mesh.points.size()},
            {"faces", mesh.face_count()},
            {"attributes", attribute_names(mesh)}};
}

Json json_of(const std::string &path, const Curves &curves) {
    return {{"file", path}, {"kind", "curves"}, {"points", curves.points.size()}, {"curves", curves.closed.size()}};
}

Json json_of(const Failure &failure) {
    Json made = {{"message", failure.what()}, {"exit", static_cast<int>(failure.exit)}};
    if (failure.status) {
        made["status"] = *failure.status;
    }
    if (!failure.parameter.empty()) {
        made["parameter"] = failure.parameter;
    }
    if (failure.input) {
        made["input"] = *failure.input;
    }
    if (failure.index) {
        made["element"] = failure.element;
        made["index"] = *failure.index;
    }
    return made;
}

Json json_of(const gusset_filter &filter, const std::vector<double> &values) {
    Json made = Json::object();
    for (const auto *param : params(filter)) {
        const double *first = values.data() + param->first_value;
        if (param->kind == GUSSET_PARAM_BOOL) {
            made[param->id] = first[0] != 0;
        } else if (param->kind == GUSSET_PARAM_CHOICE && first[0] >= 0 && first[0] < param->choice_count) {
            made[param->id] = param->choices[static_cast<uint32_t>(first[0])].label;
        } else if (param->arity == 1) {
            made[param->id] = json_of(first[0]);
        } else {
            Json list = Json::array();
            for (uint32_t k = 0; k < param->arity; ++k) {
                list.push_back(json_of(first[k]));
            }
            made[param->id] = std::move(list);
        }
    }
    return made;
}

Json json_of(const gusset_filter &filter, const std::vector<double> &suggested, bool in_full) {
    Json made = {{"id", filter.id},
                 {"name", filter.name},
                 {"category", filter.category},
                 {"inputs", kinds_of(filter.input_kinds, filter.input_kind_count)},
                 {"min_inputs", filter.min_inputs},
                 {"max_inputs", filter.max_inputs},
                 {"outputs", kinds_of(filter.output_kinds, filter.output_count)}};
    if (!in_full) {
        return made;
    }
    made["script"] = filter.script_name;
    made["help"] = filter.help;
    made["reference"] = filter.reference;
    std::vector<double> defaults(filter.value_count);
    for (const auto *param : params(filter)) {
        std::copy_n(param->default_values, param->arity, defaults.begin() + param->first_value);
    }
    const Json given = json_of(filter, defaults), suited = suggested.empty() ? Json() : json_of(filter, suggested);
    made["parameters"] = Json::array();
    for (const auto *param : params(filter)) {
        Json one = {{"id", param->id},
                    {"label", param->label},
                    {"help", param->help},
                    {"kind", type_name(param->kind)},
                    {"default", given[param->id]}};
        if (!suited.is_null()) {
            one["suggested"] = suited[param->id];
        }
        if (param->kind != GUSSET_PARAM_BOOL && param->kind != GUSSET_PARAM_CHOICE) {
            one["min"] = json_of(param->min);
            one["max"] = json_of(param->max);
        }
        for (uint32_t c = 0; c < param->choice_count; ++c) {
            one["choices"].push_back({{"label", param->choices[c].label}, {"help", param->choices[c].help}});
        }
        made["parameters"].push_back(std::move(one));
    }
    return made;
}
