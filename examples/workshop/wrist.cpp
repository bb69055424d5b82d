// Joins a body and its separately modelled hand at the wrist; eyes and mouth stay open.
//   wrist [body.obj hand.obj] [--picture wrist.svg] [--mesh joined.off] [--page NAME]
// The body's wrist may have few edges and the hand's many. Without files, or with - for the first, a doll is made by
// formula, with 6 edges at its wrist and 52 at its hand's. OBJ files have y up.
#include "workshop.hpp"

#include <gusset/openmesh.hpp>

#include <CLI/CLI.hpp>
#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>

#include <set>

namespace {
using namespace workshop;
using Mesh = OpenMesh::PolyMesh_ArrayKernelT<>;

Mesh read_mesh(const std::string &file) {
    Mesh mesh;
    if (!OpenMesh::IO::read_mesh(mesh, file)) {
        throw std::runtime_error("cannot read " + file);
    }
    for (const Mesh::VertexHandle v : mesh.vertices()) {
        const Mesh::Point p = mesh.point(v);
        mesh.set_point(v, {p[0], -p[2], p[1]});
    }
    return mesh;
}

/// Rings of points about the x axis, with a pole where a ring has one point, and quads or triangles between.
struct Rings {
    Mesh mesh;
    std::vector<std::vector<Mesh::VertexHandle>> rings;

    void add(const std::vector<Point3> &points) {
        rings.emplace_back();
        for (const Point3 &p : points) {
            rings.back().push_back(mesh.add_vertex(
                {static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2])}));
        }
    }
    /// Faces between the last two rings, except some. Every third of the points continues.
    void join(const std::set<std::size_t> &open = {}) {
        const auto &a = rings[rings.size() - 2], &b = rings.back();
        const std::size_t sides = std::max(a.size(), b.size());
        const auto of = [&](const std::vector<Mesh::VertexHandle> &ring, std::size_t i) {
            return ring[ring.size() == 1 ? 0 : ring.size() == sides ? i % sides : (i + 1) / 3 % ring.size()];
        };
        for (std::size_t i = 0; i < sides; ++i) {
            std::vector<Mesh::VertexHandle> face;
            for (const Mesh::VertexHandle v : {of(a, i), of(a, i + 1), of(b, i + 1), of(b, i)}) {
                if (face.empty() || (v != face.back() && v != face.front())) {
                    face.push_back(v);
                }
            }
            if (open.count(i) == 0) {
                mesh.add_face(face);
            }
        }
    }
};

/// A ring of an ellipse with its middle on the x axis.
std::vector<Point3> ring(std::size_t sides, double x, double wide, double high, double turn = 0) {
    std::vector<Point3> points;
    for (std::size_t i = 0; i < sides; ++i) {
        const double angle = 6.283185307179586 * (static_cast<double>(i) + turn) / static_cast<double>(sides);
        points.push_back({x, -wide * std::sin(angle), high * std::cos(angle)});
    }
    return points;
}

/// A round head, two eyes and a mouth, with an arm of six sides.
Mesh head_with_arm() {
    Rings doll;
    doll.add({{-3.0, 0, 0}});
    for (int k = 1; k < 16; ++k) {
        const double polar = 3.141592653589793 * k / 16.4;
        doll.add(ring(18, -1.9 - 1.1 * std::cos(polar), 1.1 * std::sin(polar), 1.1 * std::sin(polar)));
        // In front, where y is negative.
        using Open = std::set<std::size_t>;
        doll.join(k == 6 || k == 11 ? Open{3} : k == 8 || k == 9 ? Open{5} : Open{});
    }
    for (const double x : {-0.5, 0.1, 0.8, 1.4}) {
        doll.add(ring(6, x, 0.3 - 0.05 * x, 0.3 - 0.05 * x));
        doll.join();
    }
    return std::move(doll.mesh);
}

/// A mitten: from the wrist, whose rim has 52 edges, over a palm with a thumb to its end.
Mesh mitten() {
    Rings hand;
    for (int k = 0; k <= 22; ++k) {
        const double t = k / 23.0, round = std::sqrt(1 - std::pow(t, 4));
        std::vector<Point3> points = ring(52, 1.62 + 1.25 * t, (0.2 + 0.32 * std::sin(2.2 * t)) * round,
                                          (0.2 - 0.04 * std::sin(3 * t)) * round);
        for (std::size_t i = 0; i < points.size(); ++i) {
            const double side = std::pow(std::max(0.0, -points[i][1]) / 0.55, 4);
            points[i][1] -= 0.9 * side * std::exp(-std::pow((t - 0.42) / 0.14, 2));
        }
        hand.add(points);
        if (k > 0) {
            hand.join();
        }
    }
    hand.add({{1.62 + 1.25, 0, 0}});
    hand.join();
    return std::move(hand.mesh);
}

