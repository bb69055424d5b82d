#include "pieces.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace campaign {

Waves::Waves(Random &random, double size) {
    for (auto &axis : waves_) {
        for (Wave &wave : axis) {
            wave = {{random.real(-2, 2), random.real(-2, 2), random.real(-2, 2)}, random.real(0, 6.3), random.real(0.2, 0.5) * size};
        }
    }
}

Point Waves::operator()(const Point &p) const {
    Point moved = p;
    for (std::size_t k = 0; k < 3; ++k) {
        for (const Wave &wave : waves_[k]) {
            moved[k] += wave.size * std::sin(wave.direction[0] * p[0] + wave.direction[1] * p[1] + wave.direction[2] * p[2] + wave.phase);
        }
    }
    return moved;
}

Soup grid(uint32_t n, uint32_t m, bool closed_s, bool closed_t, const std::function<Point(double, double)> &at) {
    Soup soup;
    const uint32_t columns = closed_s ? n : n + 1, rows = closed_t ? m : m + 1;
    for (uint32_t j = 0; j < rows; ++j) {
        for (uint32_t i = 0; i < columns; ++i) {
            soup.points.push_back(at(double(i) / n, double(j) / m));
        }
    }
    for (uint32_t j = 0; j < m; ++j) {
        for (uint32_t i = 0; i < n; ++i) {
            const uint32_t k = (i + 1) % columns, l = (j + 1) % rows;
            soup.add_face({j * columns + i, j * columns + k, l * columns + k, l * columns + i});
        }
    }
    return soup;
}

Soup random_shape(Random &random, Shape shape) {
    const uint32_t n = random.between(3, 14), m = random.between(shape == Shape::torus ? 3 : 1, 12);
    const Waves waves(random, shape == Shape::torus ? 0.15 : 0.3);
    const auto round = [](double s) { return Point{std::cos(2 * M_PI * s), std::sin(2 * M_PI * s), 0}; };
    switch (shape) {
    case Shape::sheet: return grid(n, m, false, false, [&](double s, double t) { return waves({2 * s - 1, 2 * t - 1, 0}); });
    case Shape::tube: return grid(n, m, true, false, [&](double s, double t) { return waves({round(s)[0], round(s)[1], 2 * t - 1}); });
    case Shape::torus: return grid(n, m, true, true, [&](double s, double t) {
        const double ring = 1 + 0.4 * round(t)[0];
        return waves({ring * round(s)[0], ring * round(s)[1], 0.4 * round(t)[1]});
    });
    case Shape::ball: break;
    }
    // The rings of a ball between its poles.
    Soup soup = grid(n, m, true, false, [&](double s, double t) {
        const double across = M_PI * (t * m + 1) / (m + 2);
        return waves({std::sin(across) * round(s)[0], std::sin(across) * round(s)[1], -std::cos(across)});
    });
    const auto south = static_cast<uint32_t>(soup.points.size());
    soup.points.push_back(waves({0, 0, -1}));
    soup.points.push_back(waves({0, 0, 1}));
    for (uint32_t i = 0; i < n; ++i) {
        const uint32_t k = (i + 1) % n;
        soup.add_face({south, k, i});
        soup.add_face({south + 1, m * n + i, m * n + k});
    }
    return soup;
}

Soup cut_to_triangles(const Soup &soup, Random &random, double share) {
    Soup split;
    split.points = soup.points;
    for (std::vector<uint32_t> face : faces_of(soup)) {
        if (face.size() == 3 || random.unit() > share) {
            split.add_face(face);
            continue;
        }
        std::rotate(face.begin(), face.begin() + random.below(face.size()), face.end());
        for (std::size_t k = 2; k < face.size(); ++k) {
            split.add_face({face[0], face[k - 1], face[k]});
        }
    }
    return split;
}

Soup without(const Soup &soup, const std::function<bool(std::size_t)> &dropped) {
    Soup left;
    left.points = soup.points;
    const auto faces = faces_of(soup);
    for (std::size_t f = 0; f < faces.size(); ++f) {
        if (!dropped(f)) {
            left.add_face(faces[f]);
        }
    }
    return left;
}

