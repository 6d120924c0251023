// Keeps the list of orientation laws.
#include "continuum/orientation_registry.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>

#include "base/entry_by_name.hpp"
#include "base/error.hpp"
#include "microstructure/closure.hpp"

namespace fiberfate {
namespace {

constexpr double unbounded = std::numeric_limits<double>::infinity();
using Constants = OrientationConstants;

template <class Choice>
const OrientationChoice<Choice>& description(const std::vector<OrientationChoice<Choice>>& all,
                                             Choice choice) {
  return *std::ranges::find(all, choice, &OrientationChoice<Choice>::choice);
}

/// Symbols are the same whatever their capitals and underscores: C_I, c_i and CI.
bool same_symbol(std::string_view left, std::string_view right) {
  const auto plain = [](std::string_view symbol) {
    std::string letters;
    for (const char letter : symbol)
      if (letter != '_') letters += static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
    return letters;
  };
  return plain(left) == plain(right);
}

/// The constants that a model reads.
std::vector<std::string> constants_of(const OrientationModel& model) {
  std::vector<std::string> names = {"xi", "U0"};
  for (const auto& one : description(rotary_diffusions(), model.diffusion).constants) names.push_back(one);
  for (const auto& one : description(retardations(), model.retardation).constants) names.push_back(one);
  return names;
}

std::string complaint_about(const OrientationConstant& constant, double value, bool read) {
  const LawParameter& parameter = constant.parameter;
  if (!std::isfinite(value)) return "not a finite number";
  if (!read && value != Constants{}.*constant.member) return "not read by this law";
  if (read && (value < parameter.lower || value > parameter.upper))
    return fmt::format("outside [{:g}, {:g}]", parameter.lower, parameter.upper);
  return {};
}

}  // namespace

const std::vector<OrientationConstant>& orientation_constants() {
  static const std::vector<OrientationConstant> all = {
      {{"xi", "1", "Shape factor (r²-1)/(r²+1) of fibers of aspect ratio r; 1 for slender ones", 1, -1, 1},
       &Constants::xi},
      {{"C_I", "1", "Interaction coefficient: strength of rotary diffusion", required_value},
       &Constants::c_i},
      {{"C_M", "1", "Fiber-matrix interaction: how much diffusion is suppressed along the flow",
        required_value, 0, 1},
       &Constants::c_m},
      {{"Omega", "1", "Share of diffusion along the second principal axis", required_value, 0, 1},
       &Constants::omega},
      {{"D1", "1", "Diffusion along the first principal axis, in units of C_I", 1}, &Constants::d1},
      {{"D2", "1", "Diffusion along the second principal axis, in units of C_I", required_value},
       &Constants::d2},
      {{"D3", "1", "Diffusion along the third principal axis, in units of C_I", required_value},
       &Constants::d3},
      {{"b1", "1", "Isotropic diffusion", required_value, -unbounded}, &Constants::b1},
      {{"b2", "1", "Diffusion along A", 0, -unbounded}, &Constants::b2},
      {{"b3", "1", "Diffusion along A²", 0, -unbounded}, &Constants::b3},
      {{"b4", "1", "Diffusion along D/rate", 0, -unbounded}, &Constants::b4},
      {{"b5", "1", "Diffusion along D²/rate²", 0, -unbounded}, &Constants::b5},
      {{"kappa", "1", "Factor on the rates of the principal values", required_value, 0, 1},
       &Constants::kappa},
      {{"alpha", "1", "Share by which the rates of the principal values are reduced", required_value, 0, 1},
       &Constants::alpha},
      {{"beta", "s", "Tunes the retardation by products of the rates", 0}, &Constants::beta},
      {{"srf", "1", "Factor on the whole rate", required_value, 0, 1}, &Constants::srf},
      {{"U0", "1", "Maier-Saupe potential; the isotropic state is stable below 8 C_I", 0, -unbounded},
       &Constants::u0}};
  return all;
}

const std::vector<OrientationChoice<RotaryDiffusion>>& rotary_diffusions() {
  static const std::vector<OrientationChoice<RotaryDiffusion>> all = {
      {RotaryDiffusion::none, "jeffery", "No diffusion.", "Jeffery, Proc. R. Soc. A 102, 161 (1922)", {}},
      {RotaryDiffusion::folgar_tucker,
       "folgar_tucker",
       "C = C_I I.",
       "Folgar, Tucker, J. Reinf. Plast. Compos. 3, 98 (1984)",
       {"C_I"}},
      {RotaryDiffusion::ard,
       "ard",
       "C = b1 I + b2 A + b3 A² + b4 D/rate + b5 D²/rate².",
       "Phelps, Tucker, J. Non-Newton. Fluid Mech. 156, 165 (2009)",
       {"b1", "b2", "b3", "b4", "b5"}},
      {RotaryDiffusion::iard,
       "iard",
       "C = C_I (I - C_M D²/|D²|), |X| = sqrt(X:X/2); indefinite in uniaxial flow for "
       "C_M > 3/4.",
       "Tseng, Chang, Hsu, J. Rheol. 60, 215 (2016)",
       {"C_I", "C_M"}},
      {RotaryDiffusion::pard,
       "pard",
       "C = C_I R diag(1, Omega, 1 - Omega) Rᵀ in the axes of A.",
       "Tseng, Chang, Hsu, J. Rheol. 62, 313 (2018)",
       {"C_I", "Omega"}},
      {RotaryDiffusion::mrd,
       "mrd",
       "C = C_I R diag(D1, D2, D3) Rᵀ in the axes of A.",
       "Bakharev, Yu, Speight, Wang, ANTEC (2018)",
       {"C_I", "D1", "D2", "D3"}},
      {RotaryDiffusion::wpt,
       "wpt",
       "C = b1 I + b3 A².",
       "Favaloro, Tucker, Composites A 126, 105605 (2019)",
       {"b1", "b3"}}};
  return all;
}

const std::vector<OrientationChoice<Retardation>>& retardations() {
  static const std::vector<OrientationChoice<Retardation>> all = {
      {Retardation::none, "none", "No retardation.", "", {}},
      {Retardation::rsc,
       "rsc",
       "Reduced strain closure: the principal values change kappa times as fast.",
       "Wang, O'Gara, Tucker, J. Rheol. 52, 1179 (2008)",
       {"kappa"}},
      {Retardation::rpr,
       "rpr",
       "Retarding principal rate; with beta = 0 the same as rsc with kappa = 1 - alpha.",
       "Tseng, Chang, Hsu, Phys. Fluids 25, 53103 (2013)",
       {"alpha", "beta"}},
      {Retardation::srf,
       "srf",
       "Strain reduction factor on the whole rate; not objective.",
       "Huynh, MS thesis, University of Illinois (2001)",
       {"srf"}}};
  return all;
}

const std::vector<NamedOrientationModel>& named_orientation_models() {
  static const std::vector<NamedOrientationModel> all = {
      {"jeffery", RotaryDiffusion::none, Retardation::none},
      {"folgar_tucker", RotaryDiffusion::folgar_tucker, Retardation::none},
      {"rsc", RotaryDiffusion::folgar_tucker, Retardation::rsc},
      {"srf", RotaryDiffusion::folgar_tucker, Retardation::srf},
      {"ard", RotaryDiffusion::ard, Retardation::none},
      {"ard_rsc", RotaryDiffusion::ard, Retardation::rsc},
      {"iard", RotaryDiffusion::iard, Retardation::none},
      {"iard_rpr", RotaryDiffusion::iard, Retardation::rpr},
      {"pard", RotaryDiffusion::pard, Retardation::none},
      {"pard_rpr", RotaryDiffusion::pard, Retardation::rpr},
      {"mrd", RotaryDiffusion::mrd, Retardation::none},
      {"wpt", RotaryDiffusion::wpt, Retardation::none}};
  return all;
}

const char* name(RotaryDiffusion diffusion) {
  return description(rotary_diffusions(), diffusion).name.c_str();
}
const char* name(Retardation retardation) {
  return description(retardations(), retardation).name.c_str();
}

RotaryDiffusion rotary_diffusion_named(std::string_view name) {
  return entry_named(rotary_diffusions(), "rotary diffusion", name).choice;
}

Retardation retardation_named(std::string_view name) {
  return entry_named(retardations(), "retardation", name).choice;
}

OrientationModel orientation_model_named(std::string_view name, std::string_view closure) {
  const NamedOrientationModel& named = entry_named(named_orientation_models(), "orientation law", name);
  return {named.diffusion, named.retardation, closure_named(closure), {}};
}

void set_constant(OrientationModel& model, std::string_view name, double value) {
  std::vector<std::string> names;
  for (const OrientationConstant& one : orientation_constants()) {
    names.push_back(one.parameter.name);
    if (!same_symbol(one.parameter.name, name)) continue;
    model.constants.*one.member = value;
    return;
  }
  const std::string near = nearest_word(name, names);
  throw InputError(fmt::format("no orientation law has a constant '{}'", name),
                   near.empty() ? fmt::format("the constants are {}", fmt::join(names, ", "))
                                : fmt::format("did you mean '{}'?", near));
}

void require_admissible(const OrientationModel& model) {
  const std::vector<std::string> read = constants_of(model);
  const std::string remedy = fmt::format("the law {} with {} reads {}", name(model.diffusion),
                                         name(model.retardation), fmt::join(read, ", "));
  std::vector<InputProblem> problems;
  for (const OrientationConstant& one : orientation_constants()) {
    const std::string& symbol = one.parameter.name;
    const double value = model.constants.*one.member;
    const std::string complaint = complaint_about(one, value, std::ranges::find(read, symbol) != read.end());
    if (!complaint.empty())
      problems.push_back({"", 0, 0, symbol, fmt::format("{:g}", value), complaint, remedy});
  }
  if (!problems.empty()) throw InputError(std::move(problems));
}

}  // namespace fiberfate
