"""A scene for each shape of more than a quadric's work: turned copies in a grid that fills the view, one light."""
import random
from itertools import product

from formats import Look, Scene

TURF = 'function 64,64 { .5 + .25*sin(9*x)*cos(7*y) + .2*sin(31*x + 17*y) }'
# Each fits a sphere of radius one or so around the origin.
SHAPES = {
    'torus': 'torus { .7, .25',
    'cubic': 'cubic { <1.2,0,0,.4, 0,0,1,0,0,-.3, .9,.3,0,0,0,0, -.7,0,0,.1> clipped_by { sphere { 0, 1 } } '
             'bounded_by { clipped_by }',
    'quartic': 'quartic { <1,0,0,0,2,0,0,2,0,-1.3, 0,0,0,0,0,0,0,0,0,0, 1,0,0,2,0,.3,0,0,0,0, 1,0,-1.3,0,.2> '
               'sturm bounded_by { sphere { 0, 1.4 } }',
    'poly': 'poly { 4, <1,0,0,0,2,0,0,2,0,-1.3, 0,0,0,0,0,0,0,0,0,0, 1,0,0,2,0,.3,0,0,0,0, 1,0,-1.3,0,.2> '
            'bounded_by { sphere { 0, 1.4 } }',
    'height_field': 'height_field { ' + TURF + ' smooth translate -.5 scale <1.6,.8,1.6>',
    'prism': 'prism { linear_sweep linear_spline -.5, .5, 11, <0,.9>, <.2,.3>, <.85,.3>, <.35,-.1>, <.5,-.75>, <0,-.35>, '
             '<-.5,-.75>, <-.35,-.1>, <-.85,.3>, <-.2,.3>, <0,.9>',
    'prism_cubic': 'prism { linear_sweep cubic_spline -.5, .5, 9, <-.6,0>, <0,.8>, <.6,0>, <.3,-.7>, <0,-.3>, <-.3,-.7>, '
                   '<-.6,0>, <0,.8>, <.6,0>',
    'lathe': 'lathe { cubic_spline 7, <0,-1.2>, <.5,-.8>, <.7,-.3>, <.3,.1>, <.5,.5>, <.2,.8>, <0,1>',
    'lathe_linear': 'lathe { linear_spline 5, <.01,-.8>, <.7,-.5>, <.3,0>, <.6,.5>, <.01,.8>',
    'sor': 'sor { 6, <.1,-1>, <.5,-.8>, <.7,-.3>, <.3,.2>, <.45,.7>, <.1,1>',
    'superellipsoid': 'superellipsoid { <.4,.3> scale .75',
    'bicubic': 'bicubic_patch { type 1 flatness .01 u_steps 4 v_steps 4 <-.9,-.9,0>, <-.3,-.9,.8>, <.3,-.9,-.6>, '
               '<.9,-.9,0>, <-.9,-.3,.5>, <-.3,-.3,-.9>, <.3,-.3,.9>, <.9,-.3,-.5>, <-.9,.3,-.4>, <-.3,.3,.7>, '
               '<.3,.3,-.8>, <.9,.3,.4>, <-.9,.9,0>, <-.3,.9,-.6>, <.3,.9,.5>, <.9,.9,0>',
    'text': 'text { ttf "timrom.ttf" "Rag" .2, 0 translate <-.8,-.3,-.1>',
    'blob': 'blob { threshold .5 sphere { <.4,0,0>, .7, 1 } sphere { <-.4,.2,0>, .7, 1 } sphere { <0,.4,.4>, .6, 1 } '
            'cylinder { <0,-.7,-.4>, <0,.6,0>, .4, .8 } sphere { <.3,-.5,.2>, .5, -.6 }',
    'isosurface': 'isosurface { function { x*x + y*y + z*z - .5 + .1*sin(7*x)*sin(7*y)*sin(7*z) } '
                  'contained_by { sphere { 0, .95 } } max_gradient 2.9 accuracy .001',
    'parametric': 'parametric { function { cos(u)*(.6 + .25*cos(v)) }, function { .25*sin(v) }, '
                  'function { sin(u)*(.6 + .25*cos(v)) } <0,0>, <6.2832,6.2832> contained_by { box { <-.9,-.3,-.9>, '
                  '<.9,.3,.9> } } max_gradient 1 accuracy .005 precompute 12 x,y,z',
    'sphere_sweep': 'sphere_sweep { b_spline 6, <-.9,-.6,0>, .2, <-.6,.6,.4>, .25, <0,-.6,-.4>, .2, <.4,.7,0>, .3, '
                    '<.8,-.4,.3>, .2, <.9,.8,0>, .2 tolerance .0001',
    'julia': 'julia_fractal { <-.08,0,-.83,-.02> quaternion sqr max_iteration 8 precision 20 scale .8',
    'ovus': 'ovus { .6, .3 translate -.4*y',
}
LOOKS = tuple(Look(rgb) for rgb in ((.85, .35, .25), (.3, .7, .35), (.3, .45, .85), (.85, .75, .3)))


def shape(name, columns=8, rows=6):
    """The shape `columns` times `rows` times, each turned as chance has it."""
    def lay():
        draw = random.Random(7).random
        for number, (column, row) in enumerate(product(range(columns), range(rows))):
            turn = [360.0 * draw() for _ in range(3)]
            place = (1.7 * (column - 0.5 * (columns - 1)), 1.7 * (row - 0.5 * (rows - 1)), draw())
            yield (f'{SHAPES[name]} {LOOKS[number % 4].text()} rotate <%.5g,%.5g,%.5g> translate <%.5g,%.5g,%.5g> }}'
                   % (*turn, *place))
    return Scene((0, 0, -16), (0, 0, 0), 46, lights=[((12, 18, -20), 1)], objects=lay)
