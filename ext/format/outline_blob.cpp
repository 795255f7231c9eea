#include <algorithm>
#include <cmath>

#include "format/form_blob.h"
#include "format/node_format.h"
#include "shape/outline/validity.h"

namespace foresee {
namespace {

/// Counts of a blob, and the offsets that follow from them.
struct Counts {
  std::uint32_t rings, parts, corners;

  std::size_t part_starts_at() const { return form_header_size + std::size_t{4} * rings; }
  std::size_t corners_at() const { return part_starts_at() + std::size_t{4} * parts; }
  std::size_t size() const { return corners_at() + sizeof(Corner) * corners + form_checksum_size; }
};

Counts counts_of(const std::byte* blob) {
  const std::byte* const at = blob + form_counts_at;
  return {load_number<std::uint32_t>(at), load_number<std::uint32_t>(at + 4),
          load_number<std::uint32_t>(at + 8)};
}

/// Reads the rings; returns what is wrong with their structure, or null. Validity is checked later.
const char* read_rings(const std::byte* blob, const Counts& counts, Outline& outline) {
  std::uint32_t corner = 0, part = 0;
  for (std::uint32_t ring = 0; ring < counts.rings; ++ring) {
    const bool starts_part =
        part < counts.parts && load_number<std::uint32_t>(blob + counts.part_starts_at() + 4 * part) == ring;
    if (ring == 0 && !starts_part) return "its first ring does not start a part";
    part += starts_part;
    if (starts_part)
      outline.begin_part();
    else
      outline.begin_hole();
    const auto end = load_number<std::uint32_t>(blob + form_header_size + std::size_t{4} * ring);
    if (end <= corner || end > counts.corners) return "its rings do not follow one another";
    for (; corner < end; ++corner) {
      const auto at = load_number<Corner>(blob + counts.corners_at() + sizeof(Corner) * corner);
      if (!std::isfinite(at.x) || !std::isfinite(at.y)) return "a corner is not finite";
      outline.add(at);
    }
    if (outline.close_ring()) return "a ring ends where it starts";
  }
  return part == counts.parts && corner == counts.corners ? nullptr
                                                          : "it has parts or corners without a ring";
}

}  // namespace

std::vector<std::byte> encode_outline(const Outline& outline) {
  const Counts counts{static_cast<std::uint32_t>(outline.rings()),
                      static_cast<std::uint32_t>(outline.parts()),
                      static_cast<std::uint32_t>(outline.corners().size())};
  std::vector<std::byte> blob = form_blob_of(FormKind::outline, counts.size());
  std::byte* at = blob.data() + form_counts_at;
  for (const std::uint32_t count : {counts.rings, counts.parts, counts.corners}) {
    store_number(at, count);
    at += sizeof count;
  }
  for (std::uint32_t ring = 0; ring < counts.rings; ++ring, at += 4)
    store_number(at, static_cast<std::uint32_t>(outline.ring_start(ring) + outline.ring(ring).size()));
  for (std::uint32_t part = 0; part < counts.parts; ++part, at += 4)
    store_number(at, static_cast<std::uint32_t>(outline.part_start(part)));
  for (const Corner& corner : outline.corners()) {
    store_number(at, corner);
    at += sizeof corner;
  }
  seal_form(blob);
  return blob;
}

namespace {

/// Checks all but that rings are valid and nested correctly.
const char* decode_corners(std::span<const std::byte> blob, Outline& outline) {
  outline = {};
  if (const char* fault = form_frame_fault(blob)) return fault;
  if (form_kind_of(blob) != FormKind::outline) return "its format or kind is not known";
  const Counts counts = counts_of(blob.data());
  if (counts.rings == 0 || counts.corners > max_corners || counts.rings > counts.corners ||
      counts.parts > counts.rings)
    return "its counts are wrong";
  if (blob.size() != counts.size()) return "its size does not fit its counts";
  if (const char* fault = read_rings(blob.data(), counts, outline)) return fault;
  // A blob that would be encoded differently is rejected, not normalized: foresee did not write it.
  return outline.corners().size() != counts.corners ? "a corner is repeated" : nullptr;
}

/// The places of the two blobs in that of a zone.
struct ZoneBlobs {
  std::size_t first, second;
};

ZoneBlobs zone_blobs_of(std::span<const std::byte> blob) {
  const auto first = load_number<std::uint32_t>(blob.data() + form_counts_at);
  const std::size_t both = blob.size() - form_header_size - form_checksum_size;
  return {first, first < both ? both - first : 0};
}

bool is_on_earth(const Outline& degrees) {
  const auto corners = degrees.corners();
  return std::all_of(corners.begin(), corners.end(), [](const Corner& corner) {
    return std::abs(corner.x) <= 180 && std::abs(corner.y) <= 90;
  });
}

}  // namespace

const char* decode_outline(std::span<const std::byte> blob, Outline& outline) {
  if (const char* fault = decode_corners(blob, outline)) return fault;
  return flaw_of(outline) ? "its rings cross, touch or are nested wrongly" : nullptr;
}

std::vector<std::byte> encode_zone(const Outline& degrees, const Outline& plane) {
  const std::vector<std::byte> first = encode_outline(degrees), second = encode_outline(plane);
  std::vector<std::byte> blob =
      form_blob_of(FormKind::zone, form_header_size + first.size() + second.size() + form_checksum_size);
  store_number(blob.data() + form_counts_at, static_cast<std::uint32_t>(first.size()));
  std::copy(first.begin(), first.end(), blob.begin() + form_header_size);
  std::copy(second.begin(), second.end(), blob.begin() + form_header_size + first.size());
  seal_form(blob);
  return blob;
}

const char* decode_zone(std::span<const std::byte> blob, Outline& degrees, Outline& plane) {
  degrees = {};
  plane = {};
  if (const char* fault = form_frame_fault(blob)) return fault;
  if (form_kind_of(blob) != FormKind::zone) return "its format or kind is not known";
  const ZoneBlobs blobs = zone_blobs_of(blob);
  if (blobs.second == 0) return "its size does not fit its counts";
  if (const char* fault = decode_corners(blob.subspan(form_header_size, blobs.first), degrees)) return fault;
  if (!is_on_earth(degrees)) return "a corner is not on the Earth";
  return decode_outline(blob.subspan(form_header_size + blobs.first, blobs.second), plane);
}

}  // namespace foresee
