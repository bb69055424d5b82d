#include "filters.hpp"

#include "attributes.hpp"
#include "parameters.hpp"

#include <QAction>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace {

/// Filters with more inputs take all visible layers; filters with fewer have a parameter for each.
constexpr std::uint32_t NAMED_INPUTS = 8;

QString text(const char *utf8) { return QString::fromUtf8(utf8); }

std::uint32_t input_kind(const gusset_filter &filter, std::size_t input) {
    return filter.input_kinds[std::min<std::size_t>(input, filter.input_kind_count - 1)];
}

bool named(const gusset_filter &filter) { return filter.max_inputs > 1 && filter.max_inputs <= NAMED_INPUTS; }
bool gives(const gusset_filter &filter, std::uint32_t kind) {
    return std::find(filter.output_kinds, filter.output_kinds + filter.output_count, kind) !=
           filter.output_kinds + filter.output_count;
}

QString layer_id(std::uint32_t input) { return QString("input_%1").arg(input + 1); }
QString use_id(std::uint32_t input) { return QString("use_input_%1").arg(input + 1); }

/// Whether the layer can be an input of this kind.
bool fits(const CMeshO &layer, std::uint32_t kind) { return kind == GUSSET_KIND_CURVES ? layer.en > 0 : layer.fn > 0; }

/// A whole number as one, if it is one that scripts can have.
QVariant number(double value) {
    const bool whole = value == std::floor(value) && std::abs(value) <= std::numeric_limits<int>::max();
    return whole ? QVariant(static_cast<int>(value)) : QVariant(value);
}

/// For each input a layer of the right kind: the current one if it fits, then visible ones, then others. Fewer if
/// there are
/// none.
std::vector<const MeshModel *> candidates(const gusset_filter &filter, const MeshDocument &document) {
    std::vector<const MeshModel *> layers, found;
    if (document.mm() != nullptr) {
        layers.push_back(document.mm());
    }
    for (const bool visible : {true, false}) {
        for (const MeshModel &layer : document.meshIterator()) {
            if (&layer != document.mm() && layer.isVisible() == visible && filter.max_inputs > 1) {
                layers.push_back(&layer);
            }
        }
    }
    while (found.size() < filter.max_inputs) {
        const auto layer = std::find_if(layers.begin(), layers.end(), [&](const MeshModel *one) {
            return fits(one->cm, input_kind(filter, found.size()));
        });
        if (layer == layers.end()) {
            break;
        }
        found.push_back(*layer);
        layers.erase(layer);
    }
    return found;
}

} // namespace

GussetFilters::GussetFilters() : plugin_(GUSSET_PLUGIN_PATH) {
    const int count = plugin_.tables() != nullptr ? static_cast<int>(plugin_.tables()->filter_count) : 0;
    for (int id = 0; id < count; ++id) {
        typeList.push_back(id);
        actionList.push_back(new QAction(filterName(id), this));
    }
}

std::pair<std::string, bool> GussetFilters::getMLVersion() const {
    if (plugin_.tables() == nullptr) {
        throw MLException(QString::fromStdString(plugin_.error()));
    }
    return {meshlab::meshlabVersion(), meshlab::builtWithDoublePrecision()};
}

QString GussetFilters::pluginName() const {
    return plugin_.tables() != nullptr ? text(plugin_.tables()->name) : "gusset";
}
QString GussetFilters::vendor() const {
    return plugin_.tables() != nullptr ? text(plugin_.tables()->vendor) : QString();
}

QString GussetFilters::filterName(ActionIDType id) const {
    return text(plugin_.tables()->name) + ": " + text(plugin_.filter(id).name);
}

QString GussetFilters::pythonFilterName(ActionIDType id) const {
    return text(plugin_.tables()->id) + "_" + text(plugin_.filter(id).script_name);
}

QString GussetFilters::filterInfo(ActionIDType id) const {
    const gusset_filter &filter = plugin_.filter(id);
    QString info = text(filter.help).toHtmlEscaped();
    if (filter.max_inputs > NAMED_INPUTS) {
        info += "<br>It takes all visible layers.";
    }
    return info + "<br><br><i>" + text(filter.reference).toHtmlEscaped() + "</i><br>" + pluginName() + " " +
           text(plugin_.tables()->version);
}

FilterPlugin::FilterClass GussetFilters::getClass(const QAction *action) const {
    const gusset_filter &of = filter(action);
    int found = of.max_inputs == 0 ? MeshCreation : of.max_inputs > 1 ? Layer : 0;
    if ((of.flags & GUSSET_FILTER_REPLACES) != 0) {
        found |= text(of.category) == "Repair" ? Cleaning : Remeshing;
    } else if (of.max_inputs > 0) {
        found |= gives(of, GUSSET_KIND_CURVES) ? Measure : Remeshing;
    }
    return static_cast<FilterClass>(found);
}

FilterPlugin::FilterArity GussetFilters::filterArity(const QAction *action) const {
    const gusset_filter &of = filter(action);
    return of.max_inputs == 0 ? NONE : of.max_inputs == 1 ? SINGLE_MESH : named(of) ? FIXED : VARIABLE;
}

int GussetFilters::getPreConditions(const QAction *action) const {
    const gusset_filter &of = filter(action);
    // Only the current layer is checked; if layers are chosen by parameters, a run reports missing ones.
    const bool faces = of.min_inputs == 1 && of.max_inputs == 1 && input_kind(of, 0) == GUSSET_KIND_MESH;
    return faces ? MeshModel::MM_FACENUMBER : MeshModel::MM_NONE;
}

int GussetFilters::postCondition(const QAction *action) const {
    const bool replaces = (filter(action).flags & GUSSET_FILTER_REPLACES) != 0;
    return replaces ? MeshModel::MM_GEOMETRY_AND_TOPOLOGY_CHANGE : MeshModel::MM_NONE;
}

