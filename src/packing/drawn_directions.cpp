// Draws the directions with which fibers begin to be packed.
#include "packing/drawn_directions.hpp"

#include <fmt/format.h>

#include "base/error.hpp"
#include "microstructure/orientation_statistics.hpp"

namespace fiberfate {
namespace {

const Vec3 planar_start(0.495, 0.495, 0.01);  // of the published route

double largest_difference(const Mat3& a, const Mat3& b) {
  return (a - b).cwiseAbs().maxCoeff();
}

}  // namespace

DrawnDirections draw_directions(const PackingRequest& request) {
  std::vector<double> lengths;
  for (const FiberBlank& fiber : request.fibers) lengths.push_back(fiber.length);
  const OrientationRequest& wanted = request.orientation;
  const bool held = holds_orientation(request.start), measured = held && !wanted.directions.empty();
  const Mat3 start = held ? wanted.tensor : Mat3(planar_start.asDiagonal());

  DrawnDirections drawn;
  drawn.directions = measured ? deal_orientations(wanted.directions, lengths, request.seed)
                              : sample_orientations(start, lengths, wanted.law, request.seed);
  drawn.asked = measured ? second_moment({wanted.directions}) : wanted.tensor;
  drawn.fourth_moment = fourth_moment({drawn.directions, lengths});

  const Mat3 moment = second_moment(drawn.directions, lengths);
  const double error = largest_difference(moment, drawn.asked);
  if (!held || error < request.orientation_tolerance) return drawn;
  if (!measured)
    throw InputError(
        fmt::format("{} fibers cannot have this orientation: the nearest that they have is off by {:.3g}",
                    lengths.size(), error),
        "ask for more fibers, or for an orientation tolerance above that");
  drawn.asked = moment;
  return drawn;
}

}  // namespace fiberfate
