// Stiff and extreme scenes as SQL, each with its exact expected rows.
//
// The numbers are chosen so that every exact time is one rounding away from doubles: a quotient, a sum or a
// square root that IEEE arithmetic itself rounds correctly. The tests compare the answers; the bench measures
// the time.
#pragma once

#include <string>
#include <vector>

namespace foresee::testing {

struct ExtremeScene {
  std::string name;
  std::string setup;  ///< creates and fills the table
  std::string query;  ///< numbers only, rows in order
  std::vector<std::vector<double>> expected;
};

/// `aircraft`: the number that meet in one point, at most 300.
std::vector<ExtremeScene> extreme_scenes(int aircraft = 300);

}  // namespace foresee::testing
