// History of nodes: every state as of every mark and snapshot, whichever of them are given up.
#include "storage/nodes/node_history.h"

#include <gtest/gtest.h>

#include <map>
#include <random>
#include <vector>

namespace foresee {
namespace {

/// States are told apart by their nodes' addresses.
NodeState any_state() {
  return {.node = std::make_shared<Node>(), .dirty = true};
}

using States = std::map<NodeNumber, NodeState>;

class Histories : public ::testing::Test {
 protected:
  Histories() {
    for (NodeNumber number = 1; number <= 12; ++number) nodes[number] = any_state();
  }
  void change(NodeNumber number) {
    history.keep(number, nodes[number]);
    nodes[number] = any_state();
  }
  void expect(std::size_t position, const States& states) {
    for (const auto& [number, state] : states) {
      const NodeState* before = history.find(position, number);
      ASSERT_EQ((before ? *before : nodes[number]).node, state.node) << "node " << number;
    }
  }

  NodeHistory history;
  States nodes;
};

TEST_F(Histories, HaveTheStateOfEveryNodeWhicheverMarksAndSnapshotsAreGivenUp) {
  struct Mark {
    std::size_t position;
    States nodes;
  };
  struct Held {
    NodeHistory::Snapshot snapshot;
    States nodes;
  };
  std::mt19937 random(1);
  for (int round = 0; round < 200; ++round) {
    std::vector<Mark> marks;  // a stack
    std::vector<Held> held;   // in no order
    const auto compact = [&](std::size_t position) {
      std::vector<std::size_t> positions;
      for (const Mark& mark : marks) positions.push_back(mark.position);
      history.compact(position, positions);
    };
    for (int step = 0; step < 80; ++step) {
      switch (random() % 10) {
        case 0:
          marks.push_back({history.end(), nodes});
          break;
        case 1:
          held.push_back({history.take_snapshot(), nodes});
          break;
        case 2: {
          if (marks.empty()) break;
          const std::size_t position = marks.back().position;
          marks.pop_back();
          compact(marks.empty() ? 0 : position);
          break;
        }
        case 3: {
          if (held.empty()) break;
          const auto which = held.begin() + static_cast<std::ptrdiff_t>(random() % held.size());
          const std::size_t position = which->snapshot->position;
          history.give_up(which->snapshot);
          held.erase(which);
          compact(position);
          break;
        }
        case 4: {
          if (marks.empty() || history.has_snapshot_since(marks.back().position)) break;
          nodes = marks.back().nodes;
          history.truncate(marks.back().position);
          break;
        }
        default:
          if (!marks.empty() || !held.empty()) change(1 + static_cast<NodeNumber>(random() % 12));
      }
      for (const Mark& then : marks) expect(then.position, then.nodes);
      for (const Held& then : held) expect(then.snapshot->position, then.nodes);
    }
    for (const Held& each : held) history.give_up(each.snapshot);
    history.clear();
  }
}

TEST_F(Histories, GoBackFromTheNewestStateToTheOldest) {
  const std::size_t position = history.end();
  const States before = nodes;
  change(3);
  change(5);
  change(3);
  history.for_each_back(position, history.end(),
                        [&](NodeNumber number, const NodeState& state) { nodes[number] = state; });
  for (const auto& [number, state] : before) EXPECT_EQ(nodes[number].node, state.node);
  history.truncate(position);
  EXPECT_EQ(history.find(position, 3), nullptr);
}

TEST_F(Histories, DropWhatAnOlderStateCovers) {
  const std::size_t savepoint = history.end();
  const States before = nodes;
  change(1);
  std::weak_ptr<Node> covered;
  for (int i = 0; i < 1000; ++i) {
    const std::size_t position = history.end();
    covered = nodes[1].node;
    change(1);
    history.compact(position, {{savepoint}});
    ASSERT_TRUE(covered.expired());
    ASSERT_EQ(history.end(), savepoint + 1);
  }
  expect(savepoint, before);
  const auto snapshot = history.take_snapshot();
  change(2);
  history.compact(0, {});
  EXPECT_EQ(history.find(savepoint, 1), nullptr) << "no snapshot is that old";
  EXPECT_EQ(history.find(snapshot->position, 2)->node, before.at(2).node);
  history.give_up(snapshot);
}

}  // namespace
}  // namespace foresee
