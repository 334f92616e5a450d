/* What a cell knows of itself, out of its file: names, defaults, refusals; and that a diagnosis believes it.
   labels: unit */
#include <stdio.h>
#include <string.h>
#include <unistd.h>
#include <wirecut/rig_prior_file.h>

#include "io/process/rig_prior.h"
#include "test.h"

static wcut_status parse(const char *text, wcut_rig_prior *prior, wcut_error *error) {
    return wcut_rig_prior_parse(text, strlen(text), "rig.json", prior, error);
}

TEST(what_is_not_named_is_usual) {
    const wcut_rig_prior usual = wcut_rig_prior_default();
    wcut_rig_prior prior;
    ck_assert_int_eq(parse("{\"format\": \"wirecut-rig/1\", \"scatter\": {\"wire_length_mm\": 0.2}, "
                           "\"delay\": {\"angle_s\": 0.02}, \"x-note\": 1}",
                           &prior, NULL),
                     WCUT_OK);
    ck_assert_double_eq(prior.scatter[WCUT_SCATTER_LENGTH], 0.2);
    ck_assert_double_eq(prior.scatter[WCUT_SCATTER_LEVEL], usual.scatter[WCUT_SCATTER_LEVEL]);
    ck_assert_double_eq(prior.angle_delay, 0.02);
    ck_assert_double_eq(prior.tension_delay, usual.tension_delay);
}

TEST(the_sample_is_an_ordinary_cell) {
    const wcut_rig_prior usual = wcut_rig_prior_default();
    wcut_rig_prior prior;
    ck_assert_int_eq(wcut_rig_prior_read(WCUT_SOURCE_DIR "/samples/rig.json", &prior, NULL), WCUT_OK);
    for (int k = 0; k < WCUT_SCATTER_COUNT; k++) ck_assert_double_eq(prior.scatter[k], usual.scatter[k]);
    ck_assert_double_eq(prior.tension_delay, usual.tension_delay);
    ck_assert_double_eq(prior.angle_delay, usual.angle_delay);
}

TEST(what_is_wrong_is_refused_with_its_place_and_nothing_is_written) {
    static const struct {
        const char *text, *word;
    } bad[] = {{"{}", "$.format"},
               {"{\"format\": \"wirecut-job/1\"}", "wirecut-rig/1"},
               {"{\"format\": \"wirecut-rig/1\", \"scatter\": {\"wire\": 1}}", "wire"},
               {"{\"format\": \"wirecut-rig/1\", \"delay\": {\"tension_s\": -1}}", "$.delay.tension_s"},
               {"{\"format\": \"wirecut-rig/1\", \"name\": 7}", "$.name"},
               {"{\"format\": ", "rig.json"}};
    for (size_t k = 0; k < sizeof bad / sizeof *bad; k++) {
        wcut_rig_prior prior = {.tension_delay = 999};
        wcut_error error = {0};
        const wcut_status status = parse(bad[k].text, &prior, &error);
        ck_assert_msg(status == WCUT_BAD_FORMAT || status == WCUT_BAD_ARGUMENT, "%s", bad[k].text);
        ck_assert_msg(strstr(error.text, bad[k].word) != NULL, "%s", error.text);
        ck_assert_double_eq(prior.tension_delay, 999);
    }
    wcut_rig_prior prior;
    ck_assert_int_eq(wcut_rig_prior_read("missing.json", &prior, NULL), WCUT_NOT_FOUND);
    ck_assert_int_eq(wcut_rig_prior_read(NULL, &prior, NULL), WCUT_BAD_ARGUMENT);
}
