"""Sweeps on a cluster of processes, one of which is killed."""

import os
import signal
import threading
import time

import numpy as np
import pytest

import springbed

distributed = pytest.importorskip("distributed")

LENS = """(shape: Paraboloid(radius: "10 mm"), bodies: (Elastic(young: "1 MPa", poisson: 0.5), Rigid),
    adhesion: Jkr(work: "50 mJ/m^2"), history: [Press(to: "1 mN", over: 1), Retract(speed: "1 um/s")])"""
VALUES = {"bodies.0.young": "100kPa..10MPa:60log", "adhesion.work": "[0.01,0.02,0.05,0.1]"}


@pytest.fixture
def cluster():
    with distributed.LocalCluster(
        n_workers=3, threads_per_worker=1, processes=True, dashboard_address=None, silence_logs=50
    ) as cluster, distributed.Client(cluster) as client:
        yield client


def same(one, other):
    assert list(one.columns) == list(other.columns) and one.paths == other.paths
    for name, column in one.columns.items():
        if isinstance(column, list):
            assert column == other[name]
        else:
            assert np.array_equal(column, other[name], equal_nan=True), name


def test_a_cluster_gives_what_one_machine_does(cluster):
    same(springbed.sweep(LENS, VALUES, client=cluster), springbed.sweep(LENS, VALUES))


def test_the_work_of_a_lost_worker_is_done_again(cluster):
    values = {"bodies.0.young": "100kPa..10MPa:3000log", "adhesion.work": "[0.01,0.02,0.05,0.1]"}
    processes = list(cluster.run(os.getpid).values())
    killed = []

    def kill():
        while not cluster.processing() or not any(cluster.processing().values()):
            time.sleep(0.005)
        os.kill(processes[0], signal.SIGKILL)
        killed.append(processes[0])

    killer = threading.Thread(target=kill)
    killer.start()
    swept = springbed.sweep(LENS, values, client=cluster)
    killer.join()
    assert killed
    same(swept, springbed.sweep(LENS, values))


def test_a_wrong_sweep_is_told_before_anything_is_sent(cluster):
    with pytest.raises(springbed.SceneError):
        springbed.sweep(LENS, {"bodies.0.yung": [1.0]}, client=cluster)
