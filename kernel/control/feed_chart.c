/* The feed chart of a bow: largest steady feeds at which the wire bows by so much, in closed form.

   A foam of width W in the middle of the distance d of the wire's ends, with the load F per width: beside it the wire is
   straight, in it a parabola. With the pull H and tails g = (d - W) / 2 the middle is b = F W (g + W / 4) / (2 H) behind
   the ends, so that b fixes the shape; the wire's natural length then fixes H, H fixes F, and (2) the speed. */
#include "control/feed_chart.h"

#include "base/numbers.h"
#include "control/robot_limits.h"

static const double bow_limit[WCUT_FEED_CHART_BOWS] = {0.5, 1, 2};

const double *wcut_feed_chart_bows(void) { return bow_limit; }

typedef struct shape {
    double width, tail; /* [mm] W, g */
    double turn;        /* [1/mm] F / H */
} shape;

/* shape of a wire that bows by b */
static shape chart_shape_of(double distance, double width, double b) {
    const double w = fmin(width, distance), tail = (distance - w) / 2;
    return (shape){w, tail, 2 * b / (w * (tail + w / 4))};
}

/* natural length of a wire of this shape under the pull H: the sum of ds / (1 + H ds/dx / EA), Simpson's rule in the foam */
static double natural_of(const shape *s, double pull, double softness) {
    enum { N = 32 };
    double sum = 0;
    for (int k = 0; k <= N; k++) {
        const double stretch = hypot(1, s->turn * s->width * ((double)k / N - 0.5));
        sum += (k == 0 || k == N ? 1 : k % 2 ? 4 : 2) * stretch / (1 + pull * softness * stretch);
    }
    const double beside = hypot(1, s->turn * s->width / 2);
    return sum * s->width / (3 * N) + 2 * s->tail * beside / (1 + pull * softness * beside);
}

/* by how much the wire of `rest` mm is too short to hang by b under the pull H, whose frame is closed by it */
static double missing_at(const wcut_bow *bow, double width, double b, double rest, double pull) {
    const double distance = bow->distance - bow->give * (pull - bow->pretension);
    if (!(distance > b)) return -rest;
    const shape s = chart_shape_of(distance, width, b);
    return natural_of(&s, pull, bow->softness) - rest;
}

/* the pull at which it fits: the more pull, the closer the ends and the longer the wire; 0 where it is too long already */
static double pull_of(const wcut_bow *bow, double width, double b, double rest) {
    double low = 0, high = bow->pretension + 1;
    double at_low = missing_at(bow, width, b, rest, low), at_high = missing_at(bow, width, b, rest, high);
    if (!(at_low > 0)) return 0;
    while (at_high > 0 && high < 1e9)
        low = high, at_low = at_high, high *= 2, at_high = missing_at(bow, width, b, rest, high);

    /* the secant, kept inside its bracket (Illinois) */
    for (int k = 0, side = 0; k < 100 && high - low > 1e-13 * high; k++) {
        const double pull = (low * at_high - high * at_low) / (at_high - at_low);
        const double missing = missing_at(bow, width, b, rest, pull);
        if (fabs(missing) <= 1e-14 * rest) return pull;
        if (missing > 0) {
            low = pull, at_low = missing;
            if (side > 0) at_high /= 2;
            side = 1;
        } else {
            high = pull, at_high = missing;
            if (side < 0) at_low /= 2;
            side = -1;
        }
    }
    return (low + high) / 2;
}

/* a wire that bows by b at a heat: its feed and tension, the heat of the wire in the foam following the feed */
static void chart_one(const wcut_setup *setup, double width, double heat, double b, double *feed, double *tension) {
    const wcut_bow *bow = &setup->bow;
    const wcut_job *job = setup->job;
    const double share = fmin(width / bow->distance, 1);
    double speed = job->speed_max, pull = 0;
    for (int k = 0; k < 60; k++) {
        double air, foam;
        wcut_bow_warm(bow, job, heat, speed, &air, &foam);
        pull = pull_of(bow, width, b, bow->natural * (1 + share * foam + (1 - share) * air));
        const double load = chart_shape_of(bow->distance - bow->give * (pull - bow->pretension), width, b).turn * pull;

        /* (2) inverted; foam that never resists so much sets no limit */
        double next = 0;
        if (load >= job->force_law.a)
            next = job->speed_max;
        else if (load > 0)
            next = fmin(1000 * job->force_law.b * heat / log(job->force_law.a / load), job->speed_max);
        const bool settled = fabs(next - speed) <= 1e-10 * job->speed_max;
        speed = next;
        if (settled) break;
    }
    *feed = speed;
    *tension = pull * hypot(1, chart_shape_of(bow->distance, width, b).turn * fmin(width, bow->distance) / 2);
}

/* the feed, or the one at which the wire that bows less is pulled as much as it bears; 0 where that is less than nothing */
static double allowed_feed(const wcut_setup *setup, double width, const wcut_feed_chart_row *row, int b) {
    double low = 0, high = bow_limit[b], feed, tension, allowed = 0;
    if (row->tension[b] <= row->strength) return row->feed[b];
    for (int k = 0; k < 20; k++) {
        const double middle = (low + high) / 2;
        chart_one(setup, width, row->heat, middle, &feed, &tension);
        if (tension <= row->strength)
            low = middle, allowed = feed;
        else
            high = middle;
    }
    return allowed;
}

wcut_status wcut_feed_chart_fill(const wcut_setup *setup, double width, const wcut_robot_limits *limits,
                                 wcut_feed_chart_row *chart) {
    wcut_job job = *setup->job; /* borrowed arrays: only its heat is another one */
    const double section = WCUT_PI / 4 * job.wire_diameter * job.wire_diameter;
    for (int k = 0; k < WCUT_FEED_CHART_HEATS; k++) {
        wcut_feed_chart_row row = {.heat = setup->job->heat * (5 + k) / 10};
        job.heat = row.heat;
        if (!wcut_limits_wire(&job, limits, &row.temperature, &row.strength)) return WCUT_BAD_ARGUMENT;
        row.strength *= section;
        row.too_hot = row.temperature > limits->temperature;
        for (int b = 0; b < WCUT_FEED_CHART_BOWS; b++) {
            chart_one(setup, width, row.heat, bow_limit[b], &row.feed[b], &row.tension[b]);
            const bool pulled = row.feed[b] > 0;
            row.kerf[b] = job.kerf_width + (pulled ? job.kerf_per_q * 1000 * row.heat / row.feed[b] : 0);
            if (pulled && !row.too_hot) row.allowed[b] = allowed_feed(setup, width, &row, b);
        }
        chart[k] = row;
    }
    return WCUT_OK;
}
