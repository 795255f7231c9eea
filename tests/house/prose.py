"""The prose of a C++ file, of a page or of a man page: comments, messages and paragraphs, without code, quoted output and SQL.

    for piece in prose_of(ROOT / "ext/query/scene.h"):
        print(piece.kind, piece.first_line, piece.text)        # kind: "comment", "message", "page", "heading", "table"

A piece is one paragraph. `line_at(offset)` gives the line of a character of `text`. Code in backticks or in quotation marks is
replaced by ¤, so that sentences keep their number of words. Examples are not prose: in C++ comments the lines that are
indented by three or more spaces, in pages fenced blocks and lines that are indented by four spaces.
"""
import re
from bisect import bisect_right
from dataclasses import dataclass, field

CODE = re.compile(r"'[^'\s]+'|``[^`]+``|`[^`]*`|\"[^\"]*\"|“[^”]*”|\*\*?SQL\*\*?|\bhttps?://\S+|<!--.*?-->|\]\([^)]*\)|</?\w+[^>\n]*>")
SQL = re.compile(r"\b(TIN|POLYGON|MULTIPOLYGON|POLYHEDRALSURFACE|SELECT|INSERT|UPDATE|DELETE FROM|CREATE|DROP|ALTER|PRAGMA|SAVEPOINT|ROLLBACK|RELEASE|WHERE|VALUES|BEGIN|COMMIT|PRIMARY KEY)\b"
                 r"|^\s*(REAL|INTEGER|TEXT|HIDDEN)\b")
RAW, PLAIN, CHARACTER = re.compile(r'R"(\w*)\((.*?)\)\1"'), re.compile(r'"((?:[^"\\]|\\.)*)"'), re.compile(r"'(?:[^'\\]|\\.)+'")
COMMENT = re.compile(r"^\s*//[/!]?<?(.*)$")
CPP = {".h", ".cpp", ".c"}


@dataclass
class Piece:
    kind: str
    text: str = ""
    starts: list = field(default_factory=list)  # offset in `text` at which each line starts
    lines: list = field(default_factory=list)

    @property
    def first_line(self):
        return self.lines[0]

    def add(self, line, text):
        if self.text:
            self.text += " "
        self.starts.append(len(self.text))
        self.lines.append(line)
        self.text += text.strip()

    def line_at(self, offset):
        return self.lines[max(0, bisect_right(self.starts, offset) - 1)]


def without_code(piece):
    """Blanks code and quotations in place, so that offsets stay true."""
    piece.text = CODE.sub(lambda m: "¤" * len(m.group()), piece.text)
    return piece


def split_code_line(line):
    """(code without comment and literals, string literals, comment or None) of a line of C++."""
    literals, code, at = [], "", 0
    while at < len(line):
        if line.startswith("//", at):
            return code, literals, line[at:]
        raw, plain, char = RAW.match(line, at), PLAIN.match(line, at), CHARACTER.match(line, at)
        if raw or plain:
            literals.append((raw.group(2) if raw else plain.group(1)))
            code += '""'
            at = (raw or plain).end()
        elif char:
            code += "' '"
            at = char.end()
        else:
            code += line[at]
            at += 1
    return code, literals, None


def without_raw_pages(text):
    """Raw strings of several lines, which hold SQL or data, as empty ones; the lines keep their numbers."""
    return re.sub(r'R"(\w*)\((.*?)\)\1"', lambda m: '""' + "\n" * m.group().count("\n") if "\n" in m.group() else m.group(), text, flags=re.S)


def prose_of_cpp(text):
    pieces, comment, message, code_before = [], None, None, ""

    def close():
        nonlocal comment
        if comment and comment.text:
            pieces.append(comment)
        comment = None

    for number, line in enumerate(without_raw_pages(text).splitlines(), 1):
        whole = COMMENT.match(line)
        if whole:
            words = whole.group(1)
            if not re.search(r"\w", words) or re.match(r"\s{3,}\S", words):  # nothing, a rule, or an example
                close()
                continue
            if comment is None:
                comment = Piece("comment")
            comment.add(number, words)
            continue
        code, literals, beside = split_code_line(line)
        close()
        if beside is not None and not beside.startswith("// namespace"):
            comment = Piece("comment")
            comment.add(number, re.sub(r"^//[/!]?<?", "", beside))
        if literals and not code.lstrip().startswith("#include"):
            goes_on = code.lstrip().startswith('"') and not code_before.endswith(",")  # not the next literal of a list
            if message is None or message.lines[-1] != number - 1 or not goes_on:
                message = Piece("message")
                pieces.append(message)
            for literal in literals:
                message.add(number, literal)
        code_before = code.rstrip()
    close()
    return [without_code(piece) for piece in pieces
            if piece.kind != "message" or (" " in piece.text.strip() and not SQL.search(piece.text))]


def prose_of_page(text):
    pieces, piece, fence = [], None, None

    def close():
        nonlocal piece
        if piece and piece.text:
            pieces.append(piece)
        piece = None

    in_list = False
    for number, line in enumerate(text.splitlines(), 1):
        if line.lstrip().startswith("```"):
            fence = None if fence is not None else line
            close()
            continue
        if fence is not None:
            continue
        if not line.strip():
            close()
            continue
        item = re.match(r"\s*(?:[-*+]|\d+\.)\s+", line)
        if re.match(r"    ", line) and not item and not in_list:
            close()
            continue
        if line.startswith("#"):
            close()
            in_list = False
            piece = Piece("heading")
            piece.add(number, line.lstrip("# "))
            close()
            continue
        if line.lstrip().startswith("|"):
            close()
            if not re.fullmatch(r"[\s|:-]+", line):
                piece = Piece("table")
                piece.add(number, line)
                close()
            continue
        if item:
            close()
            in_list = True
            line = line[item.end():]
        elif not line.startswith(" "):
            in_list = in_list and piece is not None
        if piece is None:
            piece = Piece("page")
        piece.add(number, line)
    close()
    return [without_code(piece) for piece in pieces]


def prose_of_man_page(text):
    """Of a man page (roff): what macros set in bold or italics is code, and so are lists of names and what stands between .nf and .fi."""
    pieces, piece, is_example = [], Piece("page"), False

    def add(number, words):
        if words.strip():
            piece.add(number, words)

    for number, line in enumerate(text.splitlines(), 1):
        macro, _, rest = line.partition(" ")
        if macro in (".SH", ".TP", ".PP", ".TH", ".nf", ".fi"):
            is_example = {".nf": True, ".fi": False}.get(macro, is_example)
            pieces.append(piece)
            piece = Piece("heading" if macro == ".SH" else "page")
            if macro == ".SH":
                piece.add(number, rest)
                pieces.append(piece)
                piece = Piece("page")
        elif is_example or line.startswith(('.\\"', ".B ")) and not piece.text:      # a function that is described below
            continue
        elif line.startswith("."):
            add(number, f"`{rest}`" + "." * rest.endswith("."))
        elif re.fullmatch(r"[\w, ]+[.]?", line) and "," in line and not re.search(r"\w \w", line):
            add(number, f"`{line}`.")
        else:
            add(number, re.sub(r"\\f[A-Z]|\\\(aq|\\", "", line))
    pieces.append(piece)
    return [without_code(piece) for piece in pieces if piece.text]


def prose_of(path):
    text = path.read_text()
    if path.name.endswith(".3.in"):
        return prose_of_man_page(text)
    return prose_of_cpp(text) if path.suffix in CPP else prose_of_page(text)
