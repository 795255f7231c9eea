// foresee without SQLite: a scene in memory, the join as a library call.
//
// Build: c++ -std=c++20 embed_core.cpp $(pkg-config --cflags --libs foresee-core)     (docs/hosts/c.md)
// Prints:  Anna and Bruno touch after 95 s
#include <cstdio>
#include <memory>

#include "query/join/join.h"

int main() {
  const char* const names[] = {"Anna", "Bruno", "Clara"};

  auto ships = std::make_shared<foresee::Scene>();
  ships->name = "ships";
  ships->layout = {.axes = 2, .law = foresee::Law::uniform, .shape = foresee::Shape::ball};
  ships->ids = {0, 1, 2};
  ships->rows = {
      0,    0,     6,  0, 30,  // x, y, vx, vy, r: the order of row_offsets(layout)
      1200, 0,     -6, 0, 30,  //
      600,  -1600, 0,  8, 30,
  };

  foresee::JoinQuestion question;
  question.a = ships;
  question.h = 300;

  foresee::NeverInterrupt never;
  foresee::Join join(question, never);
  for (auto rows = join.next(); !rows.empty(); rows = join.next())
    for (const foresee::JoinRow& row : rows)
      std::printf("%s and %s touch after %g s\n", names[row.a], names[row.b], row.contact.dt);
}
