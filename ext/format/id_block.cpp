#include "format/id_block.h"

#include <algorithm>
#include <bit>
#include <cstring>

namespace foresee {
namespace {

/// The offsets of a block with all its ids: most blocks are full.
constexpr std::array<std::byte, IdBlock::ids> all_offsets = [] {
  std::array<std::byte, IdBlock::ids> offsets{};
  for (std::size_t i = 0; i < offsets.size(); ++i) offsets[i] = static_cast<std::byte>(i);
  return offsets;
}();

const char* offsets_fault(std::span<const std::byte> offsets) {
  if (offsets.size() == all_offsets.size() && std::equal(offsets.begin(), offsets.end(), all_offsets.begin()))
    return nullptr;
  for (std::size_t i = 0; i < offsets.size(); ++i) {
    if (static_cast<std::size_t>(offsets[i]) >= all_offsets.size()) return "an id is beyond its block";
    if (i > 0 && offsets[i] <= offsets[i - 1]) return "its ids do not ascend";
  }
  return nullptr;
}

}  // namespace

std::vector<std::byte> IdBlock::encode() const {
  std::uint64_t any = 1;
  for (const std::int64_t leaf : leaves_) any |= static_cast<std::uint64_t>(leaf);
  const auto width = static_cast<std::size_t>(std::bit_width(any) + 7) / 8;
  const std::size_t size = 1 + count_ * (1 + width);
  // Each number is written whole, and the next one over its end.
  std::vector<std::byte> bytes(size + sizeof(std::int64_t));
  bytes[0] = static_cast<std::byte>(width);
  std::byte *offset = bytes.data() + 1, *leaves = offset + count_;
  for (std::size_t i = 0; i < leaves_.size(); ++i) {
    if (leaves_[i] == 0) continue;
    *offset++ = static_cast<std::byte>(i);
    std::memcpy(leaves, &leaves_[i], sizeof(std::int64_t));
    leaves += width;
  }
  bytes.resize(size);
  return bytes;
}

const char* IdBlock::decode(std::span<const std::byte> bytes) {
  leaves_ = {};
  count_ = 0;
  const std::size_t width = bytes.empty() ? 0 : static_cast<std::size_t>(bytes[0]);
  if (width < 1 || width > sizeof(std::int64_t)) return "a leaf's number takes 1 to 8 bytes";
  const std::size_t count = (bytes.size() - 1) / (1 + width);
  if (count < 1 || count > leaves_.size() || bytes.size() != 1 + count * (1 + width))
    return "its size fits no number of ids";
  const std::span<const std::byte> offsets = bytes.subspan(1, count);
  if (const char* fault = offsets_fault(offsets)) return fault;
  // Each number is read whole, with the start of the next ones.
  std::array<std::byte, (ids + 1) * sizeof(std::int64_t)> leaves{};
  std::memcpy(leaves.data(), offsets.data() + count, count * width);
  const std::uint64_t digits = ~std::uint64_t{0} >> (64 - 8 * width);
  for (std::size_t i = 0; i < count; ++i) {
    std::uint64_t number;
    std::memcpy(&number, leaves.data() + i * width, sizeof number);
    const auto leaf = static_cast<std::int64_t>(number & digits);
    if (leaf < 1) return "a leaf's number is not positive";
    leaves_[static_cast<std::size_t>(offsets[i])] = leaf;
  }
  count_ = count;
  return nullptr;
}

}  // namespace foresee
