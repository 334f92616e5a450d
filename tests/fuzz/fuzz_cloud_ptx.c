/* Any bytes as a PTX cloud. */
#include <wirecut/cloud_file.h>
#include "cloud_fuzz.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    fuzz_cloud(data, size, WCUT_CLOUD_FORMAT_PTX);
    return 0;
}
