"""The denoiser's network in PyTorch; io.github.lumbre.render.denoise computes the same in Java.

A U-Net sees 16 planes of features. At each of its five levels it predicts, for each pixel, a kernel of 5x5 weights, how
far the coarser level replaces the low frequencies of this one, and a weight with which the pixel enters the next
coarser level. All levels filter the noisy light, once plain and once divided by albedo; at full size the network mixes
the two. So each pixel of the result is a weighted mean of noisy pixels.
"""

import numpy as np
import torch
import torch.nn as nn
import torch.nn.functional as F

PLANES = 14
FEATURES = 16
KERNEL = 5
TAPS = KERNEL * KERNEL
ALBEDO_FLOOR = 0.05
ENCODER = (16, 32, 48, 64, 64)
DECODER = (24, 32, 48, 64)
LEVELS = len(ENCODER)


def tone(light):
    return torch.log1p(8 * light.clamp_min(0)) * 0.5


def exposure(light):
    """Returns the factor for [B,3,H,W] that brings the geometric mean of blocks of 8x8 pixels to 0.18."""
    blocks = F.avg_pool2d(light.mean(1, keepdim=True), 8).flatten(1)
    lit = (blocks > 1e-6).float()
    mean = torch.exp((torch.log(blocks.clamp_min(1e-6)) * lit).sum(1) / lit.sum(1).clamp_min(1))
    return (0.18 / mean).clamp(1e-4, 1e5).view(-1, 1, 1, 1)


def features(x, scale):
    """Returns features [B,16,H,W], light plain and divided by albedo [B,6,H,W], and the divisor."""
    light, noise = x[:, 0:3] * scale, x[:, 3:6] * scale
    albedo, normal = x[:, 6:9].clamp(0, 1), x[:, 9:12].clamp(-1, 1)
    divisor = albedo + ALBEDO_FLOOR
    divided = light / divisor
    deviation = noise.abs().mean(1, keepdim=True)
    relative = deviation / (light.mean(1, keepdim=True) + 0.05) * 0.5
    guides = [albedo, normal, x[:, 12:13].clamp(0, 1), x[:, 13:14].clamp(0, 1)]
    return torch.cat([tone(light), tone(divided), tone(deviation), relative] + guides, 1), torch.cat([light, divided], 1), divisor


def convolution(inputs, outputs):
    layer = nn.Conv2d(inputs, outputs, 3, padding=1)
    nn.init.kaiming_normal_(layer.weight)
    nn.init.zeros_(layer.bias)
    return layer


def head(inputs, outputs):
    layer = nn.Conv2d(inputs, outputs, 1)
    nn.init.normal_(layer.weight, std=0.02)
    nn.init.zeros_(layer.bias)
    return layer


class Network(nn.Module):
    def __init__(self):
        super().__init__()
        e, d = ENCODER, DECODER
        below = [d[i + 1] if i + 1 < LEVELS - 1 else e[i + 1] for i in range(LEVELS - 1)]
        pairs = [(FEATURES if i == 0 else e[i - 1], e[i]) for i in range(LEVELS)]
        self.e = nn.ModuleList(nn.ModuleList([convolution(a, b), convolution(b, b)]) for a, b in pairs)
        self.d = nn.ModuleList(nn.ModuleList([convolution(e[i] + below[i], d[i]), convolution(d[i], d[i])]) for i in range(LEVELS - 1))
        widths = list(d) + [e[-1]]
        self.h = nn.ModuleList(head(widths[i], TAPS + 2 + (i == 0)) for i in range(LEVELS))

    def heads(self, x):
        """Returns what each level predicts: kernel, share of the coarser level, weight; at full size also the mix."""
        kept = []
        for level in range(LEVELS):
            if level:
                x = F.max_pool2d(x, 2)
            for layer in self.e[level]:
                x = F.relu(layer(x))
            kept.append(x)
        decoded = [None] * (LEVELS - 1) + [x]
        for level in reversed(range(LEVELS - 1)):
            x = torch.cat([F.interpolate(x, scale_factor=2, mode="nearest"), kept[level]], 1)
            for layer in self.d[level]:
                x = F.relu(layer(x))
            decoded[level] = x
        return [layer(x) for layer, x in zip(self.h, decoded)]

    def forward(self, x, scale):
        """Returns denoised light and filtered noise [B,3,H,W] in units of 1/scale; x is [B,14,H,W], sides are multiples of 16."""
        planes, light, divisor = features(x, scale)
        with torch.autocast("cuda", dtype=torch.bfloat16, enabled=x.is_cuda and self.training, cache_enabled=False):
            heads = [h.float().contiguous() for h in self.heads(planes)]
        if not self.training:
            noise = x[:, 3:6] * scale
            light = torch.cat([light, noise, noise / divisor], 1)
        filtered = combine(heads, light)
        mix = torch.sigmoid(heads[0][:, TAPS + 2 :])
        both = [mix * f[:, 3:] * divisor + (1 - mix) * f[:, :3] for f in filtered.split(6, 1)]
        return both[0].clamp_min(0), both[-1]


def combine(heads, light):
    """Filters light at all levels, which [B,C,H,W] and the heads tell."""
    weight = torch.ones_like(light[:, :1])
    levels = []
    for level, h in enumerate(heads):
        b, c, height, width = light.shape
        kernel = torch.softmax(h[:, :TAPS], 1).view(b, 1, KERNEL, KERNEL, height, width)
        padded = F.pad(light, (KERNEL // 2,) * 4, mode="replicate")
        near = padded.unfold(2, height, 1).unfold(3, width, 1)
        levels.append((near * kernel).sum((2, 3)))
        if level < LEVELS - 1:
            weight = torch.exp(h[:, TAPS + 1 : TAPS + 2].clamp(-8, 8)) * weight
            pooled = F.avg_pool2d(weight, 2)
            light = F.avg_pool2d(light * weight, 2) / pooled
            weight = pooled
    result = levels[-1]
    for level in reversed(range(LEVELS - 1)):
        share = torch.sigmoid(heads[level][:, TAPS : TAPS + 1])
        change = result - F.avg_pool2d(levels[level], 2)
        result = levels[level] + share * F.interpolate(change, scale_factor=2, mode="bilinear", align_corners=False)
    return result


def write_weights(network, file):
    """Writes weights and then biases of each layer, in the order of the network's lists, as 16-bit floats, little-endian."""
    layers = [layer for pair in [*network.e, *network.d] for layer in pair] + list(network.h)
    values = [t.detach().cpu().float().numpy().ravel() for layer in layers for t in (layer.weight, layer.bias)]
    np.concatenate(values).astype("<f2").tofile(file)


def read_weights(network, file):
    """Sets a network's weights to those of a file that write_weights made."""
    layers = [layer for pair in [*network.e, *network.d] for layer in pair] + list(network.h)
    tensors = [t for layer in layers for t in (layer.weight, layer.bias)]
    values = torch.from_numpy(np.fromfile(file, "<f2").astype(np.float32))
    with torch.no_grad():
        for tensor, part in zip(tensors, values.split([t.numel() for t in tensors])):
            tensor.copy_(part.view_as(tensor))
