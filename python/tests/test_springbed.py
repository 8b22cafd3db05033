"""The package as its users meet it; exact answers are closed forms."""

import math
import os
import pickle
import signal
import subprocess
import sys
import time

import numpy as np
import pytest

import springbed

HERTZ = """(
    title: "Steel ball",
    shape: Paraboloid(radius: "10 mm"),
    bodies: (Elastic(young: "210 GPa", poisson: 0.3), Rigid),
    history: [Indent(to: "1 um", over: 1), Indent(to: 0, over: 1)],
)"""

LENS = """(shape: Paraboloid(radius: "10 mm"), bodies: (Elastic(young: "1 MPa", poisson: 0.5), Rigid),
    adhesion: Jkr(work: "50 mJ/m^2"), history: [Press(to: "1 mN", over: 1), Retract(speed: "1 um/s")])"""


def hertz_force(depth, modulus, radius=0.01):
    return 4 / 3 * modulus * np.sqrt(radius) * depth**1.5


def test_a_scene_gives_arrays_by_the_names_of_their_columns():
    result = springbed.run(HERTZ)
    depth, force = result.records["indentation_m"], result.records["force_n"]
    assert isinstance(force, np.ndarray) and force.dtype == float
    assert np.allclose(force, hertz_force(depth, 210e9 / (1 - 0.3**2)), rtol=1e-13)
    assert result.results["largest_force_n"] == force.max()
    assert result.error_estimate.relative < 1e-9 and result.error_estimate.basis
    assert result.plan["solver"] and result.warnings == []
    field = result.fields["end of entry 1 (largest depth)"]
    peak = field["pressure_pa"][0]
    assert math.isclose(peak, result.results["peak_pressure_pa"], rel_tol=1e-12)
    assert set(result.tables) == {"pressure"}


def test_arrays_are_not_copied():
    force = springbed.run(HERTZ).records["force_n"]
    assert force.base is not None or force.flags.owndata
    assert force.flags.c_contiguous and force.flags.writeable


def test_a_scene_is_text_a_file_or_a_dict(tmp_path):
    text = springbed.run(HERTZ)
    (tmp_path / "ball.ron").write_text(HERTZ)
    file = springbed.run(tmp_path / "ball.ron")
    again = springbed.run(text.scene)
    for other in [file, again, springbed.run(str(tmp_path / "ball.ron"))]:
        assert other.results == text.results
        assert all(np.array_equal(other.records[name], text.records[name], equal_nan=True) for name in text.records)
    with pytest.raises(FileNotFoundError):
        springbed.run("there_is_none.ron")


def test_tables_are_looked_for_beside_the_scene(tmp_path):
    (tmp_path / "tip.csv").write_text("radius_m,height_m\n0,0\n1e-6,1e-7\n2e-6,4e-7\n4e-6,1.6e-6\n")
    (tmp_path / "tip.ron").write_text(
        '(shape: Table("tip.csv"), bodies: (Elastic(young: 1e9, poisson: 0.3), Rigid), history: [Indent(to: 1e-8, over: 1)])'
    )
    result = springbed.run(tmp_path / "tip.ron")
    assert result.results["largest_force_n"] > 0
    assert "<svg" in result.figure().svg


def test_values_are_set_by_path():
    stiffer = springbed.run(HERTZ, **{"bodies.0.young": "420 GPa", "history.0.to": 2e-6})
    right = hertz_force(2e-6, 420e9 / (1 - 0.3**2))
    assert math.isclose(stiffer.results["largest_force_n"], right, rel_tol=1e-13)
    assert stiffer.scene["bodies"][0]["Elastic"]["young"] == 420e9


def test_a_wrong_scene_is_told_with_all_its_problems():
    wrong = HERTZ.replace("10 mm", "10 kg").replace("poisson: 0.3", "poisson: 0.7")
    with pytest.raises(springbed.SceneError) as caught:
        springbed.run(wrong)
    problems = caught.value.problems
    assert len(problems) == 2 and problems[0].line == 3 and problems[1].line == 4
    assert problems[0].place == "line 3, column 31" and "expected a length" in problems[0].message
    assert "expected a length" in str(caught.value)
    again = pickle.loads(pickle.dumps(caught.value))
    assert again.problems == problems
    with pytest.raises(springbed.SceneError) as caught:
        springbed.run(HERTZ, **{"bodies.0.yung": 1})
    assert caught.value.problems[0].place == "bodies.0.yung"
    assert "did you mean `young`?" in caught.value.problems[0].message
    with pytest.raises(springbed.SceneError):
        springbed.check({"shape": 1})
    springbed.check(HERTZ)


