#!/usr/bin/env python3
"""The results of every shipped project as digits: which of them does this program change?

    kept.py COVARIA          holds the results against results.json of this folder; status 1 where one differs and changes.json does not say why
    kept.py COVARIA --write  keeps those of this program; changes.json is emptied, what it said belongs into CHANGELOG.md

Each output has its estimate, u and U by the law of propagation, and the same of 10,000 trials with the seed of the project. They are the same to 1e-9
of themselves, or of u where they are estimates. changes.json lists what a version changes: {"what": "projects/x.covaria/analysis/x of P", "cause": "..."};
`what` may end with *. An entry about which nothing changed is wrong too.
"""
import fnmatch
import json
import pathlib
import subprocess
import sys
import tempfile

FOLDER = pathlib.Path(__file__).resolve().parent
TREE = FOLDER.parent.parent
SAME = 1e-9


def results_of(program, project, options):
    with tempfile.TemporaryDirectory() as out:
        subprocess.run([program, "run", str(TREE / project), "--no-studies", "--out", out, *options], capture_output=True, check=False)
        return json.loads((pathlib.Path(out) / "results.json").read_text())["analyses"]


def figures(program):
    """name -> [estimate, u, U] by the law of propagation and of trials."""
    found = {}
    for folder in ("projects", "projects/gum"):
        for file in sorted((TREE / folder).glob("*.covaria")):
            project = f"{folder}/{file.name}"
            for options in (["--first-order"], ["--trials", "1e4"]):
                for analysis in results_of(program, project, options):
                    for output in analysis["outputs"]:
                        name = f"{project}/{analysis['id']}/{output['symbol']}" + (f" of {output['group']}" if output["group"] else "")
                        found.setdefault(name, []).extend(output[key] for key in ("estimate", "standardUncertainty", "expandedUncertainty"))
    return found


def same(a, b):
    """Estimates are compared in parts of u, too: a zero has no digits."""
    if len(a) != len(b):
        return False
    for i, (x, y) in enumerate(zip(a, b)):
        if x is None or y is None:
            if x is not y:
                return False
            continue
        scale = max(abs(x), abs(y), (a[i + 1] or 0) if i % 3 == 0 else 0)
        if abs(x - y) > SAME * scale:
            return False
    return True


def main(program, write):
    now = figures(program)
    if write:
        lines = ",\n".join(f"{json.dumps(name, ensure_ascii=False)}: {json.dumps(values)}" for name, values in now.items())
        (FOLDER / "results.json").write_text("{\n" + lines + "\n}\n")
        (FOLDER / "changes.json").write_text("[]\n")
        return 0
    kept, listed = json.loads((FOLDER / "results.json").read_text()), json.loads((FOLDER / "changes.json").read_text())
    changed = [name for name in kept if name not in now or not same(kept[name], now[name])]
    unsaid = [name for name in changed if not any(fnmatch.fnmatchcase(name, one["what"]) and one["cause"] for one in listed)]
    idle = [one["what"] for one in listed if not fnmatch.filter(changed, one["what"])]
    for name in unsaid:
        print(f"{name}: kept {kept.get(name)}, now {now.get(name)}")
    for what in idle:
        print(f"changes.json says that {what} changed; it did not")
    print(f"{len(kept)} results kept, {len(changed)} changed, {len(unsaid)} of them without a cause; {len(set(now) - set(kept))} new ones, not kept yet")
    return 1 if unsaid or idle else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1], "--write" in sys.argv))
