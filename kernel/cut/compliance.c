/* What gives way to the wire's tension: its own length, and the mounts. A mount is a spring that settles:
   du/dt = (F/k - u)/tau, solved exactly over the step for a pull F that changes evenly (first-order hold). */
#include "cut/compliance.h"

#include "base/vec3.h"

/* u_1 = (u_0 - F_0/k) E + F_0/k G + F_1/k (1 - G) with z = h/tau, E = exp(-z), G = (1 - E)/z; k by coordinate */
typedef struct settling {
    wcut_vec3 kept, kept_by_log_rate; /* [mm] the part that the pull at the end does not change */
    wcut_vec3 give, give_by_log_rate; /* [mm/N] (1 - G)/k */
} settling;

static wcut_vec3 times(wcut_vec3 a, wcut_vec3 b) { return (wcut_vec3){a.x * b.x, a.y * b.y, a.z * b.z}; }

static settling settle(const wcut_compliance *y, int mount, double rate) {
    const wcut_mount *m = &y->mount[mount];
    const wcut_vec3 give = y->give[mount];
    settling s = {.give = give};
    if (!m->set || !(y->settling > 0)) return s;
    const double z = 1 / (rate * y->settling), decay = exp(-z), hold = -expm1(-z) / z;
    const wcut_vec3 was = times(give, m->pull), ahead = vec3_sub(m->offset, was);
    s.kept = vec3_add_scaled(vec3_scale(decay, ahead), hold, was);
    s.kept_by_log_rate = vec3_add_scaled(vec3_scale(z * decay, ahead), hold - decay, was);
    s.give = vec3_scale(1 - hold, give);
    s.give_by_log_rate = vec3_scale(decay - hold, give);
    return s;
}

wcut_end wcut_compliance_end(const wcut_compliance *y, int mount, wcut_vec3 x, double s, double length, double softness,
                             double rate) {
    const settling g = settle(y, mount, rate);
    const wcut_vec3 kappa = vec3_scale(s / length, g.give);
    const wcut_vec3 part = {1 / (1 + kappa.x), 1 / (1 + kappa.y), 1 / (1 + kappa.z)};
    wcut_end end = {.by_next = times(kappa, part)};
    end.at = times(part, vec3_add(vec3_add(y->mount[mount].at, g.kept), times(kappa, x)));

    /* the edge, as far as it pulls the mount along */
    const wcut_vec3 edge = times(part, vec3_sub(x, end.at));
    end.by_tension = vec3_scale(1 / length * (1 - s * softness / length), times(g.give, edge));
    end.by_log_rate =
        vec3_add(times(part, g.kept_by_log_rate), vec3_scale(s / length, times(g.give_by_log_rate, edge)));
    return end;
}