def test_what_cannot_be_followed_is_an_error_of_its_own(tmp_path):
    (tmp_path / "tip.csv").write_text("radius_m,height_m\n0,0\n1e-8,1e-9\n2e-8,4e-9\n")
    (tmp_path / "tip.ron").write_text(
        '(shape: Table("tip.csv"), bodies: (Elastic(young: 1e9, poisson: 0.3), Rigid), history: [Indent(to: 1e-6, over: 1)])'
    )
    with pytest.raises((springbed.ComputationError, springbed.SceneError)):
        springbed.run(tmp_path / "tip.ron")


def test_results_are_pickled_and_draw_themselves_afterwards():
    result = springbed.run(LENS)
    again = pickle.loads(pickle.dumps(result))
    assert again.results == result.results and again.scene == result.scene
    assert again.figure().svg == result.figure().svg and result._repr_svg_().startswith("<svg")


def test_a_result_is_a_data_frame_if_pandas_is_there():
    pandas = pytest.importorskip("pandas")
    result = springbed.run(HERTZ)
    frame = result.to_pandas()
    assert isinstance(frame, pandas.DataFrame) and len(frame) == len(result.records["time_s"])
    assert "profile" in result.to_pandas("pressure")


def test_a_sweep_is_a_grid_of_its_values():
    swept = springbed.sweep(LENS, {"bodies.0.young": np.geomspace(1e5, 1e7, 4), "adhesion.work": ["10 mJ/m^2", 0.05]})
    assert len(swept) == 8 and swept.failures == {}
    assert np.array_equal(swept["adhesion.work"], [0.01, 0.05] * 4)
    pull_off = -1.5 * np.pi * swept["adhesion.work"] * 0.01
    assert np.allclose(swept["pull_off_force_n"], pull_off, rtol=1e-9)
    alone = springbed.run(LENS, **{"bodies.0.young": swept["bodies.0.young"][5], "adhesion.work": 0.05})
    for name, value in alone.results.items():
        assert swept[name][5] == value, name
    ranges = springbed.sweep(LENS, {"bodies.0.young": "100kPa..10MPa:4log", "adhesion.work": "[10 mJ/m^2,0.05]"})
    assert np.allclose(ranges["bodies.0.young"], swept["bodies.0.young"], rtol=1e-14)
    side = springbed.sweep(LENS, {"bodies.0.young": [1e6, 2e6], "adhesion.work": [0.1, 0.2]}, zip=True)
    assert len(side) == 2
    assert "adhesion.work" in side.parameters and "adhesion.work" not in side.results


def test_a_row_that_fails_is_there_with_its_reason(tmp_path):
    (tmp_path / "tip.csv").write_text("radius_m,height_m\n0,0\n1e-8,1e-9\n2e-8,4e-9\n")
    (tmp_path / "tip.ron").write_text(
        '(shape: Table("tip.csv"), bodies: (Elastic(young: 1e9, poisson: 0.3), Rigid), history: [Indent(to: 1e-9, over: 1)])'
    )
    swept = springbed.sweep(tmp_path / "tip.ron", {"history.0.to": [1e-9, 1e-6]})
    assert list(swept.failures) == [1] and np.isnan(swept["largest_force_n"][1])


def test_a_wrong_sweep_is_told_with_its_path():
    for values, place in [
        ({"bodies.0.yung": [1, 2]}, "bodies.0.yung"),
        ({"adhesion.work": ["1 kg"]}, "adhesion.work"),
        ({"friction.coefficient": [0.1]}, "friction.coefficient"),
        ({"bodies.0.young": []}, "bodies.0.young"),
    ]:
        with pytest.raises(springbed.SceneError) as caught:
            springbed.sweep(LENS, values)
        assert caught.value.problems[0].place == place


def test_contacts_are_moved_together():
    radius = np.linspace(1e-3, 1e-2, 1000)
    balls = springbed.Contact.paraboloid(radius, modulus=1e6)
    balls.advance(1e-5)
    assert len(balls) == 1000
    assert np.allclose(balls.force, hertz_force(1e-5, 1e6, radius), rtol=1e-13)
    assert np.allclose(balls.contact_radius, np.sqrt(radius * 1e-5), rtol=1e-13)
    kept = balls.copy()
    balls.press(np.linspace(1e-6, 1e-3, 1000))
    assert np.allclose(balls.force, np.linspace(1e-6, 1e-3, 1000), rtol=1e-12)
    assert np.allclose(kept.force, hertz_force(1e-5, 1e6, radius), rtol=1e-13)


