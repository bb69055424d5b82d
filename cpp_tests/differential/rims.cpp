#include "rims.hpp"

#include <algorithm>
#include <cmath>

namespace campaign {
namespace {
/// A tube of n sides about an axis. Its rim, the vertices 0 to n - 1, is at z = 0, its other end below or above; a
/// fan closes that end if `capped`. Faces outwards if it is below.
Soup cup(Random &random, uint32_t n, uint32_t rings, double depth, double radius, double noise, bool capped) {
    const double slope = random.real(-0.4, 0.6), oval = random.real(-0.3, 0.3), wave = random.real(0, 0.2);
    const uint32_t waves = random.between(2, 5);
    Soup soup = grid(n, rings, true, false, [&](double s, double t) {
        const double angle = 2 * M_PI * s, r = radius * (1 + slope * t) + noise * random.real(-1, 1);
        return Point{r * (1 + oval) * std::cos(angle), r * (1 - oval) * std::sin(angle),
                     depth * t + wave * radius * std::sin(waves * angle) + noise * random.real(-1, 1)};
    });
    if (capped) {
        const auto pole = static_cast<uint32_t>(soup.points.size());
        soup.points.push_back({0.01, 0.02, 1.2 * depth});
        for (uint32_t i = 0; i < n; ++i) {
            soup.add_face({rings * n + i, rings * n + (i + 1) % n, pole});
        }
    }
    // Rings ascend, counter-clockwise: outwards. Descending tubes are inside out.
    return depth > 0 ? soup : inside_out(soup);
}
} // namespace

Rims random_rims(Random &random, bool triangles) {
    const bool large = random.one_in(20);
    const uint32_t n = random.between(3, large ? 90 : 24), m = random.one_in(3) ? n : random.between(3, large ? 90 : 24);
    const double radius = random.real(0.5, 1.5), gap = random.one_in(4) ? random.real(-0.5, 0.1) : random.real(0.05, 1.5);
    const double noise = random.one_in(2) ? 0.0 : random.real(0, 0.15);
    Rims rims;
    rims.a = cup(random, n, random.between(1, 4), -random.real(0.3, 1.5), 1, noise, random.one_in(2));
    rims.b = cup(random, m, random.between(1, 4), random.real(0.3, 1.5), radius, noise, random.one_in(2));
    std::array<Point, 3> tilt{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    if (random.one_in(3)) {
        const double angle = random.real(-0.6, 0.6);
        tilt = {{{std::cos(angle), 0, std::sin(angle)}, {0, 1, 0}, {-std::sin(angle), 0, std::cos(angle)}}};
    }
    move(rims.b, tilt, {random.real(-0.3, 0.3), random.real(-0.3, 0.3), gap});
    const auto rotation = random_rotation(random);
    move(rims.a, rotation, {0, 0, 0});
    move(rims.b, rotation, {0, 0, 0});
    for (uint32_t v = 0; v < n; ++v) {
        rims.rim_a.push_back(v);
    }
    for (uint32_t v = 0; v < m; ++v) {
        rims.rim_b.push_back(v);
    }
    for (auto *rim : {&rims.rim_a, &rims.rim_b}) {
        std::rotate(rim->begin(), rim->begin() + random.below(rim->size()), rim->end());
        if (random.one_in(2)) {
            std::reverse(rim->begin(), rim->end());
        }
    }
    const double share = triangles ? 1.0 : random.below(3) / 2.0;
    rims.a = cut_to_triangles(rims.a, random, share);
    rims.b = cut_to_triangles(rims.b, random, share);
    return rims;
}

gusset::StitchOptions random_stitch_options(Random &random) {
    gusset::StitchOptions options;
    options.meridians = static_cast<gusset::Meridians>(random.below(8));
    options.twist = random.one_in(4) ? static_cast<int64_t>(random.below(7)) - 3 : 0;
    const uint32_t rows = random.below(6);
    if (rows > 1) {
        options.row_count = rows - 2;
    } else {
        options.rows = rows == 0 ? gusset::RowRule::none : gusset::RowRule::mean_edge;
    }
    options.search = random.one_in(4) ? gusset::StripSearch::exact : gusset::StripSearch::automatic;
    options.start = random.one_in(2) ? gusset::StripStart::closest : gusset::StripStart::automatic;
    options.fairing = random.one_in(3) ? gusset::Fairing::thin_plate : gusset::Fairing::none;
    options.centres = random.one_in(2) ? gusset::Centres::length : gusset::Centres::vertices;
    options.finish = random.one_in(4) ? gusset::Finish::blend : gusset::Finish::strip;
    return options;
}

gusset::FillOptions random_fill_options(Random &random) {
    gusset::FillOptions options;
    options.weight = static_cast<gusset::FillWeight>(random.below(4));
    options.refine = static_cast<gusset::FillRefinement>(random.below(2));
    options.fairing = random.one_in(2) ? gusset::Fairing::thin_plate : gusset::Fairing::none;
    options.continuity = static_cast<gusset::FillContinuity>(random.below(2));
    options.together = random.one_in(3) ? gusset::FillTogether::cheapest : gusset::FillTogether::apart;
    options.ignore_creases = random.one_in(3);
    return options;
}
} // namespace campaign
