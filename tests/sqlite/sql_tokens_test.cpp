// The SQL tokenizer: words, quoted names, numbers, comments and unterminated tokens.
#include "sqlite/sql_tokens.h"

#include <gtest/gtest.h>

#include <vector>

namespace foresee {
namespace {

using Kind = SqlToken::Kind;
using Texts = std::vector<std::string>;

Texts texts_of(std::string_view sql) {
  Texts texts;
  SqlTokens tokens(sql);
  while (const auto token = tokens.next()) texts.push_back(token->text);
  return texts;
}

Kind kind_of(std::string_view sql) {
  return SqlTokens(sql).next()->kind;
}

TEST(SqlTokens, AreWordsNamesNumbersAndSigns) {
  EXPECT_EQ(texts_of("USING [a b](x,-1.5e3)"), (Texts{"USING", "a b", "(", "x", ",", "-", "1.5e3", ")"}));
  EXPECT_EQ(kind_of("x1$"), Kind::word);
  EXPECT_EQ(kind_of("sch\xc3\xb6n"), Kind::word);
  EXPECT_EQ(kind_of("[x]"), Kind::quoted);
  EXPECT_EQ(kind_of(".5"), Kind::number);
  EXPECT_EQ(kind_of("$"), Kind::sign);
}

TEST(SqlTokens, LoseTheirQuotes) {
  EXPECT_EQ(texts_of("\"a \"\"b\"\"\"'it''s'`c``d`[e]"), (Texts{"a \"b\"", "it's", "c`d", "e"}));
  EXPECT_EQ(texts_of("[a[b]"), (Texts{"a[b"}));
  EXPECT_EQ(texts_of("\"\" x"), (Texts{"", "x"}));
}

TEST(SqlTokens, AreNotFoundInComments) {
  EXPECT_EQ(texts_of("a/*b*/c -- d\n e"), (Texts{"a", "c", "e"}));
  EXPECT_EQ(texts_of("/*/ a */ b"), (Texts{"b"}));
  EXPECT_EQ(texts_of("a - b / c"), (Texts{"a", "-", "b", "/", "c"}));
  EXPECT_EQ(texts_of(" \t\n"), Texts{});
}

TEST(SqlTokens, EndWithTheTextWhereTheyAreNotClosed) {
  EXPECT_EQ(texts_of("a \"b"), (Texts{"a", "b"}));
  EXPECT_EQ(texts_of("a '"), (Texts{"a", ""}));
  EXPECT_EQ(texts_of("a /* b"), (Texts{"a"}));
  EXPECT_EQ(texts_of("a --"), (Texts{"a"}));
}

TEST(SqlTokens, AreTheSameNameInAnyCaseOfAscii) {
  EXPECT_TRUE(same_name("Ships", "sHIPS"));
  EXPECT_FALSE(same_name("ships", "ship"));
  EXPECT_FALSE(same_name("sch\xc3\xb6n", "sch\xc3\x96n"));
}

}  // namespace
}  // namespace foresee
