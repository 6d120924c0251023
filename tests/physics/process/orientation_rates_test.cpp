// Compares DA/Dt of every law with the reference table.
#include <gtest/gtest.h>

#include <string>

#include "continuum/orientation_law.hpp"
#include "continuum/orientation_registry.hpp"
#include "microstructure/closure.hpp"
#include "physics/process/reference_table.hpp"

namespace fiberfate {
namespace {

/// Builds a model from a row of the table: "FT_RPR" is the table's name for Folgar-Tucker retarded by alpha =
/// 0.9.
OrientationModel model_of(const nlohmann::json& row) {
  const std::string name = row["model"];
  OrientationModel model;
  model.closure = row["closure"] == "IBOF" ? closure_named("ibof") : closure_named("ore");
  const auto has = [&](const char* key) { return row["params"].contains(key); };
  const auto starts = [&](const char* start) { return name.starts_with(start); };
  if (starts("Jeffery")) {
    model.diffusion = rotary_diffusion_named("jeffery");
  } else if (starts("ARD") || starts("WPT")) {
    model.diffusion = starts("WPT") ? rotary_diffusion_named("wpt") : rotary_diffusion_named("ard");
  } else if (starts("iARD")) {
    model.diffusion = rotary_diffusion_named("iard");
  } else if (starts("pARD")) {
    model.diffusion = rotary_diffusion_named("pard");
  } else if (starts("MRD")) {
    model.diffusion = rotary_diffusion_named("mrd");
  } else {
    model.diffusion = rotary_diffusion_named("folgar_tucker");
  }
  if (has("kappa") && !starts("WPT")) model.retardation = retardation_named("rsc");
  if (has("alpha") || name == "FT_RPR") model.retardation = retardation_named("rpr");
  if (has("srf")) model.retardation = retardation_named("srf");
  set_constant(model, "xi", row["xi"]);
  if (name == "FT_RPR") set_constant(model, "alpha", 0.9);
  const std::pair<const char*, const char*> names[] = {
      {"Ci", "c_i"},      {"Cm", "c_m"},    {"Omega", "omega"}, {"D1", "d1"},
      {"D2", "d2"},       {"D3", "d3"},     {"b1", "b1"},       {"b2", "b2"},
      {"b3", "b3"},       {"b4", "b4"},     {"b5", "b5"},       {"kappa", "kappa"},
      {"alpha", "alpha"}, {"beta", "beta"}, {"srf", "srf"},     {"U0", "u0"}};
  for (const auto& [table_name, our_name] : names)
    if (has(table_name)) set_constant(model, our_name, row["params"][table_name]);
  return model;
}

TEST(OrientationRates, MatchTheReferenceTable) {
  const auto table = reference_table("orientation_rhs.json");
  for (const auto& row : table["models"]) {
    const OrientationLaw law(model_of(row));
    for (std::size_t k = 0; k < table["states"].size(); ++k) {
      const auto& state = table["states"][k];
      const Mat3 error = law.rate(matrix3(state["A"]), matrix3(state["L"])) - matrix3(row["dAdt"][k]);
      EXPECT_LT(error.cwiseAbs().maxCoeff(), 1e-11)
          << row["model"] << " " << row["closure"] << " state " << k;
    }
  }
}

}  // namespace
}  // namespace fiberfate
