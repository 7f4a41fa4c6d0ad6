#!/usr/bin/env python3
"""Look into image files, by nothing but the formats' own rules.

pixels.py size FILE                    prints WIDTH HEIGHT BITS
pixels.py chunks FILE.png              prints the names of the chunks
pixels.py part WHOLE X0 Y0 X1 Y1 FILE  fails unless FILE is that part of WHOLE
pixels.py same A B                     fails unless both hold the same samples
pixels.py black FILE                   prints the share of black pixels
pixels.py near A.pfm B.pfm D N         fails if more than N pixels differ by more than D
pixels.py between FILE.pfm X Y LO HI   fails unless the pixel's channels lie in LO .. HI
pixels.py mean FILE.pfm                prints the channels' means
"""
import struct
import sys
import zlib


def read_header(data, count):
    words, at = [], 0
    while len(words) < count:
        end = at
        while data[end:end + 1] not in (b" ", b"\n"):
            end += 1
        words.append(data[at:end])
        at = end + 1
    return words, at


def rows_of(data, width, height, bytes_per_pixel):
    stride = width * bytes_per_pixel
    assert len(data) == stride * height, "%d bytes for %d rows of %d" % (len(data), height, stride)
    return [[data[y * stride + x * bytes_per_pixel:y * stride + (x + 1) * bytes_per_pixel]
             for x in range(width)] for y in range(height)]


def png_chunks(data):
    assert data[:8] == b"\x89PNG\r\n\x1a\n"
    at = 8
    while at < len(data):
        length, name = struct.unpack(">I4s", data[at:at + 8])
        body = data[at + 8:at + 8 + length]
        assert zlib.crc32(name + body) == struct.unpack(">I", data[at + 8 + length:at + 12 + length])[0]
        yield name.decode(), body
        at += 12 + length


def undo_filter(kind, line, above, step):
    line = bytearray(line)
    for i in range(len(line)):
        left = line[i - step] if i >= step else 0
        up = above[i]
        corner = above[i - step] if i >= step else 0
        guess = left + up - corner
        nearest = min((abs(guess - left), 0, left), (abs(guess - up), 1, up), (abs(guess - corner), 2, corner))[2]
        line[i] = (line[i] + (0, left, up, (left + up) // 2, nearest)[kind]) & 255
    return line


def read_png(data):
    body, width, height, bits = b"", 0, 0, 0
    for name, content in png_chunks(data):
        if name == "IHDR":
            width, height, bits, colour, _, _, interlace = struct.unpack(">IIBBBBB", content)
            assert colour == 2 and interlace == 0
        elif name == "IDAT":
            body += content
    body = zlib.decompress(body)
    step = 3 * bits // 8
    above, lines = bytearray(width * step), []
    for y in range(height):
        start = y * (width * step + 1)
        above = undo_filter(body[start], body[start + 1:start + 1 + width * step], above, step)
        lines.append(bytes(above))
    return width, height, bits, rows_of(b"".join(lines), width, height, step)


def read(path):
    with open(path, "rb") as file:
        data = file.read()
    if data[:4] == b"\x89PNG":
        return read_png(data)
    words, at = read_header(data, 4)
    width, height = int(words[1]), int(words[2])
    if words[0] == b"PF":
        assert words[3] == b"-1.0"
        return width, height, 32, rows_of(data[at:], width, height, 12)[::-1]
    assert words[0] == b"P6"
    bits = {b"255": 8, b"65535": 16}[words[3]]
    return width, height, bits, rows_of(data[at:], width, height, 3 * bits // 8)


def floats(path):
    return [[struct.unpack("<3f", pixel) for pixel in row] for row in read(path)[3]]


def main():
    what, files = sys.argv[1], sys.argv[2:]
    if what == "size":
        print(*read(files[0])[:3])
    elif what == "chunks":
        with open(files[0], "rb") as file:
            print(*[name for name, _ in png_chunks(file.read())])
    elif what == "part":
        x0, y0, x1, y1 = map(int, files[1:5])
        part = [row[x0:x1] for row in read(files[0])[3][y0:y1]]
        assert read(files[5])[3] == part, "not that part"
    elif what == "same":
        a, b = read(files[0]), read(files[1])
        assert a[:3] == b[:3] and a[3] == b[3], "the samples differ"
    elif what == "black":
        width, height, _, rows = read(files[0])
        print(sum(not any(pixel) for row in rows for pixel in row) / (width * height))
    elif what == "near":
        off = sum(max(abs(p - q) for p, q in zip(a, b)) > float(files[2])
                  for one, other in zip(floats(files[0]), floats(files[1])) for a, b in zip(one, other))
        assert off <= int(files[3]), "%d pixels differ" % off
    elif what == "between":
        pixel = floats(files[0])[int(files[2])][int(files[1])]
        assert all(float(files[3]) <= c <= float(files[4]) for c in pixel), pixel
    elif what == "mean":
        pixels = [pixel for row in floats(files[0]) for pixel in row]
        print(*[sum(channel) / len(pixels) for channel in zip(*pixels)])


main()
