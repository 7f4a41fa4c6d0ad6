// What the include files give, as text: the same from povtrace's own files and from POV-Ray's.
#include "colors.inc"
#include "consts.inc"
#include "finish.inc"
#include "functions.inc"
#include "math.inc"
#include "rand.inc"
#include "shapes.inc"
#include "strings.inc"
#include "transforms.inc"

#macro Number(V) #debug concat("= ", str(V, 0, 5), "\n") #end
#macro Vector(V)
    #local W = <0, 0, 0> + V;
    #debug concat("= ", vstr(3, W, " ", 0, 5), "\n")
#end
#macro Components(V)
    #debug concat("= ", str(V.red, 0, 5), " ", str(V.green, 0, 5), " ", str(V.blue, 0, 5), " ", str(V.filter, 0, 5), " ",
                  str(V.transmit, 0, 5), "\n")
#end
#macro String(V) #debug concat("= ", V, "\n") #end
#macro Moves(V)
    #ifdef (Moved) #undef Moved #end
    #declare Moved = function { transform { V } }
    #debug concat("= ", vstr(3, Moved(0, 0, 0), " ", 0, 5), "; ", vstr(3, Moved(1, 0, 0), " ", 0, 5), "; ",
                  vstr(3, Moved(0, 1, 0), " ", 0, 5), "; ", vstr(3, Moved(0, 0, 1), " ", 0, 5), "\n")
#end
// Which of some points lie inside.
#macro Solid(V)
    #local S = seed(7);
    #local Text = "";
    #local I = 0;
    #while (I < 500)
        #local Text = concat(Text, str(inside(V, <rand(S), rand(S), rand(S)> * 7 - 3.5), 0, 0));
        #local I = I + 1;
    #end
    #debug concat("= ", Text, "\n")
#end

#declare ObA = box { <-1, -2, -.5>, <2, 1, 3> }
#declare TrA = transform { rotate <10, 20, 30> scale <1, 2, .5> translate <1, 2, 3> }
#declare Ga = function { x * x * 0.5 + sin(y) * z }
#declare Gb = function { x * y - z * z }
#declare Gc = function { exp(-x * x) + y * z }
#declare ArA = array[6] { 1, 2.5, -3, 4, .5, 2 }
#declare SplA = spline { cubic_spline -1, <0, 0, 0> 0, <1, 2, 3> 1, <4, 0, -1> 2, <5, 5, 5> }
#declare PgA = pigment { gradient x color_map { [0 rgb <.1, .2, .3>] [1 rgbft <.9, .5, .2, .1, .4>] } }

// ---- functions.inc ----

#declare Five = color eval_pigment(PgA, <1.795,-1.045,-1.557>);
Components(Five)
#declare Five = color eval_pigment(PgA, <1.935,-2.31,-0.143>);
Components(Five)
#declare Five = color eval_pigment(PgA, <0.347,0.668,-2.127>);
Components(Five)

// ---- math.inc ----

