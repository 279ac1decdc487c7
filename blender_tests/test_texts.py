"""What the add-on says: a tooltip with unit and effect for every setting, and in German."""

import re
from types import SimpleNamespace
from typing import Any

import bpy
import interface_texts
import pytest
from illustrate import messages, translations

UNITS = (
    r"millimetre|pixel|degree|second|share|stops|times|how often|levels|spacings|surfaces|frame"
    r"|as many as|triangles|pairs|rings|steps|measured against|right angles|exact|proportion"
    r"|disagree|strongly"
)
"""Words by which a tooltip says what its number counts, where Blender does not show it."""
SHOWN_BY_BLENDER = {"PIXEL", "ANGLE", "FACTOR", "COLOR", "COLOR_GAMMA", "XYZ", "DISTANCE", "LENGTH"}
VALUE = re.compile(r"{[^}]*}")
FROM_BLENDER = {"filepath", "filter_glob", "check_existing", "directory"}


def wrong_with(prop: Any) -> str:
    """What a tooltip lacks; empty when it says what the setting does, and in what it counts."""
    name, text = prop.name, prop.description
    if not name or len(text.split()) < 2 or text.lower() == name.lower():
        return "says nothing of its effect"
    if text.endswith("."):
        return "has a full stop, and Blender adds another"
    if prop.type in ("INT", "FLOAT") and not {prop.subtype, prop.unit} & SHOWN_BY_BLENDER:
        return (
            "" if re.search(UNITS, text, re.IGNORECASE) else f"does not say what it counts: {text}"
        )
    return ""


def test_every_setting_has_a_tooltip_with_its_unit_and_effect() -> None:
    settings = [
        (owner, prop)
        for owner, prop in interface_texts.properties()
        if not prop.is_hidden
        and prop.type != "COLLECTION"  # a list, which nothing shows by itself
        and prop.identifier not in FROM_BLENDER
    ]
    assert len(settings) > 150
    wrong = {f"{owner}.{prop.identifier}": wrong_with(prop) for owner, prop in settings}
    assert not [f"{name} {problem}" for name, problem in wrong.items() if problem]


def test_every_operator_says_what_it_does() -> None:
    for kind in interface_texts.registered():
        if kind.__name__.startswith("ILLUSTRATE_OT_"):
            assert len(kind.bl_description.split()) >= 4, kind
            assert not kind.bl_description.endswith("."), kind


@pytest.mark.parametrize("language", sorted(set(translations.TABLES.values())))
def test_no_text_lacks_its_translation(language: str) -> None:
    table, texts = translations.texts(language), interface_texts.all_texts()
    assert not sorted(texts - set(table)), "they are shown in English"
    assert not sorted(set(table) - texts), "nothing shows them any more"
    assert all(words.strip() == words and words for words in table.values())
    for text, words in table.items():
        assert words.endswith(".") == text.endswith("."), text


def test_every_message_can_be_translated() -> None:
    assert not list(interface_texts.unsaid()), "they miss `said` of messages.py"


@pytest.mark.parametrize("language", sorted(set(translations.TABLES.values())))
def test_translations_have_the_values_of_their_texts(language: str) -> None:
    for text, words in translations.texts(language).items():
        assert sorted(VALUE.findall(text)) == sorted(VALUE.findall(words)), text


def test_messages_are_translated(monkeypatch: Any) -> None:
    german = translations.texts("german")
    stand_in = SimpleNamespace(pgettext_rpt=lambda text: german.get(text, text))
    app = SimpleNamespace(translations=stand_in)
    monkeypatch.setattr(messages, "bpy", SimpleNamespace(app=app))
    assert messages.amount(1, "stroke") == "1 Strich"
    assert messages.amount(2, "stroke") == "2 Striche"
    assert messages.quoted(["a", "b", "c"], 1) == '"a" und 2 weitere'
    assert messages.said("Kept {strokes}", strokes="2 Striche") == "2 Striche behalten"


def test_blender_shows_the_translation() -> None:
    view = bpy.context.preferences.view
    before = view.language, view.use_translate_interface
    known = view.bl_rna.properties["language"].enum_items.keys()
    wanted = next((name for name in translations.TABLES if name in known), None)
    if wanted is None:
        pytest.skip(f"this Blender has no German among its languages: {len(known)} known")
    try:
        view.language = wanted
        view.use_translate_interface = True
        assert bpy.app.translations.pgettext_iface("Hidden Lines") == "Verdeckte Linien"
        tip = "Draw the selected objects only"
        assert bpy.app.translations.pgettext(tip) == "Nur die ausgewählten Objekte zeichnen"
    finally:
        view.language, view.use_translate_interface = before
