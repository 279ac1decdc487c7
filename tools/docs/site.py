"""Puts the sources of the documentation site together, for Sphinx.

    .venv/bin/python tools/docs/site.py OUT [--light]

Pages keep their places, so that links between them hold; links to files that are no pages become
plain words. Settings, messages and the Python API are made from their sources. --light: without the
pictures of settings.
"""

from __future__ import annotations

import argparse
import re
import shutil
from pathlib import Path

import api_page
import messages_page
from paths import ROOT

TOP = ("README.md", "CHANGELOG.md", "CONTRIBUTING.md", "native/README.md", "examples/README.md")
PICTURES = ("docs/pictures", "docs/gallery")
LINK = re.compile(r"(?<!!)\[([^\]]+)\]\(([^)\s]+)\)")


def pages() -> dict[str, Path]:
    """(path in the site) the file that each page is."""
    found = {name: ROOT / name for name in TOP}
    for page in sorted((ROOT / "docs").glob("*.md")):
        found[f"docs/{page.name}"] = page
    found["index.md"] = ROOT / "docs" / "site" / "index.md"
    return found


def with_links(text: str, page: str, known: set[str]) -> str:
    """A page whose links lead to other pages of the site; those to other files are words."""

    def replaced(match: re.Match[str]) -> str:
        words, target = match.groups()
        file = target.partition("#")[0]
        if re.match(r"\w+:", target) or not file:
            return match[0]
        aim = (ROOT / page).parent.joinpath(file).resolve()
        inside = aim.relative_to(ROOT).as_posix() if aim.is_relative_to(ROOT) else ""
        if inside == "docs":
            return f"[{words}]({target.rstrip('/')}/README.md)"
        return match[0] if inside in known else words

    return LINK.sub(replaced, text)


def put_together(out: Path, light: bool) -> None:
    """Writes the sources of the site to a new folder."""
    shutil.rmtree(out, ignore_errors=True)
    generated = out / "generated"
    (generated / "settings").mkdir(parents=True)
    found = pages()
    known = {*found, "generated/settings.md", "generated/messages.md", "generated/api.md"}
    for name, file in found.items():
        (out / name).parent.mkdir(parents=True, exist_ok=True)
        text = file.read_text(encoding="utf-8")
        (out / name).write_text(with_links(text, name, known), encoding="utf-8")
    for folder in PICTURES:
        shutil.copytree(ROOT / folder, out / folder)
    for name in ("conf.py", "site.css"):
        shutil.copy(ROOT / "docs" / "site" / name, out)
    (generated / "messages.md").write_text(messages_page.page(), encoding="utf-8")
    (generated / "api.md").write_text(api_page.page(), encoding="utf-8")
    import settings_page  # draws: not needed by those who only check links

    pictures = None if light else generated / "settings"
    (generated / "settings.md").write_text(settings_page.page(pictures), encoding="utf-8")


def main() -> None:
    """Reads the command line."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("out", type=Path)
    parser.add_argument("--light", action="store_true", help="without the pictures of settings")
    arguments = parser.parse_args()
    put_together(arguments.out, arguments.light)


if __name__ == "__main__":
    main()
