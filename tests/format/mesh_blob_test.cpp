// Stored mesh: round trip through its bytes, and faults of other bytes.
#include <gtest/gtest.h>

#include <cstring>

#include "format/crc32c.h"
#include "format/form_blob.h"
#include "shape/mesh/mesh_text.h"

namespace foresee {
namespace {

/// Four corners, four triangles.
constexpr const char* tetrahedron =
    "POLYHEDRALSURFACE Z(((0 0 0, 0 1 0, 1 0 0, 0 0 0)), ((0 0 0, 1 0 0, 0 0 1, 0 0 0)), ((0 0 0, 0 0 1, 0 1 "
    "0, 0 0 0)), ((1 0 0, 0 1 0, 0 0 1, 1 0 0)))";

std::vector<std::byte> mesh_bytes(const std::string& text = tetrahedron) {
  return encode_mesh(read_mesh(text));
}

/// The fault of a blob with a correct checksum.
std::string mesh_fault(std::vector<std::byte> bytes) {
  const std::uint32_t checksum = crc32c(bytes.data(), bytes.size() - 4);
  std::memcpy(bytes.data() + bytes.size() - 4, &checksum, 4);
  Mesh mesh;
  const char* fault = decode_mesh(bytes, mesh);
  return fault ? fault : "";
}

template <class T>
std::vector<std::byte> changed(std::vector<std::byte> bytes, std::size_t at, T value) {
  std::memcpy(bytes.data() + at, &value, sizeof value);
  return bytes;
}

TEST(MeshBlob, RoundTrips) {
  for (const char* word : {"TIN Z", "POLYHEDRALSURFACE Z", "MULTIPOLYGON Z"}) {
    const std::string text = word + std::string(tetrahedron).substr(19);
    Mesh mesh;
    EXPECT_EQ(decode_mesh(mesh_bytes(text), mesh), nullptr);
    EXPECT_EQ(mesh, read_mesh(text));
  }
  EXPECT_EQ(mesh_bytes().size(), 16 + 12 * 4 + 24 * 4 + 4u);
}

TEST(MeshBlob, EveryChangedByteIsDetected) {
  for (std::size_t i = 0; i < mesh_bytes().size(); ++i) {
    std::vector<std::byte> bytes = mesh_bytes();
    bytes[i] ^= std::byte{0x10};
    Mesh mesh;
    EXPECT_STREQ(decode_mesh(bytes, mesh), "its checksum is wrong") << i;
  }
}

// Bytes of an attacker, with correct checksums.
TEST(MeshBlob, HostileBytesAreFaults) {
  constexpr std::size_t triangles = 16, corners = triangles + 12 * 4;
  const auto bytes = mesh_bytes();
  Mesh mesh;
  EXPECT_STREQ(decode_mesh({}, mesh), "it is too short");
  for (const std::size_t at : {0, 1}) {
    EXPECT_EQ(mesh_fault(changed(bytes, at, std::uint8_t{9})), "its format or kind is not known");
    EXPECT_EQ(mesh_fault(changed(bytes, at, std::uint8_t{0})), "its format or kind is not known");
  }
  EXPECT_EQ(mesh_fault(changed(bytes, 1, std::uint8_t{1})), "its format or kind is not known");
  for (const std::size_t at : {2, 3, 12, 15})
    EXPECT_EQ(mesh_fault(changed(bytes, at, std::uint8_t{1})), "its corners are not those of its triangles");
  for (const std::uint32_t count : {0u, 3u, 5u, 0x40000001u, 0xffffffffu})
    for (const std::size_t at : {4, 8}) EXPECT_NE(mesh_fault(changed(bytes, at, count)), "") << count;
  EXPECT_EQ(mesh_fault(changed(bytes, triangles, 4u)), "a triangle has a corner that does not exist");
  EXPECT_EQ(mesh_fault(changed(bytes, triangles, 0xffffffffu)),
            "a triangle has a corner that does not exist");
  EXPECT_EQ(mesh_fault(changed(bytes, corners, std::numeric_limits<double>::quiet_NaN())),
            "a corner is not finite");
  EXPECT_EQ(mesh_fault(changed(bytes, corners, -0.0)), "its corners are not those of its triangles");
  // Corner 1 at the place of corner 0, and numbers in another order than triangles name them.
  EXPECT_EQ(mesh_fault(changed(bytes, corners + 24 + 8, 0.0)), "its corners are not those of its triangles");
  EXPECT_EQ(mesh_fault(changed(changed(bytes, triangles, 1u), triangles + 4, 0u)),
            "its corners are not those of its triangles");
  // A solid that is not closed, and a triangle without area.
  EXPECT_EQ(mesh_fault(changed(bytes, triangles + 36, 0u)),
            "a triangle has no area, or its surface is not closed");
  EXPECT_EQ(
      mesh_fault(changed(mesh_bytes("TIN Z(((0 0 0, 1 0 0, 2 1 0, 0 0 0)))"), 16 + 12 + 2 * 24 + 8, 0.0)),
      "a triangle has no area, or its surface is not closed");
}

TEST(FormBlob, IsOfTheShapeThatTheTableHas) {
  const auto mesh = encode_form(*read_form(Shape::mesh, tetrahedron));
  const auto outline = encode_form(*read_form(Shape::outline, "POLYGON((0 0, 4 0, 0 3, 0 0))"));
  EXPECT_EQ(mesh, mesh_bytes());
  std::shared_ptr<const Form> form;
  EXPECT_EQ(decode_form(mesh, Shape::mesh, form), nullptr);
  EXPECT_EQ(form->text(), tetrahedron);
  EXPECT_EQ(decode_form(outline, Shape::outline, form), nullptr);
  EXPECT_EQ(form->text(), "POLYGON((0 0, 4 0, 0 3, 0 0))");
  EXPECT_STREQ(decode_form(mesh, Shape::outline, form), "its format or kind is not known");
  EXPECT_STREQ(decode_form(outline, Shape::mesh, form), "its format or kind is not known");
  EXPECT_EQ(form, nullptr);
}

}  // namespace
}  // namespace foresee
