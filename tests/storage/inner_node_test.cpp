#include "storage/inner_node.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

namespace foresee {
namespace {

constexpr double inf = std::numeric_limits<double>::infinity();
constexpr std::int64_t number = 3;

NodeFormat format_of(const Layout& layout) {
  return NodeFormat(layout, NodeFormat::node_size_for(layout, 4096));
}

// Bounds only where the layout stores them, so that what comes back is what went in.
InnerNode full_node(const NodeFormat& format) {
  InnerNode node{.level = 2, .parent = 17, .epoch = 1.6e9, .entries = {}};
  for (std::size_t i = 0; i < format.inner_capacity; ++i) {
    InnerEntry entry{
        .child = static_cast<std::int64_t>(100 + i), .t_least = -1, .t_greatest = 4, .until_greatest = inf};
    for (std::size_t axis = 0; axis < static_cast<std::size_t>(format.layout.axes); ++axis) {
      const double base = static_cast<double>(i * 10 + axis);
      entry.lower[axis] = base;
      entry.upper[axis] = axis == 0 ? inf : base + 0.5;
      if (format.layout.law >= Law::uniform) entry.v_lower[axis] = -base, entry.v_upper[axis] = base + 1;
      if (format.layout.law >= Law::accelerated) entry.a_lower[axis] = -0.0, entry.a_upper[axis] = 5e-324;
    }
    node.entries.push_back(entry);
  }
  return node;
}

TEST(InnerNode, ComesBackAsItWasForEveryLayout) {
  for (int axes = 1; axes <= 3; ++axes)
    for (Law law : {Law::rest, Law::uniform, Law::accelerated, Law::forced}) {
      const NodeFormat format = format_of({.axes = axes, .law = law});
      const InnerNode node = full_node(format);
      const std::vector<std::byte> blob = encode_inner(format, number, node);
      ASSERT_EQ(blob.size(), format.node_size);
      ASSERT_EQ(inner_fault(format, blob, number), nullptr);
      EXPECT_EQ(decode_inner(format, blob), node);
    }
}

TEST(InnerNode, EveryChangedByteIsAFault) {
  const NodeFormat format = format_of({.axes = 2, .law = Law::accelerated});
  std::vector<std::byte> blob = encode_inner(format, number, full_node(format));
  for (std::byte& byte : blob) {
    byte ^= std::byte{0x40};
    ASSERT_NE(inner_fault(format, blob, number), nullptr);
    byte ^= std::byte{0x40};
  }
}

TEST(InnerNode, HostileContentsWithAGoodChecksumAreFaults) {
  const NodeFormat format = format_of({.axes = 2, .law = Law::accelerated});
  const auto fault_after = [&](auto change) -> std::string {
    InnerNode node = full_node(format);
    change(node);
    const char* fault = inner_fault(format, encode_inner(format, number, node), number);
    return fault ? fault : "";
  };
  EXPECT_EQ(fault_after([](InnerNode&) {}), "");
  EXPECT_EQ(fault_after([](InnerNode& n) { n.level = 0; }), "it is no inner node");
  EXPECT_EQ(fault_after([](InnerNode& n) { n.entries.clear(); }), "its count is wrong");
  EXPECT_EQ(fault_after([](InnerNode& n) { n.parent = -1; }), "its parent is no node");
  EXPECT_EQ(fault_after([](InnerNode& n) { n.epoch = std::nan(""); }), "its epoch is not finite");
  EXPECT_EQ(fault_after([](InnerNode& n) { n.entries[1].child = 0; }), "a child is no other node");
  EXPECT_EQ(fault_after([](InnerNode& n) { n.entries[1].child = number; }), "a child is no other node");
  EXPECT_EQ(fault_after([](InnerNode& n) { n.entries[1].t_least = 5; }), "reference times are out of order");
  EXPECT_EQ(fault_after([](InnerNode& n) { n.entries[1].t_greatest = inf; }),
            "reference times are out of order");
  EXPECT_EQ(fault_after([](InnerNode& n) { n.entries[1].until_greatest = -2; }),
            "a child ends before it begins");
  EXPECT_EQ(fault_after([](InnerNode& n) { n.entries[0].lower[1] = 1e9; }), "bounds are out of order");
  EXPECT_EQ(fault_after([](InnerNode& n) { n.entries[0].v_upper[0] = std::nan(""); }),
            "bounds are out of order");
  EXPECT_EQ(fault_after([](InnerNode& n) { n.entries[0].a_lower[0] = 1; }), "bounds are out of order");
}

TEST(InnerNode, ACountBeyondTheCapacityIsAFault) {
  const NodeFormat format = format_of({.axes = 3});
  std::vector<std::byte> blob = encode_inner(format, number, full_node(format));
  store_number(blob.data() + NodeFormat::count_at, static_cast<std::uint16_t>(format.inner_capacity + 1));
  seal_node(blob, number);
  EXPECT_STREQ(inner_fault(format, blob, number), "its count is wrong");
}

}  // namespace
}  // namespace foresee
