// Checks of the numbers that a query is given; each throws an Error that states the rule and the value.
#pragma once

#include <string>

#include "query/scene.h"

namespace foresee {

/// "h must be a finite number >= 0, not -3"
void require_not_negative(const char* name, double value);

/// "step must be a finite number > 0, not 0"
void require_positive(const char* name, double value);

/// "now must be a finite number, not inf"
void require_finite(const char* name, double value);

/// "x0 must be a finite number, or left out for no bound, not inf"; an infinity of the other sign means no
/// bound.
void require_lower_bound(const char* name, double value);
void require_upper_bound(const char* name, double value);

/// "x0 must not be greater than x1: x0 is 5, x1 is 3"
void require_order(const char* lower_name, double lower, const char* upper_name, double upper);

/// "ships has 2 axes (x, y): leave out z0"
[[noreturn]] void reject_axis(const SearchTarget& objects, const std::string& given);

/// "ships has 2 axes (x, y): y is missing"
[[noreturn]] void reject_missing(const SearchTarget& objects, const std::string& coordinate);

}  // namespace foresee
