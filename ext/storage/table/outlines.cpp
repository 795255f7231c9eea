#include "storage/table/outlines.h"

#include <algorithm>

#include "shape/outline/validity.h"
#include "shape/outline/wkt_reader.h"
#include "storage/format/outline_blob.h"

namespace foresee::storage {
namespace {

// Beyond these memory begins anew: some 100 bytes a corner, with its pieces.
constexpr std::size_t most_corners_known = 1 << 20;
constexpr std::size_t most_texts = 1024, longest_text = 4096;

}  // namespace

void StoredOutlines::remember(std::int64_t number, const std::shared_ptr<const CutOutline>& outline) {
  const std::size_t corners = outline->outline().corners().size();
  if (!known_ || corners_ + corners > most_corners_known) known_ = std::make_shared<ByNumber>(), corners_ = 0;
  (*known_)[number] = outline;
  corners_ += corners;
}

std::shared_ptr<const CutOutline> StoredOutlines::find_known(std::int64_t number) const {
  if (!known_) return nullptr;
  const auto found = known_->find(number);
  return found == known_->end() ? nullptr : found->second;
}

std::shared_ptr<const StoredOutlines::ByNumber> StoredOutlines::known() {
  if (!known_) known_ = std::make_shared<ByNumber>();
  return known_;
}

std::shared_ptr<const CutOutline> StoredOutlines::outline(std::int64_t number) {
  if (auto found = find_known(number)) return found;
  auto read = std::make_shared<const CutOutline>(rows_.read(number));
  remember(number, read);
  return read;
}

StoredOutlines::Known StoredOutlines::find_or_add(std::string_view text) {
  const std::string key(text.substr(0, longest_text + 1));
  if (const auto found = texts_.find(key); found != texts_.end()) return found->second;
  Outline outline = read_outline(text);
  check_outline(outline);
  const std::vector<std::byte> blob = encode_outline(outline);
  Known known{rows_.find(blob).value_or(0), nullptr};
  if (known.number == 0) {
    known.number = std::max(last_number_, rows_.read_largest_number()) + 1;
    rows_.add(known.number, blob);
    last_number_ = known.number;
  }
  known.outline = find_known(known.number);
  if (!known.outline)
    remember(known.number, known.outline = std::make_shared<const CutOutline>(std::move(outline)));
  if (texts_.size() >= most_texts) texts_.clear();
  if (text.size() <= longest_text) texts_.emplace(key, known);
  return known;
}

void StoredOutlines::keep_only(const std::unordered_set<std::int64_t>& numbers) {
  std::vector<std::int64_t> unused;
  rows_.read_numbers([&](std::int64_t number) {
    if (!numbers.contains(number)) unused.push_back(number);
  });
  forget_texts();
  for (const std::int64_t number : unused) {
    last_number_ = std::max(last_number_, number);
    rows_.erase(number);
  }
}

}  // namespace foresee::storage
