// How far the shearing of a cell is, in words.
#include "studies/shear_cell/status.hpp"

#include <fmt/format.h>

namespace fiberfate {
namespace {

std::string describe_duration(double seconds) {
  if (!(seconds < 1e7)) return "long";
  if (seconds < 90) return fmt::format("{:.0f} s", seconds);
  if (seconds < 5400) return fmt::format("{:.0f} min", seconds / 60);
  return fmt::format("{:.1f} h", seconds / 3600);
}

}  // namespace

std::string describe(const RunStatus& status) {
  const double done = status.time - status.begin;
  std::string speed;
  if (done > 0 && status.wall > 0) {
    const double rate = done / status.wall;
    speed = fmt::format("{:.3g} s/min, {} left, ", 60 * rate,
                        describe_duration((status.end - status.time) / rate));
  }
  return fmt::format("{:.6g} of {:.6g} s, {}L_N {:.4g} mm, L_W {:.4g} mm, step {:.2e} s ({})", status.time,
                     status.end, speed, 1e3 * status.number_average, 1e3 * status.weight_average,
                     status.step_size, status.step_limit);
}

}  // namespace fiberfate
