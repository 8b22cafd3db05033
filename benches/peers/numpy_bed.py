"""A spring bed as a user writes it in an afternoon: error and time of four cases of `springbed report accuracy`.

usage: numpy_bed.py [SPRINGS]
R = E* = 1; springs at the middle of their cells, the whole bed kept, a clock around each case, least of seven.
"""
import math
import sys
import time

import numpy as np

DEPTH = 0.01
RADIUS = math.sqrt(DEPTH)
FORCE = 4 / 3 * DEPTH**1.5


def bed(count, reach):
    width = 2 * reach / count
    place = (np.arange(count) + 0.5) * width - reach
    return place, width


def hertz(count):
    place, width = bed(count, math.sqrt(math.pi / 2) * RADIUS)
    load = np.maximum(DEPTH - place**2, 0.0)
    radius = 0.5 * width * np.count_nonzero(load)
    middle, fall = 0.5 * (place[1:] + place[:-1]), -np.diff(load)
    peak = np.sum(fall[middle > 0] / middle[middle > 0]) / math.pi
    assert abs(radius / RADIUS - 1) < 1e-2 and abs(peak * math.pi / (2 * RADIUS) - 1) < 1e-2
    return abs(load.sum() * width / FORCE - 1)


def jkr(count):
    """400 steps from d = 2 to −1.6, edge springs let go one by one beyond √(2πxw/E*); w = 1."""
    place, width = bed(count, 3.2)
    half, height = place[count // 2:], place[count // 2:] ** 2
    limit = height - np.sqrt(2 * math.pi * half)
    sums = np.concatenate([[0.0], np.cumsum(height)])
    held, least = np.searchsorted(limit, 2.0), 0.0
    for depth in np.linspace(2.0, -1.6, 401):
        while held and limit[held - 1] > depth:
            held -= 1
        least = min(least, 2 * width * (held * depth - sums[held]))
    return abs(least / (-1.5 * math.pi) - 1)


def ting(count, steps, exponential):
    """In by 0.01 in a second and out again, E* = 0.4 + 3.6 exp(−t/0.2); force at the turn and after 1.2 s."""
    place, width = bed(count, 0.11)
    height, step = place**2, 2.0 / steps
    pressed, element, forces = np.zeros(count), np.zeros(count), {}
    keep = math.exp(-step / 0.2) if exponential else 1 - step / 0.2
    gain = 3.6 * ((1 - keep) * 0.2 / step if exponential else 1.0)
    for k in range(1, steps + 1):
        now = np.maximum(0.01 * (1 - abs(1 - k * step)) - height, 0.0)
        element = keep * element + gain * (now - pressed)
        pressed = now
        if k in (steps // 2, 3 * steps // 5):
            load = np.maximum(0.4 * now + element, 0.0)
            forces[k] = width * load[now > 0].sum()
    turn, after = (forces[k] for k in sorted(forces))
    return max(abs(turn - 1.80671802e-3), abs(after - 9.472905e-5)) / 1.80671802e-3


def mindlin(count):
    """Sheared to 90 % of gross slip in 200 steps, μ = 0.3, G* = E*."""
    place, width = bed(count, 1.1 * RADIUS)
    limit = 0.3 * np.maximum(DEPTH - place**2, 0.0)
    slide = 0.3 * DEPTH * (1 - 0.1 ** (2 / 3))
    load = np.zeros(count)
    for _ in range(200):
        load = np.clip(load + slide / 200, -limit, limit)
    return abs(width * load.sum() / (0.9 * 0.3 * FORCE) - 1)


def least_time(case):
    times = []
    for _ in range(7):
        start = time.perf_counter()
        error = case()
        times.append(time.perf_counter() - start)
    return error, min(times)


def main():
    count = int(sys.argv[1]) if len(sys.argv) > 1 else 10_000
    cases = {
        "hertz": lambda: hertz(count),
        "jkr, 400 steps": lambda: jkr(count),
        "ting, 1000 steps, explicit Euler": lambda: ting(count, 1000, False),
        "ting, 1000 steps, exponential update": lambda: ting(count, 1000, True),
        "mindlin, 200 steps": lambda: mindlin(count),
    }
    for name, case in cases.items():
        error, seconds = least_time(case)
        print(f"{name:40} springs {count} error {error:.1e} time_s {seconds:.2e}")


main()
