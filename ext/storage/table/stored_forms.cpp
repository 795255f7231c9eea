#include "storage/table/stored_forms.h"

#include <algorithm>

#include "format/form_blob.h"

namespace foresee {
namespace {

// Beyond these limits a cache is emptied. A form takes about 100 bytes per corner, with its convex pieces.
constexpr std::size_t max_corners_known = 1 << 20;
constexpr std::size_t max_text_bytes = 1 << 22, max_text_length = max_text_bytes / 4;

}  // namespace

void StoredForms::remember(std::int64_t number, const std::shared_ptr<const Form>& form) {
  const std::size_t corners = form->corners();
  if (!known_ || corners_ + corners > max_corners_known) {
    known_ = std::make_shared<ByNumber>();
    corners_ = 0;
  }
  (*known_)[number] = form;
  corners_ += corners;
}

std::shared_ptr<const Form> StoredForms::find_known(std::int64_t number) const {
  if (!known_) return nullptr;
  const auto found = known_->find(number);
  return found == known_->end() ? nullptr : found->second;
}

std::shared_ptr<const StoredForms::ByNumber> StoredForms::known() {
  if (!known_) known_ = std::make_shared<ByNumber>();
  return known_;
}

std::shared_ptr<const Form> StoredForms::form(std::int64_t number) {
  if (auto found = find_known(number)) return found;
  auto read = rows_.read(number);
  remember(number, read);
  return read;
}

StoredForms::Known StoredForms::find_or_add(std::string_view text, const Reader& read) {
  const bool short_enough = text.size() <= max_text_length;
  const std::string key(short_enough ? text : std::string_view());
  if (const auto found = texts_.find(key); short_enough && found != texts_.end()) return found->second;
  auto form = read ? read(text) : read_form(shape_, text);
  const std::vector<std::byte> blob = encode_form(*form);
  Known known{rows_.find(blob).value_or(0), nullptr};
  if (known.number == 0) {
    join();
    known.number = std::max(last_number_, rows_.read_largest_number()) + 1;
    rows_.add(known.number, blob);
    last_number_ = known.number;
  }
  known.form = find_known(known.number);
  if (!known.form) remember(known.number, known.form = std::move(form));
  if (!short_enough) return known;
  if (text_bytes_ + text.size() > max_text_bytes) forget_texts();
  texts_.emplace(key, known);
  text_bytes_ += text.size();
  return known;
}

void StoredForms::keep_only(const std::unordered_set<std::int64_t>& numbers) {
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

}  // namespace foresee
