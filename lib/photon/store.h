/* store.h - the photon maps of a scene, made when they are first asked for.
 *
 * Which map a sample of a pixel asks for is a matter of the sample's number: maps of later samples have more photons, and
 * smaller discs, so that pictures converge. The samples of a pixel alternate between two halves; each half has maps of its
 * own, and the discs of the second blur even light by nothing (map.h). So what those of the first blur and what is left to
 * chance both show in the difference between the halves, by which a job estimates its error. Each seed has maps of its own.
 *
 * A map is made of chunks of emissions. All threads that ask for it trace chunks until there are none left; the photons
 * stand in the order of the chunks, so that the map does not depend on the threads. */
#ifndef PHOTON_STORE_H
#define PHOTON_STORE_H

#include "base/thread.h"
#include "photon/emission.h"
#include "photon/map.h"

/* Maps double in size up to the last level. */
enum { PHOTON_HALVES = 2, PHOTON_LEVELS = 5, PHOTON_MAPS = PHOTON_HALVES * PHOTON_LEVELS };

typedef struct photon_list { photon *items; size_t count, capacity; } photon_list;

/* Photons on surfaces, and in media. */
enum photon_place { PHOTON_ON, PHOTON_IN, PHOTON_PLACES };
typedef struct photon_catch { photon_list of[PHOTON_PLACES]; } photon_catch;
typedef struct photon_maps { photon_map of[PHOTON_PLACES]; } photon_maps;

/* Emissions first .. first + count - 1 of an aim of a map of a seed, which has `total` of them. */
typedef struct photon_chunk { const photon_aim *aim; uint32_t seed, map, first, count, total; } photon_chunk;

/* Trace a chunk of emissions, and add what arrives to `out`, whose memory is the store's. False: no memory. */
typedef bool photon_trace(void *user, const photon_chunk *chunk, photon_catch *out);
/* Is the work still wanted? */
typedef bool photon_wanted(void *user);

typedef struct photon_store photon_store;
typedef struct photon_seed photon_seed;   /* the maps of one seed */

/* The aims must outlive it. NULL: no memory. */
photon_store *photon_store_create(const env *e, const photon_aims *aims);
void photon_store_destroy(photon_store *s);
/* The map's number for the k-th sample of a pixel. */
uint32_t photon_store_number(uint32_t sample);
/* Emissions of an aim in a map. */
uint32_t photon_store_emissions(const photon_aims *aims, uint32_t number);
/* The maps of a seed, for who lets go of them later: those of a seed that nobody holds are kept until another one is
 * asked for. NULL: no memory. */
photon_seed *photon_store_hold(photon_store *s, uint32_t seed);
void photon_store_let_go(photon_store *s, photon_seed *of);
/* The maps of this number, made with the help of the caller's thread if there is none yet. NULL: no memory, or not
 * wanted. */
const photon_maps *photon_store_take(photon_store *s, photon_seed *of, uint32_t number, photon_trace *trace, photon_wanted *wanted,
                                     void *user);

#endif
