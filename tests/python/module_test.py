"""The Python module gives the bits of the command line, its documents run as written, its stubs name what is there.
Arguments: source folder, program, folder for files."""

import ast
import inspect
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import unittest

import covaria
import numpy as np

source, program, folder = (pathlib.Path(a) for a in sys.argv[1:4])
FILE = str(source / "projects/gum/h1-end-gauge.covaria")


def run(*arguments):
    out = folder / "python-module"
    subprocess.run([program, "run", FILE, "--out", out, *arguments], check=True, stdout=subprocess.DEVNULL)
    return json.loads((out / "results.json").read_text())


class Module(unittest.TestCase):
    def test_results_are_those_of_the_command_line(self):
        project = covaria.load(FILE)
        self.assertEqual(project.analyses, ["table", "statements"])
        ours, theirs = project.evaluate(), run()
        self.assertEqual(ours["analyses"], theirs["analyses"])

    def test_values_are_set_as_by_the_command_line(self):
        pointer = "/analyses/table/setup/quantities/rows/l_S/a"
        project = covaria.load(FILE)
        before = project.evaluate(["table"])["arrays"]["table"]["u"][0]
        project.set(pointer, 150)
        after = project.evaluate()
        self.assertEqual(after["analyses"], run("--set", pointer + "=150")["analyses"])
        self.assertGreater(after["arrays"]["table"]["u"][0], 1.5 * before)
        with self.assertRaisesRegex(ValueError, "nowhere"):
            project.set("/analyses/nowhere", 1)
        self.assertEqual(project.evaluate()["analyses"], after["analyses"])

    def test_trials_are_replayed_and_the_model_gives_their_outputs(self):
        project = covaria.load(FILE)
        analysis = project.analysis("statements")
        inputs, outputs = analysis.trials(1000)
        self.assertEqual(inputs.shape, (1000, len(analysis.inputs)))
        self.assertEqual(outputs.shape, (1000, 1))
        for x, y in zip(inputs[:50], outputs[:50]):
            np.testing.assert_array_equal(analysis.model(x), y)
        part = analysis.trials(10, first=500)[1]
        np.testing.assert_array_equal(part, outputs[500:510])
        result = project.evaluate(["statements"], trials=1000)["arrays"]["statements"]
        self.assertAlmostEqual(result["y"][0], outputs.mean(), delta=1e-15)
        self.assertAlmostEqual(result["u"][0] / outputs.std(ddof=1), 1.0, delta=1e-9)

    def test_wrong_arguments_are_errors(self):
        project = covaria.load(FILE)
        with self.assertRaises(KeyError):
            project.analysis("none")
        with self.assertRaisesRegex(ValueError, "input quantities"):
            project.analysis("table").model(np.zeros(1))
        with self.assertRaises(ValueError):
            covaria.load(FILE + "x")

    def test_files_are_named_by_texts_and_paths(self):
        for file in (FILE, pathlib.Path(FILE), os.fsencode(FILE)):
            project = covaria.load(file)
            self.assertEqual(project.file, FILE)
            self.assertEqual(project.title, "End-gauge calibration (GUM H.1)")

    def test_whole_numbers_may_be_floats(self):
        project = covaria.load(FILE)
        exact = project.evaluate(["table"], trials=10**4, seed=7)
        for trials, seed in ((1e4, 7.0), (np.int64(10000), np.uint8(7)), (np.float64(1e4), 7)):
            self.assertEqual(project.evaluate(["table"], trials=trials, seed=seed)["analyses"], exact["analyses"])
        largest = 2**64 - 1
        seed = project.evaluate(["table"], trials=100, seed=largest)["analyses"][0]["seed"]
        self.assertEqual(int(seed), largest)
        for wrong in (-1, 1.5, 2**64, float("inf"), float("nan"), "1e4", [1]):
            with self.assertRaises((ValueError, TypeError, OverflowError), msg=repr(wrong)):
                project.evaluate(["table"], trials=wrong)

    def test_the_model_takes_a_row_or_a_matrix(self):
        for file in ("projects/gum/h1-end-gauge.covaria", "projects/gum/s2-9.4-impedance.covaria"):
            project = covaria.load(source / file)
            analysis = project.analysis(project.analyses[0])
            x, y = analysis.trials(200)
            every = analysis.model(x)
            self.assertEqual(every.shape, (200, len(analysis.outputs)))
            np.testing.assert_array_equal(every, np.array([analysis.model(row) for row in x]))
            # A run uses vector code: the same but for the last bits.
            np.testing.assert_allclose(every, y, rtol=1e-12)
            # The result is the same however the matrix lies in memory, and whatever its number type.
            np.testing.assert_array_equal(analysis.model(np.asfortranarray(x)), every)
            np.testing.assert_array_equal(analysis.model(x[::2]), every[::2])
            np.testing.assert_array_equal(analysis(x.tolist()), every)
            self.assertEqual(analysis.model(x[:0]).shape, (0, len(analysis.outputs)))
            for wrong in (x[:, :-1], np.zeros(len(analysis.inputs) + 1), x[None], np.float64(1)):
                with self.assertRaises(ValueError):
                    analysis.model(wrong)

    def test_a_trial_without_value_is_nan_in_its_row_only(self):
        file = folder / "root.covaria"
        file.write_text(json.dumps({
            "format": "covaria", "schemaVersion": 2, "title": "root", "assets": [],
            "analyses": [{"id": "root", "model": "measurement-equation", "name": "root", "setup": {
                "equations": ["y = sqrt(x)"],
                "outputs": {"columns": ["symbol", "name", "unit"], "rows": [["y", "root", "1"]]},
                "quantities": {"columns": ["symbol", "name", "value", "unit", "statement", "a"],
                               "rows": [["x", "square", 4, "1", "standard", 0.1]]}}}]}))
        y = covaria.load(file).analysis("root").model([[4.0], [-1.0], [9.0]])
        np.testing.assert_array_equal(y, [[2.0], [np.nan], [3.0]])

    def test_a_project_is_saved_with_what_was_set(self):
        project = covaria.load(FILE)
        pointer = "/analyses/table/setup/quantities/rows/l_S/a"
        project.set(pointer, 150)
        saved = folder / "saved.covaria"
        project.save(saved)
        again = covaria.load(saved)
        self.assertEqual(again.evaluate(trials=100)["analyses"], project.evaluate(trials=100)["analyses"])
        self.assertEqual(json.loads(saved.read_text())["analyses"][0]["setup"]["quantities"]["rows"][0][5], 150)
        covaria.load(FILE).save(folder / "same.covaria")
        self.assertEqual((folder / "same.covaria").read_bytes(), pathlib.Path(FILE).read_bytes())
        # CSV files are beside the project, not beside its copy.
        stewart = covaria.load(source / "projects/stewart-platform.covaria")
        with self.assertRaisesRegex(ValueError, "embed=True"):
            stewart.save(folder / "stewart.covaria")
        stewart.save(folder / "stewart.covaria", embed=True)
        self.assertEqual(covaria.load(folder / "stewart.covaria").analyses, stewart.analyses)
        with self.assertRaises(ValueError):
            project.save(folder / "nowhere" / "file.covaria")

    def test_what_is_shown_says_what_it_is(self):
        project = covaria.load(FILE)
        self.assertEqual(repr(project), "<covaria.Project 'End-gauge calibration (GUM H.1)': table, statements>")
        analysis = project.analysis("table")
        self.assertRegex(repr(analysis), r"^<covaria.Analysis 'table': \d+ input quantities, 1 output>$")
        results = project.evaluate(trials=0)
        self.assertEqual(repr(results), "<covaria.Results of 'table', 'statements'>")
        self.assertIsInstance(results, dict)
        for shown, words in ((project, ("<table", "statements", "measurement-equation")),
                             (analysis, ("<table", "50 000 623", "l")),
                             (results, ("<table", "838"))):
            for word in words:
                self.assertIn(word, shown._repr_html_().replace("\u202f", " "))
            self.assertEqual(shown._repr_html_().count("<table"), shown._repr_html_().count("</table>"))

    def test_the_version_is_that_of_the_program(self):
        said = subprocess.run([program, "--version"], check=True, capture_output=True, text=True).stdout
        self.assertEqual(said.strip(), "covaria " + covaria.__version__)


