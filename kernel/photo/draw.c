/* Smooth lines: each pixel near the line takes the share of colour that the line covers of it. */
#include "photo/draw.h"

#include <math.h>
#include <stddef.h>

#include "base/numbers.h"

static void blend(unsigned char *to, int channels, wcut_colour colour, double share) {
    const unsigned char value[3] = {colour.red, colour.green, colour.blue};
    for (int k = 0; k < 3; k++) to[k] = (unsigned char)(to[k] + share * (value[k] - to[k]) + 0.5);
    if (channels == 4) to[3] = (unsigned char)(to[3] + share * (255 - to[3]) + 0.5);
}

void wcut_draw_line(wcut_picture *p, double u0, double v0, double u1, double v1, double width, wcut_colour colour) {
    const double reach = width / 2 + 0.5, du = u1 - u0, dv = v1 - v0, square = du * du + dv * dv;
    if (!isfinite(square) || p->channels < 3) return;

    /* the part of the bounding box that is in the picture */
    const double left = floor(fmin(u0, u1) - reach), right = ceil(fmax(u0, u1) + reach),
                 top = floor(fmin(v0, v1) - reach), bottom = ceil(fmax(v0, v1) + reach);
    if (right < 0 || bottom < 0 || left > p->width - 1 || top > p->height - 1) return;
    const int i0 = (int)fmax(left, 0), i1 = (int)fmin(right, p->width - 1), j0 = (int)fmax(top, 0),
              j1 = (int)fmin(bottom, p->height - 1);
    for (int j = j0; j <= j1; j++) {
        for (int i = i0; i <= i1; i++) {
            /* distance of the pixel from the line's nearest point */
            const double t = square > 0 ? clamp(((i - u0) * du + (j - v0) * dv) / square, 0, 1) : 0;
            const double far = hypot(i - u0 - t * du, j - v0 - t * dv);
            if (far < reach)
                blend(p->pixel + ((size_t)j * p->width + i) * p->channels, p->channels, colour, fmin(reach - far, 1));
        }
    }
}

wcut_colour wcut_colour_of(double value) {
    static const wcut_colour at[] = {{48, 18, 222},  {20, 150, 240}, {30, 220, 140},
                                     {200, 230, 40}, {250, 140, 20}, {200, 20, 20}};
    enum { LAST = sizeof at / sizeof *at - 1 };
    const double place = clamp(value, 0, 1) * LAST;
    const int k = (int)fmin(place, LAST - 1);
    const double t = place - k;
    return (wcut_colour){(unsigned char)(at[k].red + t * (at[k + 1].red - at[k].red)),
                         (unsigned char)(at[k].green + t * (at[k + 1].green - at[k].green)),
                         (unsigned char)(at[k].blue + t * (at[k + 1].blue - at[k].blue))};
}

wcut_colour wcut_colour_of_phase(wcut_phase phase) {
    static const wcut_colour colour[] = {
        {150, 150, 150}, {20, 120, 240}, {20, 180, 80}, {240, 120, 20}, {150, 150, 150}};
    return colour[phase <= WCUT_PHASE_LEFT ? phase : WCUT_PHASE_LEFT];
}
