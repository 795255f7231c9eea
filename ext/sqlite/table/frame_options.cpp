#include "sqlite/table/frame_options.h"

#include <algorithm>

#include "base/error.h"
#include "sqlite/sql_tokens.h"

namespace foresee {
namespace {

[[noreturn]] void refuse(const std::string& argument, const std::string& why) {
  throw Error("\"" + argument + "\": " + why);
}

LatLon declared_origin(const Argument& argument) {
  if (const auto origin = parse_origin(argument.detail)) return *origin;
  refuse(argument.text,
         "an origin is a latitude within 90 and a longitude within 180 degrees, or globe; write for example "
         "origin = '53.9 7.9'");
}

SpeedUnit declared_unit(const Argument& argument) {
  for (const SpeedUnit unit : {SpeedUnit::mps, SpeedUnit::knots, SpeedUnit::kmh})
    if (same_name(name_of(unit), argument.detail)) return unit;
  refuse(argument.text, "no such unit; known: mps (the default), knots and kmh, as in speed_unit = knots");
}

std::string declared_text(const Argument& argument) {
  if (argument.detail.empty())
    refuse(argument.text, "the text is empty; write for example frame = 'harbour'");
  for (const char* own : {"plane", "degrees", "globe"})
    if (same_name(own, argument.detail))
      refuse(argument.text, "plane, degrees and globe are foresee's own frames; write another text");
  return argument.detail;
}

using Words = std::vector<DeclaredWord>;

const DeclaredWord* find(const Words& words, std::string_view name) {
  const auto found = std::find_if(words.begin(), words.end(),
                                  [&](const DeclaredWord& one) { return one.word.name == name; });
  return found == words.end() ? nullptr : &*found;
}

/// `first` and `second`, both or neither, in this order.
void require_pair(const Words& words, const char* first, const char* second) {
  const DeclaredWord *one = find(words, first), *two = find(words, second);
  const std::string both = std::string(first) + ", " + second;
  if (one && two && two < one)
    refuse(two->argument, std::string(first) + " comes before " + second + "; write " + both);
  if (!one != !two)
    refuse((one ? one : two)->argument, both + " go together; add " + std::string(one ? second : first));
}

/// The column that a table in degrees has in place of this one; "" if it takes the column itself.
std::string_view geographic_for(const Word& word) {
  if (geo_column(word.name) != GeoColumn::none || word.axis > 1) return "";
  if (word.quantity == Quantity::centre) return word.axis == 0 ? "lat" : "lon";
  if (word.quantity == Quantity::velocity) return word.axis == 0 ? "speed" : "course";
  return "";
}

void require_geographic(const Words& words, bool on_globe) {
  if (!find(words, "lat") && !find(words, "lon"))
    refuse(
        (find(words, "speed") ? find(words, "speed") : find(words, "course"))->argument,
        "speed, course go with lat, lon; write lat, lon in place of x, y, or vx, vy in place of these two");
  require_pair(words, "lat", "lon");
  require_pair(words, "speed", "course");
  for (const auto& [word, argument] : words) {
    if (const std::string_view other = geographic_for(word); !other.empty())
      refuse(argument, "a table with lat, lon has " + std::string(other) + " instead, and " +
                           (on_globe ? "g" : "") + std::string(word.name) +
                           " as a hidden column to read; leave it out");
    if (word.quantity == Quantity::acceleration || word.quantity == Quantity::force ||
        word.quantity == Quantity::mass)
      refuse(argument,
             on_globe ? "the acceleration on the globe is its curvature; leave it out, or use x, y, z and "
                        "geo_to_globe"
                      : "an acceleration would follow the axes of the plane, not east and north; leave it "
                        "out, or use x, y and "
                        "geo_to_plane");
  }
}

/// On the globe no axis is up: its objects are points and balls.
void require_globe(const Words& words) {
  if (const DeclaredWord* plan = find(words, "plan"))
    refuse(plan->argument,
           "legs are straight, and paths on the globe bend; write origin = 'LAT LON', or leave plan out");
  for (const auto& [word, argument] : words)
    if (word.quantity == Quantity::half_extent || word.quantity == Quantity::form ||
        word.quantity == Quantity::heading || (word.quantity == Quantity::growth && word.axis == 2))
      refuse(argument,
             "no axis of the globe points up, so a table on the globe has points and balls (r) only; leave " +
                 std::string(word.name) + " out, or write origin = 'LAT LON'");
}

/// The columns that go with `zone`: t, z and hz, r, growth and growth_z, until.
void require_zone(const DeclaredWord& zone, const Words& words) {
  for (const auto& [word, argument] : words) {
    const bool on_height = word.axis == 2 && word.quantity == Quantity::velocity;
    if (word.quantity == Quantity::centre && word.axis < 2)
      refuse(argument, "the corners of a zone place it; leave " + std::string(word.name) +
                           " out, or write shape in place of zone");
    if (word.quantity == Quantity::velocity || word.quantity == Quantity::acceleration ||
        word.quantity == Quantity::force || word.quantity == Quantity::mass ||
        word.quantity == Quantity::plan || on_height)
      refuse(argument, "a zone is at rest; leave " + std::string(word.name) +
                           " out, or write lat, lon and shape in place of zone");
    if (word.quantity == Quantity::heading || word.name == "shape" ||
        (word.quantity == Quantity::half_extent && word.axis < 2))
      refuse(argument,
             "the corners of a zone are all of its shape; leave " + std::string(word.name) + " out");
  }
  if (find(words, "z") && !find(words, "hz"))
    refuse(zone.argument, "a zone with z is an upright prism; add hz, half of its height, or leave z out");
}

}  // namespace

bool FrameOptions::read_if_known(const Argument& argument) {
  std::optional<Argument>* option = nullptr;
  if (same_name(argument.name, "origin")) option = &origin_;
  if (same_name(argument.name, "speed_unit")) option = &unit_;
  if (same_name(argument.name, "frame")) option = &text_;
  if (option == nullptr) return false;
  if (*option) refuse(argument.text, argument.name + " is given twice; leave one out");
  if (option == &origin_) {
    if (same_name(argument.detail, "globe"))
      given_.kind = FrameKind::globe;
    else
      given_.origin = declared_origin(argument);
  }
  if (option == &unit_) given_.unit = declared_unit(argument);
  if (option == &text_) given_.text = declared_text(argument);
  *option = argument;
  return true;
}

void FrameOptions::require_plane() const {
  for (const auto* option : {&origin_, &unit_})
    if (*option)
      refuse((*option)->text, (*option)->name +
                                  " is for tables in degrees; write lat, lon in place of x, y, or leave "
                                  "it out");
}

Frame FrameOptions::frame_of_zones(const DeclaredWord& zone, const Words& words) const {
  require_zone(zone, words);
  if (text_) refuse(text_->text, "the frame of a table of zones is its origin; leave frame out");
  if (unit_) refuse(unit_->text, "a zone has no speed; leave speed_unit out");
  if (!origin_)
    refuse(
        zone.argument,
        "a table of zones needs the origin of the tables beside it; write for example origin = '53.9 7.9'");
  if (given_.on_globe())
    refuse(origin_->text, "zones lie on a plane; write an origin within 1500 km, as in origin = '53.9 7.9'");
  Frame frame = given_;
  frame.kind = FrameKind::degrees;
  return frame;
}

Frame FrameOptions::frame(const Words& words) const {
  Frame frame = given_;
  if (const DeclaredWord* const zone = find(words, zone_column)) return frame_of_zones(*zone, words);
  const bool in_degrees = std::any_of(words.begin(), words.end(), [](const DeclaredWord& one) {
    return geo_column(one.word.name) != GeoColumn::none;
  });
  if (!in_degrees) {
    require_plane();
    return frame;
  }
  require_geographic(words, frame.on_globe());
  if (text_) refuse(text_->text, "the frame of a table with lat, lon is its origin; leave frame out");
  if (frame.on_globe())
    require_globe(words);
  else
    frame.kind = FrameKind::degrees;
  return frame;
}

}  // namespace foresee
