"""Compare the layers of an OpenEXR file with the maps of .pfm files: layers.py EXR CHANNEL=PFM ... By OpenEXR's own reader
(PyPI: OpenEXR); each PFM has its channels in the order in which they are named."""
import sys

import numpy as np
import OpenEXR


def pfm(path):
    with open(path, 'rb') as f:
        assert f.readline() == b'PF\n'
        width, height = map(int, f.readline().split())
        f.readline()
        return np.frombuffer(f.read(), '<f4').reshape(height, width, 3)[::-1]


channels = OpenEXR.File(sys.argv[1], separate_channels=True).channels()
for i, pair in enumerate(sys.argv[2:]):
    name, path = pair.split('=')
    component = sum(other.endswith('=' + path) for other in sys.argv[2:2 + i])
    assert (channels[name].pixels == pfm(path)[:, :, component]).all(), name
    assert len(np.unique(channels[name].pixels)) > 1, name
