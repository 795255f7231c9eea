"""The examples at the heads of headers, as C++ that a compiler checks.

    sources(ROOT)        # (the text of one source with all examples, how many headers have one)

An example is made of the lines of a header's comments, at the head or before a part, that are indented by three or more spaces. It
becomes a function in the namespace of its header. What an example uses and does not declare are parameters: those of GIVEN[name of the header], then of
COMMON, and each other value is of a type that converts to all others.
A line without `;` at its end is an expression; so are the parts of a line with four spaces between them. `…` stands for what a
reader fills in: a value after `=`, `(` or `,`, else statements. Errors of the compiler name the header and line (#line).
"""
import re

from examples_given import COMMON, DRAWINGS, FUNCTIONS, GIVEN

LINE = re.compile(r"//(\s{3,}\S.*)$")
TOKEN = re.compile(r'"(?:[^"\\]|\\.)*"|\'(?:[^\'\\]|\\.)+\'|//.*|/\*.*?\*/|\w+|\s+|.')
KEYWORDS = set("""auto bool break char class const constexpr continue default delete do double else enum explicit false float for if
    inline int long namespace new noexcept nullptr operator return short signed sizeof static struct switch template this throw true
    typename unsigned using void while""".split())
NAMESPACE = re.compile(r"^namespace (foresee[\w:]*) \{", re.M)

PRELUDE = """namespace foresee {
/// Stands for what a reader fills in: a value of any type, a function of any arguments.
struct Anything {
  template <class T>
  operator T&() const;
  template <class... T>
  Anything operator()(T&&...) const;
};
}  // namespace foresee
"""


def without_comment(line):
    return "".join(token for token in TOKEN.findall(line) if not token.startswith(("//", "/*"))).rstrip()


def blocks_of(text):
    """The blocks of indented lines in the comments of a header, as [(number of its first line, lines)]."""
    blocks, last = [], 0
    for number, line in enumerate(text.splitlines(), 1):
        if match := LINE.match(line):
            if last != number - 1:
                blocks.append((number, []))
            blocks[-1][1].append(match.group(1))
            last = number
    return blocks


def is_drawing(name, lines, *openings):
    return any(lines[0].strip().startswith(opening) for opening in openings or DRAWINGS.get(name, ()))


def fill(code):
    """`…` as a value or as nothing; an empty statement after if (…) and for (…)."""
    if code.strip() == "…":
        return ";"
    code = re.sub(r"([=(,]\s*)…", r"\1Anything{}", code)
    code = re.sub(r"\)\s*…\s*$", ") ;", code)
    return re.sub(r"…[^….;{}]*…;?|…;?", "", code)


def depth_after(code, depth):
    bare = "".join(token for token in TOKEN.findall(code) if token[0] not in "\"'")
    return depth + sum(map(bare.count, "([{")) - sum(map(bare.count, ")]}"))


def indent_of(line):
    return len(line) - len(line.lstrip())


def statements(lines):
    """The lines of a block as C++, one for each."""
    code, depth, indent, made = [fill(without_comment(line)) for line in lines], 0, 0, []
    for i, line in enumerate(code):
        if depth == 0:  # else the line goes on with what the line of `indent` has opened
            indent = indent_of(lines[i])
            line = re.sub(r"(?<=[^\s;{}(,=+|&])\s{4,}(?=\S)", "; ", line.lstrip())
        depth = depth_after(line, depth)
        following = code[i + 1] if i + 1 < len(code) else ""
        goes_on = depth > 0 or re.search(r"(?:[;{},(|&?:+=]|\bdo|\belse)$", line) or following and indent_of(following) > indent
        made.append(line if goes_on or not line.strip() else line + ";")
    return made


def examples_of(name, text):
    """[(first line, lines as C++)] of the blocks of a header that are code."""
    return [(number, statements(lines)) for number, lines in blocks_of(text) if not is_drawing(name, lines)]


def parameters(name, code):
    """The names that an example may use: those given for this header, then those of all; each other value is Anything."""
    code = re.sub(r"(?:\.|->|::)\s*\w+", " ", "".join(token for token in TOKEN.findall(code) if token[0] not in "\"'"))
    given = dict(GIVEN.get(name, {}))
    called = set(re.findall(r"\b\w+(?=\s*\()", code))
    values = set(re.findall(r"\b[a-z]\w*\b(?!\s*(?:[(<{]|::))|\b[a-z]\w*\b(?=\s*<[ =])", code)) - KEYWORDS
    for word in sorted(values | called & set(FUNCTIONS)):
        given.setdefault(word, COMMON.get(word, "Anything"))
    return ", ".join(f"{kind} {word}" for word, kind in given.items())


def function(name, path, number, examples, space):
    body = []
    for first, lines in examples:
        body.append(f'#line {first} "{path}"')
        body += lines
    code = "\n".join(body)
    place = f'#line 1 "the example of {path}, and examples_given.py"'
    given = parameters(name, re.sub(r"(?m)^#.*$", "", code))
    return (f"{place}\nnamespace {space} {{ namespace example_{number} {{\n"
            f"[[maybe_unused]] inline auto example({given}) {{\n{{\n{code}\n{place}\n}}\n}}\n}} }}\n")


def sources(root):
    """(text of a source with all examples, how many headers have one)."""
    includes, functions = [], []  # of all headers, as an example may use what stands beside its own
    for path in sorted((root / "ext").rglob("*.h")):
        text = path.read_text()
        includes.append(f'#include "{path.relative_to(root / "ext").as_posix()}"\n')
        if examples := examples_of(path.name, text):
            spaces = NAMESPACE.findall(text) or ["foresee"]
            functions.append(function(path.name, path.relative_to(root).as_posix(), len(functions), examples, spaces[-1]))
    return "".join(includes) + PRELUDE + "".join(functions), len(functions)
