"""The one-definition rule: in a namespace, a name stands for one type or one function.

Two types of one name in files that do not include each other compile and link; the linker then
keeps one destructor of the two, and a build without optimisation frees the wrong members. Of two
inline functions it keeps one as well. All of native/ counts as one program: the stages, the
bindings, the C++ tests and the fuzzer. What stands in an anonymous namespace belongs to its file
alone.
"""

from __future__ import annotations

import re
from collections import defaultdict
from collections.abc import Iterator, Mapping
from pathlib import Path

import pytest

NATIVE = Path(__file__).resolve().parents[2]

# Comments, strings, characters (but not the ' of 1'000), empty defaults and what is for the
# preprocessor.
NO_CODE = re.compile(
    r"""//[^\n]* | /\*.*?\*/ | R"(\w*)\(.*?\)\1" | "(?:\\.|[^"\\\n])*"
      | (?<!\w)'(?:\\.|[^'\\\n])+' | =\s*\{\s*\} | ^[ \t]*\#(?:\\\n|[^\n])*""",
    re.DOTALL | re.MULTILINE | re.VERBOSE,
)
NAMESPACE = re.compile(r"\bnamespace\s*([\w:]*)\s*$")
# What stands before the brace of a type, and before the semicolon of an alias.
TYPE = re.compile(
    r"\b(?:struct|class|union|enum(?:\s+(?:class|struct))?)\s+"
    r"(?:alignas\s*\([^)]*\)\s*|\[\[[^\]]*\]\]\s*)*((?:\w+::)*\w+)\s*(?:final\s*)?(?::(?!:)[^{]*)?$"
)
ALIAS = re.compile(r"\busing\s+(\w+)\s*=|\btypedef\b.*\b(\w+)\s*$", re.DOTALL)

# Return type and name before a list of parameters: no call, and no type of a function.
FUNCTION = re.compile(
    r"(?:^|[\s&*])(operator\s*(?:\(\)|\W+?)|[\w:~]+)\s*\(((?:[^()]|\([^()]*\))*)\)", re.DOTALL
)
PARAMETER_NAME = re.compile(r"(?<=[\s&*])\w+$")


def statements(text: str) -> Iterator[tuple[tuple[str, ...], str, str]]:
    """What stands directly in a namespace, up to its brace or semicolon.

    Each as the namespaces round it (anonymous: ""), its text and the mark that ends it.
    """
    namespaces: list[str] = []
    head, depth = "", 0  # depth: of braces that are no namespace's
    for token in re.split(r"([{};])", NO_CODE.sub(" ", text)):
        opens = NAMESPACE.search(head) if token == "{" and not depth else None
        if token not in ("{", "}", ";"):
            head = token
        elif opens:
            namespaces.append(opens[1])
        elif token == "}" and not depth:
            namespaces.pop()
        else:
            if not depth:
                yield tuple(namespaces), head, token
            depth += {"{": 1, "}": -1, ";": 0}[token]
    assert not namespaces and not depth, "braces without a partner"


def signature(head: str) -> str | None:
    """Name and types of the parameters of the function that `head` begins, if it does."""
    found = FUNCTION.search(head)
    if not found or re.search(r"\bstatic\b", head):
        return None
    parameters = [part.partition("=")[0].strip() for part in found[2].split(",")]
    types = [PARAMETER_NAME.sub("", part).strip() for part in parameters]
    return f"{found[1]}({', '.join(' '.join(part.split()) for part in types)})"


def definitions(text: str) -> Iterator[str]:
    """Full names of the types and functions that a file defines for the whole program."""
    for namespaces, head, end in statements(text):
        found = (TYPE if end == "{" else ALIAS).search(head)
        name = found[found.lastindex or 1] if found else signature(head) if end == "{" else None
        if name and "" not in namespaces:
            yield "::".join([*namespaces, name])


def double_definitions(texts: Mapping[str, str]) -> list[str]:
    """Names defined in more than one file, with the files. texts: of each file, by name."""
    places = defaultdict(list)
    for file, text in texts.items():
        for name in sorted(set(definitions(text))):
            places[name].append(file)
    return [f"{name}: {', '.join(files)}" for name, files in places.items() if len(files) > 1]


def sources() -> dict[str, str]:
    return {
        path.relative_to(NATIVE).as_posix(): path.read_text(encoding="utf-8")
        for path in sorted(NATIVE.rglob("*"))
        if path.suffix in (".h", ".cpp")
    }


def test_each_type_and_function_is_defined_once() -> None:
    wrong = double_definitions(sources())
    assert not wrong, "\n".join(wrong)


def test_the_definitions_of_a_file_are_found() -> None:
    text = """
    #include "a.h"  // struct Comment {};
    namespace illustrate {
    struct Forward;
    enum class Kind : int { sharp, smooth };
    using Points = std::vector<Vec3>;
    template <class T>
    class Tree final : public Base<T> {
      struct Node { int first; };
      using Nodes = std::vector<Node>;
      const char* brace() const { return "{"; }
    };
    template <> struct Hash<Kind> {};
    struct Tree::Walk { int at; };
    inline char quote() { struct Local {}; return '{'; }
    int count = 1'000'000;
    double length(const Points& points, int first = 0);
    double length(const Points& points, std::array<int, 2> ends = {}) { return count; }
    Tree::Tree(int size) : size_(size) {}
    bool operator==(const Kind& a, const Kind& b) { return true; }
    static void own(int a) {}
    namespace { struct Own {}; }
    namespace detail { struct Part {}; }
    }  // namespace illustrate
    """
    types = ["Kind", "Points", "Tree", "Tree::Walk", "detail::Part"]
    functions = [
        "quote()",
        "length(const Points&, std::array<int, 2>)",
        "Tree::Tree(int)",
        "operator==(const Kind&, const Kind&)",
    ]
    names = [*types[:4], *functions, types[4]]
    assert list(definitions(text)) == [f"illustrate::{name}" for name in names]


@pytest.mark.parametrize(
    ("first", "second"),
    [
        ("struct Joints { int nodes; };", "struct Joints { int partners; };"),
        ("enum class Crossing { apart, segment };", "struct Crossing { int front; };"),
        ("struct Run { int first; };", "using Run = int;"),
        ("class Walk final : public Path {};", "template <class T> struct Walk {};"),
        ("inline int turn(int a) { return a; }", "inline int turn(int b) { return -b; }"),
        ("template <class T> T cube(T x) { return x; }", "double cube(T) { return 0; }"),
        ("typedef int Index;", "enum Index { none };"),
    ],
)
def test_a_double_definition_is_found(first: str, second: str) -> None:
    texts = {"mesh/a.h": first, "contour/b.cpp": second}
    inside = {file: f"namespace illustrate {{\n{text}\n}}\n" for file, text in texts.items()}
    assert double_definitions(inside) == [
        f"{name}: mesh/a.h, contour/b.cpp" for name in definitions(inside["mesh/a.h"])
    ]
    inside["contour/b.cpp"] = f"namespace illustrate {{ namespace {{\n{second}\n}} }}\n"
    assert not double_definitions(inside)
