// Tests how a case takes what it leaves out from a material.
#include "keys/material_presets.hpp"

#include <gtest/gtest.h>

#include "app/study_registry.hpp"
#include "base/error.hpp"
#include "keys/case_file.hpp"
#include "studies/molding/case.hpp"

namespace fiberfate {
namespace {

const char* const plaque = R"(study = "molding"
[part]
length = "100 mm"
width = "40 mm"
thickness = "2 mm"
mesh_size = "10 mm"
[material]
preset = "ppgf30"
[machine]
fill_time = "1 s"
melt_temperature = "523 K"
mold_temperature = "323 K"
[fibers]
length = "2 mm"
)";

MoldingCase read(const std::vector<std::string>& overrides = {}) {
  return std::any_cast<MoldingCase>(parse_case(plaque, "case.toml", case_kinds(), overrides).values);
}

TEST(MaterialPreset, FillsInWhatTheCaseLeavesOut) {
  const MoldingCase values = read();
  EXPECT_EQ(values.material.density, 952);
  EXPECT_EQ(values.melt.name, "cross_wlf");
  EXPECT_EQ(values.melt.parameters.at("n"), 0.275);
  EXPECT_EQ(values.fibers.volume_fraction, 0.132);
}

TEST(MaterialPreset, GivesWayToTheCase) {
  EXPECT_EQ(read({"material.density=1000"}).material.density, 1000);
  const MoldingCase values = read({"melt.name=newtonian", "melt.eta_0=100"});
  EXPECT_EQ(values.melt.name, "newtonian");
  EXPECT_FALSE(values.melt.parameters.at("n").has_value()) << "no key of another law's table is taken";
}

TEST(MaterialPreset, IsNotNeededByTheResolvedCase) {
  const LoadedCase loaded = parse_case(plaque, "case.toml", case_kinds());
  const std::string text = resolved_case(*loaded.kind, loaded.values);
  EXPECT_EQ(text.find("ppgf30"), std::string::npos);
  const MoldingCase again =
      std::any_cast<MoldingCase>(parse_case(text, "case.resolved.toml", case_kinds()).values);
  EXPECT_EQ(again.melt.parameters.at("D1"), read().melt.parameters.at("D1"));
}

TEST(MaterialPreset, IsSoughtAmongTheProgramsAndThenAsAFile) {
  try {
    (void)read({"material.preset=ppgf31"});
    FAIL() << "there is no such material";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("did you mean \"ppgf30\"?"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace fiberfate
