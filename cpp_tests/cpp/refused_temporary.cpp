// Must not compile: what a handle that is gone lent.
#include <gusset.hpp>

std::size_t count(const gusset::MeshView &a, const gusset::MeshView &b) {
    const auto mesh = gusset::stitch(a, b).mesh();
    return mesh.face_count();
}

int main() { return 0; }
