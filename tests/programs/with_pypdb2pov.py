"""Scenes as pypdb2pov writes them (it wants Python 3.12).

Usage: with_pypdb2pov.py FOLDER"""
import os
import shutil
import subprocess
import sys
from pathlib import Path

import pypdb2pov

os.chdir(sys.argv[1])
ATOMS = [('C', 1.188, -.383, 0), ('C', 0, .553, 0), ('O', -1.187, -.247, 0), ('H', -1.924, .385, 0), ('H', 2.099, .231, 0),
         ('H', 1.118, -1.009, .887), ('H', 1.118, -1.009, -.887), ('H', -.023, 1.181, .885), ('H', -.023, 1.181, -.885)]
LINE = 'HETATM{0:5d}  {1:<4}ETH A   1    {2:8.3f}{3:8.3f}{4:8.3f}  1.00  0.00          {1:>2}\n'

Path('ethanol.pdb').write_text(''.join(LINE.format(i + 1, *atom) for i, atom in enumerate(ATOMS)) + 'END\n', encoding='ascii')
for included in (Path(pypdb2pov.__file__).parent / 'include').glob('*.inc'):
    shutil.copy(included, '.')
for name, words in (('filled', '-v -s -g'), ('small', '-c -p'), ('sticks', '-b -h -a --bonds covalent')):
    subprocess.run([sys.executable, '-m', 'pypdb2pov', 'ethanol.pdb', f'pypdb2pov_{name}.pov', *words.split()], check=True)
