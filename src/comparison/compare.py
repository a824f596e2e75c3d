"""Measures Lumbre beside Mitsuba 3, Sunflow and Embree, and how its times grow.

    python compare.py [OPTIONS] [PART...]

README.md tells what the parts measure and how. Prints tables in Markdown.
"""

import argparse
import contextlib
import hashlib
import os
import subprocess
import sys

import numpy as np

import rays
import scenes
import sunflow_scene
from measure import Server, Turns, java_command, java_version, table, three_digits

DEPTH = 5
TARGETS = (0.02, 0.002)
SPLITS = (2, 4)
LAMPS = (1, 100, 10_000)
TRIANGLES = (1_000, 10_000, 100_000, 1_000_000, 10_000_000)
RAYS_AT_BALL = 200_000
MOST_TRIANGLES = 10_000_000
LIKE = 0.02
# Seconds to warm up a kernel, which is the vector kernel from the start.
KERNEL_WARM = 4
SUNFLOW = "/usr/share/java/sunflow.jar:/usr/share/java/janino.jar"
FOLDER = os.path.dirname(os.path.abspath(__file__))


class Comparison:
    def __init__(self, options):
        self.home = os.path.dirname(os.path.dirname(FOLDER))
        self.work = os.path.join(self.home, "target", "comparison")
        self.jar = os.path.join(self.home, "target", "lumbre-all.jar")
        self.options = options
        os.makedirs(os.path.join(self.work, "references"), exist_ok=True)
        self.scenes = scenes.prepare(self.home, self.work)
        self.javas = {"Lumbre, Java " + java_version(java): java for java in options.java}
        self.lumbre = next(iter(self.javas))

    # Programs

    def renderer(self, name):
        """Starts a renderer: Lumbre, or Mitsuba with its variant and its sampler."""
        if name.startswith("Lumbre"):
            java = self.javas[name.split(", split")[0]]
            command = java_command(java, self.jar, "RenderServer.java")
        elif name.startswith("Sunflow"):
            command = java_command(self.options.java[0], self.options.sunflow, "SunflowServer.java")
        else:
            _, variant, sampler = name.split()
            script = os.path.join(FOLDER, "mitsuba_server.py")
            command = [sys.executable, script, variant + "_rgb", sampler, self.work]
        return Server(name, command, self.options.core)

    def kernel(self, name):
        """Starts a kernel: Lumbre's or Embree's."""
        if name in self.javas:
            command = java_command(self.javas[name], self.jar, "KernelServer.java", "-Xmx8g")
        else:
            mode = ["robust"] if name.endswith("robust") else []
            command = [os.path.join(self.work, "embree_server"), *mode]
        return Server(name, command, self.options.core)

    def start(self, stack, names, starter):
        return {name: stack.enter_context(starter(name)) for name in names}

    @property
    def has_embree(self):
        return os.path.exists(os.path.join(self.work, "embree_server"))

    def renderers(self, *samplers):
        """All that can render here, Lumbre first."""
        return list(self.javas) + self.mitsubas(*samplers)

    def contestants(self, *samplers):
        """The same, and Lumbre with paths that go on in several ways."""
        names = [
            "%s, split %d" % (name, ways) if ways > 1 else name
            for name in self.javas
            for ways in (1, *SPLITS)
        ]
        return names + self.mitsubas(*samplers)

    def mitsubas(self, *samplers):
        names = []
        if has_mitsuba():
            names += ["Mitsuba %s %s" % (v, s) for s in samplers for v in ("scalar", "llvm_ad")]
        return names

    def sunflow(self, scene):
        """The name of Sunflow, if it is installed and can render the scene."""
        installed = os.path.exists(self.options.sunflow.split(":")[0])
        name = self.lumbre.replace("Lumbre", "Sunflow")
        return [name] if installed and self.sunflow_file(scene) else []

    def sunflow_file(self, scene):
        source, width, height = self.scenes[scene]
        target = os.path.join(self.work, "sunflow.scene")
        return target if sunflow_scene.convert(source, target, width, height, DEPTH) else None

    def load(self, server, scene):
        path, width, height = self.scenes[scene]
        if server.name.startswith("Sunflow"):
            path = self.sunflow_file(scene)
        ways = [ways_of(server.name)] if server.name.startswith("Lumbre") else []
        server.ask("load", path, width, height, DEPTH, *ways)

    def warm(self, server, samples=4):
        """Warms up; returns how many samples a pixel take about the time asked for."""
        # Mitsuba compiles before its first render, Java while it renders.
        left = 0 if server.name.startswith("Mitsuba") else self.options.warm
        while True:
            answer = server.ask("render", samples, 1, 1, "-")
            left -= answer["cpu"]
            if left <= 0:
                turn = max(samples, round(samples * self.options.seconds / answer["cpu"]))
                # Mitsuba compiles for each number of samples.
                server.ask("render", turn, 2, 1, "-")
                return turn

    # Pictures

    def picture(self, server, samples, seed):
        """A picture, and how many samples a pixel it has."""
        path = os.path.join(self.work, "picture.raw")
        answer = server.ask("render", samples, seed, 1, path)
        values = np.fromfile(path, "<f4").astype(float)
        return values, 3 * answer["samples"] // len(values)

    def reference(self, scene, renderer):
        """Two independent pictures of many samples by Lumbre or Mitsuba; made once and kept."""
        name = self.lumbre if renderer == "Lumbre" else "Mitsuba llvm_ad independent"
        samples = 256 if scene == "cornell-box" else 64
        halves = []
        for seed in (1001, 1002):
            stem = "%s-%s-%d-%d" % (scene, renderer, samples, seed)
            file = os.path.join(self.work, "references", stem.replace(", ", "-"))
            if not os.path.exists(file):
                progress("rendering " + file)
                with self.renderer(name) as server:
                    self.load(server, scene)
                    server.ask("render", samples, seed, 1, file + ".part")
                os.rename(file + ".part", file)
            halves.append(np.fromfile(file, "<f4").astype(float))
        return halves

    def check(self, scene):
        """Compares two renderers' references; returns a row of a table, and whether they agree."""
        ours = self.reference(scene, "Lumbre")
        theirs = self.reference(scene, "Mitsuba")
        a, b = sum(ours) / 2, sum(theirs) / 2
        expected = own_error(ours) + own_error(theirs)
        ratio = a.mean() / b.mean()
        row = ["%.5f" % a.mean(), "%.5f" % b.mean(), "%+.2f %%" % (100 * (ratio - 1))]
        row += [three_digits(relative_error(a, b)), three_digits(expected)]
        return [scene, *row], abs(ratio - 1) < LIKE

    def check_sunflow(self, scene, name):
        """The lower halves alone: Sunflow's picture is a row off, which at bright lamps is much."""
        half = self.scenes[scene][1] * self.scenes[scene][2] * 3 // 2
        with self.renderer(name) as server:
            self.load(server, scene)
            theirs = self.picture(server, 16, 0)[0][half:]
        ours = sum(self.reference(scene, "Lumbre"))[half:] / 2
        ratio = ours.mean() / theirs.mean()
        row = [scene + ", lower half, Sunflow", "%.5f" % ours.mean(), "%.5f" % theirs.mean()]
        row += ["%+.2f %%" % (100 * (ratio - 1)), three_digits(relative_error(ours, theirs)), "?"]
        return row, abs(ratio - 1) < LIKE

    def part_check(self):
        """Whether the renderers make the same pictures."""
        if not has_mitsuba():
            return "Mitsuba is not installed: nothing to check.\n"
        results = [self.check(scene) for scene in self.scenes]
        for scene in self.scenes:
            results += [self.check_sunflow(scene, name) for name in self.sunflow(scene)]
        head = [
            "scene",
            "mean, Lumbre",
            "mean, the other",
            "difference",
            "relMSE between",
            "of noise",
        ]
        text = table(head, [row for row, _ in results])
        if not all(like for _, like in results):
            raise SystemExit(text + "The pictures differ by more than %g: no times." % LIKE)
        return text

    def part_error(self):
        """What samples bring the error down to; made once and kept, as it needs no clock."""
        rows = []
        for name in self.contestants("independent", "multijitter", "orthogonal"):
            if not name.startswith("Mitsuba scalar"):
                curve = self.error_curve(name)
                text = ", ".join("%d: %s" % (n, three_digits(curve[n])) for n in sorted(curve))
                needed = [three_digits(samples_to(curve, target)[1]) for target in TARGETS]
                rows.append([name, *needed, text])
        head = ["renderer", *("samples to relMSE %g" % target for target in TARGETS)]
        return table([*head, "relMSE after samples"], rows)

    def error_curve(self, name):
        """relMSE against the renderer's own reference for 1, 2, 4... samples, of two seeds."""
        halves = self.reference("cornell-box", name.split()[0].strip(","))
        truth, own = sum(halves) / 2, own_error(halves)
        stem = name.replace(" ", "-").replace(",", "")
        if name.startswith("Lumbre"):
            # The same with every Java, but another version may take other samples.
            with open(self.jar, "rb") as jar:
                version = hashlib.sha256(jar.read()).hexdigest()[:12]
            stem = "Lumbre-%s-split-%d" % (version, ways_of(name))
        path = os.path.join(self.work, "references", stem + ".curve")
        if not os.path.exists(path):
            curve = {}
            progress("rendering the errors of " + name)
            with self.renderer(name) as server:
                self.load(server, "cornell-box")
                asked = 1
                while not curve or min(curve.values()) > min(TARGETS):
                    pictures = [self.picture(server, asked, seed) for seed in (1, 2)]
                    errors = [relative_error(values, truth) for values, _ in pictures]
                    curve[pictures[0][1]] = np.mean(errors) - own
                    asked *= 2
            np.savetxt(path, list(curve.items()))
        return {int(n): float(error) for n, error in np.loadtxt(path)}

    # Times

    def part_renderers(self):
        """Samples a second of CPU time."""
        rows = []
        for scene in self.scenes:
            with contextlib.ExitStack() as stack:
                names = self.renderers("independent") + self.sunflow(scene)
                servers = self.start(stack, names, self.renderer)
                for server in servers.values():
                    self.load(server, scene)
                counts = {name: self.warm(server) for name, server in servers.items()}
                samples = dict.fromkeys(names, counts[self.lumbre])
                for name in self.sunflow(scene):
                    samples[name] = 4 ** max(1, round(np.log2(counts[name]) / 2))

                def take(name, turn):
                    answer = servers[name].ask("render", samples[name], turn, 1, "-")
                    return answer["cpu"] / answer["samples"]

                turns = Turns(servers, self.options.blocks, take)
            for name in servers:
                rate = three_digits(1e-6 / turns.median(name)) + " M"
                faster = turns.ratio_text(name, self.lumbre)
                rows.append(
                    [scene, name, samples[name], rate, "1" if name == self.lumbre else faster]
                )
        head = ["scene", "renderer", "samples a pixel", "samples/s", "Lumbre is faster by"]
        return table(head, rows)

    def part_time_to_error(self):
        """CPU time to an error in the Cornell box."""
        names = self.contestants("independent", "multijitter", "orthogonal")
        names = [name for name in names if name != "Mitsuba scalar orthogonal"]
        curves = {n: self.error_curve(n.replace("scalar", "llvm_ad")) for n in names}
        rows = []
        with contextlib.ExitStack() as stack:
            servers = self.start(stack, names, self.renderer)
            for server in servers.values():
                self.load(server, "cornell-box")
                self.warm(server)
            counts = {name: samples_to(curves[name], TARGETS[0])[0] for name in names}

            def take(name, turn):
                return servers[name].ask("render", counts[name], turn, 1, "-")["cpu"]

            turns = Turns(servers, self.options.blocks, take)
        for target in TARGETS:
            needed = {name: samples_to(curves[name], target)[1] for name in names}
            parts = {name: needed[name] / counts[name] for name in names}
            for name in names:
                seconds = three_digits(turns.median(name) * parts[name]) + " s"
                factor = parts[name] / parts[self.lumbre]
                ratio = turns.ratio_text(name, self.lumbre, factor)
                ratio = "1" if name == self.lumbre else ratio
                rows.append([target, name, three_digits(needed[name]), seconds, ratio])
        head = ["relMSE", "renderer", "samples a pixel", "CPU time", "times Lumbre's"]
        return table(head, rows)

    def part_kernel(self):
        """Rays a second, one by one, beside Embree."""
        names = list(self.javas) + (["Embree", "Embree, robust"] if self.has_embree else [])
        models = os.path.join(self.home, "scenes", "models")
        meshes = {
            "tumbler": rays.read_obj(os.path.join(models, "tumbler.obj")),
            "wine glass": rays.read_obj(os.path.join(models, "wine-glass.obj")),
            "frog": rays.read_obj(os.path.join(models, "frog.obj")),
            "armoured figure": rays.read_obj(os.path.join(models, "armoured-figure.obj")),
            "wavy ball": scenes.ball(1_000_000),
        }
        rows, ratios = [], {name: [] for name in names}
        with contextlib.ExitStack() as stack:
            servers = self.start(stack, names, self.kernel)
            for mesh, (positions, triangles) in meshes.items():
                path = os.path.join(self.work, mesh.replace(" ", "-"))
                count = rays.make(positions, triangles, servers[self.lumbre], path)
                for server in servers.values():
                    server.ask("load", path)
                for file, search in (
                    ("camera", "closest"),
                    ("scattered", "closest"),
                    ("shadow", "any"),
                ):
                    row = ["%s, %d triangles" % (mesh, count), "%s, %s" % (file, search)]
                    turns, misses = self.race(servers, path + "." + file, search)
                    row.append(misses)
                    row += [three_digits(1e-6 / turns.median(name)) for name in names]
                    for name in names[len(self.javas) :]:
                        ratio = turns.ratio(name, self.lumbre)
                        ratios[name].append(ratio[0])
                        row.append(turns.ratio_text(name, self.lumbre))
                    rows.append(row)
        others = names[len(self.javas) :]
        head = ["mesh", "rays, hit", "differing hits"] + [name + ", M/s" for name in names]
        text = table(head + ["Lumbre over " + name for name in others], rows)
        for name in others:
            mean = float(np.exp(np.mean(np.log(ratios[name]))))
            text += "\nLumbre over %s, geometric mean: %s\n" % (name, three_digits(mean))
        return text

    def race(self, servers, file, search):
        """Lets kernels search for the same rays in turns; tells how many hits differ at most."""
        counts = {}
        for name, server in servers.items():
            counts[name] = server.ask("rays", file)["hits"]
        hits = {}
        for name, server in servers.items():
            spent, seconds = 0, KERNEL_WARM if name in self.javas else 0
            while spent <= seconds:
                answer = server.ask(search, 1)
                spent += answer["cpu"]
            hits[name] = answer["hits"]
        slowest = max(server.ask(search, 1)["cpu"] for server in servers.values())
        times = max(1, round(self.options.seconds / 2 / slowest))

        def take(name, turn):
            return servers[name].ask(search, times)["cpu"] / (times * counts[name])

        turns = Turns(servers, self.options.blocks, take)
        return turns, max(hits.values()) - min(hits.values())

    # Growth

    def part_lights(self):
        """Time a sample with 1, 100, 10 000 lamps of the same light."""
        names = {"lamps: %d" % count: scenes.lamps(count, self.work) for count in LAMPS}
        with contextlib.ExitStack() as stack:
            servers = self.start(stack, names, lambda _: self.renderer(self.lumbre))
            for name, path in names.items():
                servers[name].ask("load", path, 320, 180, DEPTH)
            samples = {name: self.warm(server) for name, server in servers.items()}
            errors = {}
            for name, server in servers.items():
                halves = [self.picture(server, 16, seed)[0] for seed in (1, 2)]
                errors[name] = 2 * own_error(halves)

            def take(name, turn):
                answer = servers[name].ask("render", samples[name], turn, 1, "-")
                return answer["cpu"] / answer["samples"]

            turns = Turns(names, self.options.blocks, take)
        first = next(iter(names))
        rows = []
        for name in names:
            cost = three_digits(1e6 * turns.median(name))
            ratio = "1" if name == first else turns.ratio_text(name, first)
            rows.append([name.split()[-1], cost, ratio, three_digits(errors[name])])
        return table(["lamps", "µs/sample", "times one lamp's", "relMSE of 16 samples"], rows)

    def part_triangles(self):
        """Time a ray in meshes of a thousand to ten million triangles."""
        names = [self.lumbre] + (["Embree"] if self.has_embree else [])
        random = np.random.default_rng(2)
        origins = 3 * rays.normalized(random.standard_normal((RAYS_AT_BALL, 3)))
        ends = rays.normalized(random.standard_normal((RAYS_AT_BALL, 3)))
        ends *= random.random((RAYS_AT_BALL, 1)) ** (1 / 3)
        path = os.path.join(self.work, "at-ball")
        lengths = np.full(RAYS_AT_BALL, rays.INFINITE)
        rays.write_rays(origins, rays.normalized(ends - origins), lengths, path)
        rows = []
        for triangles in TRIANGLES:
            mesh = rays.write_mesh(*scenes.ball(triangles), path)
            with contextlib.ExitStack() as stack:
                servers = self.start(stack, names, self.kernel)
                built = {name: server.ask("load", mesh) for name, server in servers.items()}
                turns, _ = self.race(servers, path, "closest")
                row = [built[self.lumbre]["hits"]]
                row += [three_digits(1e9 * turns.median(name)) for name in names]
                row += [three_digits(built[name]["cpu"]) + " s" for name in names]
                row += [three_digits(servers[name].peak_mebibytes()) for name in names]
            rows.append(row)
        head = ["triangles"]
        for what in ("%s, ns/ray", "%s, building", "%s, peak MiB"):
            head += [what % name for name in names]
        return table(head, rows)

    def part_memory(self):
        """Renders ten million triangles from a file in a heap of 8 GB."""
        path, triangles = scenes.ball_scene(MOST_TRIANGLES, self.work)
        command = java_command(self.javas[self.lumbre], self.jar, "RenderServer.java", "-Xmx8g")
        with Server(self.lumbre, command) as server:
            load = server.ask("load", path, 320, 240, DEPTH)
            for _ in range(3):
                answer = server.ask("render", 16, 1, 1, "-")
            rate = three_digits(1e-6 * answer["rays"] / answer["cpu"])
            peak = three_digits(server.peak_mebibytes())
        row = [triangles, three_digits(load["seconds"]) + " s", rate, peak]
        return table(["triangles", "from file to first ray", "M rays/CPU s", "peak MiB"], [row])

    def part_threads(self):
        """Time on the wall of one thread over that of two."""
        rows = []
        command = java_command(self.javas[self.lumbre], self.jar, "RenderServer.java")
        for scene in self.scenes:
            with Server(self.lumbre, command) as server:
                self.load(server, scene)
                samples = 2 * self.warm(server)

                def take(threads, turn):
                    return server.ask("render", samples, turn, threads, "-")["seconds"]

                turns = Turns([1, 2], self.options.blocks, take)
            rows.append([scene, samples, turns.ratio_text(1, 2)])
        return table(["scene", "samples a pixel", "two threads are faster by"], rows)


