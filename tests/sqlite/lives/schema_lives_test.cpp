// Random schema changes: the creation, renaming and dropping of tables and watches is rolled back, on two
// connections that keep every statement prepared. FORESEE_LONG=1 runs a hundred thousand statements.
#include "sqlite/lives/schema_lives.h"

#include <cstdlib>

#include "sanitized.h"

namespace foresee::testing {
namespace {

const unsigned lives = std::getenv("FORESEE_LONG") ? 250 : sanitized ? 3 : 12;
constexpr int statements = 400;

TEST(SchemaLives, TablesEqualTheirTwinsAndWatchesTheJoin) {
  int succeeded = 0, failed = 0;
  for (unsigned seed = 1; seed <= lives && !::testing::Test::HasFatalFailure(); ++seed) {
    SCOPED_TRACE("life " + std::to_string(seed));
    SchemaLife life(seed);
    std::mt19937 random(seed);
    for (int i = 0; i < statements && !::testing::Test::HasFatalFailure(); ++i) {
      life.step();
      if (::testing::Test::HasFailure()) FAIL() << life.history();
      if (random() % 3 == 0) life.expect_equal();
      if (!life.in_transaction() && random() % 4 == 0 && !::testing::Test::HasFatalFailure())
        life.expect_sound();
    }
    succeeded += life.succeeded(), failed += life.failed();
  }
  EXPECT_GT(succeeded, 3 * failed);
}

}  // namespace
}  // namespace foresee::testing
