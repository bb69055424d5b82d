// Embree: triangles in single precision, closest points by point queries with a callback, lines by filters that let every hit pass.
#include "surface.hpp"

#include <embree3/rtcore.h>
#include <tbb/global_control.h>

#include <atomic>
#include <cmath>
#include <limits>
#include <optional>

namespace surface {
namespace {
using Vector = std::array<float, 3>;

Vector operator-(const Vector &a, const Vector &b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
float dot(const Vector &a, const Vector &b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vector along(const Vector &a, float s, const Vector &d) { return {a[0] + s * d[0], a[1] + s * d[1], a[2] + s * d[2]}; }

/// The nearest point of a triangle, by the regions of its plane (Ericson, Real-Time Collision Detection, 5.1.5).
Vector nearest_of_triangle(const Vector &p, const Vector &a, const Vector &b, const Vector &c) {
    const Vector ab = b - a, ac = c - a, ap = p - a, bp = p - b, cp = p - c;
    const float d1 = dot(ab, ap), d2 = dot(ac, ap), d3 = dot(ab, bp), d4 = dot(ac, bp), d5 = dot(ab, cp), d6 = dot(ac, cp);
    if (d1 <= 0 && d2 <= 0) {
        return a;
    }
    if (d3 >= 0 && d4 <= d3) {
        return b;
    }
    if (d6 >= 0 && d5 <= d6) {
        return c;
    }
    const float vc = d1 * d4 - d3 * d2, vb = d5 * d2 - d1 * d6, va = d3 * d6 - d5 * d4;
    if (vc <= 0 && d1 >= 0 && d3 <= 0) {
        return along(a, d1 / (d1 - d3), ab);
    }
    if (vb <= 0 && d2 >= 0 && d6 <= 0) {
        return along(a, d2 / (d2 - d6), ac);
    }
    if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) {
        return along(b, (d4 - d3) / ((d4 - d3) + (d5 - d6)), c - b);
    }
    const float scale = 1 / (va + vb + vc);
    return along(along(a, vb * scale, ab), vc * scale, ac);
}

struct Query {
    const std::vector<Vector> &points;
    const std::vector<uint32_t> &corners;
    Vector foot;
};

bool visit(RTCPointQueryFunctionArguments *arguments) {
    auto &query = *static_cast<Query *>(arguments->userPtr);
    const uint32_t *corner = &query.corners[3 * std::size_t{arguments->primID}];
    const Vector p = {arguments->query->x, arguments->query->y, arguments->query->z};
    const Vector foot = nearest_of_triangle(p, query.points[corner[0]], query.points[corner[1]], query.points[corner[2]]);
    const float distance = std::sqrt(dot(foot - p, foot - p));
    if (distance >= arguments->query->radius) {
        return false;
    }
    arguments->query->radius = distance;
    query.foot = foot;
    return true;
}

/// Data that a ray passes to the filter.
struct Collector {
    RTCIntersectContext context;
    Points *points;
};

void keep_and_go_on(const RTCFilterFunctionNArguments *arguments) {
    const auto *collector = reinterpret_cast<const Collector *>(arguments->context);
    if (!collector->points) {
        return;
    }
    const auto *ray = reinterpret_cast<const RTCRay *>(arguments->ray);
    const Vector at = along({ray->org_x, ray->org_y, ray->org_z}, ray->tfar, {ray->dir_x, ray->dir_y, ray->dir_z});
    collector->points->push_back({at[0], at[1], at[2]});
    arguments->valid[0] = 0;
}

class Embree final : public Solver {
public:
    Embree(const Triangles &triangles, unsigned threads)
        : corners_(triangles.corners), threads_(threads), device_(rtcNewDevice(nullptr)) {
        for (const Point &p : triangles.points) {
            points_.push_back({static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2])});
        }
        // The last one may be read as four numbers.
        points_.reserve(points_.size() + 1);
        rtcSetDeviceMemoryMonitorFunction(device_, count_bytes, &bytes_);
    }
    ~Embree() override {
        rtcReleaseScene(scene_);
        rtcReleaseDevice(device_);
    }
    void prepare() override {
        if (scene_) {
            rtcReleaseScene(scene_);
        }
        scene_ = nullptr;
    }
    void build() override {
        // A device has as many threads as any other one has.
        std::optional<tbb::global_control> alone;
        if (threads_ == 1) {
            alone.emplace(tbb::global_control::max_allowed_parallelism, 1);
        }
        scene_ = rtcNewScene(device_);
        RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
        rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, points_.data(), 0, sizeof(Vector),
                                   points_.size());
        rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, corners_.data(), 0, 3 * sizeof(uint32_t),
                                   corners_.size() / 3);
        rtcSetGeometryPointQueryFunction(geometry, visit);
        rtcSetGeometryIntersectFilterFunction(geometry, keep_and_go_on);
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(scene_, geometry);
        rtcReleaseGeometry(geometry);
        rtcCommitScene(scene_);
        if (const RTCError error = rtcGetDeviceError(device_); error != RTC_ERROR_NONE) {
            throw std::runtime_error("rtcCommitScene: error " + std::to_string(error));
        }
    }
    std::size_t bytes() const override { return static_cast<std::size_t>(bytes_.load()); }
    void closest(const Points &queries, Points &feet) override {
        feet.clear();
        RTCPointQueryContext context;
        for (const Point &q : queries) {
            rtcInitPointQueryContext(&context);
            RTCPointQuery query{};
            query.x = static_cast<float>(q[0]);
            query.y = static_cast<float>(q[1]);
            query.z = static_cast<float>(q[2]);
            query.radius = std::numeric_limits<float>::infinity();
            Query state{points_, corners_, {}};
            rtcPointQuery(scene_, &query, &context, nullptr, &state);
            feet.push_back({state.foot[0], state.foot[1], state.foot[2]});
        }
    }
    void lines(const std::vector<Line> &lines, Hits &hits) override {
        hits.clear();
        for (const Line &line : lines) {
            shoot(line, &hits.points);
            hits.ends.push_back(hits.points.size());
        }
    }
    void rays(const std::vector<Line> &rays, Hits &hits) override {
        hits.clear();
        for (const Line &line : rays) {
            const RTCRayHit ray = shoot(line, nullptr);
            if (ray.hit.geomID != RTC_INVALID_GEOMETRY_ID) {
                hits.points.push_back(line.origin + static_cast<double>(ray.ray.tfar) * line.direction);
            }
            hits.ends.push_back(hits.points.size());
        }
    }

