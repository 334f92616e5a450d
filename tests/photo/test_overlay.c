/* Rills beside wires: a flat face whose rills have another bow than the wires, in closed form. */
#include <string.h>

#include "photo/views.h"

static wcut_camera above(void) {
    return camera_at((wcut_vec3){120, -60, 420}, (wcut_vec3){100, 80, 40}, 900, 700, 540, -0.05, 0);
}

static void forget_history(wcut_history *h) { wcut_history_destroy(h); }

static wcut_overlay *overlay_of(double bow, double amplitude, const wcut_overlay_options *options) {
    const wcut_camera c = above();
    wcut_history *h = flat_history();
    wcut_picture *p = flat_photo(&c, bow, amplitude);
    wcut_overlay *o = NULL;
    wcut_error error = {0};
    ck_assert_msg(wcut_overlay_create(FLAT_BLOCK, h, &c, NULL, p, options, NULL, NULL, &o, &error) == WCUT_OK, "%s",
                  error.text);
    wcut_picture_destroy(p);
    forget_history(h);
    return o;
}

TEST(rills_along_the_wire_show_no_difference) {
    wcut_overlay *o = overlay_of(FLAT_BOW, 12, NULL);
    ck_assert_double_gt(o->covered, 0.99);
    ck_assert_double_gt(o->readable_share, 0.9);
    ck_assert_int_eq(o->differing, 0);
    ck_assert_int_eq(o->curve_count, wcut_overlay_options_default().curves);
    const wcut_rill_phase *steady = &o->phase[WCUT_PHASE_STEADY];
    ck_assert_int_gt(steady->readable, 20);
    ck_assert_double_lt(fabs(steady->median), 0.2 * 3.1416 / 180);
    wcut_overlay_destroy(o);
}

TEST(another_bow_is_measured_with_its_sign_and_size) {
    /* rills bend 3e-4 / mm more: over 180 mm between the outer patches that is 3e-4 * 90^2 = 2.43 mm */
    const double more = 3e-4;
    wcut_overlay *o = overlay_of(FLAT_BOW + more, 12, NULL);
    int measured = 0;
    ck_assert_int_gt(o->differing, o->curve_count / 2);
    for (int k = 0; k < o->curve_count; k++) {
        const wcut_rill_curve *c = &o->curve[k];
        if (c->readable < 10) continue;
        measured++;
        double mean = 0, place = 0;
        int n = 0;
        for (int i = 0; i < c->count; i++)
            if (c->node[i].readable) mean += more * pow(c->node[i].place.x - 100, 2), place = c->node[i].place.x, n++;
        mean /= n;
        ck_assert_double_gt(place, 0);

        /* at each node within its interval of 4 standard deviations, and within a fifth of the whole */
        for (int i = 0; i < c->count; i++) {
            if (!c->node[i].readable) continue;
            const double truth = more * pow(c->node[i].place.x - 100, 2) - mean;
            ck_assert_double_le(fabs(c->node[i].deviation - truth), 4 * c->node[i].sigma);
            ck_assert_double_le(fabs(c->node[i].deviation - truth), 0.2 * 2.43);
        }
    }
    ck_assert_int_ge(measured, 10);
    wcut_overlay_destroy(o);
}

TEST(slowly_changing_light_is_not_read) {
    wcut_overlay *o = overlay_of(FLAT_BOW, 0, NULL);
    ck_assert_double_gt(o->covered, 0.99);
    ck_assert_int_eq(o->readable, 0);
    ck_assert_int_eq(o->differing, 0);
    for (int k = 0; k < o->curve_count; k++) ck_assert_int_eq(o->curve[k].readable, 0);
    wcut_overlay_destroy(o);
}

TEST(the_number_of_threads_changes_nothing) {
    wcut_overlay_options options = wcut_overlay_options_default();
    wcut_overlay *one = overlay_of(FLAT_BOW, 12, &options);
    options.threads = 3;
    wcut_overlay *three = overlay_of(FLAT_BOW, 12, &options);
    const size_t pixels = (size_t)one->rectified->width * one->rectified->height * 4;
    ck_assert_int_eq(one->rectified->width, three->rectified->width);
    ck_assert_int_eq(memcmp(one->rectified->pixel, three->rectified->pixel, pixels), 0);
    ck_assert_int_eq(memcmp(one->patch, three->patch, (size_t)one->columns * one->rows * sizeof *one->patch), 0);
    wcut_overlay_destroy(one);
    wcut_overlay_destroy(three);
}

TEST(the_rectified_picture_puts_a_mark_where_it_is) {
    /* a black spot of 3 mm around (60, 110) in an even picture */
    const wcut_camera c = above();
    wcut_history *h = flat_history();
    wcut_picture *p = flat_photo(&c, FLAT_BOW, 0);
    const wcut_photo_point mark = seen_by(&c, (wcut_vec3){60, 110, FLAT_HEIGHT});
    for (int v = -3; v <= 3; v++)
        for (int u = -3; u <= 3; u++) p->pixel[((int)(mark.v + 0.5) + v) * p->width + (int)(mark.u + 0.5) + u] = 0;
    wcut_overlay *o = NULL;
    ck_assert_int_eq(wcut_overlay_create(FLAT_BLOCK, h, &c, NULL, p, NULL, NULL, NULL, &o, NULL), WCUT_OK);
    double x = 0, y = 0, n = 0;
    for (int r = 0; r < o->rectified->height; r++)
        for (int k = 0; k < o->rectified->width; k++) {
            const unsigned char *at = o->rectified->pixel + ((size_t)r * o->rectified->width + k) * 4;
            if (!at[3] || at[0] > 40) continue;
            x += (k + 0.5) * o->resolution, y += FLAT_BLOCK.y - (r + 0.5) * o->resolution, n += 1;
        }
    ck_assert_double_gt(n, 0);
    ck_assert_double_eq_tol(x / n, 60, 0.3);
    ck_assert_double_eq_tol(y / n, 110, 0.3);
    wcut_overlay_destroy(o);
    wcut_picture_destroy(p);
    forget_history(h);
}