Number(Mean(ArA))
Number(Std_Dev(ArA, 0.229))
Number(Std_Dev(ArA, 2.518))
Number(Std_Dev(ArA, 2.946))
Number(Interpolate(0.538, -0.447, 1.445, -0.446, 2.656, 0))
Number(Interpolate(0.351, -0.235, 1.828, -0.456, 2.212, 2))
Number(Interpolate(0.946, -0.235, 1.219, -1.055, 3.214, -1))
Vector(VSqr(<2.75,-1.6,0.009>))
Vector(VSqr(<-0.725,2.889,1.272>))
Vector(VSqr(<0.607,-0.063,-1.393>))
Vector(VPow(<2.147,2.351,0.743>, 2.536))
Vector(VPow(<1.399,0.903,2.62>, 2.654))
Vector(VPow(<2.602,1.106,2.759>, 2.395))
#declare Five = color VPow5D(<0.587,0.639,0.823,0.271,0.161>, 2.916);
Components(Five)
#declare Five = color VPow5D(<0.06,0.516,0.624,0.955,0.087>, 2.196);
Components(Five)
#declare Five = color VPow5D(<0.079,0.454,0.62,0.849,0.047>, 2.321);
Components(Five)
Number(VEq(<0.866,-1.852,0.004>, <1.71,-1.721,-0.872>))
Number(VEq(<-1.646,-2.051,1.021>, <1.988,0.161,-0.318>))
Number(VEq(<-1.185,-1.564,2.654>, <-0.121,1.091,-1.326>))
Number(VEq5D(<0.256,0.789,0.173,0.426,0.024>, <0.588,0.51,0.432,0.2,0.638>))
Number(VEq5D(<0.036,0.933,0.483,0.611,0.424>, <0.022,0.03,0.726,0.487,0.278>))
Number(VEq5D(<0.538,0.871,0.51,0.518,0.584>, <0.874,0.032,0.663,0.576,0.716>))
Number(VZero(<-0.796,2.77,-1.9>))
Number(VZero(<1.573,2.617,2.492>))
Number(VZero(<1.533,2.54,-2.312>))
Number(VZero5D(<0.803,0.129,0.92,0.812,0.834>))
Number(VZero5D(<0.919,0.218,0.594,0.905,0.543>))
Number(VZero5D(<0.681,0.105,0.668,0.026,0.513>))
Number(VLength5D(<0.001,0.777,0.794,0.268,0.295>))
Number(VLength5D(<0.912,0.232,0.901,0.824,0.409>))
Number(VLength5D(<0.457,0.404,0.36,0.704,0.679>))
#declare Five = color VNormalize5D(<0.641,0.556,0.161,0.22,0.391>);
Components(Five)
#declare Five = color VNormalize5D(<0.947,0.034,0.964,0.95,0.403>);
Components(Five)
#declare Five = color VNormalize5D(<0.625,0.303,0.042,0.02,0.731>);
Components(Five)
Number(VDot5D(<0.809,0.187,0.791,0.551,0.83>, <0.807,0.503,0.721,0.135,0.754>))
Number(VDot5D(<0.212,0.559,0.166,0.948,0.401>, <0.656,0.508,0.69,0.195,0.773>))
Number(VDot5D(<0.389,0.642,0.932,0.657,0.755>, <0.489,0.472,0.913,0.471,0.039>))
Number(VCos_Angle(<1.575,-2.993,-1.942>, <2.254,-2.745,2.214>))
Number(VCos_Angle(<-2.03,-0.705,-1.205>, <0.91,0.794,-1.979>))
Number(VCos_Angle(<-1.429,-0.064,2.473>, <-0.127,0.9,1.837>))
Number(VAngle(<-1.926,2.135,-2.885>, <1.872,-0.999,1.615>))
Number(VAngle(<-0.199,2.49,-0.673>, <-2.014,-0.809,0.563>))
Number(VAngle(<-2.116,0.846,2.038>, <-2.968,2.876,-0.981>))
Number(VAngleD(<-2.572,2.341,-2.499>, <1.133,1.708,2.836>))
Number(VAngleD(<-1.312,0.009,-2.363>, <1.219,2.779,2.598>))
Number(VAngleD(<-2.913,-2.256,2.964>, <2.593,1.438,1.6>))
Number(VRotation(<-1.896,1.987,-0.6>, <2.235,0.841,2.825>, <-1.984,-1.504,0.631>))
Number(VRotation(<-1.553,0.368,-1.479>, <1.025,1.76,2.468>, <1.301,-1.843,-1.49>))
Number(VRotation(<2.484,0.887,-2.32>, <1.004,-1.251,1.528>, <-2.574,2.019,-1.224>))
Number(VRotationD(<-1.377,-1.302,2.07>, <-0.27,-0.593,0.451>, <1.442,-2.945,2.903>))
Number(VRotationD(<-0.265,-2.993,0.51>, <-0.406,-0.815,0.398>, <-2.477,0.909,-1.091>))
Number(VRotationD(<1.23,-1.339,-1.089>, <2.965,1.94,0.736>, <-0.885,-2.161,0.573>))
Number(VDist(<-2.832,1.952,1.26>, <-2.931,-0.797,0.583>))
Number(VDist(<-1.132,-0.483,-2.067>, <1.611,-1.338,2.393>))
Number(VDist(<-0.524,2.646,-2.584>, <-1.651,1.589,-1.761>))
Vector(VPerp_To_Vector(<-2.491,-1.492,-1.927>))
Vector(VPerp_To_Vector(<0.77,-0.892,1.559>))
Vector(VPerp_To_Vector(<0.392,0.53,-2.127>))
Vector(VPerp_To_Plane(<-2.506,-1.459,-0.47>, <2.26,2.852,-2.689>))
Vector(VPerp_To_Plane(<1.987,-1.61,0.18>, <1.788,-0.446,1.329>))
Vector(VPerp_To_Plane(<1.518,-1.187,-1.521>, <2.86,1.051,-1.633>))
Vector(VPerp_Adjust(<1.935,-0.672,-2.284>, <-1.245,-2.343,-1.096>))
Vector(VPerp_Adjust(<-1.501,-0.905,-2.274>, <2.73,-2.425,-1.046>))
Vector(VPerp_Adjust(<2.392,0.297,-0.083>, <1.32,2.773,-1.232>))
Vector(VProject_Plane(<0.934,0.283,2.612>, <-0.242,-1.205,-1.746>))
Vector(VProject_Plane(<-1.154,0.517,0.195>, <-0.773,0.525,1.837>))
Vector(VProject_Plane(<2.376,2.913,-1.441>, <2.231,-1.373,-0.13>))
Vector(VProject_Axis(<-1.704,-2.149,2.048>, <-0.814,-2.962,-0.184>))
Vector(VProject_Axis(<1.265,1.232,1.184>, <2.505,1.013,1.216>))
Vector(VProject_Axis(<2.809,1.911,-1.745>, <-2.639,1.295,0.169>))
Number(VMin(<-2.052,-1.136,0.892>))
Number(VMin(<-0.969,1.641,-0.113>))
Number(VMin(<-1.184,-2.271,-2.864>))
Number(VMax(<1.905,-2.78,-1.075>))
Number(VMax(<1.026,-1.086,-1.387>))
Number(VMax(<-1.763,1.178,0.555>))
Vector(VWith_Len(<0.794,2.49,-1.435>, 0.872))
Vector(VWith_Len(<0.663,2.199,-0.196>, 0.887))
Vector(VWith_Len(<-0.4,1.009,1.577>, 2.262))
Vector(vGradient(Ga, <2.584,-2.207,0.488>))
Vector(vGradient(Gc, <-2.169,-0.267,-0.696>))
Vector(vGradient(Ga, <1.507,1.105,2.112>))
Vector(vCurl(Ga, Gc, Ga, <1.907,0.502,-1.812>))
Vector(vCurl(Gb, Ga, Gb, <0.57,-1.092,2.066>))
Vector(vCurl(Gc, Ga, Gb, <-0.629,2.653,2.394>))
Number(Divergence(Ga, Ga, Gc, <-0.585,-2.344,-2.954>))
Number(Divergence(Gc, Gc, Gc, <1.061,1.351,2.186>))
Number(Divergence(Ga, Ga, Gb, <0.278,-2.047,1.263>))
Number(Gradient_Length(Gb, <-2.082,1.49,-0.946>))
Number(Gradient_Length(Ga, <1.172,-1.699,2.123>))
Number(Gradient_Length(Ga, <1.366,-0.737,1.087>))
Number(Gradient_Directional(Ga, <0.084,1.821,0.914>, <-2.534,-0.246,0.634>))
Number(Gradient_Directional(Ga, <1.081,-2.479,2.321>, <-0.942,0.646,-0.756>))
Number(Gradient_Directional(Ga, <-1.373,-0.822,1.442>, <1.62,1.799,-0.571>))

// ---- shapes.inc ----

