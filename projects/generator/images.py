# SPDX-License-Identifier: MIT
"""PNG files, 8 bits a channel, sRGB, by zlib alone."""
import struct
import zlib


def png(width, height, pixel):
    """pixel(u, v) -> linear red, green, blue, all within 0..1; u to the right, v downward, both in 0..1."""
    rows = bytearray()
    previous = bytes(3 * width)
    for j in range(height):
        row = bytearray()
        for i in range(width):
            row += bytes(_SRGB8[int(c * _STEPS + 0.5)] for c in pixel((i + 0.5) / width, (j + 0.5) / height))
        rows.append(2)  # filter "up": each byte less the one above
        rows += bytes((a - b) & 255 for a, b in zip(row, previous))
        previous = row
    header = struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)
    return (b"\x89PNG\r\n\x1a\n" + _chunk(b"IHDR", header) + _chunk(b"sRGB", b"\0")
            + _chunk(b"IDAT", zlib.compress(bytes(rows), 9)) + _chunk(b"IEND", b""))


def _chunk(kind, content):
    return struct.pack(">I", len(content)) + kind + content + struct.pack(">I", zlib.crc32(kind + content))


def _srgb8(linear):
    c = 12.92 * linear if linear <= 0.0031308 else 1.055 * linear ** (1 / 2.4) - 0.055
    return int(255 * c + 0.5)


_STEPS = 16383  # fine enough that no 8-bit code is skipped
_SRGB8 = [_srgb8(i / _STEPS) for i in range(_STEPS + 1)]


def png_pixels(content):
    """What a PNG of ours holds, however tightly zlib has packed it."""
    at, packed, header = 8, b"", b""
    while at < len(content):
        size, = struct.unpack(">I", content[at:at + 4])
        kind, body = content[at + 4:at + 8], content[at + 8:at + 8 + size]
        if kind == b"IHDR":
            header = body
        elif kind == b"IDAT":
            packed += body
        at += 12 + size
    return header + zlib.decompress(packed)
