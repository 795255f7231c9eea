// Is an outline one?
//
//   check_outline(outline);                                        // throws Error
//   const Outline as_it_lies = turned(outline, heading);
//   check_turned(outline, as_it_lies, heading);
#pragma once

#include "shape/outline/outline.h"

namespace foresee::shape {

/// Throws Error, which says what is wrong and where: for the person who wrote the outline.
void check_outline(const Outline& outline);

/// Throws Error if `turned`, which is the valid `outline` turned by `heading`, is none any more.
void check_turned(const Outline& outline, const Outline& turned, double heading);

}  // namespace foresee::shape
