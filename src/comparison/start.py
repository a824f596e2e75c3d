"""Measures whole commands, from their start to the written picture, and draws error against time.

Each renders the Cornell box, 320x240, with 1, 4, 16 and 64 samples per pixel. Contestants take turns. The error, relMSE, is
that of the picture against a reference of the first contestant, whose own error is subtracted: the means of all agree within
0.3 %. See README.md.
"""

import argparse
import json
import math
import os
import pathlib
import resource
import statistics
import subprocess
import sys
import time

import numpy as np

HERE = pathlib.Path(__file__).resolve().parent
HOME = HERE.parents[1]
WORK = HOME / "target" / "comparison" / "start"
SAMPLES = (1, 4, 16, 64)
REFERENCE = 256
COLOURS = ("#d62728", "#ff9896", "#1f77b4", "#aec7e8", "#2ca02c", "#9467bd")


def contestants(arguments):
    """Returns the command of each contestant as a function of samples, seed and output."""

    def lumbre(java):
        def command(samples, seed, out):
            flags = ["--size", "320x240", "-s", str(samples), "--seed", str(seed), "--progress", "none", "--overwrite"]
            return [str(HOME / "lumbre"), "render", str(HOME / "scenes" / "cornell-box.json"), *flags, "-o", out + ".pfm"]

        return command, {"JAVA_HOME": java}

    def program(python, name):
        return (lambda samples, seed, out: [python, str(HERE / "start_programs.py"), name, str(samples), str(seed), out]), {}

    result = {f"Lumbre, Java {number}": lumbre(java) for number, java in (java.split("=") for java in arguments.java)}
    if arguments.peers:
        for title, name in (("Mitsuba llvm", "mitsuba-llvm"), ("Mitsuba scalar", "mitsuba-scalar"), ("LuxCore", "luxcore")):
            result[title] = program(arguments.peers, name)
    if arguments.blender:
        result["Cycles"] = program(arguments.blender, "cycles")
    return result


