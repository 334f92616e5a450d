/* Orthophotograph: each place of the face takes the brightness of its image, averaged over a pixel's area. */
#include "photo/rectify.h"

#include "base/alloc.h"
#include "base/numbers.h"
#include "base/sort.h"
#include "base/threads.h"
#include "photo/camera.h"

enum { RASTER = 24, SAMPLES_MAX = 4 };

/* [1] of a pixel of the photograph: at 1 rills of three pixels lose their contrast in the filters */
static const double FINENESS = 0.7;

static bool is_in_photo(const wcut_camera *c, wcut_pixel p) {
    return p.depth > 0 && p.u >= 0 && p.v >= 0 && p.u <= c->width - 1 && p.v <= c->height - 1;
}

/* singular values of the map from mm of the block's plane to pixels at a place: largest, smallest [px/mm] */
static bool scale_at(const wcut_face_grid *grid, const wcut_camera *camera, double x, double y, double scale[2]) {
    const double h = grid->cell;
    const wcut_face_place here = wcut_face_grid_locate(grid, x, y), right = wcut_face_grid_locate(grid, x + h, y),
                          up = wcut_face_grid_locate(grid, x, y + h);
    if (!here.there || here.hidden || !right.there || !up.there) return false;
    const wcut_pixel p = wcut_camera_pixel(camera, (wcut_vec3){x, y, here.z}),
                     q = wcut_camera_pixel(camera, (wcut_vec3){x + h, y, right.z}),
                     r = wcut_camera_pixel(camera, (wcut_vec3){x, y + h, up.z});
    if (!is_in_photo(camera, p) || !(q.depth > 0) || !(r.depth > 0)) return false;

    const double a = (q.u - p.u) / h, b = (r.u - p.u) / h, c = (q.v - p.v) / h, d = (r.v - p.v) / h;
    const double sum = a * a + b * b + c * c + d * d, area = fabs(a * d - b * c);
    const double root = sqrt(fmax(sum * sum - 4 * area * area, 0));
    scale[0] = sqrt((sum + root) / 2);
    scale[1] = scale[0] > 0 ? area / scale[0] : 0;
    return scale[1] > 0;
}

double wcut_rectify_resolution(const wcut_face_grid *grid, wcut_vec3 block, const wcut_camera *camera) {
    double size[RASTER * RASTER], scale[2];
    int count = 0;
    for (int j = 0; j < RASTER; j++)
        for (int i = 0; i < RASTER; i++)
            if (scale_at(grid, camera, block.x * (i + 0.5) / RASTER, block.y * (j + 0.5) / RASTER, scale))
                size[count++] = 1 / scale[1];
    if (count == 0) return 0;
    wcut_sort(count, size);
    return FINENESS * sorted_median(count, size);
}

/* weights of four neighbours at a fraction t between the middle two (Keys 1981): images of the pixel grid, which linear
   interpolation leaves, would turn the direction of fine rills */
static void sample_weights(double t, double w[4]) {
    w[0] = t * (-0.5 + t * (1 - 0.5 * t));
    w[1] = 1 + t * t * (-2.5 + 1.5 * t);
    w[2] = t * (0.5 + t * (2 - 1.5 * t));
    w[3] = t * t * (-0.5 + 0.5 * t);
}

/* brightness between pixels, one value a channel */
static void take_sample(const wcut_picture *photo, wcut_pixel p, double *sum) {
    const int n = photo->channels, i = (int)fmin(p.u, photo->width - 2), j = (int)fmin(p.v, photo->height - 2);
    double wu[4], wv[4];
    sample_weights(p.u - i, wu);
    sample_weights(p.v - j, wv);
    for (int b = 0; b < 4; b++) {
        const int row = (int)clamp(j + b - 1, 0, photo->height - 1);
        for (int a = 0; a < 4; a++) {
            const int column = (int)clamp(i + a - 1, 0, photo->width - 1);
            const unsigned char *at = photo->pixel + ((size_t)row * photo->width + column) * n;
            for (int k = 0; k < 3; k++) sum[k] += wv[b] * wu[a] * at[n == 1 ? 0 : k];
        }
    }
}

/* one pixel of the result; false: not seen */
static bool fill_pixel(const wcut_face_grid *grid, const wcut_camera *camera, const wcut_picture *photo, double x,
                       double y, double resolution, int samples, unsigned char *to) {
    double sum[3] = {0};
    for (int j = 0; j < samples; j++)
        for (int i = 0; i < samples; i++) {
            const double sx = x + resolution * ((i + 0.5) / samples - 0.5),
                         sy = y + resolution * ((j + 0.5) / samples - 0.5);
            const wcut_face_place f = wcut_face_grid_locate(grid, sx, sy);
            if (!f.there || f.hidden) return false;
            const wcut_pixel p = wcut_camera_pixel(camera, (wcut_vec3){sx, sy, f.z});
            if (!is_in_photo(camera, p)) return false;
            take_sample(photo, p, sum);
        }
    for (int k = 0; k < 3; k++) to[k] = (unsigned char)(clamp(sum[k] / (samples * samples), 0, 255) + 0.5);
    to[3] = 255;
    return true;
}

/* how many samples a side so that none of the photograph's pixels within a pixel is left out */
static int samples_of(const wcut_face_grid *grid, wcut_vec3 block, const wcut_camera *camera, double resolution) {
    double most = 0, scale[2];
    for (int j = 0; j < RASTER; j++)
        for (int i = 0; i < RASTER; i++)
            if (scale_at(grid, camera, block.x * (i + 0.5) / RASTER, block.y * (j + 0.5) / RASTER, scale))
                most = fmax(most, scale[0]);
    return (int)clamp(ceil(most * resolution - 0.25), 1, SAMPLES_MAX);
}

wcut_status wcut_rectify(const wcut_face_grid *grid, wcut_vec3 block, const wcut_camera *camera,
                         const wcut_picture *photo, double resolution, int threads, wcut_picture **rectified,
                         double *covered) {
    const double columns = floor(block.x / resolution), rows = floor(block.y / resolution);
    if (columns < 1 || rows < 1 || columns * rows > WCUT_PICTURE_PIXELS || columns > 1e6 || rows > 1e6)
        return WCUT_BAD_ARGUMENT;
    const int width = (int)columns, height = (int)rows, samples = samples_of(grid, block, camera, resolution);
    wcut_picture *made = NULL;
    const wcut_status status = wcut_picture_create(width, height, 4, &made);
    if (status != WCUT_OK) return status;

    /* rows are independent; counts of whole numbers do not depend on their order */
    long seen = 0, there = 0;
#pragma omp parallel for num_threads(wcut_threads(threads)) schedule(static) reduction(+ : seen, there)
    for (int r = 0; r < height; r++)
        for (int c = 0; c < width; c++) {
            const double x = (c + 0.5) * resolution, y = block.y - (r + 0.5) * resolution;
            unsigned char *to = made->pixel + ((size_t)r * width + c) * 4;
            there += wcut_face_grid_locate(grid, x, y).there;
            seen += fill_pixel(grid, camera, photo, x, y, resolution, samples, to);
        }
    *covered = there > 0 ? (double)seen / (double)there : 0;
    *rectified = made;
    return WCUT_OK;
}
