#include "plugins/subject.h"

#include "support/check.h"
#include "support/fake_reader.h"

#include <povtrace/exact.h>

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

plugin_subject subject;

static const struct { const char *keyword, *text; } texts[] = {
    { "sphere", "<0, 0, 0>, 1" },
    { "sphere", "<3, -2, 1>, 0.25" },
    { "sphere", "<1e6, 2e6, -1e6>, 1e-3" },
    { "box", "<-1, -1, -1>, <1, 1, 1>" },
    { "box", "<2, 5, 1>, <1, 4.5, 3>" },
    { "box", "<0, 0, 0>, <1, 1e-9, 1>" },
    { "cylinder", "<0, 0, 0>, <0, 1, 0>, 1" },
    { "cylinder", "<-1, 0.5, 0>, <1, 0.5, 0>, 0.5" },
    { "cylinder", "<1, 2, 3>, <2, 1, 5>, 0.5 open" },
    { "cylinder", "<0, 0, 0>, <0, 0, 10>, 1e-4" },
    { "cylinder", "<1e6, 2e6, -1e6>, <1000000.001, 2000000.002, -1e6>, 1e-3" },
    { "cylinder", "<0, 0, 0>, <0, 1e-3, 1e-4>, 1" },
    { "cone", "<0, 0, 0>, 1, <0, 1, 0>, 0" },
    { "cone", "<1, 1, 1>, 5, <1.1, 1.5, 1>, 0" },
    { "cone", "<3, 0, 1>, 2, <3, 1, 1.5>, 1e-9 open" },
    { "cone", "<1, 0, 1>, 0.25, <2, 3, 0>, 1 open" },
    { "cone", "<0, -1, 0>, 1, <0, 1, 0>, 0.999999" },
    { "quadric", "<1, 1, 1>, <0, 0, 0>, <0, 0, 0>, -1" },
    { "quadric", "<1, 2, 0.5>, <0.3, -0.2, 0.1>, <1, 0, 2>, -1" },
    { "quadric", "<1, 0, 1>, <0, 0, 0>, <0, -1, 0>, 0" },
    { "quadric", "<0, 0, 0>, <0, 0, 0>, <0, 1, 0>, 0.5" },
    { "torus", "1, 0.25" },
    { "torus", "0.5, 0.01" },
    { "torus", "0, 0.75" },
    { "torus", "2e6, 1e4" },
    { "torus", "1e-90, 0.9e-90" },
    { "plane", "<0, 1, 0>, -0.5" },
    { "plane", "<-1, 0, 0>, 7" },
    { "plane", "<0, 0, 4>, 1e-3" },
    { "plane", "<3, -2, 7>, 1e3" },
    { "plane", "<1e-200, 0, 2e-200>, 0" },
    { "quadric", "<1, 1, -1>, <0, 0, 0>, <0, 0, 0>, -0.25" },
    { "quadric", "<-1, -1, -1>, <0, 0, 0>, <0, 0, 0>, 1" },
    { "polygon", "5, <0, 0, 0>, <1, 0, 0>, <1, 1, 0>, <0, 1, 0>, <0, 0, 0>" },
    { "polygon", "10, <-2, 1, -2>, <2, 1, -2>, <2, 1, 2>, <-2, 1, 2>, <-2, 1, -2>, "
                 "<-1, 1, -1>, <1, 1, -1>, <1, 1, 1>, <-1, 1, 1>, <-1, 1, -1>" },
    { "polygon", "4, <1, 0, 0>, <0, 1, 0>, <0, 0, 1>, <1, 0, 0>" },
    { "polygon", "4, <1, 0, 0>, <1, 1, 0>, <1.1, 0.5, 0.01>, <1, 0, 0>" },
    { "polygon", "5, <1e6, 2, 1e6>, <1e6, 2.001, 1e6>, <1000000.001, 2.0005, 1e6>, <1000000.0005, 2, 1e6>, <1e6, 2, 1e6>" },
    { "polygon", "5, <0, 0, 0>, <1, 1, 1>, <1, 1, 0>, <0, 0, 1>, <0, 0, 0>" },
    { "polygon", "6, <-0.7, -0.7, 0>, <0.7, -0.7, 0>, <0.9, 0.3, 0>, <0, 0.9, 0>, <-0.9, 0.3, 0>, <-0.7, -0.7, 0>" },
    { "polygon", "6, <0, 1, 0>, <0.6, -0.8, 0>, <-1, 0.3, 0>, <1, 0.3, 0>, <-0.6, -0.8, 0>, <0, 1, 0>" },
    { "triangle", "<0, 0, 0>, <1, 0, 0>, <0, 1, 0>" },
    { "triangle", "<1, 2, 3>, <-2, 1, 5>, <4, 4, 4>" },
    { "triangle", "<1e6, 2, 1e6>, <1e6, 2.001, 1e6>, <1000000.001, 2.0005, 1e6>" },
    { "triangle", "<0, 0, 0>, <1, 1e-6, 0>, <2, 0, 1e-6>" },
    { "smooth_triangle", "<0, 0, 0>, <0, 0, -1>, <1, 0, 0>, <1, 0, -2>, <0, 1, 0>, <0, 3, -1>" },
    { "mesh2", "vertex_vectors { 4, <0,0,0>, <1,0,0>, <0,1,0>, <0,0,1> } face_indices { 4, <0,1,2>, <0,1,3>, <0,2,3>, "
               "<1,2,3> } inside_vector <0.3, 0.9, 0.1>" },
    /* Smooth but for its last face, whose normals are one. */
    { "mesh2", "vertex_vectors { 4, <0,0,0>, <1,0,0>, <0,1,0>, <0,0,1> } normal_vectors { 5, <-1,-1,-1>, <3,-1,.2>, <-1,2,-1>, <0,-1,3>, "
               "<1,1,1> } face_indices { 4, <0,1,2>, <0,1,3>, <0,2,3>, <1,2,3> } normal_indices { 4, <0,1,2>, <0,1,3>, <0,2,3>, <4,4,4> } "
               "inside_vector <0.3, 0.9, 0.1>" },
    { "mesh", "triangle { <1,0,0>, <0,1,0>, <0,0,1> } triangle { <0,1,0>, <-1,0,0>, <0,0,1> } "
              "triangle { <-1,0,0>, <0,-1,0>, <0,0,1> } triangle { <0,-1,0>, <1,0,0>, <0,0,1> } "
              "triangle { <0,1,0>, <1,0,0>, <0,0,-1> } triangle { <-1,0,0>, <0,1,0>, <0,0,-1> } "
              "triangle { <0,-1,0>, <-1,0,0>, <0,0,-1> } triangle { <1,0,0>, <0,-1,0>, <0,0,-1> } inside_vector <1, 2, 3>" },
    { "mesh", "triangle { <1e6,0,1>, <1000001,1,1.5>, <1e6,0.5,1.25> } triangle { <1e6,0,1>, <1000001,1,1.5>, <1e6,2,7> } "
              "triangle { <1e6,2,7>, <1000001,1,1.5>, <1e6,0.5,1.25> } triangle { <1e6,0,1>, <1e6,0.5,1.25>, <1e6,2,7> } "
              "inside_vector <1, 0, 0>" },
    { "disc", "<0, 0, 0>, <0, 1, 0>, 1" },
    { "disc", "<1, 2, 3>, <1, -1, 2>, 2, 0.5" },
    { "prism", "0, 1, 4, <0, 0>, <1, 0>, <0, 1>, <0, 0>" },
    { "prism", "-0.3, 0.241, 6, <1.4, 0>, <-1.133, 0.823>, <0.433, -1.331>, <0.433, 1.331>, <-1.133, -0.823>, <1.4, 0>" },
    { "prism", "conic_sweep 0.4, 1.3, 5, <1, 1>, <-1, 1>, <-1, -1>, <1, -1>, <1, 1>" },
    { "prism", "conic_sweep quadratic_spline 0.4, 1.3, 6, <-1, 0>, <1, -1>, <1, 1>, <-1, 1>, <-1, -1>, <1, -1>" },
    { "prism", "conic_sweep cubic_spline 0.5, 1, 7, <-1, -1>, <1, -1>, <1, 1>, <-1, 1>, <-1, -1>, <1, -1>, <1, 1>" },
    { "prism", "linear_sweep quadratic_spline -1, 1, 6, <-1, 0>, <1, -1>, <1, 1>, <-1, 1>, <-1, -1>, <1, -1>" },
    { "prism", "cubic_spline 0, 0.5, 7, <-1, -1>, <1, -1>, <1, 1>, <-1, 1>, <-1, -1>, <1, -1>, <1, 1>" },
    { "prism", "bezier_spline 1e6, 1000000.5, 8, <0, 0>, <1, 0>, <1, 1>, <0, 1>, <0, 1>, <-1, 1>, <-1, 0>, <0, 0>" },
    { "prism", "linear_spline 0, 1, 4, <0, 0>, <1, 0>, <0, 1>, <0, 0> open" },
    { "lathe", "4, <0, -1>, <1, -0.5>, <0.5, 0.4>, <0, 1>" },
    { "lathe", "linear_spline 5, <1, 0>, <2, 0>, <2, 1>, <1, 1>, <1, 0>" },
    { "lathe", "quadratic_spline 5, <0, -1.5>, <0, -1>, <1, -0.5>, <0.6, 0.4>, <0, 1>" },
    { "lathe", "cubic_spline 7, <0, -1.4>, <0, -1.2>, <0.962, -0.6>, <0.553, 0>, <0.836, 0.6>, <0, 1.2>, <0, 1.5>" },
    { "lathe", "bezier_spline 8, <2, 1e6>, <3, 1e6>, <3, 1000001>, <2, 1000001>, <2, 1000001>, <1, 1000001>, <1, 1e6>, <2, 1e6>" },
    { "lathe", "linear_spline 3, <1, 0>, <2, 1>, <1, 3>" },
    { "sor", "6, <0.466, -1.5>, <0.642, -1.1>, <0.811, -0.4>, <0.54, 0.3>, <0.729, 0.9>, <0.522, 1.3>" },
    { "sor", "4, <0, 1e6>, <0, 1e6>, <1e-3, 1000000.001>, <1e-3, 1000000.002>" },
    { "sor", "5, <1, 0>, <1, 1>, <2, 2>, <0, 3>, <0, 4> open" },
    { "blob", "threshold 0.5 sphere { <0.5, 0, 0>, 1, 1 } sphere { <-0.5, 0, 0>, 1, 1 }" },
    { "blob", "threshold 0.3 cylinder { <-1, 0, 0>, <1, 0.5, 0>, 0.8, 1 } sphere { <0, 0.3, 0>, 0.6, -0.5 }" },
    /* Rays without an x are level with the second. */
    { "blob", "threshold 0.3 cylinder { -z, z, 0.8, 1 } cylinder { -x, x, 0.5, 0.9 } sphere { y, 0.7, 1 }" },
    /* Enough for runs of components. */
    { "blob", "threshold 0.3 cylinder { -y, y, .2, .5 } sphere { <1, -1, 0>, .3, 1 } "
              "sphere { <0.921, -0.96, 0.389>, .3, 1 } sphere { <0.697, -0.92, 0.717>, .3, 1 } "
              "sphere { <0.362, -0.88, 0.932>, .3, 1 } sphere { <-0.029, -0.84, 1>, .3, 1 } "
              "sphere { <-0.416, -0.8, 0.909>, .3, 1 } sphere { <-0.737, -0.76, 0.675>, .3, 1 } "
              "sphere { <-0.942, -0.72, 0.335>, .3, 1 } sphere { <-0.998, -0.68, -0.058>, .3, 1 } "
              "sphere { <-0.897, -0.64, -0.443>, .3, 1 } sphere { <-0.654, -0.6, -0.757>, .3, 1 } "
              "sphere { <-0.307, -0.56, -0.952>, .3, 1 } sphere { <0.087, -0.52, -0.996>, .3, 1 } "
              "sphere { <0.469, -0.48, -0.883>, .3, 1 } sphere { <0.776, -0.44, -0.631>, .3, 1 } "
              "sphere { <0.96, -0.4, -0.279>, .3, 1 } sphere { <0.993, -0.36, 0.117>, .3, 1 } "
              "sphere { <0.869, -0.32, 0.494>, .3, 1 } sphere { <0.608, -0.28, 0.794>, .3, 1 } "
              "sphere { <0.251, -0.24, 0.968>, .3, 1 } sphere { <-0.146, -0.2, 0.989>, .3, 1 } "
              "sphere { <-0.519, -0.16, 0.855>, .3, 1 } sphere { <-0.811, -0.12, 0.585>, .3, 1 } "
              "sphere { <-0.975, -0.08, 0.223>, .3, 1 } sphere { <-0.985, -0.04, -0.174>, .3, 1 } "
              "sphere { <-0.839, 0, -0.544>, .3, 1 } sphere { <-0.561, 0.04, -0.828>, .3, 1 } "
              "sphere { <-0.194, 0.08, -0.981>, .3, 1 } sphere { <0.203, 0.12, -0.979>, .3, 1 } "
              "sphere { <0.568, 0.16, -0.823>, .3, 1 } sphere { <0.844, 0.2, -0.537>, .3, 1 } "
              "sphere { <0.986, 0.24, -0.166>, .3, 1 } sphere { <0.973, 0.28, 0.232>, .3, 1 } "
              "sphere { <0.806, 0.32, 0.592>, .3, 1 } sphere { <0.512, 0.36, 0.859>, .3, 1 } "
              "sphere { <0.137, 0.4, 0.991>, .3, 1 } sphere { <-0.26, 0.44, 0.966>, .3, 1 } "
              "sphere { <-0.615, 0.48, 0.788>, .3, 1 } sphere { <-0.874, 0.52, 0.486>, .3, 1 } "
              "sphere { <-0.994, 0.56, 0.108>, .3, 1 } sphere { <-0.958, 0.6, -0.288>, .3, 1 } "
              "sphere { <-0.77, 0.64, -0.638>, .3, 1 } sphere { <-0.461, 0.68, -0.888>, .3, 1 } "
              "sphere { <-0.079, 0.72, -0.997>, .3, 1 } sphere { <0.316, 0.76, -0.949>, .3, 1 } "
              "sphere { <0.66, 0.8, -0.751>, .3, 1 } sphere { <0.901, 0.84, -0.435>, .3, 1 } "
              "sphere { <0.999, 0.88, -0.05>, .3, 1 }" },
    { "blob", "threshold 0.2 sphere { <1e6, 0, 0>, 1e-2, strength 1 } component 1, 1e-2, <1000000.01, 0, 0>" },
    { "cubic", "<1, 0, 0, 0, 0, 0, 0, 0, 0, -0.5, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0.1> sturm" },
    { "quartic", "<1, 0, 0, 0, 2, 0, 0, 2, 0, -2.32, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 2, 0, 1.68, 0, 0, 0, 0, 1, 0, -2.32, 0, 0.7056>" },
    { "poly", "2, <1, 0, 0, 0, 1, 0, 0, 1, 0, -1>" },
    { "polynomial", "4, xyz(4, 0, 0): 1, xyz(0, 4, 0): 1 xyz(0, 0, 4): 1 xyz(0, 0, 0): -1" },
    { "cubic", "<1.2, 0, 0, 0.4, 0, 0, 1, 0, 0, -0.3, 0.9, 0.3, 0, 0, 0, 0, -0.7, 0, 0, 0.1>" },
    { "quartic", "<0.3, 0, 0.2, 0, 1, 0, 0, -1, 0, 0.4, 0, 0.7, 0, 0, 0, 0, 0, 0, -0.6, 0, 0, 0, 1, 0, 0, 0.1, 0, 0, 0, 0, -0.5, 0, 0.2, 0, 0.1>" },
    { "polynomial", "6, xyz(6, 0, 0): 1, xyz(2, 4, 0): 3 xyz(0, 6, 0): 1 xyz(0, 0, 6): 2 xyz(1, 1, 1): -1 xyz(0, 0, 0): -0.5" },
    { "polynomial", "9, xyz(9, 0, 0): 1, xyz(0, 5, 1): -3 xyz(0, 0, 4): 1 xyz(1, 2, 1): 2 xyz(0, 1, 0): 0.7 xyz(0, 0, 0): -0.2" },
    /* Convex: its marks say so. The second is one of its spheres. */
    { "sphere_sweep", "linear_spline 2, <-1, 0, 0.3>, 0.5, <1, 0.5, 0>, 0.2" },
    { "sphere_sweep", "linear_spline 2, <0, 0, 0>, 1, <0.3, 0.1, 0>, 0.2" },
    { "sphere_sweep", "linear_spline 3, <0, 0, 0>, 0.5, <1, 0, 0>, 0.2, <1, 2, 0>, 0.3" },
    { "sphere_sweep", "cubic_spline 5, <-1, 0, 0>, 0.5, <0, 0, 0>, 0.3, <1, 1, 0>, 0.2, <2, 0, 1>, 0.3, <3, 0, 0>, 0.3" },
    { "sphere_sweep", "b_spline 4, <1e6, 0, 0>, 5e-3, <1000000.01, 0, 0>, 3e-3, <1e6, 0.01, 0>, 2e-3, <1e6, 0, 0.01>, 3e-3 tolerance 1" },
    { "bicubic_patch", "type 1 u_steps 2 v_steps 3 <0, 0, 0>, <1, 0, 1>, <2, 0, 0>, <3, 0, 0>, <0, 1, 0>, <1, 1, 1>, <2, 1, 0>, <3, 1, 0>, "
                       "<0, 2, 0>, <1, 2, -1>, <2, 2, 0>, <3, 2, 0>, <0, 3, 0>, <1, 3, 1>, <2, 3, 0>, <3, 3, 1>" },
    { "julia_fractal", "<-0.167, -0.083, -0.676, -0.098> quaternion sqr max_iteration 4 precision 20" },
    { "julia_fractal", "<-0.3, 0.2, 0.4, 0.1> cube max_iteration 3 precision 20 slice <0, 0.2, 0, 1>, 0.1" },
    { "julia_fractal", "<-0.5, 0.3, -0.2, 0> hypercomplex sqr max_iteration 4 precision 20" },
    { "julia_fractal", "<0.2, 0.1, 0.3, 0> hypercomplex exp max_iteration 3 precision 20" },
    { "ovus", "1, 0.5" },
    { "ovus", "1e-3, 1.5e-3" },
    { "superellipsoid", "<0.25, 0.5>" },
    { "superellipsoid", "<1, 1>" },
    { "superellipsoid", "<0.1, 0.05>" },
    { "superellipsoid", "<2, 1.5>" },
    { "superellipsoid", "<3, 2.5>" },
};

