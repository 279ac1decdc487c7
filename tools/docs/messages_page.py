"""The page of every message that the add-on can show, read from its source."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from paths import ROOT

ADDON = ROOT / "addon"
PLOT = ROOT / "native" / "illustrate_native" / "plot"  # its errors are shown as they are
DEFINITIONS = {
    "native_options.py",
    "option_kinds.py",
    "scene_settings.py",
    "settings.py",
    "styles.py",
}
FILLED_IN = re.compile(r"\{[^{}]+\}")
FEWEST_WORDS = 4  # fewer are names and parts of names
LABELS = {"description", "name", "help", "text", "bl_description", "prog", "usage", "epilog"}
AREAS = {
    "Before a drawing": ("native.py", "ui/", "running/problems.py", "reading/scene.py"),
    "Drawing": ("running/illustration.py", "running/operators.py", "running/tasks.py"),
    "After a drawing": ("running/remarks.py",),
    "Images, lights and renders": ("reading/", "running/rendering.py"),
    "In the viewport": ("viewport/",),
    "Writing": ("output/", "messages.py"),
    "Animation": ("running/bake.py",),
    "Plots": ("plot/",),
    "The command, farms": ("farm/", "headless.py"),
}
INTRODUCTION = """Messages name the thing and say what to do; what stands for names and numbers
here is **…**. The command says the same words as the panel and the status bar.
"""


@dataclass(frozen=True)
class Message:
    """What is shown, with … for what is filled in, and the file that says it."""

    file: str
    text: str


def words_of(node: ast.AST) -> str | None:
    """The text of a string, with … for what is filled in; None for anything else."""
    if isinstance(node, ast.Constant) and isinstance(node.value, str):
        return FILLED_IN.sub("…", node.value)
    if isinstance(node, ast.JoinedStr):
        return "".join(words_of(part) or "…" for part in node.values)
    return None


def _inner(tree: ast.AST) -> Iterator[ast.AST]:
    """Nodes of function bodies, without documentation, labels and parts of other strings."""
    for node in ast.iter_child_nodes(tree):
        is_documentation = isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant)
        if is_documentation or (isinstance(node, ast.keyword) and node.arg in LABELS):
            continue
        yield node
        if not isinstance(node, ast.JoinedStr):
            yield from _inner(node)


def messages_in(file: str, source: str) -> Iterator[Message]:
    """Of one file, in their order."""
    functions = (node for node in ast.walk(ast.parse(source)) if isinstance(node, ast.FunctionDef))
    seen: set[str] = set()
    for function in functions:
        for statement in function.body:
            for node in _inner(ast.Module([statement], [])):
                text = words_of(node)
                if text and len(text.split()) >= FEWEST_WORDS and text not in seen:
                    seen.add(text)
                    yield Message(file, text.strip())


def messages() -> list[Message]:
    """Of the whole add-on."""
    files = [
        path
        for path in sorted(ADDON.rglob("*.py"))
        if "presets" not in path.parts and path.name not in DEFINITIONS
    ]
    found = [
        message
        for path in files
        for message in messages_in(path.relative_to(ADDON).as_posix(), _source(path))
    ]
    return [*found, *errors_of_plots()]


def errors_of_plots() -> Iterator[Message]:
    """What the plots' own module refuses."""
    for path in sorted(PLOT.glob("*.py")):
        for node in ast.walk(ast.parse(_source(path))):
            if not isinstance(node, ast.Raise) or node.exc is None:
                continue
            for part in _inner(node.exc):
                text = words_of(part)
                if text and len(text.split()) >= FEWEST_WORDS:
                    yield Message(f"plot/{path.name}", text.strip())


def _source(path: Path) -> str:
    return path.read_text(encoding="utf-8")


def area_of(message: Message) -> str:
    """The heading that a message stands under."""
    for area, files in AREAS.items():
        if message.file.startswith(files):
            return area
    return "Elsewhere"


def page() -> str:
    """MyST text of the page."""
    found = messages()
    lines = ["# Every message\n", INTRODUCTION]
    for area in (*AREAS, "Elsewhere"):
        chosen = [message for message in found if area_of(message) == area]
        if chosen:
            lines += [f"## {area}\n", "| message | from |", "|---|---|"]
            lines += [f"| {_cell(message.text)} | `{message.file}` |" for message in chosen]
            lines.append("")
    return "\n".join(lines)


def _cell(text: str) -> str:
    """Text for a table, without marks of MyST."""
    for mark in "\\`*_{}[]<>|#$":
        text = text.replace(mark, f"\\{mark}")
    return text.replace("\n", " ")
