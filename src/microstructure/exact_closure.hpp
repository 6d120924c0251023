// Closes A4 exactly for Jeffery's equation: the distribution is that of an isotropic state carried by the
// flow.
#pragma once

namespace fiberfate {

/// Finds the fourth moments of psi(p) = (1/4 pi) (p·B·p)^(-3/2), det B = 1, whose second moment has the
/// principal values a_1 >= a_2 >= a_3, sum 1. With the principal values b_i of B and Delta(s) =
/// sqrt((s+b_1)(s+b_2)(s+b_3)):
///   a_i = 1/2 ∫ ds / ((s+b_i) Delta) = R_D(b_j, b_k, b_i)/3,
///   A_iijj = 1/4 ∫ s ds / ((s+b_i)(s+b_j) Delta) for i != j, three times that for i = j; s from 0 to
///   infinity.
/// `components` receives A_1111, A_2222, A_3333, A_2233, A_3311, A_1122, each to about 1e-14.
/// Values of 1e-9 and less, where b_i no longer fits, are taken in the planar and aligned limits.
/// Source: Montgomery-Smith, He, Jack, Smith, J. Fluid Mech. 680, 321 (2011), eqs. 3.7 and 4.1.
void close_exactly(const double values[3], double components[6]);

/// Solves a_i = R_D(b_j, b_k, b_i)/3 for the principal values b of B; a_i must be positive. Returns false
/// when the iteration fails (values below about 1e-12).
bool find_exact_shape(const double values[3], double shape[3]);

/// Carlson's symmetric elliptic integral R_D(x, y, z) = 3/2 ∫ ds / ((s+z) sqrt((s+x)(s+y)(s+z))), to
/// round-off. x, y are not negative and at most one is zero; z is positive. Source: Carlson, Numer.
/// Algorithms 10, 13 (1995); the duplication theorem and a series of seventh order.
double carlson_rd(double x, double y, double z);

}  // namespace fiberfate
