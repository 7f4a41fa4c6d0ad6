"""A viewer for the test of --tev: reads the packets of one connection, and holds the picture that they make against a PFM.
Usage: tev.py PORT_FILE NAME PICTURE.pfm [CLOSE_AFTER]     (CLOSE_AFTER: packets, then it hangs up)"""
import array
import socket
import struct
import sys
from pathlib import Path


def read_exactly(stream, count):
    data = stream.read(count)
    if len(data) < count:
        raise EOFError
    return data


def text(data, at):
    end = data.index(b'\0', at)
    return data[at:end].decode(), end + 1


def channels(data, at):
    count, = struct.unpack_from('<i', data, at)
    at += 4
    names = []
    for _ in range(count):
        name, at = text(data, at)
        names.append(name)
    return names, at


def update(data, name, picture, size):
    assert data[1] == 0, 'an update takes the focus'
    title, at = text(data, 2)
    assert title == name
    names, at = channels(data, at)
    x, y, width, height = struct.unpack_from('<4i', data, at)
    offsets = struct.unpack_from('<3q', data, at + 16)
    strides = struct.unpack_from('<3q', data, at + 40)
    values = array.array('f', data[at + 64:])
    assert names == ['R', 'G', 'B'] and 0 <= x and 0 <= y and x + width <= size[0] and y + height <= size[1]
    assert len(values) == max(o + (width * height - 1) * s + 1 for o, s in zip(offsets, strides))
    for i in range(width * height):
        for c in range(3):
            picture[(y + i // width, x + i % width, c)] = values[offsets[c] + i * strides[c]]


def receive(stream, name, limit):
    picture, size, packets = {}, None, 0
    try:
        while packets < limit:
            length, = struct.unpack('<I', read_exactly(stream, 4))
            data = read_exactly(stream, length - 4)
            packets += 1
            if packets == 1:
                assert data[0] == 4 and data[1] == 1
                title, at = text(data, 2)
                size = struct.unpack_from('<2i', data, at)
                assert title == name and channels(data, at + 8) == (['R', 'G', 'B'], len(data))
            else:
                assert data[0] == 6
                update(data, name, picture, size)
    except EOFError:
        pass
    return picture, size, packets


def main():
    port_file, name, expected, *limit = sys.argv[1:]
    with socket.create_server(('127.0.0.1', 0)) as server:
        Path(port_file + '.tmp').write_text(str(server.getsockname()[1]))
        Path(port_file + '.tmp').rename(port_file)
        connection, _ = server.accept()
        with connection, connection.makefile('rb') as stream:
            picture, size, packets = receive(stream, name, int(limit[0]) if limit else sys.maxsize)
    if limit:
        return
    assert len(picture) == 3 * size[0] * size[1], f'{len(picture)} values of {size}'
    pfm = Path(expected).read_bytes()
    values = array.array('f', pfm[len(pfm) - 12 * size[0] * size[1]:])
    for (y, x, c), value in picture.items():
        assert values[3 * ((size[1] - 1 - y) * size[0] + x) + c] == value, (x, y, c)
    print(f'{packets} packets')


main()
