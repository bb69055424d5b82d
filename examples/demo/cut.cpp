#include "cut.hpp"

#include <gusset/openmesh.hpp>

#include <algorithm>
#include <limits>
#include <numeric>
#include <vector>

namespace {
using OpenMesh::FaceHandle;
using Point = HostMesh::Point;

constexpr int taken = -1, unseen = -2;

std::size_t at(FaceHandle face) { return static_cast<std::size_t>(face.idx()); }

/// Gives a number to all faces that hang together with `start` and are `from` so far; how many there are.
std::size_t flood(const HostMesh &mesh, FaceHandle start, int from, int number, std::vector<int> &part) {
    std::size_t count = 0;
    std::vector<FaceHandle> open{start};
    part[at(start)] = number;
    while (!open.empty()) {
        const FaceHandle face = open.back();
        open.pop_back();
        ++count;
        for (const auto next : mesh.ff_range(face)) {
            if (part[at(next)] == from) {
                part[at(next)] = number;
                open.push_back(next);
            }
        }
    }
    return count;
}

/// The faces of one part, as a mesh of its own.
HostMesh piece(const HostMesh &mesh, const std::vector<int> &part, int number) {
    HostMesh copy = mesh;
    for (const auto face : mesh.faces()) {
        if (part[at(face)] != number) {
            copy.delete_face(face);
        }
    }
    copy.garbage_collection();
    return copy;
}

std::size_t loops(const HostMesh &mesh) {
    return gusset::Boundary(gusset::openmesh::Input(mesh).view()).size();
}
} // namespace

std::optional<Cut> cut_in_two(const HostMesh &mesh, const Band &band) {
    constexpr int between = -3;
    const Point normal = band.normal.normalized();
    std::vector<int> part(mesh.n_faces(), unseen);
    FaceHandle nearest;
    double least = std::numeric_limits<double>::max();
    for (const auto face : mesh.faces()) {
        double low = std::numeric_limits<double>::max(), high = std::numeric_limits<double>::lowest();
        Point centre(0, 0, 0);
        for (const auto vertex : mesh.fv_range(face)) {
            const Point p = mesh.point(vertex) - band.point;
            low = std::min(low, normal | p);
            high = std::max(high, normal | p);
            centre += p / static_cast<double>(mesh.valence(face));
        }
        if (low < 0.5 * band.width && high > -0.5 * band.width) {
            part[at(face)] = between;
            if (centre.norm() < least) {
                least = centre.norm();
                nearest = face;
            }
        }
    }
    if (!nearest.is_valid()) {
        return std::nullopt;
    }
    flood(mesh, nearest, between, taken, part);
    std::replace(part.begin(), part.end(), between, unseen);
    // Faces that would stick out of a rim by two of their edges go too.
    for (bool is_even = false; !is_even;) {
        is_even = true;
        for (const auto face : mesh.faces()) {
            const auto range = mesh.ff_range(face);
            const auto beside = std::count_if(range.begin(), range.end(), [&](const auto &next) { return part[at(next)] == taken; });
            if (part[at(face)] != taken && beside >= 2) {
                part[at(face)] = taken;
                is_even = false;
            }
        }
    }

    std::vector<std::size_t> sizes;
    std::vector<FaceHandle> starts;
    for (const auto start : mesh.faces()) {
        if (part[at(start)] == unseen) {
            starts.push_back(start);
            sizes.push_back(flood(mesh, start, unseen, static_cast<int>(sizes.size()), part));
        }
    }
    std::vector<int> order(sizes.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return sizes[static_cast<std::size_t>(a)] > sizes[static_cast<std::size_t>(b)]; });
    for (std::size_t k = 2; k < order.size(); ++k) {
        const auto number = static_cast<std::size_t>(order[k]);
        if (100 * sizes[number] > mesh.n_faces()) {
            return std::nullopt;
        }
        flood(mesh, starts[number], order[k], taken, part);
    }
    if (order.size() < 2) {
        return std::nullopt;
    }
    Cut cut{piece(mesh, part, order[0]), piece(mesh, part, order[1]), piece(mesh, part, taken), {}};
    for (const int number : part) {
        cut.part.push_back(number == order[0] ? 0 : number == order[1] ? 1 : 2);
    }
    if (loops(cut.left) != 1 || loops(cut.right) != 1) {
        return std::nullopt;
    }
    return cut;
}
