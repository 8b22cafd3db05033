"""Measured-looking data of known truth for `springbed fit`: closed forms of the theory and noise, no springbed.

    python3 configs/fit/make_data.py        # writes the .csv files beside this script

Truth stands in each function and in the head of each file. Needs NumPy.
"""

import pathlib

import numpy as np

HERE = pathlib.Path(__file__).parent


def correlated(rng, count, deviation, rho):
    """Noise of the standard deviation `deviation` whose neighbours have the correlation `rho`."""
    noise = np.empty(count)
    noise[0] = rng.normal(0.0, deviation)
    for k in range(1, count):
        noise[k] = rho * noise[k - 1] + rng.normal(0.0, deviation * np.sqrt(1 - rho**2))
    return noise


def save(name, head, columns, form, separator=","):
    lines = [separator.join(form % value for value in row) for row in zip(*columns)]
    (HERE / name).write_text(head + "\n" + "\n".join(lines) + "\n", encoding="utf-8")


def gel_sphere():
    """Hertz: R = 5 um, E = 2.4 kPa, nu = 1/2, touched at z = 1.3 um, baseline 0.2 nN; noise 20 pN."""
    rng = np.random.default_rng(1)
    z = np.linspace(0.0, 3e-6, 1500)
    depth = np.clip(z - 1.3e-6, 0.0, None)
    force = 4 / 3 * 2.4e3 / 0.75 * np.sqrt(5e-6 * depth**3) + 0.2e-9
    force += correlated(rng, z.size, 20e-12, 0.0)
    save("gel_sphere.csv", "z [nm],force [nN]", (z * 1e9, force * 1e9), "%.5f")


def jkr(depth, radius, modulus, work):
    """Force of JKR at the depths of one way: none before touch, then the stable branch down to its end."""
    a = np.geomspace(1e-3, 30.0, 200000) * (work * radius**2 / modulus) ** (1 / 3)
    d = a**2 / radius - np.sqrt(2 * np.pi * a * work / modulus)
    stable = np.argmin(d)
    a, d = a[stable:], d[stable:]
    radius_at = np.interp(depth, d, a)
    for _ in range(4):  # Newton
        off = radius_at**2 / radius - np.sqrt(2 * np.pi * radius_at * work / modulus) - depth
        slope = 2 * radius_at / radius - 0.5 * np.sqrt(2 * np.pi * work / modulus / radius_at)
        radius_at = np.maximum(radius_at - off / slope, a[0])
    force = 4 / 3 * modulus * radius_at**3 / radius - np.sqrt(8 * np.pi * modulus * work * radius_at**3)
    return force, d[0]


def jkr_lens():
    """JKR in and out: R = 2.5 mm, E* = 6.4 MPa, w = 42 mJ/m^2, touched at z = 4 um; noise 20 uN, correlated 0.8."""
    rng = np.random.default_rng(2)
    into = np.linspace(0.0, 24e-6, 600)
    out = np.linspace(24e-6, -6e-6, 800)[1:]
    force_in, _ = jkr(into - 4e-6, 2.5e-3, 6.4e6, 0.042)
    force_in[into < 4e-6] = 0.0
    force_out, last = jkr(out - 4e-6, 2.5e-3, 6.4e6, 0.042)
    force_out[out - 4e-6 < last] = 0.0
    z = np.concatenate([into, out])
    force = np.concatenate([force_in, force_out]) + correlated(rng, z.size, 20e-6, 0.8)
    save("jkr_lens.csv", "z;F\num;mN", (z * 1e6, force * 1e3), "%.6f", ";")


