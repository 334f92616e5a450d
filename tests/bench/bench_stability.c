/* The picture of kernel/stability.svg: where the tension loop is stable, over gain and delay; and why it acts on the
   slowness.   bench_stability [PICTURE.svg]
   The plant is the wire's own: its shape does not change with its speed, so that its tension follows the foam's force
   at once, ln T = ln k + s/v0 - s/v; between them a delay, the mounts' lag and the sensor's sampling. The loop is the
   real controller. Gain: both of the defaults multiplied by one number. A cell is stable when a step of 10 % in the
   foam's density dies out; the colour is the time until it stays within 1 %. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <wirecut/control.h>

enum { STATIONS = 100, COLUMNS = 41, ROWS = 41, RING = 1024 };

#define PERIOD 0.01  /* [s] */
#define LAG 0.05     /* [s] */
#define HORIZON 40.0 /* [s] */

static wcut_history_row row[STATIONS];
static wcut_history plan;
static const wcut_job job = {.tension = 2, .heat = 60, .force_law = {0.1, 8.6e-4}, .speed_min = 0.1, .speed_max = 100};

static void make_plan(double speed) {
    for (int j = 0; j < STATIONS; j++)
        row[j] = (wcut_history_row){.time = 4 / speed * j,
                                    .duration = j ? 4 / speed : 0,
                                    .speed_a = speed,
                                    .speed_b = speed,
                                    .tension_a = 2,
                                    .tension_b = 2,
                                    .phase = WCUT_PHASE_STEADY};
    plan = (wcut_history){.stations = STATIONS, .planned = STATIONS, .nodes = 3, .row = row};
}

/* how long after the step [s] the tension stays within 1 %; INFINITY where it does not */
static double settle(const wcut_control_settings *settings, double delay, double speed0) {
    wcut_control *control = NULL;
    if (wcut_control_create(settings, &plan, &control, NULL) != WCUT_OK) exit(1);
    const int late = (int)(delay / PERIOD + 0.5);
    const double s = settings->exponent_speed;
    double ring[RING], speed = speed0, command = 0, last = 0;
    for (int i = 0; i < RING; i++) ring[i] = 2;
    for (long i = 0; (double)i * PERIOD < 2 * HORIZON; i++) {
        const double time = (double)i * PERIOD, density = time > HORIZON ? 1.1 : 1;
        speed += (command - speed) * PERIOD / (LAG + PERIOD);
        const double tension = speed > 0.05 ? 2 * density * exp(s / speed0 - s / speed) : 0;
        ring[i % RING] = tension;
        const double read = ring[(i - late + RING) % RING] + 1e-9 * (double)(i % 7);
        wcut_control_step(control, time, 50, read, read, &command);
        if (time > HORIZON && fabs(tension / 2 - 1) > 0.01) last = time - HORIZON;
    }
    wcut_control_destroy(control);
    return last > HORIZON - 1 ? INFINITY : last;
}

/* ---- the picture ---- */

static double gain_of(int column) { return pow(10, -1 + 2.0 * column / (COLUMNS - 1)); } /* 0.1 .. 10 */
static double delay_of(int line) { return 0.5 * line / (ROWS - 1); }                     /* 0 .. 0.5 s */

