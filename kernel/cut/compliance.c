/* What gives way to the wire's tension: its own length, and the mounts. A mount is a spring that settles:
   du/dt = (F/k - u)/tau, solved exactly over the step for a pull F that changes evenly (first-order hold). */
#include "cut/compliance.h"

#include "base/vec3.h"

/* u_1 = (u_0 - F_0/k) E + F_0/k G + F_1/k (1 - G) with z = h/tau, E = exp(-z), G = (1 - E)/z */
typedef struct settling {
    wcut_vec3 kept, kept_by_log_rate; /* [mm] the part that the pull at the end does not change */
    double give, give_by_log_rate;    /* [mm/N] (1 - G)/k */
} settling;

static settling settle(const wcut_compliance *y, const wcut_mount *m, double rate) {
    settling s = {{0, 0, 0}, {0, 0, 0}, y->mount_compliance, 0};
    if (!m->set || !(y->settling > 0)) return s;
    const double z = 1 / (rate * y->settling), decay = exp(-z), hold = -expm1(-z) / z;
    const wcut_vec3 was = vec3_scale(y->mount_compliance, m->pull), ahead = vec3_sub(m->offset, was);
    s.kept = vec3_add_scaled(vec3_scale(decay, ahead), hold, was);
    s.kept_by_log_rate = vec3_add_scaled(vec3_scale(z * decay, ahead), hold - decay, was);
    s.give = y->mount_compliance * (1 - hold);
    s.give_by_log_rate = -y->mount_compliance * (hold - decay);
    return s;
}

wcut_end wcut_compliance_end(const wcut_compliance *y, int mount, wcut_vec3 x, double s, double length, double softness,
                             double rate) {
    const wcut_mount *m = &y->mount[mount];
    const settling g = settle(y, m, rate);
    const double kappa = g.give * s / length, one = 1 + kappa;
    wcut_end end = {.by_next = kappa / one};
    end.at = vec3_scale(1 / one, vec3_add_scaled(vec3_add(m->at, g.kept), kappa, x));
    const wcut_vec3 edge = vec3_scale(1 / one, vec3_sub(x, end.at));
    end.by_tension = vec3_scale(g.give / length * (1 - s * softness / length), edge);
    end.by_log_rate = vec3_add_scaled(vec3_scale(1 / one, g.kept_by_log_rate), g.give_by_log_rate * s / length, edge);
    return end;
}
