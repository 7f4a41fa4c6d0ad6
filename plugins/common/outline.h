/* outline.h - closed plane curves of straight, quadratic and cubic pieces, filled by the even-odd rule.
 *
 * A piece is given by its Bezier points; pieces that join have an end in common, bit by bit. On which side of a line an end
 * lies is computed from the two alone, so a line crosses a closed curve an even number of times. */
#ifndef COMMON_OUTLINE_H
#define COMMON_OUTLINE_H

#include <povtrace/shape.h>

typedef struct common_piece { uint32_t degree; double x[4], y[4]; } common_piece;

typedef struct common_outline {
    uint32_t count, capacity;
    common_piece *at;
    double lo[2], hi[2];
    /* Bezier points of all pieces side by side: for each number of a point a row of x and one of y. The last point of a
     * piece stands for those that it has not. */
    double *rows;
    uint32_t stride, points;
    double (*across)[2];         /* of straight pieces: a unit vector across, to the right of the way */
    double (*cubic)[2][4];       /* of curved pieces: x and y of the points that each has as a cubic */
} common_outline;

/* Where a line crosses: at its parameter s, at u of the piece. */
typedef struct common_cross { double s, u; uint32_t piece; } common_cross;

/* Appends a piece; `memory` is the host's. False: no memory. */
bool common_outline_add(common_outline *o, const pov_host *host, pov_reader *in, const common_piece *piece);
/* Pieces that stand there twice, whichever way they go, are left out: by the even-odd rule neither bounds anything. */
void common_outline_cancel(common_outline *o, const pov_host *host, pov_reader *in);
/* The box of all pieces; then points become (p - middle) scale. */
void common_outline_bound(common_outline *o);
void common_outline_place(common_outline *o, const double middle[2], double scale);

/* To be called last. False: no memory. */
bool common_outline_pack(common_outline *o, const pov_host *host, pov_reader *in);

/* Crossings of the line p + s d in order of s; `out` has room for three a piece. Returns how many. Those of pieces that
 * certainly lie before or behind the range of s are left out; *odd changes for each one before it. */
uint32_t common_outline_cross(const common_outline *o, const double p[2], const double d[2], const double range[2],
                              common_cross *out, bool *odd);
/* The same of the cone from the origin over the outline at height 1, and the line w + s d through (x, height, y). */
uint32_t common_outline_cross_cone(const common_outline *o, pov_vec3 w, pov_vec3 d, common_cross *out);
bool common_outline_inside(const common_outline *o, const double p[2]);
/* Point and tangent of a piece. */
void common_piece_at(const common_piece *piece, double u, double point[2], double tangent[2]);

#endif
