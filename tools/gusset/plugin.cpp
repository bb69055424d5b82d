#include "plugin.hpp"

#include "failure.hpp"

#include <dlfcn.h>

#include <algorithm>

void Plugin::Close::operator()(void *open) const { dlclose(open); }

Plugin::Plugin(const std::string &name) : library(dlopen(name.c_str(), RTLD_NOW | RTLD_LOCAL)) {
    if (!library) {
        throw Failure(Exit::plugin, dlerror());
    }
    const auto entry = reinterpret_cast<gusset_plugin_entry_fn>(dlsym(library.get(), "gusset_plugin_entry"));
    if (entry == nullptr) {
        throw Failure(Exit::plugin, name + " is no plugin: it has no gusset_plugin_entry");
    }
    tables = entry(GUSSET_PLUGIN_ABI);
    if (tables == nullptr || tables->abi != GUSSET_PLUGIN_ABI || tables->struct_size < sizeof(gusset_plugin)) {
        throw Failure(Exit::plugin, name + " does not serve hosts of ABI " + std::to_string(GUSSET_PLUGIN_ABI));
    }
}

std::vector<const gusset_filter *> Plugin::filters() const {
    std::vector<const gusset_filter *> all;
    for (uint32_t i = 0; i < tables->filter_count; ++i) {
        all.push_back(tables->filter(i));
    }
    return all;
}

const gusset_filter *Plugin::find_or_null(const std::string &name) const {
    if (const gusset_filter *found = tables->find(name.c_str())) {
        return found;
    }
    const auto all = filters();
    const auto found =
        std::find_if(all.begin(), all.end(), [&](const auto *filter) { return name == filter->script_name; });
    return found == all.end() ? nullptr : *found;
}

const gusset_filter *Plugin::find(const std::string &name) const {
    const gusset_filter *found = find_or_null(name);
    if (found == nullptr) {
        throw Failure(Exit::usage, "there is no filter " + name + "; 'gusset filters' shows them all");
    }
    return found;
}

const gusset_plugin_values *Plugin::values() const {
    const auto *found = static_cast<const gusset_plugin_values *>(tables->extension("values/1"));
    return found != nullptr && found->struct_size >= sizeof *found ? found : nullptr;
}

const gusset_plugin_attributes *Plugin::attributes() const {
    const auto *found = static_cast<const gusset_plugin_attributes *>(tables->extension("attributes/1"));
    return found != nullptr && found->struct_size >= sizeof *found ? found : nullptr;
}

std::vector<const gusset_param_info *> params(const gusset_filter &filter) {
    std::vector<const gusset_param_info *> all;
    for (uint32_t i = 0; i < filter.param_count; ++i) {
        all.push_back(filter.param(&filter, i));
    }
    return all;
}

uint32_t input_kind(const gusset_filter &filter, std::size_t place) {
    if (filter.input_kind_count == 0 || place >= filter.max_inputs) {
        return 0;
    }
    return filter.input_kinds[std::min<std::size_t>(place, filter.input_kind_count - 1)];
}

namespace {
gusset_plugin_mesh view(const Mesh &mesh) {
    gusset_plugin_mesh view{};
    view.struct_size = sizeof view;
    view.positions = mesh.points.data();
    view.vertex_count = mesh.points.size();
    view.face_offsets = mesh.offsets.data();
    view.face_corners = mesh.corners.data();
    view.face_count = mesh.offsets.size() - 1;
    view.scalar = GUSSET_PLUGIN_F64;
    view.merge = mesh.merge.empty() ? nullptr : mesh.merge.data();
    return view;
}

gusset_plugin_curves view(const Curves &curves) {
    gusset_plugin_curves view{};
    view.struct_size = sizeof view;
    view.points = curves.points.data();
    view.point_count = curves.points.size();
    view.offsets = curves.offsets.data();
    view.closed = curves.closed.data();
    view.curve_count = curves.closed.size();
    view.scalar = GUSSET_PLUGIN_F64;
    return view;
}
} // namespace

void check_count(const gusset_filter &filter, std::size_t count) {
    if (count >= filter.min_inputs && count <= filter.max_inputs) {
        return;
    }
    const std::string least = std::to_string(filter.min_inputs), most = std::to_string(filter.max_inputs);
    const std::string range = filter.max_inputs == UINT32_MAX ? least + " or more inputs"
                              : least == most                 ? number_of(filter.max_inputs, "input")
                                                              : least + " to " + most + " inputs";
    throw Failure(Exit::usage, std::string(filter.id) + " takes " + range + ", not " + std::to_string(count));
}

Inputs::Inputs(const gusset_filter &filter, const std::vector<InputFile> &files) {
    check_count(filter, files.size());
    for (std::size_t i = 0; i < files.size(); ++i) {
        if (input_kind(filter, i) == GUSSET_KIND_CURVES) {
            read.emplace_back(read_curves(files[i].path));
        } else {
            Mesh mesh = read_mesh(files[i].path);
            if (files[i].pose) {
                place(mesh, *files[i].pose);
            }
            read.emplace_back(std::move(mesh));
        }
    }
    // Their addresses are final from here on.
    for (const auto &one : read) {
        std::visit([&](const auto &geometry) { views.emplace_back(view(geometry)); }, one);
    }
    for (std::size_t i = 0; i < views.size(); ++i) {
        gusset_input input{};
        input.struct_size = sizeof input;
        input.kind = input_kind(filter, i);
        input.view = std::visit([](const auto &one) { return static_cast<const void *>(&one); }, views[i]);
        inputs.push_back(input);
    }
}
