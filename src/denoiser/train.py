#!/usr/bin/env python3
"""Trains the denoiser's network on rendered pictures, with or without an accelerator; can be ended and run again.

    train.py --data FOLDER --out FOLDER --seconds 36000 [--start WEIGHTS]

Pictures may arrive while it runs. OUT gets weights.f16 (the mean of the last steps' weights, which is what counts),
state.pt (all that is needed to go on), log.csv, and held-out.csv with the errors of scenes that are held out. Same arguments again: it goes on where it was.
"""

import argparse
import copy
import glob
import math
import os
import threading
import time

import numpy as np
import torch
import torch.nn.functional as F

from network import PLANES, Network, exposure, read_weights, tone, write_weights

PICTURES = 9
PREFIXES = [1, 2, 4, 8, 16, 32, 64]
# How often each picture of a scene is drawn: the samples 0 to 0, 1, 3, 7, 15, 31, 63, then 2-3, 4-7.
OFTEN = [0.3, 1.0, 3.0, 1.4, 2.0, 1.2, 1.4, 0.6, 1.4]
HELD_OUT = int(os.environ.get("HELD_OUT", 48))
# Sizes at which errors of tones are seen, with their weights.
SCALES = ((1, 1.0), (2, 0.5), (4, 0.35), (8, 0.25))
SQUARES = 0.3
SIMILARITY = 0.08
LUMINANCE = (0.2126, 0.7152, 0.0722)
DTYPE = torch.float32


class Pictures:
    """The pictures of scenes, on the device; a thread adds those that appear."""

    def __init__(self, folder, most, side, device):
        self.folder, self.side, self.count = folder, side, 0
        self.inputs = torch.empty(most, PICTURES, PLANES, side, side, device=device, dtype=DTYPE)
        self.targets = torch.empty(most, 6, side, side, device=device, dtype=DTYPE)
        self.seen, self.lock = set(), threading.Lock()
        threading.Thread(target=self.watch, daemon=True).start()

    def watch(self):
        while True:
            for file in sorted(set(glob.glob(self.folder + "/*.bin")) - self.seen):
                self.seen.add(file)
                if self.count < len(self.inputs):
                    self.add(torch.from_numpy(np.fromfile(file, "<f4")))
            time.sleep(1)

    def add(self, values):
        size = PICTURES * PLANES * self.side**2
        if not torch.isfinite(values).all():
            return
        with self.lock:
            self.inputs[self.count] = values[:size].view(PICTURES, PLANES, self.side, self.side).clamp(-1e4, 1e4)
            self.targets[self.count] = values[size:].view(6, self.side, self.side).clamp(-1e4, 1e4)
            self.count += 1


def some(count, share, device):
    return (torch.rand(count, 1, 1, 1, device=device) < share).float()


def adaptive(x, other):
    """Returns pictures that have more samples where they are noisy, as adaptive sampling leaves them."""
    relative = x[:, 3:6].abs().mean(1, keepdim=True) / (x[:, :3].mean(1, keepdim=True) + 0.05)
    relative = F.avg_pool2d(relative, 5, 1, 2)
    threshold = relative.flatten(1).median(1).values.view(-1, 1, 1, 1)
    return torch.where(relative > threshold, other, x)


def without_some_planes(x):
    """Returns pictures of which some lack guides, the guides' noise or all noise."""
    n, device = len(x), x.device
    guides, noise, guide_noise = some(n, 0.06, device), some(n, 0.06, device), some(n, 0.08, device)
    kept = 1 - torch.clamp(noise + guide_noise + guides, max=1)
    return torch.cat([x[:, :3], x[:, 3:6] * (1 - noise), x[:, 6:12] * (1 - guides), x[:, 12:] * kept], 1)


