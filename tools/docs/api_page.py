"""The page of the Python API, from the docstrings of the stub and of the Python files."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from dataclasses import dataclass

from paths import ROOT

PACKAGE = ROOT / "native" / "illustrate_native"


@dataclass(frozen=True)
class Module:
    """A module of the package, and which of its names are shown; empty: the public ones."""

    file: str
    title: str
    names: tuple[str, ...] = ()


MODULES = (
    Module("_core.pyi", "illustrate_native"),
    Module("sequence.py", "illustrate_native", ("draw_sequence",)),
    Module("millimetres.py", "illustrate_native", ("lengths_in_pixels",)),
    Module("svg.py", "illustrate_native.svg", ("to_svg", "read_made_by")),
    Module("drawing_json.py", "illustrate_native.drawing_json"),
    Module("png.py", "illustrate_native.png"),
    Module("field_svg.py", "illustrate_native.field_svg", ("field_to_svg",)),
    Module("debug.py", "illustrate_native.debug"),
    Module("plot/plans.py", "illustrate_native.plot"),
    Module("plot/pages.py", "illustrate_native.plot"),
    Module("plot/pens.py", "illustrate_native.plot"),
    Module("plot/order.py", "illustrate_native.plot"),
    Module("plot/regions.py", "illustrate_native.plot"),
)
Definition = ast.ClassDef | ast.FunctionDef


def signature(node: ast.FunctionDef) -> str:
    """A function's first lines as Python has them, without its body."""
    head = ast.FunctionDef(
        name=node.name, args=node.args, body=[], decorator_list=[], returns=node.returns
    )  # fmt: skip
    return ast.unparse(ast.fix_missing_locations(head)).strip().removesuffix(":")


def _text(node: Definition) -> str:
    """Its docstring, with sections as lists: what MyST shows as it is read."""
    text = ast.get_docstring(node) or ""
    lines = []
    for line in text.splitlines():
        if line.strip() in ("Args:", "Returns:", "Raises:"):
            lines += ["", f"**{line.strip().removesuffix(':')}**", ""]
        elif line.startswith("    ") and not line.startswith("     "):
            lines.append(f"- {line.strip()}")
        elif line.startswith("     "):
            lines.append(f"  {line.strip()}")
        else:
            lines.append(line)
    return _plain("\n".join(lines))


def _plain(text: str) -> str:
    """Marks of MyST that stand for themselves, but for those of headings and lists."""
    for mark in "<|_":
        text = text.replace(mark, f"\\{mark}")
    return text


def _fields(node: ast.ClassDef) -> Iterator[str]:
    """Attributes and properties: a row of a table each."""
    body = node.body
    for at, part in enumerate(body):
        if isinstance(part, ast.AnnAssign) and isinstance(part.target, ast.Name):
            after = body[at + 1] if at + 1 < len(body) else None
            told = ""
            if isinstance(after, ast.Expr) and isinstance(after.value, ast.Constant):
                told = str(after.value.value)
            yield _row(part.target.id, told)
        elif isinstance(part, ast.Assign) and isinstance(part.targets[0], ast.Name):
            yield _row(part.targets[0].id, "")
        elif isinstance(part, ast.FunctionDef) and _is_property(part):
            yield _row(part.name, ast.get_docstring(part) or "")


def _is_property(node: ast.FunctionDef) -> bool:
    return any(isinstance(d, ast.Name) and d.id == "property" for d in node.decorator_list)


def _is_setter(node: ast.FunctionDef) -> bool:
    return any(isinstance(d, ast.Attribute) for d in node.decorator_list)


def _row(name: str, told: str) -> str:
    words = " ".join(told.split())
    return f"| `{name}` | {_plain(words)} |"


def entries(node: Definition, depth: int) -> Iterator[str]:
    """Heading, signature, text and members of a definition."""
    yield f"{'#' * depth} {node.name.strip('_') if depth > 3 else node.name}\n"
    if isinstance(node, ast.FunctionDef):
        yield f"```python\n{signature(node)}\n```\n"
        yield _text(node) + "\n"
        return
    yield _text(node) + "\n"
    rows = list(_fields(node))
    if rows:
        yield "\n".join(["| | |", "|---|---|", *rows]) + "\n"
    for part in node.body:
        if not isinstance(part, ast.FunctionDef) or _is_property(part) or _is_setter(part):
            continue
        told = ast.get_docstring(part) or ""
        if part.name == "__init__" and "Args:" not in told:
            continue
        if part.name == "__init__" or not part.name.startswith("_"):
            yield f"```python\n{signature(part).replace('__init__', node.name)}\n```\n"
            yield _text(part) + "\n"


def definitions(module: Module) -> Iterator[Definition]:
    """What of a module is shown."""
    tree = ast.parse((PACKAGE / module.file).read_text(encoding="utf-8"))
    for node in tree.body:
        if not isinstance(node, Definition) or node.name.startswith("_"):
            continue
        if not module.names or node.name in module.names:
            yield node


def page() -> str:
    """MyST text of the page."""
    lines = ["# Python API\n"]
    title = ""
    for module in MODULES:
        if module.title != title:
            title = module.title
            lines.append(f"## {title}\n")
        for node in definitions(module):
            lines += entries(node, 3)
    return "\n".join(lines)
