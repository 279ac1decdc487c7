"""Errors and messages, in words for the artist."""


class IllustrateError(Exception):
    """The drawing cannot be made or written: the message names the thing and the way out."""


def quoted(names: list[str], most: int = 5) -> str:
    """Names in quotes, the first few of many."""
    shown = ", ".join(f'"{name}"' for name in names[:most])
    return shown + (f" and {len(names) - most} more" if len(names) > most else "")


def counted(count: int, noun: str, plural: str = "") -> str:
    """Such as '1 mesh' or '2 meshes'; the plural is the noun with an s where none is given."""
    return f"{count} {noun if count == 1 else plural or noun + 's'}"
