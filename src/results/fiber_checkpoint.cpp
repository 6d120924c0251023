// Saves and restores runs as HDF5 files.
#include "results/fiber_checkpoint.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "base/error.hpp"
#include "fibers/state_check.hpp"
#include "results/checkpoint_file.hpp"

namespace fiberfate {
namespace {

template <class T>
std::span<const T> view(const std::vector<T>& values) {
  return {values.data(), values.size()};
}

std::vector<double> flattened(const std::vector<Vec3>& vectors) {
  std::vector<double> numbers;
  numbers.reserve(3 * vectors.size());
  for (const Vec3& vector : vectors) numbers.insert(numbers.end(), vector.data(), vector.data() + 3);
  return numbers;
}

std::vector<Vec3> vectors_of(const std::vector<double>& numbers) {
  std::vector<Vec3> vectors(numbers.size() / 3);
  for (std::size_t i = 0; i < vectors.size(); ++i) vectors[i] = Vec3(&numbers[3 * i]);
  return vectors;
}

/// Writes numbers as dataset of a group, or reads them back: one list of names serves both ways.
class Saver {
 public:
  explicit Saver(Hdf5File& file) : file_(file) {}
  template <class T>
  void array(const std::string& name, const std::vector<T>& values) {
    file_.write(name, view(values));
  }
  template <class Kind>
  void array(const std::string& name, const std::vector<IndexOf<Kind>>& values) {
    file_.write(name, numbers(values));
  }
  void array(const std::string& name, const std::vector<Vec3>& values) {
    const std::vector<double> numbers = flattened(values);
    file_.write(name, view(numbers), 3);
  }
  template <class T>
  void number(const std::string& group, const char* name, T value) {
    file_.write_attribute(group, name, value);
  }
  void group(const std::string& name) { file_.make_group(name); }

 private:
  Hdf5File& file_;
};

class Loader {
 public:
  explicit Loader(const Hdf5File& file) : file_(file) {}
  template <class T>
  void array(const std::string& name, std::vector<T>& values) {
    values = file_.read<T>(name);
  }
  template <class Kind>
  void array(const std::string& name, std::vector<IndexOf<Kind>>& values) {
    values.clear();
    for (const Index number : file_.read<Index>(name)) values.emplace_back(number);
  }
  void array(const std::string& name, std::vector<Vec3>& values) {
    file_.require_columns(name, 3);
    values = vectors_of(file_.read<double>(name));
  }
  /// Reads a dataset of so many columns, and so many rows.
  template <class T>
  std::vector<T> table(const std::string& name, std::uint64_t columns) {
    file_.require_columns(name, columns);
    return file_.read<T>(name);
  }
  template <class T>
  std::vector<T> table(const std::string& name, std::uint64_t columns, std::uint64_t rows) {
    if (file_.rows(name) != rows)
      throw StorageError(fmt::format("cannot read {}: dataset {} has {} rows where {} belong", file_.path(),
                                     name, file_.rows(name), rows));
    return table<T>(name, columns);
  }
  template <class T>
  void number(const std::string& group, const char* name, T& value) {
    value = file_.read_attribute<T>(group, name);
  }
  void group(const std::string&) {}

