// All filters of a gusset plugin as one MeshLab plugin. Nothing here knows which filters there are.
#pragma once

#include "layers.hpp"
#include "plugin.hpp"

#include <common/plugins/interfaces/filter_plugin.h>

class GussetFilters : public QObject, public FilterPlugin {
    Q_OBJECT
    Q_PLUGIN_METADATA(IID FILTER_PLUGIN_IID)
    Q_INTERFACES(FilterPlugin)

public:
    GussetFilters();

    /// Throws MLException if the plugin cannot be loaded. A host calls it first, and reports the exception.
    std::pair<std::string, bool> getMLVersion() const override;
    QString pluginName() const override;
    QString vendor() const override;

    QString filterName(ActionIDType filter) const override;
    QString pythonFilterName(ActionIDType filter) const override;
    QString filterInfo(ActionIDType filter) const override;
    FilterClass getClass(const QAction *action) const override;
    FilterArity filterArity(const QAction *action) const override;
    int getPreConditions(const QAction *action) const override;
    int postCondition(const QAction *action) const override;
    RichParameterList initParameterList(const QAction *action, const MeshModel &layer) override;
    RichParameterList initParameterList(const QAction *action, const MeshDocument &document) override;
    std::map<std::string, QVariant> applyFilter(const QAction *action, const RichParameterList &list,
                                                MeshDocument &document, unsigned int &post_condition,
                                                vcg::CallBackPos *progress) override;

private:
    const gusset_filter &filter(const QAction *action) const { return plugin_.filter(ID(action)); }
    std::vector<unsigned int> chosen(const gusset_filter &filter, const RichParameterList &list,
                                     const MeshDocument &document) const;

    Plugin plugin_;
};
