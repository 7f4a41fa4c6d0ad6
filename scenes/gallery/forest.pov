// Ten thousand firs, each one of three that were declared once.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 9, -32> look_at <0, 3, 10> angle 55 }
light_source { <-60, 50, -40> rgb <1.1, 1, .85> }
sky_sphere { pigment { gradient y color_map { [0 rgb <.75, .8, .85>] [.4 rgb <.3, .5, .8>] } } }
fog { distance 160 rgb <.72, .78, .84> }
plane { y, 0 pigment { bozo scale 4 color_map { [0 rgb <.2, .3, .1>] [1 rgb <.35, .38, .17>] } } }
#macro Fir(N, Tall, Green)
    union {
        cylinder { 0, Tall*y, .09 pigment { rgb <.3, .2, .12> } }
        #for (I, 0, N - 1)
            cone { y*(.6 + I*(Tall - .6)/N), 1.15*(1 - I/(N + 1)), y*(.6 + (I + 1.9)*(Tall - .6)/N), 0 pigment { rgb Green*(.8 + .05*I) } }
        #end
    }
#end
#declare A = Fir(5, 4, <.08, .28, .12>)
#declare B = Fir(7, 5.5, <.1, .25, .08>)
#declare C = Fir(4, 2.6, <.18, .33, .1>)
#declare R = seed(41);
#for (I, 1, 10000)
    #local P = <300*(rand(R) - .5), 0, 300*rand(R) - 22>;
    #if (abs(P.x + 8*sin(P.z/14)) > 3.5)
        object { #switch (mod(I, 3)) #case (0) A #break #case (1) B #break #else C #end
            scale .7 + .6*rand(R) rotate 360*rand(R)*y translate P }
    #else
        #local Skip = rand(R) + rand(R);
    #end
#end
