/* Shows how another solver's user-defined fiber function calls fiberfate: it follows the fibers of three points of a
 * cavity, near the wall, between and in the core, through half a second of filling.
 *
 * Build: cc user_law.c $(pkg-config --cflags --libs fiberfate) -lm */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "continuum/fiberfate.h"

#define POINTS 3

/* Stops the program with fiberfate's own words when a call fails. */
static void check(fiberfate_status status) {
  if (status == FIBERFATE_OK) return;
  fprintf(stderr, "fiberfate: %s\n", fiberfate_error_text());
  exit((int)status);
}

/* What the host solver would call at every node and time step. */
static void user_fiber_function(const fiberfate_orientation_law* orientation, const fiberfate_length_law* length,
                                double dt, const double* gradients, double* orientations, double* lengths) {
  const double viscosities[POINTS] = {180, 240, 400}; /* Pa s */
  double rates[POINTS];
  for (int i = 0; i < POINTS; ++i) rates[i] = fabs(gradients[9 * i + 2]); /* simple shear: |dv_1/dx_3| */
  check(fiberfate_orientation_advance(orientation, POINTS, orientations, gradients, dt, 1e-7));
  check(fiberfate_length_advance(length, POINTS, rates, viscosities, dt, lengths));
}

int main(void) {
  const fiberfate_constant orientation_constants[] = {{"C_I", 0.0165}, {"C_M", 0.999}, {"alpha", 0.965}};
  const fiberfate_constant length_constants[] = {
      {"lambda", 0.05}, {"xi", 0.004}, {"sigma_u", 2.0e9}, {"d_f", 19e-6}};
  fiberfate_orientation_law* orientation = NULL;
  fiberfate_length_law* length = NULL;
  check(fiberfate_orientation_create("iard_rpr", "ibof", orientation_constants, 3, &orientation));
  check(fiberfate_length_create("unbreakable_length", length_constants, 4, &length));

  const double shear_rates[POINTS] = {200, 50, 2}; /* 1/s, from wall to core */
  double gradients[9 * POINTS] = {0}, orientations[6 * POINTS] = {0}, lengths[POINTS];
  for (int i = 0; i < POINTS; ++i) {
    gradients[9 * i + 2] = shear_rates[i]; /* v_1 varies with x_3 */
    for (int m = 0; m < 3; ++m) orientations[6 * i + m] = 1.0 / 3;
    lengths[i] = 15e-3;
  }
  for (int step = 0; step < 50; ++step)
    user_fiber_function(orientation, length, 0.01, gradients, orientations, lengths);

  printf("  rate 1/s     A11     A22     A33     A31    L mm\n");
  for (int i = 0; i < POINTS; ++i) {
    const double* a = orientations + 6 * i;
    printf("%10g  %6.4f  %6.4f  %6.4f  %6.4f  %6.3f\n", shear_rates[i], a[0], a[1], a[2], a[4], 1e3 * lengths[i]);
    if (fabs(a[0] + a[1] + a[2] - 1) > 1e-14 || lengths[i] > 15e-3) return EXIT_FAILURE;
  }
  fiberfate_orientation_destroy(orientation);
  fiberfate_length_destroy(length);
  return EXIT_SUCCESS;
}
