#include "format/id_block.h"

#include <bit>
#include <cstring>

namespace foresee {

std::vector<std::byte> IdBlock::encode() const {
  std::uint64_t any = 1;
  for (const std::int64_t leaf : leaves_) any |= static_cast<std::uint64_t>(leaf);
  const auto width = static_cast<std::size_t>(std::bit_width(any) + 7) / 8;
  std::vector<std::byte> bytes(1 + count_ * (1 + width));
  bytes[0] = static_cast<std::byte>(width);
  std::byte *offset = bytes.data() + 1, *leaves = offset + count_;
  for (std::size_t i = 0; i < leaves_.size(); ++i) {
    if (leaves_[i] == 0) continue;
    *offset++ = static_cast<std::byte>(i);
    std::memcpy(leaves, &leaves_[i], width);
    leaves += width;
  }
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
  const std::byte* leaves = bytes.data() + 1 + count;
  for (std::size_t i = 0; i < count; ++i, leaves += width) {
    const auto offset = static_cast<std::size_t>(bytes[1 + i]);
    if (offset >= leaves_.size()) return "an id is beyond its block";
    if (i > 0 && bytes[1 + i] <= bytes[i]) return "its ids do not ascend";
    std::int64_t leaf = 0;
    std::memcpy(&leaf, leaves, width);
    if (leaf < 1) return "a leaf's number is not positive";
    leaves_[offset] = leaf;
  }
  count_ = count;
  return nullptr;
}

}  // namespace foresee
