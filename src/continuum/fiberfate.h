/* Lets another solver's user-defined fiber functions call fiberfate's point laws from C.
 *
 * Every function that can fail returns a fiberfate_status; fiberfate_error_text() then says what was wrong and what to
 * do. No exception leaves the library. Laws are immutable: any number of threads may use one at once. Arrays are
 * point-major rows: orientation n×6 in the order 11, 22, 33, 23, 31, 12; velocity gradients n×9,
 * L_ij = d v_i / d x_j row by row. SI units throughout. */
#ifndef FIBERFATE_H
#define FIBERFATE_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Rises when a function changes what it takes or means. */
#define FIBERFATE_API_VERSION 1

typedef enum fiberfate_status {
  FIBERFATE_OK = 0,
  FIBERFATE_BAD_INPUT = 2,        /* a name, number or pointer is impossible */
  FIBERFATE_FAILED = 3            /* the integration failed, or memory ran out */
} fiberfate_status;

/* Holds one orientation law, one law of mean lengths, one law of length distributions. */
typedef struct fiberfate_orientation_law fiberfate_orientation_law;
typedef struct fiberfate_length_law fiberfate_length_law;
typedef struct fiberfate_breakage_law fiberfate_breakage_law;

/* Holds one named constant of a law, {"C_I", 0.01}. */
typedef struct fiberfate_constant {
  const char* name;
  double value;
} fiberfate_constant;

/* Tells the FIBERFATE_API_VERSION of the library in use. */
int fiberfate_api_version(void);

/* Tells what the last failing call of this thread complained of; "" when none failed. Valid until the next failure. */
const char* fiberfate_error_text(void);

/* Creates an orientation law.
 * `model`:   jeffery, folgar_tucker, rsc, srf, ard, ard_rsc, iard, iard_rpr, pard, pard_rpr, mrd or wpt, or any pair
 *            "diffusion+retardation" such as "mrd+rsc".
 * `closure`: linear, quadratic, hybrid, ibof, orf, orw, orw3, ore, ors, orl, orp, bingham or exact.
 * Constants that are not given are neutral (no diffusion, no retardation, slender fibers); one that the law does not
 * read is an error.
 * `law` receives the law, or NULL; free it with fiberfate_orientation_destroy. */
fiberfate_status fiberfate_orientation_create(const char* model, const char* closure,
                                              const fiberfate_constant* constants, size_t constant_count,
                                              fiberfate_orientation_law** law);

/* Writes DA/Dt (1/s, n×6) of n points. `rates` may be `orientations`. */
fiberfate_status fiberfate_orientation_rates(const fiberfate_orientation_law* law, size_t n, const double* orientations,
                                             const double* gradients, double* rates);

/* Advances n orientations in place by `duration` seconds of constant gradients, with an error of at most `tolerance`
 * (Frobenius norm) in each internal step. */
fiberfate_status fiberfate_orientation_advance(const fiberfate_orientation_law* law, size_t n, double* orientations,
                                               const double* gradients, double duration, double tolerance);

/* Writes the closed A4 (n×36, A_ijkl by pairs ij and kl in the order above) of n points. */
fiberfate_status fiberfate_close(const char* closure, size_t n, const double* orientations, double* fourth_orders);

/* Destroys a law; NULL is allowed. */
void fiberfate_orientation_destroy(fiberfate_orientation_law* law);

/* Creates a length law of the form DL/Dt = -k_f max(0, L - L_inf) by its name in the registry ("unbreakable_length",
 * "stress_induced", …); as above for the rest. */
fiberfate_status fiberfate_length_create(const char* name, const fiberfate_constant* constants, size_t constant_count,
                                         fiberfate_length_law** law);

/* Writes DL/Dt (m/s) of n points from shear rates (1/s), matrix viscosities (Pa s) and lengths (m). */
fiberfate_status fiberfate_length_rates(const fiberfate_length_law* law, size_t n, const double* shear_rates,
                                        const double* viscosities, const double* lengths, double* rates);

/* Advances n lengths (m) in place by `duration` seconds of constant flow, exactly. */
fiberfate_status fiberfate_length_advance(const fiberfate_length_law* law, size_t n, const double* shear_rates,
                                          const double* viscosities, double duration, double* lengths);

/* Destroys a law; NULL is allowed. */
void fiberfate_length_destroy(fiberfate_length_law* law);

/* Creates a law of length distributions ("phelps" or "durin") over `bins` bins: bin i = 0 ... bins-1 holds fibers of
 * length (i + 1) largest_length/bins (m); as above for the rest. */
fiberfate_status fiberfate_breakage_create(const char* name, const fiberfate_constant* constants, size_t constant_count,
                                           size_t bins, double largest_length, fiberfate_breakage_law** law);

/* Writes the breakage rate of every bin (1/s) of n points, rates[bin][point], from shear rates (1/s), matrix viscosities
 * (Pa s) and -2 D:A/rate (NULL: 1 everywhere, the worst direction). */
fiberfate_status fiberfate_breakage_rates(const fiberfate_breakage_law* law, size_t n, const double* shear_rates,
                                          const double* viscosities, const double* compressions, double* rates);

/* Advances the numbers of fibers of n points, numbers[bin][point], in place by `duration` seconds of constant flow: exactly
 * however long it is, with the fiber length kept to round-off. (Explicit steps of dN/dt would be stiff.) */
fiberfate_status fiberfate_breakage_advance(const fiberfate_breakage_law* law, size_t n, const double* shear_rates,
                                            const double* viscosities, const double* compressions, double duration,
                                            double* numbers);

/* Destroys a law; NULL is allowed. */
void fiberfate_breakage_destroy(fiberfate_breakage_law* law);

#ifdef __cplusplus
}
#endif
#endif
