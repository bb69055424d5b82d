// libgusset_openmfx.so, opened by a host that knows nothing of it but the standard, and the
// descriptor to compare with.
#include "shapes.hpp"

#include <doctest/doctest.h>
#include <gusset_plugin.h>

#include <dlfcn.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <stdexcept>

using namespace mfx;

namespace {

template <typename F>
F symbol(const char *name) {
    static void *library = dlopen(GUSSET_OPENMFX, RTLD_NOW | RTLD_LOCAL);
    REQUIRE_MESSAGE(library != nullptr, dlerror());
    void *found = dlsym(library, name);
    REQUIRE(found != nullptr);
    F function = nullptr;
    std::memcpy(&function, &found, sizeof function);
    return function;
}

int effect_count() { return symbol<int (*)()>("OfxGetNumberOfPlugins")(); }
const OfxPlugin *effect(int nth) { return symbol<const OfxPlugin *(*)(int)>("OfxGetPlugin")(nth); }

const OfxPlugin &named(const std::string &id) {
    for (int k = 0; k < effect_count(); ++k) {
        if (effect(k)->pluginIdentifier == "gusset." + id) {
            return *effect(k);
        }
    }
    throw std::out_of_range(id);
}

const gusset_plugin &tables() { return *symbol<gusset_plugin_entry_fn>("gusset_plugin_entry")(GUSSET_PLUGIN_ABI); }

/// An effect, described, with an instance.
struct Cooked : Session {
    explicit Cooked(const std::string &id, Traits of = {}) : Session(named(id), of) {
        REQUIRE(described == OK);
        instantiate();
    }
    ~Cooked() { CHECK(wrongs == std::vector<std::string>()); }

    void connect(const std::string &input, MeshData data) {
        instance.input(input).data = std::move(data);
        instance.input(input).connected = true;
    }
    std::string error() const {
        const auto found = instance.messages.find("OfxMessageError");
        return found == instance.messages.end() ? "" : found->second.at(0);
    }
};

const std::string MAIN = "OfxMeshMainInput";

double greatest(const MeshData &mesh, std::size_t axis) {
    double found = -1e30;
    for (std::size_t k = axis; k < mesh.points.size(); k += 3) {
        found = std::max(found, static_cast<double>(mesh.points[k]));
    }
    return found;
}

} // namespace

TEST_CASE("effects are the filters of the descriptor") {
    CHECK(effect(-1) == nullptr);
    CHECK(effect(effect_count()) == nullptr);
    REQUIRE(effect_count() == static_cast<int>(tables().filter_count));
    for (int k = 0; k < effect_count(); ++k) {
        const OfxPlugin &plugin = *effect(k);
        CHECK(effect(k) == &plugin);
        CHECK(plugin.pluginApi == std::string("OfxMeshEffectPluginAPI"));
        CHECK(plugin.apiVersion == 1);
        CHECK(plugin.pluginIdentifier == std::string("gusset.") + tables().filter(static_cast<std::uint32_t>(k))->id);
        const std::string version =
            std::to_string(plugin.pluginVersionMajor) + "." + std::to_string(plugin.pluginVersionMinor) + ".";
        CHECK(std::string(tables().version).rfind(version, 0) == 0);
    }
}