 private:
  const Hdf5File& file_;
};

/// Visits every part of the state once, by name, for saving and for loading.
template <class Visitor, class State>
void visit_state(Visitor& visitor, State& state) {
  visitor.group("state");
  visitor.array("state/position", state.position);
  visitor.array("state/relative_velocity", state.relative_velocity);
  visitor.array("state/rod_length", state.rod_length);
  visitor.array("state/first_node", state.first_node);
  visitor.array("state/birth_id", state.birth_id);
  visitor.array("state/birth_node", state.birth_node);
  visitor.array("state/material_id", state.material_id);
  visitor.array("state/touches_previous", state.touches_previous);
  visitor.number("state", "time", state.time);
  visitor.number("state", "step_size", state.step_size);
  visitor.number("state", "step", state.step);
  visitor.number("state", "rod_steps", state.rod_steps);
  visitor.number("state", "breakage_checks", state.breakage_checks);
  visitor.number("state", "breaks", state.breaks);
}

template <class Visitor, class Record>
void visit_record(Visitor& visitor, Record& record) {
  visitor.group("record");
  visitor.number("record", "series_rows", record.series_rows);
  visitor.number("record", "break_rows", record.break_rows);
  visitor.number("record", "frames", record.frames);
  visitor.number("record", "rejections", record.rejections);
  visitor.number("record", "wall_s", record.wall_s);
  visitor.number("record", "cpu_s", record.cpu_s);
}

/// The lattice of a flow that stretches or turns it; one that is carried needs none of this.
void write_frame(Hdf5File& file, const LatticeFrame& frame) {
  if (frame.kind == LatticeKind::carried) return;
  const std::vector<double> axes(frame.axes.data(), frame.axes.data() + 9);
  const std::vector<double> first(frame.first.data(), frame.first.data() + 9);
  const std::vector<double> strain(frame.strain.data(), frame.strain.data() + 3);
  const std::vector<std::int32_t> basis(frame.basis.data(), frame.basis.data() + 9);
  file.write("state/frame_kind", view(std::vector<std::uint8_t>{static_cast<std::uint8_t>(frame.kind)}));
  file.write("state/frame_axes", view(axes), 3);
  file.write("state/frame_first", view(first), 3);
  file.write("state/frame_strain", view(strain));
  file.write("state/frame_basis", view(basis), 3);
}

LatticeFrame read_frame(const Hdf5File& file, Loader& loader) {
  LatticeFrame frame;
  if (!file.contains("state/frame_kind")) return frame;
  const int kind = loader.table<std::uint8_t>("state/frame_kind", 1, 1).front();
  if (kind > static_cast<int>(LatticeKind::rotating))
    throw StorageError(fmt::format("cannot read {}: its lattice is of an unknown kind", file.path()));
  frame.kind = static_cast<LatticeKind>(kind);
  frame.axes = Mat3(loader.table<double>("state/frame_axes", 3, 3).data());
  frame.first = Mat3(loader.table<double>("state/frame_first", 3, 3).data());
  frame.strain = Vec3(loader.table<double>("state/frame_strain", 1, 3).data());
  frame.basis = Eigen::Matrix3i(loader.table<std::int32_t>("state/frame_basis", 3, 3).data());
  return frame;
}

void write_rest(Hdf5File& file, const Checkpoint& checkpoint) {
  const FiberState& state = checkpoint.state;
  std::vector<double> lattice(state.cell.lattice.data(), state.cell.lattice.data() + 9);
  std::vector<std::uint8_t> boundary;
  for (const Boundary one : state.cell.boundary) boundary.push_back(one == Boundary::walls ? 1 : 0);
  std::vector<double> materials;
  for (const FiberMaterial& material : state.materials)
    materials.insert(materials.end(), {material.radius, material.youngs_modulus, material.density});
  std::vector<double> seconds;
  for (std::size_t phase = 0; phase < phase_count; ++phase)
    seconds.push_back(checkpoint.record.times.seconds(static_cast<Phase>(phase)));
  file.write("state/lattice", view(lattice), 3);
  write_frame(file, state.cell.frame);
  file.write("state/boundary", view(boundary));
  file.write("state/materials", view(materials), 3);
  file.write("record/timings", view(seconds));
  if (!checkpoint.record.stress.empty()) file.write("record/stress", view(checkpoint.record.stress));
  if (!checkpoint.record.stress_history.empty())
    file.write("record/stress_history", view(checkpoint.record.stress_history));
  file.write_text("case", checkpoint.resolved_case);
}

void read_rest(const Hdf5File& file, Loader& loader, Checkpoint& checkpoint) {
  FiberState& state = checkpoint.state;
  state.cell.lattice = Mat3(loader.table<double>("state/lattice", 3, 3).data());
  state.cell.frame = read_frame(file, loader);
  const auto boundary = loader.table<std::uint8_t>("state/boundary", 1, 3);
  for (std::size_t i = 0; i < 3; ++i)
    state.cell.boundary[i] = boundary[i] == 1 ? Boundary::walls : Boundary::periodic;
  const auto materials = loader.table<double>("state/materials", 3);
  for (std::size_t i = 0; i < materials.size(); i += 3)
    state.materials.push_back({materials[i], materials[i + 1], materials[i + 2]});
  const auto seconds = loader.table<double>("record/timings", 1, phase_count);
  for (std::size_t phase = 0; phase < phase_count; ++phase)
    checkpoint.record.times.add(static_cast<Phase>(phase), seconds[phase]);
  if (file.contains("record/stress")) checkpoint.record.stress = loader.table<double>("record/stress", 1);
  if (file.contains("record/stress_history"))
    checkpoint.record.stress_history = loader.table<double>("record/stress_history", 1);
  checkpoint.resolved_case = file.read_text("case");
}

/// Whether every fiber has a rod at least, and all of them have all nodes.
bool has_ordered_nodes(const FiberState& state) {
  const auto& first = state.first_node;
  const auto is_short = [](NodeIndex begin, NodeIndex end) { return end < begin + 2; };
  return first.front() == NodeIndex(0) && first.back() == NodeIndex(state.node_count()) &&
         std::adjacent_find(first.begin(), first.end(), is_short) == first.end();
}

/// Whether offsets and arrays belong together, so that damage that HDF5 does not see is caught here.
bool is_whole(const FiberState& state) {
  const auto nodes = state.position.size();
  const auto fibers = state.birth_id.size();
  return state.relative_velocity.size() == nodes && state.rod_length.size() == nodes &&
         state.first_node.size() == fibers + 1 && state.birth_node.size() == fibers &&
         state.material_id.size() == fibers && state.touches_previous.size() == fibers &&
         has_ordered_nodes(state);
}

/// Whether nothing is counted or timed that cannot be.
bool is_countable(const Checkpoint& checkpoint) {
  const FiberState& state = checkpoint.state;
  const RunRecord& record = checkpoint.record;
  const std::int64_t counts[] = {state.step,    state.rod_steps,    state.breakage_checks,
                                 state.breaks,  record.series_rows, record.break_rows,
                                 record.frames, record.rejections};
  const double seconds[] = {state.time, state.step_size, record.wall_s, record.cpu_s};
  return std::all_of(std::begin(counts), std::end(counts), [](std::int64_t count) { return count >= 0; }) &&
         std::all_of(std::begin(seconds), std::end(seconds),
                     [](double one) { return one >= 0 && std::isfinite(one); });
}

/// Compares the parts of a checkpoint with each other and with what a run can leave: damage that checksums do
/// not see is caught here.
void require_whole(const std::string& path, const Checkpoint& checkpoint) {
  const auto refuse = [&path](const std::string& reason) {
    throw StorageError("cannot read " + path + ": " + reason);
  };
  if (!is_whole(checkpoint.state)) refuse("its arrays do not belong together");
  if (!is_countable(checkpoint)) refuse("a count or a time is negative or not finite");
  try {
    require_sound(checkpoint.state);
  } catch (const InputError& fault) {
    refuse(fault.problems().front().complaint);
  }
}

/// Fills a new checkpoint file.
CheckpointBody body_of(const Checkpoint& checkpoint) {
  return [&checkpoint](Hdf5File& file) {
    Saver saver(file);
    visit_state(saver, checkpoint.state);
    visit_record(saver, checkpoint.record);
    write_rest(file, checkpoint);
  };
}

}  // namespace

void write_checkpoint(const std::string& path, const Checkpoint& checkpoint) {
  write_checkpoint_file(path, body_of(checkpoint));
}

Checkpoint read_checkpoint(const std::string& path) {
  const Hdf5File file = open_checkpoint_file(path);
  Checkpoint checkpoint;
  Loader loader(file);
  visit_state(loader, checkpoint.state);
  visit_record(loader, checkpoint.record);
  read_rest(file, loader, checkpoint);
  require_whole(path, checkpoint);
  return checkpoint;
}

void save_checkpoint(Recorder& recorder, const Checkpoint& checkpoint) {
  recorder.save_checkpoint(body_of(checkpoint));
}

void save_failure(Recorder& recorder, const Checkpoint& checkpoint) {
  recorder.save_failure(body_of(checkpoint));
}

Checkpoint load_checkpoint(Recorder& recorder) {
  Checkpoint checkpoint;
  recorder.read_checkpoint([&](const std::string& path) { checkpoint = read_checkpoint(path); });
  return checkpoint;
}

}  // namespace fiberfate
