"""The same noisy curves fitted by nanite (its models, its residual, lmfit) and by springbed.

usage: fit_nanite.py PROGRAM [POINTS]      (pip install nanite; PROGRAM is the binary of springbed)

Force over depth of nanite's own models with white noise, contact point and constant baseline free, all points of equal
weight. Prints for each model how far both answers are apart, both standard errors, and nanite's median time of 15 fits.
"""
import json
import pathlib
import statistics
import subprocess
import sys
import tempfile
import time

import lmfit
import numpy as np
from nanite.model import models_available

SCENE = """(shape: {shape}, bodies: (Elastic(young: 2000, poisson: {nu}), Rigid), history: [Indent(to: 1e-6, over: 1)],
    fit: (free: ["bodies.0.young=10..1e6"]))"""
# Depth falls towards the sample in nanite: delta = -depth.
MODELS = {
    "hertz_para": ({"E": 3e3, "R": 5e-6, "nu": 0.5}, "Paraboloid(radius: 5e-6)"),
    "hertz_cone": ({"E": 3e3, "alpha": 25.0, "nu": 0.5}, f"Cone(slope: {float(1 / np.tan(np.radians(25.0)))!r})"),
}


def by_nanite(name, fixed, delta, force):
    model = models_available[name]
    parameters = lmfit.Parameters()
    for key in model.parameter_keys:
        free = key in ("E", "contact_point", "baseline")
        value = {"E": 2e3, "contact_point": -1e-6, "baseline": 0.0}.get(key, fixed.get(key))
        parameters.add(key, value=value, vary=free)

    def rest(p):
        return (model.module.model_func(delta, **{k: p[k].value for k in model.parameter_keys}) - force) / force.max()

    fit = lambda: lmfit.minimize(rest, parameters, ftol=1e-14, xtol=1e-14)
    found, times = fit(), []
    for _ in range(15):
        began = time.perf_counter()
        fit()
        times.append(time.perf_counter() - began)
    return found.params["E"].value, found.params["E"].stderr, statistics.median(times)


def by_springbed(program, shape, nu, depth, force):
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        (folder / "scene.ron").write_text(SCENE.format(shape=shape, nu=nu))
        rows = [f"{d!r},{f!r}" for d, f in zip(depth.tolist(), force.tolist())]
        (folder / "data.csv").write_text("depth [m],force [N]\n" + "\n".join(rows))
        command = [program, "fit", "scene.ron", "data.csv", "--out", "."]
        subprocess.run(command, cwd=folder, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        answer = json.loads((folder / "data.fit.json").read_text())
    young = next(one for one in answer["parameters"] if one["path"] == "bodies.0.young")
    return young["value"], young["standard_error"]


def main():
    program, points = str(pathlib.Path(sys.argv[1]).resolve()), int(sys.argv[2]) if len(sys.argv) > 2 else 5000
    rng = np.random.default_rng(1)
    for name, (fixed, shape) in MODELS.items():
        depth = np.linspace(0, 3e-6, points)
        clean = models_available[name].module.model_func(-depth, contact_point=-1.3e-6, baseline=2e-10, **fixed)
        force = clean + 0.01 * clean.max() * rng.normal(size=points)
        theirs, their_error, seconds = by_nanite(name, fixed, -depth, force)
        ours, our_error = by_springbed(program, shape, fixed["nu"], depth, force)
        print(f"{name}: {ours / theirs - 1:+.1e} apart; errors {their_error:.4g} {our_error:.4g} Pa; nanite {1e3 * seconds:.1f} ms")


if __name__ == "__main__":
    main()