static void draw(FILE *out, double time[ROWS][COLUMNS]) {
    const int cell = 12, left = 70, top = 40, width = COLUMNS * cell, height = ROWS * cell;
    fprintf(out,
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %d %d\" font-family=\"sans-serif\" "
            "font-size=\"13\">\n<rect width=\"100%%\" height=\"100%%\" fill=\"#fff\"/>\n",
            left + width + 30, top + height + 100);
    fprintf(out, "<text x=\"%d\" y=\"24\" font-size=\"15\">Stability of the tension loop over gain and delay</text>\n",
            left);
    for (int i = 0; i < ROWS; i++)
        for (int j = 0; j < COLUMNS; j++) {
            const double t = time[ROWS - 1 - i][j], share = fmin(1, log1p(t) / log1p(20));
            const int red = (int)(20 + 200 * share), green = (int)(110 + 110 * share), blue = (int)(170 + 70 * share);
            char colour[8] = "#d9d2c5";
            if (!isinf(t)) snprintf(colour, sizeof colour, "#%02x%02x%02x", red & 255, green & 255, blue & 255);
            fprintf(out, "<path fill=\"%s\" d=\"M%d %dh%dv%dh-%dz\"/>\n", colour, left + j * cell, top + i * cell, cell,
                    cell, cell);
        }
    const double x = left + (COLUMNS - 1) / 2.0 * cell + 0.5 * cell,
                 y = top + height - (0.05 / 0.5 * (ROWS - 1) + 0.5) * cell;
    fprintf(out,
            "<circle cx=\"%.1f\" cy=\"%.1f\" r=\"6\" fill=\"none\" stroke=\"#b3261e\" stroke-width=\"2.5\"/>\n"
            "<text x=\"%.1f\" y=\"%.1f\" fill=\"#fff\">defaults</text>\n",
            x, y, x + 10, y - 8);
    for (int k = 0; k <= 4; k++) {
        const double share = k / 4.0;
        fprintf(out, "<text x=\"%.1f\" y=\"%d\" text-anchor=\"middle\">%.3g</text>\n",
                left + (share * (COLUMNS - 1) + 0.5) * cell, top + height + 18, pow(10, -1 + 2 * share));
        fprintf(out, "<text x=\"%d\" y=\"%.1f\" text-anchor=\"end\">%.3g</text>\n", left - 8,
                top + height - (share * (ROWS - 1) + 0.5) * cell + 5, 0.5 * share);
    }
    fprintf(out,
            "<text x=\"%d\" y=\"%d\" text-anchor=\"middle\">both gains over the defaults (0.3 and 1.5 1/s)</text>\n",
            left + width / 2, top + height + 38);
    fprintf(out,
            "<text transform=\"translate(20 %d) rotate(-90)\" text-anchor=\"middle\">delay of the reading [s]</text>\n",
            top + height / 2);
    fprintf(out,
            "<text x=\"%d\" y=\"%d\">Colour: time until a density step of 10 %% is within 1 %% (dark: soon);</text>\n"
            "<text x=\"%d\" y=\"%d\">grey: it never is. Filter 0.1 s, lag of the mounts 0.05 s, loop 100 "
            "Hz.</text>\n</svg>\n",
            left, top + height + 62, left, top + height + 80);
}

/* ---- why the slowness ---- */

/* the change of ln T for a unit of what a controller may act on: how the loop's gain changes with the speed */
static void compare_actions(void) {
    printf(
        "d ln T per unit of the action, over that at 20 mm/s: what one fixed gain has to bear\n"
        "  v [mm/s]   speed   log speed   slowness s/v\n");
    for (double v = 5; v <= 40; v *= 2) printf("  %8.0f %7.2f %11.2f %14.2f\n", v, 400 / (v * v), 20 / v, 1.0);
}

int main(int argc, char **argv) {
    wcut_control_settings settings = wcut_control_settings_default(&job);
    const wcut_control_settings standard = settings;
    compare_actions();
    for (double v = 5; v <= 40; v *= 2) {
        make_plan(v);
        printf("defaults at %4.0f mm/s, delay 0.05 s: within 1 %% after %.2f s\n", v, settle(&standard, 0.05, v));
    }
    make_plan(20);
    static double time[ROWS][COLUMNS];
    for (int i = 0; i < ROWS; i++)
        for (int j = 0; j < COLUMNS; j++) {
            settings.gain = gain_of(j) * standard.gain;
            settings.rate = gain_of(j) * standard.rate;
            time[i][j] = settle(&settings, delay_of(i), 20);
        }
    for (int i = 0; i < ROWS; i += 4) {
        int j = 0;
        while (j < COLUMNS && !isinf(time[i][j])) j++;
        printf("delay %.3f s: stable up to %.2f times the default gains\n", delay_of(i), j ? gain_of(j - 1) : 0);
    }
    if (argc < 2) return 0;
    FILE *out = fopen(argv[1], "w");
    if (!out) return 1;
    draw(out, time);
    return fclose(out) != 0;
}
