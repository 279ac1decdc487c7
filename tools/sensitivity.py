"""What half and double of each constant of a table do to drawings, as a Markdown table.

The tables are structs of numbers with names (TABLES). Their headers are copied, every number is
read from the environment in the copy, and what includes them is compiled and linked anew, once,
beside the build: the sources themselves know nothing of it. Then each number is halved and doubled,
and native/benchmarks/sensitivity.py measures. Needs a build (tools/build.sh).

    tools/sensitivity.py --results out/sensitivity.json > docs/sensitivity.md

Results are kept in that file and not measured again.
"""

from __future__ import annotations

import argparse
import json
import os
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
NATIVE, BUILD = ROOT / "native", ROOT / "build" / "native"
MEASURES = NATIVE / "benchmarks" / "sensitivity.py"

FIELD_LINE = re.compile(r"^  (double|int) (.+?);", re.MULTILINE)
FIELD = re.compile(r"(\w+) = ([^,]+)")
INCLUDED = re.compile(r'^#include "(/.+)"', re.MULTILINE)
TABLE = re.compile(r"inline constexpr (\w+) (\w+);")

Measures = dict[str, float]


@dataclass(frozen=True)
class Table:
    """A header of constants and what they are measured by."""

    header: str
    title: str
    measured: str  # of native/benchmarks/sensitivity.py
    columns: dict[str, str]  # measure: the format that tells it

    def text(self) -> str:
        """The header."""
        return (NATIVE / self.header).read_text(encoding="utf-8")

    def name(self) -> str:
        """Of the object that holds the constants."""
        found = TABLE.search(self.text())
        if not found:
            raise ValueError(f"{self.header} has no table")
        return found[2]

    def constants(self) -> Iterator[tuple[str, str, list[float]]]:
        """Names and values, and half and double of these, whole where they are."""
        for line in FIELD_LINE.finditer(self.text()):
            for name, value in FIELD.findall(line[2]):
                both = [factor * number(value) for factor in (0.5, 2)]
                yield name, value, [int(x) for x in both] if line[1] == "int" else both


LINES = {"repairs": ".0f", "unbalanced": ".0f", "changed": ".1f"}
HATCHES = {"hatches": ".0f", "length": ".1f", "uneven": ".2f", "near": ".0f", "steady": ".0f"}
TABLES = (
    Table("visibility/reaches.h", "Reaches of visibility", "lines", LINES),
    Table("visibility/prices.h", "Prices of visibility", "lines", LINES),
    Table("hatch/even_rules.h", "Rules of even hatches", "hatches", HATCHES),
)

INTRODUCTION = """# Sensitivity

What half and double of a constant do to drawings. Made by `tools/sensitivity.py`; what a constant
is for, and what it was chosen by, stands beside it in the header. Numbers that differ from those of
the first row are **bold**. A constant that changes nothing here guards against what these shapes do
not have, or a limit that they do not reach.
"""
LEGENDS = {
    "lines": """Of 32 views of coarse meshes (a bumpy ball, a knot, a surface that passes through
itself), on which there is most to repair: `repairs`, loops that do not balance (`unbalanced`), and
pixels of visible line that are elsewhere than before, for each 1000 (`changed`).
""",
    "hatches": """Of a dented ball: number of `hatches`, their mean `length`, how `uneven` they are
(distance to the nearest parallel one, from the tenth to the ninetieth percentile), both in
spacings; for each 1000 points those `near` another hatch (under .7 spacings) and, in a second
drawing that follows it by a degree, those that are `steady`.
""",
}


def tuned(table: Table) -> str:
    """The header with all numbers read from the environment when the module is loaded."""

    def read(line: re.Match[str]) -> str:
        fields = FIELD.sub(
            lambda field: f'{field[1]} = tuned("{table.name()}.{field[1]}", {field[2]})', line[2]
        )
        return line[0].replace(line[2], fields)

    text = TABLE.sub(r"inline const \1 \2{};", FIELD_LINE.sub(read, table.text()))
    reader = """#include <cstdlib>

#ifndef TUNED
#define TUNED
namespace illustrate {
template <class Number>
Number tuned(const char* name, Number usual) {
  const char* value = std::getenv(name);
  return value ? static_cast<Number>(std::atof(value)) : usual;
}
}  // namespace illustrate
#endif
"""
    return text.replace("#pragma once\n", f"#pragma once\n\n{reader}", 1)


def sources_of(unit: Path) -> list[Path]:
    """What is compiled as one: a folder's sources, included by a file of the build, or itself."""
    if unit.is_relative_to(NATIVE):
        return [unit]
    return [Path(path) for path in INCLUDED.findall(unit.read_text(encoding="utf-8"))]


