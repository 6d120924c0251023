// Builds harmonic operators from the ladder relations of complex harmonics.
#include "continuum/spherical_harmonics.hpp"

#include <cmath>
#include <complex>
#include <vector>

#include "base/constants.hpp"
#include "microstructure/tensor.hpp"

namespace fiberfate {
namespace {

using Complex = std::complex<double>;
using ComplexSparse = Eigen::SparseMatrix<Complex>;
using Entries = std::vector<Eigen::Triplet<Complex>>;

/// Place of Y_lm among the complex harmonics of all degrees.
int place(int l, int m) {
  return l * l + l + m;
}

ComplexSparse assembled(int rows, int columns, const Entries& entries) {
  ComplexSparse matrix(rows, columns);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

/// Multiplication by p_1, p_2, p_3 of harmonics up to `degree`, into those up to degree + 1.
/// Source: Varshalovich et al., Quantum Theory of Angular Momentum (1988), 5.8.3.
std::array<ComplexSparse, 3> multiplication(int degree) {
  Entries along_3, along_plus, along_minus;
  const auto root = [](int a, int b, int l) {
    return std::sqrt(static_cast<double>(a) * b / ((2.0 * l - 1) * (2.0 * l + 1)));
  };
  for (int l = 0; l <= degree; ++l) {
    for (int m = -l; m <= l; ++m) {
      const int from = place(l, m);
      along_3.emplace_back(place(l + 1, m), from, root(l + 1 - m, l + 1 + m, l + 1));
      along_plus.emplace_back(place(l + 1, m + 1), from, -root(l + m + 1, l + m + 2, l + 1));
      along_minus.emplace_back(place(l + 1, m - 1), from, root(l - m + 1, l - m + 2, l + 1));
      if (std::abs(m) < l) along_3.emplace_back(place(l - 1, m), from, root(l - m, l + m, l));
      if (m + 1 <= l - 1) along_plus.emplace_back(place(l - 1, m + 1), from, root(l - m - 1, l - m, l));
      if (m - 1 >= 1 - l) along_minus.emplace_back(place(l - 1, m - 1), from, -root(l + m - 1, l + m, l));
    }
  }
  const int rows = (degree + 2) * (degree + 2), columns = (degree + 1) * (degree + 1);
  const ComplexSparse plus = assembled(rows, columns, along_plus),
                      minus = assembled(rows, columns, along_minus);
  return {ComplexSparse(Complex(0.5) * (plus + minus)), ComplexSparse(Complex(0, -0.5) * (plus - minus)),
          assembled(rows, columns, along_3)};
}

/// R = p × grad = i L with the quantum-mechanical angular momentum L.
std::array<ComplexSparse, 3> rotations(int degree) {
  Entries plus, minus, third;
  for (int l = 0; l <= degree; ++l) {
    for (int m = -l; m <= l; ++m) {
      if (m < l)
        plus.emplace_back(place(l, m + 1), place(l, m), std::sqrt(static_cast<double>(l - m) * (l + m + 1)));
      if (m > -l)
        minus.emplace_back(place(l, m - 1), place(l, m), std::sqrt(static_cast<double>(l + m) * (l - m + 1)));
      third.emplace_back(place(l, m), place(l, m), m);
    }
  }
  const int size = (degree + 1) * (degree + 1);
  const ComplexSparse up = assembled(size, size, plus), down = assembled(size, size, minus);
  return {ComplexSparse(Complex(0, 0.5) * (up + down)), ComplexSparse(Complex(0.5) * (up - down)),
          ComplexSparse(Complex(0, 1) * assembled(size, size, third))};
}

/// Columns are the real harmonics of even degree, expressed in the complex ones of all degrees.
ComplexSparse real_basis(int degree) {
  Entries entries;
  const double half = std::sqrt(0.5);
  int column = 0;
  for (int l = 0; l <= degree; l += 2) {
    for (int m = -l; m <= l; ++m, ++column) {
      const int n = std::abs(m);
      const double sign = n % 2 == 0 ? 1 : -1;
      if (m > 0) {
        entries.emplace_back(place(l, n), column, sign * half);
        entries.emplace_back(place(l, -n), column, half);
      } else if (m < 0) {
        entries.emplace_back(place(l, n), column, Complex(0, -sign * half));
        entries.emplace_back(place(l, -n), column, Complex(0, half));
      } else {
        entries.emplace_back(place(l, 0), column, 1);
      }
    }
  }
  return assembled((degree + 1) * (degree + 1), column, entries);
}

Eigen::SparseMatrix<double> in_real_basis(const ComplexSparse& basis, const ComplexSparse& matrix) {
  const ComplexSparse inside = basis.adjoint() * matrix * basis;
  Eigen::SparseMatrix<double> real = inside.real();
  real.prune(1.0, 1e-15);
  return real;
}

}  // namespace

HarmonicOperators harmonic_operators(int degree) {
  HarmonicOperators operators;
  const ComplexSparse basis = real_basis(degree);
  const auto raise = multiplication(degree);      // up to degree + 1
  const auto twice = multiplication(degree + 1);  // and on to degree + 2
  const auto turn = rotations(degree);
  const int inside = (degree + 1) * (degree + 1);
  for (std::size_t i = 0; i < 3; ++i) operators.rotation[i] = in_real_basis(basis, turn[i]);
  for (std::size_t k = 0; k < 6; ++k) {
    const ComplexSparse product = twice[row_of[k]] * raise[column_of[k]];
    operators.product[k] = in_real_basis(basis, product.topRows(inside));
  }
  operators.laplacian.resize(basis.cols());
  int place_in_basis = 0;
  for (int l = 0; l <= degree; l += 2)
    for (int m = -l; m <= l; ++m) operators.laplacian[place_in_basis++] = -l * (l + 1.0);
  return operators;
}

Eigen::VectorXd harmonics_at(const Vec3& direction, int degree) {
  const Vec3 p = direction.normalized();
  const double theta = std::acos(std::min(1.0, std::max(-1.0, p[2]))), phi = std::atan2(p[1], p[0]);
  Eigen::VectorXd values((degree + 1) * (degree + 2) / 2);
  int place_in_basis = 0;
  for (int l = 0; l <= degree; l += 2) {
    for (int m = -l; m <= l; ++m) {
      const auto n = static_cast<unsigned>(std::abs(m));
      // std::sph_legendre carries the Condon-Shortley phase (-1)^m, which the real harmonics leave out.
      const double legendre = std::sph_legendre(static_cast<unsigned>(l), n, theta) * (n % 2 == 0 ? 1 : -1);
      const double wave = m > 0 ? std::cos(n * phi) : std::sin(n * phi);
      values[place_in_basis++] = m == 0 ? legendre : std::sqrt(2.0) * legendre * wave;
    }
  }
  return values;
}

}  // namespace fiberfate
