#!/usr/bin/env python3
"""Lists a reproducible sample of a folder of ShaderToy exports, one path a line.

The order is that of the SHA-256 of the file names, so that anyone who has the same files gets the
same list. Only hashes that begin with 0 to 7 count: the other half is kept for acceptance.
"""

import argparse
import hashlib
import json
import os
import sys


def arguments():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", help="where the .json files lie")
    parser.add_argument("--count", type=int, default=5000, help="how many [default: 5000]")
    parser.add_argument(
        "--single",
        action="store_true",
        help="only shaders of one Image pass that reads no inputs",
    )
    parser.add_argument(
        "--busy",
        action="store_true",
        help="only shaders that read inputs or have several passes besides Common",
    )
    return parser.parse_args()


def in_order(folder):
    """The names of the half that may be looked at, in the order of their hashes."""
    names = (name for name in os.listdir(folder) if name.endswith(".json"))
    hashed = sorted((hashlib.sha256(os.fsencode(name)).hexdigest(), name) for name in names)
    return [name for digest, name in hashed if digest[0] in "01234567"]


def passes_of(path):
    with open(path, encoding="utf-8") as file:
        shader = json.load(file)
    if isinstance(shader, list):
        shader = shader[0]
    return shader.get("Shader", shader)["renderpass"]


def is_single(path):
    passes = passes_of(path)
    return len(passes) == 1 and passes[0]["type"] == "image" and not passes[0]["inputs"]


def is_busy(path):
    passes = passes_of(path)
    several = sum(one["type"] != "common" for one in passes) > 1
    return several or any(one["inputs"] for one in passes)


def main():
    options = arguments()
    left = options.count
    for name in in_order(options.folder):
        if left == 0:
            break
        path = os.path.join(options.folder, name)
        if options.single and not is_single(path):
            continue
        if options.busy and not is_busy(path):
            continue
        print(path)
        left -= 1
    if left:
        print(f"sample: {left} fewer than asked for: there are no more", file=sys.stderr)


if __name__ == "__main__":
    main()