def cell_on_glass():
    """A flat cell on glass, which sphere and base feel: R = 5 um, E = 1.5 kPa, nu = 1/2, 3 um thick and bonded; noise 15 pN, correlated 0.5.

    p(r) of the contact radius a has the transform int_0^a phi(t) cos(k t) dt, where (Lebedev & Ufliand 1958)
    phi(x) + 1/pi int_0^a phi(t) (M(x - t) + M(x + t)) dt = E*/pi (d - x^2/R), M(y) = int_0^oo (L(k h) - 1) cos(k y) dk,
    L(q) = (sinh 2q - 2q)/(cosh 2q + 2 q^2 + 1), phi(a) = 0 gives d, and F = 2 pi int phi.
    """
    rng = np.random.default_rng(12)
    radius, modulus, thickness = 5e-6, 1.5e3 / 0.75, 3e-6
    nodes, weights = np.polynomial.legendre.leggauss(40)
    q, by = np.polynomial.legendre.leggauss(400)
    q, by = 15 * (q + 1), 15 * by  # L = 1 beyond 30 to 1e-22
    with np.errstate(over="ignore"):
        lacking = (np.sinh(2 * q) - 2 * q) / (np.cosh(2 * q) + 2 * q**2 + 1) - 1

    def kernel(y):
        return np.cos(y[..., None] / thickness * q) @ (lacking * by) / thickness

    def pressed(a):
        x, w = 0.5 * a * (nodes + 1), 0.5 * a * weights
        matrix = np.eye(x.size) + (kernel(x[:, None] - x) + kernel(x[:, None] + x)) * w / np.pi
        one, other = np.linalg.solve(matrix, np.array([np.ones_like(x), x**2 / radius]).T).T
        row = (kernel(a - x) + kernel(a + x)) * w / np.pi
        depth = (a**2 / radius - row @ other) / (1 - row @ one)
        return depth, 2 * modulus * w @ (depth * one - other)

    table = np.array([(0.0, 0.0)] + [pressed(a) for a in np.linspace(0.02e-6, 3.2e-6, 400)])
    z = np.linspace(0.0, 1.6e-6, 800)
    depth = np.clip(z - 0.5e-6, 0.0, None)
    # F/d^(3/2) is smooth.
    force = depth**1.5 * np.interp(depth, table[1:, 0], table[1:, 1] / table[1:, 0] ** 1.5)
    force += correlated(rng, z.size, 15e-12, 0.5)
    save("cell_on_glass.csv", "z [nm],force [nN]", (z * 1e9, force * 1e9), "%.5f")


def fused_silica():
    """The way out of a diamond sphere on fused silica: R = 10 um, E = 72 GPa, nu = 0.17, diamond 1141 GPa and 0.07; from 10 mN.

    Hertz, F = 4/3 E* sqrt(R) (z - z0)^(3/2), touched last at z0 = 12 nm, baseline 3 uN; noise 5 uN, correlated 0.6.
    """
    rng = np.random.default_rng(11)
    modulus = 1 / ((1 - 0.17**2) / 72e9 + (1 - 0.07**2) / 1141e9)
    deepest = (10e-3 * 0.75 / (modulus * np.sqrt(10e-6))) ** (2 / 3)
    z = np.linspace(deepest + 12e-9, -20e-9, 600)
    force = 4 / 3 * modulus * np.sqrt(10e-6) * np.clip(z - 12e-9, 0.0, None) ** 1.5 + 3e-6
    force += correlated(rng, z.size, 5e-6, 0.6)
    save("fused_silica.csv", "depth (nm)\tload (uN)", (z * 1e9, force * 1e6), "%.5f", "\t")


def ting():
    """Ting's triangle on a standard solid: R = 10 um, G(t) = 300 Pa + 900 Pa exp(-t/0.2 s), nu = 1/2, touched at 0.3 um.

    F(t) = 4 sqrt(R)/3 int 4 G(t - s) d(depth^(3/2)); on the way out the integral ends at t1(t), where
    int_{t1}^t G(t - s) v(s) ds = 0.
    """
    rng = np.random.default_rng(7)
    radius, g0, g1, tau, speed, turn = 10e-6, 300.0, 900.0, 0.2, 2e-6, 1.0
    time = np.linspace(0.0, 2.0, 401)
    touch = 0.3e-6 / speed

    def history(until, now):
        """int_touch^until G(now - s) d/ds (v s)^(3/2) ds by Gauss-Legendre after s = touch + u^2."""
        if until <= touch:
            return 0.0
        nodes, weights = np.polynomial.legendre.leggauss(60)
        end = np.sqrt(until - touch)
        u = 0.5 * end * (nodes + 1)
        s = touch + u * u
        rate = 1.5 * speed**1.5 * u * 2 * u
        return 0.5 * end * np.sum(weights * (g0 + g1 * np.exp(-(now - s) / tau)) * rate)

    def area(low, high):
        """int_low^high G."""
        return g0 * (high - low) + g1 * tau * (np.exp(-low / tau) - np.exp(-high / tau))

    force = np.zeros_like(time)
    for k, t in enumerate(time):
        until = min(t, turn)
        if t > turn:
            # int_{t1}^{turn} G(t-s) ds = int_{turn}^{t} G(t-s) ds
            low, high = touch, turn
            balance = lambda s: area(t - turn, t - s) - area(0.0, t - turn)
            if balance(touch) < 0:
                continue
            for _ in range(80):
                middle = 0.5 * (low + high)
                low, high = (middle, high) if balance(middle) > 0 else (low, middle)
            until = 0.5 * (low + high)
        force[k] = 4 / 3 * np.sqrt(radius) * 4 * history(until, t)
    z = np.where(time < turn, speed * time, speed * (2 * turn - time))
    force += correlated(rng, time.size, 20e-12, 0.0)
    save("cell_ting.csv", "time_s\tz_um\tforce_nN", (time, z * 1e6, force * 1e9), "%.7g", "\t")


