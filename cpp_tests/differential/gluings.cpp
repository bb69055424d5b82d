// Compares random gluings of nets with union-find and plain counts: classes of nodes, the complex with its
// characteristic and boundary, meshes. Gluings must survive streams, parts, concatenation and enlargement.
#include "../cpp/nets.hpp"
#include "complex_by_hand.hpp"
#include "pieces.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <set>

namespace campaign {
namespace of_gluings {
namespace {
using gusset::LocalGluing;
using gusset::NetComplex;
using gusset::Seam;
using gusset::Sides;
std::vector<uint32_t> flat(const std::vector<Edge> &edges) {
    std::vector<uint32_t> list;
    for (const auto &[a, b] : edges) {
        list.insert(list.end(), {a, b});
    }
    return list;
}
bool same(gusset::Indices list, const std::vector<uint32_t> &other) { return std::equal(list.begin(), list.end(), other.begin(), other.end()); }

void check_complex(Case &test, const Net &net, const Classes &classes, bool reversed) {
    test.check(net.classes() == classes.list(), "the classes are not those of union-find");
    const ByHand hand(classes);
    const NetComplex complex(net);
    const gusset_net_complex_view view = complex.view();
    test.equal(view.vertex_count, hand.vertices, "vertices");
    test.equal(view.edge_count, hand.edges, "edges");
    test.equal(view.quad_count, hand.quads, "quads");
    test.equal(view.triangle_count, hand.triangles, "triangles");
    test.equal(view.digon_count, hand.digons, "digons");
    test.equal(view.point_count, hand.points, "cells that are points");
    test.equal(view.fold_count, hand.folds, "folds");
    test.equal(view.boundary_edge_count, hand.boundary, "boundary edges");
    test.equal(view.component_count, 1u, "components");
    test.equal(view.euler, hand.euler(), "Euler's characteristic");
    test.check(same(complex.wires(), flat(hand.wires)), "the wires are others");
    test.check(same(complex.branches(), flat(hand.branches)), "the branches are others");
    test.check(same(complex.conflicts(), flat(hand.conflicts)), "the conflicts are others");
    test.check(same(complex.pinches(), hand.pinches), "the pinches are others");
    test.check(complex.is_orientable() == hand.orientable, "what can be oriented cannot, or the other way round");
    test.check(complex.is_closed() == (hand.boundary == 0) && complex.is_oriented() == hand.conflicts.empty(), "closed or oriented, and not so by hand");
    test.check(complex.is_manifold() == hand.is_manifold(), "a manifold that is none, or the other way round");
    std::multiset<Edge> rim, sought(hand.rim.begin(), hand.rim.end());
    for (std::size_t k = 0; k < complex.boundary_count(); ++k) {
        const gusset::Indices chain = complex.boundary(k);
        for (std::size_t i = 0; i + (view.boundary_open.data[k] ? 1 : 0) < chain.size(); ++i) {
            Edge edge{chain[i], chain[(i + 1) % chain.size()]};
            // Chains of faces that disagree run one way all along.
            if (hand.conflicts.empty() && hand.branches.empty() && hand.pinches.empty()) {
                rim.insert(reversed ? Edge{edge.second, edge.first} : edge);
            } else {
                rim.insert(std::minmax(edge.first, edge.second));
            }
        }
    }
    if (!(hand.conflicts.empty() && hand.branches.empty() && hand.pinches.empty())) {
        sought.clear();
        for (const auto &[a, b] : hand.rim) {
            sought.insert(std::minmax(a, b));
        }
    }
    test.check(rim == sought, "the chains of the boundary are not its edges");
    if (hand.is_manifold()) {
        test.note("manifolds");
        const long excess = 2 - hand.euler() - static_cast<long>(complex.boundary_count());
        test.equal(complex.genus().value_or(-1), hand.orientable ? excess / 2 : excess, "genus");
    }
}

/// Counts that belong to the surface, not to its nodes.
std::array<uint64_t, 6> surface_of(const Net &net) {
    const NetComplex complex(net);
    const auto view = complex.view();
    return {view.vertex_count, view.edge_count, view.quad_count, view.triangle_count, view.boundary_edge_count, view.wires.count};
}

Seam random_seam(Random &random, uint32_t rows, uint32_t columns) {
    Seam seam{};
    const auto run = [&](uint32_t &row, uint32_t &column, int32_t &row_step, int32_t &column_step, uint32_t count) {
        do {
            row = random.below(rows), column = random.below(columns);
            row_step = static_cast<int32_t>(random.below(3)) - 1, column_step = static_cast<int32_t>(random.below(3)) - 1;
            const int64_t i = row + static_cast<int64_t>(count - 1) * row_step, j = column + static_cast<int64_t>(count - 1) * column_step;
            if (i >= 0 && i < rows && j >= 0 && j < columns && (count == 1 || row_step != 0 || column_step != 0)) {
                return;
            }
        } while (true);
    };
    seam.count = random.between(1, std::min(rows, columns));
    run(seam.row_a, seam.column_a, seam.row_step_a, seam.column_step_a, seam.count);
    run(seam.row_b, seam.column_b, seam.row_step_b, seam.column_step_b, seam.count);
    return seam;
}

/// Local gluings at random places.
LocalGluing random_gluing(Random &random, Classes &classes) {
    const uint32_t rows = classes.rows, columns = classes.columns;
    const uint32_t i = random.below(rows), j = random.below(columns), cell_i = random.below(rows - 1), cell_j = random.below(columns - 1);
    const uint32_t node = classes.node(i, j), cell = cell_i * (columns - 1) + cell_j;
    const std::array<uint32_t, 4> around{classes.node(cell_i, cell_j), classes.node(cell_i, cell_j + 1), classes.node(cell_i + 1, cell_j + 1), classes.node(cell_i + 1, cell_j)};
    switch (random.below(5)) {
    case 0: {
        const uint32_t link = 2 * node + random.below(2);
        classes.link(link);
        return LocalGluing::link(link);
    }
    case 1: {
        const uint32_t mask = random.between(1, 15);
        const std::array<uint32_t, 4> others{classes.node(i, (j + 1) % columns), classes.node((i + 1) % rows, j), classes.node(i, (j + columns - 1) % columns),
                                             classes.node((i + rows - 1) % rows, j)};
        for (uint32_t k = 0; k < 4; ++k) {
            mask >> k & 1 ? classes.unite(node, others[k]) : void();
        }
        return LocalGluing::star(node, static_cast<gusset::Links>(mask));
    }
    case 2: {
        const uint32_t mask = random.between(1, 15);
        for (uint32_t k = 0; k < 4; ++k) {
            mask >> k & 1 ? classes.unite(around[k], around[(k + 1) % 4]) : void();
        }
        return LocalGluing::cell(cell, static_cast<gusset::CellSides>(mask));
    }
    case 3: {
        const bool rising = random.one_in(2);
        classes.unite(around[rising], around[2 + rising]);
        return LocalGluing::diagonal(cell, rising ? gusset::Diagonal::rising : gusset::Diagonal::falling);
    }
    default: {
        const Seam seam = random_seam(random, rows, columns);
        classes.seam(seam);
        return LocalGluing::along(seam);
    }
    }
}

void check_streams(Case &test, const Net &net) {
    for (const auto mode : {gusset::StreamMode::lossless, gusset::StreamMode::raw}) {
        gusset::StreamOptions options;
        options.mode = mode;
        options.rows_per_block = test.random.below(4);
        const gusset::Stream stream(net, options);
        test.check(identical(gusset::decode(stream.bytes()), net), "a stream without loss has another net");
    }
    gusset::StreamOptions options;
    options.bits = test.random.between(8, 24);
    options.per_axis = test.random.one_in(2);
    const gusset::Stream stream(net, options);
    const gusset::StreamReport report = gusset::inspect(stream.bytes());
    const Net back = gusset::decode(stream.bytes());
    test.check(back.classes() == net.classes() && back.matrix() == net.matrix(), "a quantised stream has another gluing");
    const auto list = net.classes();
    const auto p = net.points(), q = back.points();
    for (std::size_t v = 0; v < p.size(); ++v) {
        for (std::size_t k = 0; k < 3; ++k) {
            // Glued nodes have the position of the first.
            test.at_most(std::abs(q[v][k] - p[list[v]][k]), 0.5 * report.step[k] * (1 + 1e-9) + 1e-12, "the error of a quantised coordinate");
        }
    }
}

void check_mesh(Case &test, const Net &net, const Classes &classes) {
    const ByHand hand(classes);
    const gusset::NetMesh mesh(net);
    const Counts counts = count(mesh.mesh());
    test.equal(counts.faces, hand.quads + hand.triangles, "faces of the mesh");
    test.equal(counts.edges + hand.wires.size(), hand.edges, "edges of the mesh");
    test.equal(counts.boundary, hand.boundary, "boundary edges of the mesh");
    test.equal(mesh.wires().size(), 2 * hand.wires.size(), "wires of the mesh");
    const auto list = net.classes();
    bool at_class = true;
    for (std::size_t v = 0; v < list.size(); ++v) {
        const uint32_t vertex = mesh.vertex_of_node()[v];
        at_class = at_class && vertex == mesh.vertex_of_node()[list[v]];
        at_class = at_class && (vertex == gusset::NetMesh::none || mesh.node_of_vertex()[vertex] == list[v]);
    }
    test.check(at_class, "the vertices of the mesh are not the classes");
}

/// The classes of a rectangle, by its links and the runs of seams within it.
void check_part(Case &test, const Net &net) {
    Random &random = test.random;
    const auto rows = static_cast<uint32_t>(net.rows()), columns = static_cast<uint32_t>(net.columns());
    const uint32_t height = random.between(2, rows), width = random.between(2, columns);
    const uint32_t top = random.below(rows - height + std::size_t{1}), left = random.below(columns - width + std::size_t{1});
    Classes classes(height, width);
    const auto matrix = net.matrix();
    for (uint32_t i = 0; i < height; ++i) {
        for (uint32_t j = 0; j < width; ++j) {
            const std::size_t horizontal = std::size_t{2} * (i + top) * columns + j + left, vertical = horizontal + columns;
            if (matrix[horizontal] && (j + 1 < width || width == columns)) {
                classes.link(2 * classes.node(i, j));
            }
            if (matrix[vertical] && (i + 1 < height || height == rows)) {
                classes.link(2 * classes.node(i, j) + 1);
            }
        }
    }
    const auto inside = [&](int64_t i, int64_t j) { return top <= i && i < top + height && left <= j && j < left + width; };
    for (const Seam &seam : net.seams()) {
        for (int64_t k = 0; k < seam.count; ++k) {
            const int64_t a = seam.row_a + k * seam.row_step_a, b = seam.column_a + k * seam.column_step_a;
            const int64_t c = seam.row_b + k * seam.row_step_b, d = seam.column_b + k * seam.column_step_b;
            if (inside(a, b) && inside(c, d)) {
                classes.unite(classes.node(static_cast<std::size_t>(a - top), static_cast<std::size_t>(b - left)),
                              classes.node(static_cast<std::size_t>(c - top), static_cast<std::size_t>(d - left)));
            }
        }
    }
    std::optional<Net> part;
    const Refusal refused = refusal([&] { part.emplace(net.part(top, height, left, width)); });
    if (refused.status == GUSSET_ERROR_CROSSING_CELL) {
        test.check(classes.has_crossing(), "a part is refused, and no cell of it crosses");
        return;
    }
    if (test.check(refused.status == GUSSET_OK, "a part is refused")) {
        test.check(!classes.has_crossing(), "a cell of a part crosses");
        test.check(part->classes() == classes.list(), "the classes of a part are not those of its links and seams");
        bool bits = true;
        for (std::size_t i = 0; i < height; ++i) {
            for (std::size_t j = 0; j < width; ++j) {
                bits = bits && part->at(i, j) == net.at(i + top, j + left);
            }
        }
        test.check(bits, "a node of a part has other bits");
    }
}

/// The classes of another net, whose node (i, j) is `from(i, j)` of the net.
template <class From>
void check_moved(Case &test, const Net &moved, const Net &net, From &&from, const char *sentence) {
    const auto list = net.classes(), now = moved.classes();
    std::map<uint32_t, uint32_t> first;
    bool holds = moved.node_count() == net.node_count();
    for (uint32_t v = 0; v < now.size() && holds; ++v) {
        const std::size_t i = v / moved.columns(), j = v % moved.columns();
        const auto [row, column] = from(i, j);
        holds = moved.at(i, j) == net.at(row, column) && now[v] == first.emplace(list[row * net.columns() + column], v).first->second;
    }
    test.check(holds && surface_of(moved) == surface_of(net), sentence);
}

void check_moves(Case &test, const Net &net) {
    const std::size_t h = net.rows(), w = net.columns();
    check_moved(test, net.transposed(), net, [](std::size_t i, std::size_t j) { return std::pair(j, i); }, "a transposed net is another");
    check_moved(test, net.flipped(gusset::Direction::right), net, [&](std::size_t i, std::size_t j) { return std::pair(i, w - 1 - j); }, "a flipped net is another");
    check_moved(test, net.flipped(gusset::Direction::down), net, [&](std::size_t i, std::size_t j) { return std::pair(h - 1 - i, j); }, "a flipped net is another");
    test.check(identical(net.turned(1).turned(-1), net) && identical(net.turned(2).turned(2), net), "a net that was turned and turned back is another");
    gusset::NetCopyOptions larger;
    larger.rows = h + test.random.below(5);
    larger.columns = w + test.random.below(5);
    larger.row_replication = static_cast<gusset::Replication>(test.random.below(5));
    larger.column_replication = static_cast<gusset::Replication>(test.random.below(5));
    larger.row_index = larger.row_replication == gusset::Replication::at ? test.random.below(h) : 0;
    larger.column_index = larger.column_replication == gusset::Replication::at ? test.random.below(w) : 0;
    const Net reformatted = net.copied(larger);
    test.check(reformatted.rows() == larger.rows && reformatted.columns() == larger.columns, "a larger net has another size");
    test.check(surface_of(reformatted) == surface_of(net), "a larger net is another surface");
    test.check(surface_of(reformatted.compacted()) == surface_of(net), "a compacted net is another surface");
    Net saturated = net;
    saturated.saturate();
    test.check(saturated.classes() == net.classes(), "saturating glues more");
}

void check_join(Case &test, const Net &net, const Net &other, bool against) {
    gusset::ConcatenateOptions options;
    options.direction = test.random.one_in(2) ? gusset::Direction::right : gusset::Direction::down;
    options.equalise = static_cast<gusset::Replication>(test.random.below(3));
    options.mode = test.random.one_in(2) ? gusset::BridgeMode::hide : gusset::BridgeMode::keep;
    options.rows = test.random.below(3);
    if (against) {
        test.check(refusal([&] { gusset::concatenate(net, other, options); }).status == GUSSET_ERROR_ORIENTATION_CONFLICT, "nets that run against each other are joined");
        return;
    }
    const Net joined = gusset::concatenate(net, other, options);
    const auto [first, second] = joined.split(0);
    test.check(identical(first, net) && identical(second, other), "nets joined and split are others");
    const bool right = options.direction == gusset::Direction::right;
    if (right ? net.rows() != other.rows() : net.columns() != other.columns()) {
        return;
    }
    // No link is contracted between the two.
    Classes classes(joined.rows(), joined.columns());
    for (const auto &[part, row, column] : {std::tuple(&net, std::size_t{0}, std::size_t{0}),
                                            std::tuple(&other, right ? 0 : net.rows() + options.rows, right ? net.columns() + options.rows : 0)}) {
        const auto list = part->classes();
        for (std::size_t v = 0; v < list.size(); ++v) {
            const auto place = [&](std::size_t k) { return classes.node(row + k / part->columns(), column + k % part->columns()); };
            classes.unite(place(v), place(list[v]));
        }
    }
    if (options.rows == 0) {
        test.check(joined.classes() == classes.list(), "the classes of joined nets are not those of both");
        test.note("joins compared");
    }
}

/// `like`: a net of the same size, or none.
Net random_net(Case &test, std::optional<Classes> &kept, bool &reversed, const Net *like = nullptr) {
    Random &random = test.random;
    for (;;) {
        const std::size_t rows = like ? like->rows() : random.between(2, 8), columns = like ? like->columns() : random.between(2, 8);
        Classes classes(rows, columns);
        std::vector<Point3> points;
        for (std::size_t k = 0; k < rows * columns; ++k) {
            points.push_back({random.real(-1, 1), random.real(-1, 1), random.real(-1, 1)});
        }
        gusset::Gluing gluing;
        gluing.reversed = reversed = random.one_in(3);
        switch (random.below(4)) {
        case 0: {
            gluing.sides = static_cast<Sides>(random.below(64));
            classes.sides(static_cast<uint32_t>(gluing.sides));
            break;
        }
        case 1: {
            gluing.matrix.resize(2 * rows * columns);
            const double share = random.real(0, 0.3);
            for (std::size_t i = 0; i < gluing.matrix.size(); ++i) {
                gluing.matrix[i] = random.unit() < share;
                const std::size_t line = i / columns, column = i % columns;
                if (gluing.matrix[i]) {
                    classes.link(2 * classes.node(line / 2, column) + static_cast<uint32_t>(line % 2));
                }
            }
            break;
        }
        case 2: {
            for (uint32_t k = random.between(1, 3); k-- > 0;) {
                gluing.seams.push_back(random_seam(random, classes.rows, classes.columns));
                classes.seam(gluing.seams.back());
            }
            break;
        }
        default: break;
        }
        std::optional<Net> net;
        const Refusal refused = refusal([&] { net.emplace(Net::from_points(rows, columns, points, gluing)); });
        if (!test.equal(refused.status, classes.has_crossing() ? GUSSET_ERROR_CROSSING_CELL : GUSSET_OK, "the status of a gluing")) {
            test.failed.back() += ", sides " + std::to_string(static_cast<uint32_t>(gluing.sides));
        }
        if (!net) {
            continue;
        }
        for (uint32_t k = random.below(4); k-- > 0;) {
            Classes more = classes;
            const LocalGluing glued = random_gluing(random, more);
            const Refusal local = refusal([&] { net->glue(glued); });
            test.equal(local.status, more.has_crossing() ? GUSSET_ERROR_CROSSING_CELL : GUSSET_OK, "the status of a local gluing");
            if (local.status == GUSSET_OK) {
                classes = more;
            }
        }
        kept.emplace(classes);
        return *net;
    }
}
} // namespace
} // namespace of_gluings

void gluings(Case &test) {
    using namespace of_gluings;
    std::optional<Classes> classes, others;
    bool reversed = false, other_reversed = false;
    Net net = random_net(test, classes, reversed);
    check_complex(test, net, *classes, reversed);
    check_mesh(test, net, *classes);
    check_streams(test, net);
    if (test.random.one_in(2)) {
        net.snap();
        test.check(gusset::NetValidation(net).is_valid(), "a net that was snapped is not valid");
        Net bare = net;
        bare.set_gluing(Sides::sheet);
        if (refusal([&] { bare.detect_gluing(); }).status == GUSSET_OK) {
            // Neighbours in one place are found, and nothing that is elsewhere.
            const auto list = net.classes(), found = bare.classes();
            bool within = true, neighbours = true;
            for (uint32_t v = 0; v < list.size(); ++v) {
                within = within && list[found[v]] == list[v];
                const bool right = (v + 1) % net.columns() != 0, down = v + net.columns() < list.size();
                neighbours = neighbours && !(right && list[v] == list[v + 1] && found[v] != found[v + 1]);
                neighbours = neighbours && !(down && list[v] == list[v + net.columns()] && found[v] != found[v + net.columns()]);
            }
            test.check(within, "nodes in different places are glued");
            test.check(neighbours, "neighbours in one place are not glued");
        }
        check_streams(test, net);
    }
    check_part(test, net);
    check_moves(test, net);
    const Net other = random_net(test, others, other_reversed, test.random.one_in(2) ? &net : nullptr);
    check_join(test, net, other, reversed != other_reversed);
}
} // namespace campaign
