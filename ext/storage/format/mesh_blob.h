// A mesh as it is stored: a row's blob of <name>_shape (form_blob.h).
//
//     byte 0   1      2..3   4..7        8..11     12..15
//   +--------+------+------+-----------+---------+--------+------------------+-----------------+----------+
//   | format | kind | 0    | triangles | corners | 0      | three corners of | x, y, z of each | checksum |
//   |  1     | 2..4 |      |           |         |        | each triangle    | corner          |          |
//   +--------+------+------+-----------+---------+--------+------------------+-----------------+----------+
//
// Kind is 2 of TIN Z, 3 of POLYHEDRALSURFACE Z, 4 of MULTIPOLYGON Z. Counts and the numbers of corners, from
// 0, are of 4 bytes, corners three doubles of 8, little-endian. No corner comes twice; they are numbered in
// the order in which triangles name them. Whether the mesh is closed is not stored.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "shape/mesh/mesh.h"

namespace foresee {

/// Requires: a sound mesh.
std::vector<std::byte> encode_mesh(const Mesh& mesh);

/// What is wrong with a blob; null: nothing, and `mesh` is a sound mesh.
const char* decode_mesh(std::span<const std::byte> blob, Mesh& mesh);

}  // namespace foresee
