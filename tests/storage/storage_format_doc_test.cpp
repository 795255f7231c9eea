// docs/developers/storage_format.md has the constants, sizes and tables of the code.
#include <fstream>
#include <map>
#include <regex>
#include <sstream>

#include "format/node_format.h"
#include "storage/database.h"

namespace foresee {
namespace {

std::string page() {
  std::ifstream file(FORESEE_SOURCE_DIR "/docs/developers/storage_format.md");
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

TEST(StorageFormatDoc, NamesTheConstantsWithTheirValues) {
  const std::map<std::string, std::size_t> constants{{"level_at", NodeFormat::level_at},
                                                     {"format_at", NodeFormat::format_at},
                                                     {"count_at", NodeFormat::count_at},
                                                     {"parent_at", NodeFormat::parent_at},
                                                     {"ids_at", NodeFormat::ids_at},
                                                     {"epoch_at", NodeFormat::epoch_at},
                                                     {"entries_at", NodeFormat::entries_at},
                                                     {"checksum_size", NodeFormat::checksum_size},
                                                     {"page_reserve", NodeFormat::page_reserve},
                                                     {"min_capacity", NodeFormat::min_capacity}};
  std::map<std::string, std::size_t> found;
  const std::string text = page();
  const std::regex constant(R"(`(\w+)` (?:\||=) ?(\d+))");
  for (std::sregex_iterator match(text.begin(), text.end(), constant), end; match != end; ++match)
    found[(*match)[1]] = std::stoul((*match)[2]);
  for (const auto& [name, value] : constants) EXPECT_EQ(found[name], value) << name;
}

TEST(StorageFormatDoc, GivesTheSizesOfItsExample) {
  const std::string text = page();
  const NodeFormat format(ships().layout, NodeFormat::node_size_for(ships().layout, 4096));
  EXPECT_NE(text.find(std::to_string(format.node_size) + " with the usual pages of 4096"), std::string::npos);
  EXPECT_NE(text.find("six numbers, " + std::to_string(8 + format.record_size) + " bytes per object"),
            std::string::npos);
  EXPECT_NE(text.find(std::to_string(format.leaf_capacity) + " objects per node"), std::string::npos);
  EXPECT_EQ(format.leaf_capacity, (format.node_size - 16 - 4) / (8 + 8 * 6));
}

TEST(StorageFormatDoc, ShowsTheShadowTablesAsTheyAreMade) {
  Database db;
  Declaration declaration = named_ships();
  declaration.layout.has_until = declaration.layout.has_plan = true;
  make_store(db, declaration);
  const std::string text = page();
  const auto squeezed = [](const std::string& sql) {
    return std::regex_replace(std::regex_replace(sql, std::regex("\""), ""), std::regex("\\s+"), " ");
  };
  Statement select(db, "SELECT sql FROM sqlite_schema WHERE type = 'table'");
  Statement::Run run(select);
  int tables = 0;
  for (; run.step(); ++tables) {
    const std::string sql = squeezed(run.text(0));
    EXPECT_NE(squeezed(text).find(sql + ";"), std::string::npos) << sql;
  }
  EXPECT_EQ(tables, 7);
}

TEST(StorageFormatDoc, ListsTheRowsOfMeta) {
  Database db;
  Declaration declaration = ships();
  declaration.layout.has_until = declaration.layout.has_plan = true;
  make_store(db, declaration);
  const std::string text = page();
  Statement select(db, "SELECT key FROM ships_meta");
  Statement::Run run(select);
  int rows = 0;
  for (; run.step(); ++rows)
    EXPECT_NE(text.find("| `" + run.text(0) + "` |"), std::string::npos) << run.text(0);
  EXPECT_EQ(rows, 9);
}

}  // namespace
}  // namespace foresee
