// Reads STL files.
#include "io/stl_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <set>
#include <string_view>

#include "base/error.hpp"
#include "io/input_file.hpp"
#include "io/point_merger.hpp"
#include "io/word_reader.hpp"

namespace fiberfate {
namespace {

constexpr std::size_t head_size = 84;   // bytes before the facets of a binary file
constexpr std::size_t facet_size = 50;  // bytes of each
/// Share of the part's size within which two corners are one point: the rounding of numbers that are written
/// with eight digits.
constexpr double same_place = 1e-8;

/// The corners of one triangle, in units of the file.
struct Facet {
  std::array<Vec3, 3> corners;
  Index solid = 0;
};

static_assert(std::endian::native == std::endian::little, "STL files are little-endian");

bool is_binary(std::string_view bytes) {
  if (bytes.size() < head_size) return false;
  std::uint32_t count = 0;
  std::memcpy(&count, bytes.data() + head_size - sizeof count, sizeof count);
  return bytes.size() == head_size + facet_size * count;
}

std::vector<Facet> binary_facets(std::string_view bytes, const std::string& path) {
  std::vector<Facet> facets((bytes.size() - head_size) / facet_size);
  for (std::size_t i = 0; i < facets.size(); ++i) {
    std::array<float, 12> numbers{};  // the normal and three corners
    std::memcpy(numbers.data(), bytes.data() + head_size + i * facet_size, sizeof numbers);
    for (std::size_t k = 0; k < 3; ++k) {
      facets[i].corners[k] = {numbers[3 * k + 3], numbers[3 * k + 4], numbers[3 * k + 5]};
      if (!facets[i].corners[k].allFinite())
        throw InputError({{path, 0, 0, "", "",
                           fmt::format("a corner of facet {} of {} is not finite", i + 1, facets.size()),
                           "export the surface again"}});
    }
  }
  return facets;
}

/// Reads the facets of a text.
class TextFacets {
 public:
  TextFacets(std::string_view text, const std::string& path) : words_(text, path) {}

  std::vector<Facet> read() {
    std::vector<Facet> facets;
    Index solids = 0;
    while (!words_.at_end()) {
      expect("solid");
      words_.skip_line();
      for (; words_.peek() == "facet"; facets.back().solid = solids) facets.push_back(facet());
      expect("endsolid");
      words_.skip_line();
      ++solids;
    }
    return facets;
  }

 private:
  void expect(std::string_view wanted) {
    if (words_.peek() != wanted)
      words_.refuse(fmt::format("'{}' should stand here", wanted), "export the surface again");
    words_.next();
  }

  Facet facet() {
    expect("facet");
    constexpr int normal_words = 4;  // which say nothing that does not follow from the corners
    for (int i = 0; i < normal_words && words_.peek() != "outer"; ++i) words_.next();
    expect("outer");
    expect("loop");
    Facet facet;
    for (Vec3& corner : facet.corners) {
      expect("vertex");
      for (double& number : corner) number = words_.number();
    }
    if (words_.peek() == "vertex")
      words_.refuse("a facet has more than three corners", "export the surface as triangles");
    expect("endloop");
    expect("endfacet");
    return facet;
  }

  WordReader words_;
};

std::vector<Facet> read_facets(const std::string& path) {
  const std::string bytes = read_input_file(path);
  if (is_binary(bytes)) return binary_facets(bytes, path);
  if (bytes.find('\0') != std::string::npos)
    throw InputError(
        {{path, 1, 1, "", "", "is a binary STL file of another size than its number of facets asks for",
          "export the surface again"}});
  WordReader words(bytes, path);
  if (words.peek() != "solid")
    throw InputError(
        {{path, 1, 1, "", "", "is not an STL file, or is cut short", "export the surface again"}});
  return TextFacets(bytes, path).read();
}

/// The size of the part, or where it lies far out, what its numbers can still distinguish there.
double size_of(const std::vector<Facet>& facets) {
  constexpr double far_out = 1e-6;
  Vec3 low = Vec3::Constant(INFINITY), high = -low;
  for (const Facet& facet : facets)
    for (const Vec3& corner : facet.corners) {
      low = low.cwiseMin(corner);
      high = high.cwiseMax(corner);
    }
  const double distance = std::max(low.cwiseAbs().maxCoeff(), high.cwiseAbs().maxCoeff());
  return facets.empty() ? 0 : std::max((high - low).maxCoeff(), far_out * distance);
}

std::string count_of(std::size_t number, std::size_t all) {
  return fmt::format("{} of {} facets {}", number, all, number == 1 ? "is" : "are");
}

}  // namespace

SurfaceMesh read_stl(const std::string& path, double unit) {
  const std::vector<Facet> facets = read_facets(path);
  PointMerger points(same_place * size_of(facets));
  SurfaceMesh mesh;
  std::set<std::array<Index, 3>> known;
  std::size_t doubled = 0, collapsed = 0;
  for (std::size_t i = 0; i < facets.size(); ++i) {
    std::array<Index, 3> triangle{};
    for (std::size_t k = 0; k < 3; ++k) triangle[k] = points.index_of(facets[i].corners[k]);
    std::array<Index, 3> sorted = triangle;
    std::sort(sorted.begin(), sorted.end());
    const bool flat = sorted[0] == sorted[1] || sorted[1] == sorted[2];
    const bool twice = !flat && !known.insert(sorted).second;
    collapsed += flat ? 1 : 0;
    doubled += twice ? 1 : 0;
    if (flat || twice) continue;
    mesh.triangles.push_back(triangle);
    mesh.regions.push_back(facets[i].solid);
    mesh.numbers.push_back(i + 1);
  }
  if (mesh.triangles.empty())
    throw InputError({{path, 0, 0, "", "", "there are no triangles", "export the surface again"}});
  for (const Vec3& point : points.points()) mesh.points.push_back(unit * point);
  for (Index solid = 0; solid <= facets.back().solid; ++solid)
    mesh.region_names.push_back(fmt::format("surface {}", solid + 1));
  if (doubled > 0) mesh.remarks.push_back(count_of(doubled, facets.size()) + " given twice and left out");
  if (collapsed > 0)
    mesh.remarks.push_back(count_of(collapsed, facets.size()) + " without area and left out");
  return mesh;
}

}  // namespace fiberfate
