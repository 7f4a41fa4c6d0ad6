#!/bin/sh
# Scenes as Jmol, Open Babel, Inkscape, DRAWxtl, Voro++, polymake, Graphviz, OpenSceneGraph, GRASS, ESyS-Particle,
# Avogadro, Blender and FreeCAD write them, each where it is installed.
# Usage: others.sh FOLDER
here=$(cd "$(dirname "$0")" && pwd)
cd "$1" || exit 1
have() {
    command -v "$1" > /dev/null || { echo "programs: $1 is not installed: its scenes are left out" >&2; return 1; }
}
# within SECONDS PROGRAM...: says only what went wrong.
within() {
    timeout "$@" > said 2>&1 < /dev/null || { echo "programs: failed, or took longer than that: $*" >&2; tail -n 3 said >&2; }
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
    within 60 obabel molecule.xyz -O openbabel_sticks.pov
    within 60 obabel molecule.xyz -O openbabel_bas.pov -xm BAS
    within 60 obabel molecule.xyz -O openbabel_spacefill.pov -xm SPF
    within 60 obabel molecule.xyz -O openbabel_capped.pov -xm CST
    within 60 obabel molecule.xyz -O openbabel_clear.pov -xt -xc -xf -xs
fi
if have jmol && have xvfb-run; then
    for view in 'spacefill 25%; wireframe 0.15' 'spacefill; wireframe off' 'isosurface sasurface translucent' \
                'spacefill 25%; select *; halos on' 'geosurface 0.5; spacefill 20%'; do
        name=jmol_$(echo "$view" | tr -dc 'a-z0-9')
        echo "load molecule.xyz; $view; write POVRAY $name.pov; exitJmol" > script.spt
        within 120 xvfb-run -a jmol -n -o -g160x120 -s script.spt
    done
fi
if have inkscape; then
    cat > drawing.svg <<'END'
<svg xmlns="http://www.w3.org/2000/svg" width="200" height="200">
<path d="M20 20 L180 30 L150 170 C100 120 60 190 20 150 Z" fill="#c04020"/>
<path d="M60 60 L120 60 L90 120 Z" fill="#2060c0" fill-opacity=".6"/>
</svg>
END
    within 120 inkscape drawing.svg --export-filename=inkscape_drawing.pov
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
    timeout 30 xvfb-run -a DRAWxtl55 drawxtl_salt.str < /dev/null > /dev/null 2>&1   # its window stays open
    rm -f drawxtl_salt.[!p]*
fi
if have voro++; then
    awk 'BEGIN { srand(3); for (i = 0; i < 60; i++) print i, rand(), rand(), rand() }' > cells
    within 60 voro++ -y 0 1 0 1 0 1 cells
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
    within 300 polymake --script solid.pl
    scene=$(sed -n 's/^#include "\(.*polymake-scene.pov\)"/\1/p' polymake_solid.pov)
    cp "$scene" polymake-scene.inc
    sed -i 's/^#include ".*polymake-scene.pov"/#include "polymake-scene.inc"/' polymake_solid.pov
fi
if have dot; then
    cat > graph.dot <<'END'
digraph parts {
  graph [bgcolor=transparent, fontname="timrom.ttf", label="parts of a scene"]; node [style=filled, fontname="cyrvetic.ttf"];
  edge [fontname="crystal.ttf"];
  scene [shape=box, fillcolor="#c04020"]; camera [shape=ellipse, fillcolor="#ffd700"]; light [shape=hexagon, fillcolor="#80c0ff"];
  object [shape=doublecircle, fillcolor="#98fb98"]; texture [shape=polygon, sides=5, fillcolor="#dda0dd80"];
  scene -> camera; scene -> light [color="#ff0000"]; scene -> object [style=dashed, label="many"]; object -> texture [penwidth=3];
}
END
    within 60 dot -Tpov graph.dot -o graphviz_parts.pov
    within 60 dot -Kneato -Tpov graph.dot -o graphviz_springs.pov
fi
if have osgconv; then
    printf 'newmtl red\nKa .2 .1 .1\nKd .8 .2 .1\nKs .5 .5 .5\nNs 40\n' > pyramid.mtl
    cat > pyramid.obj <<'END'
mtllib pyramid.mtl
v 0 0 0
v 1 0 0
v 1 1 0
v 0 1 0
v .5 .5 1
vt 0 0
vt 1 0
vt 1 1
vt 0 1
vn 0 0 -1
vn 0 -.9 .4
vn .9 0 .4
vn 0 .9 .4
vn -.9 0 .4
usemtl red
f 1/1/1 4/4/1 3/3/1 2/2/1
f 1/1/2 2/2/2 5/3/2
f 2/1/3 3/2/3 5/3/3
f 3/1/4 4/2/4 5/3/4
f 4/1/5 1/2/5 5/3/5
END
    within 60 osgconv -o 60-1,0.2,0.3 pyramid.obj osg_pyramid.pov
    [ ! -e osg_pyramid.pov ] || echo 'light_source { <2, 3, -5> rgb 1 }' >> osg_pyramid.pov
fi
if have grass; then
    cat > map.sh <<'END'
g.region n=64 s=0 e=64 w=0 res=1
r.mapcalc "hill = 20 * exp(-((row()-32)^2 + (col()-24)^2) / 200.0) + 8 + 8 * sin(row() * 12) * cos(col() * 17)" --q
r.out.pov input=hill output=grass_hill.tga --q
r.contour input=hill output=lines step=4 --q
v.out.pov input=lines output=grass_lines.inc size=0.3 zmod=+28 objmod="pigment { rgb <1, .8, .2> }" --q
v.random output=points npoints=40 seed=1 zmin=26 zmax=34 -z --q
v.out.pov input=points output=grass_points.inc size=1 objmod="pigment { rgb x }" --q
v.random output=sites npoints=12 seed=2 --q
v.voronoi input=sites output=cells --q
v.out.pov input=cells output=grass_areas.inc zmod=+30 objmod="pigment { rgbt <.3, .6, .4, .5> }" --q
END
    within 120 grass --tmp-location XY --exec sh map.sh
    cat > grass_map.pov <<'END'
#version 3.6;
camera { location <32, 70, -40> look_at <32, 10, 28> }
background { rgb <.7, .8, 1> }
light_source { <-60, 90, -30> rgb 1 }
height_field { tga "grass_hill.tga" smooth scale <64, 3600, 64> pigment { rgb <.4, .6, .3> } }
#include "grass_lines.inc"
#include "grass_points.inc"
#include "grass_areas.inc"
END
fi
if have mesh2pov; then
    printf 'Triangle\n3D-Nodes 5\n0 0 0 0 0 0\n1 1 0 1 0 0\n2 2 0 1 1 0\n3 3 0 0 1 0\n4 4 0 .5 .5 .8\n\n' > walls.lsm
    printf 'Tri3 4\n0 0 0 1 4\n1 0 1 2 4\n2 0 2 3 4\n3 0 3 0 4\n' >> walls.lsm
    within 60 mesh2pov -i walls.lsm -o esys_walls.inc
    cat > esys_walls.pov <<'END'
camera { location <3, 2, 3> look_at <.5, .5, .3> sky z }
light_source { <5, 3, 8> rgb 1 }
#include "esys_walls.inc"
END
fi
if [ -e /usr/include/avogadro/rendering/povrayvisitor.h ]; then
    within 120 ${CXX:-g++} -I/usr/include/eigen3 -I/usr/include/avogadro "$here/with_avogadro.cpp" -lAvogadroRendering -lAvogadroCore -o writer
    timeout 60 ./writer > avogadro_molecule.pov
fi
if have blender; then
    within 300 blender -b --python-exit-code 1 --python "$here/with_blender.py" -- "$PWD"
fi
if have freecadcmd; then
    export SCENES="$PWD"
    within 120 freecadcmd "$here/with_freecad.py"
fi
rm -f molecule.xyz script.spt drawing.svg cells cells.vol solid.pl graph.dot pyramid.obj pyramid.mtl map.sh walls.lsm writer said