def test_contacts_adhere_rub_and_relax():
    lenses = springbed.Contact.paraboloid(2.5e-3, modulus=6.4e6, work=[0.042, 0.084])
    lenses.press(0.048)
    lenses.press(-1.0)
    assert not lenses.joined.any() and (lenses.dissipated > 0).all() and np.isnan(lenses.indentation).all()
    ball = springbed.Contact.paraboloid(1.0, modulus=1.0, tangential_modulus=1.0, friction=0.3)
    ball.advance(1.0)
    ball.advance(1.0, 0.225)
    assert math.isclose(ball.stick_radius[0], 0.5, rel_tol=1e-13)
    assert math.isclose(ball.tangential_force[0], 0.35, rel_tol=1e-13)
    rubber = springbed.Contact.paraboloid(0.01, relaxation=(1e6, [(9e6, 0.1)], 0.0))
    rubber.advance(1e-4)
    rubber.advance(1e-4, seconds=0.1)
    modulus = 1e6 + 9e6 * math.exp(-1)
    assert math.isclose(rubber.force[0], hertz_force(1e-4, modulus), rel_tol=1e-9)
    assert math.isclose(springbed.Contact.cone(0.2, modulus=1e9).pressure(1e-6)[0], 0.0, abs_tol=0.0)


def test_wrong_contacts_are_refused():
    with pytest.raises(springbed.SceneError, match="contact 1: .*above zero"):
        springbed.Contact.sphere([1.0, -1.0], modulus=1.0)
    with pytest.raises(TypeError, match="its modulus or its relaxation"):
        springbed.Contact.sphere(1.0)
    with pytest.raises(ValueError, match="do not go together"):
        springbed.Contact.sphere([1.0, 2.0], modulus=[1.0, 2.0, 3.0])
    ball = springbed.Contact.sphere([1.0, 2.0], modulus=1.0)
    with pytest.raises(ValueError, match="expected one value or one each"):
        ball.advance([1.0, 2.0, 3.0])
    with pytest.raises(springbed.ComputationError, match="contact 1: "):
        ball.advance([0.1, math.nan])
    assert ball.force[0] > 0, "the other contact has been moved"


GEL = """(shape: Paraboloid(radius: "1 mm"), bodies: (Elastic(young: "5 kPa", poisson: 0.5), Rigid),
    history: [Indent(to: "10 um", over: 1)])"""


def hertz(young, touch=0.0):
    """A curve of F = (4/3)E*√R d^{3/2} that touches at ``touch``."""
    depth = np.linspace(0.0, 2e-5, 300)
    return {"depth": depth, "force": 4 / 3 * young / 0.75 * np.sqrt(1e-3) * np.clip(depth - touch, 0, None) ** 1.5}


def test_a_curve_gives_the_parameters_of_its_scene():
    found = springbed.fit(GEL, hertz(1e3, 2e-6), {"bodies.0.young": ("100 Pa", 1e6)})
    assert found["bodies.0.young"] == pytest.approx(1e3, rel=1e-6)
    assert found["contact_point"] == pytest.approx(2e-6, rel=1e-6)
    assert found.parameters["bodies.0.young"].unit == "Pa" and found.correlations.shape == (3, 3)
    assert found.points["counts"].all() and np.allclose(found.points["model"], found.points["force_n"], atol=1e-12)
    assert found.figure().svg.startswith("<svg") and pickle.loads(pickle.dumps(found))["bodies.0.young"] == found["bodies.0.young"]
    again = springbed.run(found.scene)
    assert again.results["largest_force_n"] == pytest.approx(4 / 3 * 1e3 / 0.75 * np.sqrt(1e-3 * 1e-15), rel=1e-5)


def test_files_records_and_several_curves_are_fitted(tmp_path):
    curve = hertz(2e3)
    rows = "\n".join(f"{float(d) * 1e9!r};{float(f) * 1e9!r}".replace(".", ",") for d, f in zip(curve["depth"], curve["force"]))
    (tmp_path / "gel.csv").write_text("z [nm];F [nN]\n" + rows + "\n")
    free = ["bodies.0.young=100 Pa..1 MPa"]
    options = {"baseline": "absent", "contact": "zero"}
    of_file, of_arrays = springbed.fit(GEL, [tmp_path / "gel.csv", curve], free, **options)
    assert of_file["bodies.0.young"] == pytest.approx(2e3, rel=1e-6)
    assert of_arrays["bodies.0.young"] == pytest.approx(2e3, rel=1e-9)
    records = springbed.run(GEL, **{"steps": 60}).records
    assert springbed.fit(GEL, records, free, **options)["bodies.0.young"] == pytest.approx(5e3, rel=1e-6)


