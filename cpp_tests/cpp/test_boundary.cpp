// Boundary loops from an OpenMesh host, on every real mesh, against OpenMesh's own walks, CGAL and
// the manifest.
#include "data.hpp"
#include "host.hpp"
#include "judge.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iostream>
#include <map>
#include <numeric>
#include <set>

namespace boundary_tests {

namespace {
std::vector<uint32_t> from_smallest(std::vector<uint32_t> cycle) {
    std::rotate(cycle.begin(), std::min_element(cycle.begin(), cycle.end()), cycle.end());
    return cycle;
}

using Edge = std::pair<uint32_t, uint32_t>;

/// How often each edge is run in each direction: counted here, by a map, from the faces alone.
std::map<Edge, int> half_edges(const Soup &soup) {
    std::map<Edge, int> count;
    for (std::size_t f = 0; f < soup.face_count(); ++f) {
        const auto face = soup.view().face(f);
        for (std::size_t i = 0; i < face.size(); ++i) {
            ++count[{face[i], face[(i + 1) % face.size()]}];
        }
    }
    return count;
}

int faces_at(const std::map<Edge, int> &count, Edge edge) {
    const auto one = count.find(edge), other = count.find({edge.second, edge.first});
    return (one != count.end() ? one->second : 0) + (other != count.end() ? other->second : 0);
}

/// Properties of every loop on every mesh, however odd.
void check_loops(const Soup &soup, const gusset::Boundary &boundary) {
    const auto count = half_edges(soup);
    std::set<uint32_t> used;
    for (const gusset::Loop loop : boundary) {
        const std::size_t n = loop.half_edges.size();
        REQUIRE(loop.vertices.size() == n + (loop.is_closed() ? 0 : 1));
        CHECK(std::set<uint32_t>(loop.vertices.begin(), loop.vertices.end()).size() == loop.vertices.size());
        for (std::size_t i = 0; i < n; ++i) {
            const uint32_t h = loop.half_edges[i], f = loop.faces[i];
            CHECK(used.insert(h).second);
            const uint32_t first = soup.offsets[f], last = soup.offsets[f + 1];
            CHECK((first <= h && h < last));
            Edge edge{soup.corners[h], soup.corners[h + 1 < last ? h + 1 : first]};
            const int faces = faces_at(count, edge);
            CHECK(faces != 2);
            CHECK((faces > 2) == ((loop.edge_flags[i] & GUSSET_EDGE_NON_MANIFOLD) != 0));
            if (loop.edge_flags[i] & GUSSET_EDGE_REVERSED) {
                std::swap(edge.first, edge.second);
            }
            CHECK(edge.first == loop.vertices[i]);
            CHECK(edge.second == loop.vertices[(i + 1) % loop.vertices.size()]);
        }
    }
    std::size_t free = 0, found = 0;
    for (const auto &[edge, n] : count) {
        free += faces_at(count, edge) == 1 && edge.first != edge.second;
    }
    for (const gusset::Loop loop : boundary) {
        for (uint8_t flags : loop.edge_flags) {
            found += (flags & GUSSET_EDGE_NON_MANIFOLD) == 0;
        }
    }
    CHECK(found == free);
}
/// The number of edges with one face in each connected part of the boundary, largest first.
std::vector<std::size_t> boundary_parts(const gusset::Boundary &boundary) {
    std::map<uint32_t, uint32_t> parent;
    const auto root = [&](uint32_t v) {
        for (parent.emplace(v, v); parent[v] != v;) {
            v = parent[v] = parent[parent[v]];
        }
        return v;
    };
    std::vector<uint32_t> starts;
    for (const gusset::Loop loop : boundary) {
        for (std::size_t i = 0; i < loop.half_edges.size(); ++i) {
            if ((loop.edge_flags[i] & GUSSET_EDGE_NON_MANIFOLD) == 0) {
                starts.push_back(loop.vertices[i]);
                parent[root(loop.vertices[i])] = root(loop.vertices[(i + 1) % loop.vertices.size()]);
            }
        }
    }
    std::map<uint32_t, std::size_t> count;
    for (uint32_t v : starts) {
        ++count[root(v)];
    }
    std::vector<std::size_t> sizes;
    for (const auto &[part, n] : count) {
        sizes.push_back(n);
    }
    std::sort(sizes.begin(), sizes.end(), std::greater<>());
    return sizes;
}
} // namespace

TEST_SUITE_BEGIN("real meshes");

TEST_CASE("every real mesh: loops against OpenMesh, CGAL and the manifest") {
    const auto files = data_files();
    std::size_t by_openmesh = 0, by_cgal = 0;
    for (const DataFile &file : files) {
        CAPTURE(file.name);
        const Soup soup = read_soup(file.path);
        const gusset::Boundary boundary(soup.view());
        check_loops(soup, boundary);
        gusset::BoundaryOptions only;
        only.survey = gusset::Survey::boundary_only;
        const gusset::Boundary fast(soup.view(), only);
        REQUIRE(fast.size() == boundary.size());
        for (std::size_t i = 0; i < fast.size(); ++i) {
            CHECK(std::equal(fast[i].half_edges.begin(), fast[i].half_edges.end(), boundary[i].half_edges.begin(),
                             boundary[i].half_edges.end()));
        }

        // The manifest, computed by another program altogether.
        const auto parts = boundary_parts(boundary);
        CHECK(std::accumulate(parts.begin(), parts.end(), std::size_t{0}) == file.boundary_edges);
        REQUIRE(parts.size() >= file.longest.size());
        CHECK(std::equal(file.longest.begin(), file.longest.end(), parts.begin()));
        if (file.walks) {
            CHECK(boundary.walk_count() == *file.walks);
        }

        // OpenMesh, where it takes every face: the same cycles, the other way round, as it has the
        // hole on the left.
        if (const auto host = host_mesh(soup)) {
            ++by_openmesh;
            const gusset::openmesh::Input input(*host);
            REQUIRE(input.view().get().positions == host->points());
            const gusset::Boundary own(input.view());
            std::multiset<std::vector<uint32_t>> ours, theirs;
            for (const gusset::Loop loop : own) {
                std::vector<uint32_t> cycle(loop.vertices.begin(), loop.vertices.end());
                std::reverse(cycle.begin(), cycle.end());
                ours.insert(from_smallest(cycle));
                for (std::size_t i = 0; i < loop.half_edges.size(); ++i) {
                    const auto v = input.vertex(loop.vertices[i]);
                    const auto w = input.vertex(loop.vertices[(i + 1) % loop.vertices.size()]);
                    const auto h = host->find_halfedge(v, w);
                    REQUIRE(h.is_valid());
                    CHECK(host->face_handle(h) == input.face(loop.faces[i]));
                    CHECK(host->is_boundary(host->opposite_halfedge_handle(h)));
                }
            }
            bool simple = true;
            for (const auto &cycle : walks(*host)) {
                simple = simple && std::set<uint32_t>(cycle.begin(), cycle.end()).size() == cycle.size();
                theirs.insert(from_smallest(cycle));
            }
            if (simple) {
                CHECK(ours == theirs);
            }
        }
        const Verdict verdict = judge(soup.view(), false);
        if (verdict.is_mesh) {
            ++by_cgal;
            std::vector<std::size_t> lengths(boundary.walk_count());
            for (const gusset::Loop loop : boundary) {
                lengths[loop.walk] += loop.half_edges.size();
            }
            std::sort(lengths.begin(), lengths.end(), std::greater<>());
            CHECK(lengths == verdict.boundary);
        }
    }
    if (!files.empty()) {
        std::cout << files.size() << " real meshes; OpenMesh took " << by_openmesh << ", CGAL " << by_cgal << "\n";
        CHECK(by_openmesh >= files.size() - 4);
        CHECK(by_cgal >= files.size() - 4);
    }
}

TEST_SUITE_END();

TEST_CASE("faces that the host has deleted are not there") {
    HostMesh mesh;
    mesh.request_face_status();
    mesh.request_edge_status();
    mesh.request_vertex_status();
    // A sheet of 4 x 4 cells, without its four cells in the middle.
    std::vector<HostMesh::VertexHandle> v;
    for (int j = 0; j < 5; ++j) {
        for (int i = 0; i < 5; ++i) {
            v.push_back(mesh.add_vertex({double(i), double(j), 0.0}));
        }
    }
    std::vector<HostMesh::FaceHandle> faces;
    for (std::size_t j = 0; j < 4; ++j) {
        for (std::size_t i = 0; i < 4; ++i) {
            faces.push_back(mesh.add_face(v[5 * j + i], v[5 * j + i + 1], v[5 * j + i + 6], v[5 * j + i + 5]));
        }
    }
    const gusset::openmesh::Input before(mesh);
    CHECK(gusset::Boundary(before.view()).size() == 1);
    for (std::size_t f : {5u, 6u, 9u, 10u}) {
        mesh.delete_face(faces[f]);
    }
    const gusset::openmesh::Input input(mesh);
    CHECK(input.view().vertex_count() == 25);
    CHECK(input.view().face_count() == 12);
    CHECK(input.face(5) == faces[7]);
    const gusset::Boundary boundary(input.view());
    REQUIRE(boundary.size() == 2);
    CHECK(boundary[0].vertices.size() == 16);
    CHECK(boundary[1].vertices.size() == 8);
    // Nothing is lost of the host's deleted vertex, and nothing is read of it.
    mesh.set_point(v[12], {NAN, NAN, NAN});
    CHECK(gusset::Boundary(gusset::openmesh::Input(mesh).view()).size() == 2);
}

} // namespace boundary_tests