/// The drawing within a frame of the picture, from `x` on and this wide.
void clip(pictures::Drawing &drawing, int x, int width) {
    std::ostringstream text;
    text << "<clipPath id='from" << x << "'><rect x='" << x << "' y='8' width='" << width
         << "' height='310'/></clipPath>\n<g clip-path='url(#from" << x << ")' stroke-width='0.3'>\n";
    drawing.add(text.str());
}

void draw(const std::vector<MeshView> &pieces, const gusset::Join &whole, const std::string &file) {
    const auto box = [&](gusset::Indices vertices) {
        std::array<Point3, 2> found{whole.mesh().position(vertices[0]), whole.mesh().position(vertices[0])};
        for (const uint32_t v : vertices) {
            for (std::size_t i = 0; i < 3; ++i) {
                found[0][i] = std::min(found[0][i], whole.mesh().position(v)[i]);
                found[1][i] = std::max(found[1][i], whole.mesh().position(v)[i]);
            }
        }
        return found;
    };
    const auto of = [](const gusset_indices &list) { return gusset::Indices(list.data, list.count); };
    const auto all = box(of(whole.pieces()[0].vertices)), hand = box(of(whole.pieces()[1].vertices));
    const double far = 270 / std::max(std::max(all[1][0], hand[1][0]) - all[0][0], all[1][2] - all[0][2]);
    const Point3 across = minus(hand[1], hand[0]), eye{0.35, -1, 0.3};
    const double near = 190 / std::sqrt(dot(across, across));
    const Point3 wrist = whole.mesh().position(of(whole.joints()[0].side[0])[0]);
    const Point3 middle{(all[0][0] + std::max(all[1][0], hand[1][0])) / 2, 0, (all[0][2] + all[1][2]) / 2};
    pictures::Drawing drawing(960, 350, eye, 1);
    const std::array<pictures::Colour, 2> colours{pictures::blue, pictures::ochre};
    std::vector<pictures::Colour> colour(whole.mesh().face_count(), pictures::green);
    for (std::size_t k = 0; k < 2; ++k) {
        const gusset_indices faces = whole.pieces()[k].faces;
        for (const uint32_t f : of(faces)) {
            colour[f] = colours[k];
        }
    }
    const auto frame = [&](int x, double scale, const Point3 &centre, const char *caption) {
        clip(drawing, x, 300);
        drawing.look(eye, scale);
        drawing.place(0, 0);
        const auto spot = drawing.at(centre);
        drawing.place(x + 150 - spot[0], 163 - spot[1]);
        drawing.caption(x + 150, 338, caption);
    };
    for (const int x : {15, 330, 645}) {
        frame(x, x == 15 ? far : near, x == 15 ? middle : wrist,
              x == 15 ? "joined" : x == 330 ? "the wrist before" : "and after");
        if (x == 330) {
            for (std::size_t k = 0; k < 2; ++k) {
                drawing.mesh(pieces[k], [&](std::size_t) { return colours[k]; });
            }
        } else {
            drawing.mesh(whole.mesh(), [&](std::size_t f) { return colour[f]; });
        }
        drawing.add("</g>\n");
    }
    save(drawing, file);
}
/// Describes a joint in words.
std::string account(const gusset_joint &joint, const MeshView &mesh) {
    const std::size_t cut = joint.intersections.count / 2;
    return said(joint.side[0].count, " edges to ", joint.side[1].count, " across a gap of ", joint.gap, ", ", joint.face_count,
                " new faces, smallest angle ", smallest_angle(mesh, joint.face_first), " degrees, pairs of faces that cut: ",
                joint.intersections_known != 0 ? std::to_string(cut) : "not sought");
}

/// Before and after for a page, by a strip and by a blend.
page::Showcase show(const std::vector<MeshView> &pieces) {
    page::Showcase shown;
    shown.id = "wrist";
    shown.title = "A wrist";
    shown.text = "A body and its hand, which were modelled apart, joined at the wrist; eyes and mouth stay open.";
    shown.paints = {{"body", "#8fa3b3", 0, 0.5}, {"hand", "#dbcbad", 0, 0.5}, {"joint", "#d99a1c", 0.4, 0.35, true}};
    shown.eye = {0.35, -1, 0.3};
    shown.up = {0, 0, 1};
    shown.pairs = {{0, 2}, {0, 1}, {1, 2}};
    shown.bodies.resize(1);
    for (std::size_t k = 0; k < pieces.size(); ++k) {
        shown.bodies[0].add(pieces[k], [&](std::size_t) { return k; });
    }
    shown.states = {{"Apart", 0, {}, "Two meshes; no vertex of them moves."}};
    for (const gusset::Finish finish : {gusset::Finish::strip, gusset::Finish::blend}) {
        gusset::JoinOptions options;
        options.strip_options.finish = finish;
        const gusset::Join whole(pieces, options);
        std::vector<uint8_t> paint(whole.mesh().face_count(), 2);
        for (std::size_t k = 0; k < pieces.size(); ++k) {
            for (const uint32_t f : gusset::Indices(whole.pieces()[k].faces.data, whole.pieces()[k].faces.count)) {
                paint[f] = static_cast<uint8_t>(k);
            }
        }
        shown.bodies.emplace_back().add(whole.mesh(), [&](std::size_t f) { return paint[f]; });
        const gusset_joint &joint = whole.joints()[0];
        shown.states.push_back({finish == gusset::Finish::strip ? "Strip" : "Blend", shown.bodies.size() - 1, {},
                                account(joint, whole.mesh()) + '.'});
        const gusset::Indices rim(joint.side[1].data, joint.side[1].count);
        Point3 centre{};
        for (const uint32_t v : rim) {
            for (std::size_t i = 0; i < 3; ++i) {
                centre[i] += whole.mesh().position(v)[i] / static_cast<double>(rim.size());
            }
        }
        shown.near_centre = centre;
        shown.near_eye = shown.eye;
        for (const uint32_t v : rim) {
            const Point3 out = minus(whole.mesh().position(v), centre);
            shown.near_radius = std::max(shown.near_radius, 3 * std::sqrt(dot(out, out)));
        }
    }
    return shown;
}
} // namespace

