/* A job's "rig", "feed" and the poses of its tool: tables of keys, and the keys that a rig needs elsewhere in a job. */
#include "io/process/rig_json.h"

#include <math.h>
#include <stdlib.h>

#include "base/alloc.h"
#include "io/process/job.h"

#define READ_OBJECT(fields, into) wcut_read_object(reader, at, fields, (int)(sizeof(fields) / sizeof *(fields)), into)
#define IN_RIG(member, key, required, read) \
    { key, required, read, offsetof(wcut_rig, member) }

static const char *const kind_word[] = {"two_arms", "bow", "blade", NULL};

/* ---- the rig ---- */

static bool read_kind(wcut_reader *reader, const wcut_place *at, void *into) {
    int kind;
    if (!wcut_read_word(reader, at, kind_word, &kind)) return false;
    *(wcut_rig_kind *)into = (wcut_rig_kind)kind;
    return true;
}

/* the frame of a force sensor's readings: a word to whether it is the block's */
static bool read_force_frame(wcut_reader *reader, const wcut_place *at, void *into) {
    static const char *const frame_word[] = {"tool", "block", NULL};
    int frame;
    if (!wcut_read_word(reader, at, frame_word, &frame)) return false;
    *(bool *)into = frame == 1;
    return true;
}

bool wcut_read_rig(wcut_reader *reader, const wcut_place *at, void *job) {
    /* of two arms and a blade nothing but the kind is asked */
    static const wcut_field fields[] = {
        IN_RIG(kind, "kind", true, read_kind),
        IN_RIG(pretension, "pretension_N", false, wcut_read_positive),
        IN_RIG(stiffness, "stiffness_N_per_mm", false, wcut_read_positive),
        IN_RIG(wire_stiffness, "wire_stiffness_N", false, wcut_read_positive),
        IN_RIG(expansion, "expansion_per_K", false, wcut_read_not_negative),
        IN_RIG(force_in_block, "force_frame", false, read_force_frame),
    };
    wcut_rig *rig = &((wcut_job *)job)->rig;
    if (!READ_OBJECT(fields, rig)) return false;
    for (size_t k = 1; k < sizeof fields / sizeof *fields; k++) {
        const wcut_place place = wcut_place_member(at, fields[k].key);
        const bool frame = fields[k].read == read_force_frame;
        if (frame && place.value && rig->kind == WCUT_RIG_KIND_TWO_ARMS)
            return wcut_refuse(reader, &place, WCUT_BAD_FORMAT, "no such key: two arms have tension sensors");
        if (!frame && place.value && rig->kind != WCUT_RIG_KIND_BOW)
            return wcut_refuse(reader, &place, WCUT_BAD_FORMAT, "no such key: it is of a bow, this is a rig of kind %s",
                               kind_word[rig->kind]);
    }
    return true;
}

static bool refuse_rig_key(wcut_reader *reader, const wcut_place *at, const char *key, const char *why) {
    const wcut_place place = wcut_place_member(at, key);
    return wcut_refuse(reader, &place, WCUT_BAD_FORMAT, "%s", why);
}

static bool length_fits(wcut_reader *reader, const wcut_place *job_at, const wcut_job *job) {
    /* a length is needed where it does not follow from the rig */
    const wcut_place at = wcut_place_member(job_at, "wire"), rig_at = wcut_place_member(job_at, "rig");
    const bool length = json_object_get(at.value, "length_mm"), path = job->mode == WCUT_MODE_PATH;
    if (path && !length && job->rig.kind == WCUT_RIG_KIND_TWO_ARMS)
        return refuse_rig_key(reader, &at, "length_mm", "a number greater than 0: a job with a path needs it");
    if (job->rig.kind != WCUT_RIG_KIND_BOW) return true;
    if (length && job->rig.pretension > 0)
        return refuse_rig_key(reader, &at, "length_mm", "none beside rig.pretension_N: the pretension sets the length");
    return length || job->rig.pretension > 0 ||
           refuse_rig_key(reader, &rig_at, "pretension_N", "a number greater than 0, or a wire.length_mm in its place");
}

bool wcut_read_rig_fits(wcut_reader *reader, const wcut_place *at, wcut_job *job) {
    const wcut_place process = wcut_place_member(at, "process"), feed = wcut_place_member(at, "feed");
    const wcut_rig_kind kind = job->rig.kind;

    /* the tension is held by two arms, else it is an answer */
    const bool tension = json_object_get(process.value, "tension_N");
    if (kind == WCUT_RIG_KIND_TWO_ARMS && !tension)
        return refuse_rig_key(reader, &process, "tension_N", "a number greater than 0: two arms hold it");
    if (kind != WCUT_RIG_KIND_TWO_ARMS && tension)
        return refuse_rig_key(reader, &process, "tension_N",
                              kind == WCUT_RIG_KIND_BOW ? "none: the tension of a bow is an answer (rig.pretension_N)"
                                                        : "none: the tension of a blade is an answer");

    /* one tool, straight at rest, fed at a commanded speed */
    if (kind != WCUT_RIG_KIND_TWO_ARMS && job->mode != WCUT_MODE_PATH)
        return refuse_rig_key(reader, at, "design",
                              "a path: a design shapes a slack wire, bow and blade are straight at rest");
    if (kind == WCUT_RIG_KIND_TWO_ARMS && job->tool)
        return refuse_rig_key(reader, at, "path", "mount_a_mm and mount_b_mm: each of two arms has a mount of its own");
    if (kind != WCUT_RIG_KIND_TWO_ARMS && !feed.value)
        return refuse_rig_key(reader, at, "feed", "a commanded speed: bow and blade have no other");
    return length_fits(reader, at, job);
}

