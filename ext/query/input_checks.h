// Checks of the inputs of a query; each throws an Error that states the rule and the value.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "query/scene.h"

namespace foresee {

// What the scene of a query is. Each check takes a constant time.

/// "a join has no scene a; set JoinQuestion::a". `what`: before the semicolon; `member`: what to set.
void require_set(bool is_set, const char* what, const char* member);

/// Throws Error for a layout that queries do not know: axes 0 or 4, a cylinder on two axes, a plan without `until`. As
/// "ships: a layout has 1, 2 or 3 axes, not 4".
void require_layout(const std::string& name, const Layout& layout);

/// Throws Error unless the sizes of a scene fit its layout, as "ships: 3 ids need 15 numbers in rows, not 12". Also for
/// plans without find_movers(), and for levels of another scene.
void require_whole(const Scene& scene);

/// Throws Error for outlines or meshes without take_forms(), which contact reads.
void require_forms(const Scene& scene);

/// The scene, if it is set and whole.
std::shared_ptr<const Scene> whole(std::shared_ptr<const Scene> scene, const char* what, const char* member);

/// Throws Error unless the target has either a whole scene or a tree, with chunks if its layout has plans.
void require_target(const SearchTarget& objects, const char* what, const char* member);

// Numbers of a record or a row.

enum class NumberRule : std::uint8_t { finite, positive, size, end, kind };

struct NumberColumn {
  const char* name;  ///< "x", "vy", "hz", "until", …
  int place;         ///< in the record or row
  NumberRule rule;
};

/// `at`: of the record or row. Numbers of plans, and the number of an outline or a mesh, are left out.
std::vector<NumberColumn> number_columns(const Layout& layout, const Offsets& at);

/// Throws Error for the first number that a table refuses (check_numbers()).
void require_numbers(const std::string& name, std::int64_t id, std::span<const NumberColumn> columns,
                     const Offsets& at, const double* numbers);

// Inputs of a query.

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
