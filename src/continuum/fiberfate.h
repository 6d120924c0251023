/* The point laws of fiberfate for C: what another solver's user-defined fiber functions call.
 *
 * Every function that can fail returns a fiberfate_status; fiberfate_error_text() then says what was wrong
 * and what to do. No exception leaves the library. All arguments are checked: what is not finite, has the
 * wrong sign, or is no orientation tensor (trace off 1, or a principal value below 0, by more than 1e-3) is
 * refused with the name of the point, and no results are promised then. Laws are immutable: any number of
 * threads may use one at once. Arrays are point-major rows: orientation n×6 in the order 11, 22, 33, 23, 31,
 * 12; velocity gradients n×9, L_ij = d v_i / d x_j row by row; tensors of fourth order n×36, by pairs ij and
 * kl in the order above, plain components. SI units throughout.
 *
 * ABI: handles are opaque, structures are never extended, and functions keep their signatures; new ones are
 * added. FIBERFATE_API_VERSION rises when functions are added or mean something else. */
#ifndef FIBERFATE_H
#define FIBERFATE_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* 2: checks of all arguments, and what is marked (2) below. */
#define FIBERFATE_API_VERSION 2

typedef enum fiberfate_status {
  FIBERFATE_OK = 0,
  FIBERFATE_BAD_INPUT = 2, /* a name, number or pointer is impossible */
  FIBERFATE_FAILED = 3     /* the integration failed, or memory ran out */
} fiberfate_status;

/* One orientation law, one law of mean lengths, one of length distributions, one viscosity, one equation of
 * the distribution of directions. */
typedef struct fiberfate_orientation_law fiberfate_orientation_law;
typedef struct fiberfate_length_law fiberfate_length_law;
typedef struct fiberfate_breakage_law fiberfate_breakage_law;
typedef struct fiberfate_viscosity_law fiberfate_viscosity_law;
typedef struct fiberfate_distribution fiberfate_distribution;

/* One named constant of a law, {"C_I", 0.01}. */
typedef struct fiberfate_constant {
  const char* name;
  double value;
} fiberfate_constant;

/* The FIBERFATE_API_VERSION of the library in use. */
int fiberfate_api_version(void);

/* What the last failing call of this thread complained of; "" when none failed. Valid until the next
 * failure. */
const char* fiberfate_error_text(void);

/* (2) Sets how many threads the functions of this process use (at least 1); the default is that of OpenMP.
 * Results do not depend on it. */
fiberfate_status fiberfate_set_threads(int threads);

/* (2) Tells how many threads are used. */
int fiberfate_threads(void);

/* ---- orientation ---- */

/* Creates an orientation law.
 * `model`:   jeffery, folgar_tucker, rsc, srf, ard, ard_rsc, iard, iard_rpr, pard, pard_rpr, mrd or wpt, or
 * any pair "diffusion+retardation" such as "mrd+rsc". `closure`: linear, quadratic, hybrid, ibof, orf, orw,
 * orw3, ore, ors, orl, orp, bingham or exact. Constants that are not given are neutral (no diffusion, no
 * retardation, slender fibers); one that the law does not read is an error. `law` receives the law, or NULL;
 * free it with fiberfate_orientation_destroy. */
fiberfate_status fiberfate_orientation_create(const char* model, const char* closure,
                                              const fiberfate_constant* constants, size_t constant_count,
                                              fiberfate_orientation_law** law);

/* Writes DA/Dt (1/s, n×6) of n points; `rates` may be `orientations`. */
fiberfate_status fiberfate_orientation_rates(const fiberfate_orientation_law* law, size_t n,
                                             const double* orientations, const double* gradients,
                                             double* rates);

/* Advances n orientations in place by `duration` seconds of constant gradients, with an error of at most
 * `tolerance` (Frobenius norm) in each internal step. */
fiberfate_status fiberfate_orientation_advance(const fiberfate_orientation_law* law, size_t n,
                                               double* orientations, const double* gradients, double duration,
                                               double tolerance);

/* (2) The same; `put_back` receives how many points left the admissible states by more than the tolerance and
 * were put back (the mark of a poor closure or of a bad start). */
fiberfate_status fiberfate_orientation_advance_counted(const fiberfate_orientation_law* law, size_t n,
                                                       double* orientations, const double* gradients,
                                                       double duration, double tolerance, size_t* put_back);

/* (2) Finds the stable steady state in a constant velocity gradient (9 numbers) by Newton's method:
 * `orientation` receives 6 numbers, `decay_rate` (may be NULL) how fast the slowest disturbance dies out,
 * 1/s. Fails, in words, where there is none or where the start decides. */
