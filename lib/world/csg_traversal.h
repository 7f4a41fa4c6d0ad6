/* csg_traversal.h - a ray's way through a tree of shapes: crossings of its members, from near to far. */
#ifndef WORLD_CSG_TRAVERSAL_H
#define WORLD_CSG_TRAVERSAL_H

#include "world/csg.h"

/* Crossings are coincident if their distances differ by no more than the error of double-double. */
#define CSG_SAME_POINT 0x1p-92
/* Distances in double are distinct if they differ by more than this fraction; else all are computed again in
 * double-double. */
#define CSG_SEPARATION 0x1p-42

typedef struct csg_traversal {
    const csg_tree *tree;
    const pov_ray *ray;
    csg_scratch *scratch;
    pov_hits found;              /* the members' crossings */
    uint32_t applied;            /* number of crossings at the front that are behind; the others are in order */
    uint32_t asked_count, near_count;
    bool unsure;                 /* doubles cannot order them */
    bool missed;                 /* the ray is never inside a member that the tree is within */
    bool whole, grazes;          /* whole: open clips are asked for their crossings; else grazes: one of them would have to be */
    double enter, leave;         /* of the tree's box; without one, 0 and infinity */
    pov_vec3 inverse;            /* 1 / direction, by component */
    double dir, size;            /* largest component of the direction; and of the coordinates involved */
} csg_traversal;

void csg_traversal_init(csg_traversal *w, const csg_tree *tree, const pov_ray *ray, const pov_hits *hits);
/* False: the ray passes the tree's box; or the tree before tmax. */
bool csg_traversal_hits_box(csg_traversal *w);
bool csg_traversal_enters(csg_traversal *w, const pov_hits *hits);
/* May the ray hit the contents of a box before `leave`, and between which distances? */
bool csg_hits_box(const csg_traversal *w, const pov_box *b, double *enter, double *leave);
/* Where the ray enters and leaves the boxes of few members. */
void csg_enter_few(const csg_traversal *w, const csg_few *few, double *enter, double *leave);
/* Begin at the start of the ray, and afterwards clear what members remember. */
void csg_traversal_begin(csg_traversal *w, const pov_hits *hits, bool exact);
void csg_traversal_end(csg_traversal *w);
/* Test members until the next crossing lies before all that are left. */
void csg_test_ahead(csg_traversal *w);
/* A member is entered or left: update the nodes above it, up to the first whose value stays. */
void csg_toggle(csg_traversal *w, uint32_t member);

/* The number of a member by its name. */
static inline uint32_t csg_which(const csg_traversal *w, uint32_t name)
{
    return name - w->scratch->names - w->tree->members[0].leaf;
}

static inline const csg_member *csg_member_at(const csg_traversal *w, const pov_crossing *at)
{
    return &w->tree->members[csg_which(w, at->owner)];
}

/* The name by which a ray leaves a member that it starts on: of members that are one surface it knows one. */
uint32_t csg_name_of(const csg_traversal *w, const csg_member *m);
/* Cosine between the ray and the normal, times the length of the direction. */
double csg_slope(const csg_traversal *w, const pov_crossing *at);
/* Report a crossing of a member as one of the tree. False: nothing more is wanted. */
bool csg_report(const pov_crossing *at, bool enters, pov_hits *hits);
/* Merge the crossings from `first` on into those from `least` on. */
void csg_put_in_order(csg_traversal *w, uint32_t first, uint32_t least);
/* Pass the crossings that are found, in order, and report those of the tree. False: doubles are not sufficient; `*more`: more is wanted. */
bool csg_pass(csg_traversal *w, pov_hits *hits, bool exact, bool *more);
/* The grow function of crossings that have all the room they need. */
bool csg_no_more(pov_hits *hits);
/* The first crossing of a tree that has them, for hits that want no more. False: doubles were not sufficient; nothing is
 * reported. */
bool csg_chords_first(csg_traversal *w, pov_hits *hits);
/* The same of a surface that convex solids clip. */
bool csg_clipped_first(csg_traversal *w, pov_hits *hits);
/* The same of up to so many rays, where the clips have an outline and the surface takes several. Returns those that are open, a bit each. */
enum { CSG_CLIPPED_MANY = 8 };
uint32_t csg_clipped_many(const csg_tree *t, const pov_ray *const *rays, pov_hits *const *hits, uint32_t n);
/* Do nothing but hollows clip the surface, and has it an inside? The same of one ray, with ends of hollows that are off by less than `off`. False:
 * open. */
