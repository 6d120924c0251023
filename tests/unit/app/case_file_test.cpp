// Tests reading, checking and writing of whole cases.
#include "keys/case_file.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "app/command_explain.hpp"
#include "app/gallery.hpp"
#include "app/study_registry.hpp"
#include "base/error.hpp"
#include "studies/shear_cell/case.hpp"

namespace fiberfate {
namespace {

const char* const smallest_case = R"(study = "shear_cell"
[cell]
size = "0.5 mm"
[fibers]
count = 10
length = "0.25 mm"
diameter = "19 um"
youngs_modulus = "73 GPa"
rod_length = "0.1 mm"
[flow]
rate = "10 1/s"
viscosity = "200 Pa s"
[run]
duration = "1 s"
)";

const ShearCellCase& shear_cell(const LoadedCase& loaded) {
  return *std::any_cast<ShearCellCase>(&loaded.values);
}

std::string errors_of(const std::string& text, const std::vector<std::string>& overrides = {}) {
  try {
    static_cast<void>(parse_case(text, "c.toml", case_kinds(), overrides));
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

std::string with(const std::vector<std::string>& overrides) {
  return errors_of(smallest_case, overrides);
}

TEST(CaseFile, FillsTheStruct) {
  const LoadedCase loaded = parse_case(smallest_case, "c.toml", case_kinds(),
                                       {"breakage.law=fixed", "breakage.critical_radius=300 um"});
  const ShearCellCase& values = shear_cell(loaded);
  EXPECT_EQ(loaded.kind->name, "shear_cell");
  EXPECT_EQ(values.sample.fibers.count, 10);
  EXPECT_EQ(values.sample.fibers.diameter, 19e-6);
  EXPECT_EQ(values.dynamics.breakage.law, "fixed");
  EXPECT_EQ(values.dynamics.breakage.critical_radius, 300e-6);
  EXPECT_EQ(values.dynamics.contact.force_constant, ContactParameters{}.force_constant);
  EXPECT_EQ(flow_history(values.flow).at(0.5).gradient(0, 1), 10);
  EXPECT_TRUE(loaded.warnings.empty());
}

TEST(CaseFile, IsTheSameBitsAfterBeingResolved) {
  const std::vector<std::vector<std::string>> variants = {
      {},
      {"flow.rate=16.650000000000002", "contact.friction=0.30000000000000004", "run.seed=9007199254740993"},
      {"cluster.orientation=[[0.34444, -0.17778, 0.15556], [-0.17778, 0.41112, -0.02222], [0.15556, "
       "-0.02222, 0.24444]]"},
      {"cell.size=[\"0.5 mm\", \"0.6 mm\", \"0.7 mm\"]", "output.histogram_times=[\"0.1 s\", \"0.3 s\"]"}};
  for (const auto& overrides : variants) {
    const LoadedCase first = parse_case(smallest_case, "c.toml", case_kinds(), overrides);
    const std::string resolved = resolved_case(*first.kind, first.values);
    const LoadedCase second = parse_case(resolved, "case.resolved.toml", case_kinds());
    // Numbers are written with the fewest digits that name their bits, so equal texts are equal bits.
    EXPECT_EQ(resolved_case(*second.kind, second.values), resolved);
    EXPECT_TRUE(second.warnings.empty());
    EXPECT_EQ(shear_cell(first).run.seed, shear_cell(second).run.seed);
    EXPECT_EQ(shear_cell(first).sample.cluster.orientation, shear_cell(second).sample.cluster.orientation);
  }
}

TEST(CaseFile, KeepsATableOfFlow) {
  std::string text = smallest_case;
  text.replace(text.find("rate ="), 5, "kind = \"table\"\ntable = [[\"0.5 s\", 10, 300], [1, 20, 150]]\n#");
  text.replace(text.find("viscosity"), 1, "#");
  const LoadedCase loaded = parse_case(text, "c.toml", case_kinds());
  EXPECT_EQ(flow_history(shear_cell(loaded).flow).at(0.7).viscosity, 150);
  const std::string resolved = resolved_case(*loaded.kind, loaded.values);
  EXPECT_EQ(shear_cell(parse_case(resolved, "r.toml", case_kinds())).flow.table,
            shear_cell(loaded).flow.table);
}

TEST(CaseFile, TemplatesOfTheParticleLevelCanBeRunAsTheyAre) {
  for (const std::string name : {"shear_cell", "cluster"}) {
    const LoadedCase loaded = parse_case(case_template(*find_study(name)), name + ".toml", case_kinds());
    EXPECT_TRUE(loaded.warnings.empty()) << loaded.warnings.front();
  }
}

TEST(CaseFile, TemplatesLackNothingButTheUsersMeasurements) {
  for (const Study& study : studies()) {
    try {
      static_cast<void>(parse_case(case_template(study), study.name + ".toml", case_kinds()));
    } catch (const InputError& error) {
      for (const InputProblem& problem : error.problems())
        EXPECT_TRUE(problem.message().find(".csv") != std::string::npos) << problem.message();
    }
  }
}

TEST(CaseFile, AnnotatedCasesReadBackAsTheyWere) {
  const LoadedCase loaded =
      parse_case(smallest_case, "c.toml", case_kinds(), {"step.initial=12.5 us", "contact.friction=0.45"});
  const LoadedCase again =
      parse_case(annotated_case(*loaded.kind, loaded.values), "again.toml", case_kinds());
  EXPECT_EQ(resolved_case(*again.kind, again.values), resolved_case(*loaded.kind, loaded.values));
}

TEST(KeyTable, EveryKeyIsExplainedAndItsExampleIsRead) {
  for (const Study& study : studies()) {
    CaseValues values = study.make();
    KeyTable table(KeyTable::Repeats::one_to_show);
    study.describe(table, values);
    for (const Key& key : table.keys()) {
      EXPECT_TRUE(key.notes.text.ends_with('.')) << key.name;
      EXPECT_EQ(std::count_if(table.sections().begin(), table.sections().end(),
                              [&key](const Section& section) { return section.name == key.section(); }),
                1)
          << key.name;
      EXPECT_TRUE(key.notes.need == Need::optional || !key.notes.example.empty()) << key.name;
      if (key.notes.example.empty()) continue;
      const TomlDocument example = TomlDocument::parse("value = " + key.notes.example, "example");
      EXPECT_TRUE(key.read(example.find("value")->value).empty()) << key.name;
    }
  }
}

TEST(KeyTable, TheDocumentationOfKeysIsCurrent) {
  std::ifstream file(FIBERFATE_SOURCE_DIR "/docs/guide/case_keys.md");
  std::ostringstream committed;
  committed << file.rdbuf();
  EXPECT_EQ(committed.str(), key_reference())
      << "run: fiberfate explain --markdown > docs/guide/case_keys.md";
}

TEST(Gallery, EveryCaseAndVariantIsValid) {
  ASSERT_GE(gallery_names().size(), 7u);
  for (const GalleryFile& file : gallery_files()) {
    if (file.name != "case.toml") continue;
    const std::string path = FIBERFATE_SOURCE_DIR "/cases/" + std::string(file.case_name);
    const LoadedCase loaded = load_case(path + "/case.toml", case_kinds());
    EXPECT_TRUE(loaded.warnings.empty()) << path;
    if (!std::filesystem::exists(path + "/variants.toml")) continue;
    const TomlDocument variants = TomlDocument::read(path + "/variants.toml");
    for (const TomlTable& variant : variants.tables()) {
      EXPECT_NO_THROW(static_cast<void>(
          load_case(path + "/case.toml", case_kinds(), {.variants = {variant.name}, .overrides = {}})))
          << path << " " << variant.name;
    }
  }
}

TEST(Gallery, IsFoundByNameOrNumber) {
  EXPECT_EQ(find_gallery_case("04_couette_43wt"), "04_couette_43wt");
  EXPECT_EQ(find_gallery_case("couette_43wt"), "04_couette_43wt");
  EXPECT_EQ(find_gallery_case("04"), "04_couette_43wt");
  EXPECT_EQ(find_gallery_case("couette"), "");
}

TEST(CaseFile, ReportsAllErrorsAtOnceInTheirOrder) {
  const std::string text = R"(study = "shear_cell"
[fibres]
length = 1
[fibers]
count = 0
diameter = 19
lenght = "2 mm"
[run]
duration = "1 m"
)";
  EXPECT_EQ(
      errors_of(text),
      "c.toml:2:1: [fibres]: unknown table in study shear_cell: did you mean [fibers]?\n"
      "c.toml:4:1: fibers.youngs_modulus: not given: add youngs_modulus = \"73 GPa\" under [fibers]\n"
      "c.toml:4:1: fibers.length: not given; fibers need a length: add length = \"2.5 mm\" under [fibers]\n"
      "c.toml:4:1: fibers.rod_length: not given; fibers are cut into rods: add rod_length = \"0.1 mm\" under "
      "[fibers]\n"
      "c.toml:5:9: fibers.count = 0: out of range: give 1 to 10000000\n"
      "c.toml:6:12: fibers.diameter = 19: out of range: give 100 nm to 1 mm (a number without unit is in m)\n"
      "c.toml:7:1: fibers.lenght = \"2 mm\": unknown key in study shear_cell: did you mean fibers.length?\n"
      "c.toml:9:12: run.duration = \"1 m\": 'm' does not have the dimension of 's': give a number with a "
      "unit in "
      "quotes, such as \"1 s\"\n"
      "c.toml:1:1: flow.rate: not given; this kind of flow needs it: add rate = \"16.65 1/s\" under [flow]\n"
      "c.toml:1:1: flow.viscosity: not given; this kind of flow needs it: add viscosity = \"200 Pa s\" under "
      "[flow]");
}

TEST(CaseFile, NamesTheStudies) {
  const std::string missing = errors_of("[run]\nduration = 1\n");
  EXPECT_TRUE(missing.starts_with(
      "c.toml:1:1: study: not given, so nothing else can be checked: add study = \"shear_cell\""));
  EXPECT_TRUE(missing.ends_with(" above the first [table]"));
  for (const Study& study : studies()) EXPECT_NE(missing.find('"' + study.name + '"'), std::string::npos);
  EXPECT_EQ(errors_of("study = \"shear_cel\"\n"),
            "c.toml:1:9: study = \"shear_cel\": there is no such study, so nothing else can be checked: did "
            "you mean "
            "\"shear_cell\"?");
}

TEST(Sample, CountFractionAndCellContradict) {
  EXPECT_EQ(
      with({"fibers.volume_fraction=10 %"}),
      "command line: fibers.volume_fraction = \"10 %\": contradicts fibers.count = 10 (line 5) and cell.size "
      "= "
      "\"0.5 mm\" (line 3): remove all but two of number, fraction and cell; the third follows from them");
  EXPECT_EQ(
      with({"fibers.length_histogram.edges=[\"1 mm\", \"2 mm\"]", "fibers.length_histogram.heights=[1]"}),
      "command line: fibers.length_histogram.edges = [\"1 mm\", \"2 mm\"]: contradicts fibers.length = "
      "\"0.25 mm\" (line 6): remove one of the two");
}

TEST(Sample, RefusesWhatCannotBe) {
  EXPECT_EQ(
      with({"fibers.rod_length=10 um"}),
      "command line: fibers.rod_length = \"10 um\": a rod is shorter than it is thick, fibers.diameter = "
      "\"19 um\" (line 7): give at least one diameter; about five is usual");
  EXPECT_EQ(
      with({"fibers.length=2.5"}),
      "command line: fibers.length = 2.5: out of range: give 1 um to 100 mm (a number without unit is in m)");
  EXPECT_EQ(with({"cell.size=50 um"}),
            "command line: cell.size = \"50 um\": the cell is hardly wider than a fiber, fibers.diameter = "
            "\"19 um\" "
            "(line 7): give edges of at least 4 diameters");
  EXPECT_NE(with({"fibers.count=10000"}), "no error");  // 210 % by volume
}

TEST(Sample, ASingleFiberLiesInTheMiddleOfItsCell) {
  const LoadedCase loaded = load_case(FIBERFATE_SOURCE_DIR "/cases/02_segmentation/case.toml", case_kinds());
  const FiberState state = single_fiber(shear_cell(loaded).sample);
  EXPECT_EQ(state.fiber_count(), 1);
  EXPECT_EQ(state.rod_count(), 25);
  EXPECT_NEAR(fiber_length(state, FiberIndex(0)), 0.5e-3, 1e-15);
  EXPECT_LT((fiber_centroid(state, FiberIndex(0)) - Vec3::Constant(1e-3)).norm(), 1e-15);
  const Vec3 along = (state.position.back() - state.position.front()).normalized();
  EXPECT_LT((along - Vec3(0, 1, 1).normalized()).norm(), 1e-12);
}

TEST(ShearCell, FindsContradictionsOfItsOwn) {
  EXPECT_EQ(
      with({"step.minimum=1 s"}),
      "command line: step.minimum = \"1 s\": larger than step.maximum: give minimum <= initial <= maximum");
  EXPECT_EQ(with({"breakage.law=strength", "breakage.minimum_radius=400 um"}),
            "command line: breakage.minimum_radius = \"400 um\": not less than breakage.maximum_radius: give "
            "the radius "
            "of certain breakage as minimum_radius, the one of none as maximum_radius");
  EXPECT_EQ(with({"output.histogram_times=[2.0]"}),
            "command line: output.histogram_times = [2.0]: 2 s comes after the end, run.duration = \"1 s\" "
            "(line 14): "
            "give times up to run.duration");
  EXPECT_EQ(
      with({"flow.kind=table"}),
      "c.toml:10:1: flow.table: not given; this kind of flow needs it: add table = [[\"0.5 s\", \"10 1/s\", "
      "\"300 Pa s\"], ...] under [flow]");
}

TEST(ShearCell, WarnsOfKeysThatNothingReads) {
  const LoadedCase loaded =
      parse_case(smallest_case, "c.toml", case_kinds(), {"breakage.critical_radius=200 um"});
  ASSERT_EQ(loaded.warnings.size(), 1u);
  EXPECT_EQ(loaded.warnings[0],
            "command line: breakage.critical_radius = \"200 um\": has no effect: it is read by "
            "breakage.law = \"fixed\" only");
}

}  // namespace
}  // namespace fiberfate
