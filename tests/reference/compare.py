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
import circles
import curves
import equations
import first_order
import forces
import geometry
import groups
import identification
import networks
import poses
import proving
import robots
import rounds
import sensors
from dual import Dual
from units import exact, factor, si

MODELS = {"measurement-equation": equations.evaluate, "pose-from-points": poses.evaluate, "network-adjustment": networks.evaluate,
          "calibration-curve": curves.evaluate, "observations-in-groups": groups.evaluate, "geometry-from-points": geometry.evaluate,
          "feature-relations": geometry.relations, "distance-meter-baseline": baselines.evaluate, "robot-pose": robots.evaluate,
          "tcp-from-ballbars": ballbars.evaluate, "theodolite-rounds": rounds.evaluate, "force-proving-instrument": proving.evaluate,
          "robot-calibration": identification.evaluate, "points-from-sensors": sensors.evaluate,
          "robot-circle-points": circles.evaluate, "force-moment-channels": forces.channels, "force-moment-loads": forces.loads}
BOUND = mp.mpf("1e-9")


class Project:
    """The analyses of a file and what the program found of them; each is evaluated once."""

    def __init__(self, path, results):
        self.folder, content = pathlib.Path(path).parent, json.loads(pathlib.Path(path).read_text())
        self.entries = {entry["id"]: entry for entry in content["analyses"]}
        self.assets = {asset["id"]: asset for asset in content.get("assets", [])}
        self.outputs = {analysis["id"]: analysis["outputs"] for analysis in results["analyses"]}
        self.known = {}

    def started(self, name):
        """Estimates of the program, from which fits and networks begin."""
        return {(output["symbol"], output["group"]): si(output["estimate"], output["unit"]) for output in self.outputs[name]}

    def evaluated(self, entry):
        model = entry["model"]
        if model not in MODELS:
            raise NotImplementedError(model)
        for key in ("links", "inputs"):
            if entry.get(key) and model != "measurement-equation":
                raise NotImplementedError(f"{model} with {key}")
        return MODELS[model](entry, self)

    def of(self, name):
        """(results as duals, inputs), or what is not covered, again."""
        if name not in self.known:
            try:
                self.known[name] = self.evaluated(self.entries[name])
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
        return {key: Dual(value.v, {full(k): d for k, d in value.g.items()}) for key, value in defined.items()}

    def linked(self, entry, inputs):
        """symbol of an input quantity -> the result of another analysis; what the set-up says of its own uncertainty does not count."""
        return {link["input"]: of_group(self.taken(link["analysis"], inputs), link["output"], link.get("group")) for link in entry.get("links", [])}


def of_group(results, symbol, group):
    return results[symbol, group] if (symbol, group) in results else results[symbol]


def relative(a, b):
    return abs(a - b) / max(abs(a), abs(b)) if a != b else mp.mpf(0)


def differences(output, computed, inputs):
    """(figure, relative difference) of a result line of results.json."""
    unit, first = output["unit"], output.get("firstOrder") or output
    u = first_order.uncertainty(computed.g, inputs)
    difference, scale = abs(si(first["estimate"], unit) - computed.v), max(abs(computed.v), abs(u))
    yield "estimate", difference / scale if scale else difference
    yield "u", relative(exact(first["standardUncertainty"] or 0) * factor(unit), u)
    nu = first.get("effectiveDegreesOfFreedom")
    if not inputs.correlation:
        own = inputs.nu or first_order.effective_degrees_of_freedom(computed.g, inputs)
        if nu is not None or own != mp.inf:  # none are stated where there are infinitely many
            yield "nu_eff", relative(exact(nu or 0), own)


def results_of(program, project):
    with tempfile.TemporaryDirectory() as out:
        subprocess.run([program, "run", project, "--first-order", "--no-studies", "--out", out], capture_output=True, check=False)
        return json.loads((pathlib.Path(out) / "results.json").read_text())


def main(program, projects):
    found, left_out, bad = {model: [] for model in MODELS}, [], 0
    for path in projects:
        project = Project(path, results_of(program, path))
        for analysis, outputs in project.outputs.items():
            name = f"{pathlib.Path(path).name}/{analysis}"
            try:
                defined, inputs = project.of(analysis)
            except NotImplementedError as what:
                left_out.append(f"{name}: {what}")
                continue
            for output in outputs:
                symbol, group = output["symbol"], output["group"]
                for figure, difference in differences(output, of_group(defined, symbol, group), inputs):
                    found[project.entries[analysis]["model"]].append(difference)
                    if not difference <= BOUND:
                        bad += 1
                        print(f"{name}, {symbol} {group}, {figure}: {mp.nstr(difference, 3)}")
    for model, all_ in found.items():
        print(f"{model}: {len(all_)} figures, largest relative difference {mp.nstr(max(all_, default=mp.nan), 3)}")
        bad += not all_
    print("left out:", *left_out, sep="\n  ")
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1], sys.argv[2:]))
