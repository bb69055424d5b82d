// Showcases for the page by scripts/page.py: meshes in several states, which a reader rotates and compares. write()
// puts
// what describes them into NAME.json and their arrays into NAME.bin, in the form that page.js reads: each array of elements of
// k bytes as differences to the element before, modulo 2^(8 k), all lowest bytes first, so that it compresses well.
#pragma once

#include <gusset.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace page {
using gusset::Point3;
using Colour = std::array<uint8_t, 3>;

/// The material of some faces.
struct Paint {
    std::string name, colour;
    double metalness = 0, roughness = 0.55;
    /// New faces: they keep this paint if the body has its own colours, and show distances.
    bool joint = false;
};

/// A curve, drawn as a tube.
struct Curve {
    std::vector<Point3> points;
    bool closed;
    std::string colour;
    double radius;
};

/// A mesh with its drawing.
struct Body {
    std::vector<Point3> points;
    std::vector<uint32_t> sizes, corners;
    /// For each face the index of its paint.
    std::vector<uint8_t> paint;
    /// Colours of its own, of each vertex or of each face, in place of the paints'. Or none.
    std::vector<Colour> vertex_colours, face_colours;
    /// For each vertex its distance; negative: none. Or none at all.
    std::vector<double> distances;
    std::vector<Curve> curves;

    /// Adds a mesh; face f has the paint that `paint_of(f)` says.
    template <class PaintOf>
    void add(const gusset::MeshView &mesh, PaintOf &&paint_of) {
        const auto first = static_cast<uint32_t>(points.size());
        for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
            points.push_back(mesh.position(v));
        }
        for (std::size_t f = 0; f < mesh.face_count(); ++f) {
            const gusset::Indices face = mesh.face(f);
            sizes.push_back(static_cast<uint32_t>(face.size()));
            for (const uint32_t v : face) {
                corners.push_back(first + v);
            }
            paint.push_back(static_cast<uint8_t>(paint_of(f)));
        }
    }
};

/// A body, or a part of it.
struct State {
    std::string name;
    std::size_t body;
    /// Paints whose faces are not there.
    std::vector<std::size_t> hidden = {};
    /// The text under the picture: its origin and its error.
    std::string note = {};
};

struct Showcase {
    std::string id, title, text;
    std::vector<Paint> paints;
    std::vector<Body> bodies;
    std::vector<State> states;
    /// Pairs of states to compare, the first one to begin with.
    std::vector<std::array<std::size_t, 2>> pairs;
    /// The direction to the eye, the up vector, and the close-up: its centre, its radius, the direction to the eye.
    Point3 eye, up;
    Point3 near_centre, near_eye;
    double near_radius = 0;
    /// The distance at the end of the scale in the unit of the points and in the unit of the legend, and the latter
    /// unit.
    double distance_limit = 0, distance_shown = 0;
    std::string distance_unit;
};

namespace detail {
inline std::string quoted(const std::string &text) {
    std::string out = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') {
            out += '\\';
        }
        out += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
    }
    return out + '"';
}

class Writer {
public:
    explicit Writer(const std::string &name) : json_(name + ".json"), bin_(name + ".bin", std::ios::binary) { json_.precision(9); }

    std::ostream &json() { return json_; }

    /// Writes an array; what describes it goes where the caller is in the JSON.
    template <class T>
    void array(const std::vector<T> &values) {
        json_ << "{\"at\":" << at_ << ",\"count\":" << values.size() << ",\"bytes\":" << sizeof(T) << '}';
        std::string bytes(values.size() * sizeof(T), '\0');
        T before = 0;
        for (std::size_t k = 0; k < values.size(); ++k) {
            const T difference = static_cast<T>(values[k] - before);
            before = values[k];
            for (std::size_t byte = 0; byte < sizeof(T); ++byte) {
                bytes[byte * values.size() + k] = static_cast<char>((difference >> (8 * byte)) & 0xff);
            }
        }
        bin_.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
        at_ += bytes.size();
    }

    void point(const Point3 &p) { json_ << '[' << p[0] << ',' << p[1] << ',' << p[2] << ']'; }

    void close() {
        if (!json_.flush() || !bin_.flush()) {
            throw std::runtime_error("cannot write the showcases");
        }
    }

private:
    std::ofstream json_, bin_;
    std::size_t at_ = 0;
};

/// A value of 0 to `largest` as 0 to `steps`.
template <class T>
T quantised(double value, double largest, double steps) {
    return static_cast<T>(std::lround(largest > 0 ? std::clamp(value / largest, 0.0, 1.0) * steps : 0.0));
}

inline void colours(Writer &out, const char *name, const std::vector<Colour> &all) {
    if (!all.empty()) {
        std::array<std::vector<uint8_t>, 3> channels;
        for (const Colour &colour : all) {
            for (std::size_t k = 0; k < 3; ++k) {
                channels[k].push_back(colour[k]);
            }
        }
        out.json() << ",\n\"" << name << "\":[";
        for (std::size_t k = 0; k < 3; ++k) {
            out.json() << (k == 0 ? "" : ",");
            out.array(channels[k]);
        }
        out.json() << ']';
    }
}

