#include "format/inner_node.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "format/node_cases.h"

namespace foresee {
namespace {

using namespace node_cases;

/// The doubles of an entry that are bounds, in the order of index/pages.h.
std::size_t place(const NodeFormat& format, std::size_t entry, std::size_t bound, std::size_t axis) {
  const auto axes = static_cast<std::size_t>(format.layout.axes);
  return entry * static_cast<std::size_t>(entry_size(format.layout.axes)) + 3 + bound * axes + axis;
}
enum Bound : std::size_t { lower, upper, v_lower, v_upper, a_lower, a_upper };

// Sets only the bounds that the layout stores, so that a round trip is exact.
Node full_node(const NodeFormat& format) {
  Node node{.level = 2, .parent = 17, .epoch = 1.6e9, .keys = {}, .values = {}};
  const auto stride = static_cast<std::size_t>(entry_size(format.layout.axes));
  for (std::size_t i = 0; i < format.inner_capacity; ++i) {
    node.keys.push_back(static_cast<std::int64_t>(100 + i));
    node.values.resize(node.values.size() + stride);
    node.values[i * stride] = -1;
    node.values[i * stride + 1] = 4;
    node.values[i * stride + 2] = inf;
    for (std::size_t axis = 0; axis < static_cast<std::size_t>(format.layout.axes); ++axis) {
      const auto at = [&](Bound bound) -> double& { return node.values[place(format, i, bound, axis)]; };
      const double base = static_cast<double>(i * 10 + axis);
      at(lower) = base;
      at(upper) = axis == 0 ? inf : base + 0.5;
      at(v_lower) = -rest_velocity_pad;
      at(v_upper) = rest_velocity_pad;
      if (format.layout.law >= Law::uniform) {
        at(v_lower) = -base;
        at(v_upper) = base + 1;
      }
      if (format.layout.law >= Law::accelerated) {
        at(a_lower) = -0.0;
        at(a_upper) = 5e-324;
      }
    }
  }
  return node;
}

TEST(InnerNode, RoundTripsForEveryLayout) {
  for (int axes = 1; axes <= 3; ++axes)
    for (Law law : {Law::rest, Law::uniform, Law::accelerated, Law::forced}) {
      const NodeFormat format = format_of({.axes = axes, .law = law});
      const Node node = full_node(format);
      const std::vector<std::byte> blob = encode_inner(format, number, node);
      ASSERT_EQ(blob.size(), format.node_size);
      ASSERT_EQ(inner_fault(format, blob, number), nullptr);
      EXPECT_TRUE(is_inner(format, blob, number));
      const Node back = decode_inner(format, blob);
      EXPECT_EQ(back.level, node.level);
      EXPECT_EQ(back.parent, node.parent);
      EXPECT_EQ(back.epoch, node.epoch);
      EXPECT_EQ(back.keys, node.keys);
      EXPECT_EQ(back.values, node.values);
    }
}

TEST(InnerNode, KindsRoundTripAndTakeEightBytesPerEntry) {
  const Layout plain{.axes = 2, .law = Law::uniform};
  for (bool Layout::*kinds : {&Layout::has_category, &Layout::has_mask}) {
    Layout layout = plain;
    layout.*kinds = true;
    const NodeFormat format = format_of(layout);
    EXPECT_EQ(format.inner_entry_size, format_of(plain).inner_entry_size + 8);
    EXPECT_EQ(format.record_size, format_of(plain).record_size + 8);
    Node node = full_node(format);
    for (std::size_t slot = 0; slot < node.size(); slot += 2)
      set_kinds(node, slot, {static_cast<std::uint32_t>(slot), 0xfffffff0});
    const std::vector<std::byte> blob = encode_inner(format, number, node);
    ASSERT_EQ(inner_fault(format, blob, number), nullptr);
    const Node back = decode_inner(format, blob);
    EXPECT_EQ(back.values, node.values);
    EXPECT_EQ(back.kinds, node.kinds);
    EXPECT_EQ(kinds_at(back, 1), Kinds{});
    EXPECT_EQ(kinds_at(back, 2), (Kinds{2, 0xfffffff0}));
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
    Node node = full_node(format);
    change(node);
    const char* fault = inner_fault(format, encode_inner(format, number, node), number);
    return fault ? fault : "";
  };
  const auto times = static_cast<std::size_t>(entry_size(2));  // of the second entry
  EXPECT_EQ(fault_after([](Node&) {}), "");
  EXPECT_EQ(fault_after([](Node& n) { n.level = 0; }), "it is not an inner node");
  EXPECT_EQ(fault_after([](Node& n) { n.keys.clear(); }), "its count is wrong");
  EXPECT_EQ(fault_after([](Node& n) { n.parent = -1; }), "its parent is not a node");
  EXPECT_EQ(fault_after([](Node& n) { n.epoch = std::nan(""); }), "its epoch is not finite");
  EXPECT_EQ(fault_after([](Node& n) { n.keys[1] = 0; }), "a child is not another node");
  EXPECT_EQ(fault_after([](Node& n) { n.keys[1] = number; }), "a child is not another node");
  EXPECT_EQ(fault_after([](Node& n) { n.keys[1] = n.keys[6]; }), "a child is named twice");
  EXPECT_EQ(fault_after([&](Node& n) { n.values[times] = 5; }), "reference times are out of order");
  EXPECT_EQ(fault_after([&](Node& n) { n.values[times + 1] = inf; }), "reference times are out of order");
  EXPECT_EQ(fault_after([&](Node& n) { n.values[times + 2] = -2; }), "a child ends before it starts");
  const std::string unordered = "bounds are out of order";
  EXPECT_EQ(fault_after([&](Node& n) { n.values[place(format, 0, lower, 1)] = 1e9; }), unordered);
  EXPECT_EQ(fault_after([&](Node& n) { n.values[place(format, 0, v_upper, 0)] = std::nan(""); }), unordered);
  EXPECT_EQ(fault_after([&](Node& n) { n.values[place(format, 0, a_lower, 0)] = 1; }), unordered);
  EXPECT_EQ(fault_after([&](Node& n) { n.values[place(format, 0, lower, 0)] = inf; }), unordered);
  EXPECT_EQ(fault_after([&](Node& n) {
              n.values[place(format, 0, lower, 1)] = n.values[place(format, 0, upper, 1)] = -inf;
            }),
            unordered);
}

TEST(InnerNode, WhatDoesNotFitIsNotEncoded) {
  const NodeFormat format = format_of({.axes = 2});
  Node node = full_node(format);
  node.level = 256;
  EXPECT_THROW(encode_inner(format, number, node), BrokenTree);
  node.level = 1;
  node.keys.push_back(1000);
  node.values.resize(node.values.size() + static_cast<std::size_t>(entry_size(2)));
  EXPECT_THROW(encode_inner(format, number, node), BrokenTree);
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
