// Contact of real ships (AIS) against the oracle, if the data set is present: ../shared/data beside the
// repository, or $FORESEE_SHARED_DATA.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>

#include "contact/contact.h"

namespace foresee {
namespace {

std::string data_folder() {
  if (const char* folder = std::getenv("FORESEE_SHARED_DATA")) return folder;
  return FORESEE_SOURCE_DIR "/../shared/data";
}

std::vector<std::vector<double>> read_csv(const std::string& name) {
  std::ifstream file(data_folder() + "/" + name);
  std::vector<std::vector<double>> lines;
  std::string line, field;
  std::getline(file, line);  // headings
  while (std::getline(file, line)) {
    std::vector<double> numbers;
    for (std::istringstream fields(line); std::getline(fields, field, ',');)
      numbers.push_back(field.empty() ? NAN : std::stod(field));
    lines.push_back(numbers);
  }
  return lines;
}

struct Ships {
  std::vector<std::int64_t> ids;
  std::vector<double> rows;
};

Ships read_ships(double half) {
  Ships ships;
  for (const auto& line : read_csv("ships_mississippi.csv")) {
    ships.ids.push_back(static_cast<std::int64_t>(line[0]));
    ships.rows.insert(ships.rows.end(), line.begin() + 1, line.begin() + 6);
    if (half > 0) ships.rows.insert(ships.rows.end(), {half, half});
  }
  return ships;
}

void expect_pairs(const Ships& ships, const Layout& layout, double within, const std::string& expected_csv,
                  std::size_t count) {
  const Bodies bodies(layout, ships.rows.data(), ships.ids.size());
  const auto contact = make_contact(bodies, bodies, {.horizon = {600, 600}, .within = within, .within_z = {}},
                                    "ships", "ships");
  std::vector<Pair> all, hits;
  for (std::uint32_t a = 0; a < bodies.count; ++a)
    for (std::uint32_t b = a + 1; b < bodies.count; ++b) all.push_back({a, b});
  std::vector<ContactTimes> times;
  contact->first_contacts(all, TimesWanted::both, hits, times);
  ASSERT_EQ(hits.size(), count);
  std::map<std::pair<std::int64_t, std::int64_t>, std::vector<double>> expected;
  for (const auto& line : read_csv(expected_csv))
    expected[std::minmax(static_cast<std::int64_t>(line[0]), static_cast<std::int64_t>(line[1]))] = line;
  ASSERT_EQ(expected.size(), count);
  std::vector<ClosestApproach> approaches(count);
  contact->closest_approach(hits, approaches);
  for (std::size_t i = 0; i < count; ++i) {
    const auto found = expected.find(std::minmax(ships.ids[hits[i].a], ships.ids[hits[i].b]));
    ASSERT_NE(found, expected.end());
    const std::vector<double>& line = found->second;
    EXPECT_NEAR(times[i].dt, line[2], 1e-6);
    EXPECT_NEAR(times[i].dt_end, line[3], 1e-6);
    EXPECT_NEAR(times[i].t, 600 + line[2], 1e-6);
    EXPECT_NEAR(times[i].t_end, 600 + line[3], 1e-6);
    if (line.size() < 6 || std::isnan(line[5])) continue;
    EXPECT_NEAR(approaches[i].d, line[5], 1e-6);
    EXPECT_NEAR(approaches[i].dt, line[4], 1e-3);
  }
}

TEST(RealShips, MeetWithin926Metres) {
  const Ships ships = read_ships(0);
  if (ships.ids.empty()) GTEST_SKIP() << "no data in " << data_folder();
  const Layout layout{.axes = 2, .law = Law::uniform, .has_t = true};
  expect_pairs(ships, layout, 926, "ships_mississippi_within926_h600.csv", 3993);
}

TEST(RealShips, MeetAsBoxesOfHalfExtent463Metres) {
  const Ships ships = read_ships(463);
  if (ships.ids.empty()) GTEST_SKIP() << "no data in " << data_folder();
  const Layout layout{.axes = 2, .law = Law::uniform, .shape = Shape::box, .has_t = true};
  expect_pairs(ships, layout, 0, "ships_mississippi_box463_h600.csv", 4488);
}

}  // namespace
}  // namespace foresee
