/* Force-adaptive speed control: feedforward from the simulated cut, PI feedback on the logarithm of the tension acting
   on the slowness, in which the foam's force law F = a exp(-s/v) is linear (Rust et al. 2016, 2 and 4). */
#include <wirecut/control.h>

#include "base/alloc.h"
#include "base/fail.h"
#include "base/numbers.h"

#define SPARE 0.7   /* [1] of the acceleration that the plan may use; the rest is the feedback's */
#define NO_LOAD 0.1 /* [1] of the target: with less there is nothing to steer by, and no reason to speed up */
#define LOAD 0.4    /* [1] of the target: from here on the error counts in full */
enum { STILL_MAX = 50 /* calls in a row in which time may stand still */ };

struct wcut_control {
    wcut_control_settings s;
    int stations;
    double *planned; /* stations-1 [mm/s] of the faster mount between station j and j+1 */
    double *loaded;  /* stations [1] planned tension over the target, at most 1 */
    bool begun;
    double time, period;         /* [s] of the last step, and what it took */
    double tension_a, tension_b; /* [N] the last readings */
    double faulty, repeated;     /* [s] for how long */
    int still;                   /* calls for which time has not moved */
    bool over;                   /* the last reading was above the stop */
    bool filtered;               /* the filter holds a tension */
    double integral;             /* [1] part of u */
    wcut_control_view view;
};

wcut_control_settings wcut_control_settings_default(const wcut_job *job) {
    const double k = job->tension;
    return (wcut_control_settings){.feedback = true,
                                   .tension = k,
                                   .exponent_speed = 1000 * job->force_law.b * job->heat,
                                   .gain = 0.3,
                                   .rate = 1.5,
                                   .filter = 0.1,
                                   .authority = 2,
                                   .speed_min = job->speed_min,
                                   .speed_max = job->speed_max,
                                   .acceleration = 200,
                                   .caution = 1,
                                   .margin = 10,
                                   .noise = 0.1 * k,
                                   .tension_stop = 2.5 * k,
                                   .tension_absurd = 25 * k,
                                   .fault_time = 0.5};
}

static wcut_status check_settings(const wcut_control_settings *s, wcut_error *error) {
    const struct {
        const char *name;
        double value;
        bool zero; /* is allowed */
    } number[] = {{"tension", s->tension, false},
                  {"exponent_speed", s->exponent_speed, false},
                  {"gain", s->gain, true},
                  {"rate", s->rate, true},
                  {"filter", s->filter, true},
                  {"authority", s->authority, false},
                  {"speed_min", s->speed_min, false},
                  {"speed_max", s->speed_max, false},
                  {"acceleration", s->acceleration, false},
                  {"caution", s->caution, true},
                  {"margin", s->margin, true},
                  {"noise", s->noise, true},
                  {"tension_stop", s->tension_stop, false},
                  {"tension_absurd", s->tension_absurd, false},
                  {"fault_time", s->fault_time, false}};

    /* each number is positive, or 0 where that switches something off */
    for (size_t i = 0; i < sizeof number / sizeof *number; i++)
        if (!is_positive(number[i].value) && !(number[i].zero && number[i].value == 0))
            return wcut_fail(error, WCUT_BAD_ARGUMENT, "%s: found %g, expected a number %s 0", number[i].name,
                             number[i].value, number[i].zero ? "not less than" : "greater than");

    /* the limits are in order */
    if (s->speed_min >= s->speed_max)
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "speed_min: found %g, expected less than speed_max = %g",
                         s->speed_min, s->speed_max);
    if (s->tension_stop <= s->tension || s->tension_absurd <= s->tension_stop)
        return wcut_fail(error, WCUT_BAD_ARGUMENT,
                         "tension_stop: found %g, expected more than the target %g and less than tension_absurd = %g",
                         s->tension_stop, s->tension, s->tension_absurd);

    return WCUT_OK;
}

static double faster_way(const wcut_history_row *row, int j) { /* [mm] of the faster mount from station j to j+1 */
    return fmax(row[j + 1].speed_a, row[j + 1].speed_b) * row[j + 1].duration;
}

static bool is_cut(const wcut_history_row *row, int j) { /* whether the wire is in contact from station j to j+1 */
    return row[j + 1].phase != WCUT_PHASE_APPROACH && row[j + 1].phase != WCUT_PHASE_LEFT;
}

/* The least speed at which the plan cuts within the margin of segment j, where contact begins or ends there: the load
   sets in over the whole width at once, and the block may stand a little elsewhere. */
