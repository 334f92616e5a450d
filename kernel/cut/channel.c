/* The channels of a recording by name. */
#include <wirecut/recording.h>

const char *wcut_channel_name(wcut_channel channel) {
#define CHANNEL_NAME(name, stem, unit, required) sizeof unit > 1 ? stem "_" unit : stem,
    static const char *const name[] = {WCUT_CHANNEL_LIST(CHANNEL_NAME)};
#undef CHANNEL_NAME
    return (unsigned)channel < WCUT_CHANNEL_COUNT ? name[channel] : "";
}
