// A minimal host of OpenMfx effects, strict about what effects may do.
#pragma once

#include "mfx.hpp"

#include <array>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <variant>
#include <vector>

namespace mfx {

/// Named values. The host refuses unknown names, as hosts do.
struct Properties {
    using Value = std::variant<std::monostate, void *, std::string, double, int>;
    std::map<std::string, std::vector<Value>> values;

    template <typename T>
    T get(const std::string &name, std::size_t index = 0) const {
        return std::get<T>(values.at(name).at(index));
    }
    bool has(const std::string &name) const { return values.count(name) > 0; }
};

/// Arrays of a mesh as the host keeps them: any stride, and sizes of faces only where they differ.
struct MeshData {
    std::vector<float> points;
    std::vector<int> corners;
    std::vector<int> sizes;
    /// 0, or the number of corners of all faces; then sizes are not handed over.
    int constant_size = 0;
    /// Floats and ints between the starts of two elements.
    int point_stride = 3, corner_stride = 1;
    /// Row after row; empty for the identity.
    std::vector<double> matrix;
    bool loose_edges = false;

    int point_count() const { return (static_cast<int>(points.size()) + point_stride - 3) / point_stride; }
    int corner_count() const { return (static_cast<int>(corners.size()) + corner_stride - 1) / corner_stride; }
};

struct Attribute {
    Properties properties;
    std::string attachment, name;
    std::vector<char> owned;
};

// No two things with handles have one address: handles are known by their addresses.

struct Mesh {
    bool is_output = false, open = false, allocated = false;
    Properties properties;
    std::vector<std::unique_ptr<Attribute>> attributes;
    /// Properties of an input.
    MeshData *data = nullptr;
};

struct Input {
    std::string name;
    Properties properties;
    Mesh mesh;
    MeshData data;
    bool connected = false;
};

struct Param {
    std::string type, name;
    Properties properties;
    /// Unset values are the defaults.
    std::vector<double> values;
};

struct ParamSet {
    std::vector<std::unique_ptr<Param>> list;
};

struct Effect {
    /// Says stop when it has been asked so often; never if negative.
    int abort_after = -1;
    int asked = 0;
    Properties properties;
    std::vector<std::unique_ptr<Input>> inputs;
    ParamSet params;
    std::map<std::string, std::vector<std::string>> messages;

    Input &input(const std::string &name);
    Param &param(const std::string &name);
    void set(const std::string &name, std::vector<double> values) { param(name).values = std::move(values); }
};

/// Options in which hosts differ.
struct Traits {
    bool has_messages = true, has_parameters = true, has_meshes = true;
    bool has_values_at_time = true, has_choices = true;
    bool out_of_memory = false;
};

/// One effect of a library in one host: described, with an instance that can be cooked any number of times.
class Session {
public:
    explicit Session(const OfxPlugin &plugin, Traits traits = {});
    ~Session();
    Session(const Session &) = delete;

    Status act(const char *action, Handle handle = nullptr, Handle in_args = nullptr);
    /// Makes the instance: a copy of the descriptor with the defaults of all parameters.
    void instantiate();
    Status cook();

    Effect descriptor, instance;
    Status described = -1;
    /// The output of the effect.
    MeshData output;
    /// Violations by the effect.
    std::vector<std::string> wrongs;

private:
    const OfxPlugin &plugin_;
    OfxHost host_;
    Properties in_args_;
};

} // namespace mfx
