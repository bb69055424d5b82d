// Certificates through the C++ wrapper: the facts of a filled pyramid, and of results with a lie.
#include "soup.hpp"

#include <doctest/doctest.h>

namespace certificate_tests {

namespace {
/// A pyramid without its base.
Soup open_pyramid() {
    Soup soup;
    soup.points = {{0, 0, 2}, {1, 0, 1}, {0, 1, 1}, {-1, 0, 1}, {0, -1, 1}};
    for (uint32_t k = 0; k < 4; ++k) {
        soup.add_face({0, 1 + k, 1 + (k + 1) % 4});
    }
    return soup;
}
} // namespace

TEST_CASE("a filled pyramid keeps its faces") {
    const Soup soup = open_pyramid();
    const gusset::Fill fill(soup.view());
    const gusset::MeshView pieces[] = {soup.view()};
    const gusset::Certificate certificate(pieces, fill.mesh());
    const gusset_certificate_view facts = certificate.view();
    CHECK(facts.closed == 1);
    CHECK(facts.outward == 1);
    CHECK(facts.intersecting_pairs == 0);
    CHECK(facts.kept_faces == 4);
    CHECK(facts.new_faces == 2);
    CHECK(certificate.lost_faces().empty());
    CHECK(certificate.turned_faces().empty());
}

TEST_CASE("turned and lost faces are listed with their pieces") {
    const Soup soup = open_pyramid();
    Soup result;
    result.points = soup.points;
    result.add_face({0, 2, 1});
    result.add_face({2, 3, 0});
    const gusset::MeshView pieces[] = {soup.view(), soup.view()};
    const gusset::Certificate certificate(pieces, result.view());
    CHECK(certificate.view().kept_faces == 1);
    CHECK(certificate.turned_faces().size() == 2);
    CHECK(certificate.turned_faces()[1] == 0);
    CHECK(certificate.lost_faces().size() == 2 * 6);
    // The result lacks only this vertex.
    CHECK(certificate.view().farthest_vertex == 4);
}

} // namespace certificate_tests
