#include "host.hpp"

#include <algorithm>
#include <cstdarg>
#include <cstdio>
#include <cstring>
#include <stdexcept>

namespace mfx {

namespace {

/// The active host: suites cannot receive it as an argument.
thread_local Session *session = nullptr;
thread_local Traits traits;
/// Every handle given out, by its kind.
thread_local std::map<Handle, char> handles;

void wrong(const std::string &what) { session->wrongs.push_back(what); }

template <typename T>
T *known(Handle handle, char kind) {
    const auto found = handles.find(handle);
    if (found == handles.end() || found->second != kind) {
        wrong(std::string("a handle that is no ") + kind);
        return nullptr;
    }
    return static_cast<T *>(handle);
}

template <typename T>
void give(Handle *out, T &object, char kind) {
    handles[&object] = kind;
    if (out != nullptr) {
        *out = &object;
    }
}

template <typename T>
Status set(Handle handle, const char *name, int index, T value) {
    Properties *set = known<Properties>(handle, 'p');
    if (set == nullptr) {
        return ERR_BAD_HANDLE;
    }
    auto &values = set->values[name];
    if (index < 0 || index > static_cast<int>(values.size())) {
        return ERR_BAD_INDEX;
    }
    values.resize(std::max(values.size(), static_cast<std::size_t>(index) + 1));
    values[static_cast<std::size_t>(index)] = std::move(value);
    return OK;
}

template <typename T>
T *find(Handle handle, const char *name, int index) {
    Properties *set = known<Properties>(handle, 'p');
    if (set == nullptr || index < 0 || !set->has(name) || index >= static_cast<int>(set->values[name].size())) {
        return nullptr;
    }
    return std::get_if<T>(&set->values[name][static_cast<std::size_t>(index)]);
}

template <typename T>
Status get(Handle handle, const char *name, int index, T *out) {
    const T *found = find<T>(handle, name, index);
    if (found == nullptr) {
        return ERR_UNKNOWN;
    }
    *out = *found;
    return OK;
}

Status set_pointer(Handle h, const char *name, int index, void *value) { return set<void *>(h, name, index, value); }
Status set_string(Handle h, const char *name, int index, const char *value) {
    return set<std::string>(h, name, index, value);
}
Status set_double(Handle h, const char *name, int index, double value) { return set<double>(h, name, index, value); }
Status set_int(Handle h, const char *name, int index, int value) { return set<int>(h, name, index, value); }
Status get_pointer(Handle h, const char *name, int index, void **out) { return get<void *>(h, name, index, out); }
Status get_double(Handle h, const char *name, int index, double *out) { return get<double>(h, name, index, out); }
Status get_int(Handle h, const char *name, int index, int *out) { return get<int>(h, name, index, out); }
Status get_string(Handle h, const char *name, int index, char **out) {
    std::string *found = find<std::string>(h, name, index);
    if (found == nullptr) {
        return ERR_UNKNOWN;
    }
    *out = found->data();
    return OK;
}

Status param_define(Handle h, const char *type, const char *name, Handle *properties) {
    static const std::set<std::string> kinds = {"OfxParamTypeInteger", "OfxParamTypeDouble", "OfxParamTypeDouble3D",
                                                "OfxParamTypeBoolean", "OfxParamTypeChoice"};
    ParamSet *set = known<ParamSet>(h, 's');
    if (set == nullptr) {
        return ERR_BAD_HANDLE;
    }
    if (kinds.count(type) == 0 || (!traits.has_choices && std::string(type) == "OfxParamTypeChoice")) {
        return ERR_UNSUPPORTED;
    }
    for (const auto &param : set->list) {
        if (param->name == name) {
            wrong(std::string("defined twice: ") + name);
            return ERR_EXISTS;
        }
    }
    set->list.push_back(std::make_unique<Param>());
    Param &param = *set->list.back();
    param.type = type;
    param.name = name;
    give(properties, param.properties, 'p');
    return OK;
}

Status param_handle(Handle h, const char *name, Handle *out, Handle *properties) {
    ParamSet *set = known<ParamSet>(h, 's');
    for (std::size_t k = 0; set != nullptr && k < set->list.size(); ++k) {
        if (set->list[k]->name == name) {
            give(out, *set->list[k], 'v');
            give(properties, set->list[k]->properties, 'p');
            return OK;
        }
    }
    return set == nullptr ? ERR_BAD_HANDLE : ERR_UNKNOWN;
}

Status param_value(Handle h, va_list arguments) {
    Param *param = known<Param>(h, 'v');
    if (param == nullptr) {
        return ERR_BAD_HANDLE;
    }
    const bool real = param->type == "OfxParamTypeDouble" || param->type == "OfxParamTypeDouble3D";
    for (const double value : param->values) {
        if (real) {
            *va_arg(arguments, double *) = value;
        } else {
            *va_arg(arguments, int *) = static_cast<int>(value);
        }
    }
    return OK;
}

Status param_get(Handle h, ...) {
    va_list arguments;
    va_start(arguments, h);
    const Status status = param_value(h, arguments);
    va_end(arguments);
    return status;
}

Status param_get_at(Handle h, double time, ...) {
    if (time != 7) {
        wrong("another time than that of the action");
    }
    if (!traits.has_values_at_time) {
        return ERR_UNSUPPORTED;
    }
    va_list arguments;
    va_start(arguments, time);
    const Status status = param_value(h, arguments);
    va_end(arguments);
    return status;
}

Status effect_properties(Handle h, Handle *out) {
    Effect *effect = known<Effect>(h, 'e');
    if (effect == nullptr) {
        return ERR_BAD_HANDLE;
    }
    give(out, effect->properties, 'p');
    return OK;
}

Status effect_params(Handle h, Handle *out) {
    Effect *effect = known<Effect>(h, 'e');
    if (effect == nullptr) {
        return ERR_BAD_HANDLE;
    }
    give(out, effect->params, 's');
    return OK;
}

Status input_define(Handle h, const char *name, Handle *input, Handle *properties) {
    Effect *effect = known<Effect>(h, 'e');
    if (effect == nullptr) {
        return ERR_BAD_HANDLE;
    }
    effect->inputs.push_back(std::make_unique<Input>());
    effect->inputs.back()->name = name;
    give(input, *effect->inputs.back(), 'i');
    give(properties, effect->inputs.back()->properties, 'p');
    return OK;
}

Status input_handle(Handle h, const char *name, Handle *out, Handle *properties) {
    Effect *effect = known<Effect>(h, 'e');
    for (std::size_t k = 0; effect != nullptr && k < effect->inputs.size(); ++k) {
        if (effect->inputs[k]->name == name) {
            give(out, *effect->inputs[k], 'i');
            give(properties, effect->inputs[k]->properties, 'p');
            return OK;
        }
    }
    return effect == nullptr ? ERR_BAD_HANDLE : ERR_UNKNOWN;
}

Attribute &define(Mesh &mesh, const char *attachment, const char *name, int components, const char *type) {
    mesh.attributes.push_back(std::make_unique<Attribute>());
    Attribute &attribute = *mesh.attributes.back();
    attribute.attachment = attachment;
    attribute.name = name;
    attribute.properties.values["OfxMeshAttribPropComponentCount"] = {components};
    attribute.properties.values["OfxMeshAttribPropType"] = {std::string(type)};
    attribute.properties.values["OfxMeshAttribPropData"] = {static_cast<void *>(nullptr)};
    attribute.properties.values["OfxMeshAttribPropStride"] = {0};
    return attribute;
}

void lend(Attribute &attribute, const void *data, int stride) {
    attribute.properties.values["OfxMeshAttribPropData"] = {const_cast<void *>(data)};
    attribute.properties.values["OfxMeshAttribPropStride"] = {stride};
}

Status input_mesh(Handle h, double time, Handle *out, Handle *properties) {
    Input *input = known<Input>(h, 'i');
    if (input == nullptr) {
        return ERR_BAD_HANDLE;
    }
    if (time != 7) {
        wrong("another time than that of the action");
    }
    Mesh &mesh = input->mesh;
    if (mesh.open) {
        wrong("a mesh is taken twice: " + input->name);
    }
    mesh = Mesh();
    mesh.is_output = input->name == "OfxMeshMainOutput";
    if (!mesh.is_output && !input->connected) {
        return FAILED;
    }
    mesh.open = true;
    Attribute &points = define(mesh, "OfxMeshAttribPoint", "OfxMeshAttribPointPosition", 3, "OfxMeshAttribTypeFloat");
    Attribute &corners = define(mesh, "OfxMeshAttribCorner", "OfxMeshAttribCornerPoint", 1, "OfxMeshAttribTypeInt");
    Attribute &sizes = define(mesh, "OfxMeshAttribFace", "OfxMeshAttribFaceSize", 1, "OfxMeshAttribTypeInt");
    if (!mesh.is_output) {
        mesh.data = &input->data;
        MeshData &data = input->data;
        const int corner_count = data.corner_count();
        const int faces =
            data.constant_size > 0 ? corner_count / data.constant_size : static_cast<int>(data.sizes.size());
        mesh.properties.values["OfxMeshPropPointCount"] = {data.point_count()};
        mesh.properties.values["OfxMeshPropCornerCount"] = {corner_count};
        mesh.properties.values["OfxMeshPropFaceCount"] = {faces};
        mesh.properties.values["OfxMeshPropNoLooseEdge"] = {data.loose_edges ? 0 : 1};
        mesh.properties.values["OfxMeshPropConstantFaceSize"] = {data.constant_size > 0 ? data.constant_size : -1};
        if (!data.matrix.empty()) {
            mesh.properties.values["OfxMeshPropTransformMatrix"] = {static_cast<void *>(data.matrix.data())};
        }
        lend(points, data.points.data(), data.point_stride * 4);
        lend(corners, data.corners.data(), data.corner_stride * 4);
        if (data.constant_size == 0) {
            lend(sizes, data.sizes.data(), 4);
        }
    }
    give(out, mesh, 'm');
    give(properties, mesh.properties, 'p');
    return OK;
}

int number(const Mesh &mesh, const char *name) { return mesh.properties.get<int>(name); }

/// Takes the mesh that the effect wrote.
void collect(const Mesh &mesh) {
    MeshData &out = session->output;
    out = MeshData();
    const auto bytes = [&](int which, std::size_t size) {
        const std::vector<char> &owned = mesh.attributes[static_cast<std::size_t>(which)]->owned;
        if (owned.size() != size) {
            wrong("counts changed after the allocation");
        }
        return owned;
    };
    const auto count = [&](const char *name) { return static_cast<std::size_t>(number(mesh, name)); };
    out.points.resize(3 * count("OfxMeshPropPointCount"));
    out.corners.resize(count("OfxMeshPropCornerCount"));
    out.constant_size = number(mesh, "OfxMeshPropConstantFaceSize");
    out.loose_edges = number(mesh, "OfxMeshPropNoLooseEdge") == 0;
    out.sizes.assign(count("OfxMeshPropFaceCount"), out.constant_size);
    const auto take = [&](auto &into, int which) {
        const auto from = bytes(which, into.size() * 4);
        if (!from.empty()) {
            std::memcpy(into.data(), from.data(), from.size());
        }
    };
    take(out.points, 0);
    take(out.corners, 1);
    if (out.constant_size < 0) {
        take(out.sizes, 2);
    }
}

Status release_mesh(Handle h) {
    Mesh *mesh = known<Mesh>(h, 'm');
    if (mesh == nullptr || !mesh->open) {
        wrong("a mesh is given back that was not taken");
        return ERR_BAD_HANDLE;
    }
    mesh->open = false;
    if (mesh->is_output && mesh->allocated) {
        collect(*mesh);
    }
    return OK;
}

Status get_attribute(Handle h, const char *attachment, const char *name, Handle *out) {
    Mesh *mesh = known<Mesh>(h, 'm');
    for (std::size_t k = 0; mesh != nullptr && k < mesh->attributes.size(); ++k) {
        if (mesh->attributes[k]->attachment == attachment && mesh->attributes[k]->name == name) {
            give(out, mesh->attributes[k]->properties, 'p');
            return OK;
        }
    }
    return mesh == nullptr ? ERR_BAD_HANDLE : ERR_BAD_INDEX;
}

Status alloc_mesh(Handle h) {
    Mesh *mesh = known<Mesh>(h, 'm');
    if (mesh == nullptr || !mesh->is_output || mesh->allocated) {
        wrong("memory for what is no new output");
        return ERR_BAD_HANDLE;
    }
    if (traits.out_of_memory) {
        return ERR_MEMORY;
    }
    const char *counts[] = {"OfxMeshPropPointCount", "OfxMeshPropCornerCount", "OfxMeshPropFaceCount"};
    const int sizes[] = {12, 4, number(*mesh, "OfxMeshPropConstantFaceSize") > 0 ? 0 : 4};
    for (std::size_t k = 0; k < 3; ++k) {
        Attribute &attribute = *mesh->attributes[k];
        attribute.owned.assign(static_cast<std::size_t>(number(*mesh, counts[k])) * static_cast<std::size_t>(sizes[k]),
                               0);
        lend(attribute, attribute.owned.empty() ? nullptr : attribute.owned.data(), sizes[k]);
    }
    mesh->allocated = true;
    return OK;
}

int abort_asked(Handle h) {
    Effect *effect = known<Effect>(h, 'e');
    return effect != nullptr && effect->abort_after >= 0 && effect->asked++ >= effect->abort_after ? 1 : 0;
}

Status message(Handle h, const char *type, const char *, const char *format, ...) {
    Effect *effect = known<Effect>(h, 'e');
    if (effect == nullptr) {
        return ERR_BAD_HANDLE;
    }
    std::array<char, 4096> text{};
    va_list arguments;
    va_start(arguments, format);
    std::vsnprintf(text.data(), text.size(), format, arguments);
    va_end(arguments);
    effect->messages[type].emplace_back(text.data());
    return OK;
}

const void *fetch(Handle, const char *name, int version) {
    static const PropertySuiteV1 properties = {set_pointer, set_string, set_double,  set_int,    nullptr,    nullptr,
                                               nullptr,     nullptr,    get_pointer, get_string, get_double, get_int,
                                               nullptr,     nullptr,    nullptr,     nullptr,    nullptr,    nullptr};
    static const ParameterSuiteV1 parameters = {param_define, param_handle, nullptr, nullptr,
                                                param_get,    param_get_at, {}};
    static const MeshEffectSuiteV1 meshes = {effect_properties, effect_params, input_define, input_handle, nullptr,
                                             nullptr,           input_mesh,    release_mesh, nullptr,      nullptr,
                                             get_attribute,     nullptr,       alloc_mesh,   abort_asked};
    static const MessageSuiteV1 messages = {message};
    const std::string suite = name;
    if (suite == "OfxPropertySuite" && version == 1) {
        return &properties;
    }
    if (suite == "OfxParameterSuite" && version == 1 && traits.has_parameters) {
        return &parameters;
    }
    if (suite == "OfxMeshEffectSuite" && version == 1 && traits.has_meshes) {
        return &meshes;
    }
    return suite == "OfxMessageSuite" && version == 1 && traits.has_messages ? &messages : nullptr;
}

} // namespace

Input &Effect::input(const std::string &name) {
    for (const auto &input : inputs) {
        if (input->name == name) {
            return *input;
        }
    }
    throw std::out_of_range("no input " + name);
}

Param &Effect::param(const std::string &name) {
    for (const auto &param : params.list) {
        if (param->name == name) {
            return *param;
        }
    }
    throw std::out_of_range("no parameter " + name);
}

Session::Session(const OfxPlugin &plugin, Traits of) : plugin_(plugin), host_{this, fetch} {
    session = this;
    traits = of;
    handles.clear();
    handles[&in_args_] = 'p';
    in_args_.values["OfxPropTime"] = {7.0};
    plugin.setHost(&host_);
    act("OfxActionLoad");
    described = act("OfxActionDescribe", &descriptor);
}

Session::~Session() {
    act("OfxActionDestroyInstance", &instance);
    act("OfxActionUnload");
    plugin_.setHost(nullptr);
    session = nullptr;
}

Status Session::act(const char *action, Handle handle, Handle in_args) {
    if (handle != nullptr) {
        handles[handle] = 'e';
    }
    return plugin_.mainEntry(action, handle, in_args, nullptr);
}

void Session::instantiate() {
    for (const auto &input : descriptor.inputs) {
        instance.inputs.push_back(std::make_unique<Input>());
        instance.inputs.back()->name = input->name;
    }
    for (const auto &param : descriptor.params.list) {
        instance.params.list.push_back(std::make_unique<Param>(*param));
        for (const auto &value : param->properties.values.at("OfxParamPropDefault")) {
            const int *whole = std::get_if<int>(&value);
            instance.params.list.back()->values.push_back(whole != nullptr ? *whole : std::get<double>(value));
        }
    }
    act("OfxActionCreateInstance", &instance);
}

Status Session::cook() {
    output = MeshData();
    instance.messages.clear();
    instance.asked = 0;
    const Status status = act("OfxMeshEffectActionCook", &instance, &in_args_);
    for (const auto &input : instance.inputs) {
        if (input->mesh.open) {
            wrong("a mesh was not given back: " + input->name);
        }
    }
    return status;
}

} // namespace mfx
