#!/usr/bin/env python3
"""Compares what Vitrine and WebGL2 accept, shader by shader.

WebGL2's verdicts come from the reference host: a folder with its `results.jsonl`, made with
`--compile-only` from the same list. Shaders on which it ran out of time are left out, and sound
passes do not count, since it only compiles them.
"""

import argparse
import collections
import json
import os
import re
import subprocess


def arguments():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("list", help="file of paths, one a line")
    parser.add_argument("reference", help="folder with the reference's results.jsonl")
    parser.add_argument("--vitrine", default="target/release/vitrine", help="the program")
    parser.add_argument("--files", type=int, default=5, help="names to print in each class")
    parser.add_argument("--keep", metavar="FILE", help="keep Vitrine's answers here")
    return parser.parse_args()


def reference_verdicts(folder):
    """Of each file name: accept or refuse, and the first message."""
    verdicts = {}
    with open(os.path.join(folder, "results.jsonl"), encoding="utf-8") as lines:
        for line in map(json.loads, lines):
            if line["status"] == "ok":
                verdicts[line["file"]] = ("accept", "")
            elif line["status"] in ("compile_failed", "link_failed"):
                verdicts[line["file"]] = ("refuse", first_message(line["passes"]))
    return verdicts


def first_message(passes):
    for one in passes:
        if one["type"] == "sound":
            continue
        log = (one.get("log") or "") + (one.get("linkLog") or "")
        for line in log.splitlines():
            if line.strip("\0 "):
                return masked(re.sub(r"^\w+: \d+:\d+: ", "", line), "'")
    return "no message"


def masked(message, quote):
    """A message without the names in it, so that equal problems are counted together."""
    return re.sub(f"{quote}[^{quote}]*{quote}", f"{quote}…{quote}", message)


def own_verdict(line):
    """Accept, refuse or what became of it instead, and the class of the first error."""
    if line["verdict"] in ("cut-off", "unreadable"):
        return line["verdict"], line["verdict"]
    passes = [one for one in line["passes"] if one["name"] != "Sound"]
    found = [line["diagnostics"]] + [one["diagnostics"] for one in passes]
    errors = [d for some in found for d in some if d["severity"] == "error"]
    if not errors:
        return "accept", ""
    return "refuse", f"{errors[0]['code']}: {masked(errors[0]['message'], '`')}"


def own_verdicts(options):
    command = [options.vitrine, "check", "--strict", "--format", "json", "--list", options.list]
    answer = subprocess.run(command, stdout=subprocess.PIPE, check=False, encoding="utf-8")
    if options.keep:
        with open(options.keep, "w", encoding="utf-8") as file:
            file.write(answer.stdout)
    lines = map(json.loads, answer.stdout.splitlines())
    return {os.path.basename(line["file"]): own_verdict(line) for line in lines}


def table(title, classes, limit):
    print(f"\n{title}: {sum(map(len, classes.values()))}")
    for name, files in sorted(classes.items(), key=lambda item: (-len(item[1]), item[0])):
        more = f" and {len(files) - limit} more" if len(files) > limit else ""
        print(f"{len(files):6}  {name}\n        {' '.join(files[:limit])}{more}")


def share(part, whole):
    return f"{part} of {whole}" + (f", {100 * part / whole:.2f} %" if whole else "")


def main():
    options = arguments()
    reference = reference_verdicts(options.reference)
    own = own_verdicts(options)
    both = [name for name in own if name in reference]
    counts = collections.Counter()
    refused_here = collections.defaultdict(list)
    accepted_here = collections.defaultdict(list)
    for name in both:
        (theirs, message), (ours, problem) = reference[name], own[name]
        counts[theirs, ours == "accept"] += 1
        if theirs == "accept" and ours != "accept":
            refused_here[problem].append(name)
        if theirs == "refuse" and ours == "accept":
            accepted_here[message].append(name)
    accepted = counts["accept", True] + counts["accept", False]
    refused = counts["refuse", True] + counts["refuse", False]
    agreed = counts["accept", True] + counts["refuse", False]
    print(f"compared              {len(both)} (left out: {len(own) - len(both)})")
    print(f"same verdict          {share(agreed, len(both))}")
    print(f"accepted, of WebGL2's {share(counts['accept', True], accepted)}")
    print(f"refused, of WebGL2's  {share(counts['refuse', False], refused)}")
    table("refused here, accepted by WebGL2", refused_here, options.files)
    table("accepted here, refused by WebGL2", accepted_here, options.files)


if __name__ == "__main__":
    main()
