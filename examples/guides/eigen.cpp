// The program of the section on matrices in docs/guides/cpp.md.
//! [includes]
#include <gusset/eigen.hpp>
//! [includes]

#include <iostream>

int main() {
    // An open pyramid, whose base is a quad that is missing.
    Eigen::MatrixXd V(5, 3);
    V << 1, 0, 0, 0, 1, 0, -1, 0, 0, 0, -1, 0, 0, 0, 1;
    Eigen::MatrixXi F(4, 3);
    F << 0, 1, 4, 1, 2, 4, 2, 3, 4, 3, 0, 4;
    //! [eigen]
    const gusset::eigen::Input pyramid(V, F); // rows of V are vertices, rows of F are faces, as in libigl
    const gusset::Fill filled(pyramid.view());
    const Eigen::MatrixXd points = gusset::eigen::vertices(filled.mesh());
    const Eigen::MatrixXi faces = gusset::eigen::faces(filled.mesh());
    //! [eigen]
    std::cout << points.rows() << " vertices, " << faces.rows() << " faces\n";
    return points.topRows(5) == V && faces.topRows(4) == F ? 0 : 1;
}