TEST_CASE("every effect describes itself as the descriptor does") {
    const std::map<std::uint32_t, std::string> types = {
        {GUSSET_PARAM_BOOL, "OfxParamTypeBoolean"},   {GUSSET_PARAM_INT, "OfxParamTypeInteger"},
        {GUSSET_PARAM_CHOICE, "OfxParamTypeChoice"},  {GUSSET_PARAM_REAL, "OfxParamTypeDouble"},
        {GUSSET_PARAM_LENGTH, "OfxParamTypeDouble"},  {GUSSET_PARAM_ANGLE, "OfxParamTypeDouble"},
        {GUSSET_PARAM_POINT, "OfxParamTypeDouble3D"}, {GUSSET_PARAM_DIRECTION, "OfxParamTypeDouble3D"},
        {GUSSET_PARAM_PLANE, "OfxParamTypeDouble3D"}};
    for (int k = 0; k < effect_count(); ++k) {
        const gusset_filter &filter = *tables().filter(static_cast<std::uint32_t>(k));
        CAPTURE(filter.id);
        Session session(*effect(k));
        REQUIRE(session.described == OK);
        CHECK(session.wrongs.empty());
        Effect &effect = session.descriptor;
        CHECK(effect.properties.get<std::string>("OfxPropLabel") == filter.name);
        CHECK(effect.properties.has("OfxMeshEffectPropSupportedContexts"));
        CHECK(effect.inputs.size() == std::min(filter.max_inputs, 8u) + 1);
        CHECK(effect.inputs.back()->name == "OfxMeshMainOutput");
        CHECK((filter.max_inputs == 0 || effect.inputs.front()->name == MAIN));
        for (const auto &input : effect.inputs) {
            const bool several = filter.max_inputs > 1 && input->name != "OfxMeshMainOutput";
            CHECK(input->properties.has("OfxInputPropRequestTransform") == several);
        }
        for (std::uint32_t p = 0; p < filter.param_count; ++p) {
            const gusset_param_info &info = *filter.param(&filter, p);
            CAPTURE(info.id);
            const Param &param = effect.param(info.id);
            CHECK(param.type == types.at(info.kind));
            CHECK(param.properties.get<std::string>("OfxPropLabel").rfind(info.label, 0) == 0);
            CHECK(param.properties.get<std::string>("OfxParamPropHint").rfind(info.help, 0) == 0);
            const double unit = info.kind == GUSSET_PARAM_ANGLE ? 3.14159265358979323846 / 180 : 1;
            for (std::uint32_t c = 0; c < std::min(info.arity, 3u); ++c) {
                if (param.type.find("Double") == std::string::npos) {
                    CHECK(param.properties.get<int>("OfxParamPropDefault") == info.default_values[0]);
                } else {
                    CHECK(unit * param.properties.get<double>("OfxParamPropDefault", c) ==
                          doctest::Approx(info.default_values[c]));
                    CHECK(unit * param.properties.get<double>("OfxParamPropMin", c) == doctest::Approx(info.min));
                    CHECK(unit * param.properties.get<double>("OfxParamPropMax", c) == doctest::Approx(info.max));
                }
            }
            for (std::uint32_t c = 0; c < info.choice_count; ++c) {
                CHECK(param.properties.get<std::string>("OfxParamPropChoiceOption", c) == info.choices[c].label);
            }
            if (info.kind == GUSSET_PARAM_PLANE) {
                CHECK(effect.param(std::string(info.id) + "_offset").properties.get<double>("OfxParamPropDefault") ==
                      info.default_values[3]);
            }
        }
    }
}

TEST_CASE("a host that lacks what is needed is told so") {
    const OfxPlugin &plugin = named("weld");
    plugin.setHost(nullptr);
    int nothing = 0;
    CHECK(plugin.mainEntry("OfxActionDescribe", &nothing, nullptr, nullptr) == ERR_MISSING_HOST_FEATURE);
    CHECK(plugin.mainEntry(nullptr, nullptr, nullptr, nullptr) == ERR_BAD_HANDLE);
    Traits traits;
    traits.has_meshes = false;
    CHECK(Session(plugin, traits).described == ERR_MISSING_HOST_FEATURE);
    traits = Traits();
    traits.has_parameters = false;
    CHECK(Session(plugin, traits).described == ERR_MISSING_HOST_FEATURE);
    traits = Traits();
    traits.has_messages = false;
    CHECK(Session(plugin, traits).described == OK);
    traits.has_choices = false;
    CHECK(Session(plugin, traits).described == ERR_UNSUPPORTED);
}

TEST_CASE("actions that are not trapped") {
    Cooked session("weld");
    CHECK(session.act("OfxMeshEffectActionIsIdentity", &session.instance) == REPLY_DEFAULT);
    CHECK(session.act("OfxActionPurgeCaches", &session.instance) == REPLY_DEFAULT);
    CHECK(session.act("OfxMeshEffectActionDescribeInContext", &session.descriptor) == OK);
}

