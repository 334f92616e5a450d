/* A taut wire between the ends of an elastic frame (equations: cut/bow.h). */
#include "cut/bow.h"

#include <wirecut/robot.h>

#include "base/fail.h"
#include "base/numbers.h"
#include "base/vec3.h"

/* [1] of the distance: what rounding of the mounts in a file leaves */
#define DISTANCE_OFF 1e-5
#define AMBIENT 20.0 /* [degC] */

/* heat that the foam takes from a wire by what it advances, as the effect wire_thermal_lag has it: 0.0079 W s/(mm m K) of
   a wire of 0.15 mm; a thicker one melts as much wider a kerf */
#define LOSS_BY_SPEED 0.0079
#define LOSS_DIAMETER 0.15

static double alloy_or(double stated, const wcut_wire_material *material, double of_it) {
    return stated > 0 ? stated : material ? of_it : 0;
}

static wcut_status check_distance(const wcut_job *job, double distance, wcut_error *error) {
    for (int j = 0; j < job->stations; j++) {
        const double d = vec3_distance(job->mount_a[j], job->mount_b[j]);
        if (!(fabs(d - distance) <= DISTANCE_OFF * distance))
            return wcut_fail(
                error, WCUT_DEGENERATE,
                "station %d: found the mounts %.8g mm apart, expected %.8g mm as at station 0: both are on "
                "one frame",
                j, d, distance);
    }
    return WCUT_OK;
}

wcut_status wcut_bow_create(const wcut_job *job, wcut_bow *bow, wcut_error *error) {
    /* stiffness and expansion as given, else of the material, which was checked to be known */
    const wcut_rig *r = &job->rig;
    const wcut_wire_material *material = wcut_wire_material_view(job->wire_material);
    const double section = WCUT_PI / 4 * job->wire_diameter * job->wire_diameter;
    const double wire = alloy_or(r->wire_stiffness, material, material ? material->modulus * section : 0);
    wcut_bow b = {.on = true,
                  .distance = vec3_distance(job->mount_a[0], job->mount_b[0]),
                  .pretension = r->pretension,
                  .give = 1 / r->stiffness,
                  .softness = 1 / wire,
                  .expansion = r->expansion >= 0 ? r->expansion
                               : material        ? material->expansion
                                                 : 0};
    b.natural = b.pretension > 0 ? b.distance / (1 + b.pretension * b.softness) : job->wire_length;
    const wcut_status status = check_distance(job, b.distance, error);
    if (status != WCUT_OK) return status;

    /* ends that come closer by all of their distance under a constant pull: the frame folds */
    const double tension = fmax(b.pretension, 0);
    if (tension * b.give >= b.distance)
        return wcut_fail(error, WCUT_DEGENERATE,
                         "rig.stiffness_N_per_mm: found %g, expected more than %.4g: a frame whose ends are %.4g mm "
                         "apart buckles under the pretension of %g N below that",
                         r->stiffness, tension / b.distance, b.distance, tension);
    if (b.give == 0 && b.softness == 0 && b.natural < b.distance * (1 - 1e-9))
        return wcut_fail(error, WCUT_DEGENERATE,
                         "wire.length_mm: found %.6g, expected at least %.6g: neither frame nor wire gives", b.natural,
                         b.distance);
    *bow = b;
    return WCUT_OK;
}

void wcut_bow_warm(const wcut_bow *bow, const wcut_job *job, double heat, double speed, double *air, double *foam) {
    *air = *foam = 0;
    if (bow->expansion == 0) return;
    const wcut_wire_material *material = wcut_wire_material_view(job->wire_material);
    const double given = alloy_or(job->wire_emissivity, material, material ? material->emissivity : 0);
    double temperature = 0;

    /* one hotter than the table of air reaches would be gone; it counts as that hot */
    if (wcut_wire_temperature(heat, job->wire_diameter, AMBIENT, given > 0 ? given : 0.7, &temperature) != WCUT_OK)
        temperature = 3000;
    const double above = temperature - AMBIENT, loss = heat / above;
    *air = bow->expansion * above;
    *foam = bow->expansion * heat / (loss + LOSS_BY_SPEED * job->wire_diameter / LOSS_DIAMETER * speed);
}

double wcut_bow_tension(const wcut_bow *bow, double rest) {
    /* rest (1 + T / EA) = D - (T - P) / k_b */
    const double missing = bow->distance + bow->pretension * bow->give - rest, soft = rest * bow->softness + bow->give;
    return soft > 0 ? fmax(missing / soft, 0) : 0;
}

wcut_bow_frame wcut_bow_frame_at(const wcut_bow *bow, wcut_vec3 a, wcut_vec3 b) {
    return (wcut_bow_frame){.middle = vec3_mix(a, b, 0.5),
                            .along = vec3_unit(vec3_sub(b, a)),
                            .distance = bow->distance,
                            .pretension = bow->pretension,
                            .give = bow->give};
}

wcut_vec3 wcut_bow_frame_end(const wcut_bow_frame *frame, double closing, int end) {
    return vec3_add_scaled(frame->middle, (end == 0 ? -0.5 : 0.5) * (frame->distance - closing), frame->along);
}

double wcut_bow_frame_closing(const wcut_bow_frame *frame, wcut_vec3 a, wcut_vec3 b) {
    return frame->distance - vec3_dot(vec3_sub(b, a), frame->along);
}
