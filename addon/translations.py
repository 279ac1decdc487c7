"""The interface in other languages: a table for each, handed to Blender.

To add a language, add its table; what is not in it is shown in English.
"""

import bpy

GERMAN = {
    "Illustrate": "Illustrieren",
    "Bake Animation": "Animation backen",
    "Clear Illustration": "Illustration entfernen",
    "Show Field": "Feld zeigen",
    "Hide Field": "Feld verbergen",
    "Live Lines": "Linien im Viewport",
    "Draw": "Zeichnen",
    "Line Width": "Linienbreite",
    "Hatching": "Schraffur",
    "Spacing": "Abstand",
    "Hidden Lines": "Verdeckte Linien",
    "Surface and Field": "Fläche und Feld",
    "Lines": "Linien",
    "Light": "Licht",
    "Output": "Ausgabe",
    "Animation": "Animation",
}
TABLES = {"de_DE": GERMAN, "de": GERMAN}
CONTEXTS = ("*", "Operator")


def table() -> dict[str, dict[tuple[str, str], str]]:
    """All tables as Blender takes them."""
    return {
        locale: {(context, text): words for context in CONTEXTS for text, words in texts.items()}
        for locale, texts in TABLES.items()
    }


def register() -> None:
    """Hands the tables to Blender."""
    bpy.app.translations.register(__package__, table())


def unregister() -> None:
    """Takes them back."""
    bpy.app.translations.unregister(__package__)
