#!/bin/sh
# Scenes as Jmol, Open Babel, Inkscape, DRAWxtl, Voro++, polymake, Blender and FreeCAD write them, each where it is installed.
# Usage: others.sh FOLDER
here=$(cd "$(dirname "$0")" && pwd)
cd "$1" || exit 1
have() {
    command -v "$1" > /dev/null || { echo "programs: $1 is not installed: its scenes are left out" >&2; return 1; }
}

cat > molecule.xyz <<'END'
9
ethanol
C  1.1879 -0.3829  0.0000
C  0.0000  0.5526  0.0000
O -1.1867 -0.2472  0.0000
H -1.9237  0.3850  0.0000
H  2.0985  0.2306  0.0000
H  1.1184 -1.0093  0.8869
H  1.1184 -1.0093 -0.8869
H -0.0227  1.1812  0.8852
H -0.0227  1.1812 -0.8852
END

if have obabel; then
    obabel molecule.xyz -O openbabel_sticks.pov > /dev/null
    obabel molecule.xyz -O openbabel_bas.pov -xm BAS > /dev/null
    obabel molecule.xyz -O openbabel_spacefill.pov -xm SPF > /dev/null
    obabel molecule.xyz -O openbabel_capped.pov -xm CST > /dev/null
    obabel molecule.xyz -O openbabel_clear.pov -xt -xc -xf -xs > /dev/null
fi
if have jmol && have xvfb-run; then
    for view in 'spacefill 25%; wireframe 0.15' 'spacefill; wireframe off' 'isosurface sasurface translucent' \
                'spacefill 25%; select *; halos on' 'geosurface 0.5; spacefill 20%'; do
        name=jmol_$(echo "$view" | tr -dc 'a-z0-9')
        echo "load molecule.xyz; $view; write POVRAY $name.pov; exitJmol" > script.spt
        timeout 120 xvfb-run -a jmol -n -o -g160x120 -s script.spt > /dev/null 2>&1
    done
fi
if have inkscape; then
    cat > drawing.svg <<'END'
<svg xmlns="http://www.w3.org/2000/svg" width="200" height="200">
<path d="M20 20 L180 30 L150 170 C100 120 60 190 20 150 Z" fill="#c04020"/>
<path d="M60 60 L120 60 L90 120 Z" fill="#2060c0" fill-opacity=".6"/>
</svg>
END
    inkscape drawing.svg --export-filename=inkscape_drawing.pov > /dev/null 2>&1
    [ ! -e inkscape_drawing.pov ] || cat >> inkscape_drawing.pov <<'END'
camera { location <100, 100, -250> look_at <100, 100, 0> }
light_source { <0, 300, -300> rgb 1 }
END
fi
if have DRAWxtl55 && have xvfb-run; then
    cat > drawxtl_salt.str <<'END'
title rock salt
cell 5.64 5.64 5.64 90 90 90
spgr f m 3 m
pack -.1 1.1 -.1 1.1 -.1 1.1
atom Na 1 0 0 0
atom Cl 1 .5 .5 .5
polysz Na 3 Gray60
sphere Na 1 .5 Red
sphere Cl 1 .3 Green
bond Na Cl .1 2 3 White
end
END
    timeout 60 xvfb-run -a DRAWxtl55 drawxtl_salt.str < /dev/null > /dev/null 2>&1
    rm -f drawxtl_salt.[!p]*
fi
if have voro++; then
    awk 'BEGIN { srand(3); for (i = 0; i < 60; i++) print i, rand(), rand(), rand() }' > cells
    voro++ -y 0 1 0 1 0 1 cells
    mv cells_p.pov cells_p.inc
    mv cells_v.pov cells_v.inc
    cat > voro_cells.pov <<'END'
#version 3.6;
camera { location <2, -3, 2> sky z right -.5*x*image_width/image_height up .5*z look_at .5 }
background { rgb 1 }
light_source { <-8, -20, 30> color rgb <.77, .75, .75> }
#declare r = .015;
#declare s = .05;
union { #include "cells_p.inc" pigment { rgb .95 } finish { reflection .1 specular .3 } }
union { #include "cells_v.inc" pigment { rgb <1, .4, .45> } finish { specular .5 ambient .42 } }
END
fi
if have polymake; then
    printf 'use application "polytope";\n%s\n' \
        'povray(cube(3)->VISUAL(FacetColor => "255 100 50", FacetTransparency => .4), File => "polymake_solid");' > solid.pl
    polymake --script solid.pl < /dev/null > /dev/null 2>&1
    scene=$(sed -n 's/^#include "\(.*polymake-scene.pov\)"/\1/p' polymake_solid.pov)
    cp "$scene" polymake-scene.inc
    sed -i 's/^#include ".*polymake-scene.pov"/#include "polymake-scene.inc"/' polymake_solid.pov
fi
if have blender; then
    timeout 300 blender -b --python-exit-code 1 --python "$here/with_blender.py" -- "$PWD" > /dev/null
fi
if have freecadcmd; then
    SCENES=$PWD timeout 120 freecadcmd "$here/with_freecad.py" < /dev/null > /dev/null
fi
rm -f molecule.xyz script.spt drawing.svg cells cells.vol solid.pl
