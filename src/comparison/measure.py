"""Programs that work on command, and letting them take turns."""

import json
import math
import os
import statistics
import subprocess

# Two-sided 95 % quantiles of Student's t, for 1, 2, ... degrees of freedom.
STUDENT = [12.71, 4.30, 3.18, 2.78, 2.57, 2.45, 2.36, 2.31, 2.26, 2.23, 2.20, 2.18, 2.16, 2.14]


class Server:
    """A program that answers each line with a line of JSON; it is idle in between."""

    def __init__(self, name, command, cores=None):
        self.name = name
        if cores is not None:
            command = ["taskset", "-c", str(cores)] + command
        self.process = subprocess.Popen(
            command,
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
        )

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.process.stdin.close()
        self.process.wait()

    def ask(self, *words):
        try:
            self.process.stdin.write(" ".join(map(str, words)) + "\n")
            self.process.stdin.flush()
            line = self.process.stdout.readline()
        except BrokenPipeError:
            line = ""
        if not line:
            raise RuntimeError(self.name + " failed:\n" + self.process.stderr.read()[-2000:])
        return json.loads(line)

    def peak_mebibytes(self):
        """The most memory that the program has had so far, by the system's count."""
        with open("/proc/%d/status" % self.process.pid, encoding="ascii") as status:
            for line in status:
                if line.startswith("VmHWM"):
                    return int(line.split()[1]) / 1024
        raise RuntimeError("the system does not tell " + self.name + "'s memory")


class Turns:
    """What contestants took in blocks of two turns each: A B C, C B A."""

    def __init__(self, contestants, blocks, take):
        """take(contestant, turn) does the work and returns its cost."""
        self.costs = {contestant: [] for contestant in contestants}
        for block in range(blocks):
            order = list(contestants)
            if block % 2:
                order.reverse()
            for contestant in order:
                self.costs[contestant].append([take(contestant, 2 * block)])
            for contestant in reversed(order):
                self.costs[contestant][-1].append(take(contestant, 2 * block + 1))

    def median(self, contestant):
        return statistics.median(cost for block in self.costs[contestant] for cost in block)

    def ratio(self, a, b, factor=1):
        """How many times as much a took as b: the geometric mean over blocks, and 95 % limits.

        The costs of a are multiplied by the factor.
        """
        logs = [
            math.log(factor * sum(x) / sum(y))
            for x, y in zip(self.costs[a], self.costs[b], strict=True)
        ]
        middle = statistics.fmean(logs)
        if len(logs) == 1:
            return math.exp(middle), 0.0, math.inf
        quantile = STUDENT[min(len(logs) - 1, len(STUDENT)) - 1]
        half = quantile * statistics.stdev(logs) / math.sqrt(len(logs))
        return math.exp(middle), math.exp(middle - half), math.exp(middle + half)

    def ratio_text(self, a, b, factor=1):
        return "%s (%s to %s)" % tuple(map(three_digits, self.ratio(a, b, factor)))


def three_digits(value):
    if value == 0 or not math.isfinite(value):
        return str(value)
    return "%.*f" % (max(0, 2 - math.floor(math.log10(abs(value)))), value)


def table(head, rows):
    """A table in Markdown; all columns but the first are numbers."""
    lines = ["| " + " | ".join(head) + " |", "|---|" + "--:|" * (len(head) - 1)]
    lines += ["| " + " | ".join(map(str, row)) + " |" for row in rows]
    return "\n".join(lines) + "\n"


def java_version(java):
    """Such as 17, of the program java."""
    text = subprocess.run([java, "-version"], capture_output=True, text=True, check=True).stderr
    return text.split('"')[1].split(".")[0]


def java_command(java, jar, source, *options):
    """Runs a file of Java source against the jar, with the options that ./lumbre gives."""
    folder = os.path.dirname(os.path.abspath(__file__))
    jvm = os.path.join(folder, "..", "main", "jvm", "options")
    fixed = [java, "@" + jvm, "--add-modules", "jdk.incubator.vector", *options]
    return [*fixed, "-cp", jar, os.path.join(folder, source)]