bool csg_is_hollowed(const csg_tree *t);
bool csg_hollows_first(const csg_traversal *w, const double *in, const double *out, double off, pov_hits *hits);
/* The same where the clips have an outline, which is asked where the ray crosses the surface. */
bool csg_hollowed_first(const csg_traversal *w, pov_hits *hits);
/* Of n candidates of such a tree, those that do not certainly pass its surface. */
uint32_t csg_clipped_narrow(const csg_tree *t, const pov_rays *rays, pov_candidate *io, uint32_t n);
typedef enum csg_found { CSG_NOTHING, CSG_CROSSED, CSG_OPEN } csg_found;
typedef struct csg_first {
    uint32_t column;
    bool enters, inward;         /* the member; the tree */
    double t, off;               /* about where, and by how much less than this that may be off */
} csg_first;
/* Report it, of a tree that has an outline. False: its member does not have it, as far as doubles tell. */
bool csg_chords_report(csg_traversal *w, const csg_first *f, pov_hits *hits);
/* The column of an outline that the ray starts on, or CSG_COLUMNS. */
uint32_t csg_outline_column(const csg_traversal *w);
/* Where any crossing will do, and one certainly lies before the end, its distance need not be known. */
static inline bool csg_first_is_enough(const csg_first *f, const pov_hits *hits)
{
    return hits->want == POV_WANT_ANY && f->t + f->off < hits->tmax - hits->slack;
}

/* Crossings are where an outline has them within half of this, in units of the tree's size. */
#define CSG_OUTLINE_MARGIN 0x1p-20
/* A ray in these units, and by column where it crosses: infinity and minus infinity if it does not. The ray is inside between the two,
 * or else, where a bit of `outside` is set. */
typedef struct csg_intervals {
    double start, per_unit;      /* a distance of the ray is (place - start) per_unit */
    double from;                 /* of a tree without a box: how far the ray's start is from the middle, and more than one; else one */
    uint32_t outside;
    double in[CSG_COLUMNS], out[CSG_COLUMNS];
} csg_intervals;
/* False: open. */
bool csg_outline_cross(const csg_outline *of, const pov_ray *ray, csg_intervals *out);
/* Of what is in all factors and in no other column, of which each holds the ray between two places at most: which crossing is the first that is
 * not beyond `most`? The intervals change. `from`: the column that the ray starts on, or CSG_COLUMNS. */
csg_found csg_outline_first(const csg_outline *by, csg_intervals *of, uint32_t from, double most, csg_first *out);
/* What all columns of clips have in common: the first interval. Behind it those of hollows, one after the other. */
bool csg_outline_common(const csg_outline *of, uint32_t hollows, const pov_ray *ray, csg_intervals *out);
/* By how much less than this the ends of these, as distances, are off; infinity if that is not known. */
static inline double csg_margin(const csg_outline *of, const csg_intervals *k)
{
    const double off = CSG_OUTLINE_MARGIN * k->per_unit;

    return of->endless ? off * (k->from + pov_max(fabs(k->in[0]), fabs(k->out[0]))) : off;
}
/* Is the tree what all of its columns have in common, all of them seen? Without members that are absent nothing may be. */
static inline bool csg_is_common(const csg_tree *t)
{
    const csg_outline *of = t->outline;

    return of->count == t->member_count && of->within == (1u << of->count) - 1 && !of->hidden;
}
/* As csg_chords_first() of any tree with an outline of its own; all crossings, for hits that want these. exact: in double-double. False: some may
 * have been reported. */
bool csg_sweep(csg_traversal *w, pov_hits *hits, bool exact);
/* Ask a member for its crossings, and count that. */
void csg_intersect_member(const csg_traversal *w, const csg_member *m, pov_hits *found);
/* Is a crossing that was found in double-double in the place that the ray starts from, and so behind it? */
bool csg_is_behind(const csg_traversal *w, const pov_crossing *at);
/* Distance from a crossing at t to the points at which open members are tested: less than to the crossings before and after it. */
double csg_open_step(const csg_traversal *w, double t, double before, double after);
/* Is a point of the ray inside a member? */
bool csg_member_holds(const csg_traversal *w, const csg_member *m, double t);

#endif