int main(int argc, char **argv) try {
    CLI::App app("Joins a body and its hand at the wrist; eyes and mouth stay open.");
    std::string first = "-", second, picture, file, page;
    bool blend = false;
    app.add_option("body", first, "an OBJ file, or - for a doll by formula");
    app.add_option("hand", second, "an OBJ file");
    app.add_flag("--blend", blend, "fine triangles on a smooth surface, not the strip");
    app.add_option("--picture", picture, "an SVG file of both before and after");
    app.add_option("--mesh", file, "an OFF file of the result");
    app.add_option("--page", page, "before and after for scripts/page.py, NAME.json and NAME.bin");
    CLI11_PARSE(app, argc, argv);

    Claims claims;
    const Mesh body = first == "-" ? head_with_arm() : read_mesh(first), hand = first == "-" ? mitten() : read_mesh(second);
    //! [wrist]
    const gusset::openmesh::Input a(body), b(hand); // positions are read where OpenMesh keeps them
    const std::vector<MeshView> pieces{a.view(), b.view()};
    gusset::JoinOptions options; // by default what faces each other is joined, and no hole is filled
    options.strip_options.finish = blend ? gusset::Finish::blend : gusset::Finish::strip;
    const gusset::Join whole(pieces, options);
    //! [wrist]
    for (std::size_t k = 0; k < 2; ++k) {
        std::cout << (k == 0 ? "body: " : "hand: ") << pieces[k].vertex_count() << " vertices, "
                  << pieces[k].face_count() << " faces, Euler characteristic " << euler(pieces[k]) << ", loops of";
        for (const gusset::Loop loop : gusset::Boundary(pieces[k])) {
            std::cout << ' ' << loop.vertices.size();
        }
        std::cout << ", smallest angle " << smallest_angle(pieces[k]) << " degrees\n";
    }
    std::cout << "joined: ";
    for (const gusset_joint &joint : whole.joints()) {
        std::cout << account(joint, whole.mesh()) << '\n';
    }
    std::cout << "result: " << whole.mesh().vertex_count() << " vertices, " << whole.mesh().face_count()
              << " faces, Euler characteristic " << euler(whole.mesh()) << ", loops of";
    for (const gusset_left_loop &loop : whole.left()) {
        std::cout << ' ' << loop.vertices.count;
    }
    std::cout << '\n';

    const std::size_t loops = gusset::Boundary(pieces[0]).size() + gusset::Boundary(pieces[1]).size();
    const bool joined = whole.joints().size() == 1 && whole.joints()[0].outcome == GUSSET_JOINT_JOINED;
    claims.hold(joined, "one joint, at the wrist");
    claims.hold(whole.report().loops_left == loops - 2, "all other holes stay open");
    claims.hold(euler(whole.mesh()) == euler(pieces[0]) + euler(pieces[1]), "a strip round the wrist adds nothing");
    const gusset::Check check(whole.mesh());
    claims.hold(check.is_manifold() && check.is_oriented(), "the result is an oriented manifold");
    bool kept = true;
    for (std::size_t k = 0; k < 2; ++k) {
        for (std::size_t v = 0; v < pieces[k].vertex_count(); ++v) {
            kept = kept && whole.mesh().position(whole.pieces()[k].vertices.data[v]) == pieces[k].position(v);
        }
    }
    claims.hold(kept, "no vertex of the pieces has moved");
    if (joined && !picture.empty()) {
        draw(pieces, whole, picture);
    }
    save(whole.mesh(), file);
    if (joined && !page.empty()) {
        save(show(pieces), page);
    }
    return claims.status();
} catch (const std::exception &error) {
    std::cerr << error.what() << '\n';
    return 1;
}
