"""Measures Lumbre in twelve scenes beside an earlier version, Mitsuba 3, Cycles and LuxCore.

    python suite.py [OPTIONS] check|error|time|table...

README.md tells what the parts do. Results are kept in target/comparison/suite/results.json, by scene.
"""

import argparse
import contextlib
import itertools
import json
import math
import os
import subprocess
import sys

import numpy as np

import scenes
from measure import STUDENT, Server, java_command, table, three_digits

FOLDER = os.path.dirname(os.path.abspath(__file__))
HOME = os.path.dirname(os.path.dirname(FOLDER))
TARGETS = (0.02, 0.002)
# Samples per pixel at which errors are measured, and how many pictures each time.
COUNTS = (4, 16, 64)
SEEDS = 3
LIKE = 0.02
# The scalar variant takes the same samples as the other one.
SAME_ERROR = {"Mitsuba scalar independent": "Mitsuba llvm_ad independent"}
# Programs that choose their own instructions: nothing limits them to AVX2.
UNLIMITED = ("Cycles", "LuxCore")


class Suite:
    def __init__(self, options):
        self.options = options
        self.timed = "time with AVX2" if options.avx2 else "time"
        self.work = os.path.join(HOME, "target", "comparison")
        os.makedirs(os.path.join(self.work, "suite"), exist_ok=True)
        self.file = os.path.join(self.work, "suite", "results.json")
        self.results = {}
        if os.path.exists(self.file):
            with open(self.file, encoding="utf-8") as file:
                self.results = json.load(file)
        self.scenes = scenes.suite(HOME, self.work, self.bake)
        if options.scene:
            self.scenes = {name: self.scenes[name] for name in options.scene}

    def keep(self, scene, part, name, value):
        self.results.setdefault(scene, {}).setdefault(part, {})[name] = value
        with open(self.file + ".part", "w", encoding="utf-8") as file:
            json.dump(self.results, file, indent=1)
        os.replace(self.file + ".part", self.file)

    def kept(self, scene, part):
        return self.results.get(scene, {}).get(part, {})

    # Programs

    def java(self, home, source):
        command = [self.options.java, "@" + os.path.join(home, "src/main/jvm/options")]
        command += ["-XX:UseAVX=2"] if self.options.avx2 else []
        command += ["--add-modules", "jdk.incubator.vector"]
        command += ["-cp", os.path.join(home, "target", "lumbre-all.jar")]
        return [*command, os.path.join(home, "src/comparison", source)]

    def bake(self, scene, folder):
        command = self.java(HOME, "TextureBaker.java")
        subprocess.run([*command, scene, folder], check=True)

    def contestants(self):
        result = ["Lumbre"]
        if self.options.before:
            result.append("Lumbre before")
        samplers = ("llvm_ad independent", "llvm_ad multijitter", "llvm_ad orthogonal")
        result += ["Mitsuba " + s for s in samplers]
        return [*result, "Mitsuba scalar independent", *UNLIMITED]

    def start(self, name):
        python = self.options.python
        if name.startswith("Lumbre"):
            command = self.java(self.options.before if "before" in name else HOME, "RenderServer.java")
        elif name.startswith("Mitsuba"):
            _, variant, sampler = name.split()
            script = os.path.join(FOLDER, "mitsuba_server.py")
            command = [python, script, variant + "_rgb", sampler, os.path.join(self.work, "suite")]
            command += ["avx2"] if self.options.avx2 else []
        else:
            script = os.path.join(FOLDER, name.lower() + "_server.py")
            command = [python, script, os.path.join(self.work, "suite")]
        return Server(name, command, self.options.core)

    def load(self, server, scene):
        path, width, height, depth = self.scenes[scene]
        server.ask("load", path, width, height, depth)

    def picture(self, server, samples, seed):
        """A picture, and how many samples a pixel it has."""
        path = os.path.join(self.work, "suite", "picture.raw")
        answer = server.ask("render", samples, seed, 1, path)
        values = np.fromfile(path, "<f4").astype(float)
        return values, 3 * answer["samples"] / len(values)

    # Parts

    def part_error(self):
        """Means, and relMSE after some samples; kept, since it needs no clock."""
        for scene, name in itertools.product(self.scenes, self.contestants()):
            if name in SAME_ERROR or name in self.kept(scene, "error"):
                continue
            progress("%s: error of %s" % (scene, name))
            try:
                with self.start(name) as server:
                    self.load(server, scene)
                    pictures = {}
                    for count in COUNTS:
                        seeds = [SEEDS * count + i for i in range(SEEDS)]
                        taken = [self.picture(server, count, seed) for seed in seeds]
                        pictures[np.mean([n for _, n in taken])] = [p for p, _ in taken]
            except (RuntimeError, ValueError) as error:
                self.keep(scene, "refused", name, str(error)[-300:])
                continue
            self.keep(scene, "error", name, curve(pictures))
            mean = np.average(
                [np.mean(p) for p in pictures.values()], weights=list(pictures)
            )
            self.keep(scene, "mean", name, float(mean))
        return self.part_check()

    def part_check(self):
        """Whether the pictures' means agree: their differences from Lumbre's."""
        names = [n for n in self.contestants() if n not in SAME_ERROR]
        rows = []
        for scene in self.scenes:
            means = self.kept(scene, "mean")
            row = [scene]
            for name in names:
                text = "–"
                if name in means:
                    text = "%+.2f %%" % (100 * (means[name] / means["Lumbre"] - 1))
                row.append(text)
            rows.append(row)
        return table(["scene", *names], rows)

    def best_mitsuba(self, scene):
        """The sampler of Mitsuba's that needs the fewest samples, for each target the same one."""
        errors = self.kept(scene, "error")
        known = [n for n in errors if n.startswith("Mitsuba llvm")]
        return min(known, key=lambda n: samples_to(errors[n], TARGETS[1]), default=None)

    def racers(self, scene):
        means, errors = self.kept(scene, "mean"), self.kept(scene, "error")
        names = ["Lumbre", "Lumbre before", self.best_mitsuba(scene), "Mitsuba scalar independent"]
        names += [] if self.options.avx2 else UNLIMITED
        result = []
        for name in names:
            like = SAME_ERROR.get(name, name)
            if like in errors and abs(means[like] / means["Lumbre"] - 1) < LIKE:
                result.append(name)
        return result

    def part_time(self):
        """CPU time per sample, of contestants in turn."""
        for scene in self.scenes:
            if self.kept(scene, self.timed) and not self.options.again:
                continue
            names = self.racers(scene)
            progress("%s: time of %s" % (scene, ", ".join(names)))
            with contextlib.ExitStack() as stack:
                servers = {name: stack.enter_context(self.start(name)) for name in names}
                samples = {}
                for name, server in servers.items():
                    self.load(server, scene)
                    samples[name] = self.warm(server)
                costs = {name: [] for name in names}
                for block in range(self.options.blocks):
                    order = names if block % 2 == 0 else names[::-1]
                    for name in [*order, *order[::-1]]:
                        answer = servers[name].ask("render", samples[name], block, 1, "-")
                        costs[name].append(answer["cpu"] / answer["samples"])
                for name in names:
                    self.keep(scene, self.timed, name, costs[name])
        return self.part_table()

    def warm(self, server, samples=8):
        """Warms up; returns how many samples a pixel take about the time of a turn."""
        left = self.options.warm if server.name.startswith("Lumbre") else 0
        while True:
            answer = server.ask("render", samples, 1, 1, "-")
            left -= answer["cpu"]
            if left <= 0:
                again = server.ask("render", samples, 2, 1, "-")["cpu"]
                turn = min(1024, max(samples, round(samples * self.options.seconds / again)))
                # Mitsuba compiles for each number of samples.
                server.ask("render", turn, 3, 1, "-")
                return turn

    def part_table(self):
        """CPU time to an error, in multiples of Lumbre's."""
        names = ["Lumbre before", "Mitsuba llvm", "Mitsuba scalar", "Cycles", "LuxCore"]
        text = ""
        for target in TARGETS:
            rows, ratios = [], {name: [] for name in names}
            for scene in self.scenes:
                costs, errors = self.kept(scene, self.timed), self.kept(scene, "error")
                if not costs:
                    continue
                _, width, height, _ = self.scenes[scene]
                needed = {n: samples_to(errors[SAME_ERROR.get(n, n)], target) for n in costs}
                ours = needed["Lumbre"] * np.median(costs["Lumbre"]) * width * height
                row = [scene, three_digits(needed["Lumbre"]), three_digits(ours) + " s"]
                for name in names:
                    racer = next((n for n in costs if n.startswith(name)), None)
                    if racer is None:
                        row.append("–")
                        continue
                    factor = needed[racer] / needed["Lumbre"]
                    middle, low, high = ratio(costs[racer], costs["Lumbre"], factor)
                    ratios[name].append(middle)
                    row.append("%s (%s to %s)" % tuple(map(three_digits, (middle, low, high))))
                rows.append(row)
            means = [three_digits(geometric_mean(r)) if r else "–" for r in ratios.values()]
            rows.append(["geometric mean", "", "", *means])
            head = ["scene, relMSE %g" % target, "samples per pixel", "CPU time", *names]
            text += table(head, rows) + "\n"
        return text


