// Recognition of moving_objects tables by their CREATE VIRTUAL TABLE statements.
#include "sqlite/names/visible_tables.h"

#include <gtest/gtest.h>

namespace foresee {
namespace {

TEST(UsesMovingObjects, ReadsTheModuleInEverySpelling) {
  EXPECT_TRUE(uses_moving_objects("CREATE VIRTUAL TABLE ships USING moving_objects(id, x)"));
  EXPECT_TRUE(uses_moving_objects("CREATE VIRTUAL TABLE \"a \"\"USING\"\" b\"USING[Moving_Objects](id, x)"));
  EXPECT_TRUE(
      uses_moving_objects("CREATE VIRTUAL TABLE [x y]/*why*/using -- because\n`moving_objects`\n(id)"));
  EXPECT_TRUE(uses_moving_objects("CREATE VIRTUAL TABLE 'ships' USING \"moving_objects\" (id, x)"));
  EXPECT_TRUE(uses_moving_objects("CREATE VIRTUAL TABLE sch\xc3\xb6n USING moving_objects(id, x)"));
}

TEST(UsesMovingObjects, IgnoresNamesAndComments) {
  EXPECT_FALSE(uses_moving_objects("CREATE VIRTUAL TABLE ships USING rtree(id, x0, x1)"));
  EXPECT_FALSE(uses_moving_objects("CREATE VIRTUAL TABLE ships USING moving_objects2(id, x)"));
  EXPECT_FALSE(uses_moving_objects("CREATE VIRTUAL TABLE \"USING moving_objects(\" USING rtree(id, a, b)"));
  EXPECT_FALSE(
      uses_moving_objects("CREATE VIRTUAL TABLE t /* USING moving_objects */ USING rtree(id, a, b)"));
  EXPECT_FALSE(uses_moving_objects("CREATE TABLE t(a DEFAULT 'USING moving_objects')"));
  EXPECT_FALSE(uses_moving_objects("CREATE VIRTUAL TABLE \"unclosed"));
  EXPECT_FALSE(uses_moving_objects("CREATE VIRTUAL TABLE t /* unclosed"));
  EXPECT_FALSE(uses_moving_objects(""));
}

}  // namespace
}  // namespace foresee
