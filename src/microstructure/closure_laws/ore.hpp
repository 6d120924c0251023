// The orthotropic equivalent of the natural closure.
#pragma once

#include "base/law_text.hpp"
#include "microstructure/closure_laws/orthotropic.hpp"

namespace fiberfate {

/// A4 in the principal frame as polynomials of 15 terms, a fit to the exact closure of Jeffery's equation.
/// Coefficients: p. 47 of the source.
template <class Math>
struct OreClosure {
  static constexpr LawText text = {"ore",
                                   "Orthotropic equivalent of the natural closure (ORN), fourth order.",
                                   "VerWeyst, PhD thesis, University of Illinois (1998)"};
  static constexpr OrthotropicCoefficients coefficients = {
      {0.636256796880687, -1.8726629637381, -4.47970873193738, 11.9589562332320, 3.84459692420086,
       11.3420924278159, -10.9582626069691, -20.7277994684132, -2.11623214471004, -12.3875632855619,
       9.81598389716748, 3.47901510567439, 11.7492911177026, 0.508041387366637, 4.88366597771489},
      {0.636256796880687, -3.31527229742146, -3.03709939825406, 11.8273285968852, 6.88153952058044,
       8.43677746778325, -15.9120667157641, -15.1515872606307, -6.48728933641926, -8.63891419284016,
       9.32520343452661, 7.74683751713295, 7.48146870624441, 2.28476531637958, 3.59772251134254},
      {2.74053289560253, -9.12196509782692, -12.2570587036254, 34.3199018916987, 13.8294699121940,
       25.8684755253884, -37.7029118029384, -50.2756431927485, -10.8801761133174, -26.9636915239716,
       27.3346798054488, 15.2650686148651, 26.1134914005375, 3.4321384033477, 10.6117418066060}};

  [[gnu::always_inline]] static typename Math::Orthotropic components(const typename Math::Frame& frame) {
    return Math::fitted(coefficients, 15, frame);
  }
};

}  // namespace fiberfate
