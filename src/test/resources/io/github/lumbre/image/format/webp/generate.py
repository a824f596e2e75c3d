"""Writes the WebP files of this folder, and decoded.csv: what libwebp makes of them.

python generate.py FOLDER, with the packages numpy, pillow 13.0 and webp 0.4 (an encoder with all settings)
"""

import hashlib
import sys

import numpy
import webp
from PIL import Image

folder = sys.argv[1]
random = numpy.random.default_rng(48)
rows = ["name,width,height,alpha,sha256"]


def picture(width, height, kind):
    """Waves, squares, noise, all of them side by side, or few colors."""
    y, x = numpy.mgrid[0:height, 0:width]
    waves = [x * 255 / width, y * 255 / height, 128 + 127 * numpy.sin(x * 0.3) * numpy.cos(y * 0.2), 255 - x * y % 256]
    squares = [(x // 5 + y // 7) % 2 * 255, x // 11 % 3 * 127, y // 3 % 2 * 200, (x // 9 + y // 4) % 2 * 255]
    noise = random.integers(0, 256, (4, height, width))
    if kind == "mixed":
        channels = numpy.where(x * 3 < width, waves, numpy.where(x * 3 < 2 * width, squares, noise))
    elif kind == "waves":
        channels = numpy.array(waves)
    else:
        colors = random.integers(0, 256, (int(kind), 4))
        channels = colors[(x // 3 + y // 2 + x * y // 7) % int(kind)].transpose(2, 0, 1)
    return numpy.clip(channels, 0, 255).astype(numpy.uint8).transpose(1, 2, 0)


def write(name, pixels, alpha, profile=b"", **settings):
    image = Image.fromarray(pixels if alpha else pixels[..., :3].copy())
    file = f"{folder}/{name}.webp"
    if profile:
        image.save(file, "WEBP", icc_profile=profile, exif=b"Exif\0\0", **settings)
    else:
        config = webp.WebPConfig.new(lossless=settings.pop("lossless", False), quality=settings.pop("quality", 75))
        # The package names only some of the numbers of libwebp's structure.
        numbers = webp.ffi.cast("int*", config.ptr)
        numbers[24] = 1  # Keep the colors of transparent pixels.
        places = {"method": 2, "segments": 6, "strength": 8, "sharpness": 9, "filter": 10, "compression": 12}
        places |= {"filtering": 13, "alpha_quality": 14, "parts": 18}
        for key, value in settings.items():
            numbers[places[key]] = value
        with open(file, "wb") as out:
            out.write(bytes(webp.WebPPicture.from_pil(image).encode(config).buffer()))
    decoded = Image.open(file)
    has_alpha = decoded.mode == "RGBA"
    decoded = decoded.convert("RGBA")
    hash = hashlib.sha256(decoded.tobytes()).hexdigest()
    rows.append(f"{name},{decoded.width},{decoded.height},{str(has_alpha).lower()},{hash}")


write("lossy", picture(50, 35, "mixed"), False, method=4)
write("lossy-simple", picture(50, 35, "mixed"), False, filter=0, strength=60, segments=4, quality=20)
write("lossy-sharp", picture(50, 50, "mixed"), False, filter=1, strength=100, sharpness=5, segments=2, parts=2)
write("lossy-fine", picture(33, 17, "waves"), False, quality=98, method=6, parts=3)
write("lossy-coarse", picture(64, 64, "mixed"), False, quality=1)
write("lossy-pixel", picture(1, 1, "waves"), False)
write("lossy-column", picture(1, 40, "mixed"), False)
write("lossy-row", picture(40, 2, "mixed"), False)
write("alpha-raw", picture(20, 15, "waves"), True, compression=0, filtering=0)
write("alpha-filtered", picture(50, 35, "waves"), True, filtering=2)
write("alpha-levels", picture(40, 20, "mixed"), True, alpha_quality=30)
write("lossless", picture(50, 35, "mixed"), True, lossless=True, method=4)
write("lossless-opaque", picture(61, 47, "waves"), False, lossless=True, quality=100, method=6)
write("lossless-fast", picture(30, 20, "mixed"), True, lossless=True, quality=0, method=0)
write("lossless-pixel", picture(1, 1, "waves"), True, lossless=True)
for colors in (2, 4, 16, 100):
    write(f"lossless-{colors}-colors", picture(53, 31, str(colors)), True, lossless=True)
write("extended", picture(20, 10, "waves"), True, profile=b"\0" * 200, quality=80)
Image.fromarray(picture(8, 8, "waves")).save(
    f"{folder}/animation.webp", save_all=True, append_images=[Image.fromarray(picture(8, 8, "2"))], duration=100
)
with open(f"{folder}/decoded.csv", "w") as out:
    out.write("\n".join(rows) + "\n")
