"""Reads logs with `mcap-ros2-support` and with `rosbags`, and compares every value the two see.

Usage: read.py LOG... ; prints one line per log; exit code 1 and a sentence at the first difference.
"""

import collections
import pathlib
import sys

from mcap.reader import make_reader
from mcap_ros2.decoder import DecoderFactory
from rosbags.highlevel import AnyReader


def plain(value):
    """Messages, arrays and numbers of either reader as nested tuples of Python values."""
    if hasattr(value, "tolist"):  # numpy
        return plain(value.tolist())
    if isinstance(value, (bytes, bytearray)):
        return tuple(value)
    if isinstance(value, (list, tuple)):
        return tuple(plain(element) for element in value)
    if isinstance(value, float):
        return value.hex() if value == value else "nan"
    if isinstance(value, (int, str, bool)):
        return value
    fields = getattr(value, "__slots__", None) or vars(value)
    names = sorted(name for name in fields if not name.startswith("_"))
    return tuple((name, plain(getattr(value, name))) for name in names)


def with_mcap(path):
    """Topic -> list of (time, message), by mcap-ros2-support, chunk checksums verified."""
    topics = collections.defaultdict(list)
    with open(path, "rb") as file:
        reader = make_reader(file, validate_crcs=True, decoder_factories=[DecoderFactory()])
        for _schema, channel, message, decoded in reader.iter_decoded_messages():
            topics[channel.topic].append((message.log_time, plain(decoded)))
    return topics


def with_rosbags(path):
    """The same by rosbags, from the definitions in the file."""
    topics = collections.defaultdict(list)
    with AnyReader([pathlib.Path(path)]) as reader:
        for connection, time, raw in reader.messages():
            decoded = reader.deserialize(raw, connection.msgtype)
            topics[connection.topic].append((time, plain(decoded)))
    return topics


def without(message, name):
    """A message without a field that only one reader adds."""
    if isinstance(message, tuple):
        return tuple(
            without(part, name)
            for part in message
            if not (isinstance(part, tuple) and len(part) == 2 and part[0] == name)
        )
    return message


def main(paths):
    for path in paths:
        one, two = with_mcap(path), with_rosbags(path)
        if sorted(one) != sorted(two):
            sys.exit(f"{path}: topics {sorted(one)} against {sorted(two)}")
        for topic in sorted(one):
            if len(one[topic]) != len(two[topic]):
                sys.exit(f"{path} {topic}: {len(one[topic])} messages against {len(two[topic])}")
            for number, (a, b) in enumerate(zip(one[topic], two[topic])):
                # rosbags keeps the type's name in each message.
                if a != (b[0], without(b[1], "__msgtype__")):
                    sys.exit(f"{path} {topic}: message {number} differs")
        counts = ", ".join(f"{topic} {len(one[topic])}" for topic in sorted(one))
        print(f"{path}: {counts}: equal")


if __name__ == "__main__":
    main(sys.argv[1:])