#declare Ob = object { Center_Object(ObA, x+y) }
Solid(Ob)
#declare Ob = object { Center_Object(ObA, x+y+z) }
Solid(Ob)
#declare Ob = object { Center_Object(ObA, z) }
Solid(Ob)
#declare Ob = object { Align_Object(ObA, x-y, <1.372,-2.337,0.266>) }
Solid(Ob)
#declare Ob = object { Align_Object(ObA, y, <-0.475,-2.456,-1.394>) }
Solid(Ob)
#declare Ob = object { Align_Object(ObA, -y, <0.39,-2.099,2.207>) }
Solid(Ob)
#declare Ob = object { Wedge(283.178) }
Solid(Ob)
#declare Ob = object { Wedge(159.855) }
Solid(Ob)
#declare Ob = object { Wedge(222.631) }
Solid(Ob)
#declare Ob = object { Spheroid(<-0.791,1.107,0.506>, <2.222,2.934,1.272>) }
Solid(Ob)
#declare Ob = object { Spheroid(<0.538,1.689,0.61>, <1.999,1.577,2.879>) }
Solid(Ob)
#declare Ob = object { Spheroid(<2.439,0.115,0.983>, <2.374,2.974,1.947>) }
Solid(Ob)
#declare Ob = object { Connect_Spheres(<-0.798,-2.587,-1.517>, 0.351, <4.105,2.556,4.466>, 0.426) }
Solid(Ob)
#declare Ob = object { Connect_Spheres(<-2.226,-2.724,-1.685>, 0.58, <3.294,2.545,3.125>, 0.477) }
Solid(Ob)
#declare Ob = object { Connect_Spheres(<-0.307,-0.04,-2.587>, 0.364, <2.49,4.761,2.969>, 0.469) }
Solid(Ob)
#declare Ob = object { Wire_Box_Union(<-1.561,-1.476,-2.06>, <1.577,2.651,1.102>, 0.198) }
Solid(Ob)
#declare Ob = object { Wire_Box_Union(<-2.625,-1.676,-2.119>, <2.47,1.754,2.552>, 0.287) }
Solid(Ob)
#declare Ob = object { Wire_Box_Union(<-1.647,-1.298,-1.999>, <2.235,2.725,2.514>, 0.273) }
Solid(Ob)
#declare Ob = object { Wire_Box_Merge(<-2.808,-2.204,-2.536>, <2.771,1.907,1.069>, 0.24) }
Solid(Ob)
#declare Ob = object { Wire_Box_Merge(<-2.812,-1.188,-2.896>, <1.8,1.852,1.682>, 0.125) }
Solid(Ob)
#declare Ob = object { Wire_Box_Merge(<-2.318,-1.347,-1.555>, <1.956,2.625,1.421>, 0.213) }
Solid(Ob)
#declare Ob = object { Wire_Box(<-1.138,-1.219,-2.829>, <1.991,1.994,1.679>, 0.195, 1) }
Solid(Ob)
#declare Ob = object { Wire_Box(<-2.801,-2.158,-2.329>, <2.519,2.85,2.174>, 0.162, 1) }
Solid(Ob)
#declare Ob = object { Wire_Box(<-2.054,-2.209,-1.249>, <1.379,2.436,2.489>, 0.208, 0) }
Solid(Ob)
#declare Ob = object { Round_Box_Union(<-2.505,-2.012,-2.348>, <1.88,1.955,2.285>, 0.282) }
Solid(Ob)
#declare Ob = object { Round_Box_Union(<-2.463,-1.764,-2.459>, <1.516,2.341,2.243>, 0.245) }
Solid(Ob)
#declare Ob = object { Round_Box_Union(<-1.252,-1.503,-2.857>, <1.944,2.291,2.355>, 0.319) }
Solid(Ob)
#declare Ob = object { Round_Box_Merge(<-1.693,-1.815,-2.147>, <1.145,2.413,2.778>, 0.179) }
Solid(Ob)
#declare Ob = object { Round_Box_Merge(<-2.528,-1.066,-1.798>, <1.802,1.223,2.557>, 0.372) }
Solid(Ob)
#declare Ob = object { Round_Box_Merge(<-2.429,-2.914,-2.369>, <2.246,2.233,1.582>, 0.352) }
Solid(Ob)
#declare Ob = object { Round_Box(<-1.007,-1.439,-1.556>, <2.072,2.935,2.627>, 0.243, 0) }
Solid(Ob)
#declare Ob = object { Round_Box(<-2.881,-2.405,-1.396>, <1.062,1.604,1.144>, 0.352, 1) }
Solid(Ob)
#declare Ob = object { Round_Box(<-2.136,-1.813,-2.505>, <1.082,2.396,1.168>, 0.15, 0) }
Solid(Ob)
#declare Ob = object { Round_Cylinder_Union(<-1.315,-2.623,-1.52>, <1.327,2.236,1.398>, 1.222, 0.197) }
Solid(Ob)
#declare Ob = object { Round_Cylinder_Union(<-2.218,-2.782,-2.316>, <2.044,2.761,2.953>, 1, 0.308) }
Solid(Ob)
#declare Ob = object { Round_Cylinder_Union(<-1.695,-2.57,-1.546>, <1.437,2.564,1.161>, 1.324, 0.156) }
Solid(Ob)
#declare Ob = object { Round_Cylinder_Merge(<-2.172,-1.776,-1.633>, <2.382,1.083,1.315>, 1.062, 0.379) }
Solid(Ob)
#declare Ob = object { Round_Cylinder_Merge(<-2.019,-2.426,-2.976>, <2.821,2.446,2.732>, 1.122, 0.177) }
Solid(Ob)
#declare Ob = object { Round_Cylinder_Merge(<-2.753,-1.517,-2.776>, <1.552,2.383,1.407>, 0.957, 0.232) }
Solid(Ob)
#declare Ob = object { Round_Cylinder(<-2.857,-2.323,-2.657>, <1.623,1.393,2.813>, 1.191, 0.278, 0) }
Solid(Ob)
#declare Ob = object { Round_Cylinder(<-2.208,-2.375,-1.138>, <1.714,2.46,1.836>, 0.895, 0.391, 0) }
Solid(Ob)
#declare Ob = object { Round_Cylinder(<-1.779,-2.18,-2.856>, <2.083,1.466,1.215>, 1.383, 0.352, 0) }
Solid(Ob)
#declare Ob = object { Round_Cone_Union(<-1.766,-2.264,-2.178>, 0.974, <2.109,1.016,2.683>, 0.749, 0.159) }
Solid(Ob)
#declare Ob = object { Round_Cone_Union(<-1.992,-1.019,-1.244>, 1.126, <1.428,1.131,2.341>, 0.865, 0.217) }
Solid(Ob)
#declare Ob = object { Round_Cone_Union(<-2.107,-1.293,-2.061>, 1.299, <1.847,1.482,1.631>, 0.596, 0.114) }
Solid(Ob)
#declare Ob = object { Round_Cone_Merge(<-1.068,-2.424,-1.5>, 1.342, <1.427,1.256,2.86>, 0.549, 0.143) }
Solid(Ob)
#declare Ob = object { Round_Cone_Merge(<-1.855,-1.711,-2.308>, 1.244, <2.602,1.793,1.391>, 0.604, 0.219) }
Solid(Ob)
#declare Ob = object { Round_Cone_Merge(<-2.534,-2.06,-1.442>, 1.335, <2.529,1.967,1.219>, 0.804, 0.137) }
Solid(Ob)
#declare Ob = object { Round_Cone(<-2.393,-2.394,-2.679>, 1.39, <2.162,1.68,1.028>, 0.516, 0.157, 1) }
Solid(Ob)
#declare Ob = object { Round_Cone(<-2.544,-1.346,-2.566>, 1.107, <2.127,1.273,1.197>, 0.86, 0.268, 1) }
Solid(Ob)
#declare Ob = object { Round_Cone(<-2.552,-2.018,-2.045>, 1.281, <2.092,2.557,1.712>, 0.566, 0.227, 0) }
Solid(Ob)
#declare Ob = object { Round_Cone2_Union(<-1.759,-2.763,-2.959>, 1.269, <2.591,2.517,1.071>, 0.605) }
Solid(Ob)
#declare Ob = object { Round_Cone2_Union(<-1.288,-2.093,-2.909>, 1.054, <2.999,2.087,1.645>, 0.581) }
Solid(Ob)
#declare Ob = object { Round_Cone2_Union(<-1.805,-1.605,-1.068>, 0.813, <1.78,1.792,1.718>, 0.666) }
Solid(Ob)
#declare Ob = object { Round_Cone2_Merge(<-1.171,-2.829,-1.614>, 1.302, <2.751,2.639,2.908>, 0.843) }
Solid(Ob)
#declare Ob = object { Round_Cone2_Merge(<-2.738,-2.215,-2.42>, 0.906, <2.27,1.759,2.446>, 0.587) }
Solid(Ob)
#declare Ob = object { Round_Cone2_Merge(<-1.854,-2.887,-2.923>, 0.878, <1.632,2.566,1.425>, 0.607) }
Solid(Ob)
#declare Ob = object { Round_Cone2(<-1.566,-2.418,-1.193>, 1.2, <1.907,2.199,1.481>, 0.681, 0) }
Solid(Ob)
#declare Ob = object { Round_Cone2(<-2.102,-2.607,-2.172>, 1.279, <1.309,2.492,2.709>, 0.625, 0) }
Solid(Ob)
#declare Ob = object { Round_Cone2(<-2.619,-1.714,-1.316>, 0.957, <2.034,1.167,2.997>, 0.573, 1) }
Solid(Ob)
#declare Ob = object { Round_Cone3_Union(<-1.444,-1.1,-2.251>, 1.009, <1.949,1.711,1.81>, 0.718) }
Solid(Ob)
#declare Ob = object { Round_Cone3_Union(<-1.7,-2.077,-2.709>, 1.275, <1.641,1.577,1.075>, 0.546) }
Solid(Ob)
#declare Ob = object { Round_Cone3_Union(<-1.848,-2.567,-2.458>, 0.831, <1.686,2.67,2.358>, 0.89) }
Solid(Ob)
#declare Ob = object { Round_Cone3_Merge(<-1.881,-1.614,-2.451>, 1.19, <1.706,1.085,1.75>, 0.745) }
Solid(Ob)
#declare Ob = object { Round_Cone3_Merge(<-2.868,-1.572,-1.27>, 1.09, <2.886,1.926,1.27>, 0.617) }
Solid(Ob)
#declare Ob = object { Round_Cone3_Merge(<-1.185,-1.773,-2.338>, 1.23, <2.394,1.209,1.941>, 0.652) }
Solid(Ob)
#declare Ob = object { Round_Cone3(<-2.431,-1.358,-1.557>, 1.384, <2.356,1.902,1.024>, 0.847, 0) }
Solid(Ob)
#declare Ob = object { Round_Cone3(<-1.834,-2.877,-2.462>, 1.309, <2.39,1.006,2.757>, 0.658, 1) }
Solid(Ob)
#declare Ob = object { Round_Cone3(<-2.308,-2.545,-2.486>, 1.268, <1.998,2.559,2.34>, 0.817, 0) }
Solid(Ob)

