/* Calls the point laws of fiberfate from C, one by one: closure, steady state, lengths, breakage, viscosity, stress,
 * stiffness and the distribution of directions.
 *
 * Build: cc point_laws.c $(pkg-config --cflags --libs fiberfate) -lm */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "continuum/fiberfate.h"

/* Stops the program with fiberfate's own words when a call fails. */
static void check(fiberfate_status status) {
  if (status == FIBERFATE_OK) return;
  fprintf(stderr, "fiberfate: %s\n", fiberfate_error_text());
  exit((int)status);
}

/* Orientation: the steady state in shear, its A4 and what the distribution function says. */
static void orientation(double* steady) {
  const fiberfate_constant constants[] = {{"C_I", 0.03}};
  const double shear[9] = {0, 1, 0, 0, 0, 0, 0, 0, 0};
  double decay, fourth[36], exact[6], *psi;
  fiberfate_orientation_law* law = NULL;
  fiberfate_distribution* distribution = NULL;
  check(fiberfate_orientation_create("folgar_tucker", "ibof", constants, 1, &law));
  check(fiberfate_orientation_steady(law, shear, steady, &decay));
  check(fiberfate_close("ibof", 1, steady, fourth));
  check(fiberfate_distribution_create("folgar_tucker", constants, 1, 30, &distribution));
  psi = (double*)malloc(fiberfate_distribution_size(distribution) * sizeof(double));
  if (psi == NULL) exit(EXIT_FAILURE);
  check(fiberfate_distribution_steady(distribution, shear, psi));
  check(fiberfate_distribution_moments(distribution, psi, exact, NULL));
  printf("steady A11 %.4f with IBOF (slowest decay %.3f 1/s), %.4f without a closure; A1111 %.4f\n", steady[0], decay,
         exact[0], fourth[0]);
  free(psi);
  fiberfate_distribution_destroy(distribution);
  fiberfate_orientation_destroy(law);
}

/* Lengths: mean lengths after two seconds of breakage over 100 bins. */
static void lengths(void) {
  const fiberfate_constant constants[] = {{"C_B", 0.02}, {"zeta", 3}, {"S", 0.25}};
  const double rate = 200, viscosity = 300;
  double numbers[100] = {0}, unbreakable, number_average, weight_average;
  fiberfate_breakage_law* law = NULL;
  numbers[99] = 1;
  check(fiberfate_breakage_create("phelps", constants, 3, 100, 12e-3, &law));
  check(fiberfate_breakage_unbreakable_lengths(law, 1, &rate, &viscosity, &unbreakable));
  check(fiberfate_breakage_advance(law, 1, &rate, &viscosity, NULL, 2, numbers));
  check(fiberfate_breakage_means(law, 1, numbers, &number_average, &weight_average));
  printf("L_ub %.3f mm, L_N %.3f mm, L_W %.3f mm\n", 1e3 * unbreakable, 1e3 * number_average, 1e3 * weight_average);
  fiberfate_breakage_destroy(law);
}

/* Melt and part: viscosity, the fibers' stress, and the stiffness of the steady orientation. */
static void properties(const double* orientation) {
  const fiberfate_constant constants[] = {{"eta_0", 400}, {"tau", 2e4}, {"n", 0.3}};
  const fiberfate_composite glass = {73e9, 0.22, 5e-6, 1.5e9, 0.4, 1e-4, 0.2};
  const double gradient[9] = {0, 100, 0, 0, 0, 0, 0, 0, 0}, rate = 100, aspect = 40, share = 1;
  double viscosity, stress[6], stiffness[36], particles;
  fiberfate_viscosity_law* law = NULL;
  check(fiberfate_viscosity_create("cross", constants, 3, &law));
  check(fiberfate_viscosity_evaluate(law, 1, &rate, NULL, NULL, &viscosity));
  check(fiberfate_particle_number(aspect, glass.volume_fraction, &particles));
  check(fiberfate_fiber_stress("ibof", glass.volume_fraction * particles, 1, orientation, gradient, &viscosity, stress));
  check(fiberfate_stiffness("mori_tanaka", "ibof", &glass, 1, &aspect, &share, 1, orientation, stiffness, NULL));
  printf("eta %.1f Pa s, tau12 %.1f kPa, C1111 %.2f GPa\n", viscosity, 1e-3 * stress[5], 1e-9 * stiffness[0]);
  fiberfate_viscosity_destroy(law);
}

int main(void) {
  double steady[6], impossible[6] = {4, 0, 0, 0, 0, 0}, fourth[36];
  orientation(steady);
  lengths();
  properties(steady);
  if (fiberfate_close("ibof", 1, impossible, fourth) != FIBERFATE_BAD_INPUT) return EXIT_FAILURE;
  printf("refused: %s\n", fiberfate_error_text());
  return fabs(steady[0] + steady[1] + steady[2] - 1) < 1e-12 ? EXIT_SUCCESS : EXIT_FAILURE;
}
