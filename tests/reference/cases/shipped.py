"""Shipped projects by the law of propagation: figures of the second evaluator for models that no other maker of cases has."""
import csv
import json
import sys

from book import EVALUATORS, FOLDER, TESTS, Book  # first, for the folder of the evaluators

import ballbars
import proving
import rounds
from compare import results_of

EVALUATORS |= {"tcp-from-ballbars": ballbars.evaluate, "force-proving-instrument": proving.evaluate, "theodolite-rounds": rounds.evaluate}
PROJECTS = {"ballbar-tcp": ["paper", "stated"], "er10l-c10": ["zero-pose", "zero-pose-components", "zero-pose-nominal", "poses", "section-4-1-a", "section-4-1-b", "section-4-1-c"],
            "tracker-pose": ["tracker-alone"], "theodolite": ["rounds"], "force-transducer": ["calibration", "decreasing"], "distance-meter": ["zero-offset", "scale"]}

SIZES = {"mV/V": 2e-3}  # of the largest deflection, to whose digits a fit is


def stated(evaluate, outputs):
    """The evaluator without results that the analysis does not ask for."""
    def those(entry, project):
        results, inputs = evaluate(entry, project)
        symbols = {symbol for symbol, _ in outputs}
        return {key: value for key, value in results.items() if key in outputs or key in symbols}, inputs
    return those


def typed(setup):
    """The set-up with the tables of its CSV files in it: what has a unit is a number."""
    def of_file(given):
        lines = [line for line in (TESTS / "projects" / given["csv"]).read_text().splitlines() if line and not line.startswith("#")]
        columns, *rows = csv.reader(lines)
        return {"columns": columns, "rows": [[None if cell == "" else float(cell) if "[" in head else cell for head, cell in zip(columns, row)] for row in rows]}
    return {key: of_file(value) if isinstance(value, dict) and "csv" in value else value for key, value in setup.items()}


def main(program):
    book = Book("shipped", "Shipped projects by the law of propagation", "Analyses of shipped projects, evaluated by the law of propagation. Reference values of a second evaluator: see covaria verify.")
    for name, analyses in PROJECTS.items():
        path = TESTS / "projects" / f"{name}.covaria"
        content = json.loads(path.read_text())
        outputs = {one["id"]: one["outputs"] for one in results_of(program, str(path))["analyses"]}  # only their units
        for asset in content.get("assets", []):
            book.asset(asset)
        for entry in content["analyses"]:
            if entry["id"] not in analyses:
                continue
            known = len(book.project["analyses"])
            made = book.analysis(f"{name}-{entry['id']}", entry["model"], f"{content['title']}: {entry['name']}", typed(entry["setup"]))
            evaluate = EVALUATORS[entry["model"]]
            EVALUATORS[entry["model"]] = stated(evaluate, {(output["symbol"], output["group"]) for output in outputs[entry["id"]]})
            units = {output["symbol"]: output["unit"] for output in outputs[entry["id"]]}
            try:
                book.case(made["name"], f"second evaluator (tests/reference), 50 digits; projects/{name}.covaria", made, units, None, None, ["JCGM 102:2011, 6.2"], draws=2, size=1, sizes=SIZES)
            except NotImplementedError as what:
                print(f"{name}/{entry['id']}: left out: {what}")
                del book.project["analyses"][known:]
            EVALUATORS[entry["model"]] = evaluate
    book.write("Shipped projects: a second evaluator at 50 digits, made by tests/reference/cases/shipped.py")


if __name__ == "__main__":
    main(sys.argv[1])
