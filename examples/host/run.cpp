#include "run.hpp"

#include "steering.hpp"
#include "values.hpp"

#include <cstring>
#include <iostream>
#include <memory>

namespace {
struct Free {
    const gusset_plugin *plugin;
    void operator()(gusset_outputs *outputs) const { plugin->output_free(outputs); }
};
using Outputs = std::unique_ptr<gusset_outputs, Free>;

const char *element_name(uint32_t element) {
    switch (element) {
    case 1:
        return "vertex";
    case 2:
        return "face";
    case 3:
        return "corner";
    default:
        return "element";
    }
}

/// Whether an index is a place to look at: not if it means nothing, nor if it is a count.
bool is_place(uint32_t element) { return element != 0 && element != 6; }

/// The plugin's own account: its sentence, and which parameter, input and element it is about.
Failure refusal(const Plugin &plugin, const gusset_filter &filter, const gusset_outputs *outputs, int32_t status) {
    const Exit exit = exit_of(status);
    gusset_failure failure{};
    failure.struct_size = sizeof failure;
    if (plugin->output_failure(outputs, &failure) != GUSSET_PLUGIN_DONE) {
        return {exit, std::string(filter.id) + ": status " + std::to_string(status)};
    }
    std::string text = std::string(filter.id) + ": " + failure.message + " (status " + std::to_string(status);
    if (failure.param < filter.param_count) {
        text += std::string(", parameter ") + filter.param(&filter, failure.param)->id;
    }
    if (failure.input != GUSSET_PLUGIN_NONE) {
        text += ", input " + std::to_string(failure.input + 1);
    }
    if (is_place(failure.element)) {
        text +=
            std::string(", ") + element_name(failure.element) + " number " + std::to_string(failure.index) + " from 0";
    }
    return {exit, text + ')'};
}

std::vector<Point> points(const void *data, std::size_t stride, std::size_t count, uint32_t scalar) {
    const std::size_t size = scalar == GUSSET_PLUGIN_F32 ? sizeof(float) : sizeof(double);
    const std::size_t step = stride == 0 ? 3 * size : stride;
    std::vector<Point> all(count);
    for (std::size_t p = 0; p < count; ++p) {
        for (std::size_t k = 0; k < 3; ++k) {
            const unsigned char *from = static_cast<const unsigned char *>(data) + p * step + k * size;
            float single = 0;
            if (scalar == GUSSET_PLUGIN_F32) {
                std::memcpy(&single, from, size);
                all[p][k] = static_cast<double>(single);
            } else {
                std::memcpy(&all[p][k], from, size);
            }
        }
    }
    return all;
}

std::vector<uint32_t> indices(const void *data, std::size_t count) {
    std::vector<uint32_t> all(count);
    if (count > 0) {
        std::memcpy(all.data(), data, count * sizeof(uint32_t));
    }
    return all;
}

Mesh mesh_of(const Plugin &plugin, const gusset_outputs *outputs, uint32_t index) {
    gusset_plugin_mesh view{};
    view.struct_size = sizeof view;
    if (plugin->output_mesh(outputs, index, &view) != GUSSET_PLUGIN_DONE) {
        throw Failure(Exit::plugin, "output " + std::to_string(index) + " is no mesh");
    }
    Mesh mesh;
    mesh.points = points(view.positions, view.position_stride, view.vertex_count, view.scalar);
    mesh.offsets = indices(view.face_offsets, view.face_count + 1);
    mesh.corners = indices(view.face_corners, mesh.offsets.back());
    return mesh;
}

Curves curves_of(const Plugin &plugin, const gusset_outputs *outputs, uint32_t index) {
    gusset_plugin_curves view{};
    view.struct_size = sizeof view;
    if (plugin->output_curves(outputs, index, &view) != GUSSET_PLUGIN_DONE) {
        throw Failure(Exit::plugin, "output " + std::to_string(index) + " is no set of curves");
    }
    Curves curves;
    curves.points = points(view.points, view.point_stride, view.point_count, view.scalar);
    if (view.curve_count > 0) {
        curves.offsets = indices(view.offsets, view.curve_count + 1);
    }
    curves.closed.assign(view.curve_count, 0);
    if (view.closed != nullptr) {
        curves.closed.assign(view.closed, view.closed + view.curve_count);
    }
    return curves;
}

/// The files of the outputs, one for each that is no text; refused before the work is done rather than after.
std::vector<std::string> files_of_outputs(const gusset_filter &filter, const std::vector<std::string> &given) {
    std::vector<std::string> files(filter.output_count);
    std::size_t next = 0;
    for (uint32_t i = 0; i < filter.output_count && next < given.size(); ++i) {
        if (filter.output_kinds[i] == GUSSET_KIND_MESH) {
            check_mesh_name(given[next]);
        } else if (filter.output_kinds[i] == GUSSET_KIND_CURVES) {
            check_curves_name(given[next]);
        } else {
            continue;
        }
        files[i] = given[next++];
    }
    if (next < given.size()) {
        throw Failure(Exit::usage, std::string(filter.id) + " has " + number_of(next, "output") +
                                       " for files, and " + std::to_string(given.size()) + " are named");
    }
    return files;
}

void write(const Plugin &plugin, const gusset_outputs *outputs, const std::vector<std::string> &files) {
    for (uint32_t i = 0; i < files.size(); ++i) {
        const uint32_t kind = plugin->output_kind(outputs, i);
        if (kind == GUSSET_KIND_TEXT) {
            const char *text = plugin->output_text(outputs, i);
            std::cout << (text != nullptr ? text : "");
        } else if (!files[i].empty() && kind == GUSSET_KIND_MESH) {
            write_mesh(files[i], mesh_of(plugin, outputs, i));
        } else if (!files[i].empty() && kind == GUSSET_KIND_CURVES) {
            write_curves(files[i], curves_of(plugin, outputs, i));
        }
    }
}
} // namespace

