// The width of confidence intervals.
#pragma once

namespace fiberfate {

/// t such that |T| <= t with probability `level`, T of Student's distribution with `degrees_of_freedom`
/// (> 0; the normal distribution when infinite). NaN when degrees_of_freedom is not positive. Accurate to
/// 1e-10. Raises InputError unless 0 < level < 1.
[[nodiscard]] double student_quantile(double level, double degrees_of_freedom);

}  // namespace fiberfate
