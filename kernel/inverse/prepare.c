/* Before a design: its options, what it may be asked for, the direction of feed. */
#include "inverse/prepare.h"

#include <stddef.h>

#include "base/fail.h"
#include "base/numbers.h"
#include "inverse/curves.h"

wcut_design_options wcut_design_options_default(void) {
    return (wcut_design_options){.feed = WCUT_DESIGN_FEED_AUTO,
                                 .free_edges = 1,
                                 .tolerance = 0.01,
                                 .angle_max = WCUT_PI / 3,
                                 .unknowns_max = 24,
                                 .threads = 1};
}

wcut_status wcut_design_check(const wcut_design_target *target, const wcut_job *job, const wcut_design_options *o,
                              const void *out, wcut_error *error) {
    /* the arguments, the options, the block, the process */
    if (!target || !job || !out) return wcut_fail(error, WCUT_BAD_ARGUMENT, "a target, a job and a place are expected");
    if ((unsigned)o->feed > WCUT_DESIGN_FEED_MINUS_X || !(o->tolerance >= 0 && isfinite(o->tolerance)) ||
        !(o->angle_max > 0 && o->angle_max < WCUT_PI / 2) || o->unknowns_max < 6 || o->unknowns_max > WCUT_KNOTS_MAX ||
        o->threads < 1)
        return wcut_fail(
            error, WCUT_BAD_ARGUMENT,
            "options: a known feed, a tolerance of 0 or more, an angle in 0 .. 90 deg, 6 to %d coefficients "
            "and 1 thread or more are expected",
            WCUT_KNOTS_MAX);
    if (job->block_size.x != target->block.x || job->block_size.y != target->block.y ||
        job->block_size.z != target->block.z)
        return wcut_fail(error, WCUT_BAD_ARGUMENT,
                         "block.size_mm: found %g x %g x %g, expected that of the target, %g x %g "
                         "x %g",
                         job->block_size.x, job->block_size.y, job->block_size.z, target->block.x, target->block.y,
                         target->block.z);
    if (!is_positive(job->wire_diameter) || !is_positive(job->heat) || !is_positive(job->tension) ||
        !is_positive(job->force_law.a) || !is_positive(job->force_law.b) || !is_positive(job->speed_max) ||
        !(job->speed_min > 0 && job->speed_min < job->speed_max) || job->nodes < 5 || job->stations < 5 ||
        job->nodes > 2000 || job->stations > 20000)
        return wcut_fail(
            error, WCUT_BAD_ARGUMENT,
            "the job: a positive wire diameter, heat, tension, force law and speeds, 5 to 2000 nodes and 5 to "
            "20000 stations are expected");
    return WCUT_OK;
}

/* the feed of the lowest prediction, or the one that is asked for */
wcut_status wcut_design_choose_feed(const wcut_design_target *target, const wcut_design_options *o, double rms[5],
                                    wcut_design_feed *feed) {
    double lowest = HUGE_VAL;
    for (int f = WCUT_DESIGN_FEED_PLUS_Y; f <= WCUT_DESIGN_FEED_MINUS_X; f++) {
        rms[f] = HUGE_VAL;
        if (o->feed != WCUT_DESIGN_FEED_AUTO && o->feed != (wcut_design_feed)f) continue;
        wcut_design_target *turned = NULL;
        wcut_scan scan = {0};
        wcut_status status = wcut_design_target_turn(target, (wcut_design_feed)f, &turned);
        if (status == WCUT_OK) status = wcut_scan_create(turned, o->free_edges != 0, o->angle_max, &scan);
        if (status == WCUT_OK) rms[f] = scan.rms;
        wcut_scan_clear(&scan);
        wcut_design_target_destroy(turned);
        if (status != WCUT_OK) return status;
        if (rms[f] < 0.98 * lowest) lowest = rms[f], *feed = (wcut_design_feed)f;
    }
    return WCUT_OK;
}
