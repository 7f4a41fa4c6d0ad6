"""Reads the plain PNG files that both programs write, without any library: small pictures, so that this is quick enough."""
import struct
import zlib


class Picture:
    """pixels: rows from the top, (red, green, blue) of 0 to 255."""

    def __init__(self, width, height, pixels):
        self.width, self.height, self.pixels = width, height, pixels

    def means(self, edge):
        """Of squares of so many pixels, those at the right and lower edge smaller."""
        columns, rows = -(-self.width // edge), -(-self.height // edge)
        sums = [[0, 0, 0, 0] for _ in range(columns * rows)]
        for i, pixel in enumerate(self.pixels):
            cell = sums[i // self.width // edge * columns + i % self.width // edge]
            for k in range(3):
                cell[k] += pixel[k]
            cell[3] += 1
        return Picture(columns, rows, [tuple(s[k] / s[3] for k in range(3)) for s in sums])

    def light_means(self, edge):
        """The same of the light that the values stand for (a power of 2.2), as values again: edges within pixels do not count."""
        light = Picture(self.width, self.height, [tuple((v / 255) ** 2.2 for v in pixel) for pixel in self.pixels]).means(edge)
        return Picture(light.width, light.height, [tuple(255 * v ** (1 / 2.2) for v in pixel) for pixel in light.pixels])


def unpack(path):
    """Width, height, bits, kind of colour, and the filtered rows."""
    with open(path, 'rb') as file:
        data = file.read()
    at, packed = 8, b''
    while at + 12 <= len(data):
        length, kind = struct.unpack('>I4s', data[at:at + 8])
        body = data[at + 8:at + 8 + length]
        if kind == b'IHDR':
            width, height, bits, colour = struct.unpack('>IIBB', body[:10])
        elif kind == b'IDAT':
            packed += body
        at += 12 + length
    return width, height, bits, colour, zlib.decompress(packed)


def read(path):
    width, height, bits, colour, raw = unpack(path)
    step = {0: 1, 2: 3, 4: 2, 6: 4}[colour] * bits // 8
    return Picture(width, height, pixels_of(raw, width, height, step, bits // 8, colour))


def pixels_of(raw, width, height, step, size, colour):
    above, pixels, at = bytearray(width * step), [], 0
    for _ in range(height):
        row = unfilter(raw[at], bytearray(raw[at + 1:at + 1 + width * step]), above, step)
        at += 1 + width * step
        for x in range(0, width * step, step):
            pixels.append((row[x],) * 3 if colour in (0, 4) else (row[x], row[x + size], row[x + 2 * size]))
        above = row
    return pixels


def unfilter(kind, row, above, step):
    """0 none, 1 left, 2 above, 3 their mean, 4 the Paeth predictor."""
    for i in range(len(row) if kind else 0):
        left, up = row[i - step] if i >= step else 0, above[i]
        corner = above[i - step] if i >= step else 0
        if kind == 1:
            row[i] = (row[i] + left) & 255
        elif kind == 2:
            row[i] = (row[i] + up) & 255
        elif kind == 3:
            row[i] = (row[i] + (left + up) // 2) & 255
        else:
            row[i] = (row[i] + paeth(left, up, corner)) & 255
    return row


def paeth(left, up, corner):
    guess = left + up - corner
    a, b, c = abs(guess - left), abs(guess - up), abs(guess - corner)
    return left if a <= b and a <= c else up if b <= c else corner
