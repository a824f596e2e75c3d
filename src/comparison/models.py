"""Measures pictures of models from the start of the command to the written PNG file, beside F3D and Blender; see README.md.

Thumbnails have 256x192 pixels and 2 samples, beside F3D, a rasterizer; clean pictures 512x512 pixels and 8 samples, beside Cycles with
as many and Open Image Denoise. All are denoised, and their contestants take turns. With --many, all models but ten are drawn in one
process after those ten; Lumbre's time for each is the difference of two commands.
"""

import argparse
import os
import pathlib
import resource
import statistics
import subprocess
import sys
import time

from measure import table

HERE = pathlib.Path(__file__).resolve().parent
HOME = HERE.parents[1]
WORK = HOME / "target" / "comparison" / "models"
FIRST = 10


def lumbre(java, models, out, size, samples):
    flags = ["--size", size, "-s", samples, "--overwrite", "--quiet", "-o", out]
    return [str(HOME / "lumbre"), "render", *models, *flags], os.environ | {"JAVA_HOME": java}


def program(python, name, models, out):
    return [python, str(HERE / "model_programs.py"), name, out, *models], os.environ


def run(command):
    """Runs a command; returns its processor time, its time on the clock, and what it prints."""
    before, start = resource.getrusage(resource.RUSAGE_CHILDREN), time.perf_counter()
    done = subprocess.run(command[0], env=command[1], capture_output=True, text=True)
    wall, after = time.perf_counter() - start, resource.getrusage(resource.RUSAGE_CHILDREN)
    if done.returncode:
        sys.exit(f"{command[0]} failed:\n{done.stdout[-1000:]}{done.stderr[-1000:]}")
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime, wall, done.stdout


def alone(title, contestants, models, rounds):
    """Prints medians of each contestant over all models, and ratios of processor time to the last one's."""
    costs = {name: {model: [] for model in models} for name in contestants}
    for turn in range(rounds + 1):
        for model in models:
            for name, command in contestants.items():
                cost = run(command(model))
                if turn > 0:  # The first run makes archives of classes.
                    costs[name][model].append(cost)
    *_, peer = contestants

    def median(name, model, index):
        return statistics.median(cost[index] for cost in costs[name][model])

    rows = []
    for name in contestants:
        ratios = [median(name, model, 0) / median(peer, model, 0) for model in models]
        means = [statistics.fmean(median(name, model, index) for model in models) for index in range(2)]
        rows.append((name, *(f"{mean:.2f} s" for mean in means), f"{statistics.fmean(ratios):.2f} ({min(ratios):.2f} to {max(ratios):.2f})"))
    print(table((title, "processor", "clock", "times the last"), rows), flush=True)


def together(javas, python, models):
    """Prints the processor time for each model but the first ten, in one process."""
    rows = []
    for number, java in javas:
        times = [run(lumbre(java, part, str(WORK / "many"), "256x192", "2"))[0] for part in (models[:FIRST], models)]
        rows.append((f"Lumbre, Java {number}", f"{(times[1] - times[0]) / (len(models) - FIRST):.3f} s"))
    printed = run(program(python, "f3d", models, str(WORK / "many.png")))[2]
    each = [float(line.split()[1]) for line in printed.splitlines() if line.startswith("seconds")]
    rows.append(("F3D", f"{statistics.fmean(each[FIRST:]):.3f} s"))
    print(table((f"{len(models) - FIRST} models after {FIRST}", "each"), rows), flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--java", action="append", required=True, help="version and home of a JDK, such as 17=/usr/lib/jvm/jdk-17")
    parser.add_argument("--f3d", help="a Python with f3d")
    parser.add_argument("--blender", help="a Python with bpy")
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--many", action="store_true")
    parser.add_argument("models", nargs="+")
    arguments = parser.parse_args()
    (WORK / "many").mkdir(parents=True, exist_ok=True)
    javas = [java.split("=") for java in arguments.java]
    out = str(WORK / "picture.png")

    def contestants(size, samples):
        return {f"Lumbre, Java {n}": (lambda model, java=java: lumbre(java, [model], out, size, samples)) for n, java in javas}

    if arguments.many:
        return together(javas, arguments.f3d, arguments.models)
    if arguments.f3d:
        f3d = {"F3D": lambda model: program(arguments.f3d, "f3d", [model], out)}
        alone("thumbnail", contestants("256x192", "2") | f3d, arguments.models, arguments.rounds)
    if arguments.blender:
        cycles = {"Cycles": lambda model: program(arguments.blender, "cycles", [model], out)}
        alone("clean", contestants("512x512", "8") | cycles, arguments.models, arguments.rounds)


if __name__ == "__main__":
    main()
