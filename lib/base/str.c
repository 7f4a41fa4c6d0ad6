#include "base/str.h"

#include <string.h>
#include <strings.h>

enum { LONGEST = 32 };

static int smaller(int a, int b)
{
    return a < b ? a : b;
}

/* Edits between two words of at most LONGEST letters: insertions, deletions, replacements and swaps of neighbours
 * (optimal string alignment distance), by rows. */
static int edits(const char *a, size_t m, const char *b, size_t n)
{
    int rows[3][LONGEST + 1], *two_back = rows[0], *back = rows[1], *row = rows[2], *t;
    size_t i, j;

    for (j = 0; j <= n; j++) {
        two_back[j] = 0;
        back[j] = (int)j;
    }
    for (i = 1; i <= m; i++) {
        row[0] = (int)i;
        for (j = 1; j <= n; j++) {
            row[j] = back[j - 1] + (a[i - 1] != b[j - 1]);
            row[j] = smaller(row[j], smaller(back[j], row[j - 1]) + 1);
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                row[j] = smaller(row[j], two_back[j - 2] + 1);
        }
        t = two_back;
        two_back = back;
        back = row;
        row = t;
    }
    return back[n];
}

void str_nearer(const char *word, const char *candidate, const char **best, int *best_edits)
{
    size_t m = strlen(word), n = strlen(candidate);
    bool is_case;
    int distance;

    if (m > LONGEST || n > LONGEST)
        return;
    /* One edit in three letters is a typing error; more makes another word. All in capitals is one. */
    is_case = strcasecmp(word, candidate) == 0;
    distance = is_case ? 1 : edits(word, m, candidate, n);
    if ((!is_case && 3 * (size_t)distance > (m > n ? m : n)) || (*best && distance >= *best_edits))
        return;
    *best = candidate;
    *best_edits = distance;
}

void str_copy(char *dst, size_t size, const char *src)
{
    size_t n = strlen(src);

    if (n >= size)
        n = size - 1;
    memcpy(dst, src, n);
    dst[n] = '\0';
}
