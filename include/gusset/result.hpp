/// @file
/// Meshes that the library made. Include gusset.hpp, not this.
#ifndef GUSSET_RESULT_HPP
#define GUSSET_RESULT_HPP

#include <gusset/attributes.hpp>
#include <gusset/mesh.hpp>

namespace gusset {

/// A mesh that an operation made; see gusset_result. The class of each operation adds its report. Views and spans live as
/// long as this, and are not lent by a temporary.
class Result {
public:
    /// See ::gusset_result_get_mesh.
    MeshView mesh() const & { return MeshView(detail::lent(gusset_result_get_mesh, get())); }
    MeshView mesh() const && = delete;
    /// Where the vertices, corners and faces of the mesh come from.
    Origins origins(const Context &context = Context()) const {
        return Origins(context.result(gusset_result_origins_create, get()));
    }
    /// The argument for the C interface, which this still owns.
    const gusset_result *get() const noexcept { return result_.get(); }

protected:
    Result() = default;
    /// Owns what a function of the C interface made.
    void take(gusset_result *made) { result_.reset(made); }

private:
    detail::Handle<gusset_result, gusset_result_destroy> result_;
};

} // namespace gusset

#endif // GUSSET_RESULT_HPP
