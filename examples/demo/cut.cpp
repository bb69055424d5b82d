#include "cut.hpp"

#include <gusset/openmesh.hpp>

#include <algorithm>
#include <limits>
#include <vector>

namespace {
using Point = HostMesh::Point;

constexpr int removed = -1;

struct Slab {
    Point normal;
    double low, high;
};

/// Per face the number of its connected part, or `removed` if it reaches into the slab. Returns the parts' sizes.
std::vector<std::size_t> parts(const HostMesh &mesh, const Slab &slab, std::vector<int> &part) {
    constexpr int unseen = -2;
    part.assign(mesh.n_faces(), unseen);
    for (auto face : mesh.faces()) {
        double low = std::numeric_limits<double>::max(), high = std::numeric_limits<double>::lowest();
        for (auto vertex : mesh.fv_range(face)) {
            const double h = slab.normal | mesh.point(vertex);
            low = std::min(low, h);
            high = std::max(high, h);
        }
        if (low < slab.high && high > slab.low) {
            part[static_cast<std::size_t>(face.idx())] = removed;
        }
    }
    std::vector<std::size_t> sizes;
    std::vector<OpenMesh::FaceHandle> open;
    for (auto start : mesh.faces()) {
        if (part[static_cast<std::size_t>(start.idx())] != unseen) {
            continue;
        }
        const int number = static_cast<int>(sizes.size());
        sizes.push_back(0);
        part[static_cast<std::size_t>(start.idx())] = number;
        for (open = {start}; !open.empty();) {
            const auto face = open.back();
            open.pop_back();
            ++sizes.back();
            for (auto next : mesh.ff_range(face)) {
                int &seen = part[static_cast<std::size_t>(next.idx())];
                if (seen == unseen) {
                    seen = number;
                    open.push_back(next);
                }
            }
        }
    }
    return sizes;
}

/// The faces of one part, as a mesh of its own.
HostMesh piece(const HostMesh &mesh, const std::vector<int> &part, int number) {
    HostMesh copy = mesh;
    for (auto face : mesh.faces()) {
        if (part[static_cast<std::size_t>(face.idx())] != number) {
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

std::optional<Cut> cut_in_two(const HostMesh &mesh) {
    struct Candidate {
        Slab slab;
        std::size_t smaller;
    };
    std::vector<Candidate> candidates;
    std::vector<int> part;
    for (int code = 0; code < 27; ++code) {
        const Point direction(code / 9 - 1, code / 3 % 3 - 1, code % 3 - 1);
        // One of each pair of opposite directions.
        if (!(Point(0, 0, 0) < direction)) {
            continue;
        }
        const Point normal = direction.normalized();
        double low = std::numeric_limits<double>::max(), high = std::numeric_limits<double>::lowest();
        for (auto vertex : mesh.vertices()) {
            const double h = normal | mesh.point(vertex);
            low = std::min(low, h);
            high = std::max(high, h);
        }
        for (int step = 0; step <= 20; ++step) {
            const double middle = low + (high - low) * (0.2 + 0.03 * step), half = 0.02 * (high - low);
            const Slab slab{normal, middle - half, middle + half};
            const auto sizes = parts(mesh, slab, part);
            if (sizes.size() == 2) {
                candidates.push_back({slab, std::min(sizes[0], sizes[1])});
            }
        }
    }
    std::stable_sort(candidates.begin(), candidates.end(),
                     [](const Candidate &a, const Candidate &b) { return a.smaller > b.smaller; });
    for (const Candidate &candidate : candidates) {
        const auto sizes = parts(mesh, candidate.slab, part);
        Cut cut{piece(mesh, part, 0), piece(mesh, part, 1), candidate.slab.normal, mesh.n_faces() - sizes[0] - sizes[1]};
        if (loops(cut.left) == 1 && loops(cut.right) == 1) {
            return cut;
        }
    }
    return std::nullopt;
}
