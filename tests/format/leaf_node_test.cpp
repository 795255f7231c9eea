#include "format/leaf_node.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>
#include <string>

#include "format/node_cases.h"

namespace foresee {
namespace {

using namespace node_cases;

const Layout everything{.axes = 2, .law = Law::forced, .shape = Shape::box, .has_t = true, .has_until = true};
// t, x, y, vx, vy, fx, fy, m, hx, hy, until
const std::vector<double> fine{5, 1, 2, 0, 0, 3, 4, 2, 1, 1, inf};

std::vector<std::byte> leaf_with(const NodeFormat& format, const std::vector<double>& record) {
  Node leaf{.parent = 5, .keys = {-4, 0, 12}, .values = {}};
  for (std::size_t i = 0; i < leaf.size(); ++i)
    leaf.values.insert(leaf.values.end(), record.begin(), record.end());
  return encode_leaf(format, number, leaf);
}

std::string fault_of(const NodeFormat& format, std::vector<std::byte> blob) {
  const char* fault = leaf_fault(format, blob, number);
  return fault ? fault : "";
}

/// The fault of a leaf whose bytes were changed by `change` and whose checksum is correct.
template <class Change>
std::string fault_after(Change change) {
  const NodeFormat format = format_of(everything);
  std::vector<std::byte> blob = leaf_with(format, fine);
  change(format, blob);
  seal_node(blob, number);
  return fault_of(format, blob);
}

TEST(NodeFormat, FitsThePage) {
  for (std::size_t page = 512; page <= 65536; page *= 2)
    for (int axes = 1; axes <= 3; ++axes)
      for (Law law : {Law::rest, Law::uniform, Law::accelerated, Law::forced}) {
        const Layout layout{.axes = axes, .law = law, .shape = Shape::box, .has_t = true, .has_until = true};
        const std::size_t size = NodeFormat::node_size_for(layout, page);
        const NodeFormat format(layout, size);
        EXPECT_EQ(size % 8, 0u);
        EXPECT_EQ(format.records_at % 8, 0u);
        EXPECT_GE(format.leaf_capacity, NodeFormat::min_capacity);
        EXPECT_GE(format.inner_capacity, NodeFormat::min_capacity);
        EXPECT_LE(format.records_at + format.leaf_capacity * format.record_size,
                  size - NodeFormat::checksum_size);
        EXPECT_LE(NodeFormat::entries_at + format.inner_capacity * format.inner_entry_size,
                  size - NodeFormat::checksum_size);
        EXPECT_TRUE(size == page - 64 || page < 2048);
      }
}

TEST(LeafNode, IsStoredByAscendingIdWhateverItsOrderInMemory) {
  const NodeFormat format = format_of({.axes = 1});
  std::mt19937 random(3);
  Node leaf{.parent = 77, .keys = {}, .values = {}};
  std::map<std::int64_t, double> model;
  while (model.size() < format.leaf_capacity) {
    const auto id = static_cast<std::int64_t>(random() % 6000) - 3000;
    const double x = static_cast<double>(random());
    if (!model.emplace(id, x).second) continue;
    leaf.keys.push_back(id);
    leaf.values.push_back(x);
  }
  const std::vector<std::byte> blob = encode_leaf(format, number, leaf);
  ASSERT_EQ(leaf_fault(format, blob, number), nullptr);
  const LeafView view(format, blob);
  const Node back = decode_leaf(format, blob);
  ASSERT_EQ(static_cast<std::size_t>(view.count()), model.size());
  EXPECT_EQ(back.parent, 77);
  int place = 0;
  for (const auto& [id, x] : model) {
    double record;
    view.copy_record(place, &record);
    EXPECT_EQ(view.id(place), id);
    EXPECT_EQ(view.find(id), place);
    EXPECT_EQ(record, x);
    EXPECT_EQ(back.keys[static_cast<std::size_t>(place)], id);
    EXPECT_EQ(back.values[static_cast<std::size_t>(place++)], x);
  }
  EXPECT_EQ(view.find(5000), -1);
}

TEST(LeafNode, EveryFlippedBitIsAFault) {
  const NodeFormat format = format_of(everything);
  std::vector<std::byte> blob = leaf_with(format, fine);
  EXPECT_EQ(fault_of(format, blob), "");
  for (std::size_t i = 0; i < blob.size(); ++i)
    for (int bit = 0; bit < 8; ++bit) {
      const std::byte before = blob[i];
      blob[i] ^= static_cast<std::byte>(1 << bit);
      ASSERT_EQ(fault_of(format, blob), "its checksum does not match") << i;
      blob[i] = before;
    }
}

TEST(LeafNode, AnotherNodesBytesAreAFault) {
  const NodeFormat format = format_of(everything);
  const std::vector<std::byte> blob = leaf_with(format, fine);
  EXPECT_NE(leaf_fault(format, blob, number + 1), nullptr);
}

TEST(LeafNode, AnotherSizeIsAFault) {
  const NodeFormat format = format_of(everything);
  std::vector<std::byte> blob = leaf_with(format, fine);
  for (std::size_t size : {0, 1, 3, 4, 15, 100, 4031}) {
    blob.resize(size);
    EXPECT_EQ(fault_of(format, blob), "it does not have the size of a node") << size;
  }
}

TEST(LeafNode, HostileHeadersWithAGoodChecksumAreFaults) {
  using Blob = std::vector<std::byte>;
  const auto header = [](std::size_t at, auto value) {
    return fault_after([=](const NodeFormat&, Blob& blob) { store_number(blob.data() + at, value); });
  };
  EXPECT_EQ(header(NodeFormat::level_at, std::uint8_t{1}), "it is not a leaf");
  EXPECT_EQ(header(NodeFormat::format_at, std::uint8_t{1}), "its format is unknown");
  EXPECT_EQ(header(NodeFormat::count_at, std::uint16_t{0}), "its count is wrong");
  EXPECT_EQ(header(NodeFormat::count_at, std::uint16_t{65535}), "its count is wrong");
  EXPECT_EQ(header(NodeFormat::parent_at, std::int64_t{-1}), "its parent is not a node");
  EXPECT_EQ(header(NodeFormat::ids_at, std::int64_t{0}), "its ids do not ascend");
  EXPECT_EQ(header(NodeFormat::ids_at, std::int64_t{5}), "its ids do not ascend");
}

TEST(LeafNode, HostileRecordsWithAGoodChecksumAreFaults) {
  const NodeFormat format = format_of(everything);
  const auto with = [&](int place, double value) {
    std::vector<double> record = fine;
    record[static_cast<std::size_t>(place)] = value;
    const std::string fault = fault_of(format, leaf_with(format, record));
    const char* one = record_fault(format, record.data());
    EXPECT_EQ(fault, one ? one : "");
    return fault;
  };
  for (int place = 0; place < format.at.until; ++place)
    for (double value : {inf, -inf, std::nan("")}) EXPECT_EQ(with(place, value), "a number is not finite");
  const Offsets& at = format.at;
  EXPECT_EQ(with(at.half + 1, -0.5), "a half extent is negative");
  EXPECT_EQ(with(at.mass, 0), "a mass is not positive");
  EXPECT_EQ(with(at.mass, -1), "a mass is not positive");
  EXPECT_EQ(with(at.mass, 1e-307), "");
  EXPECT_EQ(with(at.mass, 1e-308), "an acceleration F/m overflows");
  EXPECT_EQ(with(at.until, 4.9), "an object ends before it starts");
  EXPECT_EQ(with(at.until, -inf), "an object ends before it starts");
  EXPECT_EQ(with(at.until, std::nan("")), "an object ends before it starts");
  EXPECT_EQ(with(at.until, 5), "");
  EXPECT_EQ(with(at.half, -0.0), "");
}

TEST(LeafNode, CylindersHaveNeitherNegativeRadiusNorHeight) {
  const NodeFormat format = format_of({.axes = 3, .shape = Shape::cylinder});
  const double fine[] = {1, 2, 3, 4, 5}, radius[] = {1, 2, 3, -4, 5}, height[] = {1, 2, 3, 4, -5};
  EXPECT_EQ(record_fault(format, fine), nullptr);
  EXPECT_STREQ(record_fault(format, radius), "a radius is negative");
  EXPECT_STREQ(record_fault(format, height), "a half extent is negative");
}

TEST(LeafNode, ACategoryOrMaskThatIsNot32BitsIsAFault) {
  const NodeFormat format = format_of(
      {.axes = 1, .has_until = true, .has_category = true, .has_mask = true});  // x, until, category, mask
  const auto fault_with = [&](double category, double mask) {
    return fault_of(format, leaf_with(format, {1, inf, category, mask}));
  };
  const std::string range = " is not a whole number from 0 to 4294967295";
  EXPECT_EQ(fault_with(0, 4294967295), "");
  EXPECT_EQ(fault_with(4294967295, 0), "");
  for (const double wrong : {-1.0, 0.5, 4294967296.0, std::nan(""), inf, -inf}) {
    EXPECT_EQ(fault_with(wrong, 1), "a category" + range) << wrong;
    EXPECT_EQ(fault_with(1, wrong), "a mask" + range) << wrong;
  }
}

}  // namespace
}  // namespace foresee
