#!/usr/bin/env python3
"""Compares Vitrine's pictures with those of WebGL2, shader by shader.

The reference host's pictures are made from the same list, at the same size and time. Two pictures
agree where at least 99 % of the pixels lie within 2/255 in every channel. Needs Pillow and NumPy.
"""

import argparse
import concurrent.futures
import json
import os
import subprocess
import tempfile

import numpy
from PIL import Image

NEAR = 2
ENOUGH = 0.99


def arguments():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("list", help="file of paths, one a line")
    parser.add_argument("reference", help="folder with the reference's results.jsonl and pictures")
    parser.add_argument("--vitrine", default="target/release/vitrine", help="the program")
    parser.add_argument("--size", default="192x108", help="size of the pictures")
    parser.add_argument("--time", type=float, default=1.0, help="their time in seconds")
    parser.add_argument(
        "--frames",
        action="store_true",
        help="compare the frame that the reference drew last, not a time",
    )
    parser.add_argument(
        "--media", metavar="FOLDER", help="the media that the reference had; without one it had none"
    )
    parser.add_argument(
        "--lowp", action="store_true", help="read textures in 16 bits, as llvmpipe does"
    )
    parser.add_argument("--adapter", default="cpu", help="the adapter to draw with")
    parser.add_argument("--jobs", type=int, default=os.cpu_count(), help="pictures at once")
    parser.add_argument("--timeout", type=float, default=120, help="seconds for one picture")
    parser.add_argument("--keep", metavar="FOLDER", help="keep Vitrine's pictures here")
    return parser.parse_args()


def draw(options, path, out, frame):
    """Draws one picture; says what went wrong, or nothing."""
    command = [options.vitrine, "export", path, "--out", out, "--overwrite", "--no-stand-ins"]
    command += ["--size", options.size]
    if options.frames:
        command += ["--frames", f"{frame}..{frame + 1}"]
    else:
        command += ["--time", str(options.time)]
    if options.media:
        command += ["--media", options.media]
    if options.lowp:
        command.append("--lowp")
    command += ["--adapter", options.adapter, "--frame-timeout", str(options.timeout)]
    try:
        done = subprocess.run(
            command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, timeout=2 * options.timeout
        )
    except subprocess.TimeoutExpired:
        return "timeout"
    if done.returncode == 0:
        return ""
    lines = done.stderr.decode("utf-8", "replace").splitlines()
    said = next((line for line in lines if line.startswith("error")), "no message")
    return ("refused: " if done.returncode == 1 else "failed: ") + said


def share_near(one, other):
    """The share of pixels that are near each other in every channel; None where sizes differ."""
    one, other = (numpy.asarray(Image.open(path).convert("RGB"), dtype=int) for path in (one, other))
    if one.shape != other.shape:
        return None
    return float((abs(one - other).max(axis=2) <= NEAR).mean())


def compare(options, path, reference, folder):
    reference, frame = reference
    out = os.path.join(folder, os.path.basename(path) + ".png")
    problem = draw(options, path, out, frame)
    if problem:
        return problem, None
    share = share_near(out, reference)
    return ("the sizes differ", None) if share is None else ("", share)


def reference_pictures(options):
    """Of each file name the picture at the time asked for, or the last one, and its frame number."""
    pictures = {}
    with open(os.path.join(options.reference, "results.jsonl"), encoding="utf-8") as lines:
        for line in map(json.loads, lines):
            for one in line.get("files") or []:
                is_it = options.frames or abs(one["time"] - options.time) < 1e-6
                if line["status"] == "ok" and is_it:
                    picture = os.path.join(options.reference, one["file"])
                    pictures[line["file"]] = (picture, one["frame"])
    return pictures


def main():
    options = arguments()
    pictures = reference_pictures(options)
    with open(options.list, encoding="utf-8") as lines:
        paths = [line.rstrip("\n") for line in lines if line.strip()]
    wanted = [path for path in paths if os.path.basename(path) in pictures]
    if options.keep:
        os.makedirs(options.keep, exist_ok=True)
    with tempfile.TemporaryDirectory() as temporary:
        folder = options.keep or temporary
        with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
            results = list(pool.map(
                lambda path: compare(options, path, pictures[os.path.basename(path)], folder),
                wanted,
            ))
    drawn = [(share, path) for path, (_, share) in zip(wanted, results) if share is not None]
    different = sorted((share, path) for share, path in drawn if share < ENOUGH)
    agreed = len(drawn) - len(different)
    percent = f", {100 * agreed / len(drawn):.2f} %" if drawn else ""
    print(f"not in the reference  {len(paths) - len(wanted)}")
    print(f"not drawn here        {len(wanted) - len(drawn)}")
    print(f"drawn by both         {len(drawn)}")
    print(f"of them alike         {agreed}{percent}")
    for title, rows in (
        ("different, with the share of near pixels", [(f"{s:7.4f}", p) for s, p in different]),
        ("not drawn here", [(w, p) for p, (w, s) in zip(wanted, results) if s is None]),
    ):
        print(f"\n{title}: {len(rows)}")
        for what, path in rows:
            print(f"{os.path.basename(path)}  {what}")


if __name__ == "__main__":
    main()
