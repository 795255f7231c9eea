// Stored mesh: the blob of a row of <name>_shape (form_blob.h).
//
//     byte 0   1      2..3   4..7        8..11     12..15
//   +--------+------+------+-----------+---------+--------+------------------+-----------------+----------+
//   | format | kind | 0    | triangles | corners | 0      | three corners of | x, y, z of each | checksum |
//   |  1     | 2..4 |      |           |         |        | each triangle    | corner          |          |
//   +--------+------+------+-----------+---------+--------+------------------+-----------------+----------+
//
// Kind is 2 for TIN Z, 3 for POLYHEDRALSURFACE Z, 4 for MULTIPOLYGON Z. Counts and corner numbers (from 0)
// take 4 bytes each, a corner is three doubles; all are little-endian. No corner is stored twice; corners are
// numbered in the order in which the triangles name them. Whether the mesh is closed is not stored.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "shape/mesh/mesh.h"

namespace foresee {

/// Requires: a sound mesh.
std::vector<std::byte> encode_mesh(const Mesh& mesh);

/// Returns what is wrong with a blob; null: nothing, and `mesh` is a sound mesh.
const char* decode_mesh(std::span<const std::byte> blob, Mesh& mesh);

}  // namespace foresee