Soup compact(const Soup &soup) {
    Soup small;
    small.offsets = soup.offsets;
    std::map<uint32_t, uint32_t> numbers;
    for (uint32_t v : soup.corners) {
        const auto [place, is_new] = numbers.insert({v, static_cast<uint32_t>(small.points.size())});
        if (is_new) {
            small.points.push_back(soup.points[v]);
        }
        small.corners.push_back(place->second);
    }
    return small;
}

Soup with_holes(const Soup &soup, Random &random) {
    const auto faces = faces_of(soup);
    std::set<std::size_t> dropped;
    for (uint32_t k = random.below(4); k-- > 0;) {
        dropped.insert(random.below(faces.size()));
    }
    for (uint32_t k = random.below(3); k-- > 0;) {
        const uint32_t centre = random.any(soup.corners);
        for (std::size_t f = 0; f < faces.size(); ++f) {
            if (std::find(faces[f].begin(), faces[f].end(), centre) != faces[f].end()) {
                dropped.insert(f);
            }
        }
    }
    return dropped.size() == faces.size() ? soup : without(soup, [&](std::size_t f) { return dropped.count(f) != 0; });
}

void turn_face(Soup &soup, std::size_t face) {
    std::reverse(soup.corners.begin() + soup.offsets[face], soup.corners.begin() + soup.offsets[face + 1]);
}

Soup inside_out(Soup soup) {
    for (std::size_t f = 0; f < soup.face_count(); ++f) {
        turn_face(soup, f);
    }
    return soup;
}

Soup shuffled(const Soup &soup, Random &random) {
    auto faces = faces_of(soup);
    random.shuffle(faces);
    Soup other;
    other.points = soup.points;
    for (auto &face : faces) {
        std::rotate(face.begin(), face.begin() + random.below(face.size()), face.end());
        other.add_face(face);
    }
    return other;
}

Soup together(const std::vector<Soup> &pieces) {
    Soup whole;
    for (const Soup &piece : pieces) {
        const auto first = static_cast<uint32_t>(whole.points.size());
        whole.points.insert(whole.points.end(), piece.points.begin(), piece.points.end());
        for (std::vector<uint32_t> face : faces_of(piece)) {
            for (uint32_t &v : face) {
                v += first;
            }
            whole.add_face(face);
        }
    }
    return whole;
}

std::array<Point, 3> random_rotation(Random &random) {
    // The rotation of a quaternion.
    double q[4], size = 0;
    do {
        size = 0;
        for (double &x : q) {
            x = random.real(-1, 1);
            size += x * x;
        }
    } while (size > 1 || size < 0.01);
    const double s = 2 / size, w = q[0], x = q[1], y = q[2], z = q[3];
    return {{{1 - s * (y * y + z * z), s * (x * y - z * w), s * (x * z + y * w)},
             {s * (x * y + z * w), 1 - s * (x * x + z * z), s * (y * z - x * w)},
             {s * (x * z - y * w), s * (y * z + x * w), 1 - s * (x * x + y * y)}}};
}

void move(Soup &soup, const std::array<Point, 3> &rotation, const Point &shift) {
    for (Point &p : soup.points) {
        const Point was = p;
        for (std::size_t k = 0; k < 3; ++k) {
            p[k] = rotation[k][0] * was[0] + rotation[k][1] * was[1] + rotation[k][2] * was[2] + shift[k];
        }
    }
}

std::vector<std::vector<uint32_t>> faces_of(const Soup &soup) {
    std::vector<std::vector<uint32_t>> faces;
    for (std::size_t f = 0; f < soup.face_count(); ++f) {
        faces.emplace_back(soup.corners.begin() + soup.offsets[f], soup.corners.begin() + soup.offsets[f + 1]);
    }
    return faces;
}

Counts count(const gusset::MeshView &mesh) {
    std::set<uint32_t> vertices;
    std::map<std::pair<uint32_t, uint32_t>, int> edges;
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        const gusset::Indices face = mesh.face(f);
        for (std::size_t k = 0; k < face.size(); ++k) {
            vertices.insert(face[k]);
            ++edges[std::minmax(face[k], face[(k + 1) % face.size()])];
        }
    }
    Counts counts{vertices.size(), edges.size(), 0, 0, mesh.face_count()};
    for (const auto &[edge, faces] : edges) {
        counts.boundary += faces == 1;
        counts.branches += faces > 2;
    }
    return counts;
}
} // namespace campaign
