/* wirecut/loss.h - how much an outlying sample may influence a fit. */
#ifndef WCUT_LOSS_H
#define WCUT_LOSS_H

/** The loss of a residual u, in units of the residuals' scale; what the fit minimises is its sum. */
typedef enum wcut_loss {
    WCUT_LOSS_SQUARE, /**< u^2/2: least squares, best where the noise is normal */
    WCUT_LOSS_HUBER,  /**< linear beyond 1.345 (Huber 1964): 95 % efficient on normal noise */
    WCUT_LOSS_TUKEY   /**< constant beyond 4.685 (Beaton, Tukey 1974), from Huber's fit: gross outliers have none */
} wcut_loss;

#endif
