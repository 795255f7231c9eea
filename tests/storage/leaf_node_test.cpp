#include "storage/leaf_node.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <string>

namespace foresee {
namespace {

constexpr double inf = std::numeric_limits<double>::infinity();
constexpr std::int64_t number = 9;

NodeFormat format_of(const Layout& layout) {
  return NodeFormat(layout, NodeFormat::node_size_for(layout, 4096));
}

const Layout everything{.axes = 2, .law = Law::forced, .shape = Shape::box, .has_t = true, .has_until = true};
// t, x, y, vx, vy, fx, fy, m, hx, hy, until
const std::vector<double> fine{5, 1, 2, 0, 0, 3, 4, 2, 1, 1, inf};

std::vector<std::byte> leaf_with(const NodeFormat& format, const std::vector<double>& record) {
  LeafNode leaf(format);
  for (std::int64_t id : {-4, 0, 12}) leaf.put(id, record.data());
  const auto blob = leaf.sealed(number);
  return {blob.begin(), blob.end()};
}

std::string fault_of(const NodeFormat& format, std::vector<std::byte> blob) {
  const char* fault = leaf_fault(format, blob, number);
  return fault ? fault : "";
}

/// The fault of a leaf with a good checksum after `change` was made to its bytes.
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
        EXPECT_GE(format.leaf_capacity, NodeFormat::least_capacity);
        EXPECT_GE(format.inner_capacity, NodeFormat::least_capacity);
        EXPECT_LE(format.records_at + format.leaf_capacity * format.record_size,
                  size - NodeFormat::checksum_size);
        EXPECT_LE(NodeFormat::entries_at + format.inner_capacity * format.inner_entry_size,
                  size - NodeFormat::checksum_size);
        EXPECT_TRUE(size == page - 64 || page < 2048);
      }
}

TEST(LeafNode, KeepsIdsAscendingAndRecordsBesideThem) {
  const NodeFormat format = format_of({.axes = 1});
  LeafNode leaf(format);
  std::map<std::int64_t, double> model;
  std::mt19937 random(3);
  for (int step = 0; step < 5000; ++step) {
    const auto id = static_cast<std::int64_t>(random() % 600) - 300;
    const double x = static_cast<double>(random());
    const int i = leaf.find(id);
    ASSERT_EQ(i >= 0, model.contains(id));
    if (i >= 0 && random() % 2) {
      leaf.remove(i);
      model.erase(id);
    } else if (i >= 0) {
      leaf.replace(i, &x);
      model[id] = x;
    } else if (!leaf.is_full()) {
      leaf.put(id, &x);
      model[id] = x;
    }
    ASSERT_EQ(static_cast<std::size_t>(leaf.count()), model.size());
    int place = 0;
    for (const auto& [expected, value] : model) {
      double record;
      leaf.copy_record(place, &record);
      ASSERT_EQ(leaf.id(place++), expected);
      ASSERT_EQ(record, value);
    }
  }
}

TEST(LeafNode, LeavesNothingOfARemovedObjectBehind) {
  const NodeFormat format = format_of({.axes = 1});
  LeafNode leaf(format), untouched(format);
  const double x = 12345.678;
  leaf.put(77, &x);
  leaf.remove(0);
  const auto blob = leaf.sealed(1), empty = untouched.sealed(1);
  EXPECT_TRUE(std::equal(blob.begin(), blob.end(), empty.begin(), empty.end()));
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
    EXPECT_EQ(fault_of(format, blob), "it has not the size of a node") << size;
  }
}

TEST(LeafNode, HostileHeadersWithAGoodChecksumAreFaults) {
  using Blob = std::vector<std::byte>;
  const auto header = [](std::size_t at, auto value) {
    return fault_after([=](const NodeFormat&, Blob& blob) { store_number(blob.data() + at, value); });
  };
  EXPECT_EQ(header(NodeFormat::level_at, std::uint8_t{1}), "it is no leaf");
  EXPECT_EQ(header(NodeFormat::format_at, std::uint8_t{2}), "its format is unknown");
  EXPECT_EQ(header(NodeFormat::count_at, std::uint16_t{0}), "its count is wrong");
  EXPECT_EQ(header(NodeFormat::count_at, std::uint16_t{65535}), "its count is wrong");
  EXPECT_EQ(header(NodeFormat::parent_at, std::int64_t{-1}), "its parent is no node");
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
  EXPECT_EQ(with(at.until, 4.9), "an object ends before it begins");
  EXPECT_EQ(with(at.until, -inf), "an object ends before it begins");
  EXPECT_EQ(with(at.until, std::nan("")), "an object ends before it begins");
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

}  // namespace
}  // namespace foresee