def turned(device):
    """Returns a random orthogonal matrix for normals; half of them only permute and mirror the axes."""
    if np.random.rand() < 0.5:
        q = np.linalg.qr(np.random.randn(3, 3))[0]
    else:
        q = np.eye(3)[np.random.permutation(3)] * np.random.choice([-1, 1], 3)
    return torch.tensor(q, dtype=torch.float32, device=device)


def batch(pictures, size, often):
    """Returns inputs, targets and the targets' noise."""
    device, count = pictures.inputs.device, pictures.count - HELD_OUT
    scene = HELD_OUT + torch.randint(count, (size,), device=device)
    kind = torch.multinomial(often, size, True)
    x, target = pictures.inputs[scene, kind].float(), pictures.targets[scene].float()
    if np.random.rand() < 0.3:
        few, many = sorted(np.random.choice(np.arange(1, len(PREFIXES)), 2, replace=False))
        mixed = adaptive(pictures.inputs[scene, few].float(), pictures.inputs[scene, many].float())
        x = torch.where(some(size, 0.5, device) > 0, mixed, x)
    x = without_some_planes(x)
    for flip in (lambda t: t.flip(-1), lambda t: t.flip(-2), lambda t: t.transpose(-1, -2)):
        if np.random.rand() < 0.5:
            x, target = flip(x), flip(target)
    rgb = torch.from_numpy(np.random.permutation(3)).to(device)
    normal = torch.einsum("ij,bjhw->bihw", turned(device), x[:, 9:12])
    x = torch.cat([x[:, 0:3][:, rgb], x[:, 3:6][:, rgb], x[:, 6:9][:, rgb], normal, x[:, 12:]], 1)
    return x.contiguous(), target[:, :3][:, rgb].contiguous(), target[:, 3:][:, rgb].contiguous()


def differences(d):
    """Returns the mean size of values and half that of their gradients."""
    across, down = d[..., :, 1:] - d[..., :, :-1], d[..., 1:, :] - d[..., :-1, :]
    return d.abs().mean() + 0.5 * (across.abs().mean() + down.abs().mean())


def encoded(light):
    luminance = sum(weight * light[:, i : i + 1] for i, weight in enumerate(LUMINANCE))
    return 1.055 * (luminance.clamp(0, 1) + 1e-3) ** (1 / 2.4) - 0.055


def similarity(a, b):
    """Returns the mean structural similarity of luminance, in windows of 5x5 pixels."""
    a, b = encoded(a), encoded(b)
    mean_a, mean_b, aa, bb, ab = F.avg_pool2d(torch.cat([a, b, a * a, b * b, a * b], 1), 5, 1).split(1, 1)
    spread, common = aa - mean_a**2 + bb - mean_b**2, ab - mean_a * mean_b
    alike = (2 * mean_a * mean_b + 1e-4) / (mean_a**2 + mean_b**2 + 1e-4)
    return (alike * (2 * common + 9e-4) / (spread + 9e-4)).mean()


def loss_of(output, target):
    """Returns errors of tones at several sizes, relative squared errors, and what lacks of similarity."""
    tones = tone(output) - tone(target)
    squares = torch.log1p((output - target) ** 2 / (target**2 + 0.01)).mean()
    total = SIMILARITY * (1 - similarity(output, target)) + SQUARES * squares
    for size, weight in SCALES:
        total = total + weight * differences(F.avg_pool2d(tones, size))
    return total


def relative_error(output, target, noise):
    """Returns mean relative squared errors of pictures, without that of their targets."""
    return (((output - target) ** 2 - noise**2) / (target**2 + 0.01)).mean((1, 2, 3)).clamp_min(1e-7)


