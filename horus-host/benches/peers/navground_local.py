"""Times navground's LocalGridMap on the poses and scans that the bench `local` wrote.

    python navground_local.py INPUT...

Needs `pip install navground==0.7.0 numpy`. Each INPUT is little-endian: u32 side, rays, steps, then f32 resolution,
start_angle, fov, max_range, radius, then per step f32 x, y, theta and the ranges. Prints one line per input: rays,
nanoseconds of thread CPU time per update (the lowest of several passes), FNV-1a (64 bits) of the last map.
Scans are injected into the sensing state; only `update` is timed.
"""

import struct
import sys
import time

import numpy as np
from navground import core, sim

PASSES = 7


def fnv1a64(data: bytes) -> int:
    value = 0xCBF29CE484222325
    for byte in data:
        value = (value ^ byte) * 0x100000001B3 & 0xFFFFFFFFFFFFFFFF
    return value


def run(path: str) -> None:
    with open(path, "rb") as file:
        data = file.read()
    side, rays, steps = struct.unpack_from("<3I", data)
    resolution, start_angle, fov, max_range, radius = struct.unpack_from("<5f", data, 12)
    records = np.frombuffer(data, "<f4", offset=32).reshape(steps, 3 + rays)
    best = None
    for _ in range(PASSES):
        grid = sim.state_estimations.LocalGridMapStateEstimation(
            external_lidars=["lidar"],
            external_odometry="odom",
            width=side,
            height=side,
            resolution=resolution,
            footprint=sim.state_estimations.LocalGridMapStateEstimation.FootprintType.rectangular,
            name="map",
        )
        agent = sim.Agent(radius=radius)
        world = sim.World()
        world.add_agent(agent)
        state = core.SensingState()
        f32 = np.float32
        for name, value in [("start_angle", start_angle), ("fov", fov), ("max_range", max_range)]:
            state.init_buffer("lidar/" + name, data=np.array([value], f32))
        ranges = state.init_buffer("lidar/range", data=np.zeros(rays, f32))
        pose = state.init_buffer("odom/pose", data=np.zeros(3, f32))
        state.init_buffer("odom/twist", data=np.zeros(3, f32))
        grid.prepare_state(state)
        spent = 0
        for record in records:
            pose.data = record[:3].astype(f32)
            ranges.data = record[3:].astype(f32)
            start = time.thread_time_ns()
            grid.update(agent, world, state)
            spent += time.thread_time_ns() - start
        best = spent if best is None else min(best, spent)
    cells = np.asarray(state.get_buffer("map/local_gridmap").data, np.uint8)
    print(rays, best / steps, f"{fnv1a64(cells.tobytes()):016x}", flush=True)


for argument in sys.argv[1:]:
    run(argument)
