"""The runner of the documents' examples, tried on made-up pages: what is wrong on a page is found."""
import unittest

from documents import examples, message_of, run_document
from house import main


def page(*blocks):
    """A page made of (tag, text) blocks."""
    return "Words.\n\n" + "\n\n".join(f"```{tag}\n{text}\n```" for tag, text in blocks) + "\n\nMore words.\n"


BOX_OF_ONE = "┌───┐\n│ n │\n├───┤\n│ 1 │\n└───┘"


class Runner(unittest.TestCase):
    def finds_nothing(self, document):
        found, count = run_document(document, "page")
        self.assertEqual(found, [])
        return count

    def finds(self, document, words):
        found, _ = run_document(document, "page")
        self.assertEqual(len(found), 1, found)
        self.assertIn(words, found[0])

    def test_blocks_share_one_database(self):
        self.assertEqual(self.finds_nothing(page(("sql", "CREATE TABLE one(n); INSERT INTO one VALUES(1);"),
                                                 ("sql", "SELECT n FROM one;"), ("text", BOX_OF_ONE))), 2)

    def test_a_hidden_set_up_runs_first(self):
        document = "<!-- sql setup\nCREATE TABLE one AS SELECT 1 AS n;\n-->\n" + page(("sql", "SELECT n FROM one;"))
        self.assertEqual(self.finds_nothing(document), 2)

    def test_other_blocks_are_not_run(self):
        self.assertEqual(self.finds_nothing(page(("bash", "exit 1"), ("text", "a drawing"), ("", "another"))), 0)

    def test_a_failing_example_is_found(self):
        self.finds(page(("sql", "SELECT * FROM nowhere;")), "no such table: nowhere")

    def test_a_wrong_output_is_found(self):
        self.finds(page(("sql", "SELECT 2 AS n;"), ("text", BOX_OF_ONE)), "│ 2 │")

    def test_a_missing_output_is_found(self):
        self.finds(page(("sql", "SELECT 1 AS n WHERE 0;"), ("text", BOX_OF_ONE)), "prints")

    def test_an_error_must_come_and_say_what_the_page_says(self):
        self.finds_nothing(page(("sql error", "SELECT * FROM nowhere;"), ("text", "no such table: nowhere")))
        self.finds(page(("sql error", "SELECT 1;"), ("text", "no such table: nowhere")), "was to fail")
        self.finds(page(("sql error", "SELECT * FROM nowhere;"), ("text", "no such table: elsewhere")), "but says")
        self.finds(page(("sql error", "SELECT * FROM nowhere;")), "but says")

    def test_a_message_has_at_most_160_characters(self):
        for length, words in ((160, None), (161, "says more than 160 characters, 161")):
            message = "no such table: " + (length - len("no such table: ")) * "a"
            one = page(("sql error", f"SELECT * FROM {message.split()[-1]};"), ("text", "no such table"))
            self.finds(one, words) if words else self.finds_nothing(one)

    def test_a_list_of_tables_does_not_count(self):
        self.assertEqual(message_of("Runtime error near line 1: f: tbl is missing (moving_objects tables here: 'a')"), "f: tbl is missing")
        self.assertEqual(message_of("Parse error near line 2: no such table: a\n  SELECT\n"), "no such table: a")
        self.assertEqual(message_of("Error: stepping, constraint failed (19)\n"), "stepping, constraint failed")
        self.assertEqual(message_of("n\n1\n"), "")

    def test_every_row_of_a_table_of_errors_is_run(self):
        table = "<!-- sql errors -->\n\n| write | says |\n|---|---|\n| `SELECT * FROM nowhere` | no such table: nowhere |\n"
        self.assertEqual(self.finds_nothing(table), 1)
        self.finds(table + "| `SELECT * FROM elsewhere` | no such table: nowhere |\n", "page:6")
        self.finds(table + "| `SELECT 1` | no such table |\n", "was to fail")
        self.assertEqual(self.finds_nothing(table + "\nWords.\n\n| `SELECT 1` | another table |\n"), 1)

    def test_a_block_that_never_ends_is_found(self):
        with self.assertRaisesRegex(ValueError, "line 1: the block never ends"):
            examples("```sql\nSELECT 1;\n")


if __name__ == "__main__":
    main()