/* ---- the feed ---- */

/* a speed inside the limits, which were read before; `into` is the job for its limits, the value goes to *speed */
static bool read_speed(wcut_reader *reader, const wcut_place *at, const wcut_job *job, double *speed) {
    if (!wcut_read_positive(reader, at, speed)) return false;
    if (*speed >= job->speed_min && *speed <= job->speed_max) return true;
    return wcut_refuse(reader, at, WCUT_BAD_ARGUMENT, "a speed within the job's limits, %g to %g mm/s", job->speed_min,
                       job->speed_max);
}

static bool make_feed(wcut_reader *reader, wcut_feed_kind kind, size_t count, wcut_feed *feed) {
    feed->kind = kind;
    feed->count = (int)count;
    feed->speed = wcut_alloc(count, sizeof(double));
    if (kind == WCUT_FEED_KIND_TIME) feed->time = wcut_alloc(count, sizeof(double));
    return (feed->speed && (kind != WCUT_FEED_KIND_TIME || feed->time)) || wcut_refuse_memory(reader);
}

/* one number, or one a station */
static bool read_feed_speed(wcut_reader *reader, const wcut_place *at, void *into) {
    wcut_job *job = into;
    if (!json_is_array(at->value))
        return make_feed(reader, WCUT_FEED_KIND_CONSTANT, 1, &job->feed) &&
               read_speed(reader, at, job, job->feed.speed);
    const size_t count = json_array_size(at->value);
    if (count != (size_t)job->stations)
        return wcut_refuse(reader, at, WCUT_BAD_ARGUMENT, "a number, or %d of them, one a station", job->stations);
    if (!make_feed(reader, WCUT_FEED_KIND_STATIONS, count, &job->feed)) return false;
    for (size_t k = 0; k < count; k++) {
        const wcut_place item = {at, NULL, k, json_array_get(at->value, k)};
        if (!read_speed(reader, &item, job, &job->feed.speed[k])) return false;
    }
    return true;
}

/* [[t, v], ..] */
static bool read_feed_profile(wcut_reader *reader, const wcut_place *at, void *into) {
    wcut_job *job = into;
    const size_t count = json_array_size(at->value);
    if (!json_is_array(at->value) || count < 2 || count > WCUT_JOB_STATIONS_MAX)
        return wcut_refuse(reader, at, WCUT_BAD_FORMAT, "an array of 2 to %d pairs [time in s, speed in mm/s]",
                           WCUT_JOB_STATIONS_MAX);
    if (!make_feed(reader, WCUT_FEED_KIND_TIME, count, &job->feed)) return false;
    for (size_t k = 0; k < count; k++) {
        const wcut_place item = {at, NULL, k, json_array_get(at->value, k)};
        if (!json_is_array(item.value) || json_array_size(item.value) != 2)
            return wcut_refuse(reader, &item, WCUT_BAD_FORMAT, "a pair [time in s, speed in mm/s]");
        const wcut_place time = {&item, NULL, 0, json_array_get(item.value, 0)},
                         speed = {&item, NULL, 1, json_array_get(item.value, 1)};
        if (!wcut_read_not_negative(reader, &time, &job->feed.time[k]) ||
            !read_speed(reader, &speed, job, &job->feed.speed[k]))
            return false;
        if (k > 0 && !(job->feed.time[k] > job->feed.time[k - 1]))
            return wcut_refuse(reader, &time, WCUT_BAD_ARGUMENT, "times to increase, beyond %g s",
                               job->feed.time[k - 1]);
    }
    return true;
}

bool wcut_read_feed(wcut_reader *reader, const wcut_place *at, void *job) {
    static const wcut_field fields[] = {
        {"speed_mm_s", false, read_feed_speed, 0},
        {"profile", false, read_feed_profile, 0},
    };
    const bool speed = json_object_get(at->value, "speed_mm_s"), profile = json_object_get(at->value, "profile");
    if (json_is_object(at->value) && speed == profile)
        return wcut_refuse(reader, at, WCUT_BAD_FORMAT, "either \"speed_mm_s\" or \"profile\" in it");
    return READ_OBJECT(fields, job);
}

/* ---- the tool ---- */

