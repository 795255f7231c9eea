// Is a number of the question in order? If not, an Error that says what it must be and what it is.
#pragma once

namespace foresee {

/// "h must be a finite number >= 0, not -3"
void check_not_negative(const char* name, double value);

/// "now must be a finite number, not inf"
void check_finite(const char* name, double value);

}  // namespace foresee
