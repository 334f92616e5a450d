/* What the writers of a history ask of it. */
#ifndef WCUT_IO_PROCESS_HISTORY_CHECK_H
#define WCUT_IO_PROCESS_HISTORY_CHECK_H

#include <stdbool.h>
#include <wirecut/history.h>

/* at least one station of two nodes, every row's numbers finite */
bool wcut_history_is_usable(const wcut_history *history);

#endif
