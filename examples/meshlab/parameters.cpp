#include "parameters.hpp"

#include <common/parameters/rich_parameters.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace {

constexpr double DEGREE = 3.14159265358979323846 / 180;

QString text(const char *utf8) { return QString::fromUtf8(utf8); }
QString offset_id(const gusset_param_info &param) { return text(param.id) + "_offset"; }

QString range(const gusset_param_info &param) {
    const double unit = param.kind == GUSSET_PARAM_ANGLE ? DEGREE : 1;
    const auto bound = [&](double value) { return QString::number(value / unit, 'g', 6); };
    switch (param.kind) {
    case GUSSET_PARAM_INT:
    case GUSSET_PARAM_REAL:
    case GUSSET_PARAM_LENGTH:
    case GUSSET_PARAM_ANGLE:
        return QString(" (%1 to %2%3)").arg(bound(param.min), bound(param.max), unit == 1 ? "" : " degrees");
    default:
        return {};
    }
}

QString help(const gusset_param_info &param) {
    QString help = text(param.help) + range(param);
    for (std::uint32_t k = 0; k < param.choice_count; ++k) {
        help += "\n" + text(param.choices[k].label) + ": " + text(param.choices[k].help);
    }
    return help;
}

Point3m vector(const double *values) { return {Scalarm(values[0]), Scalarm(values[1]), Scalarm(values[2])}; }

void add(const gusset_param_info &param, const double *values, double diagonal, RichParameterList &list) {
    const QString id = text(param.id), label = text(param.label), hint = help(param);
    switch (param.kind) {
    case GUSSET_PARAM_BOOL:
        list.addParam(RichBool(id, values[0] != 0, label, hint));
        break;
    case GUSSET_PARAM_INT:
        list.addParam(RichInt(id, static_cast<int>(values[0]), label, hint));
        break;
    case GUSSET_PARAM_CHOICE: {
        QStringList labels;
        for (std::uint32_t k = 0; k < param.choice_count; ++k) {
            labels.push_back(text(param.choices[k].label));
        }
        list.addParam(RichEnum(id, static_cast<int>(values[0]), labels, label, hint));
        break;
    }
    case GUSSET_PARAM_LENGTH:
        list.addParam(RichPercentage(id, Scalarm(values[0]), 0, Scalarm(diagonal), label, hint));
        break;
    case GUSSET_PARAM_ANGLE:
        list.addParam(RichFloat(id, Scalarm(values[0] / DEGREE), label + " (degrees)", hint));
        break;
    case GUSSET_PARAM_POINT:
        list.addParam(RichPosition(id, vector(values), label, hint));
        break;
    case GUSSET_PARAM_DIRECTION:
        list.addParam(RichDirection(id, vector(values), label, hint));
        break;
    case GUSSET_PARAM_PLANE:
        list.addParam(RichDirection(id, vector(values), label + ": normal", hint));
        list.addParam(RichFloat(offset_id(param), Scalarm(values[3]), label + ": offset",
                                "The product of the normal, as it stands, with any point of the plane."));
        break;
    default:
        list.addParam(RichFloat(id, Scalarm(values[0]), label, hint));
        break;
    }
}

/// A value that left the range by rounding alone, on its way through the host's precision, is put back.
double snapped(const gusset_param_info &param, double value) {
    const double slack = 8 * std::abs(value) * std::numeric_limits<Scalarm>::epsilon();
    const double nearest = std::clamp(value, param.min, param.max);
    return std::abs(nearest - value) <= slack ? nearest : value;
}

void read(const gusset_param_info &param, const RichParameterList &list, double *values) {
    const QString id = text(param.id);
    switch (param.kind) {
    case GUSSET_PARAM_BOOL:
        values[0] = list.getBool(id) ? 1 : 0;
        break;
    case GUSSET_PARAM_INT:
        values[0] = list.getInt(id);
        break;
    case GUSSET_PARAM_CHOICE:
        values[0] = list.getEnum(id);
        break;
    case GUSSET_PARAM_LENGTH:
        values[0] = snapped(param, list.getAbsPerc(id));
        break;
    case GUSSET_PARAM_ANGLE:
        values[0] = snapped(param, list.getFloat(id) * DEGREE);
        break;
    case GUSSET_PARAM_POINT:
    case GUSSET_PARAM_DIRECTION:
    case GUSSET_PARAM_PLANE: {
        const Point3m vector = list.getPoint3m(id);
        std::copy_n(vector.V(), 3, values);
        if (param.kind == GUSSET_PARAM_PLANE) {
            values[3] = list.getFloat(offset_id(param));
        }
        break;
    }
    default:
        values[0] = snapped(param, list.getFloat(id));
        break;
    }
}

} // namespace

void describe(const gusset_filter &filter, const std::vector<double> &values, double diagonal,
              RichParameterList &list) {
    for (std::uint32_t k = 0; k < filter.param_count; ++k) {
        const gusset_param_info &param = *filter.param(&filter, k);
        add(param, values.data() + param.first_value, diagonal, list);
    }
}

std::vector<double> values_of(const gusset_filter &filter, const RichParameterList &list) {
    std::vector<double> values(filter.value_count);
    for (std::uint32_t k = 0; k < filter.param_count; ++k) {
        const gusset_param_info &param = *filter.param(&filter, k);
        read(param, list, values.data() + param.first_value);
    }
    return values;
}