static double speed_near_contact(const wcut_control *c, const wcut_history_row *row, int j) {
    double min = fmax(row[j + 1].speed_a, row[j + 1].speed_b);
    for (int side = -1; side <= 1; side += 2) {
        double gone = 0, slowest = min;
        bool changes = false;
        for (int i = j; i >= 0 && i < c->stations - 1 && gone <= c->s.margin; i += side) {
            changes = changes || is_cut(row, i) != is_cut(row, j);
            if (is_cut(row, i)) slowest = fmin(slowest, fmax(row[i + 1].speed_a, row[i + 1].speed_b));
            if (i != j) gone += faster_way(row, i);
        }
        if (changes) min = slowest;
    }
    return min;
}

/* the plan's speeds, slow at contact, no drop of which needs more than SPARE of the acceleration: v0^2 <= v1^2
   + 2 a d */
static bool fill_plan(wcut_control *c, const wcut_history *plan) {
    const wcut_history_row *row = plan->row;
    for (int j = 0; j < c->stations; j++) {
        const double mean = (row[j].tension_a + row[j].tension_b) / 2;
        if (!isfinite(mean)) return false;
        c->loaded[j] = clamp(mean / c->s.tension, 0, 1);
        if (j > 0 && !is_positive(faster_way(row, j - 1))) return false;
    }
    for (int j = c->stations - 2; j >= 0; j--) {
        c->planned[j] = clamp(speed_near_contact(c, row, j), c->s.speed_min, c->s.speed_max);
        if (j == c->stations - 2) continue;
        const double next = c->planned[j + 1], d = (faster_way(row, j) + faster_way(row, j + 1)) / 2;
        c->planned[j] = fmin(c->planned[j], sqrt(next * next + 2 * SPARE * c->s.acceleration * d));
    }
    return true;
}

wcut_status wcut_control_create(const wcut_control_settings *settings, const wcut_history *plan, wcut_control **out,
                                wcut_error *error) {
    /* only a plan that came to its end can lead a whole cut */
    if (!settings || !plan || !out)
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "settings, a plan and a place for the controller are expected");
    if (!plan->row || plan->stations < 2 || plan->stations != plan->planned)
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "plan: found %d of %d stations, expected a cut to its end",
                         plan->stations, plan->planned);
    wcut_status status = check_settings(settings, error);
    if (status != WCUT_OK) return status;

    /* the controller begins with its caution as the integral, so that it starts slower than planned */
    wcut_control *c = wcut_alloc(1, sizeof *c);
    if (!c) return wcut_fail(error, WCUT_NO_MEMORY, "no memory for a controller");
    c->s = *settings;
    c->integral = settings->feedback ? fmin(settings->caution, settings->authority) : 0;
    c->stations = plan->stations;

    /* planned speed of each segment, tension of each station */
    c->planned = wcut_alloc((size_t)c->stations - 1, sizeof *c->planned);
    c->loaded = wcut_alloc((size_t)c->stations, sizeof *c->loaded);
    if (!c->planned || !c->loaded)
        status = wcut_fail(error, WCUT_NO_MEMORY, "no memory for a plan of %d stations", c->stations);
    else if (!fill_plan(c, plan))
        status = wcut_fail(error, WCUT_BAD_ARGUMENT, "plan: expected positive speeds and finite tensions");

    if (status == WCUT_OK)
        *out = c;
    else
        wcut_control_destroy(c);

    return status;
}

void wcut_control_destroy(wcut_control *c) {
    if (!c) return;
    wcut_free(c->planned);
    wcut_free(c->loaded);
    wcut_free(c);
}

/* between two neighbours of a table, at a real-valued index whose ends are held */
static double table_at(int count, const double *table, double at) {
    if (!(at > 0)) return table[0];
    if (at >= count - 1) return table[count - 1];
    const int j = (int)at;
    return table[j] + (at - j) * (table[j + 1] - table[j]);
}

/* ---- watchdog ---- */

static bool is_stopped(const wcut_control *c) { return c->view.state >= WCUT_CONTROL_STATE_STOP_TENSION; }

/* time passed since the last step; 0 where it stands still, or the clock has just begun */
static double pass_time(wcut_control *c, double time) {
    /* the first finite time starts the clock */
    if (!c->begun && isfinite(time)) {
        c->begun = true;
        c->time = time;
        return 0;
    }

    /* forward: the period; too long a gap stops the cut */
    const double dt = c->begun ? time - c->time : 0;
    if (dt > 0 && isfinite(dt)) {
        c->time = time;
        c->still = 0;
        if (dt > c->s.fault_time) { /* nobody watched the wire meanwhile */
            c->view.state = WCUT_CONTROL_STATE_STOP_STALE;
            return c->period;
        }
        return c->period = dt;
    }

    /* a time that stands still or runs back: dropped, and after some of them a stop */
    c->view.dropped++;
    if (++c->still > STILL_MAX) c->view.state = WCUT_CONTROL_STATE_STOP_STALE;

    return 0;
}