def curve(pictures):
    """relMSE after so many samples, from independent pictures; {samples: error}.

    The squared difference of two pictures is twice the squared error of one. The mean of all
    pictures stands for the truth below the fraction's line.
    """
    weights = [n for n, taken in pictures.items() for _ in taken]
    everything = [p for taken in pictures.values() for p in taken]
    truth = np.average(everything, axis=0, weights=weights)
    result = {}
    for count, taken in pictures.items():
        pairs = itertools.combinations(taken, 2)
        errors = [np.mean((a - b) ** 2 / 2 / (truth**2 + 0.01)) for a, b in pairs]
        result[count] = float(np.mean(errors))
    return result


def samples_to(errors, target):
    """The samples that bring the error down to a target, on or beyond a line between logarithms."""
    points = sorted((math.log(float(n)), math.log(error)) for n, error in errors.items())
    pairs = list(itertools.pairwise(points))
    for (n0, e0), (n1, e1) in pairs:
        if e1 <= math.log(target) or (n1, e1) == points[-1]:
            slope = (e1 - e0) / (n1 - n0)
            return math.exp(n0 + (math.log(target) - e0) / slope)
    raise ValueError("fewer than two errors")


def ratio(a, b, factor):
    """How many times as much a cost as b, and 95 % limits: of pairs of neighbouring turns."""
    logs = [math.log(factor * (x0 + x1) / (y0 + y1)) for x0, x1, y0, y1 in
            zip(a[::2], a[1::2], b[::2], b[1::2], strict=True)]
    middle = np.mean(logs)
    if len(logs) < 2:
        return math.exp(middle), 0.0, math.inf
    half = STUDENT[min(len(logs) - 1, len(STUDENT)) - 1] * np.std(logs, ddof=1) / len(logs) ** 0.5
    return math.exp(middle), math.exp(middle - half), math.exp(middle + half)


