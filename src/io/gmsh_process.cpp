// Calls Gmsh in a child process and takes its answer.
#include "io/gmsh_process.hpp"

#include <fmt/format.h>

#include "base/error.hpp"
#include "io/byte_stream.hpp"
#include "io/child_process.hpp"

namespace fiberfate {
namespace {

/// Gives the answer of a child process, in bytes.
template <class Make, class Pack>
std::string answer_of(const GmshTask& task, const Make& make, const Pack& pack) {
  static_cast<void>(gmsh_library());  // loaded once here, not in every child
  const auto work = [&] {
    try {
      const GmshSession session;
      ByteWriter bytes;
      pack(make(session), bytes);
      return bytes.take();
    } catch (const GmshError& error) {
      throw InputError(fmt::format("{}: {}", task.complaint, error.what()), task.remedy);
    }
  };
  try {
    return run_in_child(work, {.processor_seconds = task.processor_seconds});
  } catch (const ChildFailure& failure) {
    throw InputError(fmt::format("{}: {}", task.complaint, failure.what()), task.remedy);
  }
}

}  // namespace

SurfaceMesh surface_from_gmsh(const GmshTask& task,
                              const std::function<SurfaceMesh(const GmshSession&)>& make) {
  const std::string answer = answer_of(task, make, [](const SurfaceMesh& mesh, ByteWriter& bytes) {
    std::vector<double> coordinates;
    for (const Vec3& point : mesh.points)
      coordinates.insert(coordinates.end(), point.data(), point.data() + point.size());
    bytes.put(coordinates);
    bytes.put(mesh.triangles);
    bytes.put(mesh.regions);
    bytes.put(mesh.region_names);
    bytes.put(mesh.numbers);
  });
  ByteReader bytes(answer);
  SurfaceMesh mesh;
  const auto coordinates = bytes.take<std::vector<double>>();
  for (std::size_t i = 0; i + 2 < coordinates.size(); i += 3)
    mesh.points.emplace_back(coordinates[i], coordinates[i + 1], coordinates[i + 2]);
  bytes.take(mesh.triangles);
  bytes.take(mesh.regions);
  bytes.take(mesh.region_names);
  bytes.take(mesh.numbers);
  return mesh;
}

ElementData data_from_gmsh(const GmshTask& task, const std::function<ElementData(const GmshSession&)>& make) {
  const std::string answer = answer_of(task, make, [](const ElementData& data, ByteWriter& bytes) {
    bytes.put(data.elements);
    bytes.put(data.values);
  });
  ByteReader bytes(answer);
  ElementData data;
  bytes.take(data.elements);
  bytes.take(data.values);
  return data;
}

}  // namespace fiberfate
