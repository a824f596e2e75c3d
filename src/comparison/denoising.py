#!/usr/bin/env python3
"""Measures the denoisers on Lumbre's scenes: tables (standard output) and a plot of the error estimate.

    src/comparison/denoising.py [--oidn PROGRAM] [--plot FILE.svg] > tables.md

Films and pictures stay in target/comparison/denoising: what is there is not made again. See README.md.
"""

import argparse
import math
import os
import subprocess
import sys

HOME = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
SCENES = (
    "cornell-box cornell-box-dome glass-and-mirror lantern camera-bokeh table-01-depth-of-field-400mm "
    "table-04-armoured-figure table-07-suited-figure table-11-marble table-13-voronoi table-15-frog torus-knot"
).split()
# Further scenes, for the plot.
OTHERS = "camera-thin-lens cornell-box-sphere-light table-16-spherical".split()
SAMPLES = [4, 16, 64, 256]
# References have these samples, which no measured picture has, of the same seed: textures depend on the seed.
REFERENCE = (1024, 2048)
OTHERS_REFERENCE = (1024, 1536)


def render(args, scene, first, end):
    """Returns the film of some samples, which is rendered if it is missing."""
    film = os.path.join(args.folder, "%s.%d-%d.film" % (scene, first, end))
    if not os.path.exists(film):
        os.makedirs(args.folder, exist_ok=True)
        part = os.path.join(args.folder, "part.film")
        subprocess.run(
            [os.path.join(HOME, "lumbre"), "render", os.path.join(HOME, "scenes", scene + ".json")]
            + ["--size", "240x180", "--samples-from", str(first), "--samples-to", str(end)]
            + ["--layers", "denoise", "--checkpoint", part, "--overwrite", "--progress", "none"]
            + ["-o", os.path.join(args.folder, "part.png")],
            check=True,
            stdout=subprocess.DEVNULL,
        )
        os.replace(part, film)
    return film


def measure(args, scene):
    """Returns the measurements of a scene: by samples and engine; that of the reference by 0."""
    films = {render(args, scene, 0, n): n for n in SAMPLES if n < 256 or scene not in OTHERS}
    command = ["java", "-cp", os.path.join(HOME, "target", "lumbre-all.jar")]
    command += [os.path.join(HOME, "src", "comparison", "DenoiserMeter.java")]
    reference = render(args, scene, *(OTHERS_REFERENCE if scene in OTHERS else REFERENCE))
    command += [os.path.join(args.folder, "pictures"), args.oidn, reference] + list(films)
    said = subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True).stdout
    names = {os.path.basename(film): n for film, n in films.items()}
    result = {}
    for line in said.split():
        name, engine, *numbers = line.split(",")
        values = [float(x) if x else math.nan for x in numbers]
        result[names.get(name, 0), engine] = dict(zip(["relmse", "flip", "ssim", "bias", "predicted"], values))
    return result


def samples_by_flip(measured, samples, engine):
    """Returns the factor in samples with which noisy pictures have the same FLIP error."""
    steps = [(math.log(measured[n, "noisy"]["flip"]), math.log(n)) for n in SAMPLES if (n, "noisy") in measured]
    flip = math.log(measured[samples, engine]["flip"])
    for (before, start), (after, end) in zip(steps, steps[1:]):
        if flip >= after or (after, end) == steps[-1]:
            return math.exp(start + (flip - before) * (end - start) / (after - before)) / samples
    raise ValueError("at least two numbers of samples are needed")


def reference_noise(measured):
    """Returns the relMSE of the reference by its halves, an upper estimate with low-discrepancy points."""
    return measured[0, "reference"]["relmse"]


def prediction(measured, samples):
    """Returns predicted over true error; None where the reference is too noisy to tell."""
    row = measured[samples, "builtin"]
    return row["predicted"] / row["relmse"] if reference_noise(measured) < row["relmse"] / 3 else None


def mean(values):
    return math.exp(sum(map(math.log, values)) / len(values))


def table(results, samples):
    print("\n## %d samples\n" % samples)
    print(
        "| scene | relMSE before | built-in | gain | OIDN gain | FLIP before | built-in | OIDN | FLIP samples | OIDN "
        "| SSIM before | built-in | OIDN | predicted |"
    )
    print("|" + "---|" * 14)
    for scene in SCENES:
        m = results[scene]
        noisy, ours, oidn = (m[samples, engine] for engine in ("noisy", "builtin", "oidn"))
        ratio = prediction(m, samples)
        print(
            "| %s | %.5f | %.5f | %.1f | %.1f | %.4f | %.4f | %.4f | %.1f | %.1f | %.3f | %.3f | %.3f | %s |"
            % (
                (scene, noisy["relmse"], ours["relmse"], noisy["relmse"] / ours["relmse"])
                + (noisy["relmse"] / oidn["relmse"], noisy["flip"], ours["flip"], oidn["flip"])
                + (samples_by_flip(m, samples, "builtin"), samples_by_flip(m, samples, "oidn"))
                + (noisy["ssim"], ours["ssim"], oidn["ssim"], "–" if ratio is None else "%.2f" % ratio)
            )
        )
    summary(results, samples)


