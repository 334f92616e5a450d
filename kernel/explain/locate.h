/* Where a residual is not noise: windows of a channel in time, and patches of the scanned faces, that a search over all
   of them would not find in noise. */
#ifndef WCUT_EXPLAIN_LOCATE_H
#define WCUT_EXPLAIN_LOCATE_H

#include "explain/evidence.h"

enum { WCUT_MISMATCHES = 20 };

/* corrected for the search, a mismatch of so small a p-value is listed */
#define WCUT_LOCATE_LEVEL 0.01

/*
 * List where a whitened residual differs from noise: windows of 2 to 32 s, the regimes and the whole of a cut, each
 * channel of each mount by itself; rectangles of patches of a scan. Each is tested for a constant shift, by generalised
 * least squares under the noise that whitening assumed; its dispersion is what windows of that length show in the
 * two quietest of the six channels (by their quieter half), 1 at least. Where neighbours do not err alike, it is the channel's mean square beside the window
 * at least, so that the same values in another order are nothing.
 * p-values are Sidak's over all windows of the case.
 *
 * evidence: predicted under its `at`, of which rows are missing is what its residual says.
 * residual: rows, whitened, as wcut_fitted.residual of the recalibrated model.
 * count, out: WCUT_MISMATCHES; disjoint in each channel of a cut, largest share of the misfit first. `mean` is the
 * residual itself, without whitening, angles in deg. The block box is that of the wire in the foam along the exogenous
 * trajectory, or of the patches; `wire` of recordings is NaN, of scans the way along the wire from where it enters the block.
 * WCUT_OK; WCUT_NO_MEMORY; as wcut_response_run: nothing was written.
 */
wcut_status wcut_mismatch_locate(const wcut_evidence *evidence, const double *residual, int *count, wcut_mismatch *out,
                                 wcut_error *error);

#endif