TEST(what_cannot_be_laid_over_is_refused) {
    wcut_camera c = above();
    wcut_history *h = flat_history();
    wcut_picture *p = flat_photo(&c, FLAT_BOW, 0);
    wcut_overlay *o = NULL;
    wcut_error error = {0};

    /* the other half, a camera that sees nothing, a picture of another size, a cut beside the block */
    wcut_overlay_options options = wcut_overlay_options_default();
    options.upper = true;
    ck_assert_int_eq(wcut_overlay_create(FLAT_BLOCK, h, &c, NULL, p, &options, NULL, NULL, &o, &error),
                     WCUT_DEGENERATE);
    ck_assert_ptr_nonnull(strstr(error.text, "mirrored"));
    const wcut_camera away = camera_at((wcut_vec3){120, -60, 420}, (wcut_vec3){100, -900, 400}, 900, 700, 540, 0, 0);
    ck_assert_int_eq(wcut_overlay_create(FLAT_BLOCK, h, &away, NULL, p, NULL, NULL, NULL, &o, &error), WCUT_DEGENERATE);
    c.width--;
    ck_assert_int_eq(wcut_overlay_create(FLAT_BLOCK, h, &c, NULL, p, NULL, NULL, NULL, &o, &error), WCUT_BAD_ARGUMENT);
    c.width++;
    ck_assert_int_eq(wcut_overlay_create((wcut_vec3){200, 160, 30}, h, &c, NULL, p, NULL, NULL, NULL, &o, &error),
                     WCUT_DEGENERATE);
    ck_assert_ptr_null(o);
    wcut_picture_destroy(p);
    forget_history(h);
}

static int stop_at_once(int station, int stations, void *context) {
    (void)station, (void)stations;
    return ++*(int *)context;
}

TEST(a_stop_and_a_failed_allocation_leave_nothing) {
    const wcut_camera c = above();
    wcut_history *h = flat_history();
    wcut_picture *p = flat_photo(&c, FLAT_BOW, 12);
    wcut_overlay *o = NULL;
    int calls = 0;
    ck_assert_int_eq(wcut_overlay_create(FLAT_BLOCK, h, &c, NULL, p, NULL, stop_at_once, &calls, &o, NULL),
                     WCUT_INTERRUPTED);
    ck_assert_int_eq(calls, 1);
    ck_assert_ptr_null(o);

    /* two patches, so that the allocations are few */
    wcut_overlay_options options = wcut_overlay_options_default();
    options.patch = 100, options.resolution = 1, options.curves = 2;
    EACH_FAILED_ALLOCATION(wcut_overlay_create(FLAT_BLOCK, h, &c, NULL, p, &options, NULL, NULL, &o, NULL), o == NULL);
    wcut_overlay_destroy(o);
    wcut_picture_destroy(p);
    forget_history(h);
}

TEST(wires_are_drawn_where_they_are) {
    const wcut_camera c = above();
    wcut_history *h = flat_history();
    wcut_picture *photo = flat_photo(&c, FLAT_BOW, 0), *drawn = NULL, *over = NULL, *details = NULL;
    wcut_overlay *o = NULL;
    ck_assert_int_eq(wcut_overlay_create(FLAT_BLOCK, h, &c, NULL, photo, NULL, NULL, NULL, &o, NULL), WCUT_OK);
    ck_assert_int_eq(wcut_overlay_draw(o, FLAT_BLOCK, h, NULL, &drawn), WCUT_OK);
    ck_assert_int_eq(wcut_overlay_draw_photo(o, FLAT_BLOCK, h, NULL, &c, photo, &over), WCUT_OK);
    ck_assert_int_eq(wcut_overlay_details(o, FLAT_BLOCK, h, drawn, 60, &details), WCUT_OK);
    ck_assert_int_eq(details->width, 3 * details->height + 2 * 8);

    /* a grey face becomes coloured on a wire, from above and in perspective */
    const wcut_vec3 on = h->position[(size_t)o->curve[10].station * h->nodes + 20];
    const int column = (int)(on.x / o->resolution), row = (int)((FLAT_BLOCK.y - on.y) / o->resolution);
    const unsigned char *a = drawn->pixel + ((size_t)row * drawn->width + column) * 4;
    ck_assert_int_gt(abs(a[0] - a[2]), 30);
    const wcut_photo_point seen = seen_by(&c, on);
    const unsigned char *b = over->pixel + ((size_t)(seen.v + 0.5) * over->width + (size_t)(seen.u + 0.5)) * 3;
    ck_assert_int_gt(abs(b[0] - b[2]), 30);
    wcut_picture_destroy(details);
    wcut_picture_destroy(over);
    wcut_picture_destroy(drawn);
    wcut_overlay_destroy(o);
    wcut_picture_destroy(photo);
    forget_history(h);
}
