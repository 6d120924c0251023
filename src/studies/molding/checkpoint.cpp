// Fillings in HDF5 files (docs/formats/checkpoint.md).
#include "studies/molding/checkpoint.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include "base/error.hpp"
#include "molding/state_checks.hpp"
#include "results/checkpoint_file.hpp"

namespace fiberfate {
namespace {

/// Writes parts of a checkpoint or reads them back: one list of names serves both ways.
class Saver {
 public:
  explicit Saver(Hdf5File& file) : file_(file) {}
  template <class T>
  void array(const std::string& name, std::vector<T>& values) {
    file_.write(name, std::span<const T>(values));
  }
  template <class T>
  void number(const char* name, T& value) {
    file_.write_attribute("state", name, value);
  }
  template <class Enum>
  void choice(const char* name, Enum& value) {
    file_.write_attribute("state", name, static_cast<std::int64_t>(value));
  }

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
  template <class T>
  void number(const char* name, T& value) {
    value = file_.read_attribute<T>("state", name);
  }
  template <class Enum>
  void choice(const char* name, Enum& value) {
    value = static_cast<Enum>(file_.read_attribute<std::int64_t>("state", name));
  }

 private:
  const Hdf5File& file_;
};

/// Visits every number and plain array of the state once, by name.
template <class Visitor>
void visit_state(Visitor& visitor, FillingState& state) {
  visitor.number("time", state.time);
  visitor.number("steps", state.steps);
  visitor.choice("end", state.stop_reason);
  visitor.choice("control", state.control);
  visitor.number("sprue_pressure", state.sprue_pressure);
  visitor.number("flow_rate", state.flow_rate);
  visitor.number("held_pressure", state.held_pressure);
  visitor.number("injected_volume", state.injected_volume);
  visitor.number("filled_volume", state.filled_volume);
  visitor.number("heat_brought_in", state.heat.brought_in);
  visitor.number("heat_dissipated", state.heat.dissipated);
  visitor.number("heat_to_mold", state.heat.to_mold);
  visitor.array("state/sensor_arrivals", state.sensor_arrivals);
  visitor.array("state/filled", state.filled);
  visitor.array("state/excess", state.excess);
  visitor.array("state/fill_time", state.fill_time);
  visitor.array("state/pressure", state.pressure);
  visitor.array("state/temperature", state.temperature);
  visitor.array("state/rate", state.rate);
  for (std::size_t k = 0; k < state.orientation.size(); ++k)
    visitor.array(fmt::format("state/orientation_{}", k), state.orientation[k]);
  visitor.array("state/lengths", state.lengths);
}

template <class Visitor, class Record>
void visit_record(Visitor& visitor, Record& record) {
  visitor.number("series_rows", record.series_rows);
  visitor.number("frames", record.frames);
  visitor.number("wall_s", record.wall_s);
  visitor.number("cpu_s", record.cpu_s);
  visitor.number("greatest_pressure", record.greatest_pressure);
}

constexpr std::size_t gate_numbers = 5, event_numbers = 4;

void write_structures(Hdf5File& file, const MoldingCheckpoint& checkpoint) {
  const FillingState& state = checkpoint.state;
  std::vector<double> gates, events;
  for (const GateState& gate : state.gates)
    gates.insert(gates.end(),
                 {static_cast<double>(gate.moves), gate.arrival_time, gate.pressure, gate.rate, gate.volume});
  for (const FillingEvent& event : state.events)
    events.insert(events.end(), {event.time, event.filled_fraction, static_cast<double>(event.kind),
                                 static_cast<double>(event.gate)});
  std::vector<std::uint8_t> mark;
  for (const NodeMark one : state.mark) mark.push_back(static_cast<std::uint8_t>(one));
  file.write("state/gates", std::span<const double>(gates), gate_numbers);
  file.write("state/events", std::span<const double>(events), event_numbers);
  for (const auto& [name, vectors] :
       {std::pair("state/inflow", &state.inflow), {"state/gradient", &state.gradient}}) {
    std::vector<double> numbers;
    for (const Vec2& vector : *vectors) numbers.insert(numbers.end(), vector.data(), vector.data() + 2);
    file.write(name, std::span<const double>(numbers), 2);
  }
  const std::vector<std::uint8_t> covered(state.covered.begin(), state.covered.end());
  file.write("state/covered", std::span<const std::uint8_t>(covered));
  file.write("state/mark", std::span<const std::uint8_t>(mark));
}

/// Reads a dataset whose rows have so many numbers; raises StorageError where they have not.
template <class T>
std::vector<T> read_table(const Hdf5File& file, const char* name, std::uint64_t columns) {
  if (file.columns(name) != columns)
    throw StorageError(
        fmt::format("cannot read {}: dataset {} has rows of {} numbers where {} belong: continue from an "
                    "older checkpoint, or run the case again",
                    file.path(), name, file.columns(name), columns));
  return file.read<T>(name);
}

/// Reads a small whole number that is stored as a double; what is none becomes -9, which no check lets pass.
int whole(double value) {
  return value >= -1 && value < 1e9 && value == std::floor(value) ? static_cast<int>(value) : -9;
}

void read_structures(const Hdf5File& file, FillingState& state) {
  const auto gates = read_table<double>(file, "state/gates", gate_numbers);
  const auto events = read_table<double>(file, "state/events", event_numbers);
  for (std::size_t i = 0; i < gates.size(); i += gate_numbers)
    state.gates.push_back({whole(gates[i]), gates[i + 1], gates[i + 2], gates[i + 3], gates[i + 4]});
  for (std::size_t i = 0; i < events.size(); i += event_numbers)
    state.events.push_back({events[i], events[i + 1], static_cast<FillingEventKind>(whole(events[i + 2])),
                            whole(events[i + 3])});
  for (const auto& [name, vectors] :
       {std::pair("state/inflow", &state.inflow), {"state/gradient", &state.gradient}}) {
    const auto numbers = read_table<double>(file, name, 2);
    for (std::size_t i = 0; i < numbers.size(); i += 2) vectors->emplace_back(numbers[i], numbers[i + 1]);
  }
  const auto covered = file.read<std::uint8_t>("state/covered");
  state.covered.assign(covered.begin(), covered.end());
  for (const std::uint8_t one : file.read<std::uint8_t>("state/mark"))
    state.mark.push_back(static_cast<NodeMark>(one));
}

void write_shell(Hdf5File& file, const Shell& shell) {
  std::vector<double> nodes;
  for (const Vec3& node : shell.nodes) nodes.insert(nodes.end(), node.data(), node.data() + 3);
  std::vector<std::int32_t> triangles;
  for (const auto& triangle : shell.triangles)
    triangles.insert(triangles.end(), triangle.begin(), triangle.end());
  const std::vector<std::int32_t> region(shell.region.begin(), shell.region.end());
  file.write("shell/nodes", std::span<const double>(nodes), 3);
  file.write("shell/triangles", std::span<const std::int32_t>(triangles), 3);
  file.write("shell/thickness", std::span<const double>(shell.thickness));
  file.write("shell/region", std::span<const std::int32_t>(region));
  file.write_attribute("shell", "junctions", static_cast<std::int64_t>(shell.junctions));
}

Shell read_shell(const Hdf5File& file) {
  Shell shell;
  const auto nodes = read_table<double>(file, "shell/nodes", 3);
  for (std::size_t i = 0; i < nodes.size(); i += 3)
    shell.nodes.emplace_back(nodes[i], nodes[i + 1], nodes[i + 2]);
  const auto triangles = read_table<std::int32_t>(file, "shell/triangles", 3);
  for (std::size_t i = 0; i < triangles.size(); i += 3)
    shell.triangles.push_back({triangles[i], triangles[i + 1], triangles[i + 2]});
  shell.thickness = file.read<double>("shell/thickness");
  const auto region = file.read<std::int32_t>("shell/region");
  shell.region.assign(region.begin(), region.end());
  shell.junctions = static_cast<Junctions>(file.read_attribute<std::int64_t>("shell", "junctions"));
  return shell;
}

/// The sizes of a state whose part has so many nodes, from the arrays that give them.
StateShape shape_of(const FillingState& state, std::size_t nodes) {
  StateShape shape;
  shape.nodes = nodes;
  shape.layers = state.temperature.size() / nodes;
  const std::size_t points = nodes * shape.layers;
  shape.components = state.orientation[0].empty() ? 0 : state.orientation.size();
  shape.fields = points > 0 ? state.lengths.size() / points : 0;
  shape.sensors = state.sensor_arrivals.size();
  shape.most_moves.assign(state.gates.size(), std::numeric_limits<int>::max());
  return shape;
}

/// Compares the parts of a checkpoint with each other: damage that checksums do not see is caught here.
/// Raises StorageError that names the file and the datasets.
void require_whole(const std::string& path, const MoldingCheckpoint& checkpoint) {
  try {
    check_shell(checkpoint.shell);
    check_state(checkpoint.state, shape_of(checkpoint.state, checkpoint.shell.nodes.size()));
  } catch (const InputError& error) {
    std::vector<std::string> faults;
    for (const InputProblem& problem : error.problems())
      faults.push_back(
          fmt::format("dataset {}: {}", problem.key.empty() ? "shell" : problem.key, problem.complaint));
    throw StorageError(
        fmt::format("{} does not hold together: {}: continue from an older checkpoint, or run the "
                    "case again",
                    path, fmt::join(faults, "; ")));
  }
}

/// Fills a new checkpoint file.
CheckpointBody body_of(const MoldingCheckpoint& checkpoint) {
  return [&checkpoint](Hdf5File& file) {
    file.write_text_attribute("/", "study", "molding");
    file.make_group("state");
    MoldingCheckpoint copy = checkpoint;
    Saver saver(file);
    visit_state(saver, copy.state);
    visit_record(saver, copy.record);
    write_structures(file, checkpoint);
    write_shell(file, checkpoint.shell);
  };
}

}  // namespace

void save_checkpoint(Recorder& recorder, const MoldingCheckpoint& checkpoint) {
  recorder.save_checkpoint(body_of(checkpoint));
}

void save_failure(Recorder& recorder, const MoldingCheckpoint& checkpoint) {
  recorder.save_failure(body_of(checkpoint));
}

MoldingCheckpoint read_molding(const std::string& path) {
  const Hdf5File file = open_checkpoint_file(path);
  MoldingCheckpoint checkpoint;
  Loader loader(file);
  visit_state(loader, checkpoint.state);
  visit_record(loader, checkpoint.record);
  read_structures(file, checkpoint.state);
  checkpoint.shell = read_shell(file);
  require_whole(path, checkpoint);
  return checkpoint;
}

MoldingCheckpoint load_molding(Recorder& recorder) {
  MoldingCheckpoint checkpoint;
  recorder.read_checkpoint([&](const std::string& path) { checkpoint = read_molding(path); });
  return checkpoint;
}

MoldingCheckpoint load_molding(const ResultFolder& folder) {
  MoldingCheckpoint checkpoint;
  read_newest_checkpoint(
      folder, [](const std::string&) {}, [&](const std::string& path) { checkpoint = read_molding(path); });
  return checkpoint;
}

}  // namespace fiberfate
