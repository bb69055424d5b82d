// CGAL: the AABB tree of the triangles with its tree of points for closest points, the slicer for planes, and intersections of meshes.
#include "surface.hpp"

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/intersection.h>
#include <CGAL/Polygon_mesh_slicer.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <optional>

namespace surface {
namespace {
using Plain = CGAL::Simple_cartesian<double>;
using Exact = CGAL::Exact_predicates_inexact_constructions_kernel;

template <class Kernel> using Mesh = CGAL::Surface_mesh<typename Kernel::Point_3>;

template <class Kernel> Mesh<Kernel> mesh_of(const Triangles &triangles) {
    Mesh<Kernel> made;
    for (const Point &p : triangles.points) {
        made.add_vertex({p[0], p[1], p[2]});
    }
    using V = typename Mesh<Kernel>::Vertex_index;
    for (std::size_t c = 0; c < triangles.corners.size(); c += 3) {
        made.add_face(V(triangles.corners[c]), V(triangles.corners[c + 1]), V(triangles.corners[c + 2]));
    }
    return made;
}

template <class P> Point point(const P &p) { return {CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())}; }

/// The curves of points that others found, closed where the last point is the first.
template <class Lists> void take(const Lists &lists, Polylines &curves) {
    curves.clear();
    for (const auto &list : lists) {
        for (const auto &p : list) {
            curves.points.push_back(point(p));
        }
        curves.closed.push_back(list.size() > 1 && list.front() == list.back());
        curves.ends.push_back(curves.points.size());
    }
}

class Cgal : public Solver {
public:
    Cgal(const Triangles &triangles, bool with_points) : triangles_(triangles), with_points_(with_points) {}
    void prepare() override {
        tree_.reset();
        if (!mesh_) {
            mesh_ = mesh_of<Plain>(triangles_);
        }
    }
    void build() override {
        tree_.emplace(faces(*mesh_).first, faces(*mesh_).second, *mesh_);
        tree_->build();
        if (with_points_) {
            tree_->accelerate_distance_queries();
        }
    }
    void closest(const Points &queries, Points &feet) override {
        feet.clear();
        for (const Point &q : queries) {
            feet.push_back(point(tree_->closest_point({q[0], q[1], q[2]})));
        }
    }
    void lines(const std::vector<Line> &lines, Hits &hits) override {
        hits.clear();
        std::vector<Tree::Intersection_and_primitive_id<Plain::Line_3>::Type> found;
        for (const Line &line : lines) {
            const auto &[o, d] = line;
            found.clear();
            tree_->all_intersections(Plain::Line_3({o[0], o[1], o[2]}, Plain::Vector_3{d[0], d[1], d[2]}), std::back_inserter(found));
            for (const auto &one : found) {
                keep(one.first, hits);
            }
            hits.ends.push_back(hits.points.size());
        }
    }
    void rays(const std::vector<Line> &rays, Hits &hits) override {
        hits.clear();
        for (const Line &ray : rays) {
            const auto &[o, d] = ray;
            if (const auto found = tree_->first_intersection(Plain::Ray_3({o[0], o[1], o[2]}, Plain::Vector_3{d[0], d[1], d[2]}))) {
                keep(found->first, hits);
            }
            hits.ends.push_back(hits.points.size());
        }
    }
    void prepare_planes() override {
        if (!exact_) {
            exact_ = mesh_of<Exact>(triangles_);
        }
        slicer_.emplace(*exact_);
        Polylines once;
        plane({{0, 0, 1e9}, {0, 0, 1}}, once);
    }
    void plane(const Plane &plane, Polylines &curves) override {
        const auto &[o, n] = plane;
        std::vector<std::vector<Exact::Point_3>> found;
        (*slicer_)(Exact::Plane_3({o[0], o[1], o[2]}, Exact::Vector_3{n[0], n[1], n[2]}), std::back_inserter(found));
        take(found, curves);
    }
    void meet(Solver &other, Polylines &curves) override {
        auto &with = dynamic_cast<Cgal &>(other);
        for (Cgal *one : {this, &with}) {
            if (!one->exact_) {
                one->exact_ = mesh_of<Exact>(one->triangles_);
            }
        }
        std::vector<std::vector<Exact::Point_3>> found;
        CGAL::Polygon_mesh_processing::surface_intersection(*exact_, *with.exact_, std::back_inserter(found));
        take(found, curves);
    }

protected:
    using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Plain, CGAL::AABB_face_graph_triangle_primitive<Mesh<Plain>>>>;
    std::optional<Tree> tree_;

private:
    template <class Found> static void keep(const Found &found, Hits &hits) {
        if (const auto *p = boost::get<Plain::Point_3>(&found)) {
            hits.points.push_back(point(*p));
        }
    }

    const Triangles &triangles_;
    bool with_points_;
    std::optional<Mesh<Plain>> mesh_;
    std::optional<Mesh<Exact>> exact_;
    std::optional<CGAL::Polygon_mesh_slicer<Mesh<Exact>, Exact>> slicer_;
};

class CgalSegments final : public Cgal {
public:
    explicit CgalSegments(const Triangles &triangles) : Cgal(triangles, false) {}
    void prepare_planes() override {}
    void plane(const Plane &plane, Polylines &curves) override {
        const auto &[o, n] = plane;
        std::vector<Tree::Intersection_and_primitive_id<Plain::Plane_3>::Type> found;
        tree_->all_intersections(Plain::Plane_3({o[0], o[1], o[2]}, Plain::Vector_3{n[0], n[1], n[2]}), std::back_inserter(found));
        curves.clear();
        curves.ordered = false;
        for (const auto &one : found) {
            if (const auto *segment = boost::get<Plain::Segment_3>(&one.first)) {
                curves.points.push_back(point(segment->source()));
                curves.points.push_back(point(segment->target()));
                curves.ends.push_back(curves.points.size());
                curves.closed.push_back(false);
            }
        }
    }
};
} // namespace

std::unique_ptr<Solver> cgal(const Triangles &triangles, bool with_points) { return std::make_unique<Cgal>(triangles, with_points); }
std::unique_ptr<Solver> cgal_segments(const Triangles &triangles) { return std::make_unique<CgalSegments>(triangles); }
} // namespace surface