TEST_CASE("a cube of loose quads is welded, whatever its arrays look like") {
    for (int layout = 0; layout < 4; ++layout) {
        CAPTURE(layout);
        MeshData cube = loose_cube();
        if (layout % 2 == 1) {
            // With colours between the points, and something between the corners.
            MeshData wide = cube;
            wide.points.clear();
            wide.corners.clear();
            for (std::size_t k = 0; k < cube.points.size(); k += 3) {
                wide.points.insert(wide.points.end(),
                                   {cube.points[k], cube.points[k + 1], cube.points[k + 2], 0.5f, 0.25f});
                wide.corners.insert(wide.corners.end(), {cube.corners[k / 3], -7});
            }
            wide.point_stride = 5;
            wide.corner_stride = 2;
            cube = wide;
        }
        cube.constant_size = layout >= 2 ? 4 : 0;
        Traits traits;
        traits.has_values_at_time = layout != 3;
        traits.has_messages = layout != 3;
        Cooked session("weld", traits);
        session.connect(MAIN, cube);
        session.instance.set("vertices", {1});
        REQUIRE(session.cook() == OK);
        CHECK(session.output.points.size() == 3 * 8);
        CHECK(session.output.sizes == std::vector<int>(6, 4));
        CHECK(session.output.constant_size == 4);
        CHECK(!session.output.loose_edges);
        CHECK(census(session.output).euler == 2);
        CHECK(census(session.output).free_edges == 0);
        // The same positions, in their order, the later ones of each place left out.
        CHECK(
            std::equal(session.output.points.begin(), session.output.points.begin() + 12, loose_cube().points.begin()));
        if (traits.has_messages) {
            CHECK(!session.instance.messages["OfxMessageLog"].at(0).empty());
        }
        // Again, with other values: borders are all there is, so the result is the same.
        session.instance.set("vertices", {0});
        REQUIRE(session.cook() == OK);
        CHECK(census(session.output).euler == 2);
    }
}

TEST_CASE("two tubes are stitched where their matrices put them") {
    MeshData above = tube(12, 1, 2), below = tube(16, -2, -1);
    // The first is turned half round x and moved up by 10; the second is where the first would be with the same matrix,
    // but 3 lower.
    above.matrix = {1, 0, 0, 0, 0, -1, 0, 0, 0, 0, -1, 10, 0, 0, 0, 1};
    below.matrix = {1, 0, 0, 0, 0, -1, 0, 0, 0, 0, -1, 7, 0, 0, 0, 1};
    Cooked session("stitch");
    session.connect(MAIN, above);
    session.connect("Input2", below);
    REQUIRE_MESSAGE(session.cook() == OK, session.error());
    CHECK(session.output.constant_size == -1);
    CHECK(census(session.output).euler == 0);
    CHECK(census(session.output).free_edges == 28);
    // In the coordinates of the first: 3 lower in the world is 3 higher there.
    CHECK(greatest(session.output, 2) == doctest::Approx(2));
    double low = 1e30;
    for (std::size_t k = 2; k < session.output.points.size(); k += 3) {
        low = std::min(low, static_cast<double>(session.output.points[k]));
    }
    CHECK(low == doctest::Approx(1));
}

TEST_CASE("what need not be there need not be there") {
    Cooked session("join");
    session.connect(MAIN, tube(8, 0, 1));
    session.connect("Input3", tube(8, 1, 2));
    REQUIRE_MESSAGE(session.cook() == OK, session.error());
    CHECK(census(session.output).euler == 0);
    CHECK(census(session.output).free_edges == 16);
    CHECK(session.output.points.size() == 3 * 24);
}

