#include "wires.hpp"

namespace {

/// The edges of a layer, and those at each vertex.
class Graph {
public:
    explicit Graph(const CMeshO &mesh) : at_(mesh.vert.size()) {
        for (const CEdgeO &edge : mesh.edge) {
            if (!edge.IsD()) {
                const auto index = [&](int end) {
                    return static_cast<std::uint32_t>(vcg::tri::Index(mesh, edge.cV(end)));
                };
                for (const int end : {0, 1}) {
                    at_[index(end)].push_back(static_cast<std::uint32_t>(ends_.size()));
                }
                ends_.push_back({index(0), index(1)});
            }
        }
        used_.resize(ends_.size());
    }

    std::size_t vertices() const { return at_.size(); }
    /// Whether curves go on through the vertex.
    bool passes(std::uint32_t vertex) const { return at_[vertex].size() == 2; }

    /// From a vertex along edges not used yet, to the next vertex where curves do not go on, or back. Fewer than two
    /// vertices if no edge is left.
    std::vector<std::uint32_t> chain(std::uint32_t vertex) {
        std::vector<std::uint32_t> chain{vertex};
        while (take(vertex)) {
            chain.push_back(vertex);
            if (!passes(vertex) || vertex == chain.front()) {
                break;
            }
        }
        return chain;
    }

private:
    /// Uses an edge at the vertex, and goes to its other end.
    bool take(std::uint32_t &vertex) {
        for (const std::uint32_t edge : at_[vertex]) {
            if (!used_[edge]) {
                used_[edge] = true;
                vertex = ends_[edge][0] == vertex ? ends_[edge][1] : ends_[edge][0];
                return true;
            }
        }
        return false;
    }

    std::vector<std::array<std::uint32_t, 2>> ends_;
    std::vector<std::vector<std::uint32_t>> at_;
    std::vector<bool> used_;
};

} // namespace

Wires wires(const CMeshO &mesh) {
    Wires found;
    Graph graph(mesh);
    for (const bool pass : {false, true}) {
        for (std::uint32_t vertex = 0; vertex < graph.vertices(); ++vertex) {
            if (graph.passes(vertex) != pass) {
                continue;
            }
            for (auto chain = graph.chain(vertex); chain.size() > 1; chain = graph.chain(vertex)) {
                const bool closed = chain.front() == chain.back() && chain.size() > 3;
                if (closed) {
                    chain.pop_back();
                }
                for (const std::uint32_t v : chain) {
                    for (int k = 0; k < 3; ++k) {
                        found.points.push_back(mesh.vert[v].cP()[k]);
                    }
                }
                found.offsets.push_back(static_cast<std::uint32_t>(found.points.size() / 3));
                found.closed.push_back(closed ? 1 : 0);
            }
        }
    }
    return found;
}

void add_wires(CMeshO &mesh, const Wires &wires) {
    using Allocator = vcg::tri::Allocator<CMeshO>;
    const std::size_t first = mesh.vert.size();
    auto vertex = Allocator::AddVertices(mesh, wires.points.size() / 3);
    for (std::size_t k = 0; k < wires.points.size(); k += 3, ++vertex) {
        vertex->P() = Point3m(Scalarm(wires.points[k]), Scalarm(wires.points[k + 1]), Scalarm(wires.points[k + 2]));
    }
    for (std::size_t c = 0; c + 1 < wires.offsets.size(); ++c) {
        const std::size_t from = first + wires.offsets[c], to = first + wires.offsets[c + 1];
        for (std::size_t v = from; v + 1 < to; ++v) {
            Allocator::AddEdge(mesh, v, v + 1);
        }
        if (wires.closed[c] != 0 && to - from > 2) {
            Allocator::AddEdge(mesh, to - 1, from);
        }
    }
}
