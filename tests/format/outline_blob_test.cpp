// Stored outline: round trip through its bytes, and faults of other bytes.
#include <gtest/gtest.h>

#include <cstring>

#include "format/crc32c.h"
#include "format/form_blob.h"
#include "shape/outline/wkt.h"

namespace foresee {
namespace {

constexpr const char* harbour =
    "MULTIPOLYGON(((0 0, 9 0, 9 9, 0 9, 0 0), (1 1, 2 1, 2 2, 1 2, 1 1)), ((20 0, 29.5 -1e-300, 25 7, 20 "
    "0)))";

std::vector<std::byte> blob() {
  return encode_outline(read_outline(harbour));
}

/// The fault of a blob with a correct checksum.
std::string fault_of(std::vector<std::byte> bytes) {
  const std::uint32_t checksum = crc32c(bytes.data(), bytes.size() - 4);
  std::memcpy(bytes.data() + bytes.size() - 4, &checksum, 4);
  Outline outline;
  const char* fault = decode_outline(bytes, outline);
  return fault ? fault : "";
}

template <class T>
std::vector<std::byte> with(std::vector<std::byte> bytes, std::size_t at, T value) {
  std::memcpy(bytes.data() + at, &value, sizeof value);
  return bytes;
}

TEST(OutlineBlob, RoundTrips) {
  Outline outline;
  EXPECT_EQ(decode_outline(blob(), outline), nullptr);
  EXPECT_EQ(outline, read_outline(harbour));
  EXPECT_EQ(blob().size(), 16 + 4 * 3 + 4 * 2 + 16 * 11 + 4u);
  EXPECT_EQ(fault_of(blob()), "");
}

TEST(OutlineBlob, EveryChangedByteIsDetected) {
  for (std::size_t i = 0; i < blob().size(); ++i) {
    std::vector<std::byte> bytes = blob();
    bytes[i] ^= std::byte{0x10};
    Outline outline;
    EXPECT_STREQ(decode_outline(bytes, outline), "its checksum is wrong") << i;
  }
}

// Bytes of an attacker, with correct checksums.
TEST(OutlineBlob, HostileBytesAreFaults) {
  constexpr std::size_t ends = 16, part_starts = ends + 12, corners = part_starts + 8;
  Outline outline;
  EXPECT_STREQ(decode_outline({}, outline), "it is too short");
  EXPECT_EQ(fault_of(with(blob(), 0, std::uint8_t{9})), "its format or kind is not known");
  EXPECT_EQ(fault_of(with(blob(), 1, std::uint8_t{9})), "its format or kind is not known");
  for (const std::uint32_t count : {0u, 2u, 4u, 0x40000001u, 0xffffffffu})
    for (const std::size_t at : {4, 8, 12}) {
      const std::vector<std::byte> bytes = with(blob(), at, count);
      EXPECT_TRUE(bytes == blob() || !fault_of(bytes).empty()) << count << " at " << at;
    }
  EXPECT_EQ(fault_of(std::vector<std::byte>(
                with(with(std::vector<std::byte>(20), 0, std::uint8_t{1}), 1, std::uint8_t{1}))),
            "its counts are wrong");
  EXPECT_EQ(fault_of(with(blob(), ends, 0u)), "its rings do not follow one another");
  EXPECT_EQ(fault_of(with(blob(), ends + 8, 99u)), "its rings do not follow one another");
  EXPECT_EQ(fault_of(with(blob(), part_starts, 1u)), "its first ring does not start a part");
  EXPECT_EQ(fault_of(with(blob(), part_starts + 4, 7u)), "it has parts or corners without a ring");
  EXPECT_EQ(fault_of(with(blob(), corners, std::numeric_limits<double>::quiet_NaN())),
            "a corner is not finite");
  EXPECT_EQ(fault_of(with(with(blob(), corners + 16, 0.0), corners + 24, 0.0)), "a corner is repeated");
  EXPECT_EQ(fault_of(with(with(blob(), corners + 48, 0.0), corners + 56, 0.0)),
            "a ring ends where it starts");
  EXPECT_EQ(fault_of(with(blob(), corners + 16, -5.0)), "its rings cross, touch or are nested wrongly");
}

// Zones: two blobs in one.

std::vector<std::byte> zone_blob() {
  return encode_zone(read_outline("POLYGON((7 53, 8 53, 8 54, 7 53))"), read_outline(harbour));
}

std::string zone_fault_of(std::vector<std::byte> bytes) {
  const std::uint32_t checksum = crc32c(bytes.data(), bytes.size() - 4);
  std::memcpy(bytes.data() + bytes.size() - 4, &checksum, 4);
  Outline degrees, plane;
  const char* fault = decode_zone(bytes, degrees, plane);
  return fault ? fault : "";
}

TEST(ZoneBlob, RoundTrips) {
  Outline degrees, plane;
  EXPECT_EQ(decode_zone(zone_blob(), degrees, plane), nullptr);
  EXPECT_EQ(degrees, read_outline("POLYGON((7 53, 8 53, 8 54, 7 53))"));
  EXPECT_EQ(plane, read_outline(harbour));
  std::shared_ptr<const Form> form;
  EXPECT_EQ(decode_form(zone_blob(), Shape::outline, form), nullptr);
  EXPECT_EQ(form->text(), "POLYGON((7 53, 8 53, 8 54, 7 53))");
  EXPECT_EQ(form->extents(0).upper[0], 29.5);
  EXPECT_EQ(encode_form(*form), zone_blob());
  EXPECT_STREQ(decode_form(zone_blob(), Shape::mesh, form), "its format or kind is not known");
}

/// A corner may lie outside its ring in degrees: a zone that crosses the date line does.
TEST(ZoneBlob, KeepsDegreesThatCrossOnAFlatMap) {
  Outline degrees, plane;
  const Outline crossing = read_outline("POLYGON((179 0, -179 1, -179 0, 179 1, 179 0))");
  EXPECT_EQ(decode_zone(encode_zone(crossing, read_outline(harbour)), degrees, plane), nullptr);
  EXPECT_EQ(degrees, crossing);
}

TEST(ZoneBlob, HostileBytesAreFaults) {
  for (std::size_t i = 0; i < zone_blob().size(); ++i) {
    std::vector<std::byte> bytes = zone_blob();
    bytes[i] ^= std::byte{0x10};
    Outline degrees, plane;
    EXPECT_STREQ(decode_zone(bytes, degrees, plane), "its checksum is wrong") << i;
  }
  for (const std::uint32_t size : {0u, 1u, 20u, 75u, 0x7fffffffu, 0xffffffffu})
    EXPECT_NE(zone_fault_of(with(zone_blob(), 4, size)), "") << size;
  std::vector<std::byte> beyond =
      encode_zone(read_outline("POLYGON((7 53, 8 53, 8 94, 7 53))"), read_outline(harbour));
  EXPECT_EQ(zone_fault_of(beyond), "a corner is not on the Earth");
  EXPECT_EQ(zone_fault_of(blob()), "its format or kind is not known");
  EXPECT_EQ(fault_of(zone_blob()), "its format or kind is not known");
}

}  // namespace
}  // namespace foresee
