"""Which of a scene's data the add-on made and may replace. Everything else is the artist's."""

from typing import Any

MARK = "illustrate_owner"


def is_ours(thing: Any) -> bool:
    """True for objects and materials that the add-on made."""
    return bool(thing.get(MARK))


def may_replace(thing: Any) -> bool:
    """The same, but for what is linked from another file and not of this one to change."""
    linked = (thing.library, thing.override_library)
    return is_ours(thing) and not any(linked)


def mark(*things: Any) -> None:
    """Makes objects, their data and materials the add-on's own."""
    for thing in things:
        thing[MARK] = True
