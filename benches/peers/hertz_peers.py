"""Free Hertz contact, window of three contact radii, one thread, with other packages.

usage: hertz_peers.py tamaas|contactmechanics|slippy N [RUNS]
R = E* = 1, d = 0.01 (tamaas is given the force instead); prints the relative error of the force at its
indentation, the median processor time of RUNS solutions and the peak memory of the process.
"""
import contextlib
import io
import os
import resource
import statistics
import sys
import tempfile
import time

for name in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS"):
    os.environ.setdefault(name, "1")
import numpy as np

DEPTH = 0.01
RADIUS = DEPTH**0.5
FORCE = 4 / 3 * RADIUS * DEPTH


def heights(n):
    x = (np.arange(n) - n // 2) * 3 * RADIUS / n
    return (x[:, None] ** 2 + x[None, :] ** 2) / 2


def tamaas(n):
    import tamaas as tm

    tm.set_log_level(tm.LogLevel.error)
    size = 3 * RADIUS
    model = tm.ModelFactory.createModel(tm.model_type.basic_2d, [size, size], [n, n])
    model.E, model.nu = 1.0, 0.0
    surface = -heights(n)
    tm.ModelFactory.registerNonPeriodic(model, "dcfft")
    solver = tm.PolonskyKeerRey(model, surface, 1e-8)
    solver.max_iter = 5000
    solver.setIntegralOperator("dcfft")
    solver.solve(FORCE / size**2)
    displacement = np.zeros_like(surface)
    model.operators["dcfft"](model.traction, displacement)
    gap = (displacement - surface)[model.traction > 0]
    print(f"largest gap in contact over depth {np.ptp(gap) / DEPTH:.1e}", file=sys.stderr)
    return (DEPTH / gap.mean()) ** 1.5 - 1


def contactmechanics(n):
    from ContactMechanics import FreeFFTElasticHalfSpace, make_system
    from SurfaceTopography import Topography

    size = (3 * RADIUS,) * 2
    system = make_system(substrate=FreeFFTElasticHalfSpace((n, n), 1.0, size), surface=Topography(-heights(n), size))
    result = system.minimize_proxy(offset=DEPTH, maxiter=2000, pentol=1e-8 * DEPTH)
    return system.compute_normal_force() / FORCE - 1 if result.success else float("nan")


def slippy(n):
    import warnings

    warnings.filterwarnings("ignore")
    import slippy as package

    os.chdir(tempfile.mkdtemp())  # it writes result files where it runs

    package.CUDA = False
    import slippy.contact as contact
    import slippy.surface as surface

    step = 3 * RADIUS / n
    ball = surface.Surface(profile=heights(n).max() - heights(n), grid_spacing=step)
    flat = surface.FlatSurface(shift=(0, 0))
    # Two equal bodies of E = 2, ν = 0 make E* = 1.
    for body in (ball, flat):
        body.material = contact.Elastic(f"m{time.perf_counter_ns()}", {"E": 2.0, "v": 0.0}, use_frequency_domain=False)
    model = contact.ContactModel("hertz", ball, flat)
    model.add_step(contact.StaticStep("press", interference=DEPTH))
    with contextlib.redirect_stdout(io.StringIO()):
        result = model.solve()
    return np.array(result["loads_z"]).sum() * step**2 / FORCE - 1


def main():
    solve, n = globals()[sys.argv[1]], int(sys.argv[2])
    times = []
    for _ in range(int(sys.argv[3]) if len(sys.argv) > 3 else 3):
        start = time.process_time()
        error = solve(n)
        times.append(time.process_time() - start)
    memory = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
    print(f"{sys.argv[1]} {n} force_error {error:.3e} cpu_s {statistics.median(times):.3f} peak_mb {memory:.0f}")


main()
