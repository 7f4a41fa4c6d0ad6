"""Reads the two kinds of picture that are compared: POV-Ray's 16-bit PNG and povc's PFM.

Both come back as arrays of shape (height, width, 3) of doubles, the top row first. The PNG's gAMA chunk
is left alone on purpose: what was stored is what is wanted.
"""
import re
import struct
import zlib

import numpy


class PictureError(Exception):
    """The file is not a picture of the kind asked for."""


def read_png(path):
    """An RGB or RGBA PNG of 8 or 16 bits, not interlaced, as stored values in 0..1."""
    with open(path, 'rb') as file:
        data = file.read()
    if data[:8] != b'\x89PNG\r\n\x1a\n':
        raise PictureError(f'{path}: not a PNG')
    header, packed = None, b''
    for kind, body in png_chunks(data):
        if kind == b'IHDR':
            header = struct.unpack('>IIBBBBB', body)
        elif kind == b'IDAT':
            packed += body
    if header is None or header[2] not in (8, 16) or header[3] not in (2, 6) or header[6] != 0:
        raise PictureError(f'{path}: not a plain RGB PNG of 8 or 16 bits')
    width, height, bits, colour = header[:4]
    channels = 3 if colour == 2 else 4
    rows = unfilter(zlib.decompress(packed), width * channels * bits // 8, height, channels * bits // 8)
    samples = rows.view('>u2') if bits == 16 else rows
    return samples.reshape(height, width, channels)[:, :, :3].astype(float) / (2 ** bits - 1)


def png_chunks(data):
    """Each chunk of a PNG as (kind, body)."""
    at = 8
    while at + 12 <= len(data):
        length, kind = struct.unpack('>I4s', data[at:at + 8])
        yield kind, data[at + 8:at + 8 + length]
        at += 12 + length


def unfilter(raw, stride, height, step):
    """Undoes the PNG row filters; step is the number of bytes of one pixel."""
    rows = numpy.zeros((height, stride), numpy.uint8)
    above = numpy.zeros(stride, numpy.uint8)
    for y in range(height):
        start = y * (stride + 1)
        row = numpy.frombuffer(raw, numpy.uint8, stride, start + 1).copy()
        above = rows[y] = unfilter_row(raw[start], row, above, step)
    return rows


def unfilter_row(kind, row, above, step):
    """One row of PNG bytes: 0 none, 1 left, 2 above, 3 their mean, 4 the Paeth predictor."""
    if kind == 0:
        return row
    if kind == 1:
        for channel in range(step):
            row[channel::step] = numpy.cumsum(row[channel::step], dtype=numpy.uint64).astype(numpy.uint8)
        return row
    if kind == 2:
        return row + above
    out, up = row.tolist(), above.tolist()
    for i, value in enumerate(out):
        left = out[i - step] if i >= step else 0
        if kind == 3:
            out[i] = (value + (left + up[i]) // 2) & 255
        else:
            corner = up[i - step] if i >= step else 0
            out[i] = (value + paeth(left, up[i], corner)) & 255
    return numpy.array(out, numpy.uint8)


def paeth(left, up, corner):
    """The one of three neighbours that is nearest to left + up - corner."""
    guess = left + up - corner
    to_left, to_up, to_corner = abs(guess - left), abs(guess - up), abs(guess - corner)
    if to_left <= to_up and to_left <= to_corner:
        return left
    return up if to_up <= to_corner else corner


def read_pfm(path):
    """A colour PFM of either byte order; the file's rows run from the bottom up."""
    with open(path, 'rb') as file:
        data = file.read()
    header = re.match(rb'PF\s+(\d+)\s+(\d+)\s+(\S+)\s', data)
    if not header:
        raise PictureError(f'{path}: not a colour PFM')
    width, height, scale, start = int(header[1]), int(header[2]), float(header[3]), header.end()
    count = width * height * 3
    if len(data) - start < count * 4:
        raise PictureError(f'{path}: ends early')
    samples = numpy.frombuffer(data, '<f4' if scale < 0 else '>f4', count, start)
    return samples.reshape(height, width, 3)[::-1].astype(float) * abs(scale)
