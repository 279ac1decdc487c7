"""Pages and workflows name what is there: files, links, sections, targets of make."""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import cache
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[3]
FOLDERS = ("docs", "native", "addon", "examples", "farm", "tools", "blender_tests", ".github")
SITE = ROOT / "docs" / "site"  # whose first page stands elsewhere: test_docs_site follows it
PAGES = sorted(
    page
    for page in [*ROOT.glob("*.md"), *(p for f in FOLDERS for p in (ROOT / f).rglob("*.md"))]
    if page.parent != SITE
)
NAMES = [page.relative_to(ROOT).as_posix() for page in PAGES]

WORKFLOWS = sorted((ROOT / ".github" / "workflows").glob("*.yml"))

FENCE = re.compile(r"^```.*?^```", re.DOTALL | re.MULTILINE)
CODE = re.compile(r"`([^`\n]+)`")
LINK = re.compile(r"\]\(([^)\s]+)\)")
HEADING = re.compile(r"^#+ (.+)$", re.MULTILINE)
SUFFIXES = "h|cpp|py|pyi|sh|js|yaml|yml|toml|txt|json|md|in|map"
# A file in code marks: with its folder or without, or a pair such as `arcs.{h,cpp}`.
FILE = re.compile(rf"^[\w./-]+\.(?:{SUFFIXES}|\{{h,cpp\}})$")
# A number at its source, such as `repairs.cpp: twist_px`.
CONSTANT = re.compile(r"`([\w./]+\.(?:h|cpp|py)): (\w+)`")
# A work by an author and its year: "Woop et al. 2013", "Greene, Kass and Miller (1993)".
CITED = re.compile(
    r"\b([A-Z][\w-]+)(?: et al\.|(?:,? (?:and |& )?[A-Z][\w-]+)*),? \(?((?:19|20)\d\d)\b"
)
NO_AUTHORS = {"SIGGRAPH", "Gems", "Blender"}  # names that have years, too
# Files that a page tells the reader to make, or that others keep.
NOT_OURS = {"blender_manifest.toml", "drawing.json", "index.json", "config.json"}


@cache
def tracked() -> frozenset[str]:
    """All files of the checkout but what is built, by their path from the root."""
    left_out = {"build", "out", "dist", ".venv", ".git", "sources", "wheelhouse"}
    return frozenset(
        path.relative_to(ROOT).as_posix()
        for top in ROOT.iterdir()
        if top.name not in left_out
        for path in ([top] if top.is_file() else top.rglob("*"))
    )


def is_there(name: str) -> bool:
    """Whether a file of that name, or with that end of its path, is in the checkout.

    Installed, the package of addon/ is called illustrate.
    """
    name = re.sub(r"^illustrate/", "addon/", name)
    return any(path == name or path.endswith(f"/{name}") for path in tracked())


def files_named(text: str) -> Iterator[str]:
    """Files that a page names in code marks."""
    for words in CODE.findall(FENCE.sub("", text)):
        if not FILE.match(words) or words.startswith("/") or words in NOT_OURS:
            continue
        base = words.removesuffix(".{h,cpp}")
        yield from [words] if base == words else [f"{base}.h", f"{base}.cpp"]


def anchors(text: str) -> set[str]:
    """Of the headings of a page, as the hosts of repositories make them."""
    kept = (re.sub(r"[^\w\- ]", "", heading.lower()) for heading in HEADING.findall(text))
    return {heading.strip().replace(" ", "-") for heading in kept}


def broken_links(page: Path, text: str) -> Iterator[str]:
    """Links of a page to files or sections that are not there."""
    for target in LINK.findall(FENCE.sub("", text)):
        if re.match(r"\w+:", target):
            continue
        file, _, section = target.partition("#")
        aim = (page.parent / file).resolve() if file else page
        if not aim.exists() or (
            section and section not in anchors(aim.read_text(encoding="utf-8"))
        ):
            yield target


@pytest.mark.parametrize("page", PAGES, ids=NAMES)
def test_links_lead_somewhere(page: Path) -> None:
    assert not list(broken_links(page, page.read_text(encoding="utf-8")))


@pytest.mark.parametrize("page", PAGES, ids=NAMES)
def test_files_named_are_there(page: Path) -> None:
    named = sorted(set(files_named(page.read_text(encoding="utf-8"))))
    assert not [name for name in named if not is_there(name)]