inline void write(Writer &out, const Body &body, double distance_limit) {
    Point3 low{}, high{};
    for (std::size_t k = 0; k < 3; ++k) {
        const auto less = [k](const Point3 &a, const Point3 &b) { return a[k] < b[k]; };
        if (!body.points.empty()) {
            low[k] = (*std::min_element(body.points.begin(), body.points.end(), less))[k];
            high[k] = (*std::max_element(body.points.begin(), body.points.end(), less))[k];
        }
    }
    const double size = std::max({high[0] - low[0], high[1] - low[1], high[2] - low[2]});
    out.json() << "{\"low\":";
    out.point(low);
    // Places in steps of the longest side / 65535.
    out.json() << ",\"size\":" << size << ",\"points\":[";
    for (std::size_t k = 0; k < 3; ++k) {
        std::vector<uint16_t> places;
        for (const Point3 &p : body.points) {
            places.push_back(quantised<uint16_t>(p[k] - low[k], size, 65535));
        }
        out.json() << (k == 0 ? "" : ",");
        out.array(places);
    }
    out.json() << "],\n\"corners\":";
    out.array(body.corners);
    if (!std::all_of(body.sizes.begin(), body.sizes.end(), [](uint32_t count) { return count == 3; })) {
        out.json() << ",\n\"sizes\":";
        out.array(body.sizes);
    }
    out.json() << ",\n\"paint\":";
    out.array(body.paint);
    colours(out, "vertexColours", body.vertex_colours);
    colours(out, "faceColours", body.face_colours);
    if (!body.distances.empty()) {
        // 65535: none.
        std::vector<uint16_t> steps;
        for (const double distance : body.distances) {
            steps.push_back(distance < 0 ? uint16_t{65535} : quantised<uint16_t>(distance, distance_limit, 65534));
        }
        out.json() << ",\n\"distances\":";
        out.array(steps);
    }
    out.json() << ",\n\"curves\":[";
    for (std::size_t c = 0; c < body.curves.size(); ++c) {
        const Curve &curve = body.curves[c];
        out.json() << (c == 0 ? "" : ",") << "{\"closed\":" << (curve.closed ? "true" : "false") << ",\"colour\":" << quoted(curve.colour)
                   << ",\"radius\":" << curve.radius << ",\"points\":[";
        for (std::size_t k = 0; k < curve.points.size(); ++k) {
            out.json() << (k == 0 ? "" : ",");
            out.point(curve.points[k]);
        }
        out.json() << "]}";
    }
    out.json() << "]}";
}

inline void write(Writer &out, const Showcase &showcase) {
    std::ostream &json = out.json();
    json << "{\"id\":" << quoted(showcase.id) << ",\"title\":" << quoted(showcase.title) << ",\"text\":" << quoted(showcase.text)
         << ",\n\"paints\":[";
    for (std::size_t k = 0; k < showcase.paints.size(); ++k) {
        const Paint &paint = showcase.paints[k];
        json << (k == 0 ? "" : ",") << "{\"name\":" << quoted(paint.name) << ",\"colour\":" << quoted(paint.colour) << ",\"metalness\":"
             << paint.metalness << ",\"roughness\":" << paint.roughness << ",\"joint\":" << (paint.joint ? "true" : "false") << '}';
    }
    json << "],\n\"states\":[";
    for (std::size_t k = 0; k < showcase.states.size(); ++k) {
        const State &state = showcase.states[k];
        json << (k == 0 ? "" : ",") << "{\"name\":" << quoted(state.name) << ",\"body\":" << state.body << ",\"hidden\":[";
        for (std::size_t i = 0; i < state.hidden.size(); ++i) {
            json << (i == 0 ? "" : ",") << state.hidden[i];
        }
        json << ']';
        if (!state.note.empty()) {
            json << ",\"note\":" << quoted(state.note);
        }
        json << '}';
    }
    json << "],\n\"pairs\":[";
    for (std::size_t k = 0; k < showcase.pairs.size(); ++k) {
        json << (k == 0 ? "" : ",") << '[' << showcase.pairs[k][0] << ',' << showcase.pairs[k][1] << ']';
    }
    json << "],\n\"eye\":";
    out.point(showcase.eye);
    json << ",\"up\":";
    out.point(showcase.up);
    if (showcase.near_radius > 0) {
        json << ",\n\"near\":{\"centre\":";
        out.point(showcase.near_centre);
        json << ",\"eye\":";
        out.point(showcase.near_eye);
        json << ",\"radius\":" << showcase.near_radius << '}';
    }
    if (showcase.distance_limit > 0) {
        json << ",\n\"distance\":{\"limit\":" << showcase.distance_limit << ",\"shown\":" << showcase.distance_shown << ",\"unit\":"
             << quoted(showcase.distance_unit) << '}';
    }
    json << ",\n\"bodies\":[";
    for (std::size_t k = 0; k < showcase.bodies.size(); ++k) {
        json << (k == 0 ? "" : ",\n");
        write(out, showcase.bodies[k], showcase.distance_limit);
    }
    json << "]}";
}
} // namespace detail

/// Writes NAME.json and NAME.bin.
inline void write(const std::string &name, const std::vector<Showcase> &showcases) {
    detail::Writer out(name);
    out.json() << '[';
    for (std::size_t k = 0; k < showcases.size(); ++k) {
        out.json() << (k == 0 ? "" : ",\n");
        detail::write(out, showcases[k]);
    }
    out.json() << "]\n";
    out.close();
}
} // namespace page
