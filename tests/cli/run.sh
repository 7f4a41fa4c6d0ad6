#!/bin/sh
# povc as its users meet it. BUILD_DIR names the build, $CC the compiler for plugins that are wrong on purpose.
# Usage: tests/cli/run.sh [WORD ...]; words choose among: usage messages malformed output signals plugins wide pictures reports refine parts povray frames includes
. "$(dirname "$0")/../support/cases.sh"

drive=$root/tests/cli/drive.py
pixels=$root/tests/cli/pixels.py

# A small scene that every primitive test could be: one sphere, one light.
small_scene() {
    cat > "${1:-small.pov}" <<'END'
camera { location <0, 0, -4> look_at <0, 0, 0> }
light_source { <-5, 8, -9> color rgb <1, 1, 1> }
sphere { <0, 0, 0>, 1 pigment { color rgb <1, .5, .25> } finish { ambient .2 diffuse .7 phong .5 } }
END
}

# Mirrors, glass, coloured shadows: all that a ray may do.
rich_scene() {
    cat > "${1:-rich.pov}" <<'END'
camera { location <0, 2, -8> look_at <0, .5, 0> angle 50 }
light_source { <-5, 8, -9> color rgb <1, 1, 1> }
light_source { <6, 4, -3> color rgb <.4, .4, .6> }
sphere { <0, 1, 0>, 1 pigment { color rgbf <.8, 1, .9, .9> } finish { reflection .1 phong .6 } interior { ior 1.5 } }
sphere { <-2.2, 1, 1>, 1 pigment { color rgb <.9, .3, .2> } finish { ambient .1 reflection .5 } }
sphere { <2.2, 1, 1>, 1 pigment { color rgb <.2, .3, .9> } finish { ambient .1 diffuse .8 } scale <1, .6, 1> }
sphere { <0, -100, 0>, 100 pigment { color rgb <.7, .7, .7> } finish { ambient .1 diffuse .7 reflection .2 } }
END
}

for group in ${*:-usage messages malformed output signals plugins wide pictures reports refine parts povray frames includes}; do
    . "$root/tests/cli/$group.sh"
    run_cases_of "$root/tests/cli/$group.sh" "$group"
done
end_cases
