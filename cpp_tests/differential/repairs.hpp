// Welding, sewing and orienting, and what all results are held to.
#pragma once

#include "../cpp/judge.hpp"
#include "campaign.hpp"

namespace campaign::of_validity {
std::vector<uint32_t> face_of(const gusset::MeshView &mesh, std::size_t f);
/// `turned`: with the first corner kept, and the others in reverse order.
bool same_face(const std::vector<uint32_t> &was, std::vector<uint32_t> is, bool turned);
/// A closed, connected mesh without self-intersections bounds a volume.
void check_outward(Case &test, const gusset::MeshView &mesh, const Verdict &verdict);

void welded(Case &test);
void sewn(Case &test);
void oriented(Case &test);
} // namespace campaign::of_validity
