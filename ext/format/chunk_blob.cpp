#include "format/chunk_blob.h"

#include <algorithm>
#include <bit>

#include "format/node_format.h"
#include "motion/plan/plan_legs.h"

namespace foresee {
namespace {

constexpr std::uint8_t chunk_format = 1;
constexpr std::uint8_t is_first_flag = 1, has_untils_flag = 2;
constexpr std::size_t kind_at = 1, flags_at = 2, axes_at = 3, legs_at = 4, ends_at = 6, object_at = 8,
                      header_size = 16, counts_size = 8, checksum_bytes = NodeFormat::checksum_size;
constexpr std::size_t number_bytes = sizeof(double);
static_assert(legs_per_chunk <= 16, "`ends` has a bit per leg");

/// The numbers of all legs, with what follows them.
std::size_t chunk_numbers(const StoredChunk& chunk) {
  if (chunk.kind != PlanKind::knots) {
    const std::size_t vectors = chunk.kind == PlanKind::uniform ? 2 : 3;
    return chunk.legs * (1 + chunk.has_untils + vectors * chunk.axes) + !chunk.has_untils;
  }
  // The last leg has its knot whether or not it ends a part.
  const auto before_last = static_cast<std::uint16_t>(chunk.ends & ~(1u << (chunk.legs - 1)));
  return (chunk.legs + 1 + static_cast<std::size_t>(std::popcount(before_last))) * (1 + chunk.axes);
}

bool same_bits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

}  // namespace

// --- writing

ChunkWriter::ChunkWriter(const Plan& plan, std::int64_t object)
    : plan_(plan), object_(object), legs_(legs_of(plan)), ranges_(cut_into_chunks(legs_)) {}

/// Of a plan of knots. Each part has one knot more than legs.
std::size_t ChunkWriter::part_of(std::size_t leg) const {
  std::size_t low = 0, high = plan_.parts();
  while (high - low > 1) {
    const std::size_t middle = low + (high - low) / 2;
    (plan_.part_starts[middle] - middle <= leg ? low : high) = middle;
  }
  return low;
}

StoredChunk ChunkWriter::header(std::size_t chunk) const {
  const auto [first, count] = ranges_[chunk];
  StoredChunk header{
      .kind = plan_.kind, .is_first = chunk == 0, .axes = static_cast<std::size_t>(plan_.axes)};
  header.legs = count;
  header.object = object_;
  if (plan_.kind == PlanKind::knots) {
    std::size_t part = part_of(first);
    for (std::size_t i = 0; i < count; ++i)
      if (first + i + part + 2 == plan_.part_end(part))
        header.ends = static_cast<std::uint16_t>(header.ends | 1u << i), ++part;
  } else {
    for (std::size_t i = 1; i < count; ++i)
      header.has_untils |= !same_bits(legs_[first + i - 1].until, legs_[first + i].t);
  }
  return header;
}

std::vector<std::byte> ChunkWriter::blob(std::size_t chunk, std::int64_t number) const {
  const StoredChunk header = this->header(chunk);
  const std::size_t before_legs = header_size + (chunk == 0 ? counts_size + number_bytes * chunks() : 0);
  std::vector<std::byte> blob(before_legs + number_bytes * chunk_numbers(header) + checksum_bytes);
  const int flags = header.is_first * is_first_flag + header.has_untils * has_untils_flag;
  store_number(blob.data(), chunk_format);
  store_number(blob.data() + kind_at, plan_.kind);
  store_number(blob.data() + flags_at, static_cast<std::uint8_t>(flags));
  store_number(blob.data() + axes_at, static_cast<std::uint8_t>(plan_.axes));
  store_number(blob.data() + legs_at, static_cast<std::uint16_t>(header.legs));
  store_number(blob.data() + ends_at, header.ends);
  store_number(blob.data() + object_at, object_);
  std::byte* at = blob.data() + header_size;
  const auto put = [&](auto value) {
    store_number(at, value);
    at += sizeof value;
  };
  if (chunk == 0) {
    put(static_cast<std::uint32_t>(chunks()));
    put(static_cast<std::uint32_t>(legs_.size()));
    for (const ChunkRange& range : ranges_) put(legs_[range.first].t);
  }
  put_legs(header, ranges_[chunk].first, at);
  seal_node(blob, number);
  return blob;
}

void ChunkWriter::put_legs(const StoredChunk& header, std::size_t first, std::byte* at) const {
  const auto put = [&](double number) {
    store_number(at, number);
    at += sizeof number;
  };
  const auto put_vector = [&](const std::array<double, 3>& vector) {
    std::for_each_n(vector.begin(), header.axes, put);
  };
  const auto put_knot = [&](const Knot& knot) {
    put(knot.t);
    put_vector(knot.x);
  };
  if (plan_.kind == PlanKind::knots) {
    std::size_t knot = first + part_of(first);
    for (std::size_t i = 0; i < header.legs; ++i, ++knot) {
      const bool ends_part = (header.ends >> i & 1) != 0;
      put_knot(plan_.knots[knot]);
      if (ends_part || i + 1 == header.legs) put_knot(plan_.knots[knot + 1]);
      knot += ends_part;
    }
    return;
  }
  for (const Leg& leg : std::span(legs_).subspan(first, header.legs)) {
    put(leg.t);
    if (header.has_untils) put(leg.until);
    put_vector(leg.x);
    put_vector(leg.v);
    if (plan_.kind == PlanKind::accelerated) put_vector(leg.a);
  }
  if (!header.has_untils) put(legs_[first + header.legs - 1].until);
}

std::vector<std::byte> chunk_of_object(std::span<const std::byte> blob, std::int64_t number,
                                       std::int64_t object) {
  std::vector<std::byte> changed(blob.begin(), blob.end());
  store_number(changed.data() + object_at, object);
  seal_node(changed, number);
  return changed;
}

// --- reading

double StoredChunk::start(std::size_t chunk) const {
  return load_number<double>(starts + number_bytes * chunk);
}

double StoredChunk::t() const {
  return load_number<double>(numbers);
}

const char* open_chunk(const Layout& layout, std::span<const std::byte> blob, std::int64_t number,
                       StoredChunk& chunk) {
  if (blob.size() < header_size + checksum_bytes) return "it is too short";
  const std::byte* const at = blob.data();
  if (load_number<std::uint32_t>(at + blob.size() - checksum_bytes) != node_checksum(blob, number))
    return "its checksum does not match";
  const auto kind = load_number<std::uint8_t>(at + kind_at), flags = load_number<std::uint8_t>(at + flags_at);
  const auto last_kind = layout.law == Law::accelerated ? PlanKind::accelerated : PlanKind::uniform;
  if (load_number<std::uint8_t>(at) != chunk_format || kind > static_cast<std::uint8_t>(last_kind) ||
      flags > (is_first_flag | has_untils_flag))
    return "its format or kind is not known";
  chunk = {.kind = static_cast<PlanKind>(kind),
           .is_first = (flags & is_first_flag) != 0,
           .has_untils = (flags & has_untils_flag) != 0,
           .axes = load_number<std::uint8_t>(at + axes_at),
           .legs = load_number<std::uint16_t>(at + legs_at),
           .ends = load_number<std::uint16_t>(at + ends_at),
           .object = load_number<std::int64_t>(at + object_at)};
  if (chunk.axes != static_cast<std::size_t>(layout.axes)) return "it has another number of axes";
  if (chunk.legs < 1 || chunk.legs > legs_per_chunk) return "its number of legs is out of range";
  const bool knots = chunk.kind == PlanKind::knots;
  if (knots ? chunk.has_untils || chunk.ends >> chunk.legs != 0 : chunk.ends != 0)
    return "its flags do not fit its kind";
  std::size_t size = header_size;
  if (chunk.is_first) {
    if (blob.size() < size + counts_size + checksum_bytes) return "it is too short";
    chunk.plan_chunks = load_number<std::uint32_t>(at + size);
    chunk.plan_legs = load_number<std::uint32_t>(at + size + 4);
    if (chunk.plan_legs > max_plan_legs || chunk.plan_chunks < 1 || chunk.plan_chunks > chunk.plan_legs ||
        chunk.legs > chunk.plan_legs)
      return "its counts are out of range";
    chunk.starts = at + size + counts_size;
    size += counts_size + number_bytes * chunk.plan_chunks;
  }
  if (blob.size() != size + number_bytes * chunk_numbers(chunk) + checksum_bytes)
    return "its size does not fit its counts";
  chunk.numbers = at + size;
  return chunk.is_first && !same_bits(chunk.start(0), chunk.t()) ? "its starts are not those of its legs"
                                                                 : nullptr;
}

}  // namespace foresee
