"""What Python, sweeps, the gallery and Dask cost: ``python python/benches/measure.py [PROGRAM]``.

Needs the package installed; PROGRAM is the program, ``target/release/springbed`` if not given. What is not there (the program,
Dask) is skipped by name. Each line has what was measured, the bound it is held to, and how; the exit code is the number of lines
beyond their bound. Times are medians but of what takes seconds, which is measured once. The step of one owned contact is in
``cargo bench -p benches --bench states``, the time from a save to the pixels of a browser in ``benches/watch.sh``.
"""

from __future__ import annotations

import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path

import numpy as np

import springbed

ROOT = Path(__file__).resolve().parents[2]
SCENE = """(
    shape: Paraboloid(radius: "10 mm"),
    bodies: (Elastic(young: "210 GPa", poisson: 0.3), Rigid),
    history: [Indent(to: "1 um", over: "1 s")],
)"""
VALUES = {"bodies.0.young": "1GPa..300GPa:100log", "shape.radius": "1mm..100mm:100log"}

beyond = 0


def seconds(work: Callable[[], object], times: int = 1) -> float:
    """Median time of some runs."""
    taken = []
    for _ in range(times):
        begin = time.perf_counter()
        work()
        taken.append(time.perf_counter() - begin)
    return statistics.median(taken)


def told(what: str, value: float, bound: float, unit: str) -> None:
    global beyond
    beyond += value > bound
    print(f"{what:58} {value:10.3g} {unit:3} bound {bound:g} {unit}{'' if value <= bound else '  BEYOND'}", flush=True)


def process(*arguments: str) -> float:
    """Median time of a process."""
    return seconds(lambda: subprocess.run(arguments, check=True, stdout=subprocess.DEVNULL, cwd=ROOT), 11)


def python() -> float:
    bare = process(sys.executable, "-c", "import numpy")
    told("import, beside NumPy", 1e3 * (process(sys.executable, "-c", "import springbed") - bare), 50, "ms")
    hertz = ROOT / "configs" / "hertz.ron"
    told("run of hertz.ron in process", 1e6 * seconds(lambda: springbed.run(hertz), 201), 200, "us")

    lenses = springbed.Contact.paraboloid(np.linspace(1e-3, 3e-3, 100_000), modulus=6.4e6, work=0.042)
    depths = iter([1e-5, 2e-5] * 20)
    told("100 000 JKR contacts moved in one call", 1e3 * seconds(lambda: lenses.advance(next(depths)), 21), 50, "ms")

    taken = seconds(lambda: springbed.sweep(SCENE, VALUES))
    told("10 000 elastic scenes by sweep(…)", taken, 3.6, "s")
    return taken


def program(path: Path, in_python: float) -> None:
    if not path.exists():
        print(f"skipped: {path} is not there")
        return
    with tempfile.TemporaryDirectory() as out:
        scene = Path(out) / "s.ron"
        scene.write_text(SCENE, encoding="utf-8")
        sets = [f"--set={path}={values}" for path, values in VALUES.items()]
        sweep = [str(path), "run", str(scene), *sets, "--format", "csv", "--out", out, "-q"]
        taken = seconds(lambda: subprocess.run(sweep, check=True))
        told("10 000 elastic scenes by run --set, one file", taken, 3, "s")
        told("the same from Python over the program", in_python / taken, 1.2, "")
        scenes = sorted(str(scene) for scene in (ROOT / "configs").glob("*.ron"))
        gallery = [str(path), "gallery", *scenes, "--out", out, "-q"]
        told("gallery of all configs", seconds(lambda: subprocess.run(gallery, check=True)), 15, "s")
        size = sum(file.stat().st_size for file in Path(out).rglob("*.html"))
        told("its page", size / 1e6, 3, "MB")


def dask(in_python: float) -> None:
    try:
        from dask.distributed import Client
    except ImportError:
        print("skipped: dask.distributed is not installed")
        return
    with Client(n_workers=2, threads_per_worker=1, dashboard_address=None) as client:
        springbed.sweep(SCENE, {"shape.radius": "1mm..2mm:4"}, client=client)
        taken = seconds(lambda: springbed.sweep(SCENE, VALUES, client=client))
    told("10 000 scenes through Dask, over the local time", taken - in_python, 2, "s")


if __name__ == "__main__":
    taken = python()
    program(Path(sys.argv[1]) if len(sys.argv) > 1 else ROOT / "target" / "release" / "springbed", taken)
    dask(taken)
    sys.exit(beyond)