static bool is_absurd(const wcut_control *c, double tension) {
    return !(tension >= -c->s.noise && tension <= c->s.tension_absurd); /* NaN, too */
}

/* Whether these readings may be used. A real sensor under load never repeats itself; one without load may. */
static bool watch(wcut_control *c, double dt, double station, double a, double b) {
    if (!isfinite(station) || is_absurd(c, a) || is_absurd(c, b)) {
        c->view.dropped++;
        c->faulty += dt;
        if (c->faulty > c->s.fault_time) c->view.state = WCUT_CONTROL_STATE_STOP_ABSURD;
        return false;
    }
    c->faulty = 0;
    c->repeated = a == c->tension_a && b == c->tension_b && fmax(a, b) > c->s.noise ? c->repeated + dt : 0;
    if (c->repeated > c->s.fault_time) c->view.state = WCUT_CONTROL_STATE_STOP_STALE;
    c->tension_a = a;
    c->tension_b = b;
    const bool over = fmax(a, b) > c->s.tension_stop;
    if (over && c->over) c->view.state = WCUT_CONTROL_STATE_STOP_TENSION;
    c->over = over;
    return true;
}

/* ---- law ---- */

/* The error that is fed back: of the filtered tension. What would speed the wire up counts as far as the plan expects
   a load, and as far as there is one. */
static void measure_foam(wcut_control *c, double dt, double station) {
    const double mean = (c->tension_a + c->tension_b) / 2, k = c->s.tension;
    wcut_control_view *v = &c->view;
    v->tension = c->filtered ? v->tension + (mean - v->tension) * dt / (c->s.filter + dt) : mean;
    c->filtered = true;
    const double load = v->tension / k, e = log(fmax(load, NO_LOAD));
    const double share = clamp((load - NO_LOAD) / (LOAD - NO_LOAD), 0, 1);
    v->error = e > 0 ? e : e * share * table_at(c->stations, c->loaded, station);
}

/* the speed that a correction asks for; +inf where it asks for less than no slowness */
static double corrected_speed(const wcut_control *c, double correction) {
    const double x = c->s.exponent_speed / c->view.planned + correction;
    return x > 0 ? c->s.exponent_speed / x : INFINITY;
}

/* no further than the acceleration allows in dt */
static double limit_acceleration(const wcut_control *c, double dt, double speed) {
    const double max = c->s.acceleration * dt;
    return clamp(speed, c->view.speed - max, c->view.speed + max);
}

/* Plan and feedback to a speed within all limits; without a usable reading the correction stays. Anti-windup: the
   integral stands still while the speed is at a limit and the error pushes against it. */
static void follow(wcut_control *c, double dt, bool usable) {
    const double e = c->s.feedback ? c->view.error : 0, add = usable ? c->s.rate * e * dt : 0;
    const double asked = c->s.gain * e + c->integral + add;
    const double u = clamp(asked, -c->s.authority, c->s.authority);
    const double wanted = corrected_speed(c, u);
    const double speed = limit_acceleration(c, dt, clamp(wanted, c->s.speed_min, c->s.speed_max));
    const bool against = (e > 0 && (speed > wanted || asked > u)) || (e < 0 && (speed < wanted || asked < u));
    if (!against) c->integral += add;
    c->view.correction = u;
    c->view.speed = speed;
}

wcut_status wcut_control_step(wcut_control *c, double time, double station, double tension_a, double tension_b,
                              double *speed) {
    if (!c || !speed) return WCUT_BAD_ARGUMENT;
    const int dropped = c->view.dropped;
    const double dt = pass_time(c, time);
    const bool usable = !is_stopped(c) && dt > 0 && watch(c, dt, station, tension_a, tension_b);
    if (is_stopped(c)) { /* a clock that stands still does not keep the wire moving */
        c->view.speed = fmax(0, c->view.speed - c->s.acceleration * (dt > 0 ? dt : c->period));
    } else {
        c->view.state = c->view.dropped > dropped ? WCUT_CONTROL_STATE_HOLD : WCUT_CONTROL_STATE_RUN;
        if (isfinite(station)) c->view.planned = table_at(c->stations - 1, c->planned, station - 0.5);
        if (usable) measure_foam(c, dt, station);
        if (dt > 0 && c->view.planned > 0) follow(c, dt, usable);
    }
    *speed = c->view.speed;
    return WCUT_OK;
}

void wcut_control_look(const wcut_control *c, wcut_control_view *view) { *view = c->view; }

const char *wcut_control_state_name(wcut_control_state state) {
    static const char *const text[] = {"run", "hold", "stop: over-tension", "stop: absurd readings",
                                       "stop: stale readings"};
    return (unsigned)state < sizeof text / sizeof *text ? text[state] : "unknown";
}