// ---- transforms.inc ----

#declare Tr = transform { Shear_Trans(<-0.727,-1.49,1.784>, <2.813,-2.879,0.782>, <0.31,-1.399,2.08>) }
Moves(Tr)
#declare Tr = transform { Shear_Trans(<-0.713,-1.678,0.413>, <-2.323,1.554,2.419>, <0.158,2.735,0.306>) }
Moves(Tr)
#declare Tr = transform { Shear_Trans(<-1.922,-2.187,0.046>, <2.723,-0.56,-1.379>, <2.475,0.26,0.544>) }
Moves(Tr)
#declare Tr = transform { Matrix_Trans(<-2.136,-0.893,1.692>, <1.511,0.729,-2.451>, <0.462,-2.833,1.443>, <-0.309,-1.883,-1.311>) }
Moves(Tr)
#declare Tr = transform { Matrix_Trans(<-0.283,2.016,2.923>, <-2.922,2.247,-0.957>, <-0.466,2.175,-1.979>, <2.738,-2.77,-1.814>) }
Moves(Tr)
#declare Tr = transform { Matrix_Trans(<-0.561,-1.446,2.13>, <1.944,-1.913,0.306>, <-1.951,2.624,-0.528>, <-1.374,0.168,2.278>) }
Moves(Tr)
#declare Tr = transform { Axial_Scale_Trans(<2.419,0.001,-2.917>, 1.289) }
Moves(Tr)
#declare Tr = transform { Axial_Scale_Trans(<-2.235,-2.373,2.721>, 0.62) }
Moves(Tr)
#declare Tr = transform { Axial_Scale_Trans(<0.38,-2.299,2.013>, 1.181) }
Moves(Tr)
#declare Tr = transform { Axis_Rotate_Trans(<-0.2,0.298,1.312>, -173.639) }
Moves(Tr)
#declare Tr = transform { Axis_Rotate_Trans(<2.314,-0.925,1.758>, 10.893) }
Moves(Tr)
#declare Tr = transform { Axis_Rotate_Trans(<-2.55,-1.802,-1.552>, -25.862) }
Moves(Tr)
#declare Tr = transform { Rotate_Around_Trans(<-82.639,-12.161,-78.249>, <-2.115,2.216,-0.479>) }
Moves(Tr)
#declare Tr = transform { Rotate_Around_Trans(<-50.348,77.329,60.863>, <-2.669,2.767,2.705>) }
Moves(Tr)
#declare Tr = transform { Rotate_Around_Trans(<-30.991,46.102,87.841>, <2.506,-1.957,-0.026>) }
Moves(Tr)
#declare Tr = transform { Reorient_Trans(<0.035,0.426,2.783>, <0.928,0.349,-2.589>) }
Moves(Tr)
#declare Tr = transform { Reorient_Trans(<1.22,-2.881,-2.704>, <-0.947,-1.197,-0.15>) }
Moves(Tr)
#declare Tr = transform { Reorient_Trans(<-0.633,-0.424,-2.24>, <-2.238,-2.034,1.572>) }
Moves(Tr)
#declare Tr = transform { Point_At_Trans(<1.002,-1.047,2.081>) }
Moves(Tr)
#declare Tr = transform { Point_At_Trans(<-2.594,0.091,0.816>) }
Moves(Tr)
#declare Tr = transform { Point_At_Trans(<1.58,1.98,0.595>) }
Moves(Tr)
#declare Tr = transform { Center_Trans(ObA, y) }
Moves(Tr)
#declare Tr = transform { Center_Trans(ObA, x) }
Moves(Tr)
#declare Tr = transform { Center_Trans(ObA, x+y) }
Moves(Tr)
#declare Tr = transform { Align_Trans(ObA, x, <1.311,-0.538,1.586>) }
Moves(Tr)
#declare Tr = transform { Align_Trans(ObA, -z, <2.754,0.669,2.94>) }
Moves(Tr)
#declare Tr = transform { Align_Trans(ObA, y, <-2.475,2.408,-2.452>) }
Moves(Tr)
#declare Tr = transform { Spline_Trans(SplA, 0.422, y, 0.082, 0.727) }
Moves(Tr)
#declare Tr = transform { Spline_Trans(SplA, 0.142, y, 0.039, 0.618) }
Moves(Tr)
#declare Tr = transform { Spline_Trans(SplA, 0.646, y, 0.158, 0.377) }
Moves(Tr)
Vector(vtransform(<0.342,-1.463,-2.325>, TrA))
Vector(vtransform(<-0.29,-1.146,-1.077>, TrA))
Vector(vtransform(<-2.481,-1.388,-0.891>, TrA))
Vector(vinv_transform(<-1.623,-0.62,-2.049>, TrA))
Vector(vinv_transform(<-1.142,-1.261,0.026>, TrA))
Vector(vinv_transform(<-2.251,0.822,-1.124>, TrA))

