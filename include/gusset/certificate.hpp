/// @file
/// Certificates of results. Include gusset.hpp, not this.
#ifndef GUSSET_CERTIFICATE_HPP
#define GUSSET_CERTIFICATE_HPP

#include <gusset/mesh.hpp>

namespace gusset {

/// Facts about a result that verify.py checks without the library; see gusset_certificate_view, whose lists live as long as this.
class Certificate {
public:
    /// See ::gusset_certificate_create.
    Certificate(Span<const MeshView> pieces, const MeshView &result, const Context &context = Context()) {
        std::vector<gusset_mesh_view> views;
        for (const MeshView &piece : pieces) {
            views.push_back(piece.get());
        }
        certificate_.reset(context.result(gusset_certificate_create, views.data(), views.size(), &result.get()));
    }
    /// See ::gusset_certificate_get_view.
    gusset_certificate_view view() const & { return detail::lent(gusset_certificate_get_view, certificate_.get()); }
    gusset_certificate_view view() const && = delete;
    /// The faces of the pieces that the result lacks: piece, face, piece, face, ...
    Indices lost_faces() const & { return detail::indices(view().lost_faces); }
    Indices lost_faces() const && = delete;
    /// The faces of the pieces that the result has only reversed: piece, face, piece, face, ...
    Indices turned_faces() const & { return detail::indices(view().turned_faces); }
    Indices turned_faces() const && = delete;

private:
    detail::Handle<gusset_certificate, gusset_certificate_destroy> certificate_;
};

} // namespace gusset

#endif // GUSSET_CERTIFICATE_HPP
