"""Ten loads on a periodic self-affine surface, tolerance 1e-6, one thread, with other packages.

usage: rough_peers.py tamaas|contactmechanics HEIGHTS.npy [N]
With N tamaas makes the surface and saves it: H = 0.8, wave numbers 4…n/8 of 1/L, rms slope 0.1, for
`cargo run --release -p benches --example halfspace_rough -- HEIGHTS.npy` and for each package. Pressures are 0.0005…0.005 E*;
prints the processor time of all ten, the contact fractions and the peak memory of the process.
"""
import os
import resource
import sys
import time

for name in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS"):
    os.environ.setdefault(name, "1")
import numpy as np

PRESSURES = np.linspace(0.0005, 0.005, 10)
TOLERANCE = 1e-6


def made(n):
    """Heights away from the half-space."""
    import tamaas as tm

    spectrum = tm.Isopowerlaw2D()
    spectrum.q0, spectrum.q1, spectrum.q2, spectrum.hurst = 4, 4, n // 8, 0.8
    generator = tm.SurfaceGeneratorRandomPhase2D([n, n])
    generator.random_seed, generator.spectrum = 1, spectrum
    surface = np.array(generator.buildSurface())
    return -surface * (0.1 / tm.Statistics2D.computeSpectralRMSSlope(surface))


def tamaas(heights):
    import tamaas as tm

    tm.set_log_level(tm.LogLevel.error)
    model = tm.ModelFactory.createModel(tm.model_type.basic_2d, [1.0, 1.0], list(heights.shape))
    model.E, model.nu = 1.0, 0.0
    solver = tm.PolonskyKeerRey(model, -heights, TOLERANCE)
    solver.max_iter = 3000
    for pressure in PRESSURES:
        solver.solve(float(pressure))
        yield tm.Statistics2D.contact(model.traction)


def contactmechanics(heights):
    from ContactMechanics import PeriodicFFTElasticHalfSpace, make_system
    from SurfaceTopography import Topography

    substrate = PeriodicFFTElasticHalfSpace(heights.shape, 1.0, (1.0, 1.0))
    system = make_system(substrate=substrate, surface=Topography(-heights, (1.0, 1.0), periodic=True))
    displacement = None
    for pressure in PRESSURES:
        # The largest penetration that is let pass, beside the scatter of the heights, which is of the order of the displacements.
        result = system.minimize_proxy(
            external_force=float(pressure), maxiter=3000, pentol=TOLERANCE * heights.std(), initial_displacements=displacement
        )
        if not result.success:
            raise RuntimeError(result.message)
        displacement = system.disp
        yield system.compute_contact_area()


def main():
    package, name = sys.argv[1], sys.argv[2]
    if len(sys.argv) > 3:
        np.save(name, made(int(sys.argv[3])))
    heights = np.load(name)
    start = time.process_time()
    areas = [float(area) for area in globals()[package](heights)]
    elapsed = time.process_time() - start
    memory = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
    print(f"{package} {heights.shape[0]} cpu_s {elapsed:.3f} area_fractions {np.round(areas, 5).tolist()} peak_mb {memory:.0f}")


main()
