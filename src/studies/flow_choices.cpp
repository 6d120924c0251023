// What several studies choose about a flow.
#include "studies/flow_choices.hpp"

namespace fiberfate {

KeyRows<CouetteRheometer> couette_rows() {
  using Couette = CouetteRheometer;
  const Choices<CouetteRate> rates = {
      {CouetteRate::narrow_gap, "narrow_gap", "wall speed over gap, as the thesis"},
      {CouetteRate::inner_wall, "inner_wall", "exact, at the inner cylinder"},
      {CouetteRate::outer_wall, "outer_wall", "exact, at the outer cylinder"},
      {CouetteRate::mean, "mean", "exact, averaged over the gap"}};
  return {
      key("inner_radius", &Couette::inner_radius, {"m", "mm"}, Range::positive(10),
          "Radius of the rheometer's inner cylinder, which turns."),
      key("outer_radius", &Couette::outer_radius, {"m", "mm"}, Range::positive(10),
          "Radius of the rheometer's outer cylinder; the default gap gives the thesis' rates.", {},
          "thesis 5.15: 18.326 1/s at 50 rpm"),
      key("rate_at", &Couette::choice, rates, "Which shear rate of the rheometer stands for all of it."),
      key("power_law_index", &Couette::power_law_index, {}, Range::positive(2),
          "Power-law index of the melt for the exact rates; 1 is Newtonian."),
  };
}

const Choices<ShearGradient>& shear_gradient_choices() {
  static const Choices<ShearGradient> all = {{ShearGradient::y, "y", "v_x = rate y, as in cells of fibers"},
                                             {ShearGradient::z, "z", "v_x = rate z, as across a cavity"}};
  return all;
}

Mat3 shear_gradient(ShearGradient direction, double rate) {
  Mat3 gradient = Mat3::Zero();
  gradient(0, direction == ShearGradient::y ? 1 : 2) = rate;
  return gradient;
}

std::vector<Column> gradient_columns() {
  std::vector<Column> columns;
  for (const char* name : {"L11", "L12", "L13", "L21", "L22", "L23", "L31", "L32", "L33"})
    columns.push_back({name, {"1/s", "1/s"}, Range::between(-1e7, 1e7)});
  return columns;
}

Mat3 row_gradient(const std::vector<double>& row, std::size_t first) {
  Mat3 gradient;
  for (std::size_t k = 0; k < 9; ++k)
    gradient(static_cast<int>(k / 3), static_cast<int>(k % 3)) = row[first + k];
  return gradient;
}

}  // namespace fiberfate
