// The small vectors and matrices that all modules share.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>  // cross products
#include <cstddef>
#include <cstdint>

namespace fiberfate {

using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;
using IntVec3 = Eigen::Vector3i;

/// Identifies a fiber, node, rod or pair; 32 bits hold 10⁷ rods a hundred times over and halve the traffic.
using Index = std::int32_t;

}  // namespace fiberfate
