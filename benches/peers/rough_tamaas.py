"""Ten loads on a periodic self-affine surface with tamaas, tolerance 1e-6, one thread.

usage: rough_tamaas.py N [HEIGHTS.npy]
H = 0.8, wave numbers 4…n/8 of 1/L, rms slope 0.1, pressures 0.0005…0.005 E*; writes the heights if a name is given,
for `cargo run --release -p benches --example halfspace_rough -- HEIGHTS.npy`.
"""
import os
import resource
import sys
import time

os.environ.setdefault("OMP_NUM_THREADS", "1")
import numpy as np
import tamaas as tm

tm.set_log_level(tm.LogLevel.error)
n = int(sys.argv[1])
spectrum = tm.Isopowerlaw2D()
spectrum.q0, spectrum.q1, spectrum.q2, spectrum.hurst = 4, 4, n // 8, 0.8
generator = tm.SurfaceGeneratorRandomPhase2D([n, n])
generator.random_seed, generator.spectrum = 1, spectrum
surface = np.array(generator.buildSurface())
surface *= 0.1 / tm.Statistics2D.computeSpectralRMSSlope(surface)
if len(sys.argv) > 2:
    np.save(sys.argv[2], -surface)  # heights away from the half-space

start = time.process_time()
model = tm.ModelFactory.createModel(tm.model_type.basic_2d, [1.0, 1.0], [n, n])
model.E, model.nu = 1.0, 0.0
solver = tm.PolonskyKeerRey(model, surface, 1e-6)
solver.max_iter = 3000
areas = []
for pressure in np.linspace(0.0005, 0.005, 10):
    solver.solve(float(pressure))
    areas.append(tm.Statistics2D.contact(model.traction))
elapsed = time.process_time() - start
memory = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
print(f"tamaas {n} cpu_s {elapsed:.3f} area_fractions {np.round(areas, 5).tolist()} peak_mb {memory:.0f}")
