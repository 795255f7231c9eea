// What stands in <name>_meta of a watch: what CREATE said, with the tables under the names that they have
// now, and how far the watch has come. It is the truth; the text of CREATE may be older.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace foresee {

struct WatchDeclaration {
  std::string tbl;
  std::optional<std::string> other = {};  ///< none: pairs within tbl
  double horizon = 0;
  double within = 0;
  std::optional<double> within_z = {};
  bool manual = false;  ///< the clock goes by 'advance' alone
  double tolerance = 0;
  std::int64_t keep = 1000000;
  std::optional<double> ahead = {};  ///< a report later than clock + ahead does not move the clock
};

struct WatchState : WatchDeclaration {
  std::int64_t format = 0;           ///< as it was read; what is written is of the newest
  std::optional<double> clock = {};  ///< none: no object has been there yet
  std::optional<double> asked = {};  ///< by an 'advance' that is not settled yet
  bool anew = false;                 ///< 'rebuild': what is stored is not to be believed
  double known_to = 0;               ///< the rows hold all pairs that begin up to this moment
  double step = 0;                   ///< by which the clock moved last
  double further = 0;                ///< how far beyond the horizon the last look went
  std::int64_t waited = 0;           ///< pairs that it, or a change since, has found beyond the horizon
  std::int64_t dropped = 0;          ///< … of those, how many went before they were seen
  std::int64_t seq = 0;              ///< of the last change
  std::int64_t early = 0;            ///< reports beyond `ahead`
  std::optional<std::int64_t> stamp = {}, other_stamp = {};  ///< the contents that the rows are about

  double now() const { return asked ? *asked : clock.value_or(0); }
};

}  // namespace foresee
