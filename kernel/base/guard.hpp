/* The one place where C++ exceptions become wcut_status; what they say is kept as the error's text. */
#pragma once

extern "C" {
#include "base/fail.h"
}

#include <exception>
#include <new>

namespace wirecut {

template <typename Body>
wcut_status guard(wcut_error *error, Body &&body) noexcept {
    try {
        return body();
    } catch (const std::bad_alloc &) {
        return wcut_fail(error, WCUT_NO_MEMORY, "%s", wcut_status_text(WCUT_NO_MEMORY));
    } catch (const std::exception &e) {
        return wcut_fail(error, WCUT_INTERNAL, "%s", e.what());
    } catch (...) {
        return wcut_fail(error, WCUT_INTERNAL, "%s", wcut_status_text(WCUT_INTERNAL));
    }
}

}  // namespace wirecut
