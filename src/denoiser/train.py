#!/usr/bin/env python3
"""Trains the denoiser's network on rendered pictures, with or without an accelerator; can be ended and run again.

    train.py --data FOLDER --out FOLDER --seconds 36000 [--start WEIGHTS]

Pictures may arrive while it runs. OUT gets weights.f16 (the mean of the last steps' weights, which is what counts),
state.pt (all that is needed to go on) and log.csv. Same arguments again: it goes on where it was.
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
OFTEN = [0.4, 1.0, 2.0, 1.4, 2.2, 1.4, 1.8, 0.6, 1.0]
HELD_OUT = int(os.environ.get("HELD_OUT", 32))
SCALES = ((1, 1.0), (2, 0.5), (4, 0.35), (8, 0.25))
DTYPE = torch.float32


class Pictures:
    """The pictures of scenes, on the device; a thread adds those that appear."""

    def __init__(self, folder, most, side, device):
        self.folder, self.side, self.count = folder, side, 0
        self.inputs = torch.empty(most, PICTURES, PLANES, side, side, device=device, dtype=DTYPE)
        self.targets = torch.empty(most, 6, side, side, device=device, dtype=DTYPE)
        self.seen = set()
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
    guides, noise, guide_noise = some(n, 0.08, device), some(n, 0.08, device), some(n, 0.1, device)
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


def loss_of(output, target):
    """Returns absolute errors of tones and of their gradients at several sizes, and relative squared errors."""
    a, b = tone(output), tone(target)
    total = 0
    for size, weight in SCALES:
        p, q = (F.avg_pool2d(t, size) if size > 1 else t for t in (a, b))
        d = p - q
        across, down = d[..., :, 1:] - d[..., :, :-1], d[..., 1:, :] - d[..., :-1, :]
        total = total + weight * (d.abs().mean() + 0.5 * (across.abs().mean() + down.abs().mean()))
    squared = (output - target) ** 2 / (output.detach() ** 2 + 0.01)
    return total + 0.3 * torch.log1p(squared).mean()


def relative_error(output, target, noise):
    """Returns mean relative squared errors of pictures, without that of their targets."""
    return (((output - target) ** 2 - noise**2) / (target**2 + 0.01)).mean((1, 2, 3)).clamp_min(1e-7)


def judge(network, pictures):
    """Returns, for 4, 16 and 64 samples of the scenes that are held out: gain, and predicted over true error."""
    network.eval()
    result = []
    for n in (4, 16, 64):
        x = pictures.inputs[:HELD_OUT, PREFIXES.index(n)].float()
        target, noise = pictures.targets[:HELD_OUT].float().split(3, 1)
        with torch.no_grad():
            scale = exposure(x[:, :3])
            output, left = (torch.cat(t) / scale for t in zip(*(network(a, s) for a, s in zip(x.split(8), scale.split(8)))))
        before, after = relative_error(x[:, :3], target, noise), relative_error(output, target, noise)
        predicted = (left**2 / (output**2 + 0.01)).mean((1, 2, 3)).clamp_min(1e-9)
        result += [torch.log(before / after).mean().exp().item(), torch.log(predicted / after).median().exp().item()]
    network.train()
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
    parser.add_argument("--steps", type=int, default=1 << 60, help="at most")
    parser.add_argument("--batch", type=int, default=32)
    parser.add_argument("--rate", type=float, default=2e-3)
    parser.add_argument("--side", type=int, default=96, help="of the pictures")
    parser.add_argument("--most", type=int, default=3000, help="scenes")
    parser.add_argument("--least", type=int, default=2 * HELD_OUT, help="scenes before it begins")
    parser.add_argument("--save", type=float, default=60, help="seconds between results")
    parser.add_argument("--compile", action="store_true")
    return parser.parse_args()


def main():
    args = arguments()
    device = "cuda" if torch.cuda.is_available() else "cpu"
    torch.backends.cuda.matmul.allow_tf32 = torch.backends.cudnn.allow_tf32 = True
    torch.backends.cudnn.benchmark = True
    os.makedirs(args.out, exist_ok=True)
    network = Network().to(device)
    if device == "cuda":
        network = network.to(memory_format=torch.channels_last)
    if args.start:
        read_weights(network, args.start)
    mean = copy.deepcopy(network)
    optimizer = torch.optim.AdamW(network.parameters(), lr=args.rate, betas=(0.9, 0.99), weight_decay=1e-4, fused=device == "cuda")
    step, trained = 0, 0.0
    state = args.out + "/state.pt"
    if os.path.exists(state):
        kept = torch.load(state, map_location=device)
        step, trained = kept["step"], kept["trained"]
        network.load_state_dict(kept["network"])
        mean.load_state_dict(kept["mean"])
        optimizer.load_state_dict(kept["optimizer"])
    pictures = Pictures(args.data, args.most, args.side, device)
    often = torch.tensor(OFTEN, device=device)

    def result():
        if not all(torch.isfinite(p).all() for p in mean.parameters()):
            raise SystemExit("the weights are not finite any more")
        line = "%d,%.0f,%d," % (step, trained, pictures.count) + ",".join("%.3f" % v for v in judge(mean, pictures))
        print(line, "loss %.4f" % float(recent), flush=True)
        with open(args.out + "/log.csv", "a") as log:
            log.write(line + "\n")
        write_weights(mean, args.out + "/weights.f16")
        kept = dict(step=step, trained=trained, network=network.state_dict(), mean=mean.state_dict())
        save(state, dict(kept, optimizer=optimizer.state_dict()))

    def loss_at(x, target, scale):
        return loss_of(network(x, scale)[0], target)

    if args.compile:
        loss_at = torch.compile(loss_at)
    while pictures.count < args.least:
        time.sleep(1)
    recent = torch.zeros((), device=device)
    last = saved = time.time()
    first, before = step, trained
    print("scenes %d, step %d, on %s" % (pictures.count, step, device), flush=True)
    result()
    while trained < args.seconds and step < args.steps:
        done = trained / args.seconds
        rate = args.rate * min(1, (step + 1) / 300) * (0.5 + 0.5 * math.cos(math.pi * max(0, (done - 0.1) / 0.9))) + 1e-6
        for group in optimizer.param_groups:
            group["lr"] = rate
        x, target, _ = batch(pictures, args.batch, often)
        scale = exposure(x[:, :3])
        scale = scale * torch.exp(torch.empty_like(scale).uniform_(-0.6, 0.6))
        optimizer.zero_grad(set_to_none=True)
        loss = loss_at(x, (target * scale).clamp_max(200), scale)
        loss.backward()
        torch.nn.utils.clip_grad_norm_(network.parameters(), 1.0)
        optimizer.step()
        step += 1
        recent = recent * 0.99 + loss.detach() * 0.01
        with torch.no_grad():
            torch._foreach_lerp_(list(mean.parameters()), list(network.parameters()), 1 - min(0.9995, step / (step + 100.0)))
        if step % 20 == 0:
            now = time.time()
            trained += now - last
            last = now
            if now - saved > args.save:
                saved = now
                print("%.1f steps/s, rate %.5f" % ((step - first) / max(1e-9, trained - before), rate), flush=True)
                result()
                last = time.time()
    result()


if __name__ == "__main__":
    main()