RichParameterList GussetFilters::initParameterList(const QAction *action, const MeshModel &layer) {
    const gusset_filter &of = filter(action);
    Inputs inputs;
    if (of.max_inputs > 0) {
        inputs.add(layer, input_kind(of, 0));
    }
    RichParameterList list;
    describe(of, suggested(of, inputs.list()), layer.cm.bbox.IsNull() ? 1 : layer.cm.bbox.Diag(), list);
    return list;
}

RichParameterList GussetFilters::initParameterList(const QAction *action, const MeshDocument &document) {
    const gusset_filter &of = filter(action);
    const std::vector<const MeshModel *> layers = candidates(of, document);
    const MeshModel *usual = layers.empty() ? document.mm() : layers.back();
    RichParameterList list;
    for (std::uint32_t k = 0; named(of) && k < of.max_inputs && usual != nullptr; ++k) {
        const QString label = QString("Layer %1").arg(k + 1);
        if (k >= of.min_inputs) {
            list.addParam(RichBool(use_id(k), k < layers.size(), "With " + label.toLower(),
                                   "Whether this layer is an input too."));
        }
        const MeshModel *layer = k < layers.size() ? layers[k] : usual;
        list.addParam(RichMesh(layer_id(k), static_cast<unsigned>(layer->id()), &document, label,
                               QString("Input %1 of the filter.").arg(k + 1)));
    }
    Inputs inputs;
    for (const MeshModel *layer : layers) {
        inputs.add(*layer, input_kind(of, inputs.list().size()));
    }
    const Box3m box = document.bbox();
    describe(of, suggested(of, inputs.list()), box.IsNull() ? 1 : box.Diag(), list);
    return list;
}

/// The layers that a run takes.
std::vector<unsigned int> GussetFilters::chosen(const gusset_filter &of, const RichParameterList &list,
                                                const MeshDocument &document) const {
    std::vector<unsigned int> ids;
    if (named(of)) {
        for (std::uint32_t k = 0; k < of.max_inputs; ++k) {
            if (k < of.min_inputs || list.getBool(use_id(k))) {
                ids.push_back(list.getMeshId(layer_id(k)));
            }
        }
    } else if (of.max_inputs > 1) {
        for (const MeshModel &layer : document.meshIterator()) {
            if (layer.isVisible() && fits(layer.cm, input_kind(of, ids.size()))) {
                ids.push_back(static_cast<unsigned>(layer.id()));
            }
        }
    } else if (of.max_inputs == 1 && document.mm() != nullptr) {
        ids.push_back(static_cast<unsigned>(document.mm()->id()));
    }
    return ids;
}

std::map<std::string, QVariant> GussetFilters::applyFilter(const QAction *action, const RichParameterList &list,
                                                           MeshDocument &document, unsigned int &,
                                                           vcg::CallBackPos *progress) {
    const gusset_filter &of = filter(action);
    std::vector<MeshModel *> layers;
    Inputs inputs;
    for (const unsigned int id : chosen(of, list, document)) {
        MeshModel *layer = document.getMesh(id);
        const std::uint32_t kind = input_kind(of, layers.size());
        if (layer == nullptr || !fits(layer->cm, kind)) {
            throw MLException(kind == GUSSET_KIND_CURVES ? "the layer has no edges" : "the layer has no faces");
        }
        // So that vertices and faces have the same numbers in the layer and in the filter's view of it.
        vcg::tri::Allocator<CMeshO>::CompactEveryVector(layer->cm);
        inputs.add(*layer, kind);
        layers.push_back(layer);
    }
    const Listener listener{
        [&](double fraction, const char *stage) {
            const double done = fraction > 0 ? std::min(fraction, 1.0) : 0.0; // NaN is 0
            return progress == nullptr || progress(static_cast<int>(100 * done), stage);
        },
        [&](const char *message) { log(message); },
    };
    try {
        const Outputs outputs(*plugin_.tables(), of, inputs.list(), values_of(of, list), listener);
        std::map<std::string, QVariant> counts, numbers;
        for (std::uint32_t k = 0; k < outputs.count(); ++k) {
            if (outputs.kind(k) == GUSSET_KIND_TEXT) {
                std::istringstream lines(outputs.text(k));
                for (std::string line; std::getline(lines, line);) {
                    log(line.c_str());
                }
                for (const auto &[name, value] : outputs.values(k)) {
                    numbers[name] = number(value);
                }
                continue;
            }
            const Attributes attributes(inputs, outputs, k);
            MeshModel *layer = nullptr;
            if (k == 0 && (of.flags & GUSSET_FILTER_REPLACES) != 0) {
                layer = layers[0];
                if (outputs.kind(k) == GUSSET_KIND_MESH) {
                    replace(*layer, outputs.mesh(k), inputs.faces(0), attributes);
                } else {
                    replace(*layer, outputs.curves(k));
                }
            } else {
                layer = document.addNewMesh(QString(), text(of.name));
                layer->cm.Tr = layers.empty() ? Matrix44m::Identity() : layers[0]->cm.Tr;
                if (outputs.kind(k) == GUSSET_KIND_MESH) {
                    fill(*layer, outputs.mesh(k), attributes);
                } else {
                    fill(*layer, outputs.curves(k));
                }
            }
            counts["layer"] = layer->id();
            counts["vertices"] = layer->cm.vn;
            counts["edges"] = layer->cm.en;
            counts["faces"] = layer->cm.fn;
        }
        // Values of the layer replace values of one name in the report.
        counts.insert(numbers.begin(), numbers.end());
        return counts;
    } catch (const std::runtime_error &error) {
        throw MLException(QString::fromStdString(error.what()));
    }
}
