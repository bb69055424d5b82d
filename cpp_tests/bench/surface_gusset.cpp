// gusset, through its C interface.
#include "surface.hpp"

#include <gusset.h>

#include <algorithm>
#include <limits>

namespace surface {
namespace {
class Gusset : public Solver {
public:
    Gusset(unsigned threads, double chord) : chord_(chord) {
        check(gusset_context_create(&context_));
        check(gusset_context_set_threads(context_, threads));
    }
    ~Gusset() override {
        forget();
        gusset_context_destroy(context_);
    }
    void prepare() override { forget(); }
    void build() override {
        make_sheet();
        const gusset_sheet *const sheets[] = {sheet_};
        check(gusset_surface_create(context_, sheets, 1, nullptr, &surface_));
    }
    void closest(const Points &queries, Points &feet) override {
        found_.resize(queries.size());
        check(gusset_surface_nearest(context_, surface_, queries.data()->data(), queries.size(), nullptr, found_.data()));
        feet.clear();
        for (const gusset_surface_nearest_point &one : found_) {
            feet.push_back({one.point[0], one.point[1], one.point[2]});
        }
    }
    std::optional<std::vector<std::size_t>> unproven() const override {
        std::vector<std::size_t> made;
        for (std::size_t k = 0; k < found_.size(); ++k) {
            if (!(found_[k].flags & GUSSET_NEAREST_PROVEN)) {
                made.push_back(k);
            }
        }
        return made;
    }
    void lines(const std::vector<Line> &lines, Hits &hits) override {
        const std::vector<gusset_line> asked = given(lines, -std::numeric_limits<double>::infinity());
        gusset_surface_hits *found = nullptr;
        check(gusset_surface_hits_create(context_, surface_, asked.data(), asked.size(), nullptr, GUSSET_HITS_ALL, &found));
        const std::unique_ptr<gusset_surface_hits, decltype(&gusset_surface_hits_destroy)> owner(found, &gusset_surface_hits_destroy);
        gusset_surface_hits_view parts{};
        parts.struct_size = sizeof parts;
        check(gusset_surface_hits_get_view(found, &parts));
        hits.clear();
        hits.ends.assign(parts.ends + 1, parts.ends + 1 + parts.query_count);
        for (const gusset_surface_hit *hit = parts.hits; hit != parts.hits + parts.hit_count; ++hit) {
            hits.points.push_back({hit->point[0], hit->point[1], hit->point[2]});
        }
    }
    void rays(const std::vector<Line> &rays, Hits &hits) override {
        const std::vector<gusset_line> asked = given(rays, 0);
        first_.resize(rays.size());
        check(gusset_surface_first_hits(context_, surface_, asked.data(), asked.size(), first_.data()));
        hits.clear();
        for (const gusset_surface_hit &hit : first_) {
            if (hit.kind != GUSSET_HIT_NONE) {
                hits.points.push_back({hit.point[0], hit.point[1], hit.point[2]});
            }
            hits.ends.push_back(hits.points.size());
        }
    }
    void plane(const Plane &plane, Polylines &curves) override {
        gusset_contour_options options{};
        options.struct_size = sizeof options;
        options.spacing = chord_ > 0 ? GUSSET_POINT_SPACING_CHORD : GUSSET_POINT_SPACING_CELL_EDGES;
        options.chord = chord_;
        gusset_contour_function height{};
        height.struct_size = sizeof height;
        std::copy(plane.origin.begin(), plane.origin.end(), height.point);
        std::copy(plane.normal.begin(), plane.normal.end(), height.direction);
        const double level = 0;
        gusset_surface_paths *found = nullptr;
        check(gusset_surface_contours_create(context_, surface_, &height, &level, 1, &options, &found));
        take(found, curves);
    }
    void meet(Solver &other, Polylines &curves) override {
        gusset_intersection_options options{};
        options.struct_size = sizeof options;
        options.spacing = chord_ > 0 ? GUSSET_POINT_SPACING_CHORD : GUSSET_POINT_SPACING_CELL_EDGES;
        options.chord = chord_;
        gusset_surface_paths *found = nullptr;
        check(gusset_surface_intersection_create(context_, surface_, dynamic_cast<Gusset &>(other).surface_, &options, &found));
        take(found, curves);
    }

protected:
    virtual void make_sheet() = 0;

