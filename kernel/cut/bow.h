/* A taut wire between the ends of an elastic frame: its natural length, its heat, the frame's spring and its ends.

       L_0 = D / (1 + P / EA)                          of the cold wire, D the distance of the ends at rest
       l_e = L_0 / (n - 1) (1 + alpha_T theta_e) (1 + S_e / EA)
       u   = (T - P) / k_b                             by which the ends come closer, half of it at each
       T   = (S_0 t_0 + S_{n-2} t_{n-2}) . c / 2       pull of both end edges along the chord c

   With k_b and EA endless, without expansion and with L_0 given, the wire is that of path mode in given time. */
#ifndef WCUT_CUT_BOW_H
#define WCUT_CUT_BOW_H

#include <stdbool.h>
#include <wirecut/job.h>

/* of a setup */
typedef struct wcut_bow {
    bool on;           /* false: the job has none */
    double distance;   /* [mm] D */
    double natural;    /* [mm] L_0 */
    double pretension; /* [N] P */
    double give;       /* [mm/N] 1/k_b; 0: rigid */
    double softness;   /* [1/N] 1/EA; 0: the wire does not stretch */
    double expansion;  /* [1/K] alpha_T */
} wcut_bow;

/* of a step: where the frame is */
typedef struct wcut_bow_frame {
    wcut_vec3 middle, along; /* [mm] between its ends; [1] from A to B */
    double distance, pretension, give;
} wcut_bow_frame;

/* The bow of a checked job from its mounts; WCUT_DEGENERATE where their distance changes, where the frame is too soft for
   the pretension, or where nothing can give and the wire is too short. */
wcut_status wcut_bow_create(const wcut_job *job, wcut_bow *bow, wcut_error *error);

/* [1] thermal strains of the wire, in air and in foam at a speed of feed [mm/s]; heat [W/m] */
void wcut_bow_warm(const wcut_bow *bow, const wcut_job *job, double heat, double speed, double *air, double *foam);

/* [N] tension of the straight wire whose edges are together `rest` mm long without it; 0: it hangs slack */
double wcut_bow_tension(const wcut_bow *bow, double rest);

/* the frame with its ends led to a and b */
wcut_bow_frame wcut_bow_frame_at(const wcut_bow *bow, wcut_vec3 a, wcut_vec3 b);

/* [mm] an end, 0 at A and 1 at B, of a frame that is closed by u; and the closing of a frame with its ends at a and b */
wcut_vec3 wcut_bow_frame_end(const wcut_bow_frame *frame, double closing, int end);
double wcut_bow_frame_closing(const wcut_bow_frame *frame, wcut_vec3 a, wcut_vec3 b);

#endif