@pytest.mark.parametrize("page", PAGES, ids=NAMES)
def test_numbers_stand_where_the_page_says(page: Path) -> None:
    for file, name in CONSTANT.findall(page.read_text(encoding="utf-8")):
        sources = [ROOT / path for path in tracked() if path.endswith(f"/{file}")]
        assert any(
            re.search(rf"\b{name}\b", source.read_text(encoding="utf-8")) for source in sources
        ), f"{file}: {name}"


@cache
def targets() -> set[str]:
    """Of the Makefile."""
    return set(re.findall(r"^([\w-]+):", (ROOT / "Makefile").read_text(), re.MULTILINE))


@pytest.mark.parametrize("page", PAGES, ids=NAMES)
def test_targets_of_make_are_there(page: Path) -> None:
    text = page.read_text(encoding="utf-8")
    named = re.findall(r"`make ([\w-]+)`|^make ([\w-]+)", text, re.MULTILINE)
    assert not {a or b for a, b in named} - targets()


@pytest.mark.parametrize("path", WORKFLOWS, ids=lambda path: path.stem)
def test_workflows_install_make_and_call_its_targets(path: Path) -> None:
    for job in re.split(r"^  (?=\w+:$)", path.read_text(encoding="utf-8"), flags=re.MULTILINE)[1:]:
        rows = re.findall(r"^ +target: \[(.+)\]$", job, re.MULTILINE)
        chosen = {name for row in rows for name in row.split(", ")}
        called = set(re.findall(r"run: make ([\w-]+)$", job, re.MULTILINE)) | chosen
        assert called <= targets()
        # Bare images have none.
        assert not called or re.search(r"install(?s:.)*? make ", job.partition("run: make")[0])


def test_every_page_is_reached_from_the_first() -> None:
    found, waiting = set(), [ROOT / "README.md", ROOT / "docs" / "README.md"]
    while waiting:
        page = waiting.pop()
        if page in found or page.suffix != ".md":
            continue
        found.add(page)
        targets = LINK.findall(page.read_text(encoding="utf-8"))
        files = [(page.parent / t.partition("#")[0]).resolve() for t in targets if ":" not in t]
        waiting += [file for file in files if file.is_file()]
    assert not sorted(set((ROOT / "docs").glob("*.md")) - found)


def works_cited(text: str) -> set[tuple[str, str]]:
    """Authors and years of the works that a text cites."""
    plain = re.sub(r"\s+(?://|#)?\s*", " ", text)
    return {(name, year) for name, year in CITED.findall(plain) if name not in NO_AUTHORS}


def test_every_work_cited_is_in_the_references() -> None:
    page = ROOT / "docs" / "references.md"
    rows = page.read_text(encoding="utf-8").splitlines()
    texts = [*PAGES, *(ROOT / "native").rglob("*.h"), *(ROOT / "native").rglob("*.cpp")]
    texts += (ROOT / "native" / "illustrate_native").rglob("*.py")
    cited = {
        work for path in texts if path != page for work in works_cited(path.read_text("utf-8"))
    }
    assert len(cited) > 15
    assert not [
        (name, year)
        for name, year in sorted(cited)
        if not any(name in row and f"({year})" in row for row in rows)
    ]


def test_every_picture_is_shown() -> None:
    shown = {
        (page.parent / target).resolve()
        for page in PAGES
        for target in LINK.findall(page.read_text(encoding="utf-8"))
    }
    pictures = {path for path in (ROOT / "docs" / "pictures").rglob("*") if path.is_file()}
    assert not sorted(pictures - shown)


def test_what_is_wrong_is_found(tmp_path: Path) -> None:
    page = tmp_path / "page.md"
    page.write_text("# A part\n[x](gone.md) [y](#a-part) [z](#b) ![](p.svg) [w](https://a.b)\n")
    assert list(broken_links(page, page.read_text())) == ["gone.md", "#b", "p.svg"]
    assert CONSTANT.findall("`a.cpp: b_px` `a: b`") == [("a.cpp", "b_px")]
    cited = "(Woop et al. 2013), Greene, Kass\n// and Miller 1993; Loop 1987; SIGGRAPH 2000"
    assert works_cited(cited) == {("Woop", "2013"), ("Greene", "1993"), ("Loop", "1987")}
    named = list(files_named("`gone.cpp` `a/b.{h,cpp}` `draw()` `*.md`\n```\n`no.py`\n```\n"))
    assert named == ["gone.cpp", "a/b.h", "a/b.cpp"]
    assert not is_there("gone.cpp") and is_there("visibility/evidence/evidence.h")
