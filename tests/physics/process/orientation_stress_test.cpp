// Shows the stress of fibers in flows where it is known.
#include <gtest/gtest.h>

#include <cmath>

#include "base/constants.hpp"
#include "base/error.hpp"
#include "continuum/anisotropic_stress.hpp"
#include "continuum/orientation_history.hpp"
#include "microstructure/closure.hpp"

namespace fiberfate {
namespace {

TEST(FiberStress, AlignedFibersRaiseTheElongationalStressOnly) {
  // Fibers along 1: A4:D has the component D11 along 11; tau_11 = 2 eta D11 (1 + phi N_p).
  const Mat6 aligned = fourth_power({1, 0, 0});
  const Mat3 stretch = uniaxial_elongation_gradient();
  const Mat3 stress = anisotropic_stress(100, 3, stretch, aligned);
  EXPECT_NEAR(stress(0, 0), 2 * 100 * stretch(0, 0) * 4, 1e-10);
  EXPECT_NEAR(stress(1, 1), 2 * 100 * stretch(1, 1), 1e-10);
  Mat3 shear = Mat3::Zero();
  shear(0, 1) = shear(1, 0) = 0.5;
  EXPECT_NEAR(anisotropic_stress(100, 3, shear, aligned)(0, 1), 100, 1e-12);
}

TEST(FiberStress, RandomFibersAddTwoFifteenthsInEveryFlow) {
  const Mat6 random = close(Mat3::Identity() / 3, closure_named("linear"));
  for (const Mat3& gradient :
       {simple_shear_gradient(), uniaxial_elongation_gradient(), planar_elongation_gradient()}) {
    const Mat3 strain = 0.5 * (gradient + gradient.transpose());
    EXPECT_NEAR(stretching_share(strain, random), 2.0 / 15, 1e-15);
    EXPECT_NEAR(informed_isotropic_viscosity(100, 30, strain, random), 100 * (1 + 30 * 2.0 / 15), 1e-10);
  }
}

TEST(FiberStress, ViscosityIsFiniteAtRest) {
  const Mat6 aligned = fourth_power({1, 0, 0});
  EXPECT_NEAR(stretching_share(Mat3::Zero(), aligned), 2.0 / 15, 1e-15);
  const Mat3 faint = 1e-200 * uniaxial_elongation_gradient();
  EXPECT_NEAR(stretching_share(faint, aligned), stretching_share(uniaxial_elongation_gradient(), aligned),
              1e-14);
  EXPECT_NEAR(stretching_share(uniaxial_elongation_gradient(), aligned), 2.0 / 3, 1e-14);
}

TEST(FiberStress, InformedViscosityDissipatesAsTheFibersDo) {
  // tau:D is the same for the tensor and the scalar with R = phi N_p: that is how (2.11) is informed.
  const Mat3 state = Vec3(0.6, 0.3, 0.1).asDiagonal();
  const Mat6 fourth = close(state, closure_named("ore"));
  Mat3 strain;
  strain << 0.4, 0.2, -0.3, 0.2, 0.1, 0.5, -0.3, 0.5, -0.5;
  const double dissipated = double_dot(anisotropic_stress(100, 7, strain, fourth), strain);
  EXPECT_NEAR(2 * informed_isotropic_viscosity(100, 7, strain, fourth) * double_dot(strain, strain),
              dissipated, 1e-10 * dissipated);
}

TEST(FiberStress, ParticleNumberOfAlignedFibers) {
  EXPECT_NEAR(particle_number(20, 0.1), 400 / (3 * std::log(std::sqrt(pi / 0.1))), 1e-12);
  EXPECT_THROW((void)particle_number(20, 0), InputError);
}

}  // namespace
}  // namespace fiberfate
