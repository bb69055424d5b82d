/// @file
/// Matrices of Eigen, such as V and F of libigl, as input and output of gusset. Needs Eigen 3.3 or later.
///
/// Row v of V is the position of vertex v. Row f of F has the vertices of face f.
#ifndef GUSSET_EIGEN_HPP
#define GUSSET_EIGEN_HPP

#include <gusset.hpp>

#include <Eigen/Core>

#include <string>
#include <type_traits>
#include <vector>

namespace gusset::eigen {

/// A mesh in two matrices as gusset sees it, triangles if F has three columns. Rows of V that are stored by rows are read in
/// place, so V must outlive this object. Other orders are copied. F is copied.
template <class Scalar>
class Input {
    using Rows = Eigen::Matrix<Scalar, Eigen::Dynamic, 3, Eigen::RowMajor>;

public:
    /// Reads V, n x 3 floats or doubles, and F, m x k integers of any size, both stored by rows or by columns. Throws an Error
    /// if V has other columns than three, or for the first corner of F that is not from 0 to n - 1.
    template <class V, class F>
    Input(const Eigen::DenseBase<V> &v, const Eigen::DenseBase<F> &f) : positions_(three_columns(v)) {
        static_assert(std::is_integral_v<typename F::Scalar>, "F has integers: the vertices of each face");
        face_size_ = static_cast<uint32_t>(f.cols());
        corners_.reserve(static_cast<std::size_t>(f.size()));
        for (Eigen::Index row = 0; row < f.rows(); ++row) {
            for (Eigen::Index column = 0; column < f.cols(); ++column) {
                corners_.push_back(vertex(f.derived()(row, column), row, column));
            }
        }
    }
    /// A matrix that is gone with the expression cannot be borrowed.
    template <class V, class F>
    Input(Eigen::PlainObjectBase<V> &&v, const Eigen::DenseBase<F> &f) = delete;
    Input(const Input &) = delete;
    Input &operator=(const Input &) = delete;

    /// The mesh as the library reads it.
    MeshView view() const {
        auto view = gusset::detail::sized<gusset_mesh_view>();
        view.positions = positions_.data();
        view.position_stride = static_cast<std::size_t>(positions_.outerStride()) * sizeof(Scalar);
        view.vertex_count = static_cast<std::size_t>(positions_.rows());
        view.scalar = std::is_same_v<Scalar, float> ? GUSSET_F32 : GUSSET_F64;
        view.face_corners = corners_.data();
        view.face_count = face_size_ == 0 ? 0 : corners_.size() / face_size_;
        view.face_size = face_size_;
        return MeshView(view);
    }

private:
    template <class V>
    static const V &three_columns(const Eigen::DenseBase<V> &v) {
        static_assert(std::is_same_v<typename V::Scalar, float> || std::is_same_v<typename V::Scalar, double>, "V has floats or doubles");
        if (v.cols() != 3) {
            gusset::detail::refuse(GUSSET_ERROR_COUNT_DIFFERS, "V has " + std::to_string(v.cols()) + " columns, not 3");
        }
        return v.derived();
    }
    template <class Integer>
    uint32_t vertex(Integer number, Eigen::Index row, Eigen::Index column) const {
        const auto count = static_cast<std::make_unsigned_t<Integer>>(number);
        if (number < Integer(0) || count >= static_cast<std::make_unsigned_t<Eigen::Index>>(positions_.rows())) {
            gusset::detail::refuse(GUSSET_ERROR_INDEX_OUT_OF_RANGE,
                                   "F(" + std::to_string(row) + ", " + std::to_string(column) + ") is " + std::to_string(number) +
                                       " (V has " + std::to_string(positions_.rows()) + " rows)",
                                   corners_.size(), GUSSET_ELEMENT_HALF_EDGE, static_cast<double>(number));
        }
        return static_cast<uint32_t>(number);
    }

    Eigen::Ref<const Rows, 0, Eigen::OuterStride<>> positions_;
    std::vector<uint32_t> corners_;
    uint32_t face_size_ = 0;
};
/// Input(V, F) has the scalar type of V.
template <class V, class F>
Input(const Eigen::DenseBase<V> &, const Eigen::DenseBase<F> &) -> Input<typename V::Scalar>;

/// The positions of a mesh as rows.
template <class Matrix = Eigen::MatrixXd>
Matrix vertices(const MeshView &mesh) {
    Matrix made(static_cast<Eigen::Index>(mesh.vertex_count()), 3);
    for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
        const Point3 p = mesh.position(v);
        for (Eigen::Index k = 0; k < 3; ++k) {
            made(static_cast<Eigen::Index>(v), k) = static_cast<typename Matrix::Scalar>(p[static_cast<std::size_t>(k)]);
        }
    }
    return made;
}

/// The faces of a mesh as rows. All have as many corners as the first one; gusset::Triangulation makes triangles of others. Throws
/// an Error for the first face of another size.
template <class Matrix = Eigen::MatrixXi>
Matrix faces(const MeshView &mesh) {
    const std::size_t columns = mesh.face_count() == 0 ? 3 : mesh.face(0).size();
    Matrix made(static_cast<Eigen::Index>(mesh.face_count()), static_cast<Eigen::Index>(columns));
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        const Indices face = mesh.face(f);
        if (face.size() != columns) {
            gusset::detail::refuse(GUSSET_ERROR_COUNT_DIFFERS,
                                   "face " + std::to_string(f) + " has " + std::to_string(face.size()) + " corners, and face 0 has " +
                                       std::to_string(columns) + ": gusset::Triangulation makes triangles",
                                   f, GUSSET_ELEMENT_FACE, static_cast<double>(face.size()));
        }
        for (std::size_t k = 0; k < columns; ++k) {
            made(static_cast<Eigen::Index>(f), static_cast<Eigen::Index>(k)) = static_cast<typename Matrix::Scalar>(face[k]);
        }
    }
    return made;
}

} // namespace gusset::eigen

#endif // GUSSET_EIGEN_HPP