def judge(network, pictures, file):
    """Returns, for 4, 16 and 64 samples of the scenes that are held out: gain, and predicted over true error.

    The file gets a line for each scene: samples, error before and after, predicted error.
    """
    network.eval()
    result, lines = [], []
    for n in (4, 16, 64):
        x = pictures.inputs[:HELD_OUT, PREFIXES.index(n)].float()
        target, noise = pictures.targets[:HELD_OUT].float().split(3, 1)
        with torch.no_grad():
            scale = exposure(x[:, :3])
            output, left = (torch.cat(t) / scale for t in zip(*(network(a, s) for a, s in zip(x.split(8), scale.split(8)))))
        before, after = relative_error(x[:, :3], target, noise), relative_error(output, target, noise)
        predicted = (left**2 / (output**2 + 0.01)).mean((1, 2, 3)).clamp_min(1e-9)
        lines += ["%d,%.6g,%.6g,%.6g\n" % (n, *values) for values in torch.stack([before, after, predicted], 1).tolist()]
        result += [torch.log(before / after).mean().exp().item(), torch.log(predicted / after).median().exp().item()]
    network.train()
    with open(file, "w") as out:
        out.writelines(lines)
    return result


def save(file, value):
    torch.save(value, file + ".part")
    os.replace(file + ".part", file)


def arguments():
    parser = argparse.ArgumentParser()
    parser.add_argument("--data", required=True)
    parser.add_argument("--out", required=True)
    parser.add_argument("--start", help="weights to begin with")
    parser.add_argument("--seconds", type=float, default=36000, help="of training, in all")
    parser.add_argument("--end", help="file with the time, in seconds since 1970, at which it ends instead")
    parser.add_argument("--steps", type=int, default=1 << 60, help="at most")
    parser.add_argument("--batch", type=int, default=128)
    parser.add_argument("--rate", type=float, default=1e-3)
    parser.add_argument("--side", type=int, default=96, help="of the pictures")
    parser.add_argument("--most", type=int, default=3000, help="scenes")
    parser.add_argument("--least", type=int, default=2 * HELD_OUT, help="scenes before it begins")
    parser.add_argument("--save", type=float, default=60, help="seconds between results")
    parser.add_argument("--eager", action="store_true", help="without recording a step on the accelerator")
    return parser.parse_args()


class Step:
    """One step of the training; on an accelerator it is recorded once and then repeated, which spares the calls."""

    def __init__(self, network, args, device):
        self.network, self.size = network, (args.batch, args.side, args.side)
        self.optimizer = torch.optim.AdamW(
            network.parameters(),
            lr=torch.tensor(args.rate, device=device),
            betas=(0.9, 0.99),
            weight_decay=1e-4,
            fused=device == "cuda",
            capturable=device == "cuda",
        )
        n, h, w = self.size
        self.x = torch.zeros(n, PLANES, h, w, device=device)
        self.target, self.scale = torch.zeros(n, 3, h, w, device=device), torch.ones(n, 1, 1, 1, device=device)
        self.graph, self.loss, self.done, self.eager = None, None, 0, args.eager or device == "cpu"

    def compute(self):
        loss = loss_of(self.network(self.x, self.scale)[0], self.target)
        loss.backward()
        torch.nn.utils.clip_grad_norm_(self.network.parameters(), 1.0)
        self.optimizer.step()
        return loss.detach()

    def directly(self):
        self.optimizer.zero_grad(set_to_none=True)
        return self.compute()

    def record(self):
        self.optimizer.zero_grad(set_to_none=True)
        torch.cuda.synchronize()
        try:
            graph = torch.cuda.CUDAGraph()
            with torch.cuda.graph(graph, capture_error_mode="thread_local"):
                self.loss = self.compute()
            self.graph = graph
        except Exception as e:  # slower, but no reason to end
            print("the step is not recorded: %s" % e, flush=True)
            self.eager = True

    def run(self, x, target, scale, rate, lock):
        """Takes a step; returns its loss."""
        self.x.copy_(x)
        self.target.copy_(target)
        self.scale.copy_(scale)
        for group in self.optimizer.param_groups:
            group["lr"].fill_(rate)
        self.done += 1
        if self.eager:
            return self.directly()
        if self.graph is None and self.done > 5:
            with lock:
                self.record()
        if self.graph is None:
            return self.aside()
        self.graph.replay()
        return self.loss

    def aside(self):
        side = torch.cuda.Stream()
        side.wait_stream(torch.cuda.current_stream())
        with torch.cuda.stream(side):
            loss = self.directly()
        torch.cuda.current_stream().wait_stream(side)
        return loss


