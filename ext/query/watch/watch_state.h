// State of a predictive watch: its declaration and how far it has been computed. A database keeps it in
// <name>_meta, with the current names of the tables; the text of CREATE may have older ones.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace foresee {

struct WatchDeclaration {
  std::string tbl;
  std::optional<std::string> other = {};  ///< nothing: pairs within tbl
  double horizon = 0;
  double within = 0;
  std::optional<double> within_z = {};
  bool manual = false;  ///< only 'advance' moves the clock
  double tolerance = 0;
  std::int64_t keep = 1000000;
  std::optional<double> ahead = {};  ///< a report later than clock + ahead does not move the clock
};

struct WatchState : WatchDeclaration {
  std::int64_t format = 0;           ///< as read; writing uses the newest format
  std::optional<double> clock = {};  ///< nothing: there has been no object yet
  std::optional<double> asked = {};  ///< time of an 'advance' that is not settled yet
  bool anew = false;                 ///< 'rebuild': stored pairs are to be computed again
  double known_to = 0;               ///< the rows have all pairs that start up to this time
  double step = 0;                   ///< last advance of the clock
  double further = 0;                ///< how far beyond the horizon the last search went
  std::int64_t waited = 0;           ///< pairs beyond the horizon that it, or a change since, has found
  std::int64_t dropped = 0;          ///< how many of those were removed before they were reported
  std::int64_t seq = 0;              ///< number of the last change
  std::int64_t early = 0;            ///< number of reports later than `ahead` allows
  std::optional<std::int64_t> stamp = {}, other_stamp = {};  ///< contents for which the rows were computed

  double now() const { return asked ? *asked : clock.value_or(0); }
};

}  // namespace foresee
