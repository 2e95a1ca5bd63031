#!/usr/bin/env python3
"""scripts/translations finds what is wrong with a translation."""
import importlib.machinery
import importlib.util
import pathlib
import sys
import unittest

sys.dont_write_bytecode = True
path = pathlib.Path(__file__).resolve().parents[2] / "scripts" / "translations"
loader = importlib.machinery.SourceFileLoader("translations", str(path))
translations = importlib.util.module_from_spec(importlib.util.spec_from_loader("translations", loader))
loader.exec_module(translations)


class Complaints(unittest.TestCase):
    def complaints(self, source, translation, finished=True):
        return list(translations.complaints(source, translation, finished))

    def test_nothing_is_wrong(self):
        for source, translation in [("&File", "&Datei"), ("&File", "文件(&F)"), ("%1 of %2", "von %2 %1"), ("u", "u"),
                                    ("<b>%1</b> at %2", "<b>%1</b> bei %2"), (", worth %1", ", wert %1"), ("A && B", "A && B")]:
            self.assertEqual(self.complaints(source, translation), [], source)

    def test_what_is_wrong_is_found(self):
        for source, translation in [("%1 of %2", "%1 von"), ("%1", "%1 %1"), ("%n trials", "Versuche"),
                                    ("&File", "Datei"), ("File", "&Datei"), ("<b>%1</b>", "%1"), (" of %1", "von %1")]:
            self.assertEqual(len(self.complaints(source, translation)), 1, source)

    def test_a_text_without_translation_is_not_wrong(self):
        for source, translation, finished in [("Save", "", True), ("Save", "Sichern", False), ("%n rows", "%n Zeile\x1f", True)]:
            self.assertFalse(translations.is_translated(translation, finished), source)
            self.assertEqual(self.complaints(source, translation, finished), [], source)

    def test_tables_keep_every_letter(self):
        for text in ["a\tb\nc", "\\n", "\\", "“x”\\t\n", "one\x1fmany"]:
            self.assertEqual(translations.unescaped(translations.escaped(text)), text)
            self.assertNotIn("\n", translations.escaped(text))


if __name__ == "__main__":
    unittest.main()