    void check(gusset_status status) const {
        if (status != GUSSET_OK) {
            throw std::runtime_error(gusset_status_text(status));
        }
    }
    void forget() {
        gusset_surface_destroy(surface_);
        gusset_sheet_destroy(sheet_);
        surface_ = nullptr;
        sheet_ = nullptr;
    }

    static std::vector<gusset_line> given(const std::vector<Line> &lines, double from) {
        std::vector<gusset_line> made(lines.size());
        for (std::size_t k = 0; k < lines.size(); ++k) {
            std::copy(lines[k].origin.begin(), lines[k].origin.end(), made[k].origin);
            std::copy(lines[k].direction.begin(), lines[k].direction.end(), made[k].direction);
            made[k].from = from;
            made[k].to = std::numeric_limits<double>::infinity();
        }
        return made;
    }

    void take(gusset_surface_paths *found, Polylines &curves) const {
        const std::unique_ptr<gusset_surface_paths, decltype(&gusset_surface_paths_destroy)> owner(found, &gusset_surface_paths_destroy);
        gusset_surface_paths_view parts{};
        parts.struct_size = sizeof parts;
        check(gusset_surface_paths_get_view(found, &parts));
        curves.clear();
        for (std::size_t k = 0; k < parts.path_count; ++k) {
            for (std::size_t i = parts.ends.data[k]; i < parts.ends.data[k + 1]; ++i) {
                curves.points.push_back({parts.points[3 * i], parts.points[3 * i + 1], parts.points[3 * i + 2]});
            }
            // The first point again, as others have it.
            if (parts.closed[k]) {
                const Point first = curves.points[curves.ends.empty() ? 0 : curves.ends.back()];
                curves.points.push_back(first);
            }
            curves.ends.push_back(curves.points.size());
            curves.closed.push_back(parts.closed[k] != 0);
        }
        curves.unresolved = parts.unresolved_count;
    }

    double chord_;
    gusset_context *context_ = nullptr;
    gusset_sheet *sheet_ = nullptr;
    gusset_surface *surface_ = nullptr;
    std::vector<gusset_surface_nearest_point> found_;
    std::vector<gusset_surface_hit> first_;
};

class OfNodes final : public Gusset {
public:
    OfNodes(const Nodes &nodes, unsigned threads, double chord) : Gusset(threads, chord), nodes_(nodes) {}

private:
    void make_sheet() override {
        gusset_nodes given{};
        given.struct_size = sizeof given;
        given.nodes = nodes_.points.data();
        given.rows = nodes_.rows;
        given.columns = nodes_.columns;
        given.scalar = GUSSET_F64;
        given.closed_u = given.closed_v = nodes_.closed ? 1 : 0;
        check(gusset_sheet_create(context_, &given, nullptr, 1, &sheet_));
    }

    const Nodes &nodes_;
};

class OfSpline final : public Gusset {
public:
    OfSpline(const Spline &spline, unsigned threads, double chord) : Gusset(threads, chord), spline_(spline) {}

private:
    void make_sheet() override {
        gusset_spline given{};
        given.struct_size = sizeof given;
        given.points = spline_.controls.data()->data();
        given.count_u = spline_.rows;
        given.count_v = spline_.columns;
        given.knots_u = spline_.u_knots.data();
        given.knot_count_u = spline_.u_knots.size();
        given.knots_v = spline_.v_knots.data();
        given.knot_count_v = spline_.v_knots.size();
        given.degree_u = given.degree_v = 3;
        check(gusset_sheet_from_spline_create(context_, &given, &sheet_));
    }

    const Spline &spline_;
};
} // namespace

std::unique_ptr<Solver> gusset(const Nodes &nodes, unsigned threads, double chord) {
    return std::make_unique<OfNodes>(nodes, threads, chord);
}
std::unique_ptr<Solver> gusset(const Spline &spline, unsigned threads, double chord) {
    return std::make_unique<OfSpline>(spline, threads, chord);
}
} // namespace surface