fiberfate_status fiberfate_orientation_steady(const fiberfate_orientation_law* law, const double* gradient,
                                              double* orientation, double* decay_rate);

/* Writes the closed A4 (n×36, A_ijkl by pairs ij and kl in the order above) of n points. */
fiberfate_status fiberfate_close(const char* closure, size_t n, const double* orientations,
                                 double* fourth_orders);

/* Destroys a law; NULL is allowed. */
void fiberfate_orientation_destroy(fiberfate_orientation_law* law);

/* ---- lengths ---- */

/* Creates a length law of the form DL/Dt = -k_f max(0, L - L_inf) by its name in the registry
 * ("unbreakable_length", "stress_induced", …); as above for the rest. */
fiberfate_status fiberfate_length_create(const char* name, const fiberfate_constant* constants,
                                         size_t constant_count, fiberfate_length_law** law);

/* Writes DL/Dt (m/s) of n points from shear rates (1/s), matrix viscosities (Pa s) and lengths (m). */
fiberfate_status fiberfate_length_rates(const fiberfate_length_law* law, size_t n, const double* shear_rates,
                                        const double* viscosities, const double* lengths, double* rates);

/* (2) Writes k_f (1/s) and L_inf (m; infinite where nothing breaks) of n points. */
fiberfate_status fiberfate_length_coefficients(const fiberfate_length_law* law, size_t n,
                                               const double* shear_rates, const double* viscosities,
                                               double* rate_constants, double* final_lengths);

/* Advances n lengths (m) in place by `duration` seconds of constant flow, exactly. */
fiberfate_status fiberfate_length_advance(const fiberfate_length_law* law, size_t n,
                                          const double* shear_rates, const double* viscosities,
                                          double duration, double* lengths);

/* Destroys a law; NULL is allowed. */
void fiberfate_length_destroy(fiberfate_length_law* law);

/* Creates a law of length distributions ("phelps" or "durin") over `bins` bins (2 to 20000): bin i = 0 ...
 * bins-1 holds fibers of length (i + 1) largest_length/bins (m); as above for the rest. */
fiberfate_status fiberfate_breakage_create(const char* name, const fiberfate_constant* constants,
                                           size_t constant_count, size_t bins, double largest_length,
                                           fiberfate_breakage_law** law);

/* (2) Tells how much memory a law of so many bins takes, in bytes; also for numbers that are refused. */
double fiberfate_breakage_memory(size_t bins);

/* (2) Writes the unbreakable length L_ub (m; infinite without flow) of n points in the worst direction. */
fiberfate_status fiberfate_breakage_unbreakable_lengths(const fiberfate_breakage_law* law, size_t n,
                                                        const double* shear_rates, const double* viscosities,
                                                        double* lengths);

/* (2) Writes the mean number of children of bin i that a broken fiber of bin k leaves, children[i * bins +
 * k]. */
fiberfate_status fiberfate_breakage_children(const fiberfate_breakage_law* law, double* children);

/* (2) Writes L_N and L_W (m) of n points from their numbers of fibers, numbers[bin][point]. */
fiberfate_status fiberfate_breakage_means(const fiberfate_breakage_law* law, size_t n, const double* numbers,
                                          double* number_averages, double* weight_averages);

/* Writes the breakage rate of every bin (1/s) of n points, rates[bin][point], from shear rates (1/s), matrix
 * viscosities (Pa s) and -2 D:A/rate (NULL: 1 everywhere, the worst direction). */
fiberfate_status fiberfate_breakage_rates(const fiberfate_breakage_law* law, size_t n,
                                          const double* shear_rates, const double* viscosities,
                                          const double* compressions, double* rates);

/* Advances the numbers of fibers of n points, numbers[bin][point], in place by `duration` seconds of constant
 * flow: exactly however long it is, with the fiber length kept to round-off. (Explicit steps of dN/dt would
 * be stiff.) */
fiberfate_status fiberfate_breakage_advance(const fiberfate_breakage_law* law, size_t n,
                                            const double* shear_rates, const double* viscosities,
                                            const double* compressions, double duration, double* numbers);

/* Destroys a law; NULL is allowed. */
void fiberfate_breakage_destroy(fiberfate_breakage_law* law);

/* (2) Tells L_N and L_W (m) of a population: `numbers` fibers of each of n `lengths` (m); NULL: one each. */
fiberfate_status fiberfate_mean_lengths(size_t n, const double* lengths, const double* numbers,
                                        double* number_average, double* weight_average);

/* ---- viscosity and stress ---- */

