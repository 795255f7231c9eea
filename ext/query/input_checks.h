// Checks of the inputs of a query; each throws an Error that states the rule and the value.
#pragma once

#include <string>
#include <string_view>

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

/// The input `contacts`: true for 'all', false for 'first'. Throws Error for any other text.
bool wants_all_contacts(std::string_view text);

/// "contacts = 'all' is not for outlines and meshes: leave it out"
void refuse_all_contacts_of_forms(const Layout& layout);

/// "ships has 2 axes (x, y): leave out z0"
[[noreturn]] void reject_axis(const SearchTarget& objects, const std::string& given);

/// "ships has 2 axes (x, y): y is missing"
[[noreturn]] void reject_missing(const SearchTarget& objects, const std::string& coordinate);

}  // namespace foresee