def main():
    args = arguments()
    device = "cuda" if torch.cuda.is_available() else "cpu"
    torch.set_num_threads(min(2, torch.get_num_threads()))
    torch.backends.cuda.matmul.allow_tf32 = torch.backends.cudnn.allow_tf32 = True
    torch.backends.cudnn.benchmark = True
    os.makedirs(args.out, exist_ok=True)
    network = Network().to(device)
    if device == "cuda":
        network = network.to(memory_format=torch.channels_last)
    if args.start:
        read_weights(network, args.start)
    mean = copy.deepcopy(network)
    training = Step(network, args, device)
    step, trained = 0, 0.0
    state = args.out + "/state.pt"
    if os.path.exists(state):
        kept = torch.load(state, map_location=device)
        step, trained = kept["step"], kept["trained"]
        network.load_state_dict(kept["network"])
        mean.load_state_dict(kept["mean"])
        training.optimizer.load_state_dict(kept["optimizer"])
    pictures = Pictures(args.data, args.most, args.side, device)
    often = torch.tensor(OFTEN, device=device)

    gains = []

    def result():
        if not all(torch.isfinite(p).all() for p in mean.parameters()):
            raise SystemExit("the weights are not finite any more")
        judged = judge(mean, pictures, args.out + "/held-out.csv")
        gains.append(judged[0])
        line = "%d,%.0f,%d," % (step, trained, pictures.count) + ",".join("%.3f" % v for v in judged)
        print(line, "loss %.4f" % float(recent), flush=True)
        if not judged[0] > gains[0] / 2:
            raise SystemExit("the network has become worse")
        with open(args.out + "/log.csv", "a") as log:
            log.write(line + "\n")
        write_weights(mean, args.out + "/weights.f16.part")
        os.replace(args.out + "/weights.f16.part", args.out + "/weights.f16")
        kept = dict(step=step, trained=trained, network=network.state_dict(), mean=mean.state_dict())
        save(state, dict(kept, optimizer=training.optimizer.state_dict()))

    def seconds():
        """Returns the seconds of the whole training."""
        return trained + float(open(args.end).read()) - time.time() if args.end else args.seconds

    while pictures.count < args.least:
        time.sleep(0.2)
    recent = torch.zeros((), device=device)
    last = saved = time.time()
    first, before = step, trained
    print("scenes %d, step %d, on %s" % (pictures.count, step, device), flush=True)
    result()
    total = seconds()
    while trained < total and step < args.steps:
        done = min(1, trained / total)
        rate = args.rate * min(1, (step + 1) / 300) * (0.5 + 0.5 * math.cos(math.pi * max(0, (done - 0.1) / 0.9))) + 1e-6
        x, target, _ = batch(pictures, args.batch, often)
        scale = exposure(x[:, :3])
        scale = scale * torch.exp(torch.empty_like(scale).uniform_(-0.6, 0.6))
        loss = training.run(x, (target * scale).clamp_max(200), scale, rate, pictures.lock)
        step += 1
        recent = recent * 0.99 + loss * 0.01
        with torch.no_grad():
            torch._foreach_lerp_(list(mean.parameters()), list(network.parameters()), 1 - min(0.9995, step / (step + 100.0)))
        if step % 20 == 0 or device == "cpu":
            if device == "cuda":
                torch.cuda.synchronize()
            now = time.time()
            trained, last = trained + now - last, now
            total = seconds()
            if now - saved > args.save:
                saved = now
                print("%.1f steps/s, rate %.5f" % ((step - first) / max(1e-9, trained - before), rate), flush=True)
                result()
    result()


if __name__ == "__main__":
    main()