def power_law():
    """Ting's triangle on G(t) = 800 Pa (t/1 s)^(-0.2): R = 5 um, nu = 1/2, touched at 0.3 um; noise 20 pN.

    F(t) = 4 sqrt(R)/3 4 G0 3/2 v^(3/2) int_0^t1 (t - s)^(-b) sqrt(s) ds, t1 = t on the way in and
    t1 = t - 2^(1/(1-b)) (t - T) on the way out, T from first touch to the turn.
    """
    rng = np.random.default_rng(8)
    radius, modulus, beta, speed, turn = 5e-6, 800.0, 0.2, 2e-6, 0.5
    time = np.linspace(0.0, 1.0, 501)
    touch = 0.3e-6 / speed
    nodes, weights = np.polynomial.legendre.leggauss(200)

    def integral(t, t1):
        """int_0^t1 (t - s)^(-b) sqrt(s) ds; s = t - x^(1/(1-b)) takes the root of the power away, x = low + (high - low) y^2 that of s."""
        low, high = (t - t1) ** (1 - beta), t ** (1 - beta)
        y = 0.5 * (nodes + 1)
        s = t - (high - (high - low) * y * y) ** (1 / (1 - beta))
        return 0.5 * np.sum(weights * np.sqrt(np.clip(s, 0, None)) * 2 * (high - low) * y) / (1 - beta)

    force = np.zeros_like(time)
    for k, now in enumerate(time):
        t, top = now - touch, turn - touch
        t1 = t if t <= top else t - 2 ** (1 / (1 - beta)) * (t - top)
        if t > 0 and t1 > 0:
            force[k] = 4 / 3 * np.sqrt(radius) * 4 * modulus * 1.5 * speed**1.5 * integral(t, t1)
    z = np.where(time < turn, speed * time, speed * (2 * turn - time))
    force += correlated(rng, time.size, 20e-12, 0.0)
    save("cell_power_law.csv", "time_s\tz_um\tforce_nN", (time, z * 1e6, force * 1e9), "%.7g", "\t")


def creep():
    """Creep of a standard solid under a ball: R = 1 mm, 10 mN at once; J(t) = 1/G0 + (1/Ginf - 1/G0)(1 - exp(-t/q)).

    d^(3/2) = 3 F J(t) (1 - nu) / (8 sqrt R), G0 = 1 MPa, Ginf = 0.4 MPa, tau = 2 s, so q = tau G0/Ginf = 5 s; noise 20 nm.
    """
    rng = np.random.default_rng(4)
    time = np.linspace(0.0, 30.0, 301)
    compliance = 1e-6 + (2.5e-6 - 1e-6) * (1 - np.exp(-time / 5.0))
    depth = (3 * 10e-3 * compliance * 0.5 / (8 * np.sqrt(1e-3))) ** (2 / 3)
    depth += correlated(rng, time.size, 20e-9, 0.0)
    save("pdms_creep.csv", "Zeit (s);Weg (µm);Kraft (mN)", (time, depth * 1e6, np.full(time.size, 10.0)), "%.5f", ";")
    path = HERE / "pdms_creep.csv"
    path.write_text(path.read_text(encoding="utf-8").replace(".", ","), encoding="utf-8")


def rubber_moduli():
    """Storage and loss moduli of five terms, 1 % noise: G = 0.2 MPa + sum g w^2 t^2/(1 + w^2 t^2)."""
    rng = np.random.default_rng(5)
    terms = [(40e6, 1e-4), (20e6, 1e-3), (8e6, 1e-2), (2e6, 1e-1), (0.5e6, 1.0)]
    frequency = np.geomspace(1e-2, 1e4, 61)
    w = 2 * np.pi * frequency
    storage = 0.2e6 + sum(g * (w * t) ** 2 / (1 + (w * t) ** 2) for g, t in terms)
    loss = sum(g * w * t / (1 + (w * t) ** 2) for g, t in terms)
    storage *= 1 + 0.01 * rng.normal(size=w.size)
    loss *= 1 + 0.01 * rng.normal(size=w.size)
    save("rubber_moduli.csv", "frequency [Hz],G' [MPa],G'' [MPa]", (frequency, storage / 1e6, loss / 1e6), "%.6e")


