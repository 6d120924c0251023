// Checks conversions, contractions, rotations, frames and admissibility of orientation tensors.
#include "microstructure/tensor.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "microstructure/admissibility.hpp"
#include "microstructure/closure.hpp"
#include "microstructure/closure_block.hpp"
#include "microstructure/eigenframe.hpp"
#include "microstructure/exact_closure.hpp"

namespace fiberfate {
namespace {

Mat3 some_rotation() {
  return Eigen::AngleAxisd(0.9, Vec3(1, -2, 0.5).normalized()).toRotationMatrix();
}

Mat3 some_tensor() {
  Mat3 tensor;
  tensor << 0.5, 0.1, -0.05, 0.1, 0.3, 0.08, -0.05, 0.08, 0.2;
  return tensor;
}

TEST(Tensor, ComponentsAreInVoigtsOrderWithoutFactors) {
  const Vec6 components = to_components(some_tensor());
  EXPECT_EQ(components[3], 0.08);
  EXPECT_EQ(components[4], -0.05);
  EXPECT_EQ(components[5], 0.1);
  EXPECT_EQ(to_matrix(components), some_tensor());
}

TEST(Tensor, ContractionAndRotationAgreeWithSumsOverIndices) {
  const Vec3 p = Vec3(0.3, -0.5, 0.8).normalized();
  const Mat3 x = some_tensor(), r = some_rotation();
  EXPECT_LT((contracted(fourth_power(p), x) - p.dot(x * p) * p * p.transpose()).norm(), 1e-15);
  EXPECT_LT((rotated(fourth_power(p), r) - fourth_power(r * p)).norm(), 1e-15);
  EXPECT_LT((contracted(symmetric_identity(), x) - x).norm(), 1e-16);
  const Mat6 stiff = fourth_power(p) + fourth_power(r * p) + symmetric_identity();
  EXPECT_LT((composed(stiff, inverse(stiff)) - symmetric_identity()).norm(), 1e-14);
}

TEST(Eigenframe, ReconstructsTheTensorWithARotation) {
  const Eigenframe frame = eigenframe(some_tensor());
  EXPECT_LT((frame.axes * frame.values.asDiagonal() * frame.axes.transpose() - some_tensor()).norm(), 1e-15);
  EXPECT_NEAR(frame.axes.determinant(), 1, 1e-15);
  EXPECT_GE(frame.values[0], frame.values[1]);
}

TEST(Eigenframe, AGuideFixesTheAxesOfEqualValues) {
  const Mat3 guide = some_tensor() - Mat3(Mat3::Identity() / 3);
  const Eigenframe round = eigenframe(Mat3::Identity() / 3, guide);
  const Mat3 inside = round.axes.transpose() * guide * round.axes;
  EXPECT_LT(std::abs(inside(0, 1)) + std::abs(inside(1, 2)) + std::abs(inside(2, 0)), 1e-15);
  EXPECT_GE(inside(0, 0), inside(1, 1));
  const Mat3 state = rotated(Mat3(Vec3(0.5, 0.25, 0.25).asDiagonal()), some_rotation());
  const Eigenframe pair = eigenframe(state, guide);
  EXPECT_LT(std::abs((pair.axes.transpose() * guide * pair.axes)(1, 2)), 1e-15);
  EXPECT_LT((pair.axes * pair.values.asDiagonal() * pair.axes.transpose() - state).norm(), 1e-15);
}

TEST(Eigenframe, TheKernelAgreesWithEigenForEightKindsOfTensors) {
  const Mat3 r = some_rotation();
  const auto turned = [&](double a, double b, double c) {
    return rotated(Mat3(Vec3(a, b, c).asDiagonal()), r);
  };
  const Mat3 tensors[8] = {some_tensor(),         turned(0.6, 0.3, 0.1),       turned(0.5, 0.25, 0.25),
                           turned(0.4, 0.4, 0.2), Mat3::Identity() / 3,        turned(1, 0, 0),
                           turned(0.6, 0.4, 0),   turned(0.4 + 1e-8, 0.4, 0.2)};
  alignas(64) double components[48], values[24], axes[72];
  for (int lane = 0; lane < 8; ++lane)
    for (int m = 0; m < 6; ++m) components[8 * m + lane] = to_components(tensors[lane])[m];
  FIBERFATE_KERNEL(find_frames)(components, values, axes);
  for (int lane = 0; lane < 8; ++lane) {
    Eigenframe frame;
    for (int k = 0; k < 3; ++k) {
      frame.values[k] = values[8 * k + lane];
      for (int i = 0; i < 3; ++i) frame.axes(i, k) = axes[8 * (3 * k + i) + lane];
    }
    EXPECT_LT((frame.values - eigenframe(tensors[lane]).values).norm(), 2e-15) << lane;
    EXPECT_LT((frame.axes * frame.values.asDiagonal() * frame.axes.transpose() - tensors[lane]).norm(), 3e-15)
        << lane;
    EXPECT_LT((frame.axes.transpose() * frame.axes - Mat3::Identity()).norm(), 3e-15) << lane;
    EXPECT_NEAR(frame.axes.determinant(), 1, 3e-15) << lane;
  }
}

TEST(Admissibility, NamesWhatIsWrong) {
  EXPECT_EQ(fault_of(some_tensor()), "");
  EXPECT_NE(fault_of(Mat3(Mat3::Identity())).find("trace"), std::string::npos);
  EXPECT_NE(fault_of(Mat3(Vec3(0.7, 0.5, -0.2).asDiagonal())).find("below 0"), std::string::npos);
  Mat3 skew = some_tensor();
  skew(0, 1) += 0.1;
  EXPECT_NE(fault_of(skew).find("symmetric"), std::string::npos);
  EXPECT_EQ(fault_of(close(some_tensor(), closure_named("exact")), some_tensor()), "");
  EXPECT_NE(fault_of(close(some_tensor(), closure_named("quadratic")), some_tensor()).find("all indices"),
            std::string::npos);
}

TEST(Admissibility, ProjectsToTheNearestState) {
  EXPECT_LT((nearest_admissible(some_tensor()) - some_tensor()).norm(), 1e-15);
  const Mat3 outside = rotated(Mat3(Vec3(0.8, 0.3, -0.1).asDiagonal()), some_rotation());
  const Mat3 nearest = rotated(Mat3(Vec3(0.75, 0.25, 0).asDiagonal()), some_rotation());
  EXPECT_LT((nearest_admissible(outside) - nearest).norm(), 1e-14);
  EXPECT_LT((nearest_admissible(Vec3(2, -0.5, -0.5).asDiagonal()) - Mat3(Vec3(1, 0, 0).asDiagonal())).norm(),
            1e-15);
}

TEST(ExactClosure, InvertsCarlsonsIntegral) {
  EXPECT_NEAR(carlson_rd(1, 1, 1), 1, 1e-15);
  EXPECT_NEAR(carlson_rd(0, 2, 1), 1.7972103521033883, 1e-14);  // Carlson (1995), table
  EXPECT_NEAR(carlson_rd(2, 3, 4), 0.16510527294261053, 1e-15);
  for (const Vec3& values : {Vec3(0.6, 0.3, 0.1), Vec3(0.98, 0.015, 0.005), Vec3(0.5, 0.499, 0.001),
                             Vec3(1.0 / 3, 1.0 / 3, 1.0 / 3), Vec3(0.6, 0.4 - 1e-7, 1e-7)}) {
    Vec3 b;
    ASSERT_TRUE(find_exact_shape(values.data(), b.data()));
    EXPECT_NEAR(b.prod(), 1, 1e-11);
    for (int i = 0; i < 3; ++i)
      EXPECT_NEAR(carlson_rd(b[(i + 1) % 3], b[(i + 2) % 3], b[i]) / 3, values[i], 1e-13);
  }
}

TEST(ExactClosure, HasPlanarAndAlignedLimits) {
  double c[6];
  const double planar[] = {0.6, 0.4, 0};
  close_exactly(planar, c);
  EXPECT_NEAR(c[5], 0.12, 1e-6);  // A_1122 = a_1 a_2 / 2 in the plane
  const double aligned[] = {1, 0, 0};
  close_exactly(aligned, c);
  EXPECT_NEAR(c[0], 1, 1e-8);
}

}  // namespace
}  // namespace fiberfate