Exit exit_of(int32_t status) {
    // Defects of the plugin have this status and those above.
    constexpr int32_t internal_error = 9999;
    return status >= internal_error                ? Exit::plugin
           : status == GUSSET_PLUGIN_OUT_OF_MEMORY ? Exit::memory
                                                   : Exit::refused;
}

Suggested suggest(const gusset_filter &filter, const Inputs &inputs) {
    Suggested suggested{std::vector<double>(filter.value_count), 0};
    suggested.status = filter.suggest(&filter, inputs.data(), inputs.count(), suggested.values.data());
    return suggested;
}

void run(const Plugin &plugin, const RunRequest &request) {
    const gusset_filter &filter = *plugin.find(request.filter);
    const std::vector<std::string> files = files_of_outputs(filter, request.outputs);
    // What is wrong with the command is said before anything is read.
    static_cast<void>(parse_values(filter, std::vector<double>(filter.value_count), request.params));
    const Inputs inputs(filter, request.inputs);
    // If the inputs are refused already, the run will say why.
    const std::vector<double> values = parse_values(filter, suggest(filter, inputs).values, request.params);

    Steering steering(request.threads, request.progress, request.cancel_after);
    gusset_outputs *raw = nullptr;
    const int32_t status =
        filter.run(&filter, steering.host(), inputs.data(), inputs.count(), values.data(), filter.value_count, &raw);
    const auto returned = Steering::Clock::now();
    const Outputs outputs(raw, Free{plugin.operator->()});
    steering.finish();

    if (status == GUSSET_PLUGIN_CANCELLED) {
        const auto late = steering.since_request(returned);
        throw Failure(Exit::cancelled,
                      "cancelled" + (late ? ", " + print_number(*late) + " ms after the request" : ""));
    }
    if (status != GUSSET_PLUGIN_DONE) {
        throw refusal(plugin, filter, outputs.get(), status);
    }
    write(plugin, outputs.get(), files);
}