def geometric_mean(values):
    return math.exp(np.mean(np.log(values)))


def progress(text):
    print(text, file=sys.stderr, flush=True)


def main():
    parts = [name[5:] for name in vars(Suite) if name.startswith("part_")]
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("parts", nargs="+", metavar="PART", choices=parts, help=", ".join(parts))
    parser.add_argument("--before", help="a folder with an earlier version, built")
    parser.add_argument("--java", default="java", help="the Java to run")
    parser.add_argument("--python", default=sys.executable, help="the Python of the others")
    parser.add_argument("--scene", action="append", help="only this one; more by more options")
    parser.add_argument("--blocks", type=int, default=4, help="blocks of two turns each (4)")
    parser.add_argument("--seconds", type=float, default=0.7, help="of a turn, about (0.7)")
    parser.add_argument("--warm", type=float, default=20, help="seconds to warm up Java (20)")
    parser.add_argument("--core", help="the processor to run on")
    parser.add_argument(
        "--avx2", action="store_true", help="time Lumbre and Mitsuba without AVX-512"
    )
    parser.add_argument("--again", action="store_true", help="measure times again")
    options = parser.parse_args()
    suite = Suite(options)
    for part in options.parts:
        method = getattr(suite, "part_" + part)
        print("## %s\n\n%s" % (method.__doc__.split("\n")[0].rstrip("."), method()), flush=True)


if __name__ == "__main__":
    main()