/* Asked of block filters only, about a point: far apart roots and sizes are more than other tests allow for. */
static const struct hard { const char *keyword, *text; double x, y, z, half; } hard_texts[] = {
    { "quadric", "<1, 0, 0>, <0, 0, 0>, <0, 0, 0>, -1", 0.0, 0.0, 0.0, 2.0 },
    { "quadric", "<1, 2, 1>, <0, 2, 0>, <0.5, 0, 0>, -0.5", 0.0, 0.0, 0.0, 2.0 },
    { "quadric", "<-1, -1, 1>, <0, 0, 0>, <0, 0, 0>, 0.25", 0.0, 0.0, 0.0, 2.0 },
    { "quadric", "<1, -1, 0>, <0, 0, 0>, <0, 0, -1>, 0.1", 0.0, 0.0, 0.0, 2.0 },
    { "quadric", "<1, 0, 1>, <0, 0, 0>, <0, 0, 0>, -1e-8", 0.0, 0.0, 0.0, 2e-4 },
    { "quadric", "<1e-9, 1e-12, -1e-10>, <0, 1e-11, 0>, <0.3, 1, -0.2>, 0.1", 0.0, 0.0, 0.0, 2.0 },
    { "quadric", "<1e-17, 1e-14, 0>, <0, 1e-15, 0>, <0.3, 1, -0.2>, 0.1", 0.0, 0.0, 0.0, 2.0 },
    { "quadric", "<1, 1e-13, -1>, <0, 0, 1e-15>, <0, 0, 0>, -1e-3", 0.0, 0.0, 0.0, 2.0 },
    { "quadric", "<1, 0, 1>, <0, 0, 0>, <-2e6, 0, 4e6>, 4999999999999", 1e6, 0.0, -2e6, 2.0 },
    { "quadric", "<1, 0, 0>, <0, 0, 0>, <-2e8, -1, 0>, 1e16", 1e8, 0.0, 0.0, 2.0 },
    { "quadric", "<1, 1, -1>, <0, 0, 0>, <0, 0, 0>, 0", 0.0, 0.0, 0.0, 1e-3 },
    { "quadric", "<1e20, -2e20, 1e20>, <0, 0, 0>, <0, 0, 0>, -1e-4", 0.0, 0.0, 0.0, 1e-12 },
    { "quadric", "<1e-20, -2e-20, 1e-20>, <0, 0, 0>, <0, 0, 0>, 1", 0.0, 0.0, 0.0, 1e10 },
    { "quadric", "<0, 0, 0>, <0, 0, 0>, <1e-7, 1, 1e-9>, -1e6", 0.0, 1e6, 0.0, 1.0 },
    { "quadric", "<0, 0, 0>, <0, 0, 0>, <0.3, 0.7, -0.1>, 0", 0.0, 0.0, 0.0, 1.0 },
    { "quadric", "<0, 0, 0>, <0, 0, 0>, <0, 2, 0>, 1e-3", 0.0, 0.0, 0.0, 1.0 },
    { "quadric", "<1, 1, 1>, <2, 2, 2>, <0, 0, 0>, -1e-6", 0.0, 0.0, 0.0, 1.0 },
    { "quadric", "<1, 1, 1>, <0, 0, 0>, <0, 0, 0>, 1e-12", 0.0, 0.0, 0.0, 1e-5 },
};

