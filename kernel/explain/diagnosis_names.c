/* What verdicts and channels of a diagnosis are called in files. */
#include <wirecut/diagnosis.h>

const char *wcut_verdict_name(wcut_verdict_kind kind) {
#define NAME(name, text) text,
    static const char *const names[] = {WCUT_VERDICT_LIST(NAME)};
#undef NAME
    return (unsigned)kind < WCUT_VERDICT_COUNT ? names[kind] : "";
}

const char *wcut_evidence_name(wcut_evidence_channel channel) {
    static const char *const names[WCUT_EVIDENCE_CHANNEL_COUNT] = {"speed", "tension", "alpha",
                                                                   "beta",  "scan",    "force"};
    return (unsigned)channel < WCUT_EVIDENCE_CHANNEL_COUNT ? names[channel] : "";
}

const char *wcut_evidence_unit(wcut_evidence_channel channel) {
    static const char *const units[WCUT_EVIDENCE_CHANNEL_COUNT] = {"mm/s", "N", "deg", "deg", "mm", "N"};
    return (unsigned)channel < WCUT_EVIDENCE_CHANNEL_COUNT ? units[channel] : "";
}

const char *wcut_scatter_name(wcut_scatter_kind kind) {
#define WCUT_SCATTER_ENTRY(name, text) [WCUT_SCATTER_##name] = text,
    static const char *const names[WCUT_SCATTER_COUNT] = {WCUT_SCATTER_LIST(WCUT_SCATTER_ENTRY)};
#undef WCUT_SCATTER_ENTRY
    return (unsigned)kind < WCUT_SCATTER_COUNT ? names[kind] : "";
}
