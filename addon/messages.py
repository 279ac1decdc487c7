"""Errors and messages, in words for the artist, and in the language of Blender's interface.

Texts that an artist reads go through `said` or `amount`; a test finds those that do not, and those
that a language lacks. What a command line says is English.
"""

from typing import Any

import bpy


class IllustrateError(Exception):
    """The drawing cannot be made or written: the message names the thing and the way out."""


def said(text: str, **values: Any) -> str:
    """A text in the language of the interface, with `values` where their names stand in braces."""
    found = bpy.app.translations
    # Reports have a function of their own from 4.1 on.
    is_new = hasattr(found, "pgettext_rpt")
    words: str = found.pgettext_rpt(text) if is_new else found.pgettext_tip(text)
    return words.format(**values) if values else words


def quoted(names: list[str], most: int = 5) -> str:
    """Names in quotes, the first few of many."""
    shown = ", ".join(f'"{name}"' for name in names[:most])
    more = len(names) - most
    return said("{names} and {more} more", names=shown, more=more) if more > 0 else shown


def amount(count: int, noun: str, plural: str = "") -> str:
    """The same as `counted` in the language of the interface."""
    return f"{count} {said(noun if count == 1 else plural or noun + 's')}"


def counted(count: int, noun: str, plural: str = "") -> str:
    """Such as '1 mesh' or '2 meshes'; the plural is the noun with an s where none is given."""
    return f"{count} {noun if count == 1 else plural or noun + 's'}"