// ---- rand.inc ----

#declare Sx = seed(1);
Number(Prob(0.904, Sx))
#declare Sx = seed(2);
Number(Prob(0.779, Sx))
#declare Sx = seed(3);
Number(Prob(0.211, Sx))
#declare Sx = seed(1);
Number(Rand_Cauchy(-0.827, 2.571, Sx))
#declare Sx = seed(2);
Number(Rand_Cauchy(0.271, 0.721, Sx))
#declare Sx = seed(3);
Number(Rand_Cauchy(-0.677, 2.209, Sx))
#declare Sx = seed(1);
Number(Rand_Normal(-0.991, 2.19, Sx))
#declare Sx = seed(2);
Number(Rand_Normal(-0.287, 0.955, Sx))
#declare Sx = seed(3);
Number(Rand_Normal(-0.81, 0.48, Sx))
#declare Sx = seed(1);
Number(Rand_Gauss(-0.122, 2.655, Sx))
#declare Sx = seed(2);
Number(Rand_Gauss(0.959, 2.246, Sx))
#declare Sx = seed(3);
Number(Rand_Gauss(-0.269, 0.277, Sx))
#declare Sx = seed(1);
Number(Rand_Gamma(2.179, 2.79, Sx))
#declare Sx = seed(2);
Number(Rand_Gamma(2.121, 1.115, Sx))
#declare Sx = seed(3);
Number(Rand_Gamma(1.444, 0.958, Sx))
#declare Sx = seed(1);
Number(Rand_Beta(1.99, 1.575, Sx))
#declare Sx = seed(2);
Number(Rand_Beta(2.67, 2.826, Sx))
#declare Sx = seed(3);
Number(Rand_Beta(1.818, 2.378, Sx))
#declare Sx = seed(1);
Number(Rand_Triangle(-1.572, 2.246, 1, Sx))
#declare Sx = seed(2);
Number(Rand_Triangle(-1.505, 2.66, 0.122, Sx))
#declare Sx = seed(3);
Number(Rand_Triangle(-1.519, 2.63, -0.729, Sx))
#declare Sx = seed(1);
Number(Rand_Chi_Square(3, Sx))
#declare Sx = seed(2);
Number(Rand_Chi_Square(8, Sx))
#declare Sx = seed(3);
Number(Rand_Student(5, Sx))
#declare Sx = seed(4);
Number(Rand_Student(2, Sx))
#declare Sx = seed(5);
Number(Rand_F_Dist(3, 4, Sx))
#declare Sx = seed(6);
Number(Rand_F_Dist(7, 2, Sx))
#declare Sx = seed(1);
Number(Rand_Erlang(0.303, 3, Sx))
#declare Sx = seed(2);
Number(Rand_Erlang(0.292, 5, Sx))
#declare Sx = seed(3);
Number(Rand_Erlang(2.71, 2, Sx))
#declare Sx = seed(1);
Number(Rand_Exp(0.718, Sx))
#declare Sx = seed(2);
Number(Rand_Exp(2.058, Sx))
#declare Sx = seed(3);
Number(Rand_Exp(0.372, Sx))
#declare Sx = seed(1);
Number(Rand_Lognormal(-0.777, 0.423, Sx))
#declare Sx = seed(2);
Number(Rand_Lognormal(0.493, 0.39, Sx))
#declare Sx = seed(3);
Number(Rand_Lognormal(-0.116, 0.645, Sx))
#declare Sx = seed(1);
Number(Rand_Pareto(2.888, Sx))
#declare Sx = seed(2);
Number(Rand_Pareto(1.403, Sx))
#declare Sx = seed(3);
Number(Rand_Pareto(0.804, Sx))
#declare Sx = seed(1);
Number(Rand_Weibull(0.967, 2.618, Sx))
#declare Sx = seed(2);
Number(Rand_Weibull(1.167, 1.654, Sx))
#declare Sx = seed(3);
Number(Rand_Weibull(0.832, 2.55, Sx))
#declare Sx = seed(1);
Number(Rand_Bernoulli(0.819, Sx))
#declare Sx = seed(2);
Number(Rand_Bernoulli(0.522, Sx))
#declare Sx = seed(3);
Number(Rand_Bernoulli(0.352, Sx))
#declare Sx = seed(1);
Number(Rand_Binomial(3, 0.857, Sx))
#declare Sx = seed(2);
Number(Rand_Binomial(3, 0.302, Sx))
#declare Sx = seed(3);
Number(Rand_Binomial(4, 0.373, Sx))
#declare Sx = seed(1);
Number(Rand_Geo(0.698, Sx))
#declare Sx = seed(2);
Number(Rand_Geo(0.503, Sx))
#declare Sx = seed(3);
Number(Rand_Geo(0.693, Sx))
#declare Sx = seed(1);
Number(Rand_Poisson(4.146, Sx))
#declare Sx = seed(2);
Number(Rand_Poisson(3.161, Sx))
#declare Sx = seed(3);
Number(Rand_Poisson(4.47, Sx))
#declare Sx = seed(1);
Number(SRand(Sx))
#declare Sx = seed(2);
Number(SRand(Sx))
#declare Sx = seed(3);
Number(SRand(Sx))
#declare Sx = seed(1);
Number(RRand(-1.281, 1.81, Sx))
#declare Sx = seed(2);
Number(RRand(-0.797, 0.643, Sx))
#declare Sx = seed(3);
Number(RRand(-2.964, 4.316, Sx))
#declare Sx = seed(1);
Vector(VRand(Sx))
#declare Sx = seed(2);
Vector(VRand(Sx))
#declare Sx = seed(3);
Vector(VRand(Sx))
#declare Sx = seed(1);
Vector(VRand_In_Box(<-2.114,-1.825,-0.467>, <1.934,1.456,1.43>, Sx))
#declare Sx = seed(2);
Vector(VRand_In_Box(<-2.488,-1.34,-0.769>, <1.467,0.07,1.041>, Sx))
#declare Sx = seed(3);
Vector(VRand_In_Box(<-0.588,-2.558,-0.687>, <1.2,2.45,2.882>, Sx))
#declare Sx = seed(1);
Vector(VRand_In_Sphere(Sx))
#declare Sx = seed(2);
Vector(VRand_In_Sphere(Sx))
#declare Sx = seed(3);
Vector(VRand_In_Sphere(Sx))
#declare Sx = seed(1);
Vector(VRand_On_Sphere(Sx))
#declare Sx = seed(2);
Vector(VRand_On_Sphere(Sx))
#declare Sx = seed(3);
Vector(VRand_On_Sphere(Sx))
#declare Sx = seed(1);
Vector(VRand_In_Obj(ObA, Sx))
#declare Sx = seed(2);
Vector(VRand_In_Obj(ObA, Sx))
#declare Sx = seed(3);
Vector(VRand_In_Obj(ObA, Sx))