def ways_of(name):
    """In how many ways this Lumbre's paths go on."""
    return int(name.partition(", split ")[2] or 1)


def relative_error(picture, truth):
    """relMSE as lumbre bench has it."""
    return float(np.mean((picture - truth) ** 2 / (truth**2 + 0.01)))


def own_error(halves):
    """relMSE of the mean of two independent pictures, without bias."""
    a, b = halves
    mean = (a + b) / 2
    return float(np.mean((a - b) ** 2 / 4 / (mean**2 + 0.01)))


def samples_to(curve, target):
    """How many samples bring the error down to a target: a number tried, and the exact one."""
    counts = sorted(curve)
    for low, high in zip(counts, counts[1:], strict=False):
        if curve[high] <= target:
            slope = np.log(curve[high] / curve[low]) / np.log(high / low)
            return high, float(low * np.exp(np.log(target / curve[low]) / slope))
    raise RuntimeError("no picture came to an error of %g" % target)


def has_mitsuba():
    return subprocess.run([sys.executable, "-c", "import mitsuba"], check=False).returncode == 0


def progress(text):
    print(text, file=sys.stderr, flush=True)


def main():
    parts = [name[5:].replace("_", "-") for name in vars(Comparison) if name.startswith("part_")]
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("parts", nargs="*", metavar="PART", help=", ".join(parts) + "; all if none")
    parser.add_argument("--java", action="append", help="a Java to run; the first is the yardstick")
    parser.add_argument("--blocks", type=int, default=5, help="blocks of two turns each (5)")
    parser.add_argument("--seconds", type=float, default=1, help="of a turn, about (1)")
    # Lumbre changes to its vector kernel after some seconds.
    parser.add_argument("--warm", type=float, default=20, help="seconds to warm up (20)")
    parser.add_argument("--core", default="1", help="the processor to run on (1)")
    parser.add_argument("--sunflow", default=SUNFLOW, help="class path of Sunflow")
    options = parser.parse_args()
    for part in options.parts:
        if part not in parts:
            parser.error("PART: expected one of %s, found %s" % (", ".join(parts), part))
    options.java = options.java or ["java"]
    comparison = Comparison(options)
    for part in options.parts or parts:
        progress(part)
        method = getattr(comparison, "part_" + part.replace("-", "_"))
        print("## %s\n\n%s" % (method.__doc__.rstrip("."), method()), flush=True)


if __name__ == "__main__":
    main()