static const uint64_t seed = 88172645463325252u;
static uint64_t state;

double subject_length(pov_vec3 a) { return sqrt(pov_dot(a, a)); }

double subject_uniform(void)
{
    state ^= state << 13;
    state ^= state >> 7;
    state ^= state << 17;
    return (double)(state >> 11) * 0x1p-53;
}

pov_vec3 subject_direction(void)
{
    const double z = 2.0 * subject_uniform() - 1.0, angle = 6.283185307179586 * subject_uniform(),
                 r = sqrt(1.0 - z * z);
    return pov_vec3_of(r * cos(angle), r * sin(angle), z);
}

void *subject_memory(void)
{
    return fake_reader_memory(subject.in, subject.shape->instance_size);
}

static double shorter(double a, double b) { return b > 0.0 && b < a ? b : a; }

static void aim_about(thing *t, pov_vec3 middle, double half)
{
    pov_vec3 side;

    if (!t->finite) {
        t->box.lo = pov_sub(middle, pov_vec3_of(half, half, half));
        t->box.hi = pov_add(middle, pov_vec3_of(half, half, half));
    }
    side = pov_sub(t->box.hi, t->box.lo);
    t->size = pov_largest(side);
    t->thickness = shorter(shorter(t->size, side.x), shorter(side.y, side.z));
    t->middle = pov_add(pov_scale(t->box.lo, 0.5), pov_scale(t->box.hi, 0.5));
}