def run(contestant, samples, seed, name):
    """Runs a command; returns its picture, wall time and processor time."""
    command, variables = contestant
    out = str(WORK / name)
    before, start = resource.getrusage(resource.RUSAGE_CHILDREN), time.perf_counter()
    subprocess.run(command(samples, seed, out), check=True, env=os.environ | variables, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    wall, after = time.perf_counter() - start, resource.getrusage(resource.RUSAGE_CHILDREN)
    cpu = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    return picture(out), wall, cpu


def picture(out):
    if os.path.exists(out + ".pfm"):
        with open(out + ".pfm", "rb") as file:
            assert file.readline() == b"PF\n"
            width, height = map(int, file.readline().split())
            file.readline()
            return np.frombuffer(file.read(), "<f4").reshape(height, width, 3)[::-1].astype(float)
    if os.path.exists(out + ".exr"):
        import OpenEXR

        with OpenEXR.File(out + ".exr", separate_channels=True) as file:
            channels = file.channels()
            return np.stack([channels[name].pixels for name in "RGB"], -1).astype(float)
    return np.load(out + ".npy").astype(float)


def squared(difference, truth):
    return float(np.mean(difference**2 / (truth**2 + 0.01)))


def reference(contestant):
    """Returns a reference of the first contestant and its own error; it is kept, since it needs no clock."""
    path = WORK / "reference.npy"
    if not path.exists():
        np.save(path, np.stack([run(contestant, REFERENCE, seed, "reference")[0] for seed in (1001, 1002)]))
    a, b = np.load(path)
    return (a + b) / 2, squared((a - b) / 2, (a + b) / 2)


def measure(all_, arguments, results):
    truth, own = reference(next(iter(all_.values())))
    for name, contestant in all_.items():
        run(contestant, 1, 1, "picture-" + name)  # The first run makes archives of classes or caches of kernels.
    for turn in range(arguments.rounds):
        order = [(name, samples) for samples in arguments.samples for name in all_]
        for name, samples in order if turn % 2 == 0 else order[::-1]:
            seed = 1 + len(results.get(name, {}).get(str(samples), []))
            found, wall, cpu = run(all_[name], samples, seed, "picture-" + name)
            error = max(squared(found - truth, truth) - own, 1e-9)
            results.setdefault(name, {}).setdefault(str(samples), []).append([wall, cpu, error])


def medians(results):
    """Returns (samples, wall, cpu, error) by contestant, medians of the rounds."""
    return {
        name: [(int(samples), *(statistics.median(row[i] for row in rows) for i in range(3))) for samples, rows in by.items()]
        for name, by in results.items()
    }


def table(found):
    lines = ["| command | " + " | ".join(f"{s} samples" for s in SAMPLES) + " |", "|---|" + "--:|" * len(SAMPLES)]
    for name, rows in found.items():
        cells = (f"{cpu:.2f} s, {wall:.1f} s, {error:.2g}" for _, wall, cpu, error in sorted(rows))
        lines.append(f"| {name} | " + " | ".join(cells) + " |")
    return "\n".join(lines)


def plot(found, axis, label):
    """Returns a log-log plot as SVG; axis 1 is the wall time, 2 the processor time."""
    points = [(row[axis], row[3]) for rows in found.values() for row in rows]
    low = [math.log10(min(p[i] for p in points)) - 0.1 for i in (0, 1)]
    high = [math.log10(max(p[i] for p in points)) + 0.1 for i in (0, 1)]
    x = lambda v: 70 + 500 * (math.log10(v) - low[0]) / (high[0] - low[0])
    y = lambda v: 340 - 310 * (math.log10(v) - low[1]) / (high[1] - low[1])
    out = ['<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 720 390" font-family="sans-serif" font-size="12">',
           '<rect width="720" height="390" fill="#fff"/>']
    for exponent in range(-6, 4):
        for digit in (1, 2, 5):
            v = digit * 10.0**exponent
            if low[0] <= math.log10(v) <= high[0]:
                out.append(f'<path d="M{x(v):.1f} 30V340" stroke="#ddd"/><text x="{x(v):.1f}" y="356" text-anchor="middle">{v:g}</text>')
            if low[1] <= math.log10(v) <= high[1]:
                out.append(f'<path d="M70 {y(v):.1f}H570" stroke="#ddd"/><text x="64" y="{y(v) + 4:.1f}" text-anchor="end">{v:g}</text>')
    for i, (name, rows) in enumerate(found.items()):
        at = [(x(row[axis]), y(row[3])) for row in sorted(rows)]
        path = "L".join(f"{a:.1f} {b:.1f}" for a, b in at)
        out.append(f'<path d="M{path}" fill="none" stroke="{COLOURS[i]}" stroke-width="2"/>')
        out += [f'<circle cx="{a:.1f}" cy="{b:.1f}" r="3.5" fill="{COLOURS[i]}"/>' for a, b in at]
        out.append(f'<path d="M585 {45 + 20 * i}h20" stroke="{COLOURS[i]}" stroke-width="3"/><text x="610" y="{49 + 20 * i}">{name}</text>')
    out.append(f'<text x="320" y="378" text-anchor="middle">{label}</text>')
    out.append('<text x="18" y="185" text-anchor="middle" transform="rotate(-90 18 185)">relMSE</text></svg>')
    return "\n".join(out) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--java", action="append", default=[], metavar="NUMBER=HOME", help="a JDK; once for each")
    parser.add_argument("--peers", metavar="PYTHON", help="a Python with mitsuba and pyluxcore")
    parser.add_argument("--blender", metavar="PYTHON", help="a Python with bpy 5")
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--samples", type=int, nargs="+", default=SAMPLES)
    parser.add_argument("--reference", action="store_true", help="render the reference only")
    arguments = parser.parse_args()
    WORK.mkdir(parents=True, exist_ok=True)
    all_ = contestants(arguments)
    reference(next(iter(all_.values())))
    if arguments.reference:
        return
    path = WORK / "results.json"
    results = json.loads(path.read_text()) if path.exists() else {}
    measure(all_, arguments, results)
    path.write_text(json.dumps(results))
    found = medians(results)
    print("Processor time, wall time, relMSE:\n\n" + table(found))
    (WORK / "wall.svg").write_text(plot(found, 1, "wall time from the start of the command, s"))
    (WORK / "cpu.svg").write_text(plot(found, 2, "processor time of the whole command, s"))


if __name__ == "__main__":
    sys.exit(main())
