// Tests reading of STL files as other programs write them, and what is said about damaged ones.
#include "io/stl_file.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <limits>

#include "base/error.hpp"
#include "io/atomic_file.hpp"
#include "io/surface_orientation.hpp"
#include "unit/io/scratch_folder.hpp"

namespace fiberfate {
namespace {

const std::string facet = R"(facet normal 0 0 1
 outer loop
  vertex 0 0 0
  vertex 1 0 0
  vertex 0 1 0
 endloop
endfacet
)";
const std::string other_facet =
    "facet normal 0 0 1\nouter loop\nvertex 1 0 0\nvertex 1 1 0\nvertex 0 1 0\nendloop\nendfacet\n";

SurfaceMesh read_text(const std::string& text) {
  const ScratchFolder folder;
  replace_file(folder / "part.stl", text);
  return read_stl(folder / "part.stl", 1e-3);
}

std::string refusal(const std::string& text) {
  try {
    static_cast<void>(read_text(text));
  } catch (const InputError& error) {
    const InputProblem& one = error.problems().front();
    return std::to_string(one.line) + ':' + std::to_string(one.column) + ": " + one.complaint;
  }
  return "read";
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

std::string solid(const std::string& facets) {
  return "solid a\n" + facets + "endsolid a\n";
}

TEST(StlFile, ReadsNamesOfAnyLengthAndWordsInCapitals) {
  const std::string name(5000, 'n');
  EXPECT_EQ(read_text("solid " + name + "\n" + facet + "endsolid " + name + "\n").triangles.size(), 1U);
  std::string capitals = solid(facet);
  for (char& letter : capitals) letter = static_cast<char>(std::toupper(letter));
  EXPECT_EQ(read_text(capitals).triangles.size(), 1U);
  EXPECT_EQ(read_text("\xEF\xBB\xBFsolid\r\n" + facet + "endsolid").triangles.size(), 1U);
  EXPECT_EQ(read_text("solid facet normal\n" + facet + "endsolid").triangles.size(), 1U);
}

TEST(StlFile, MakesARegionOfEverySolid) {
  const SurfaceMesh mesh = read_text(solid(facet) + solid(other_facet));
  EXPECT_EQ(mesh.regions, (std::vector<Index>{0, 1}));
  EXPECT_EQ(mesh.region_names, (std::vector<std::string>{"surface 1", "surface 2"}));
  EXPECT_EQ(mesh.points.size(), 4U);
}

TEST(StlFile, JoinsCornersThatRoundingParts) {
  const std::string moved = replaced(other_facet, "vertex 1 0 0", "vertex 1.000000003 0 0");
  EXPECT_EQ(read_text(solid(facet + moved)).points.size(), 4U);
  const std::string apart = replaced(other_facet, "vertex 1 0 0", "vertex 1.0001 0 0");
  EXPECT_EQ(read_text(solid(facet + apart)).points.size(), 5U);
}

TEST(StlFile, LeavesOutFacetsThatAreGivenTwiceAndTellsHowMany) {
  const SurfaceMesh mesh = read_text(solid(facet + other_facet + facet));
  EXPECT_EQ(mesh.triangles.size(), 2U);
  EXPECT_EQ(mesh.remarks, (std::vector<std::string>{"1 of 3 facets is given twice and left out"}));
  const std::string flat = replaced(other_facet, "vertex 1 1 0", "vertex 1 0 0");
  EXPECT_EQ(read_text(solid(facet + flat)).remarks,
            (std::vector<std::string>{"1 of 2 facets is without area and left out"}));
}

TEST(StlFile, SaysWhereATextIsWrong) {
  EXPECT_EQ(refusal(solid(replaced(facet, "vertex 1 0 0", "vertex 1 nan 0"))),
            "5:12: 'nan': not a finite number");
  EXPECT_EQ(refusal(solid(replaced(facet, "vertex 1 0 0", "vertex 1,5 0 0"))),
            "5:10: '1,5': a decimal comma");
  EXPECT_EQ(refusal(solid(replaced(facet, "endloop", "vertex 3 3 0\nendloop"))),
            "7:2: 'vertex': a facet has more than three corners");
  EXPECT_EQ(refusal("solid\n" + facet).substr(0, 5), "9:1: ");
  EXPECT_EQ(refusal("solid empty\nendsolid\n"), "0:0: there are no triangles");
  EXPECT_EQ(refusal("ISO-10303-21;"), "1:1: is not an STL file, or is cut short");
}

TEST(StlFile, RefusesNumbersOfABinaryFileThatAreNotFinite) {
  std::string bytes(80, ' ');
  const std::uint32_t count = 1;
  bytes.append(reinterpret_cast<const char*>(&count), sizeof count);
  float numbers[12] = {0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0};
  numbers[4] = std::numeric_limits<float>::quiet_NaN();
  bytes.append(reinterpret_cast<const char*>(numbers), sizeof numbers);
  bytes.append(2, '\0');
  EXPECT_EQ(refusal(bytes), "0:0: a corner of facet 1 of 1 is not finite");
}

/// A strip of 2n triangles along x, as n squares.
SurfaceMesh strip(Index squares) {
  SurfaceMesh mesh;
  for (Index i = 0; i <= squares; ++i) {
    mesh.points.emplace_back(i, 0, 0);
    mesh.points.emplace_back(i, 1, 0);
  }
  for (Index i = 0; i < squares; ++i) {
    mesh.triangles.push_back({2 * i, 2 * i + 2, 2 * i + 3});
    mesh.triangles.push_back({2 * i, 2 * i + 3, 2 * i + 1});
  }
  return mesh;
}

TEST(SurfaceOrientation, TurnsTheLesserPart) {
  SurfaceMesh mesh = strip(4);
  const auto sound = mesh.triangles;
  EXPECT_EQ(turn_to_agree(mesh), 0U);
  for (const std::size_t t : {std::size_t{0}, std::size_t{5}})
    std::swap(mesh.triangles[t][1], mesh.triangles[t][2]);
  EXPECT_EQ(turn_to_agree(mesh), 2U);
  EXPECT_EQ(mesh.triangles, sound);
}

TEST(SurfaceOrientation, LeavesAMoebiusStripAsItIs) {
  SurfaceMesh mesh = strip(4);
  // The last two points are the first two, crossed over.
  for (auto& triangle : mesh.triangles)
    for (Index& corner : triangle) corner = corner == 8 ? 1 : corner == 9 ? 0 : corner;
  const auto given = mesh.triangles;
  EXPECT_EQ(turn_to_agree(mesh), 0U);
  EXPECT_EQ(mesh.triangles, given);
}

}  // namespace
}  // namespace fiberfate