private:
    RTCRayHit shoot(const Line &line, Points *points) const {
        Collector collector{};
        rtcInitIntersectContext(&collector.context);
        collector.points = points;
        RTCRayHit ray{};
        ray.ray.org_x = static_cast<float>(line.origin[0]);
        ray.ray.org_y = static_cast<float>(line.origin[1]);
        ray.ray.org_z = static_cast<float>(line.origin[2]);
        ray.ray.dir_x = static_cast<float>(line.direction[0]);
        ray.ray.dir_y = static_cast<float>(line.direction[1]);
        ray.ray.dir_z = static_cast<float>(line.direction[2]);
        ray.ray.tfar = std::numeric_limits<float>::infinity();
        ray.ray.mask = ~0u;
        ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
        rtcIntersect1(scene_, &collector.context, &ray);
        return ray;
    }

    static bool count_bytes(void *user, ssize_t bytes, bool) {
        *static_cast<std::atomic<ssize_t> *>(user) += bytes;
        return true;
    }

    const std::vector<uint32_t> &corners_;
    unsigned threads_;
    std::vector<Vector> points_;
    std::atomic<ssize_t> bytes_{0};
    RTCDevice device_;
    RTCScene scene_ = nullptr;
};
} // namespace

std::unique_ptr<Solver> embree(const Triangles &triangles, unsigned threads) { return std::make_unique<Embree>(triangles, threads); }
} // namespace surface
