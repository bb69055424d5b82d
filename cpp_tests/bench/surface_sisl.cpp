// SISL: a spline surface, asked through s1954 (closest), s1856 (line), s1851 with s1314 (plane) and s1859 with s1310 (surfaces).
#include "surface.hpp"

#include <sisl.h>

#include <cmath>
#include <cstdlib>
#include <limits>

namespace surface {
namespace {
/// Geometric resolution; the second argument of this kind, the computational one, is not used by SISL.
constexpr double RESOLUTION = 1e-7, UNUSED = 0;
/// How finely a curve is looked at: points on each of its spans.
constexpr int FINE = 4;

void check(const char *function, int status) {
    if (status < 0) {
        throw std::runtime_error(std::string(function) + " returns " + std::to_string(status));
    }
}

/// Isolated answers, as parameters, and intervals or curves.
struct Found {
    int point_count = 0, curve_count = 0;
    double *first = nullptr, *second = nullptr;
    SISLIntcurve **curves = nullptr;

    Found() = default;
    Found(const Found &) = delete;
    Found &operator=(const Found &) = delete;
    ~Found() {
        std::free(first);
        std::free(second);
        if (curves) {
            freeIntcrvlist(curves, curve_count);
        }
    }
};

class Sisl final : public Solver {
public:
    explicit Sisl(const Spline &spline) : spline_(spline) {}
    ~Sisl() override { forget(); }
    void build() override {
        forget();
        // SISL's first parameter runs fastest in the array: our v.
        Spline copy = spline_;
        surface_ = newSurf(static_cast<int>(copy.columns), static_cast<int>(copy.rows), 4, 4, copy.v_knots.data(), copy.u_knots.data(),
                           copy.controls.data()->data(), 1, 3, 1);
        if (!surface_) {
            throw std::runtime_error("newSurf fails");
        }
    }
    void closest(const Points &queries, Points &feet) override {
        feet.clear();
        for (const Point &q : queries) {
            Point query = q;
            Found found;
            int status = 0;
            s1954(surface_, query.data(), 3, UNUSED, RESOLUTION, &found.point_count, &found.first, &found.curve_count, &found.curves,
                  &status);
            check("s1954", status);
            Point best{};
            double least = std::numeric_limits<double>::infinity();
            const auto offer = [&](const double *parameters) {
                const Point p = at(parameters);
                if (const double distance = length(p - q); distance < least) {
                    least = distance;
                    best = p;
                }
            };
            for (int k = 0; k < found.point_count; ++k) {
                offer(found.first + 2 * k);
            }
            for (int k = 0; k < found.curve_count; ++k) {
                offer(found.curves[k]->epar1);
            }
            feet.push_back(best);
        }
    }
    void lines(const std::vector<Line> &lines, Hits &hits) override {
        hits.clear();
        for (Line line : lines) {
            Found found;
            int status = 0;
            s1856(surface_, line.origin.data(), line.direction.data(), 3, UNUSED, RESOLUTION, &found.point_count, &found.first,
                  &found.curve_count, &found.curves, &status);
            check("s1856", status);
            for (int k = 0; k < found.point_count; ++k) {
                hits.points.push_back(at(found.first + 2 * k));
            }
            hits.ends.push_back(hits.points.size());
        }
    }
    void plane(const Plane &plane, Polylines &curves) override {
        Plane given = plane;
        Found found;
        int status = 0;
        s1851(surface_, given.origin.data(), given.normal.data(), 3, UNUSED, RESOLUTION, &found.point_count, &found.first,
              &found.curve_count, &found.curves, &status);
        check("s1851", status);
        curves.clear();
        curves.sampled = true;
        for (int k = 0; k < found.curve_count; ++k) {
            s1314(surface_, given.origin.data(), given.normal.data(), 3, UNUSED, RESOLUTION, 0, found.curves[k], 1, 0, &status);
            check("s1314", status);
            take(*found.curves[k], curves);
        }
    }
    void meet(Solver &other, Polylines &curves) override {
        SISLSurf *with = dynamic_cast<Sisl &>(other).surface_;
        Found found;
        int status = 0;
        s1859(surface_, with, UNUSED, RESOLUTION, &found.point_count, &found.first, &found.second, &found.curve_count, &found.curves,
              &status);
        check("s1859", status);
        curves.clear();
        curves.sampled = true;
        for (int k = 0; k < found.curve_count; ++k) {
            s1310(surface_, with, found.curves[k], RESOLUTION, 0, 1, 0, &status);
            check("s1310", status);
            take(*found.curves[k], curves);
        }
    }

private:
    void forget() {
        if (surface_) {
            freeSurf(surface_);
        }
        surface_ = nullptr;
    }
    Point at(const double *parameters) const {
        Point p{}, normal{};
        double parameter[2] = {parameters[0], parameters[1]};
        int left = 0, below = 0, status = 0;
        s1421(surface_, 0, parameter, &left, &below, p.data(), normal.data(), &status);
        check("s1421", status);
        return p;
    }
    static void take(const SISLIntcurve &found, Polylines &curves) {
        SISLCurve *curve = found.pgeom;
        if (!curve) {
            throw std::runtime_error("a curve is not marched");
        }
        const std::size_t begin = curves.points.size();
        const auto keep = [&](double t) {
            Point p{};
            int left = 0, status = 0;
            s1221(curve, 0, t, &left, p.data(), &status);
            check("s1221", status);
            curves.points.push_back(p);
        };
        for (int i = curve->ik - 1; i < curve->in; ++i) {
            const double low = curve->et[i], high = curve->et[i + 1];
            for (int k = 0; low < high && k < FINE; ++k) {
                keep(low + (high - low) * k / FINE);
            }
        }
        keep(curve->et[curve->in]);
        curves.ends.push_back(curves.points.size());
        curves.closed.push_back(length(curves.points[begin] - curves.points.back()) < 1e-6);
    }

    const Spline &spline_;
    SISLSurf *surface_ = nullptr;
};
} // namespace

std::unique_ptr<Solver> sisl(const Spline &spline) { return std::make_unique<Sisl>(spline); }
} // namespace surface
