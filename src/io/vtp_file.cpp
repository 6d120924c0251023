// Writes VTK XML files. Source: VTK File Formats, "PolyData", "UnstructuredGrid", "Appended data",
// header_type UInt64.
#include "io/vtp_file.hpp"

#include <fmt/format.h>

#include <bit>
#include <numeric>

#include "io/atomic_file.hpp"

namespace fiberfate {
namespace {

static_assert(std::endian::native == std::endian::little, "the appended data are declared little-endian");

template <class T>
constexpr const char* type_name() {
  if constexpr (std::is_same_v<T, double>) return "Float64";
  if constexpr (std::is_same_v<T, float>) return "Float32";
  if constexpr (std::is_same_v<T, std::uint8_t>) return "UInt8";
  if constexpr (std::is_same_v<T, std::int32_t>) return "Int32";
  if constexpr (std::is_same_v<T, std::uint32_t>) return "UInt32";
  if constexpr (std::is_same_v<T, std::int64_t>) return "Int64";
}

/// Collects the XML and, apart, the raw numbers that it refers to by offset.
class VtkXml {
 public:
  void line(const std::string& text) { xml_ += text + '\n'; }
  template <class T>
  void array(const std::string& name, int components, const std::vector<T>& values) {
    line(fmt::format(
        R"(<DataArray type="{}" Name="{}" NumberOfComponents="{}" format="appended" offset="{}"/>)",
        type_name<T>(), name, components, raw_.size()));
    const std::uint64_t bytes = values.size() * sizeof(T);
    raw_.append(reinterpret_cast<const char*>(&bytes), sizeof bytes);
    raw_.append(reinterpret_cast<const char*>(values.data()), bytes);
  }
  void arrays(const char* element, const std::vector<FrameArray>& list) {
    line(fmt::format("<{}>", element));
    for (const FrameArray& one : list)
      std::visit([&](const auto& values) { array(one.name, one.components, values); }, one.values);
    line(fmt::format("</{}>", element));
  }
  [[nodiscard]] std::string whole() const {
    return xml_ + "<AppendedData encoding=\"raw\">\n_" + raw_ + "\n</AppendedData>\n</VTKFile>\n";
  }

 private:
  std::string xml_;
  std::string raw_;
};

void add_field_data(VtkXml& text, const PolyFrame& frame) {
  text.line("<FieldData>");
  text.line(fmt::format(
      R"(<DataArray type="Float64" Name="TimeValue" NumberOfTuples="1" format="ascii">{}</DataArray>)",
      frame.time));
  for (const FrameArray& array : frame.frame_data) {
    std::visit(
        [&](const auto& values) {
          text.line(fmt::format(
              R"(<DataArray type="{}" Name="{}" NumberOfComponents="{}" NumberOfTuples="1" format="ascii">{}</DataArray>)",
              type_name<typename std::decay_t<decltype(values)>::value_type>(), array.name, array.components,
              fmt::join(values, " ")));
        },
        array.values);
  }
  text.line("</FieldData>");
}

}  // namespace

void write_vtp(const std::string& path, const PolyFrame& frame) {
  std::vector<std::int64_t> connectivity = frame.connectivity;
  if (connectivity.empty()) {
    connectivity.resize(frame.points.size() / 3);
    std::iota(connectivity.begin(), connectivity.end(), 0);
  }
  const bool lines = frame.shape == CellShape::polyline;
  const std::size_t cells = frame.offsets.size() - 1;
  VtkXml text;
  text.line(R"(<VTKFile type="PolyData" version="1.0" byte_order="LittleEndian" header_type="UInt64">)");
  text.line("<PolyData>");
  add_field_data(text, frame);
  text.line(fmt::format(
      R"(<Piece NumberOfPoints="{}" NumberOfVerts="0" NumberOfLines="{}" NumberOfStrips="0" NumberOfPolys="{}">)",
      frame.points.size() / 3, lines ? cells : 0, lines ? 0 : cells));
  text.line("<Points>");
  text.array("Points", 3, frame.points);
  text.line(lines ? "</Points>\n<Lines>" : "</Points>\n<Polys>");
  text.array("connectivity", 1, connectivity);
  // The XML format counts from the end of the first cell.
  text.array("offsets", 1, std::vector<std::int64_t>(frame.offsets.begin() + 1, frame.offsets.end()));
  text.line(lines ? "</Lines>" : "</Polys>");
  text.arrays("PointData", frame.point_data);
  text.arrays("CellData", frame.cell_data);
  text.line("</Piece>\n</PolyData>");
  replace_file(path, text.whole());
}

void write_vtu(const std::string& path, const PrismMesh& prisms) {
  const std::vector<std::int64_t> connectivity = wedges_of(prisms);
  std::vector<std::int64_t> ends;
  for (std::size_t end = wedge_points; end <= connectivity.size(); end += wedge_points)
    ends.push_back(static_cast<std::int64_t>(end));
  VtkXml text;
  text.line(
      R"(<VTKFile type="UnstructuredGrid" version="1.0" byte_order="LittleEndian" header_type="UInt64">)");
  text.line("<UnstructuredGrid>");
  text.line(fmt::format(R"(<Piece NumberOfPoints="{}" NumberOfCells="{}">)", prisms.points.size() / 3,
                        ends.size()));
  text.line("<Points>");
  text.array("Points", 3, prisms.points);
  text.line("</Points>\n<Cells>");
  text.array("connectivity", 1, connectivity);
  text.array("offsets", 1, ends);
  text.array("types", 1, std::vector<std::uint8_t>(ends.size(), vtk_wedge));
  text.line("</Cells>");
  text.arrays("PointData", prisms.point_data);
  text.line("</Piece>\n</UnstructuredGrid>");
  replace_file(path, text.whole());
}

void write_pvd(const std::string& path, const std::vector<SeriesMember>& members) {
  std::string text =
      "<VTKFile type=\"Collection\" version=\"1.0\" byte_order=\"LittleEndian\">\n<Collection>\n";
  for (const SeriesMember& member : members)
    text += fmt::format("<DataSet timestep=\"{}\" part=\"0\" file=\"{}\"/>\n", member.time, member.file);
  replace_file(path, text + "</Collection>\n</VTKFile>\n");
}

}  // namespace fiberfate
