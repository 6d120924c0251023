// Tests reading of .msh and .stl files, and the messages for files that are something else.
#include "io/surface_file.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <sstream>

#include "base/error.hpp"
#include "io/atomic_file.hpp"
#include "unit/io/scratch_folder.hpp"

namespace fiberfate {
namespace {

/// Two triangles of a square in mm, each a physical surface; point 5 belongs to neither.
const std::string square_msh = R"($MeshFormat
2.2 0 8
$EndMeshFormat
$PhysicalNames
2
2 1 "left"
2 2 "right"
$EndPhysicalNames
$Nodes
5
1 0 0 0
2 10 0 0
3 10 10 0
4 0 10 0
5 99 99 99
$EndNodes
$Elements
2
1 2 2 1 1 1 3 4
2 2 2 2 2 1 2 3
$EndElements
)";

const char* const square_stl = R"(solid square
facet normal 0 0 1
outer loop
vertex 0 0 0
vertex 10 10 0
vertex 0 10 0
endloop
endfacet
facet normal 0 0 1
outer loop
vertex 0 0 0
vertex 10 0 0
vertex 10 10 0
endloop
endfacet
endsolid square
)";

std::string message_for(const std::string& path) {
  try {
    (void)read_surface(path, 1e-3);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(SurfaceFile, ReadsGmshMeshesWithTheirRegions) {
  const ScratchFolder folder;
  replace_file(folder / "part.msh", square_msh);
  const SurfaceMesh mesh = read_surface(folder / "part.msh", 1e-3);
  ASSERT_EQ(mesh.points.size(), 4U);
  EXPECT_TRUE(mesh.points[2].isApprox(Vec3(0.01, 0.01, 0)));
  ASSERT_EQ(mesh.triangles.size(), 2U);
  EXPECT_EQ(mesh.triangles[0], (std::array<Index, 3>{0, 2, 3}));
  EXPECT_EQ(mesh.region_names, (std::vector<std::string>{"left", "right"}));
  EXPECT_EQ(mesh.regions, (std::vector<Index>{0, 1}));
}

const char* const thickness_data = R"($ElementData
1
"wall"
1
0
3
0
1
2
2 1.5
1 2.5
$EndElementData
)";

/// The mesh with data on its elements, which are told by `section`.
std::string square_with_data(const char* section) {
  std::ostringstream text;
  text << square_msh;
  std::istringstream lines(thickness_data);
  for (std::string line; std::getline(lines, line);) {
    if (line == "$ElementData") line = std::string("$") + section;
    if (line == "$EndElementData") line = std::string("$End") + section;
    text << line << '\n';
  }
  return text.str();
}

std::string data_message_for(const std::string& path, const std::string& name) {
  try {
    (void)read_element_data(path, name);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(SurfaceFile, ReadsNumbersOfElementsAndTheirData) {
  const ScratchFolder folder;
  const std::string path = folder / "part.msh";
  replace_file(path, square_with_data("ElementData"));
  EXPECT_EQ(read_surface(path, 1e-3).numbers, (std::vector<std::size_t>{1, 2}));
  const ElementData data = read_element_data(path, "wall");
  ASSERT_EQ(data.elements.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) EXPECT_EQ(data.values[i], data.elements[i] == 1 ? 2.5 : 1.5);
  EXPECT_NE(data_message_for(path, "Wall").find("there is no data \"Wall\": it has \"wall\""),
            std::string::npos);
  replace_file(path, square_msh);
  EXPECT_NE(data_message_for(path, "wall").find("add a section $ElementData"), std::string::npos);
  replace_file(path, square_with_data("NodeData"));
  EXPECT_NE(data_message_for(path, "wall").find("NodeData"), std::string::npos);
}

TEST(SurfaceFile, JoinsTheCornersOfStl) {
  const ScratchFolder folder;
  replace_file(folder / "part.stl", square_stl);
  const SurfaceMesh mesh = read_surface(folder / "part.stl", 1e-3);
  EXPECT_EQ(mesh.points.size(), 4U);
  EXPECT_EQ(mesh.triangles.size(), 2U);
}

TEST(SurfaceFile, ReadsBinaryStl) {
  const ScratchFolder folder;
  std::string bytes(80, ' ');
  const std::uint32_t count = 1;
  bytes.append(reinterpret_cast<const char*>(&count), sizeof count);
  const float numbers[12] = {0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0};
  bytes.append(reinterpret_cast<const char*>(numbers), sizeof numbers);
  bytes.append(2, '\0');
  replace_file(folder / "part.STL", bytes);
  EXPECT_EQ(read_surface(folder / "part.STL", 1).triangles.size(), 1U);
  replace_file(folder / "part.STL", bytes.substr(0, 100));
  EXPECT_NE(message_for(folder / "part.STL").find("is a binary STL file of another size"), std::string::npos);
}

TEST(SurfaceFile, SaysWhatIsWrongWithOtherFiles) {
  const ScratchFolder folder;
  EXPECT_NE(message_for(folder / "none.msh").find("cannot be read"), std::string::npos);
  replace_file(folder / "part.step", "ISO-10303-21;");
  EXPECT_NE(message_for(folder / "part.step").find("neither a .msh nor an .stl file"), std::string::npos);
  replace_file(folder / "script.msh", "SystemCall \"true\";");
  EXPECT_NE(message_for(folder / "script.msh").find("is not a Gmsh mesh"), std::string::npos);
  replace_file(folder / "empty.msh", "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n");
  EXPECT_NE(message_for(folder / "empty.msh").find("there are no triangles"), std::string::npos);
}

TEST(SurfaceFile, TurnsAFlippedTriangleAndTellsIt) {
  const ScratchFolder folder;
  std::string text = square_msh;
  const std::string second = "1 2 3\n$EndElements";
  text.replace(text.find(second), second.size(), "1 3 2\n$EndElements");
  replace_file(folder / "part.msh", text);
  const SurfaceMesh mesh = read_surface(folder / "part.msh", 1);
  EXPECT_EQ(mesh.remarks, (std::vector<std::string>{"1 of 2 triangles is turned to agree with the others"}));
}

TEST(SurfaceFile, ReadsAMeshBehindComments) {
  const ScratchFolder folder;
  replace_file(folder / "part.msh", "$Comments\nby hand\n$EndComments\n" + square_msh);
  EXPECT_EQ(read_surface(folder / "part.msh", 1).triangles.size(), 2U);
  replace_file(folder / "part.msh", "$Comments\n$EndComments\nSystemCall \"true\";");
  EXPECT_NE(message_for(folder / "part.msh").find("is not a Gmsh mesh"), std::string::npos);
  replace_file(folder / "part.msh", "$MeshFormatting\nSystemCall \"true\";");
  EXPECT_NE(message_for(folder / "part.msh").find("is not a Gmsh mesh"), std::string::npos);
}

TEST(SurfaceFile, RefusesWhatGmshTripsOver) {
  const ScratchFolder folder;
  std::string text = square_msh;
  const std::string second = "1 2 3\n$EndElements";
  text.replace(text.find(second), second.size(), "1 2 33\n$EndElements");
  replace_file(folder / "part.msh", text);
  EXPECT_NE(message_for(folder / "part.msh"), "");
  text = square_msh;
  text.replace(text.find("3 10 10 0"), 9, "3 nan 10 0");
  replace_file(folder / "part.msh", text);
  EXPECT_NE(message_for(folder / "part.msh"), "");
}

TEST(SurfaceFile, RefusesQuadrangles) {
  const ScratchFolder folder;
  std::string text = square_msh;
  const std::string first = "1 2 2 1 1 1 3 4";
  text.replace(text.find(first), first.size(), "1 3 2 1 1 1 2 3 4");
  replace_file(folder / "part.msh", text);
  EXPECT_NE(message_for(folder / "part.msh").find("quadrangles"), std::string::npos);
}

}  // namespace
}  // namespace fiberfate