def test_wrong_questions_are_refused():
    with pytest.raises(springbed.SceneError, match="bodies.0.youn"):
        springbed.fit(GEL, hertz(1e3), ["bodies.0.youn=1..2"])
    with pytest.raises(springbed.SceneError, match="[Tt]ilted"):
        springbed.fit(GEL, hertz(1e3), ["bodies.0.young"], baseline="tilted")
    with pytest.raises(springbed.ComputationError):
        springbed.fit(GEL, {"depth": [0.0, 1.0], "force": [0.0, 1.0]}, ["bodies.0.young"])
    with pytest.raises(ValueError, match="expected arrays"):
        springbed.fit(GEL, {"z": [0.0]}, ["bodies.0.young"])


def test_a_height_map_is_pressed_on_a_half_space():
    # Hertz: F = 4/3 E* √R d^(3/2), to a per cent on 128² pixels, 2 % in the area.
    radius, depth = 1e-2, 1e-6
    side = 3 * math.sqrt(radius * depth) / 128
    at = (np.arange(128) - 63.5) * side
    heights = (at[:, None] ** 2 + at[None, :] ** 2) / (2 * radius)
    pressed = springbed.half_space(heights, side, modulus=1e9, indentation=depth)
    assert math.isclose(pressed.force, hertz_force(depth, 1e9), rel_tol=0.01)
    assert math.isclose(pressed.contact_area, math.pi * radius * depth, rel_tol=0.05)
    assert pressed.pressure.shape == (128, 128) and pressed.pressure.max() == pressed.peak_pressure
    assert math.isclose(pressed.pressure.sum() * side**2, pressed.force, rel_tol=1e-12)
    again = springbed.half_space(heights, (side, side), modulus=1e9, force=pressed.force)
    assert math.isclose(again.indentation, depth, rel_tol=1e-4)
    with pytest.raises(TypeError):
        springbed.half_space(heights, side, modulus=1e9)
    with pytest.raises(springbed.ComputationError):
        springbed.half_space(heights, side, modulus=-1.0, force=1.0)


LONG = """
import springbed, sys
print("begun", flush=True)
lens = '''(shape: Paraboloid(radius: 0.01), bodies: (Elastic(young: 1e6, poisson: 0.5), Rigid),
    history: [Indent(to: 1e-5, over: 1)])'''
try:
    springbed.sweep(lens, {"bodies.0.young": "1..2:2000", "shape.radius": "1..2:2000"})
except KeyboardInterrupt:
    print("interrupted", flush=True)
    sys.exit(3)
"""


@pytest.mark.skipif(os.name != "posix", reason="signals of POSIX")
def test_ctrl_c_ends_long_work():
    run = subprocess.Popen([sys.executable, "-c", LONG], stdout=subprocess.PIPE, text=True)
    assert run.stdout.readline() == "begun\n"
    time.sleep(1.0)
    assert run.poll() is None
    begun = time.monotonic()
    run.send_signal(signal.SIGINT)
    said, _ = run.communicate(timeout=20)
    assert run.returncode == 3 and "interrupted" in said
    assert time.monotonic() - begun < 10


def test_other_threads_run_while_it_computes():
    import threading

    ticks = []
    ended = threading.Event()

    def tick():
        while not ended.is_set():
            ticks.append(time.monotonic())
            time.sleep(0.005)

    thread = threading.Thread(target=tick)
    thread.start()
    begun = time.monotonic()
    springbed.sweep(HERTZ, {"bodies.0.young": "1GPa..1TPa:4000log"})
    over = time.monotonic() - begun
    ended.set()
    thread.join()
    during = [at for at in ticks if begun < at < begun + over]
    # Half of the ticks there is time for, at least; with the lock held there would be none.
    assert len(during) > 0.1 * over / 0.005


def test_a_figure_is_saved_as_svg_png_and_pdf(tmp_path):
    figure = springbed.run(HERTZ).figure("paper")
    assert 'width="85mm"' in figure.svg
    for name, start in [("a.svg", b"<svg"), ("a.png", b"\x89PNG"), ("a.PDF", b"%PDF")]:
        figure.save(tmp_path / name)
        assert (tmp_path / name).read_bytes().startswith(start)
    figure.save(tmp_path / "small.png", dpi=100)
    assert (tmp_path / "small.png").stat().st_size < (tmp_path / "a.png").stat().st_size
    with pytest.raises(RuntimeError, match="expected one of screen, paper, paper-wide"):
        springbed.run(HERTZ).figure("poster")
