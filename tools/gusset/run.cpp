#include "run.hpp"

#include "attributes.hpp"
#include "carry.hpp"
#include "steering.hpp"
#include "values.hpp"

#include <algorithm>
#include <cstring>
#include <iostream>
#include <memory>
#include <sstream>

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
Failure refusal(const Plugin &plugin, const gusset_filter &filter, const RunRequest &request,
                const gusset_outputs *outputs, int32_t status) {
    const Exit exit = exit_of(status);
    gusset_failure failure{};
    failure.struct_size = sizeof failure;
    if (plugin->output_failure(outputs, &failure) != GUSSET_PLUGIN_DONE) {
        Failure made(exit, std::string(filter.id) + ": status " + std::to_string(status));
        made.status = status;
        return made;
    }
    std::string text = std::string(filter.id) + ": " + failure.message + " (status " + std::to_string(status);
    const bool of_parameter = failure.param < filter.param_count;
    if (of_parameter) {
        text += std::string(", parameter ") + filter.param(&filter, failure.param)->id;
    }
    if (failure.input < request.inputs.size()) {
        text += ", input " + std::to_string(failure.input + 1) + ": " + request.inputs[failure.input].path;
    }
    if (is_place(failure.element)) {
        text +=
            std::string(", ") + element_name(failure.element) + " number " + std::to_string(failure.index) + " from 0";
    }
    Failure made(exit, text + ')');
    made.status = status;
    made.parameter = of_parameter ? filter.param(&filter, failure.param)->id : "";
    if (failure.input != GUSSET_PLUGIN_NONE) {
        made.input = failure.input;
    }
    if (is_place(failure.element)) {
        made.element = element_name(failure.element);
        made.index = failure.index;
    }
    return made;
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
    if (view.merge != nullptr) {
        mesh.merge = indices(view.merge, view.vertex_count);
    }
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
std::vector<std::string> files_of_outputs(const gusset_filter &filter, const RunRequest &request) {
    std::vector<std::string> files(filter.output_count);
    std::size_t next = 0;
    bool makes_mesh = false, tells = false;
    for (uint32_t i = 0; i < filter.output_count; ++i) {
        const uint32_t kind = filter.output_kinds[i];
        makes_mesh = makes_mesh || kind == GUSSET_KIND_MESH;
        tells = tells || kind == GUSSET_KIND_TEXT;
        if (kind == GUSSET_KIND_TEXT || next >= request.outputs.size()) {
            continue;
        }
        kind == GUSSET_KIND_MESH ? check_mesh_name(request.outputs[next]) : check_curves_name(request.outputs[next]);
        files[i] = request.outputs[next++];
    }
    if (next < request.outputs.size()) {
        throw Failure(Exit::usage, std::string(filter.id) + " has " + number_of(next, "output") + " for files, and " +
                                       std::to_string(request.outputs.size()) + " are named");
    }
    if (request.outputs.empty() && !request.dry && (makes_mesh || !tells)) {
        throw Failure(Exit::usage, request.command + " makes " + (makes_mesh ? "a mesh" : "curves") +
                                       ": name the file with -o, or ask for the report alone with --dry-run");
    }
    return files;
}

/// A line on the standard error for each, and the list for the report.
Json tell_losses(const std::string &path, const std::vector<std::string> &losses) {
    for (const std::string &loss : losses) {
        std::cerr << "gusset: " << path << ": lost: " << loss << '\n';
    }
    return losses;
}

/// The meshes that went in, for what they carry; and what their files had beyond that.
std::vector<Piece> pieces_of(const Inputs &inputs, const RunRequest &request, std::vector<std::string> &lost) {
    std::vector<Piece> pieces;
    for (std::size_t i = 0; i < inputs.geometry().size(); ++i) {
        if (const auto *mesh = std::get_if<Mesh>(&inputs.geometry()[i])) {
            pieces.push_back({mesh, request.inputs[i].path});
            for (const std::string &what : mesh->unread) {
                lost.push_back(what + " of " + request.inputs[i].path);
            }
        }
    }
    return pieces;
}

/// Whether any input has more than positions and faces.
bool carries(const Inputs &inputs) {
    return std::any_of(inputs.geometry().begin(), inputs.geometry().end(), [](const auto &input) {
        const auto *mesh = std::get_if<Mesh>(&input);
        return mesh != nullptr && !attribute_names(*mesh).empty();
    });
}

Json write_mesh_output(const std::string &file, Mesh mesh, const Origins &origins, const Inputs &inputs,
                       const RunRequest &request) {
    std::vector<std::string> lost;
    const std::vector<Piece> pieces = pieces_of(inputs, request, lost);
    const auto on_the_way = carry(pieces, origins, mesh);
    lost.insert(lost.end(), on_the_way.begin(), on_the_way.end());
    Json made = json_of(file, mesh);
    const Losses in_the_file = write_mesh(file, mesh, request.text);
    lost.insert(lost.end(), in_the_file.begin(), in_the_file.end());
    made["lost"] = tell_losses(file, lost);
    return made;
}

/// Lines as a list, and the numbers in them.
void add_text(const Plugin &plugin, const gusset_outputs *outputs, uint32_t index, Json &report) {
    const char *text = plugin->output_text(outputs, index);
    std::istringstream lines(text != nullptr ? text : "");
    for (std::string line; std::getline(lines, line);) {
        report["report"].push_back(line);
    }
    const gusset_plugin_values *values = plugin.values();
    for (uint32_t v = 0; values != nullptr && v < values->count(outputs, index); ++v) {
        report["values"][values->name(outputs, index, v)] = json_of(values->value(outputs, index, v));
    }
}

void write(const Plugin &plugin, const gusset_outputs *outputs, const std::vector<std::string> &files,
           const Inputs &inputs, const RunRequest &request, Json &report) {
    for (uint32_t i = 0; i < files.size(); ++i) {
        const uint32_t kind = plugin->output_kind(outputs, i);
        if (kind == GUSSET_KIND_TEXT) {
            add_text(plugin, outputs, i, report);
            const char *text = plugin->output_text(outputs, i);
            if (!request.json && text != nullptr) {
                std::cout << text;
            }
        } else if (!files[i].empty() && !request.dry && kind == GUSSET_KIND_MESH) {
            const Origins origins(plugin, outputs, i);
            report["outputs"].push_back(
                write_mesh_output(files[i], mesh_of(plugin, outputs, i), origins, inputs, request));
        } else if (!files[i].empty() && !request.dry && kind == GUSSET_KIND_CURVES) {
            const Curves curves = curves_of(plugin, outputs, i);
            write_curves(files[i], curves);
            report["outputs"].push_back(json_of(files[i], curves));
        }
    }
}

Json inputs_of_run(const Inputs &inputs, const RunRequest &request) {
    Json made = Json::array();
    for (std::size_t i = 0; i < request.inputs.size(); ++i) {
        made.push_back(
            std::visit([&](const auto &one) { return json_of(request.inputs[i].path, one); }, inputs.geometry()[i]));
    }
    return made;
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
    // What is wrong with the command is said before anything is read.
    check_count(filter, request.inputs.size());
    const std::vector<std::string> files = files_of_outputs(filter, request);
    static_cast<void>(parse_values(filter, std::vector<double>(filter.value_count), request.params));
    const Inputs inputs(filter, request.inputs);
    // If the inputs are refused already, the run will say why.
    const std::vector<double> values = parse_values(filter, suggest(filter, inputs).values, request.params);
    Json report = {{"command", request.command},
                   {"filter", filter.id},
                   {"inputs", inputs_of_run(inputs, request)},
                   {"parameters", json_of(filter, values)},
                   {"outputs", Json::array()}};

    const bool origins = plugin.attributes() != nullptr && carries(inputs);
    Steering steering(request.threads, origins, request.progress, request.cancel_after);
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
        throw refusal(plugin, filter, request, outputs.get(), status);
    }
    write(plugin, outputs.get(), files, inputs, request, report);
    if (request.json) {
        std::cout << report.dump(2) << '\n';
    }
}

void convert(const RunRequest &request) {
    if (request.outputs.empty()) {
        throw Failure(Exit::usage, "convert writes a mesh: name its file with -o");
    }
    check_mesh_name(request.outputs[0]);
    if (request.inputs.size() != 1) {
        throw Failure(Exit::usage, "convert reads one mesh");
    }
    const InputFile &file = request.inputs[0];
    Mesh mesh = read_mesh(file.path);
    if (file.pose) {
        place(mesh, *file.pose);
    }
    Losses lost;
    for (const std::string &what : mesh.unread) {
        lost.push_back(what + " of " + file.path);
    }
    const Losses in_the_file = write_mesh(request.outputs[0], mesh, request.text);
    lost.insert(lost.end(), in_the_file.begin(), in_the_file.end());
    Json made = json_of(request.outputs[0], mesh);
    made["lost"] = tell_losses(request.outputs[0], lost);
    if (request.json) {
        const Json report = {{"command", request.command},
                             {"inputs", Json::array({json_of(file.path, mesh)})},
                             {"outputs", Json::array({made})}};
        std::cout << report.dump(2) << '\n';
    }
}
