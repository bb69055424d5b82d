// The crate parry3d-f64, by way of bench/parry.
#include "surface.hpp"

struct ParryParts;
struct ParryMesh;
using ParryReceive = void (*)(void *user, std::size_t k, const double *point);

extern "C" {
ParryParts *parry_parts(const double *points, std::size_t count, const uint32_t *corners, std::size_t faces);
ParryMesh *parry_mesh(ParryParts *parts);
void parry_free(ParryMesh *mesh);
void parry_closest(const ParryMesh *mesh, const double *queries, std::size_t count, double *feet);
void parry_lines(const ParryMesh *mesh, const double *lines, std::size_t count, void *user, ParryReceive receive);
void parry_rays(const ParryMesh *mesh, const double *lines, std::size_t count, void *user, ParryReceive receive);
void parry_plane(const ParryMesh *mesh, const double *normal, double bias, void *user, ParryReceive receive);
}

namespace surface {
namespace {
/// Points that come by the number of their question, to an answer of one kind or the other.
template <class Answer> struct Receiver {
    Answer &answer;
    std::size_t question = 0;

    static void receive(void *user, std::size_t k, const double *point) {
        auto &self = *static_cast<Receiver *>(user);
        self.upto(k);
        self.answer.points.push_back({point[0], point[1], point[2]});
    }
    /// All questions before this one are answered.
    void upto(std::size_t k) {
        for (; question < k; ++question) {
            answer.ends.push_back(answer.points.size());
        }
    }
};

class Parry final : public Solver {
public:
    explicit Parry(const Triangles &triangles) : triangles_(triangles) {}
    ~Parry() override {
        parry_free(mesh_);
        parry_free(parts_ ? parry_mesh(parts_) : nullptr);
    }
    void prepare() override {
        parry_free(mesh_);
        mesh_ = nullptr;
        const auto &[points, corners] = triangles_;
        parts_ = parry_parts(points.data()->data(), points.size(), corners.data(), corners.size() / 3);
    }
    void build() override {
        mesh_ = parry_mesh(parts_);
        parts_ = nullptr;
        if (!mesh_) {
            throw std::runtime_error("TriMesh::new fails");
        }
    }
    void closest(const Points &queries, Points &feet) override {
        feet.resize(queries.size());
        parry_closest(mesh_, queries.data()->data(), queries.size(), feet.data()->data());
    }
    void lines(const std::vector<Line> &lines, Hits &hits) override { ask(parry_lines, lines, hits); }
    void rays(const std::vector<Line> &rays, Hits &hits) override { ask(parry_rays, rays, hits); }
    void plane(const Plane &plane, Polylines &curves) override {
        Receiver<Polylines> receiver{curves};
        curves.clear();
        parry_plane(mesh_, plane.normal.data(), dot(plane.normal, plane.origin), &receiver, Receiver<Polylines>::receive);
        curves.ends.push_back(curves.points.size());
        std::size_t begin = 0;
        for (const std::size_t end : curves.ends) {
            curves.closed.push_back(end > begin && curves.points[begin] == curves.points[end - 1]);
            begin = end;
        }
    }

private:
    template <class Function> void ask(Function function, const std::vector<Line> &lines, Hits &hits) {
        Receiver<Hits> receiver{hits};
        hits.clear();
        function(mesh_, lines.data()->origin.data(), lines.size(), &receiver, Receiver<Hits>::receive);
        receiver.upto(lines.size());
    }

    const Triangles &triangles_;
    ParryParts *parts_ = nullptr;
    ParryMesh *mesh_ = nullptr;
};
} // namespace

std::unique_ptr<Solver> parry(const Triangles &triangles) { return std::make_unique<Parry>(triangles); }
} // namespace surface