static void take(void *self)
{
    thing *t = &subject.things[subject.count++];

    t->self = self;
    fake_reader_print(subject.in, t->text, sizeof t->text);
    t->finite = subject.shape->bounds(self, &t->box);
    aim_about(t, pov_vec3_of(0.0, 0.0, 0.0), 2.0);
}

static void read_in(const char *text)
{
    void *self = subject_memory();

    fake_reader_clear(subject.in);
    fake_reader_text(subject.in, text);
    if (fake_reader_parse_into(subject.in, subject.shape, self))
        take(self);
    else
        print_error("%s { %s }: %s\n", subject.shape->keyword, text, fake_reader_message(subject.in));
}

static void read_hard(void)
{
    const int count = subject.count;
    size_t i;

    for (i = 0; i < sizeof hard_texts / sizeof *hard_texts; i++) {
        const struct hard *h = &hard_texts[i];

        if (strcmp(h->keyword, subject.shape->keyword) != 0)
            continue;
        read_in(h->text);
        aim_about(&subject.things[subject.count - 1], pov_vec3_of(h->x, h->y, h->z), h->half);
    }
    subject.hard = subject.count - count;
    subject.count = count;
}

/* As many numbers as the plugin wants: more are fed until it is content. */
static void guess(void)
{
    int tries, numbers, i;

    for (tries = 0; tries < 4000 && subject.count < 6; tries++) {
        void *self = subject_memory();

        fake_reader_clear(subject.in);
        numbers = 1 + tries % 24;
        for (i = 0; i < numbers; i++) {
            const bool vector = subject_uniform() < 0.5;

            if (vector) {
                char text[128];
                snprintf(text, sizeof text, "<%.17g, %.17g, %.17g>", 4.0 * subject_uniform() - 2.0,
                         4.0 * subject_uniform() - 2.0, 4.0 * subject_uniform() - 2.0);
                fake_reader_text(subject.in, text);
            } else {
                fake_reader_number(subject.in,
                                   subject_uniform() < 0.3 ? floor(8.0 * subject_uniform()) : 2.0 * subject_uniform());
            }
        }
        if (fake_reader_parse_into(subject.in, subject.shape, self))
            take(self);
    }
}

