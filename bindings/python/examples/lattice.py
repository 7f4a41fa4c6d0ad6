"""A lattice of glass and metal, by the scene language's own loops, and a value from Python. Usage: lattice.py [OUTPUT]"""
import sys

import povtrace

TEXT = """
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 8 }
camera { location <5, 4, -7> look_at 0 angle 36 }
light_source { <8, 10, -9> rgb 1 }
background { rgb <.7, .8, .9> }
#for (X, -N, N) #for (Y, -N, N) #for (Z, -N, N)
    sphere {
        <X, Y, Z>, .3
        #if (mod(X + Y + Z, 2) = 0)
            pigment { rgb <.9, .6, .3> } finish { reflection .3 specular .6 }
        #else
            pigment { rgbt <.9, .95, 1, .9> } finish { reflection .1 specular .8 } interior { ior 1.3 }
        #end
    }
#end #end #end
"""

scene = povtrace.Scene(TEXT, declare={"N": 1})
picture = scene.render(480, 360, error=.01, time=20)
picture.png(sys.argv[1] if len(sys.argv) > 1 else "lattice.png")
print(f"{len(scene)} objects, {picture.samples:.1f} samples a pixel, estimated rms error {picture.error}")
