#!/usr/bin/env python3
"""A second evaluator, slow and simple on purpose: shipped projects against the program, model by model.

    compare.py COVARIA PROJECT...        the largest relative difference of estimates, u and nu_eff of each model

Equations are written again from the papers and JCGM documents, derivatives are those of dual numbers of 40 digits. Status 1 where a figure differs by
more than 1e-9 of itself (or, of an estimate, of its u), or where a model that is covered here has no figure compared.
"""
import json
import pathlib
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True

try:
    import mpmath as mp
except ImportError:
    sys.exit(77)

import curves
import equations
import first_order
import groups
import networks
import poses
from units import factor, zero

MODELS = {"measurement-equation": lambda entry, *_: equations.evaluate(entry), "pose-from-points": lambda entry, *_: poses.evaluate(entry),
          "network-adjustment": networks.evaluate, "calibration-curve": curves.evaluate, "observations-in-groups": groups.evaluate}
BOUND = mp.mpf("1e-9")


def relative(a, b):
    return abs(a - b) / max(abs(a), abs(b)) if a != b else mp.mpf(0)


def differences(output, computed, inputs):
    """(figure, relative difference) of a result line of results.json."""
    unit = output["unit"]
    first = output.get("firstOrder") or output
    u = first_order.uncertainty(computed.g, inputs)
    estimate = mp.mpf(repr(first["estimate"])) * factor(unit) + zero(unit)
    scale = max(abs(computed.v), abs(u))
    yield "estimate", abs(estimate - computed.v) / scale if scale else abs(estimate)
    if first["standardUncertainty"] is not None:
        yield "u", relative(mp.mpf(repr(first["standardUncertainty"])) * factor(unit), u)
    nu = first.get("effectiveDegreesOfFreedom")
    if nu is not None and not inputs.correlation:
        own = getattr(inputs, "nu", None) or first_order.effective_degrees_of_freedom(computed.g, inputs)
        yield "nu_eff", relative(mp.mpf(repr(nu)), own)


def main(program, projects):
    worst, count, left_out, bad = {}, {}, [], 0
    for project in projects:
        entries = {entry["id"]: entry for entry in json.loads(pathlib.Path(project).read_text())["analyses"]}
        with tempfile.TemporaryDirectory() as out:
            subprocess.run([program, "run", project, "--first-order", "--out", out], capture_output=True, check=False)
            results = json.loads((pathlib.Path(out) / "results.json").read_text())
        for analysis in results["analyses"]:
            entry = entries[analysis["id"]]
            name = f"{pathlib.Path(project).name}/{analysis['id']}"
            if entry["model"] not in MODELS or entry.get("links") or entry.get("inputs"):
                left_out.append(f"{name}: {entry['model']}{' with links or edits' if entry['model'] in MODELS else ''}")
                continue
            try:
                defined, inputs = MODELS[entry["model"]](entry, pathlib.Path(project).parent, analysis)
            except NotImplementedError as what:
                left_out.append(f"{name}: {what}")
                continue
            for output in analysis["outputs"]:
                for figure, difference in differences(output, defined[output["symbol"], output["group"]] if
                                                      (output["symbol"], output["group"]) in defined else defined[output["symbol"]], inputs):
                    worst[entry["model"]] = max(worst.get(entry["model"], 0), difference)
                    count[entry["model"]] = count.get(entry["model"], 0) + 1
                    if difference > BOUND:
                        bad += 1
                        print(f"{name}, {output['symbol']} {output['group']}, {figure}: {mp.nstr(difference, 3)}")
    for model in MODELS:
        print(f"{model}: {count.get(model, 0)} figures, largest relative difference {mp.nstr(worst.get(model, mp.nan), 3)}")
        bad += model not in count
    print("left out:", *left_out, sep="\n  ")
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1], sys.argv[2:]))
