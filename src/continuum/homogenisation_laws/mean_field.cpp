// Strain concentrations and the averages that they give.
#include "continuum/homogenisation_laws/mean_field.hpp"

namespace fiberfate {

Mat6 dilute_concentration(const Mat6& eshelby, const Mat6& inclusion, const Mat6& matrix) {
  const Mat6 contrast = composed(inverse(matrix), inclusion - matrix);
  return inverse(symmetric_identity() + composed(eshelby, contrast));
}

Mat6 averaged_stiffness(const CompositeMaterial& material, const Mat6& concentration) {
  const Mat6 fiber = isotropic_stiffness(material.fiber), matrix = isotropic_stiffness(material.matrix);
  const double fraction = material.volume_fraction;
  const Mat6 stress = (1 - fraction) * matrix + fraction * composed(fiber, concentration);
  return composed(stress, inverse((1 - fraction) * symmetric_identity() + fraction * concentration));
}

Mat6 lower_concentration(const CompositeMaterial& material, double r) {
  const Mat6 fiber = isotropic_stiffness(material.fiber), matrix = isotropic_stiffness(material.matrix);
  return dilute_concentration(eshelby_tensor(r, material.matrix.poisson), fiber, matrix);
}

}  // namespace fiberfate
