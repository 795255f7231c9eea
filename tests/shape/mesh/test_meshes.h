// Meshes for tests, as texts and as objects.
#pragma once

#include <string>

namespace foresee {

/// A corner at the origin, one along each axis: four triangles.
constexpr const char* tetrahedron =
    "POLYHEDRALSURFACE Z(((0 0 0, 0 1 0, 1 0 0, 0 0 0)), ((0 0 0, 1 0 0, 0 0 1, 0 0 0)), "
    "((0 0 0, 0 0 1, 0 1 0, 0 0 0)), ((1 0 0, 0 1 0, 0 0 1, 1 0 0)))";

/// A surface of `triangles` connected triangles in the form of a fan, as a text that starts with `word`.
std::string fan(const std::string& word, std::size_t triangles);

}  // namespace foresee
