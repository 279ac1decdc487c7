"""All that the add-on shows: labels and tooltips of operators, panels, menus and properties, and
messages: reports, errors, warnings, and why a button is grey."""

import ast
import pathlib
from collections.abc import Iterator
from typing import Any

import bpy
import illustrate
from illustrate import native
from illustrate.reading import instances
from illustrate.running import remarks, tasks

GROUPS = ("PropertyGroup", "AddonPreferences")
ON_MANAGER = "illustrate_"
SHOWN_BY_CODE = {"text", "title", "heading"}
SAYING = {"IllustrateError": 0, "report": 1, "poll_message_set": 0, "show_text": 1}
"""Calls that show a text, and which of their arguments it is."""
LEVELS = {"INFO", "WARNING", "ERROR"}
COMMAND_LINE = {"farm/frames.py", "farm/main.py", "farm/plots.py"}  # it speaks English


def registered() -> Iterator[Any]:
    """The classes of the add-on that Blender knows."""
    for name in dir(bpy.types):
        if name.startswith("ILLUSTRATE_"):
            yield getattr(bpy.types, name)
    for base in (bpy.types.PropertyGroup, bpy.types.AddonPreferences):  # not listed there
        for kind in base.__subclasses__():
            if kind.__name__.startswith("ILLUSTRATE_") and kind.is_registered:
                yield kind


def properties() -> Iterator[tuple[str, Any]]:
    """The settings, with the names of their owners."""
    for kind in registered():
        if any(base.__name__ in (*GROUPS, "Operator") for base in kind.__mro__):
            for prop in kind.bl_rna.properties:
                if prop.identifier not in ("rna_type", "name") and _is_own(kind, prop.identifier):
                    yield kind.__name__, prop
    for prop in bpy.types.WindowManager.bl_rna.properties:
        if prop.identifier.startswith(ON_MANAGER):
            yield "WindowManager", prop


def _is_own(kind: Any, name: str) -> bool:
    return any(name in getattr(base, "__annotations__", {}) for base in kind.__mro__)


def sources() -> Iterator[tuple[str, ast.Module]]:
    """The add-on's modules, by the ends of their paths."""
    folder = pathlib.Path(illustrate.__file__).parent
    for path in sorted(folder.rglob("*.py")):
        if "illustrate_native" not in path.parts:
            name = path.relative_to(folder).as_posix()
            yield name, ast.parse(path.read_text(encoding="utf-8"))


def labels() -> Iterator[str]:
    """Texts of code: what `text=` says to a layout, without what has figures in it."""
    for _, tree in sources():
        for node in ast.walk(tree):
            if isinstance(node, ast.keyword) and node.arg in SHOWN_BY_CODE:
                yield from _text_of(node.value)


def messages() -> Iterator[str]:
    """What code hands to `said` and `amount`, and the tables that it takes it from."""
    for _, tree in sources():
        named = {
            target.id: node.value
            for node in ast.walk(tree)
            if isinstance(node, ast.Assign)
            for target in node.targets
            if isinstance(target, ast.Name)
        }
        for node in ast.walk(tree):
            if isinstance(node, ast.Call) and _called(node) == "said":
                text = node.args[0]
                yield from _text_of(named.get(getattr(text, "id", ""), text))
            elif isinstance(node, ast.Call) and _called(node) == "amount":
                words = [word for part in node.args[1:] for word in _text_of(part)]
                yield from words
                yield from (word + "s" for word in words if len(words) == 1)
    for kind in (*instances.WITHOUT_SURFACE.values(), instances.STRANDS, instances.WITHOUT_FACES):
        yield from (kind, remarks.plural_of(kind))
    yield from tasks.STAGES.values()
    yield from remarks.REPAIRS.values()
    for kind in native.load().Kind.__members__:
        yield kind.capitalize().replace("_", " ")


def unsaid() -> Iterator[str]:
    """Messages of code that no translation reaches: texts as they are, where `said` is missing."""
    for name, tree in sources():
        for node in ast.walk(tree) if name not in COMMAND_LINE else ():
            for each in _shown(node):
                if isinstance(each, ast.JoinedStr) or any(_text_of(each)):
                    yield f"{name}:{each.lineno}"


def _shown(node: ast.AST) -> list[ast.expr]:
    """What a piece of code shows: in a call, or as a report, which is a level and a text."""
    if isinstance(node, ast.Call) and _called(node) in SAYING:
        place = SAYING[_called(node)]
        return node.args[place : place + 1]
    if isinstance(node, ast.Tuple) and len(node.elts) > 1 and LEVELS & {*_text_of(node.elts[0])}:
        return node.elts[1:]
    return []


def _called(call: ast.Call) -> str:
    return str(getattr(call.func, "id", getattr(call.func, "attr", "")))


def _text_of(node: ast.AST) -> Iterator[str]:
    if isinstance(node, ast.Constant) and isinstance(node.value, str):
        yield node.value


def all_texts() -> set[str]:
    """Every text that Blender would translate."""
    found: set[str] = {*labels(), *messages()}
    for kind in registered():
        if issubclass(kind, bpy.types.Menu) and hasattr(kind, "preset_subdir"):
            continue  # Blender labels the menu after the preset that was chosen last
        found |= {getattr(kind, name, "") for name in ("bl_label", "bl_description")}
    for _, prop in properties():
        if prop.is_hidden:
            continue
        found |= {prop.name, prop.description}
        items = getattr(prop, "enum_items_static", ()) if prop.type == "ENUM" else ()
        found |= {text for item in items for text in (item.name, item.description)}
    return {text for text in found if any(letter.isalpha() for letter in text)}