// ---- strings.inc ----

String(CRGBFTStr(rgbft <0.676,0.066,0.222,0.534,0.048>, 1, 1))
String(CRGBFTStr(rgbft <0.727,0.536,0.832,0.907,0.338>, 4, 3))
String(CRGBFTStr(rgbft <0.897,0.703,0.385,0.866,0.027>, 0, 4))
String(CRGBStr(rgb <0.451,0.917,0.216>, 3, 1))
String(CRGBStr(rgb <0.638,0.429,0.672>, 4, 0))
String(CRGBStr(rgb <0.3,0.841,0.322>, 0, 2))
String(Str(-13.528))
String(Str(-74.377))
String(Str(11.278))
String(VStr2D(<1.263,-0.037>))
String(VStr2D(<-0.212,1.573>))
String(VStr2D(<2.792,-1.921>))
String(VStr(<-1.054,-0.029,2.375>))
String(VStr(<1.058,-2.023,-0.029>))
String(VStr(<2.355,1.614,-1.625>))
String(Vstr2D(<-0.799,-2.36>, 2, 3))
String(Vstr2D(<0.086,-2.855>, 3, 1))
String(Vstr2D(<0.541,0.044>, 2, 4))
String(Vstr(<-1.646,-1.688,2.209>, 5, 1))
String(Vstr(<-0.303,-1.804,-1.323>, 6, 1))
String(Vstr(<-1.371,-2.531,-2.995>, 6, 0))
String(Triangle_Str(<-2.304,-0.422,0.641>, <-2.109,-0.096,-1.302>, <1.804,2.452,0.158>))
String(Triangle_Str(<1.421,-2.286,-1.959>, <0.474,-2.534,-2.024>, <2.381,1.835,-1.108>))
String(Triangle_Str(<2.399,1.491,-2.531>, <0.442,0.208,2.306>, <-2.716,-2.451,-0.259>))
String(Smooth_Triangle_Str(<1.43,1.96,-2.473>, <1.769,1.019,-2.114>, <2.259,-1.56,-2.423>, <1.937,-2.532,2.402>, <-0.814,-2.918,1.727>, <1.574,-0.049,1.983>))
String(Smooth_Triangle_Str(<2.169,-1.179,-2.759>, <-2.614,1.9,-2.084>, <-0.746,-0.657,-1.594>, <-0.177,-2.474,1.726>, <-1.854,0.312,-2.336>, <-2.106,0.366,-2.21>))
String(Smooth_Triangle_Str(<-1.616,-1.765,-1.876>, <2.606,0.333,1.771>, <-0.064,1.448,1.212>, <2.828,-1.606,0.892>, <0.917,0.193,-2.807>, <-1.73,-2.57,-2.004>))

// ---- colors.inc ----

Vector(CH2RGB(-19.204))
Vector(CH2RGB(380.789))
Vector(CH2RGB(394.424))
Number(CRGB2H(<.2,.5,.9>, .9, .7))
Number(CRGB2H(<0.799,0.326,0.24>, 0.799, 0.559))
Number(CRGB2H(<0.823,0.115,0.476>, 0.823, 0.708))
#declare Five = color CHSL2RGB(<154.396,0.848,0.478,0.213,0.672>);
Components(Five)
#declare Five = color CHSL2RGB(<301.991,0.666,0.158,0.163,0.883>);
Components(Five)
#declare Five = color CHSL2RGB(<170.565,0.986,0.35,0.435,0.042>);
Components(Five)
#declare Five = color CRGB2HSL(rgbft <0.353,0.562,0.438,0.574,0.535>);
Components(Five)
#declare Five = color CRGB2HSL(rgbft <0.834,0.795,0.803,0.597,0.958>);
Components(Five)
#declare Five = color CRGB2HSL(rgbft <0.986,0.596,0.6,0.118,0.725>);
Components(Five)
#declare Five = color CHSV2RGB(<270.082,0.814,0.463,0.965,0.127>);
Components(Five)
#declare Five = color CHSV2RGB(<321.474,0.312,0.476,0.296,0.905>);
Components(Five)
#declare Five = color CHSV2RGB(<346.216,0.449,0.229,0.187,0.555>);
Components(Five)
#declare Five = color CRGB2HSV(rgbft <0.096,0.799,0.175,0.487,0.263>);
Components(Five)
#declare Five = color CRGB2HSV(rgbft <0,0.54,0.847,0.18,0.127>);
Components(Five)
#declare Five = color CRGB2HSV(rgbft <0.706,0.625,0.773,0.038,0.695>);
Components(Five)

// ---- functions of functions.inc ----

