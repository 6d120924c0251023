// Viscosity, stress and stiffness for C.
#include <memory>

#include "base/number_checks.hpp"
#include "continuum/anisotropic_stress.hpp"
#include "continuum/c_api.hpp"
#include "continuum/homogenisation.hpp"
#include "continuum/viscosity.hpp"
#include "microstructure/closure.hpp"

using namespace fiberfate;

struct fiberfate_viscosity_law {
  std::unique_ptr<ViscosityLaw> law;
};

namespace {

Mat3 strain_at(const double* gradient) {
  const Mat3 l = matrix_at(gradient);
  return 0.5 * (l + l.transpose());
}

/// Calls visit(point, D, A4) for every point.
template <class Visit>
void visit_points(const char* closure, std::size_t n, const double* orientations, const double* gradients,
                  const Visit& visit) {
  require_pointer(closure, "closure");
  const Closure chosen = closure_named(closure);
  static_cast<void>(rows_at(orientations, n, 6, "orientations"));
  static_cast<void>(rows_at(gradients, n, 9, "gradients"));
  for (std::size_t i = 0; i < n; ++i)
    visit(i, strain_at(gradients + 9 * i), close(tensor_at(orientations + 6 * i), chosen));
}

CompositeMaterial material_of(const fiberfate_composite& c) {
  CompositeMaterial material;
  material.fiber = {c.fiber_modulus, c.fiber_poisson};
  material.matrix = {c.matrix_modulus, c.matrix_poisson};
  material.fiber_expansion = c.fiber_expansion;
  material.matrix_expansion = c.matrix_expansion;
  material.volume_fraction = c.volume_fraction;
  return material;
}

}  // namespace

fiberfate_status fiberfate_viscosity_create(const char* name, const fiberfate_constant* constants,
                                            size_t constant_count, fiberfate_viscosity_law** law) {
  return guarded([&] {
    require_pointer(law, "law");
    *law = nullptr;
    require_pointer(name, "name");
    const ViscosityLawEntry& entry = find_viscosity_law(name);
    *law = new fiberfate_viscosity_law{make_viscosity_law(
        name, lined_up(entry.name, entry.parameters, constants_at(constants, constant_count)))};
  });
}

fiberfate_status fiberfate_viscosity_evaluate(const fiberfate_viscosity_law* law, size_t n,
                                              const double* shear_rates, const double* temperatures,
                                              const double* pressures, double* viscosities) {
  return guarded([&] {
    require_pointer(law, "law");
    const auto given = [n](const double* numbers, const char* what) {
      return numbers == nullptr ? std::span<const double>() : rows_at(numbers, n, 1, what);
    };
    law->law->evaluate(rows_at(shear_rates, n, 1, "shear_rates"), given(temperatures, "temperatures"),
                       given(pressures, "pressures"), rows_at(viscosities, n, 1, "viscosities"));
  });
}

void fiberfate_viscosity_destroy(fiberfate_viscosity_law* law) {
  delete law;
}

fiberfate_status fiberfate_particle_number(double aspect_ratio, double volume_fraction, double* number) {
  return guarded([&] {
    require_pointer(number, "number");
    const double found = particle_number(aspect_ratio, volume_fraction);
    require_number("number", found, any_finite);
    *number = found;
  });
}

fiberfate_status fiberfate_fiber_stress(const char* closure, double fiber_term, size_t n,
                                        const double* orientations, const double* gradients,
                                        const double* viscosities, double* stresses) {
  return guarded([&] {
    static_cast<void>(rows_at(viscosities, n, 1, "viscosities"));
    static_cast<void>(rows_at(stresses, n, 6, "stresses"));
    visit_points(
        closure, n, orientations, gradients, [&](std::size_t i, const Mat3& strain, const Mat6& fourth) {
          write_tensor(anisotropic_stress(viscosities[i], fiber_term, strain, fourth), stresses + 6 * i);
        });
  });
}

fiberfate_status fiberfate_informed_viscosity(const char* closure, double trouton_term, size_t n,
                                              const double* orientations, const double* gradients,
                                              const double* viscosities, double* effective) {
  return guarded([&] {
    static_cast<void>(rows_at(viscosities, n, 1, "viscosities"));
    static_cast<void>(rows_at(effective, n, 1, "effective"));
    visit_points(closure, n, orientations, gradients,
                 [&](std::size_t i, const Mat3& strain, const Mat6& fourth) {
                   effective[i] = informed_isotropic_viscosity(viscosities[i], trouton_term, strain, fourth);
                 });
  });
}

fiberfate_status fiberfate_stiffness(const char* model, const char* closure,
                                     const fiberfate_composite* composite, size_t classes,
                                     const double* aspect_ratios, const double* volume_shares, size_t n,
                                     const double* orientations, double* stiffnesses, double* expansions) {
  return guarded([&] {
    require_pointer(model, "model");
    require_pointer(closure, "closure");
    require_pointer(composite, "composite");
    static_cast<void>(rows_at(aspect_ratios, classes, 1, "aspect_ratios"));
    static_cast<void>(rows_at(volume_shares, classes, 1, "volume_shares"));
    static_cast<void>(rows_at(orientations, n, 6, "orientations"));
    static_cast<void>(rows_at(stiffnesses, n, 36, "stiffnesses"));
    std::vector<AspectRatioClass> shares;
    for (std::size_t k = 0; k < classes; ++k) shares.push_back({aspect_ratios[k], volume_shares[k]});
    const Closure chosen = closure_named(closure);
    const ThermoelasticProperties aligned =
        length_average(material_of(*composite), shares, homogenisation_named(model));
    for (std::size_t i = 0; i < n; ++i) {
      const Mat3 second = tensor_at(orientations + 6 * i);
      const ThermoelasticProperties here = orientation_average(aligned, close(second, chosen), second);
      write_fourth(here.stiffness, stiffnesses + 36 * i);
      if (expansions != nullptr) write_tensor(thermal_expansion(here), expansions + 6 * i);
    }
  });
}
