"""The Python module gives the bits of the command line. Arguments: source folder, program, folder for files."""

import json
import pathlib
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


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0]])
