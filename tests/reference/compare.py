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

import ballbars
import baselines
import curves
import equations
import first_order
import geometry
import groups
import networks
import poses
import robots
from units import factor, zero

MODELS = {"measurement-equation": lambda entry, project: equations.evaluate(entry, lambda inputs: project.linked(entry, inputs)),
          "pose-from-points": lambda entry, project: poses.evaluate(entry), "network-adjustment": networks.evaluate,
          "calibration-curve": curves.evaluate, "observations-in-groups": groups.evaluate,
          "geometry-from-points": geometry.evaluate, "feature-relations": geometry.relations, "distance-meter-baseline": baselines.evaluate,
          "robot-pose": robots.evaluate, "tcp-from-ballbars": ballbars.evaluate}
LINKED = ("measurement-equation",)
EDITED = ("measurement-equation",)
BOUND = mp.mpf("1e-9")


class Project:
    """The analyses of a file and what the program found of them; each is evaluated once."""

    def __init__(self, path, results):
        self.folder, content = pathlib.Path(path).parent, json.loads(pathlib.Path(path).read_text())
        self.entries = {entry["id"]: entry for entry in content["analyses"]}
        self.assets = {asset["id"]: asset for asset in content.get("assets", [])}
        self.results = {analysis["id"]: analysis for analysis in results["analyses"]}
        self.known = {}

    def of(self, name):
        """(results as duals, inputs), or what is not covered, again."""
        if name not in self.known:
            entry = self.entries[name]
            try:
                for key, able in (("links", LINKED), ("inputs", EDITED)):
                    if entry.get(key) and entry["model"] in MODELS and entry["model"] not in able:
                        raise NotImplementedError(f"{entry['model']} with {key}")
                if entry["model"] not in MODELS:
                    raise NotImplementedError(entry["model"])
                self.known[name] = MODELS[entry["model"]](entry, self)
            except NotImplementedError as what:
                self.known[name] = what
        if isinstance(self.known[name], NotImplementedError):
            raise self.known[name]
        return self.known[name]

    def taken(self, name, inputs):
        """Results of an analysis as functions of its inputs, which `inputs` takes over: one that two analyses share is one input."""
        defined, own = self.of(name)
        full = lambda symbol: symbol if isinstance(symbol, tuple) and symbol[0] == "of" else ("of", name, symbol)
        if name not in inputs.taken:
            inputs.taken.add(name)
            index = {}
            for i, component in enumerate(own.components):
                there = own.origin.get(i, (name, i))
                if there not in inputs.origin.values():
                    inputs.origin[inputs.add(full(component[0]), *component[1:])] = there
                index[i] = next(j for j, origin in inputs.origin.items() if origin == there)
            for i, estimate in own.estimates.items():
                inputs.estimates[index[i]] = name, estimate
            for (i, j), r in own.correlation.items():
                inputs.correlate(index[i], index[j], r)
        return {key: type(value)(value.v, {full(k): d for k, d in value.g.items()}) for key, value in defined.items()}

    def linked(self, entry, inputs):
        """symbol of an input quantity -> the result of another analysis; what the set-up says of its own uncertainty does not count."""
        found = {}
        for link in entry.get("links", []):
            results = self.taken(link["analysis"], inputs)
            found[link["input"]] = results[link["output"], link["group"]] if (link["output"], link.get("group")) in results else results[link["output"]]
        return found


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
        with tempfile.TemporaryDirectory() as out:
            subprocess.run([program, "run", project, "--first-order", "--no-studies", "--out", out], capture_output=True, check=False)
            results = json.loads((pathlib.Path(out) / "results.json").read_text())
        evaluated = Project(project, results)
        for analysis in results["analyses"]:
            entry = evaluated.entries[analysis["id"]]
            name = f"{pathlib.Path(project).name}/{analysis['id']}"
            try:
                defined, inputs = evaluated.of(analysis["id"])
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
