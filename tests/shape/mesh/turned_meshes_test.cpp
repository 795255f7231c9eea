// The rotated meshes of many rows: looked up once, rotated on demand, also by several threads.
#include <gtest/gtest.h>

#include <thread>

#include "shape/mesh/test_meshes.h"
#include "shape/swept_boxes.h"
#include "shape/turned_forms.h"

namespace foresee {
namespace {

struct Rack final : FormSource {
  std::shared_ptr<const Form> form(std::int64_t number) override {
    ++queried;
    return read_form(Shape::mesh, number == 1 ? tetrahedron : "TIN Z(((0 0 3, 4 0 3, 0 5 4, 0 0 3)))");
  }
  int queried = 0;
};

constexpr Layout drones{.axes = 3, .shape = Shape::mesh, .has_heading = true};

/// x, y, z, number, heading, bounds: of which contact's rows need number and heading.
std::vector<double> rows_of(std::initializer_list<std::pair<double, double>> rows) {
  std::vector<double> all;
  for (const auto& [number, heading] : rows)
    for (const double value : {0., 0., 0., number, heading, 0., 0., 0., 0., 0., 0.}) all.push_back(value);
  return all;
}

TEST(TurnedMeshes, AreSharedUnlessTheyAreTurned) {
  const auto rows = rows_of({{1, 0}, {0, 30}, {1, 90}, {2, 0}, {1, 0}});
  Rack rack;
  NeverInterrupt never;
  ScratchPieces<TriangleTree> own;
  const TurnedMeshes meshes(Bodies(drones, rows.data(), 5), rack, never);
  EXPECT_EQ(rack.queried, 2);
  EXPECT_EQ(meshes.pieces(1, own), nullptr);
  EXPECT_EQ(meshes.pieces(0, own), meshes.pieces(4, own));
  EXPECT_NE(meshes.pieces(0, own), meshes.pieces(2, own));
  EXPECT_EQ(meshes.pieces(2, own), meshes.pieces(2, own));
  EXPECT_EQ(meshes.pieces(2, own)->tree().box(0).lower[1], -1);  // clockwise from the y axis
  EXPECT_TRUE(meshes.pieces(2, own)->is_solid());
  EXPECT_EQ(meshes.pieces(3, own)->count(), 1u);
  EXPECT_FALSE(meshes.pieces(3, own)->is_solid());
}

TEST(TurnedMeshes, ManyThreadsGetTheSameTriangles) {
  std::vector<double> rows;
  for (int i = 0; i < 64; ++i)
    for (const double value : rows_of({{1 + i % 2, i}})) rows.push_back(value);
  Rack rack;
  NeverInterrupt never;
  const TurnedMeshes meshes(Bodies(drones, rows.data(), 64), rack, never);
  std::vector<std::vector<const TriangleTree*>> seen(4);
  std::vector<std::thread> threads;
  for (auto& mine : seen)
    threads.emplace_back([&] {
      ScratchPieces<TriangleTree> own;
      for (std::size_t i = 0; i < 64; ++i) mine.push_back(meshes.pieces(i, own));
    });
  for (std::thread& thread : threads) thread.join();
  for (const auto& mine : seen) EXPECT_EQ(mine, seen[0]);
}

TEST(TurnedMeshes, OfMoreHeadingsThanThereIsRoomForAreMadeAgain) {
  constexpr std::size_t budget = 4096;
  std::vector<double> rows;
  for (int i = 0; i < 200; ++i)
    for (const double value : rows_of({{1, 1 + i}})) rows.push_back(value);
  Rack rack;
  NeverInterrupt never;
  ScratchPieces<TriangleTree> own;
  TurnedMeshes meshes(budget);
  meshes.assign(Bodies(drones, rows.data(), 200), rack, never);
  const std::size_t before = meshes.memory();
  for (std::size_t i = 0; i < 200; ++i)
    EXPECT_EQ(meshes.pieces(i, own)->count(), meshes.pieces(0, own)->count());
  EXPECT_LE(meshes.memory(), before + budget);
  EXPECT_EQ(meshes.pieces(199, own), own.pieces.get());
}

// A row of a mesh that lies at (3, 4, 5) to (4, 6, 8) of its position, grown by 2.
TEST(MeshBounds, ReachToThePositionAndGrowOnAllSides) {
  const Layout layout{.axes = 3, .shape = Shape::mesh, .has_radius = true};
  const double row[] = {0, 0, 0, 2, 1, 3, 4, 5, 4, 6, 8};
  const Bodies bodies(layout, row, 1);
  ASSERT_EQ(bodies.at.size, 11);
  const Extents<3> around = extents_of<3>(bodies, 0);
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_EQ(around.lower[axis], 0);
    EXPECT_NEAR(around.upper[axis], row[8 + axis] + 2, 1e-14);
    EXPECT_GE(around.upper[axis], row[8 + axis] + 2);
  }
  EXPECT_TRUE((core_box<3>(bodies, 0, 0).lower > core_box<3>(bodies, 0, 0).upper).any());
}

}  // namespace
}  // namespace foresee