bool subject_set_up(const char *file)
{
    size_t i;

    state = seed;                /* what is asked of a plugin does not depend on those before it */
    memset(&subject, 0, sizeof subject);
    snprintf(subject.file, sizeof subject.file, "%s", file);
    subject.shape = fake_reader_load(file);
    subject.in = fake_reader_create();
    if (!subject.shape || !subject.in)
        return false;
    for (i = 0; i < sizeof texts / sizeof *texts; i++) {
        if (strcmp(texts[i].keyword, subject.shape->keyword) == 0)
            read_in(texts[i].text);
    }
    if (subject.count == 0)
        guess();
    read_hard();
    return subject.count > 0;
}

/* ---- rays ---- */

pov_ray subject_ray(const thing *t)
{
    const pov_vec3 half = pov_scale(pov_sub(t->box.hi, t->box.lo), 0.6), d = subject_direction();
    const pov_vec3 target = pov_add(t->middle, pov_vec3_of(half.x * (2.0 * subject_uniform() - 1.0),
                                                           half.y * (2.0 * subject_uniform() - 1.0),
                                                           half.z * (2.0 * subject_uniform() - 1.0)));
    pov_ray ray;

    memset(&ray, 0, sizeof ray);
    ray.org = pov_sub(target, pov_scale(d, t->size * pow(10.0, 4.0 * subject_uniform() - 1.0)));
    ray.dir = pov_scale(d, pow(10.0, 6.0 * subject_uniform() - 3.0));
    ray.origin_surface = POV_NO_OWNER;
    return ray;
}

