// Open CASCADE: projections, a line with a surface and surfaces with one another, through its package GeomAPI.
#include "surface.hpp"

#include <GeomAPI_IntCS.hxx>
#include <GeomAPI_IntSS.hxx>
#include <GeomAPI_ProjectPointOnSurf.hxx>
#include <GeomConvert.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_Line.hxx>
#include <Geom_Plane.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <Standard_Failure.hxx>

namespace surface {
namespace {
constexpr double TOLERANCE = 1e-7;
/// How finely a curve is looked at: points on each.
constexpr int FINE = 400;

gp_Pnt point(const Point &p) { return {p[0], p[1], p[2]}; }
gp_Dir direction(const Point &d) { return {d[0], d[1], d[2]}; }
Point point(const gp_Pnt &p) { return {p.X(), p.Y(), p.Z()}; }

/// Failures of this version do not derive from std::exception.
template <class Work> void guarded(Work &&work) {
    try {
        work();
    } catch (const Standard_Failure &failure) {
        throw std::runtime_error(failure.GetMessageString());
    }
}

/// Knots of degree 3, without their repetitions.
std::pair<TColStd_Array1OfReal, TColStd_Array1OfInteger> knots(const std::vector<double> &all) {
    const int spans = static_cast<int>(all.size()) - 7;
    TColStd_Array1OfReal values(1, spans + 1);
    TColStd_Array1OfInteger multiplicities(1, spans + 1);
    for (int i = 0; i <= spans; ++i) {
        values(i + 1) = all[static_cast<std::size_t>(i) + 3];
        multiplicities(i + 1) = i == 0 || i == spans ? 4 : 1;
    }
    return {values, multiplicities};
}

Handle(Geom_Surface) surface_of(const Spline &spline) {
    TColgp_Array2OfPnt poles(1, static_cast<int>(spline.rows), 1, static_cast<int>(spline.columns));
    for (std::size_t i = 0; i < spline.rows; ++i) {
        for (std::size_t j = 0; j < spline.columns; ++j) {
            poles(static_cast<int>(i) + 1, static_cast<int>(j) + 1) = point(spline.controls[i * spline.columns + j]);
        }
    }
    const auto [u, u_times] = knots(spline.u_knots);
    const auto [v, v_times] = knots(spline.v_knots);
    return new Geom_BSplineSurface(poles, u, v, u_times, v_times, 3, 3);
}

Handle(Geom_Surface) torus_at(const Point &centre) {
    return GeomConvert::SurfaceToBSplineSurface(new Geom_ToroidalSurface(gp_Ax3(point(centre), gp_Dir(0, 0, 1)), 1, 0.4));
}

class Occt final : public Solver {
public:
    explicit Occt(std::function<Handle(Geom_Surface)()> make) : make_(std::move(make)) {}
    void build() override {
        guarded([&] {
            surface_ = make_();
            double u0 = 0, u1 = 0, v0 = 0, v1 = 0;
            surface_->Bounds(u0, u1, v0, v1);
            projection_.Init(surface_, u0, u1, v0, v1);
        });
    }
    void closest(const Points &queries, Points &feet) override {
        feet.clear();
        guarded([&] {
            for (const Point &q : queries) {
                projection_.Perform(point(q));
                // Without a foot of a perpendicular, it returns no answer.
                feet.push_back(projection_.NbPoints() ? point(projection_.NearestPoint()) : Point{1e9, 0, 0});
            }
        });
    }
    void lines(const std::vector<Line> &lines, Hits &hits) override {
        hits.clear();
        guarded([&] {
            for (const Line &line : lines) {
                const GeomAPI_IntCS found(new Geom_Line(point(line.origin), direction(line.direction)), surface_);
                for (int k = 1; k <= found.NbPoints(); ++k) {
                    hits.points.push_back(point(found.Point(k)));
                }
                hits.ends.push_back(hits.points.size());
            }
        });
    }
    void plane(const Plane &plane, Polylines &curves) override {
        guarded([&] { take(GeomAPI_IntSS(surface_, new Geom_Plane(point(plane.origin), direction(plane.normal)), TOLERANCE), curves); });
    }
    void meet(Solver &other, Polylines &curves) override {
        guarded([&] { take(GeomAPI_IntSS(surface_, dynamic_cast<Occt &>(other).surface_, TOLERANCE), curves); });
    }

private:
    static void take(const GeomAPI_IntSS &found, Polylines &curves) {
        if (!found.IsDone()) {
            throw std::runtime_error("GeomAPI_IntSS is not done");
        }
        curves.clear();
        curves.sampled = true;
        for (int k = 1; k <= found.NbLines(); ++k) {
            const Handle(Geom_Curve) &curve = found.Line(k);
            const double low = curve->FirstParameter(), high = curve->LastParameter();
            for (int i = 0; i <= FINE; ++i) {
                curves.points.push_back(point(curve->Value(low + (high - low) * i / FINE)));
            }
            curves.ends.push_back(curves.points.size());
            curves.closed.push_back(curve->Value(low).Distance(curve->Value(high)) < 1e-6);
        }
    }

    std::function<Handle(Geom_Surface)()> make_;
    Handle(Geom_Surface) surface_;
    GeomAPI_ProjectPointOnSurf projection_;
};
} // namespace

std::unique_ptr<Solver> occt(const Spline &spline) {
    return std::make_unique<Occt>([&spline] { return surface_of(spline); });
}
std::unique_ptr<Solver> occt_torus(const Point &centre) {
    return std::make_unique<Occt>([centre] { return torus_at(centre); });
}
} // namespace surface
