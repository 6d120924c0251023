// Orientation laws, closures and steady states for C.
#include "base/error.hpp"
#include "base/number_checks.hpp"
#include "continuum/c_api.hpp"
#include "continuum/orientation_law.hpp"
#include "continuum/orientation_steady.hpp"
#include "microstructure/closure.hpp"

using namespace fiberfate;

struct fiberfate_orientation_law {
  OrientationLaw law;
};

namespace {

OrientationPoints points_of(std::size_t n, const double* orientations, const double* gradients,
                            double* results) {
  static_cast<void>(rows_at(orientations, n, 6, "orientations"));
  static_cast<void>(rows_at(gradients, n, 9, "gradients"));
  static_cast<void>(rows_at(results, n, 6, "rates"));
  OrientationPoints points;
  points.count = n;
  points.second_stride = points.result_stride = 6;
  points.gradient_stride = 9;
  for (std::size_t m = 0; m < 6 && n > 0; ++m) {
    points.second[m] = orientations + m;
    points.result[m] = results + m;
  }
  for (std::size_t m = 0; m < 9 && n > 0; ++m) points.gradient[m] = gradients + m;
  return points;
}

}  // namespace

fiberfate_status fiberfate_orientation_create(const char* model, const char* closure,
                                              const fiberfate_constant* constants, size_t constant_count,
                                              fiberfate_orientation_law** law) {
  return guarded([&] {
    require_pointer(law, "law");
    *law = nullptr;
    *law = new fiberfate_orientation_law{
        OrientationLaw(model_of(model, closure, constants_at(constants, constant_count)))};
  });
}

fiberfate_status fiberfate_orientation_rates(const fiberfate_orientation_law* law, size_t n,
                                             const double* orientations, const double* gradients,
                                             double* rates) {
  return guarded([&] {
    require_pointer(law, "law");
    law->law.evaluate(points_of(n, orientations, gradients, rates));
  });
}

fiberfate_status fiberfate_orientation_advance(const fiberfate_orientation_law* law, size_t n,
                                               double* orientations, const double* gradients, double duration,
                                               double tolerance) {
  size_t put_back = 0;
  return fiberfate_orientation_advance_counted(law, n, orientations, gradients, duration, tolerance,
                                               &put_back);
}

fiberfate_status fiberfate_orientation_advance_counted(const fiberfate_orientation_law* law, size_t n,
                                                       double* orientations, const double* gradients,
                                                       double duration, double tolerance, size_t* put_back) {
  return guarded([&] {
    require_pointer(law, "law");
    require_pointer(put_back, "put_back");
    *put_back = 0;
    *put_back =
        law->law.advance(points_of(n, orientations, gradients, orientations), {duration, tolerance}).put_back;
  });
}

fiberfate_status fiberfate_orientation_steady(const fiberfate_orientation_law* law, const double* gradient,
                                              double* orientation, double* decay_rate) {
  return guarded([&] {
    require_pointer(law, "law");
    require_pointer(gradient, "gradient");
    require_pointer(orientation, "orientation");
    const SteadyOrientation steady = steady_orientation(law->law.model(), matrix_at(gradient));
    write_tensor(steady.second, orientation);
    if (decay_rate != nullptr) *decay_rate = steady.decay_rate;
  });
}

fiberfate_status fiberfate_close(const char* closure, size_t n, const double* orientations,
                                 double* fourth_orders) {
  return guarded([&] {
    require_pointer(closure, "closure");
    const Closure chosen = closure_named(closure);
    static_cast<void>(rows_at(orientations, n, 6, "orientations"));
    static_cast<void>(rows_at(fourth_orders, n, 36, "fourth_orders"));
    for (std::size_t i = 0; i < n; ++i)
      write_fourth(close(tensor_at(orientations + 6 * i), chosen), fourth_orders + 36 * i);
  });
}

void fiberfate_orientation_destroy(fiberfate_orientation_law* law) {
  delete law;
}