class Stubs(unittest.TestCase):
    """__init__.pyi against what the package has: names, and the arguments of functions."""

    def test_name_everything_and_nothing_else(self):
        package = pathlib.Path(covaria.__file__).parent
        self.assertTrue((package / "py.typed").exists())
        tree = ast.parse((package / "__init__.pyi").read_text())
        classes = {node.name: node for node in tree.body if isinstance(node, ast.ClassDef)}
        functions = {node.name: node for node in tree.body if isinstance(node, ast.FunctionDef)}
        self.assertEqual(sorted([*classes, *functions]), sorted(covaria.__all__))
        self.check_arguments(functions["load"], covaria.load)
        for name, node in classes.items():
            stubs = {n.name: n for n in node.body if isinstance(n, ast.FunctionDef)}
            known = {n for n, v in vars(getattr(covaria, name)).items()
                     if callable(v) or isinstance(v, property)}
            public = {n for n in known if not n.startswith("_")} | (known & {"__call__", "_repr_html_"})
            self.assertEqual({n for n in stubs if n != "__init__"}, public, name)
            for method, stub in stubs.items():
                if method != "__init__":
                    self.check_arguments(stub, getattr(getattr(covaria, name), method))

    def check_arguments(self, stub, there):
        if isinstance(there, property):
            return
        names = [a.arg for a in stub.args.args]
        if inspect.isfunction(there):
            self.assertEqual(names, list(inspect.signature(there).parameters))
            return
        signature = there.__doc__.split("\n")[0] if there.__doc__ else ""
        self.assertEqual(names, re.findall(r"(\w+): ", signature[:signature.rindex(") ->")]), signature)


class Document(unittest.TestCase):
    """docs/python.md: every block of code runs, in the folder of the projects, and says what its comments say."""

    def test_runs_as_written(self):
        here = folder / "python-document"
        shutil.rmtree(here, ignore_errors=True)
        shutil.copytree(source / "projects", here / "projects")
        text = (source / "docs/python.md").read_text()
        blocks = re.findall(r"```python\n(.*?)```", text, re.S)
        self.assertGreaterEqual(len(blocks), 3)
        names, before = {}, os.getcwd()
        os.chdir(here)
        try:
            for block in blocks:
                self.run_block(block, names)
        finally:
            os.chdir(before)

    def run_block(self, block, names):
        lines = block.split("\n")
        for statement in ast.parse(block).body:
            source_text = ast.get_source_segment(block, statement)
            if not isinstance(statement, ast.Expr):
                exec(compile(source_text, "docs/python.md", "exec"), names)
                continue
            value = eval(compile(source_text, "docs/python.md", "eval"), names)
            comment = lines[statement.end_lineno - 1][statement.end_col_offset:].strip()
            if said := re.match(r"# (?P<literal>['\[(<\d].*)", comment):
                self.assertEqual(repr(value), said["literal"], source_text)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0]])
