// Layout of a stored tree node: sizes, capacities and byte offsets, fixed when a table is created.
//
//     byte 0   1       2..3   4..7   8..15                        last 4
//   +-------+--------+-------+------+--------+- - - - - - - - - +----------+
//   | level | format | count | 0    | parent | leaf or inner    | checksum |
//   +-------+--------+-------+------+--------+- - - - - - - - - +----------+
//
//   leaf (level 0):    ids[leaf_capacity] from byte 16, ascending; then records[leaf_capacity]
//   inner (level > 0): epoch at byte 16; entries[inner_capacity] from byte 24
//
// Little-endian; every number of 8 bytes is aligned to 8. The checksum is the CRC-32C of the bytes before it
// and the node number, so a node that is stored under another number is detected too. docs/developers/storage_format.md
// has the details.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <span>

#include "shape/row_layout.h"

namespace foresee {

static_assert(std::endian::native == std::endian::little,
              "nodes are stored in the byte order of a little-endian CPU");

struct NodeFormat {
  static constexpr int version = 2;
  static constexpr std::size_t level_at = 0;
  static constexpr std::size_t format_at = 1;
  static constexpr std::size_t count_at = 2;
  static constexpr std::size_t parent_at = 8;
  static constexpr std::size_t ids_at = 16;
  static constexpr std::size_t epoch_at = 16;
  static constexpr std::size_t entries_at = 24;
  static constexpr std::size_t checksum_size = 4;
  static constexpr std::size_t min_capacity = 4;   ///< entries per node at least, even on the smallest pages
  static constexpr std::size_t page_reserve = 64;  ///< bytes of a page that SQLite needs besides the blob

  NodeFormat() = default;
  /// Requires: `node_size_for` returned this node_size for some page size.
  NodeFormat(const Layout& layout, std::size_t node_size);

  /// Size in bytes of a table's node blobs. A blob fits into one page, unless it would then hold fewer than
  /// `min_capacity` entries.
  static std::size_t node_size_for(const Layout& layout, std::size_t page_size);
  /// The smallest page size of SQLite for which node_size_for() returns this node size.
  static std::optional<std::size_t> page_size_for(const Layout& layout, std::size_t node_size);

  Layout layout;
  Offsets at;  ///< offsets in a record
  std::size_t node_size = 0;
  std::size_t record_size = 0;  ///< bytes
  std::size_t leaf_capacity = 0;
  std::size_t records_at = 0;
  std::size_t inner_entry_size = 0;  ///< bytes
  std::size_t inner_capacity = 0;
};

template <class T>
T load_number(const std::byte* at) {
  T value;
  std::memcpy(&value, at, sizeof value);
  return value;
}

template <class T>
void store_number(std::byte* at, T value) {
  std::memcpy(at, &value, sizeof value);
}

/// The checksum of node `number`: of all bytes but the last four, and of the number.
std::uint32_t node_checksum(std::span<const std::byte> node, std::int64_t number);

/// Writes the checksum of node `number` into its last bytes.
void seal_node(std::span<std::byte> node, std::int64_t number);

/// Returns what is wrong with size, checksum or format of a blob that claims to be node `number`; null:
/// nothing. The caller checks level, count and contents.
const char* node_fault(const NodeFormat& format, std::span<const std::byte> node, std::int64_t number);

}  // namespace foresee