/* (2) Creates a viscosity law: newtonian, power_law, carreau, cross or cross_wlf; as above for the rest. */
fiberfate_status fiberfate_viscosity_create(const char* name, const fiberfate_constant* constants,
                                            size_t constant_count, fiberfate_viscosity_law** law);

/* (2) Writes the viscosity (Pa s) of n points from shear rates (1/s), temperatures (K) and pressures (Pa);
 * cross_wlf needs both, the others take NULL. */
fiberfate_status fiberfate_viscosity_evaluate(const fiberfate_viscosity_law* law, size_t n,
                                              const double* shear_rates, const double* temperatures,
                                              const double* pressures, double* viscosities);

/* (2) Destroys a law; NULL is allowed. */
void fiberfate_viscosity_destroy(fiberfate_viscosity_law* law);

/* (2) Tells the particle number N_p = r²/(3 ln sqrt(pi/phi)) of fibers of aspect ratio r > 1 and volume
 * fraction phi. */
fiberfate_status fiberfate_particle_number(double aspect_ratio, double volume_fraction, double* number);

/* (2) Writes the extra stress 2 eta D + 2 eta phi N_p A4:D (Pa, n×6) of n points; `fiber_term` is phi N_p. */
fiberfate_status fiberfate_fiber_stress(const char* closure, double fiber_term, size_t n,
                                        const double* orientations, const double* gradients,
                                        const double* viscosities, double* stresses);

/* (2) Writes the informed-isotropic viscosity eta (1 + R D:A4:D/D:D) (Pa s) of n points; `trouton_term` is R.
 */
fiberfate_status fiberfate_informed_viscosity(const char* closure, double trouton_term, size_t n,
                                              const double* orientations, const double* gradients,
                                              const double* viscosities, double* effective);

/* ---- stiffness ---- */

/* (2) Fiber and matrix, both isotropic: moduli (Pa), Poisson's ratios, linear thermal expansions (1/K), and
 * the volume fraction of fibers. */
typedef struct fiberfate_composite {
  double fiber_modulus, fiber_poisson, fiber_expansion;
  double matrix_modulus, matrix_poisson, matrix_expansion;
  double volume_fraction;
} fiberfate_composite;

/* (2) Writes the stiffness (Pa, n×36) of n points, and unless it is NULL the thermal expansion (1/K, n×6).
 * `model`: halpin_tsai, mori_tanaka or lielens. The fibers have `classes` aspect ratios of these shares of
 * their volume (any scale). */
fiberfate_status fiberfate_stiffness(const char* model, const char* closure,
                                     const fiberfate_composite* composite, size_t classes,
                                     const double* aspect_ratios, const double* volume_shares, size_t n,
                                     const double* orientations, double* stiffnesses, double* expansions);

/* ---- the distribution of directions itself ---- */

/* (2) Creates the equation of the distribution function psi of an orientation law without retardation, in
 * harmonics of even degree up to `degree` (4 to 200); constants as for fiberfate_orientation_create. */
fiberfate_status fiberfate_distribution_create(const char* model, const fiberfate_constant* constants,
                                               size_t constant_count, int degree,
                                               fiberfate_distribution** distribution);

/* (2) Tells how many coefficients a psi has; 0 for NULL. */
size_t fiberfate_distribution_size(const fiberfate_distribution* distribution);

/* (2) Writes the coefficients of a smooth psi of this A2 (6 numbers). */
fiberfate_status fiberfate_distribution_start(const fiberfate_distribution* distribution,
                                              const double* orientation, double* psi);

/* (2) Advances a psi in place by `duration` seconds of a constant velocity gradient (9 numbers). Fails when
 * psi becomes too sharp for the degree. */
fiberfate_status fiberfate_distribution_advance(const fiberfate_distribution* distribution,
                                                const double* gradient, double duration, double tolerance,
                                                double* psi);

/* (2) Writes the psi that no longer changes. */
fiberfate_status fiberfate_distribution_steady(const fiberfate_distribution* distribution,
                                               const double* gradient, double* psi);

/* (2) Writes A2 (6 numbers) and, unless it is NULL, A4 (36 numbers) of a psi. */
fiberfate_status fiberfate_distribution_moments(const fiberfate_distribution* distribution, const double* psi,
                                                double* second, double* fourth);

/* (2) Writes psi (1/sr) in n directions (n×3, any length but 0). */
fiberfate_status fiberfate_distribution_density(const fiberfate_distribution* distribution, const double* psi,
                                                size_t n, const double* directions, double* densities);

/* (2) Destroys an equation; NULL is allowed. */
void fiberfate_distribution_destroy(fiberfate_distribution* distribution);

#ifdef __cplusplus
}
#endif
#endif
