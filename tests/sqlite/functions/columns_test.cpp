#include "sqlite/functions/columns.h"

#include <gtest/gtest.h>

namespace foresee {
namespace {

constexpr ColumnList three_columns{"id INTEGER", "t REAL", "t_end REAL"};
static_assert(three_columns["id"] == 0 && three_columns["t"] == 1 && three_columns["t_end"] == 2);
constexpr ColumnList one_name{"h"};
static_assert(one_name["h"] == 0);

TEST(ColumnList, TheDeclarationHasThemInOrder) {
  const std::vector<const char*> declared = three_columns;
  ASSERT_EQ(declared.size(), 3u);
  EXPECT_STREQ(declared[static_cast<std::size_t>(three_columns["t"])], "t REAL");
}

}  // namespace
}  // namespace foresee
