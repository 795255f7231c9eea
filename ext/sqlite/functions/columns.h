// Outputs or inputs of a table-valued function, each written once: the declaration, and the place of a column by name.
//
//   constexpr ColumnList outputs{"id INTEGER", "t REAL", "x REAL"};
//   static_assert(outputs["t"] == 1);                       // a name that is not there does not compile
//   const std::vector<const char*> declared = outputs;      // for TableFunction::outputs
//
// Guarantee: a place is that of the declared column, whatever is added between. Cost: none at run time.
#pragma once

#include <array>
#include <string_view>
#include <vector>

namespace foresee {

template <std::size_t N>
class ColumnList {
 public:
  /// Each is a name, or a name and a type.
  template <class... Texts>
  constexpr ColumnList(Texts... columns) : columns_{columns...} {}

  consteval int operator[](std::string_view name) const {
    for (std::size_t place = 0; place < N; ++place)
      if (name_of(columns_[place]) == name) return static_cast<int>(place);
    throw "no column has this name";
  }

  operator std::vector<const char*>() const { return {columns_.begin(), columns_.end()}; }

 private:
  static constexpr std::string_view name_of(std::string_view column) {
    return column.substr(0, column.find(' '));
  }

  std::array<const char*, N> columns_;
};

template <class... Texts>
ColumnList(Texts...) -> ColumnList<sizeof...(Texts)>;

}  // namespace foresee