void subject_sides(const char *format, ...)
{
    va_list values;

    va_start(values, format);
    vsnprintf(subject.sides, sizeof subject.sides, format, values);
    va_end(values);
}

static void print_broken(const thing *t, const pov_ray *ray)
{
    print_error("%s { %s }\n    from <%.17g, %.17g, %.17g> along <%.17g, %.17g, %.17g>%s%s\n", subject.shape->keyword,
                t->text, ray->org.x, ray->org.y, ray->org.z, ray->dir.x, ray->dir.y, ray->dir.z,
                subject.sides[0] ? ": " : "", subject.sides);
}

void subject_each(int rays, pov_ray (*make)(const thing *t), bool (*visit)(const thing *t, const pov_ray *ray))
{
    int i, j, broken = 0;

    for (i = 0; i < subject.count; i++) {
        for (j = 0; j < rays; j++) {
            const pov_ray ray = make(&subject.things[i]);

            subject.sides[0] = '\0';
            if (!visit(&subject.things[i], &ray) && broken++ < 4)
                print_broken(&subject.things[i], &ray);
        }
    }
    assert_int_equal(broken, 0);
}

void subject_each_ray(int rays, bool (*visit)(const thing *t, const pov_ray *ray))
{
    subject_each(rays, subject_ray, visit);
}

