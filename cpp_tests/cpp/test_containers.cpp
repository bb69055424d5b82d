// Containers that views take without a copy, matrices of Eigen, and the spans that views lend.
#include <gusset/eigen.hpp>

#include <doctest/doctest.h>

#include <random>
#include <string>

namespace containers_tests {

namespace {
using gusset::MeshView;

/// A folded pair of triangles.
const std::vector<std::array<double, 3>> points{{0, 0, 0}, {2, 0, 0}, {2, 2, 1}, {0, 2, 0}};
const std::vector<uint32_t> corners{0, 1, 2, 0, 2, 3};

bool same(const MeshView &view) {
    bool is_same = view.vertex_count() == points.size() && view.face_count() == 2;
    for (std::size_t v = 0; is_same && v < points.size(); ++v) {
        is_same = view.position(v) == points[v];
    }
    const gusset::Indices lent = view.corners();
    return is_same && std::equal(lent.begin(), lent.end(), corners.begin(), corners.end());
}

/// The error that `work` throws: every one of ours is a gusset::Error.
template <class Work>
gusset_error_report report_of(Work &&work) {
    try {
        work();
    } catch (const gusset::Error &error) {
        CHECK(!std::string(error.what()).empty());
        return error.report();
    }
    FAIL("not refused");
    return {};
}

template <class V, class F>
void check_matrices() {
    V v(4, 3);
    F f(2, 3);
    for (Eigen::Index row = 0; row < 4; ++row) {
        for (Eigen::Index column = 0; column < 3; ++column) {
            v(row, column) = static_cast<typename V::Scalar>(points[std::size_t(row)][std::size_t(column)]);
        }
    }
    f << 0, 1, 2, 0, 2, 3;
    const gusset::eigen::Input input(v, f);
    CHECK(same(input.view()));
    CHECK((input.view().get().positions == v.data()) == bool(V::IsRowMajor));
    CHECK(gusset::Boundary(input.view())[0].vertices.size() == 4);
    CHECK(gusset::eigen::vertices<V>(input.view()) == v);
    CHECK(gusset::eigen::faces<F>(input.view()) == f);
    f(1, 2) = 4;
    gusset_error_report report = report_of([&] { gusset::eigen::Input(v, f); });
    CHECK(report.status == GUSSET_ERROR_INDEX_OUT_OF_RANGE);
    CHECK(report.index == 5);
    CHECK(report.value == 4);
    if (std::is_signed_v<typename F::Scalar>) {
        f(1, 0) = static_cast<typename F::Scalar>(-7);
        report = report_of([&] { gusset::eigen::Input(v, f); });
        CHECK(report.index == 3);
        CHECK(report.value == -7);
    }
}
} // namespace

TEST_CASE("containers of corners") {
    const std::vector<std::array<uint32_t, 3>> rows{{0, 1, 2}, {0, 2, 3}};
    const std::vector<std::array<int, 3>> signed_rows{{0, 1, 2}, {0, 2, 3}};
    const std::vector<int> numbers{0, 1, 2, 0, 2, 3};
    const int raw[2][3] = {{0, 1, 2}, {0, 2, 3}};
    const std::vector<Eigen::Vector3i> vectors{{0, 1, 2}, {0, 2, 3}};
    CHECK(same(MeshView::triangles(points, corners)));
    CHECK(same(MeshView::triangles(points, rows)));
    CHECK(same(MeshView::triangles(points, signed_rows)));
    CHECK(same(MeshView::triangles(points, numbers)));
    CHECK(same(MeshView::triangles(points, raw)));
    CHECK(same(MeshView::triangles(points, vectors)));
    CHECK(same(MeshView::triangles(points, gusset::Span<const int>(numbers))));
    // Nothing is copied.
    CHECK(MeshView::triangles(points, rows).corners().data() == rows[0].data());
    const std::vector<std::array<int, 4>> quads{{0, 1, 2, 3}};
    CHECK(MeshView::uniform(points, quads, 4).face(0).size() == 4);
    CHECK(report_of([&] { MeshView::uniform(points, quads, 2); }).status == GUSSET_ERROR_COUNT_DIFFERS);
    const std::vector<int> offsets{0, 3, 6};
    const MeshView polygons = MeshView::polygons(points, gusset::Offsets(offsets), gusset::Corners(rows));
    CHECK(same(polygons));
    CHECK(polygons.offsets().size() == 3);
    // A loop of signed indices.
    const std::vector<int> loop{0, 1, 2, 3};
    const gusset::Fill filled(polygons, std::vector<gusset::Indices>{loop});
    CHECK(filled.mesh().face_count() > 2);
}

TEST_CASE("the first negative index is named") {
    std::mt19937 random(1);
    for (int run = 0; run < 200; ++run) {
        std::vector<std::array<int, 3>> rows(1 + random() % 20, {0, 1, 2});
        const std::size_t place = random() % (3 * rows.size());
        const int value = -1 - int(random() % 1000);
        rows[place / 3][place % 3] = value;
        rows.push_back({-1, -1, -1});
        const gusset_error_report report = report_of([&] { MeshView::triangles(points, rows); });
        CHECK(report.status == GUSSET_ERROR_INDEX_OUT_OF_RANGE);
        CHECK(report.element == GUSSET_ELEMENT_HALF_EDGE);
        CHECK(report.index == place);
        CHECK(report.value == value);
    }
    const std::vector<int> loop{0, 1, -2}, offsets{0, -3};
    CHECK(report_of([&] { gusset::Indices{loop}; }).index == 2);
    CHECK(report_of([&] { gusset::Offsets{offsets}; }).index == 1);
}

TEST_CASE("containers of points") {
    const std::vector<double> flat{0, 0, 0, 2, 0, 0, 2, 2, 1, 0, 2, 0};
    const float raw[4][3] = {{0, 0, 0}, {2, 0, 0}, {2, 2, 1}, {0, 2, 0}};
    const std::vector<Eigen::Vector3f> vectors{{0, 0, 0}, {2, 0, 0}, {2, 2, 1}, {0, 2, 0}};
    CHECK(same(MeshView::triangles(flat, corners)));
    CHECK(same(MeshView::triangles(raw, corners)));
    CHECK(same(MeshView::triangles(vectors, corners)));
    const std::vector<double> cut(flat.begin(), flat.end() - 1);
    CHECK(report_of([&] { MeshView::triangles(cut, corners); }).status == GUSSET_ERROR_COUNT_DIFFERS);
}

TEST_CASE("views lend their arrays") {
    const MeshView view = MeshView::triangles(points, corners);
    CHECK(view.positions().data() == points.data());
    CHECK(view.positions().size() == 4);
    CHECK(view.corners().size() == 6);
    CHECK(view.offsets().empty());
    CHECK(view.face_size() == 3);
    CHECK(!view.has_floats());
    CHECK_THROWS_AS(view.positions<float>(), gusset::Error);
    const std::vector<Eigen::Vector4d> wide(4, Eigen::Vector4d(0, 0, 0, 1));
    CHECK(report_of([&] { MeshView::triangles(wide, corners).positions(); }).status == GUSSET_ERROR_BAD_STRIDE);
    const float single[4][3] = {{0, 0, 0}, {2, 0, 0}, {2, 2, 1}, {0, 2, 0}};
    const gusset::Weld weld(MeshView::triangles(single, corners));
    CHECK(weld.mesh().has_floats());
    CHECK(weld.mesh().positions<float>()[2][2] == 1.0f);
    CHECK(weld.mesh().offsets().size() == 3);
    CHECK(weld.mesh().corners().size() == 6);
}

TEST_CASE("matrices of Eigen") {
    using Eigen::Dynamic;
    using Eigen::RowMajor;
    check_matrices<Eigen::MatrixXd, Eigen::MatrixXi>();
    check_matrices<Eigen::MatrixXf, Eigen::Matrix<int64_t, Dynamic, Dynamic>>();
    check_matrices<Eigen::Matrix<double, Dynamic, 3, RowMajor>, Eigen::Matrix<int, Dynamic, 3, RowMajor>>();
    check_matrices<Eigen::Matrix<float, Dynamic, Dynamic, RowMajor>, Eigen::Matrix<unsigned, Dynamic, 3>>();
    check_matrices<Eigen::Matrix<double, 4, 3>, Eigen::Matrix<short, 2, 3>>();

    const Eigen::MatrixXi f = Eigen::RowVector3i(0, 1, 2);
    const Eigen::MatrixXd planar = Eigen::MatrixXd::Zero(3, 2);
    CHECK(report_of([&] { gusset::eigen::Input(planar, f); }).status == GUSSET_ERROR_COUNT_DIFFERS);
    // Three columns of five, in place.
    Eigen::Matrix<double, Dynamic, Dynamic, RowMajor> wide = Eigen::MatrixXd::Constant(3, 5, 9);
    wide.leftCols(3) = Eigen::Matrix3d::Identity();
    const gusset::eigen::Input part(wide.leftCols(3), f);
    CHECK(part.view().get().positions == wide.data());
    CHECK(part.view().position(2) == gusset::Point3{0, 0, 1});
    // A quad and a triangle have no matrix of faces, but their triangles have.
    const std::vector<uint32_t> offsets{0, 4, 7}, mixed{0, 1, 2, 3, 0, 3, 1};
    const MeshView polygons = MeshView::polygons(points, gusset::Offsets(offsets), gusset::Corners(mixed));
    CHECK(report_of([&] { gusset::eigen::faces(polygons); }).index == 1);
    const gusset::Triangulation triangles(polygons);
    CHECK(gusset::eigen::faces(triangles.mesh()).rows() == 3);
}

} // namespace containers_tests
