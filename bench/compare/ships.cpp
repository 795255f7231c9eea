#include "compare/ships.h"

#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>

#include "base/error.h"
#include "geography/plane.h"

namespace foresee::bench {
namespace {

constexpr double knot = 1852.0 / 3600, not_available = 102.3, no_course = 360;
constexpr LatLon middle{40.65, -74.05};

struct Report {
  double t, lat, lon, speed, course;
};

/// Seconds since midnight of "2022-01-03T00:25:16".
double seconds_of_day(const std::string& time) {
  const auto part = [&](std::size_t from) { return std::strtod(time.substr(from, 2).c_str(), nullptr); };
  if (time.size() != 19) throw Error("'" + time + "' is not a time of NOAA's files");
  return 3600 * part(11) + 60 * part(14) + part(17);
}

/// The newest report of each ship. All are of one day.
std::map<std::string, Report> newest_reports(const std::string& path) {
  std::ifstream file(path);
  std::string line;
  std::getline(file, line);
  if (!line.starts_with("MMSI,BaseDateTime,LAT,LON,SOG,COG,")) throw Error(path + " has no reports of NOAA");
  std::map<std::string, Report> newest;
  while (std::getline(file, line)) {
    std::istringstream cells(line);
    std::string ship, time, lat, lon, speed, course;
    for (std::string* cell : {&ship, &time, &lat, &lon, &speed, &course}) std::getline(cells, *cell, ',');
    const auto number = [](const std::string& cell) { return std::strtod(cell.c_str(), nullptr); };
    if (number(speed) == not_available) continue;
    const Report report{seconds_of_day(time), number(lat), number(lon), number(speed), number(course)};
    const auto [place, is_new] = newest.try_emplace(ship, report);
    if (!is_new && place->second.t <= report.t) place->second = report;
  }
  return newest;
}

}  // namespace

Workload real_ships(const std::string& path, double radius, double h) {
  const std::map<std::string, Report> reports = newest_reports(path);
  double now = 0;
  for (const auto& [ship, report] : reports) now = std::max(now, report.t);
  Workload w{"ships", {2, Law::uniform, Shape::ball}, {}, 0, h};
  for (const auto& [ship, report] : reports) {
    const double speed = report.course == no_course ? 0 : report.speed * knot;
    const OnPlane place = to_plane(
        {{report.lat, report.lon}, {{speed, report.course == no_course ? 0 : report.course}}}, middle);
    const std::array<double, 2> v = place.v.value_or(std::array<double, 2>{});
    const double age = now - report.t;
    for (double number : {place.x + age * v[0], place.y + age * v[1], v[0], v[1], radius})
      w.rows.push_back(number);
    ++w.count;
  }
  return w;
}

}  // namespace foresee::bench