def summary(results, samples):
    def gain(engine, metric):
        return [m[samples, "noisy"][metric] / m[samples, engine][metric] for m in chosen]

    chosen = [results[scene] for scene in SCENES]
    ours, oidn = ([samples_by_flip(m, samples, engine) for m in chosen] for engine in ("builtin", "oidn"))
    print(
        "\nGeometric means: relMSE gain %.1f built-in, %.1f OIDN; FLIP samples %.1f and %.1f."
        % (mean(gain("builtin", "relmse")), mean(gain("oidn", "relmse")), mean(ours), mean(oidn))
    )
    print(
        "At least 4 times the samples by FLIP: %d of 12 built-in, %d of 12 OIDN."
        % (sum(x >= 4 for x in ours), sum(x >= 4 for x in oidn))
    )
    worse = [sum(x < 1 / 1.02 for x in gain(e, k)) for k in ("relmse", "flip") for e in ("builtin", "oidn")]
    print("Worse than not denoising by more than 2 %%: by relMSE %d (OIDN %d), by FLIP %d (OIDN %d)." % tuple(worse))
    ratios = [r for r in (prediction(m, samples) for m in chosen) if r is not None]
    print("Predicted within a factor of 2: %d of %d that can be judged." % (sum(0.5 <= r <= 2 for r in ratios), len(ratios)))


def details(results):
    print("\n## References, other scenes, bias\n")
    print("| scene | relMSE of the reference itself | bias at 16 samples | predicted/true at 4, 16, 64 |")
    print("|" + "---|" * 4)
    for scene, m in results.items():
        ratios = [prediction(m, n) for n in SAMPLES[:3]]
        text = ", ".join("–" if r is None else "%.2f" % r for r in ratios)
        print("| %s | %.5f | %.4f | %s |" % (scene, reference_noise(m), m[16, "builtin"]["bias"], text))


def plot(results, file):
    """Writes predicted over true error, as an SVG with two logarithmic axes."""
    points = [
        (m[n, "builtin"]["relmse"], m[n, "builtin"]["predicted"], scene in OTHERS, scene, n)
        for scene, m in results.items()
        for n in SAMPLES
        if (n, "builtin") in m and prediction(m, n) is not None
    ]
    low = math.floor(math.log10(min(min(p[:2]) for p in points)))
    high = math.ceil(math.log10(max(max(p[:2]) for p in points)))

    def at(value):
        return 60 + 400 * (math.log10(value) - low) / (high - low)

    def x(value):
        return at(value)

    def y(value):
        return 480 - at(value)

    lines = [
        '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 480 480" role="img" font-family="system-ui,sans-serif" font-size="12">',
        "<title>Predicted and true relMSE of the built-in denoiser</title>",
        "<style>svg{background:#fff;--ink:#1c2430;--grid:#e3e7ec;--dot:#0b62a8;--square:#c4472b}"
        "@media(prefers-color-scheme:dark){svg{background:#12161c;--ink:#e6eaef;--grid:#2a313b;--dot:#6db3f2;--square:#ff8f73}}"
        "text{fill:var(--ink)}line{stroke:var(--grid)}</style>",
    ]
    for power in range(low, high + 1):
        v = 10.0**power
        lines.append('<line x1="%.1f" x2="%.1f" y1="20" y2="420"/>' % (x(v), x(v)))
        lines.append('<line x1="60" x2="460" y1="%.1f" y2="%.1f"/>' % (y(v), y(v)))
        lines.append('<text x="%.1f" y="436" text-anchor="middle">%g</text>' % (x(v), v))
        lines.append('<text x="54" y="%.1f" text-anchor="end">%g</text>' % (y(v) + 4, v))
    start, end = 10.0**low, 10.0**high
    for factor in (0.5, 1, 2):
        left, right = max(start, start / factor), min(end, end / factor)
        style = "" if factor == 1 else ' stroke-dasharray="4 3"'
        lines.append(
            '<line x1="%.1f" y1="%.1f" x2="%.1f" y2="%.1f" style="stroke:var(--ink)"%s/>'
            % (x(left), y(left * factor), x(right), y(right * factor), style)
        )
    for true, predicted, is_other, scene, n in points:
        tip = "<title>%s, %d samples</title>" % (scene, n)
        if is_other:
            shape = '<rect x="%.1f" y="%.1f" width="7" height="7" fill="var(--square)">%s</rect>'
            lines.append(shape % (x(true) - 3.5, y(predicted) - 3.5, tip))
        else:
            shape = '<circle cx="%.1f" cy="%.1f" r="3.5" fill="var(--dot)">%s</circle>'
            lines.append(shape % (x(true), y(predicted), tip))
    lines.append('<text x="260" y="458" text-anchor="middle">true relMSE</text>')
    lines.append('<text x="14" y="220" text-anchor="middle" transform="rotate(-90 14 220)">predicted relMSE</text>')
    with open(file, "w", encoding="utf-8") as out:
        out.write("\n".join(lines + ["</svg>", ""]))


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    parser.add_argument("--oidn", required=True, help="the program oidnDenoise")
    parser.add_argument("--folder", default=os.path.join(HOME, "target", "comparison", "denoising"))
    parser.add_argument("--plot", help="SVG to write")
    args = parser.parse_args()
    subprocess.run([os.path.join(HOME, "lumbre"), "--version"], check=True, stdout=sys.stderr)
    results = {scene: measure(args, scene) for scene in SCENES + OTHERS}
    for samples in SAMPLES:
        table(results, samples)
    details(results)
    if args.plot:
        plot(results, args.plot)


if __name__ == "__main__":
    main()