TEST_CASE("curves are edges without faces") {
    Cooked rims("boundary_loops");
    MeshData mesh = tube(24, 0, 1);
    // A loose edge is not part of the mesh, and does not disturb it.
    mesh.corners.insert(mesh.corners.end(), {0, 30});
    mesh.sizes.push_back(2);
    mesh.loose_edges = true;
    rims.connect(MAIN, mesh);
    REQUIRE_MESSAGE(rims.cook() == OK, rims.error());
    CHECK(rims.output.loose_edges);
    CHECK(rims.output.constant_size == 2);
    CHECK(rims.output.sizes == std::vector<int>(48, 2));
    CHECK(rims.output.points.size() == 3 * 48);

    Cooked smooth("outline");
    smooth.connect(MAIN, rims.output);
    REQUIRE_MESSAGE(smooth.cook() == OK, smooth.error());
    CHECK(smooth.output.sizes.size() > 100);
    CHECK(smooth.output.sizes.size() == smooth.output.points.size() / 3);
    for (std::size_t k = 0; k < smooth.output.points.size(); k += 3) {
        const double x = static_cast<double>(smooth.output.points[k]),
                     y = static_cast<double>(smooth.output.points[k + 1]);
        CHECK(std::hypot(x, y) == doctest::Approx(1).epsilon(0.005));
    }
}

TEST_CASE("parameters of every type") {
    Cooked session("net_shape");
    session.instance.set("rows", {9});
    session.instance.set("columns", {17});
    session.instance.set("shape", {6});
    session.instance.set("radius", {4});
    session.instance.set("triangles", {1});
    REQUIRE_MESSAGE(session.cook() == OK, session.error());
    CHECK(session.output.constant_size == 3);
    CHECK(session.output.points.size() == 3 * 8 * 16);
    CHECK(session.output.sizes.size() == 2 * 8 * 16);
    CHECK(census(session.output).euler == 0);
    CHECK(census(session.output).free_edges == 0);
    CHECK(greatest(session.output, 0) == doctest::Approx(4.25));

    // A circle of 24 points turns by 15 degrees at each: all are corners where corners begin at 10, none where at 20.
    const auto points = [](double degrees) {
        Cooked outline("outline");
        MeshData circle = ring(24);
        circle.constant_size = 2;
        outline.connect(MAIN, circle);
        outline.instance.set("corner_angle", {degrees});
        REQUIRE_MESSAGE(outline.cook() == OK, outline.error());
        return outline.output.points.size() / 3;
    };
    // Between corners, pieces are straight.
    CHECK(points(10) == 24);
    CHECK(points(20) > 24);
}

TEST_CASE("every effect gives something, or says why not; what only tells something passes its input on") {
    for (std::uint32_t k = 0; k < tables().filter_count; ++k) {
        const gusset_filter &filter = *tables().filter(k);
        CAPTURE(filter.id);
        Cooked session(filter.id);
        for (std::uint32_t input = 0; input < filter.min_inputs; ++input) {
            const bool curves = filter.input_kinds[std::min(input, filter.input_kind_count - 1)] == GUSSET_KIND_CURVES;
            const float low = static_cast<float>(3 * input);
            session.connect(input == 0 ? MAIN : "Input" + std::to_string(input + 1),
                            curves ? ring(24) : tube(24, low, low + 1));
        }
        const Status status = session.cook();
        CHECK((status == OK || (status == FAILED && !session.error().empty())));
        const std::uint32_t *end = filter.output_kinds + filter.output_count;
        const bool tells = std::all_of(filter.output_kinds, end, [](auto kind) { return kind == GUSSET_KIND_TEXT; });
        if (status == OK && tells && filter.min_inputs > 0) {
            CHECK(session.output.points == session.instance.input(MAIN).data.points);
            CHECK(session.output.corners == session.instance.input(MAIN).data.corners);
            CHECK(!session.instance.messages["OfxMessageLog"].empty());
        }
    }
}

