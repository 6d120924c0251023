// Keeps the list of orientation laws.
#include "continuum/orientation_registry.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>

#include "base/entry_by_name.hpp"
#include "base/error.hpp"
#include "continuum/orientation_laws/orientation_laws.hpp"
#include "microstructure/closure.hpp"

namespace fiberfate {
namespace {

constexpr double unbounded = std::numeric_limits<double>::infinity();
using Constants = OrientationConstants;

/// What the lists need to know where nothing is computed.
struct NoMath {
  struct Number;
  struct Symmetric;
  struct Diffusion;
  struct Place;
};

template <class Choice>
OrientationChoice<Choice> choice_of(const LawText& text, int number) {
  OrientationChoice<Choice> choice{Choice{number}, text.name, text.meaning, text.source, {}};
  for (const char* constant : text.constants)
    if (constant != nullptr) choice.constants.emplace_back(constant);
  return choice;
}

template <class Law>
RotaryDiffusionRow diffusion_row(int number) {
  return {choice_of<RotaryDiffusion>(Law::text, number), Law::depends_on_orientation};
}

/// What a retardation leaves of the rates of the principal values.
template <class Law>
Vec3 left_of(const OrientationConstants& constants, const Vec3& r) {
  Vec3 left;
  for (int i = 0; i < 3; ++i) left[i] = Law::left(constants, r[i], r[(i + 1) % 3], r[(i + 2) % 3]);
  if constexpr (requires { Law::shifts_the_trace; }) left.array() -= left.mean();
  return left;
}

template <class Law>
RetardationRow retardation_row(int number) {
  RetardationRow row{choice_of<Retardation>(Law::text, number), Law::slowness, nullptr};
  if constexpr (requires { &Law::left; }) row.left = left_of<Law>;
  return row;
}

template <template <class> class... Laws>
std::vector<RotaryDiffusionRow> diffusion_rows(LawList<Laws...>) {
  int number = 0;
  return {diffusion_row<Laws<NoMath>>(number++)...};
}

template <template <class> class... Laws>
std::vector<RetardationRow> retardation_rows(LawList<Laws...>) {
  int number = 0;
  return {retardation_row<Laws<NoMath>>(number++)...};
}

std::vector<NamedOrientationModel> named_models() {
  std::vector<NamedOrientationModel> all;
  const auto add = [&](const char* name, const char* diffusion, const char* retardation) {
    all.push_back({name, rotary_diffusion_named(diffusion), retardation_named(retardation)});
  };
  add("jeffery", "jeffery", "none");
  add("folgar_tucker", "folgar_tucker", "none");
  add("rsc", "folgar_tucker", "rsc");
  add("srf", "folgar_tucker", "srf");
  add("ard", "ard", "none");
  add("ard_rsc", "ard", "rsc");
  add("iard", "iard", "none");
  add("iard_rpr", "iard", "rpr");
  add("pard", "pard", "none");
  add("pard_rpr", "pard", "rpr");
  for (const RotaryDiffusionRow& one : rotary_diffusions())
    if (std::ranges::find(all, one.name, &NamedOrientationModel::name) == all.end())
      all.push_back({one.name, one.choice, {}});
  return all;
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
  for (const auto& one : description_of(model.diffusion).constants) names.push_back(one);
  for (const auto& one : description_of(model.retardation).constants) names.push_back(one);
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

const std::vector<RotaryDiffusionRow>& rotary_diffusions() {
  static const std::vector<RotaryDiffusionRow> all = diffusion_rows(RotaryDiffusions{});
  return all;
}

const std::vector<RetardationRow>& retardations() {
  static const std::vector<RetardationRow> all = retardation_rows(Retardations{});
  return all;
}

const std::vector<NamedOrientationModel>& named_orientation_models() {
  static const std::vector<NamedOrientationModel> all = named_models();
  return all;
}

const RotaryDiffusionRow& description_of(RotaryDiffusion diffusion) {
  return rotary_diffusions()[static_cast<std::size_t>(diffusion)];
}
const RetardationRow& description_of(Retardation retardation) {
  return retardations()[static_cast<std::size_t>(retardation)];
}
const char* name(RotaryDiffusion diffusion) {
  return description_of(diffusion).name.c_str();
}
const char* name(Retardation retardation) {
  return description_of(retardation).name.c_str();
}
bool acts_on_principal_values(Retardation retardation) {
  return description_of(retardation).left != nullptr;
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
