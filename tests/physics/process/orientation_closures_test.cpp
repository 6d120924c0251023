// Compares every closure with the reference table and with what every fourth moment obeys.
#include <gtest/gtest.h>

#include <map>

#include "microstructure/closure.hpp"
#include "physics/process/reference_table.hpp"
#include "physics/record.hpp"

namespace fiberfate {
namespace {

/// The table's names, with its tolerances (the published coefficients of ORF and ORL have six decimals).
struct Reference {
  const char* name;
  Closure closure;
  double tolerance;
  bool fitted;
};
const Reference references[] = {{"linear", closure_named("linear"), 1e-14, false},
                                {"quadratic", closure_named("quadratic"), 1e-14, false},
                                {"hybrid", closure_named("hybrid"), 1e-14, false},
                                {"IBOF", closure_named("ibof"), 1e-12, false},
                                {"ORF", closure_named("orf"), 3e-6, true},
                                {"ORW", closure_named("orw"), 1e-12, true},
                                {"ORW3", closure_named("orw3"), 1e-12, true},
                                {"ORE_natural", closure_named("ore"), 1e-11, true},
                                {"ORS_smooth", closure_named("ors"), 1e-12, true},
                                {"ORL_lowCI", closure_named("orl"), 3e-6, true},
                                {"ORP_peaked", closure_named("orp"), 1e-12, true},
                                {"Bingham_ChaubalLeal", closure_named("bingham"), 1e-12, true},
                                {"exact_Jeffery", closure_named("exact"), 1e-11, false}};

TEST(OrientationClosures, MatchTheReferenceTable) {
  const auto table = reference_table("closures.json");
  for (const Reference& reference : references) {
    const auto& answers = table["closures"][reference.name];
    double largest = 0;
    for (std::size_t k = 0; k < table["states"].size(); ++k) {
      const auto& state = table["states"][k];
      if (reference.fitted && state["degenerate_eigenvalues"]) continue;
      const Mat6 error = close(matrix3(state["A2"]), reference.closure) - matrix6(answers[k]["A4"]);
      largest = std::max(largest, error.cwiseAbs().maxCoeff());
      EXPECT_LT(error.cwiseAbs().maxCoeff(), reference.tolerance) << reference.name << " " << state["name"];
    }
    record(std::string("largest error of a component of A4, ") + reference.name, 0, largest,
           reference.tolerance);
  }
}

}  // namespace
}  // namespace fiberfate
