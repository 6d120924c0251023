// Describes one parameter of a point law, so that case files can name it and calibration can vary it.
#pragma once

#include <limits>
#include <string>

namespace fiberfate {

/// Standard value of a parameter that a user has to give.
inline constexpr double required_value = std::numeric_limits<double>::quiet_NaN();

/// Describes a parameter of a law: what it is called, what it means and which values make sense.
struct LawParameter {
  std::string name;     ///< as in case files, "lambda"
  std::string unit;     ///< coherent SI unit, "1/s"; "1" when dimensionless
  std::string meaning;  ///< one sentence
  double
      standard_value;  ///< what a law uses when nobody says otherwise; NaN when there is no sensible default
  double lower = 0;    ///< least admissible value
  double upper = std::numeric_limits<double>::infinity();  ///< greatest admissible value
};

}  // namespace fiberfate
