"""The interface in other languages: a table for each, handed to Blender.

To add a language, add its table to the folder languages: a line for each text, English, a tab, and
the other language. What is not in it is shown in English; a test names what is missing.
"""

import functools
import pathlib

import bpy

FOLDER = pathlib.Path(__file__).parent / "languages"
TABLES = {"de_DE": "german", "de": "german"}
"""The table of each of Blender's languages; some have another name from 4.0 on."""
# Blender looks the names of operators up in a context of their own, all else in "*".
CONTEXTS = ("*", "Operator")


@functools.cache
def texts(name: str) -> dict[str, str]:
    """A table: the texts of a language by the English ones."""
    lines = (FOLDER / f"{name}.tsv").read_text(encoding="utf-8").splitlines()
    return dict(line.split("\t") for line in lines if line)


def table() -> dict[str, dict[tuple[str, str], str]]:
    """All tables as Blender takes them."""
    return {
        locale: {
            (context, text): words for context in CONTEXTS for text, words in texts(name).items()
        }
        for locale, name in TABLES.items()
    }


def register() -> None:
    """Hands the tables to Blender."""
    bpy.app.translations.register(__package__, table())


def unregister() -> None:
    """Takes them back."""
    bpy.app.translations.unregister(__package__)
