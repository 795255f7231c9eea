#include "storage/format/outline_blob.h"

#include <cmath>

#include "shape/outline/validity.h"
#include "storage/format/crc32c.h"
#include "storage/format/node_format.h"

namespace foresee::storage {
namespace {

constexpr std::uint8_t format = 1, flat = 1;
constexpr std::size_t counts_at = 4, header_size = 16, checksum_size = 4;

/// How many of each a blob has, and so where everything stands.
struct Counts {
  std::uint32_t rings, parts, corners;

  std::size_t part_begins_at() const { return header_size + std::size_t{4} * rings; }
  std::size_t corners_at() const { return part_begins_at() + std::size_t{4} * parts; }
  std::size_t size() const { return corners_at() + sizeof(Corner) * corners + checksum_size; }
};

Counts counts_of(const std::byte* blob) {
  return {load_number<std::uint32_t>(blob + counts_at), load_number<std::uint32_t>(blob + counts_at + 4),
          load_number<std::uint32_t>(blob + counts_at + 8)};
}

/// Rings as the blob has them, as far as they are rings at all.
const char* read_rings(const std::byte* blob, const Counts& counts, Outline& outline) {
  std::uint32_t corner = 0, part = 0;
  for (std::uint32_t ring = 0; ring < counts.rings; ++ring) {
    const bool begins_part =
        part < counts.parts && load_number<std::uint32_t>(blob + counts.part_begins_at() + 4 * part) == ring;
    if (ring == 0 && !begins_part) return "its first ring begins no part";
    part += begins_part;
    begins_part ? outline.begin_part() : outline.begin_hole();
    const auto end = load_number<std::uint32_t>(blob + header_size + std::size_t{4} * ring);
    if (end <= corner || end > counts.corners) return "its rings do not follow one another";
    for (; corner < end; ++corner) {
      const auto at = load_number<Corner>(blob + counts.corners_at() + sizeof(Corner) * corner);
      if (!std::isfinite(at.x) || !std::isfinite(at.y)) return "a corner is not finite";
      outline.add(at);
    }
    if (outline.close_ring()) return "a ring ends where it begins";
  }
  return part == counts.parts && corner == counts.corners ? nullptr : "its rings are not all of it";
}

}  // namespace

std::vector<std::byte> encode_outline(const Outline& outline) {
  const Counts counts{static_cast<std::uint32_t>(outline.rings()),
                      static_cast<std::uint32_t>(outline.parts()),
                      static_cast<std::uint32_t>(outline.corners().size())};
  std::vector<std::byte> blob(counts.size());
  store_number(blob.data(), format);
  store_number(blob.data() + 1, flat);
  store_number(blob.data() + counts_at, counts.rings);
  store_number(blob.data() + counts_at + 4, counts.parts);
  store_number(blob.data() + counts_at + 8, counts.corners);
  std::byte* at = blob.data() + header_size;
  for (std::uint32_t ring = 0; ring < counts.rings; ++ring, at += 4)
    store_number(at, static_cast<std::uint32_t>(outline.ring_begin(ring) + outline.ring(ring).size()));
  for (std::uint32_t part = 0; part < counts.parts; ++part, at += 4)
    store_number(at, static_cast<std::uint32_t>(outline.part_begin(part)));
  for (const Corner& corner : outline.corners()) {
    store_number(at, corner);
    at += sizeof corner;
  }
  store_number(at, crc32c(blob.data(), blob.size() - checksum_size));
  return blob;
}

std::uint32_t checksum_of_outline(std::span<const std::byte> blob) {
  return load_number<std::uint32_t>(blob.data() + blob.size() - checksum_size);
}

const char* decode_outline(std::span<const std::byte> blob, Outline& outline) {
  outline = {};
  if (blob.size() < header_size + checksum_size) return "it is too short";
  if (checksum_of_outline(blob) != crc32c(blob.data(), blob.size() - checksum_size))
    return "its checksum is wrong";
  if (load_number<std::uint8_t>(blob.data()) != format || load_number<std::uint8_t>(blob.data() + 1) != flat)
    return "its format or kind is not known";
  const Counts counts = counts_of(blob.data());
  if (counts.corners > most_corners || counts.rings > counts.corners || counts.parts > counts.rings)
    return "its counts are wrong";
  if (blob.size() != counts.size()) return "its size does not fit its counts";
  if (const char* fault = read_rings(blob.data(), counts, outline)) return fault;
  // Nothing is normalised on the way in: what would be read back otherwise is not what was written.
  if (outline.corners().size() != counts.corners) return "a corner comes twice";
  return flaw_of(outline) ? "its rings cross, touch or lie wrongly" : nullptr;
}

}  // namespace foresee::storage
