// Finds the closest points of two rods.
#pragma once

#include "base/vector.hpp"

namespace fiberfate {

/// The two ends of a straight rod.
struct Segment {
  Vec3 begin;  ///< m
  Vec3 end;    ///< m
};

/// The segment moved by a vector.
[[nodiscard]] inline Segment shifted(const Segment& segment, const Vec3& by) {
  return {segment.begin + by, segment.end + by};
}

/// The closest points of two segments: x1 = begin1 + s (end1 − begin1), x2 = begin2 + t (end2 −
/// begin2).
struct ClosestPoints {
  double s = 0;                    ///< place on the first segment, in [0, 1]
  double t = 0;                    ///< place on the second segment, in [0, 1]
  Vec3 separation = Vec3::Zero();  ///< x1 − x2, from the second segment to the first, m
  double distance = 0;             ///< |separation|, m
};

/// Finds the closest points of two segments, which may cross, be parallel, touch end to end or shrink to
/// points.
///
/// Minimises the convex |x1(s) − x2(t)|² over the unit square: the optimum of the two lines with s clamped,
/// then t for that s, then s again where t was clamped. Where the segments are parallel and lie alongside
/// (the angle between them is below 1e-6) every point of the overlap is closest: its middle is returned, so
/// that a contact force there turns neither rod. Source: Ericson, Real-Time Collision Detection (2005),
/// section 5.1.9; the parallel case is ours.
[[nodiscard]] ClosestPoints closest_points(const Segment& first, const Segment& second);

}  // namespace fiberfate