TEST_CASE("parameters left alone suit the inputs, unless that is switched off") {
    const MeshData mesh = tube(24, 0, 1);
    for (std::uint32_t k = 0; k < tables().filter_count; ++k) {
        const gusset_filter &filter = *tables().filter(k);
        CAPTURE(filter.id);
        Cooked session(filter.id);
        const auto &params = session.instance.params.list;
        if (params.empty() || params.back()->name != "suit_inputs" || filter.min_inputs != 1 ||
            filter.input_kinds[0] != GUSSET_KIND_MESH) {
            continue;
        }
        session.connect(MAIN, mesh);
        const Status status = session.cook();
        const MeshData suited = session.output;
        std::vector<std::uint32_t> offsets;
        for (std::uint32_t f = 0; f <= mesh.sizes.size(); ++f) {
            offsets.push_back(4 * f);
        }
        const gusset_plugin_mesh view = {sizeof view,
                                         mesh.points.data(),
                                         0,
                                         48,
                                         offsets.data(),
                                         mesh.corners.data(),
                                         mesh.sizes.size(),
                                         GUSSET_PLUGIN_F32,
                                         0,
                                         0,
                                         0,
                                         nullptr};
        const gusset_input input = {sizeof input, &view, GUSSET_KIND_MESH, 0};
        std::vector<double> values(filter.value_count);
        REQUIRE(filter.suggest(&filter, &input, 1, values.data()) == GUSSET_PLUGIN_DONE);
        for (std::uint32_t p = 0; p < filter.param_count; ++p) {
            const gusset_param_info &info = *filter.param(&filter, p);
            const double *first = values.data() + info.first_value;
            const double unit = info.kind == GUSSET_PARAM_ANGLE ? 180 / 3.14159265358979323846 : 1;
            session.instance.set(info.id, std::vector<double>(first, first + std::min(info.arity, 3u)));
            session.instance.param(info.id).values[0] *= unit;
            if (info.kind == GUSSET_PARAM_PLANE) {
                session.instance.set(std::string(info.id) + "_offset", {first[3]});
            }
        }
        session.instance.set("suit_inputs", {0});
        CHECK(session.cook() == status);
        CHECK(session.output.points == suited.points);
        CHECK(session.output.corners == suited.corners);
    }
}

TEST_CASE("bad meshes are refused with a sentence") {
    const auto refused = [](MeshData data) {
        Cooked session("weld");
        session.connect(MAIN, std::move(data));
        CHECK(session.cook() == FAILED);
        CHECK(session.output.points.empty());
        return session.error();
    };
    MeshData bad = loose_cube();
    bad.corners[5] = -1;
    CHECK(refused(bad).find("corner 5: vertex 4294967295 does not exist") != std::string::npos);
    bad.corners[5] = 24;
    CHECK(refused(bad).find("vertex 24 does not exist") != std::string::npos);
    bad = loose_cube();
    bad.points[4] = std::numeric_limits<float>::quiet_NaN();
    CHECK(refused(bad).find("vertex 1") != std::string::npos);
    bad = loose_cube();
    bad.sizes[2] = 5;
    CHECK(!refused(bad).empty());
    bad.sizes[2] = -4;
    CHECK(!refused(bad).empty());
    bad.sizes[2] = 1;
    CHECK(refused(bad).find("face 2") != std::string::npos);
    CHECK(refused(MeshData()).find("faces") != std::string::npos);
    bad = loose_cube();
    bad.point_stride = 2;
    CHECK(!refused(bad).empty());
    // Edges without faces are not a mesh.
    bad = loose_cube();
    bad.constant_size = 2;
    CHECK(refused(bad).find("faces") != std::string::npos);

    Cooked alone("weld");
    CHECK(alone.cook() == FAILED);
    CHECK(!alone.error().empty());
}

TEST_CASE("bad values are refused by name") {
    Cooked session("net_shape");
    session.instance.set("rows", {1});
    CHECK(session.cook() == FAILED);
    CHECK(session.error().find("rows") != std::string::npos);
    session.instance.set("rows", {9});
    session.instance.set("radius", {std::numeric_limits<double>::quiet_NaN()});
    CHECK(session.cook() == FAILED);
    CHECK(session.error().find("radius") != std::string::npos);
    session.instance.set("radius", {1});
    CHECK(session.cook() == OK);
}

TEST_CASE("a host may stop an effect, and may have no memory") {
    Cooked session("net_shape");
    session.instance.abort_after = 0;
    CHECK(session.cook() == FAILED);
    CHECK(session.instance.asked == 1);
    CHECK(session.instance.messages.empty());
    CHECK(session.output.points.empty());
    session.instance.abort_after = -1;
    CHECK(session.cook() == OK);

    Traits traits;
    traits.out_of_memory = true;
    Cooked poor("net_shape", traits);
    CHECK(poor.cook() == ERR_MEMORY);
}