def polymer_temperatures():
    """Moduli of a polymer at five temperatures: fifteen terms, log a = -8.86 (T - 300 K)/(101.6 K + T - 300 K), 1 % noise."""
    rng = np.random.default_rng(9)
    terms = [(300e6 * 0.4**k, 10 ** (-7 + 0.7 * k)) for k in range(15)]
    frequency = np.geomspace(0.01, 100, 25)
    rows = []
    for temperature in (263.15, 283.15, 303.15, 323.15, 343.15):
        by = temperature - 300.0
        w = 2 * np.pi * frequency * 10 ** (-8.86 * by / (101.6 + by))
        storage = 0.3e6 + sum(g * (w * t) ** 2 / (1 + (w * t) ** 2) for g, t in terms)
        loss = sum(g * w * t / (1 + (w * t) ** 2) for g, t in terms)
        storage *= 1 + 0.01 * rng.normal(size=w.size)
        loss *= 1 + 0.01 * rng.normal(size=w.size)
        rows.append((np.full(w.size, temperature - 273.15), frequency, storage / 1e6, loss / 1e6))
    columns = [np.concatenate(column) for column in zip(*rows)]
    save("polymer_temperatures.csv", "temperature [degC];frequency [Hz];G' [MPa];G'' [MPa]", columns, "%.6e", ";")


def steel_restitution():
    """Restitution of a steel ball that yields on a hard anvil: R = 5 mm, 7800 kg/m^3, E = 210 GPa, nu = 0.3, Y = 1.1 GPa; tungsten carbide 650 GPa and 0.22.

    Thornton (1997), J. Appl. Mech. 64, 383: with s = v_y/v, e = (6 sqrt(3)/5)^(1/2) (1 - s^2/6)^(1/2) (s/(s + 2 sqrt(6/5 - s^2/5)))^(1/4),
    v_y = (pi/2E*)^2 sqrt(8 pi R^3/15m) (1.6 Y)^(5/2); noise 0.01.
    """
    rng = np.random.default_rng(14)
    radius, mass = 5e-3, 4 / 3 * np.pi * 5e-3**3 * 7800
    modulus = 1 / ((1 - 0.3**2) / 210e9 + (1 - 0.22**2) / 650e9)
    yields = (np.pi / 2 / modulus) ** 2 * np.sqrt(8 * np.pi * radius**3 / 15 / mass) * (1.6 * 1.1e9) ** 2.5
    speed = np.geomspace(0.05, 8.0, 40)
    s = np.minimum(yields / speed, 1.0)
    e = np.sqrt(6 * np.sqrt(3) / 5 * (1 - s**2 / 6)) * (s / (s + 2 * np.sqrt(6 / 5 - s**2 / 5))) ** 0.25
    e = np.where(s < 1.0, e, 1.0) + correlated(rng, speed.size, 0.01, 0.0)
    save("steel_restitution.csv", "v [m/s],e", (speed, e), "%.5f")


def friction_loop():
    """Loop of a PDMS lens on glass under 50 mN: R = 5 mm, E = 2.2 MPa, nu = 1/2, mu = 0.8; noise 0.2 mN, correlated 0.5, on 1 mN.

    Cattaneo and Mindlin: with u* = mu (2 - nu)/(2 (1 - nu)) d all slips; F = mu P (1 - (1 - u/u*)^(3/2)) at first, and from
    each turn F_t on F = F_t -+ 2 mu P (1 - (1 - |u - u_t|/2u*)^(3/2)).
    """
    rng = np.random.default_rng(15)
    load, coefficient = 50e-3, 0.8
    depth = (0.75 * load / (2.2e6 / 0.75 * np.sqrt(5e-3))) ** (2 / 3)
    all_slips, most = coefficient * 1.5 * depth, coefficient * load

    def branch(way, scale):
        return scale * most * (1 - np.clip(1 - way / (scale * all_slips), 0.0, None) ** 1.5)

    top = 0.7 * all_slips
    first, back = np.linspace(0.0, top, 120), np.linspace(top, -top, 241)[1:]
    force = branch(first, 1.0)
    out = force[-1] - branch(top - back, 2.0)
    again = out[-1] + branch(back[::-1] + top, 2.0)
    slide = np.concatenate([first, back, back[::-1]])
    force = np.concatenate([force, out, again]) + 1e-3 + correlated(rng, slide.size, 0.2e-3, 0.5)
    save("friction_loop.csv", "x [um];Fx [mN]", (slide * 1e6, force * 1e3), "%.5f", ";")


if __name__ == "__main__":
    for make in (gel_sphere, cell_on_glass, fused_silica, jkr_lens, ting, power_law, creep, rubber_moduli, polymer_temperatures, steel_restitution, friction_loop):
        make()
