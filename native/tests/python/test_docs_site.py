"""The documentation site's sources: what is made from sources has all of them, and links hold."""

from __future__ import annotations

import ast
import re
import subprocess
import sys
from pathlib import Path

import illustrate_native as ill
import pytest
from test_docs import ROOT, broken_links

DOCS = ROOT / "tools" / "docs"


def in_tools(program: str) -> str:
    """What a program prints that imports the scripts of tools/docs, on its own."""
    ran = subprocess.run(
        [sys.executable, "-c", program], cwd=DOCS, capture_output=True, text=True, check=False
    )
    assert ran.returncode == 0, ran.stderr
    return ran.stdout


@pytest.fixture(scope="module")
def site(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The sources of the site, without pictures of settings."""
    out = tmp_path_factory.mktemp("site") / "source"
    subprocess.run([sys.executable, str(DOCS / "site.py"), str(out), "--light"], check=True)
    return out


def test_links_of_the_site_hold(site: Path) -> None:
    pages = sorted(site.rglob("*.md"))
    assert len(pages) > 20
    broken = {
        page.relative_to(site).as_posix(): found
        for page in pages
        if (found := list(broken_links(page, page.read_text(encoding="utf-8"))))
    }
    assert not broken


def test_every_page_is_in_the_index(site: Path) -> None:
    index = (site / "index.md").read_text(encoding="utf-8")
    listed = set(re.findall(r"^([\w/-]+)$", index, re.MULTILINE))
    pages = {page.relative_to(site).with_suffix("").as_posix() for page in site.rglob("*.md")}
    assert pages - {"index"} == listed


def test_every_setting_has_a_picture_or_a_reason() -> None:
    program = """
import settings_list as lists
from addon_definitions import native_settings, own_settings
own = own_settings()
found = [native_settings(), own["Scene"], own["Objects and collections"]]
for known, listed in zip(found, (lists.NATIVE, lists.SCENE, lists.OBJECTS), strict=True):
    print(sorted(set(known) ^ set(listed)))
"""
    assert in_tools(program).split("\n")[:3] == ["[]", "[]", "[]"]


def test_settings_are_told_in_the_addons_words(site: Path) -> None:
    text = (site / "generated" / "settings.md").read_text(encoding="utf-8")
    assert "### Spacing\n\nDistance between neighbouring hatches, pixels of the render." in text
    assert "Default: 8. (`spacing_px`)" in text
    assert text.count("\n### ") > 95


def test_a_setting_that_shows_nothing_is_found() -> None:
    program = """
from settings_list import Effect
from settings_page import picture_of
try:
    picture_of("threads", Effect("ring", (("1", {"threads": 1}), ("2", {"threads": 2}))))
except ValueError as error:
    print(error)
assert picture_of("hatching", Effect("ring", (("on", {}), ("off", {"hatching": False}))))
"""
    assert "threads: two of its values give the same drawing" in in_tools(program)


def test_every_error_that_is_raised_is_a_message() -> None:
    program = "import messages_page as m\nfor each in m.messages(): print(repr(each.text))"
    listed = {ast.literal_eval(line) for line in in_tools(program).splitlines()}
    assert len(listed) > 80
    found = [
        (path.name, text)
        for path in sorted((ROOT / "addon").rglob("*.py"))
        for text in raised(path.read_text(encoding="utf-8"))
    ]
    assert len(found) > 10
    assert [each for each in found if each[1] not in listed] == []


def test_every_message_has_an_area() -> None:
    program = "import messages_page as m\n"
    program += "for each in m.messages(): print(m.area_of(each), each.file)"
    assert "Elsewhere" not in in_tools(program)


def raised(source: str) -> list[str]:
    """Texts of the errors for the artist that a file raises, as the page has them."""
    found = []
    for node in ast.walk(ast.parse(source)):
        if isinstance(node, ast.Call) and getattr(node.func, "id", "") == "IllustrateError":
            said = node.args[0]
            if isinstance(said, ast.Call) and getattr(said.func, "id", "") == "said":
                said = said.args[0]
            if isinstance(said, ast.Constant):
                found.append(re.sub(r"\{[^{}]+\}", "…", str(said.value)).strip())
    return [text for text in found if len(text.split()) >= 4]


def test_every_public_name_is_in_the_api(site: Path) -> None:
    text = (site / "generated" / "api.md").read_text(encoding="utf-8")
    assert not [name for name in ill.__all__ if f"### {name}\n" not in text]
    assert "line\\_width\\_px" not in text.split("### DrawOptions")[1].split("`line_width_px`")[0]
    assert "Of silhouettes and boundaries." in text


@pytest.mark.skipif(sys.platform == "win32", reason="tools are shell scripts")
def test_make_help_names_every_target() -> None:
    told = subprocess.run(
        [str(ROOT / "tools" / "help.sh")], capture_output=True, text=True, check=True
    ).stdout
    targets = re.findall(r"^([a-z-]+):", (ROOT / "Makefile").read_text(), re.MULTILINE)
    lines = dict(line.removeprefix("make ").split(maxsplit=1) for line in told.splitlines())
    assert sorted(lines) == sorted(targets)