void subject_skip(const char *why)
{
    print_message("%s %s", subject.shape->keyword, why);
    skip();
}

void *subject_scratch(const void *self)
{
    static union { char bytes[1 << 16]; double aligned; } memory;

    if (subject.shape->scratch)
        assert_true(subject.shape->scratch(self) <= sizeof memory);
    return &memory;
}

uint32_t subject_ask_in(const void *self, const pov_ray *ray, pov_want want, double tmin, double tmax, bool exact,
                        pov_crossing at[MOST])
{
    pov_hits hits = { 0 };
    uint32_t i, j;

    hits.tmin = tmin;
    hits.tmax = tmax;
    hits.want = want;
    hits.always_exact = hits.unfiltered = exact;
    hits.owner = OWNER;
    hits.capacity = MOST;
    hits.at = at;
    hits.scratch = subject_scratch(self);
    subject.shape->intersect(self, ray, &hits);
    for (i = 1; i < hits.count; i++) {
        const pov_crossing c = at[i];

        for (j = i; j > 0 && at[j - 1].t > c.t; j--)
            at[j] = at[j - 1];
        at[j] = c;
    }
    return hits.count;
}

uint32_t subject_ask(const void *self, const pov_ray *ray, pov_crossing at[MOST])
{
    return subject_ask_in(self, ray, POV_WANT_ALL, 0.0, HUGE_VAL, false, at);
}

