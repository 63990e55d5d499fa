"""Times OpenCV's exact distance transform on the maps that the bench `distance` wrote.

    python opencv_distance.py INPUT...

Needs `pip install opencv-python-headless numpy`. Each INPUT is a u32 side, little-endian, then a byte per cell, row by
row, 1 an obstacle. Prints one line per input: microseconds of thread CPU time (the median), and the sum of the squared
distances in cells, rounded to whole numbers.
"""

import struct
import sys
import time

import cv2
import numpy as np

cv2.setNumThreads(1)


def run(path: str) -> None:
    with open(path, "rb") as file:
        data = file.read()
    (side,) = struct.unpack_from("<I", data)
    cells = np.frombuffer(data, np.uint8, offset=4).reshape(side, side)
    free = (1 - cells) * np.uint8(255)
    times = []
    for _ in range(max(11, 8_000_000 // (side * side))):
        start = time.thread_time_ns()
        distances = cv2.distanceTransform(free, cv2.DIST_L2, cv2.DIST_MASK_PRECISE)
        times.append(time.thread_time_ns() - start)
    squared = np.rint(distances.astype(np.float64) ** 2)
    print(sorted(times)[len(times) // 2] / 1e3, int(squared.sum()))


for argument in sys.argv[1:]:
    run(argument)
