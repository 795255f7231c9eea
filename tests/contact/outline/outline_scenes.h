// Random test scenes of pairs with outlines. The families are hard cases: sliding edges, corners on corners,
// contacts that end and start again, touches at the ends of the queried time. Coordinates and scales may be
// extreme.
#pragma once

#include <cstdint>
#include <optional>
#include <random>
#include <span>
#include <string>

#include "contact/contact.h"
#include "contact/pair_by_hand.h"
#include "shape/outline/convex_pieces.h"

namespace foresee::testing_by_hand {

/// One object: its row, and its outline; a point or a box has none.
struct OutlinedObject {
  Object row;
  Outline outline;
};

/// A region written as rings of numbers: x, y, x, y, …
using Ring = std::vector<double>;
Outline outline_of(const std::vector<std::vector<Ring>>& parts);

/// With both coordinates of all corners multiplied.
Outline changed(const Outline& outline, const Corner& factor);

struct OutlineScene {
  OutlinedObject a, b;
  ContactQuestion question;
};

/// The result of Contact; checks that decide() and first_contacts() with both TimesWanted agree.
std::optional<ContactTimes> outline_contact(const OutlineScene& scene);
/// The same with an interrupt.
std::optional<ContactTimes> outline_contact(const OutlineScene& scene, Interrupt& interrupt);

/// How the numbers of a family look.
struct OutlineFamily {
  enum class Motion : std::uint8_t {
    any,              ///< random positions and speeds
    meets_a_corner,   ///< a corner of b comes to a corner of a at an integer time
    along_an_edge,    ///< the same, along an edge of a
    through_corners,  ///< from a corner of a to another, whatever lies between
    none              ///< corner on corner, and no relative motion
  };
  const char* name;
  Motion motion = Motion::any;
  int ulps = 0;        ///< places are then moved by up to so many units in the last place
  bool whole = true;   ///< halves of whole numbers: exact touches, ties
  double offset = 0;   ///< far from the origin
  int scale = 0;       ///< lengths times 2^scale
  double now = 0;      ///< time of the query; reports are from time 0
  double ages = 0;     ///< reference times lie up to this before now
  bool lives = false;  ///< objects cease to exist at an integer time
  int turned = 0;      ///< so many degrees, or any heading if below 0
  bool bent = false;   ///< accelerated
};

std::span<const OutlineFamily> outline_families();

/// Which kinds of objects meet.
enum class OutlinePairing : std::uint8_t { outlines, outline_and_point, outline_and_box };

OutlineScene draw_scene(const OutlineFamily& family, OutlinePairing pairing, std::uint64_t seed);

/// In words, for messages.
std::string described(const OutlineScene& scene);

}  // namespace foresee::testing_by_hand
