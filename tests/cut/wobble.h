/* How much a cut wobbles: steps that go up and down in turn, from station to station and from node to node. A smooth
   course, however steep or bent, has none. */
#ifndef WCUT_TESTS_CUT_WOBBLE_H
#define WCUT_TESTS_CUT_WOBBLE_H

#include <wirecut/history.h>

#include "base/numbers.h"

/* the least of three steps in a row where they alternate in sign, else 0 */
static inline double zigzag_of(double a, double b, double c, double d) {
    const double u = b - a, v = c - b, w = d - c;
    return u * v < 0 && v * w < 0 ? fmin(fabs(u), fmin(fabs(v), fabs(w))) : 0;
}

typedef struct wobble {
    double speed; /* [1] of the faster mount, over its speed */
    double angle; /* [rad] alpha and beta of both mounts */
    double force; /* [1] per engaged length from node to node inside the foam, over the station's largest */
} wobble;

static inline double speed_at(const wcut_history *h, int j) { return fmax(h->row[j].speed_a, h->row[j].speed_b); }

static inline double force_zigzag(const wcut_history *h, int j) {
    const double *line = h->force_line + (size_t)j * (size_t)h->nodes;
    double worst = 0, largest = 0;
    for (int i = 0; i < h->nodes; i++) largest = fmax(largest, line[i]);
    for (int i = 0; i + 3 < h->nodes; i++) /* the first and last nodes in the foam end what can alternate */
        if (line[i] > 0 && line[i + 3] > 0)
            worst = fmax(worst, zigzag_of(line[i], line[i + 1], line[i + 2], line[i + 3]));
    return largest > 0 ? worst / largest : 0;
}

/* over the stations from `skip` after first contact to where contact ends */
static inline wobble wobble_of(const wcut_history *h, int skip) {
    wobble w = {0};
    int first = 0, last = h->stations - 1;
    while (first < last && h->row[first].phase == WCUT_PHASE_APPROACH) first++;
    while (last > first && h->row[last].phase == WCUT_PHASE_LEFT) last--;
    for (int j = first + skip; j + 4 <= last; j++) {
        const wcut_history_row *r = h->row + j;
        w.speed = fmax(w.speed, zigzag_of(speed_at(h, j), speed_at(h, j + 1), speed_at(h, j + 2), speed_at(h, j + 3)) /
                                    speed_at(h, j));
        w.angle = fmax(w.angle, zigzag_of(r[0].alpha_a, r[1].alpha_a, r[2].alpha_a, r[3].alpha_a));
        w.angle = fmax(w.angle, zigzag_of(r[0].alpha_b, r[1].alpha_b, r[2].alpha_b, r[3].alpha_b));
        w.angle = fmax(w.angle, zigzag_of(r[0].beta_a, r[1].beta_a, r[2].beta_a, r[3].beta_a));
        w.angle = fmax(w.angle, zigzag_of(r[0].beta_b, r[1].beta_b, r[2].beta_b, r[3].beta_b));
        w.force = fmax(w.force, force_zigzag(h, j));
    }
    return w;
}

#endif