Number(f_snoise3d(0.7005, 1.3782, 1.6826))
Number(f_snoise3d(2.522, 1.3674, 2.4073))
Number(f_snoise3d(-2.6847, -0.196, 2.5271))
Number(f_agate(2.7498, 2.1227, -1.201))
Number(f_agate(2.6304, 0.2236, 1.0136))
Number(f_agate(-1.6828, 2.5136, 1.0867))
Number(f_boxed(1.4238, 1.9658, -2.747))
Number(f_boxed(1.6401, -0.7627, 0.4476))
Number(f_boxed(-2.7983, -2.5837, -1.8188))
Number(f_bozo(0.2573, -1.069, -1.0442))
Number(f_bozo(-1.8384, -2.4043, -2.0015))
Number(f_bozo(1.0783, 2.8313, -1.9293))
Number(f_brick(-1.9993, 1.965, -1.1696))
Number(f_brick(-0.267, 2.846, 2.0078))
Number(f_brick(2.7132, -0.2648, -0.0675))
Number(f_bumps(-0.7784, 1.1655, -1.2491))
Number(f_bumps(-0.0816, 1.5376, 1.088))
Number(f_bumps(-1.175, 2.5396, 0.8532))
Number(f_checker(-1.9028, 1.9187, 2.4931))
Number(f_checker(-0.1297, 1.0911, 1.2522))
Number(f_checker(1.313, -1.8706, 1.5981))
Number(f_crackle(-1.7478, -2.6468, -0.1976))
Number(f_crackle(-0.6823, 0.6372, 0.5139))
Number(f_crackle(-1.4943, 2.2981, -2.8462))
Number(f_cylindrical(2.6061, 2.6676, 0.6191))
Number(f_cylindrical(-0.8486, 2.2428, -2.8446))
Number(f_cylindrical(-2.2349, 0.3751, 0.6565))
Number(f_dents(-2.1552, 0.6936, -0.3222))
Number(f_dents(-1.1793, 1.6057, 1.8628))
Number(f_dents(-2.7747, 0.1856, -1.2894))
Number(f_gradientX(1.3966, 0.5176, -2.6424))
Number(f_gradientX(-1.4112, -0.253, 2.3745))
Number(f_gradientX(2.2113, 0.2599, -2.767))
Number(f_gradientY(-0.123, 0.2798, -0.0132))
Number(f_gradientY(-0.9648, -1.9749, 0.4894))
Number(f_gradientY(1.7774, -2.46, -1.5389))
Number(f_gradientZ(0.6977, -2.6017, -2.2332))
Number(f_gradientZ(-0.6886, -2.4396, -2.5219))
Number(f_gradientZ(0.429, 1.3813, 2.1572))
Number(f_granite(-1.5138, -0.7341, 1.3495))
Number(f_granite(-1.8279, 1.2158, 0.8836))
Number(f_granite(-2.3641, 0.9573, -2.3303))
Number(f_leopard(-1.9684, -1.9435, -0.7146))
Number(f_leopard(-0.6518, 2.168, -1.983))
Number(f_leopard(-1.4018, -1.2686, -1.9292))
Number(f_mandel(-0.5639, 2.6995, -0.7738))
Number(f_mandel(-1.0725, -0.1822, -1.2361))
Number(f_mandel(1.3244, 1.2422, -1.9189))
Number(f_marble(-1.4623, -2.5624, -0.5853))
Number(f_marble(-2.5072, -1.394, -0.5274))
Number(f_marble(-1.1061, -2.5574, -2.6357))
Number(f_onion(-1.0966, -0.2905, 1.8606))
Number(f_onion(-1.5734, -2.1906, -1.0732))
Number(f_onion(-2.3505, 1.5527, 1.8208))
Number(f_planar(1.4804, 0.426, -0.3296))
Number(f_planar(1.8058, 0.8861, 2.5922))
Number(f_planar(1.2997, 1.1467, -1.3241))
Number(f_radial(-0.9669, -2.7791, 0.4812))
Number(f_radial(1.8635, 1.2929, -2.3068))
Number(f_radial(0.1728, -1.8742, 1.1938))
Number(f_ripples(-0.1026, 2.1762, -0.6115))
Number(f_ripples(-1.621, -1.2708, -1.7034))
Number(f_ripples(0.3559, -0.8152, 1.4312))
Number(f_spherical(0.7017, 1.7121, -0.7043))
Number(f_spherical(-2.7925, 0.0669, 0.4941))
Number(f_spherical(-1.797, -0.6322, -1.0417))
Number(f_spiral1(0.4583, 1.4798, 1.2224))
Number(f_spiral1(-1.1013, 2.4464, -1.2848))
Number(f_spiral1(1.2316, -2.4394, 1.4443))
Number(f_spiral2(-0.646, -2.2292, 1.0761))
Number(f_spiral2(0.3045, 1.227, -0.7181))
Number(f_spiral2(2.2046, -1.6376, -1.1082))
Number(f_spotted(-2.6763, -2.1911, 0.3567))
Number(f_spotted(0.5897, -1.8019, -1.7654))
Number(f_spotted(0.5388, 0.8342, 1.0843))
Number(f_waves(1.3464, 1.8033, 1.7312))
Number(f_waves(1.2147, 2.4173, 2.6043))
Number(f_waves(0.7131, 2.651, -2.2611))
Number(f_wood(-1.1632, -2.184, -0.1196))
Number(f_wood(-0.8314, 1.3527, 2.3848))
Number(f_wood(-0.6721, -1.1936, -0.0071))
Number(f_wrinkles(1.7714, -2.8208, 1.5157))
Number(f_wrinkles(-0.7921, -2.7565, -1.4201))
Number(f_wrinkles(-0.2381, -0.6679, 0.0956))
Number(f_sine_wave(-0.4944, 2.133, 1.8564))
Number(f_sine_wave(2.3675, -0.6923, 2.8446))
Number(f_sine_wave(1.4606, 2.2331, -2.0052))
Number(f_scallop_wave(0.5638, -2.0729, -1.5016))
Number(f_scallop_wave(2.395, 2.4941, -2.6727))
Number(f_scallop_wave(-1.7966, -0.4046, -1.3298))

// ---- functions of math.inc ----