static bool read_pose(wcut_reader *reader, const wcut_place *at, void *into) {
    wcut_pose *pose = into;
    if (!json_is_array(at->value) || json_array_size(at->value) != 7)
        return wcut_refuse(reader, at, WCUT_BAD_FORMAT, "a pose [x, y, z in mm, qw, qx, qy, qz]");
    double value[7];
    for (size_t k = 0; k < 7; k++) {
        const wcut_place item = {at, NULL, k, json_array_get(at->value, k)};
        if (!wcut_read_finite(reader, &item, &value[k])) return false;
    }
    pose->at = (wcut_vec3){value[0], value[1], value[2]};
    for (int k = 0; k < 4; k++) pose->turn[k] = value[3 + k];

    /* the tolerance is that of wcut_job_place_mounts, which names it in a place that has no JSON path */
    const double size = sqrt(value[3] * value[3] + value[4] * value[4] + value[5] * value[5] + value[6] * value[6]);
    return fabs(size - 1) <= 1e-3 || wcut_refuse(reader, at, WCUT_BAD_ARGUMENT,
                                                 "a rotation: a quaternion qw, qx, qy, qz of length 1, not %.6g", size);
}

bool wcut_read_tool(wcut_reader *reader, const wcut_place *at, void *into) {
    wcut_job *job = into;
    return wcut_read_array(reader, at, 2, WCUT_JOB_STATIONS_MAX, "poses", read_pose, sizeof(wcut_pose), &job->stations,
                           (void **)&job->tool);
}

bool wcut_read_mounts(wcut_reader *reader, const wcut_place *at, wcut_job *job) {
    wcut_error error = {0};
    const wcut_status status = wcut_job_place_mounts(job, &error);
    if (status == WCUT_OK) return true;
    return status == WCUT_NO_MEMORY ? wcut_refuse_memory(reader) : wcut_refuse(reader, at, status, "%s", error.text);
}

/* ---- out ---- */

static void put_feed(wcut_text *text, const wcut_feed *feed) {
    if (feed->kind == WCUT_FEED_KIND_NONE || feed->count < 1) return;
    wcut_text_print(text, ",\n  \"feed\": {");
    if (feed->kind == WCUT_FEED_KIND_TIME) {
        for (int k = 0; k < feed->count; k++) {
            wcut_text_put_number(text, k ? ", [" : "\"profile\": [[", feed->time[k]);
            wcut_text_put_number(text, ", ", feed->speed[k]);
            wcut_text_put(text, "]", 1);
        }
        wcut_text_put(text, "]", 1);
    } else if (feed->kind == WCUT_FEED_KIND_CONSTANT) {
        wcut_text_put_number(text, "\"speed_mm_s\": ", feed->speed[0]);
    } else {
        for (int k = 0; k < feed->count; k++)
            wcut_text_put_number(text, k ? ", " : "\"speed_mm_s\": [", feed->speed[k]);
        wcut_text_put(text, "]", 1);
    }
    wcut_text_put(text, "}", 1);
}

void wcut_put_rig(wcut_text *text, const wcut_job *job) {
    const wcut_rig *rig = &job->rig;
    if (rig->kind != WCUT_RIG_KIND_TWO_ARMS) {
        wcut_text_print(text, ",\n  \"rig\": {\"kind\": \"%s\"", wcut_rig_name(rig->kind));

        /* of a bow, what is not the default; a rigid frame has no stiffness */
        const bool bow = rig->kind == WCUT_RIG_KIND_BOW;
        if (bow && rig->pretension > 0) wcut_text_put_number(text, ", \"pretension_N\": ", rig->pretension);
        if (bow && !isinf(rig->stiffness)) wcut_text_put_number(text, ", \"stiffness_N_per_mm\": ", rig->stiffness);
        if (bow && rig->wire_stiffness > 0) wcut_text_put_number(text, ", \"wire_stiffness_N\": ", rig->wire_stiffness);
        if (bow && rig->expansion >= 0) wcut_text_put_number(text, ", \"expansion_per_K\": ", rig->expansion);
        if (rig->force_in_block) wcut_text_print(text, ", \"force_frame\": \"block\"");
        wcut_text_put(text, "}", 1);
    }
    put_feed(text, &job->feed);
}

void wcut_put_tool(wcut_text *text, const wcut_job *job) {
    wcut_text_print(text, ",\n  \"path\": {\n    \"tool\": [");
    for (int j = 0; j < job->stations; j++) {
        const wcut_pose *p = &job->tool[j];
        if (j) wcut_text_put(text, ", ", 2);
        wcut_text_put_number(text, "[", p->at.x);
        wcut_text_put_number(text, ", ", p->at.y);
        wcut_text_put_number(text, ", ", p->at.z);
        for (int k = 0; k < 4; k++) wcut_text_put_number(text, ", ", p->turn[k]);
        wcut_text_put(text, "]", 1);
    }
    wcut_text_print(text, "],\n    \"mount_a_in_tool_mm\": ");
    wcut_text_put_point(text, "[", job->mount_a_in_tool);
    wcut_text_print(text, ",\n    \"mount_b_in_tool_mm\": ");
    wcut_text_put_point(text, "[", job->mount_b_in_tool);
    wcut_text_print(text, "\n  }");
}