void subject_point(const pov_ray *ray, double t, double t_lo, pov_vec3 *hi, pov_vec3 *lo)
{
    const pov_two when = pov_two_of(t, t_lo);
    const pov_two x = pov_two_add(pov_two_sum(ray->org.x, ray->org_lo.x), pov_two_mul_double(when, ray->dir.x));
    const pov_two y = pov_two_add(pov_two_sum(ray->org.y, ray->org_lo.y), pov_two_mul_double(when, ray->dir.y));
    const pov_two z = pov_two_add(pov_two_sum(ray->org.z, ray->org_lo.z), pov_two_mul_double(when, ray->dir.z));

    *hi = pov_vec3_of(x.hi, y.hi, z.hi);
    *lo = pov_vec3_of(x.lo, y.lo, z.lo);
}

pov_hits subject_nearest(double tmax, pov_crossing *at)
{
    pov_hits hits;

    memset(&hits, 0, sizeof hits);
    memset(at, 0, sizeof *at);
    hits.tmax = tmax;
    hits.want = POV_WANT_NEAREST;
    hits.owner = OWNER;
    hits.capacity = 1;
    hits.at = at;
    return hits;
}

static pov_two along(double o, double o_lo, pov_two t, double d)
{
    return pov_two_add(pov_two_add_double(pov_two_of(o, 0.0), o_lo), pov_two_mul_double(t, d));
}

bool subject_is_contact(const void *self, const pov_ray *ray, const pov_crossing *at, const pov_contact *found)
{
    const pov_two t = pov_fast_two_sum(at->t, at->t_lo);
    const pov_two x = along(ray->org.x, ray->org_lo.x, t, ray->dir.x), y = along(ray->org.y, ray->org_lo.y, t, ray->dir.y);
    const pov_two z = along(ray->org.z, ray->org_lo.z, t, ray->dir.z);
    const pov_vec3 point[2] = { pov_vec3_of(x.hi, y.hi, z.hi), pov_vec3_of(x.lo, y.lo, z.lo) }, *const from = point;
    pov_vec3 normal, *const to = &normal;

    if (subject.shape->normal_at_many)
        subject.shape->normal_at_many(&self, &from, &to, 1);
    else
        subject.shape->normal(self, ray, at, &normal);
    return memcmp(&point[0], &found->point, sizeof point[0]) == 0 && memcmp(&point[1], &found->point_lo, sizeof point[1]) == 0 &&
           memcmp(&normal, &found->normal, sizeof normal) == 0;
}
