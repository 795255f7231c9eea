// Loads and reports of hulls, boxes and discs, one kind after the other in each repetition.
#include "hulls/modes.h"
#include "hulls/ships.h"
#include "measure.h"

namespace foresee::bench {
namespace {

constexpr ShipKind kinds[] = {ShipKind::hulls, ShipKind::boxes, ShipKind::discs};

void print(const char* what, const std::vector<double> (&costs)[3]) {
  const double hulls = median(costs[0]), boxes = median(costs[1]), discs = median(costs[2]);
  std::printf("%-36s hulls %6.2f us per row   boxes %6.2f, %.2fx   discs %6.2f, %.2fx (mark: 0.5x)\n", what,
              hulls, boxes, boxes / hulls, discs, discs / hulls);
  std::fflush(stdout);
}

}  // namespace

void measure_hull_writes(bool quick) {
  Ships ships;
  const std::vector<Ship> all = ships.all();
  const double a_row = 1e6 / static_cast<double>(all.size());
  std::vector<double> loads[3], updates[3];
  std::vector<std::unique_ptr<ShipTable>> tables(3);
  for (int i = 0; i < (quick ? 1 : 5); ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      tables[k] = std::make_unique<ShipTable>(kinds[k], ships);
      loads[k].push_back(a_row * seconds_of([&] { tables[k]->insert(all, all.size() / 20); }));
    }
  print("load, 20 transactions", loads);
  for (int i = 0; i < (quick ? 1 : 9); ++i) {
    const std::vector<Ship> reports = ships.reports(all.size());
    for (std::size_t k = 0; k < 3; ++k)
      updates[k].push_back(a_row * seconds_of([&] { tables[k]->update(reports); }));
  }
  print("100,000 reports in one transaction", updates);
}

}  // namespace foresee::bench