Number(sind(-0.1074))
Number(sind(1.1728))
Number(sind(-2.8036))
Number(cosd(-2.6317))
Number(cosd(-0.6527))
Number(cosd(-0.8792))
Number(tand(1.2151))
Number(tand(2.4926))
Number(tand(2.563))
Number(asind(0.0546))
Number(asind(-0.2114))
Number(asind(0.8066))
Number(acosd(-0.556))
Number(acosd(-0.0875))
Number(acosd(-0.8363))
Number(atand(1.3746))
Number(atand(-1.356))
Number(atand(1.8763))
Number(atan2d(2.2645, -1.8415))
Number(atan2d(-2.0674, -2.5539))
Number(atan2d(1.3665, 0.3489))
Number(max3(-2.485, 1.0491, -2.321))
Number(max3(-2.469, -0.2263, 0.8486))
Number(max3(2.2348, 1.2589, -2.4547))
Number(min3(0.8586, -1.8536, -2.0588))
Number(min3(-0.0501, 1.067, -0.3012))
Number(min3(0.4177, 2.3491, -2.0232))
Number(even(0))
Number(even(9))
Number(even(8))
Number(odd(-8))
Number(odd(7))
Number(odd(5))
Number(f_sqr(-2.1956))
Number(f_sqr(0.2132))
Number(f_sqr(-2.3729))
Number(sgn(-1.6572))
Number(sgn(0.0836))
Number(sgn(2.3839))
Number(clip(-2.5446, -0.1938, 2.5023))
Number(clip(-0.3239, 0.4217, 2.3803))
Number(clip(0.001, -1.2304, 1.3917))
Number(clamp(-0.8193, -2.5508, 1.2574))
Number(clamp(-2.153, -0.9321, 1.5057))
Number(clamp(0.5228, -0.0644, 0.7928))
Number(adj_range(-0.9129, 0.0294, 1.3215))
Number(adj_range(1.2059, 0.6519, 1.6873))
Number(adj_range(-1.9419, -2.8431, -0.0311))
Number(adj_range2(0.0216, -1.1034, -0.3713, -0.7251, 1.3413))
Number(adj_range2(0.5515, -0.3162, 1.4684, -2.4992, 1.061))
Number(adj_range2(-1.3653, -2.0095, 1.9416, -2.7675, -2.526))

#declare Fg = fn_Gradient(Ga)
#declare Fd = fn_Gradient_Directional(Gb, <1, 2, 3>)
#declare Fv = fn_Divergence(Ga, Gb, Gc)
Number(Fg(.3, .4, .5))
Number(Fd(.3, .4, .5))
Number(Fv(.3, .4, .5))
GetStats(ArA)
Number(StatisticsArray[1])
Number(StatisticsArray[2])
Number(StatisticsArray[3])
Number(StatisticsArray[4])


// ---- equal components ----

Vector(VPerp_To_Vector(x)) Vector(VPerp_To_Vector(y)) Vector(VPerp_To_Vector(z)) Vector(VPerp_To_Vector(-2 * x))
Vector(VPerp_To_Vector(x + y)) Vector(VPerp_To_Vector(y + z)) Vector(VPerp_To_Vector(x + z)) Vector(VPerp_To_Vector(<1, 5, 1>))
Vector(VPerp_To_Vector(<1, 1, 1>)) Vector(VPerp_To_Vector(<-1, -1, 2>)) Vector(VPerp_To_Vector(<2, 1, 1>))

// ---- height fields on surfaces ----

// Where rays towards the middle meet an object, and the normals there.
#macro Traced(V, Middle)
    #local S = seed(3);
    #local I = 0;
    #while (I < 60)
        #local From = Middle + vnormalize(<rand(S), rand(S), rand(S)> - .5) * 9;
        #local N = <0, 0, 0>;
        #local At = trace(V, From, Middle + (<rand(S), rand(S), rand(S)> - .5) * 2 - From, N);
        #debug concat("= ", vstr(3, At, " ", 0, 5), "; ", vstr(3, N, " ", 0, 4), "\n")
        #local I = I + 1;
    #end
#end

#declare Hf = function (x, y, z) { sin(x * 2) * .4 + y * y * .2 + z * .2 + x * y * .3 }
#declare HfFlat = HF_Square(Hf, 1, 0, <5, 7>, 0, "", <-2, -1, -2>, <2, 1, 2>)
Traced(HfFlat, <0, 0, 0>)
#declare HfSmooth = HF_Square(Hf, 0, 1, <6, 5>, 1, "", <-2, -1, -2>, <2, 1, 2>)
Traced(HfSmooth, <0, 0, 0>)
#declare HfBall = HF_Sphere(Hf, 0, 1, <9, 7>, 1, "", <1, 2, 3>, 2, .5)
Traced(HfBall, <1, 2, 3>)
#declare HfTube = HF_Cylinder(Hf, 1, 1, <9, 4>, 1, "", <1, 2, 3>, <2, 4, 6>, 2, .5)
Traced(HfTube, <1.5, 3, 4.5>)
#declare HfLow = HF_Cylinder(Hf, 0, 0, <7, 4>, 0, "", <-1, 0, 0>, <2, 0, 0>, 1, .2)
Traced(HfLow, <0, 0, 0>)
#declare HfRing = HF_Torus(Hf, 0, 1, <12, 9>, 1, "", 2, .5, .3)
Traced(HfRing, <0, 0, 0>)

// ---- bevelled letters, where there are fonts ----

#macro Letters(V)
    #local S = seed(5);
    #local I = 0;
    #while (I < 100)
        #local At = <rand(S) * .9, rand(S) * .8, -1>;
        #local N = <0, 0, 0>;
        #local Hit = trace(V, At, z, N);
        #debug concat("= ", vstr(3, Hit, " ", 0, 5), "; ", vstr(3, N, " ", 0, 4), "\n")
        #local I = I + 1;
    #end
#end
#if (file_exists("timrom.ttf"))
    #declare Sharp = Bevelled_Text("timrom.ttf", "Ag", 8, 35, .05, .3, .1 * x, 0)
    Letters(Sharp)
    #declare Three = Bevelled_Text("timrom.ttf", "W", 3, 20, .1, .5, 0, 1)
    Letters(Three)
    #debug concat("= ", str(Text_Space("timrom.ttf", "abc", 2, .2), 0, 3), "\n")
    #debug concat("= ", str(Text_Space("timrom.ttf", "a b", 1, 0), 0, 3), "\n")
    #macro Round(V) object { V scale .3 translate <.4, .4, 0> } #end
    #declare Outer = Round(Circle_Text("timrom.ttf", "Circle", .8, .1, 2, .7, 0, Align_Left, 120))
    Letters(Outer)
    #declare Middle = Round(Circle_Text("timrom.ttf", "Text", .8, .2, 2, .7, 1, Align_Center, 45))
    Letters(Middle)
    #declare Inner = Round(Circle_Text("timrom.ttf", "ab c", .8, 0, 2, .7, 1, Align_Right, 0))
    Letters(Inner)
    #declare Turned = Round(Circle_Text_Valigned("timrom.ttf", "Tilt", .8, .1, 2, .7, 0, Align_Right, 30, -40))
    Letters(Turned)
#end
