/* The one place where C++ exceptions become wcut_status. */
#pragma once

#include <wirecut/status.h>

#include <new>

namespace wirecut {

template <typename Body>
wcut_status guard(Body &&body) noexcept {
    try {
        return body();
    } catch (const std::bad_alloc &) {
        return WCUT_NO_MEMORY;
    } catch (...) {
        return WCUT_INTERNAL;
    }
}

}  // namespace wirecut
