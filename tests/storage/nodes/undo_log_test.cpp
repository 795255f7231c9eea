#include "storage/nodes/undo_log.h"

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

/// A mark, and the state of every node at that time.
struct Remembered {
  UndoLog::Handle mark;
  std::map<NodeNumber, NodeState> nodes;
};

TEST(UndoLog, HasTheStateOfEveryNodeWhicheverMarksAreGivenUp) {
  std::mt19937 random(1);
  for (int round = 0; round < 200; ++round) {
    UndoLog undo;
    std::map<NodeNumber, NodeState> nodes;
    for (NodeNumber number = 1; number <= 12; ++number) nodes[number] = any_state();
    std::vector<Remembered> remembered;
    for (int step = 0; step < 60; ++step) {
      const auto chance = random() % 8;
      if (chance < 2 || remembered.empty()) {
        remembered.push_back({undo.set({}, false), nodes});
      } else if (chance < 6) {
        const NodeNumber number = 1 + static_cast<NodeNumber>(random() % 12);
        undo.keep(number, nodes[number]);
        nodes[number] = any_state();
      } else {
        const std::size_t which = random() % remembered.size();
        undo.give_up(remembered[which].mark);
        remembered.erase(remembered.begin() + static_cast<std::ptrdiff_t>(which));
      }
      for (const Remembered& then : remembered)
        for (const auto& [number, state] : then.nodes) {
          const NodeState* before = undo.find(then.mark, number);
          ASSERT_EQ((before ? *before : nodes[number]).node, state.node)
              << "round " << round << ", step " << step;
        }
    }
  }
}

}  // namespace
}  // namespace foresee
