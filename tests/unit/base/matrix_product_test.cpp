// Checks that the product for loops has the very bits of Eigen's own.
#include "base/matrix_product.hpp"

#include <gtest/gtest.h>

#include "base/random.hpp"

namespace fiberfate {
namespace {

TEST(MatrixProduct, RoundsLikeEigen) {
  for (std::uint32_t k = 0; k < 1000; ++k) {
    double drawn[12];
    for (std::uint32_t i = 0; i < 3; ++i) {
      const auto u = uniform4(3, RandomStream::position, {k, i, 0});
      for (std::size_t j = 0; j < 4; ++j) drawn[4 * i + j] = u[j] - 0.5;
    }
    const Mat3 matrix = Eigen::Map<const Mat3>(drawn);
    const Vec3 vector = Eigen::Map<const Vec3>(drawn + 9);
    const Vec3 expected = matrix * vector;
    EXPECT_EQ(product(matrix, vector), expected);
  }
}

}  // namespace
}  // namespace fiberfate