def compiled(folder: Path) -> Iterator[Path]:
    """Object files of all sources that include a table, with the headers in `folder` first."""
    headers = [f'#include "{table.header}"' for table in TABLES]
    commands = json.loads((BUILD / "compile_commands.json").read_text(encoding="utf-8"))
    for command in {command["file"]: command for command in commands}.values():
        source = Path(command["file"])
        texts = [path.read_text(encoding="utf-8") for path in sources_of(source)
                 if path.is_relative_to(NATIVE) and "tests" not in path.parts]  # fmt: skip
        if not any(header in text for header in headers for text in texts):
            continue
        out = folder / f"{source.stem}.o"
        words = shlex.split(command["command"])
        words[words.index("-o") + 1] = str(out)
        words.insert(1, f"-I{folder}")
        subprocess.run(words, cwd=command["directory"], check=True)
        yield out


def build(folder: Path) -> None:
    """The module with tuned constants, in folder/illustrate_native."""
    for table in TABLES:
        header = folder / table.header
        header.parent.mkdir(parents=True, exist_ok=True)
        header.write_text(tuned(table), encoding="utf-8")
    objects = " ".join(shlex.quote(str(path)) for path in compiled(folder))
    package = folder / "illustrate_native"
    shutil.copytree(NATIVE / "illustrate_native", package)
    commands = ["ninja", "-C", str(BUILD), "-t", "commands", "_core"]
    told = subprocess.run(commands, capture_output=True, text=True, check=True).stdout
    # Before the libraries, which then have nothing to add for what these objects define.
    link = re.sub(r" -o (\S+)", rf" -o {package}/\1 {objects}", told.splitlines()[-1], count=1)
    subprocess.run(link, shell=True, cwd=BUILD, check=True)


def measure(folder: Path, what: str, constants: dict[str, str]) -> Measures:
    """With constants changed as given. The first measure of lines is what others differ from."""
    environment = os.environ | constants | {"PYTHONPATH": str(folder)}
    command = [sys.executable, str(MEASURES), what, "--base", str(folder / "base.npy")]
    told = subprocess.run(command, env=environment, capture_output=True, text=True, check=False)
    if told.returncode != 0:
        raise RuntimeError(f"{constants}: {told.stderr}")
    found: Measures = json.loads(told.stdout)
    return found


def number(value: str) -> float:
    """Of C++: a literal or a quotient of two."""
    over, _, under = value.partition("/")
    return float(over) / float(under or 1)


class Results:
    """Measures by 'table.constant=value', kept in a file."""

    def __init__(self, path: Path | None) -> None:
        self._path = path
        self.found: dict[str, Measures] = {}
        if path and path.exists():
            self.found = json.loads(path.read_text(encoding="utf-8"))

    def get(self, folder: Path, table: Table, constant: str, value: float | None) -> Measures:
        """With one constant changed; value None: with all as they are."""
        key = f"{table.name()}.{constant}={value:g}" if value is not None else table.measured
        if key not in self.found:
            if not folder.joinpath("illustrate_native").exists():
                build(folder)
                measure(folder, "lines", {})  # the base
            setting = {} if value is None else {f"{table.name()}.{constant}": str(value)}
            self.found[key] = measure(folder, table.measured, setting)
            if self._path:
                self._path.parent.mkdir(parents=True, exist_ok=True)
                self._path.write_text(json.dumps(self.found, indent=1), encoding="utf-8")
            print(key, self.found[key], file=sys.stderr, flush=True)
        return self.found[key]


def row(table: Table, name: str, value: str, of: Measures, usual: Measures) -> str:
    """A row of the Markdown table."""
    cells = [format(of.get(column, 0.0), how) for column, how in table.columns.items()]
    before = [format(usual.get(column, 0.0), how) for column, how in table.columns.items()]
    shown = [
        cell if cell == was else f"**{cell}**" for cell, was in zip(cells, before, strict=True)
    ]
    return f"| {name} | {value} | " + " | ".join(shown) + " |"


def markdown(tables: list[Table], results: Results, folder: Path) -> Iterator[str]:
    """The page, as it is measured."""
    yield INTRODUCTION
    for table in tables:
        yield f"## {table.title}\n\n`{table.header}`. {LEGENDS[table.measured]}"
        yield f"| constant | value | {' | '.join(table.columns)} |"
        yield "|---|---|" + "---|" * len(table.columns)
        usual = results.get(folder, table, "", None)
        yield row(table, "all as they are", "", usual, usual)
        for name, value, (half, double) in table.constants():
            for changed, title in ((half, f"`{name}` = {value}"), (double, "")):
                found = results.get(folder, table, name, changed)
                yield row(table, title, f"{changed:g}", found, usual)
        yield ""


def main() -> None:
    """Prints the page."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").partition("\n")[0])
    parser.add_argument("--results", type=Path, help="file in which measures are kept")
    parser.add_argument("--table", action="append", choices=[t.name() for t in TABLES])
    chosen = parser.parse_args()
    tables = [t for t in TABLES if not chosen.table or t.name() in chosen.table]
    with tempfile.TemporaryDirectory() as folder:
        for line in markdown(tables, Results(chosen.results), Path(folder)):
            print(line)


if __name__ == "__main__":
    main()
