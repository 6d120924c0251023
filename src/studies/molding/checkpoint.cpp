// Fillings in HDF5 files (docs/formats/checkpoint.md).
#include "studies/molding/checkpoint.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <tuple>
#include <type_traits>
#include <utility>

#include "base/error.hpp"
#include "molding/state_checks.hpp"
#include "results/checkpoint_file.hpp"

namespace fiberfate {
namespace {

// How a thing stands in a row of numbers; what is no small whole number where one belongs becomes -9, which
// no check lets pass.
int whole(double value) {
  return value >= -1 && value < 1e9 && value == std::floor(value) ? static_cast<int>(value) : -9;
}
std::array<double, 5> row_of(const GateState& gate) {
  return {static_cast<double>(gate.moves), gate.arrival_time, gate.pressure, gate.rate, gate.volume};
}
void take(const std::array<double, 5>& row, GateState& gate) {
  gate = {whole(row[0]), row[1], row[2], row[3], row[4]};
}
std::array<double, 4> row_of(const FillingEvent& event) {
  return {event.time, event.filled_fraction, static_cast<double>(event.kind),
          static_cast<double>(event.gate)};
}
void take(const std::array<double, 4>& row, FillingEvent& event) {
  event = {row[0], row[1], static_cast<FillingEventKind>(whole(row[2])), whole(row[3])};
}
std::array<double, 2> row_of(const Vec2& vector) {
  return {vector.x(), vector.y()};
}
void take(const std::array<double, 2>& row, Vec2& vector) {
  vector = {row[0], row[1]};
}
std::array<double, 3> row_of(const Vec3& vector) {
  return {vector.x(), vector.y(), vector.z()};
}
void take(const std::array<double, 3>& row, Vec3& vector) {
  vector = {row[0], row[1], row[2]};
}
std::array<std::int32_t, 3> row_of(const std::array<Index, 3>& nodes) {
  return nodes;
}
void take(const std::array<std::int32_t, 3>& row, std::array<Index, 3>& nodes) {
  nodes = row;
}

/// Writes parts of a checkpoint or reads them back: one list of names serves both ways.
class Saver {
 public:
  explicit Saver(Hdf5File& file) : file_(file) {}
  /// Values, stored as another type where one is named.
  template <class Stored, class T>
  void array(const std::string& name, const std::vector<T>& values) {
    std::vector<Stored> numbers;
    numbers.reserve(values.size());
    for (const T& value : values) numbers.push_back(static_cast<Stored>(value));
    file_.write(name, std::span<const Stored>(numbers));
  }
  /// Things, a row each.
  template <class T>
  void rows(const char* name, const std::vector<T>& things) {
    using Row = decltype(row_of(things.front()));
    std::vector<typename Row::value_type> numbers;
    for (const T& thing : things) {
      const Row row = row_of(thing);
      numbers.insert(numbers.end(), row.begin(), row.end());
    }
    file_.write(name, std::span<const typename Row::value_type>(numbers), std::tuple_size_v<Row>);
  }
  template <class T>
  void number(const char* group, const char* name, const T& value) {
    if constexpr (std::is_enum_v<T>)
      file_.write_attribute(group, name, static_cast<std::int64_t>(value));
    else
      file_.write_attribute(group, name, value);
  }

 private:
  Hdf5File& file_;
};

class Loader {
 public:
  explicit Loader(const Hdf5File& file) : file_(file) {}
  template <class Stored, class T>
  void array(const std::string& name, std::vector<T>& values) {
    for (const Stored value : file_.read<Stored>(name)) values.push_back(static_cast<T>(value));
  }
  /// Raises StorageError where the rows of the dataset have another length.
  template <class T>
  void rows(const char* name, std::vector<T>& things) {
    using Row = decltype(row_of(things.front()));
    constexpr std::size_t columns = std::tuple_size_v<Row>;
    file_.require_columns(name, columns);
    const auto numbers = file_.read<typename Row::value_type>(name);
    for (std::size_t i = 0; i < numbers.size(); i += columns) {
      Row row = {};
      std::copy_n(numbers.begin() + static_cast<std::ptrdiff_t>(i), columns, row.begin());
      take(row, things.emplace_back());
    }
  }
  template <class T>
  void number(const char* group, const char* name, T& value) {
    if constexpr (std::is_enum_v<T>)
      value = static_cast<T>(file_.read_attribute<std::int64_t>(group, name));
    else
      value = file_.read_attribute<T>(group, name);
  }

 private:
  const Hdf5File& file_;
};

/// Visits everything once, by name.
template <class Visitor, class State>
void visit_state(Visitor& visitor, State& state) {
  visitor.rows("state/gates", state.gates);
  visitor.rows("state/events", state.events);
  visitor.rows("state/inflow", state.inflow);
  visitor.rows("state/gradient", state.gradient);
  visitor.template array<std::uint8_t>("state/covered", state.covered);
  visitor.template array<std::uint8_t>("state/mark", state.mark);
  for (const auto& [name, values] : {std::pair("sensor_arrivals", &state.sensor_arrivals),
                                     {"filled", &state.filled},
                                     {"excess", &state.excess},
                                     {"fill_time", &state.fill_time},
                                     {"pressure", &state.pressure},
                                     {"temperature", &state.temperature},
                                     {"rate", &state.rate},
                                     {"lengths", &state.lengths}})
    visitor.template array<double>(std::string("state/") + name, *values);
  for (std::size_t k = 0; k < state.orientation.size(); ++k)
    visitor.template array<double>(fmt::format("state/orientation_{}", k), state.orientation[k]);
  visitor.number("state", "time", state.time);
  visitor.number("state", "steps", state.steps);
  visitor.number("state", "end", state.stop_reason);
  visitor.number("state", "control", state.control);
  for (const auto& [name, value] : {std::pair("sprue_pressure", &state.sprue_pressure),
                                    {"flow_rate", &state.flow_rate},
                                    {"held_pressure", &state.held_pressure},
                                    {"injected_volume", &state.injected_volume},
                                    {"filled_volume", &state.filled_volume},
                                    {"heat_brought_in", &state.heat.brought_in},
                                    {"heat_dissipated", &state.heat.dissipated},
                                    {"heat_to_mold", &state.heat.to_mold}})
    visitor.number("state", name, *value);
}

template <class Visitor, class Checkpoint>
void visit(Visitor& visitor, Checkpoint& checkpoint) {
  visit_state(visitor, checkpoint.state);
  auto& shell = checkpoint.shell;
  visitor.rows("shell/nodes", shell.nodes);
  visitor.rows("shell/triangles", shell.triangles);
  visitor.template array<double>("shell/thickness", shell.thickness);
  visitor.template array<std::int32_t>("shell/region", shell.region);
  visitor.number("shell", "junctions", shell.junctions);
  auto& record = checkpoint.record;
  visitor.number("state", "series_rows", record.series_rows);
  visitor.number("state", "frames", record.frames);
  visitor.number("state", "wall_s", record.wall_s);
  visitor.number("state", "cpu_s", record.cpu_s);
  visitor.number("state", "greatest_pressure", record.greatest_pressure);
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

/// Does what may find faults of a state; raises StorageError that tells them with the datasets.
template <class Work>
auto refuse_faults(const std::string& what, const Work& work) {
  try {
    return work();
  } catch (const InputError& error) {
    std::vector<std::string> faults;
    for (const InputProblem& problem : error.problems())
      faults.push_back(
          fmt::format("dataset {}: {}", problem.key.empty() ? "shell" : problem.key, problem.complaint));
    throw StorageError(fmt::format("{}: {}: continue from an older checkpoint, or run the case again", what,
                                   fmt::join(faults, "; ")));
  }
}

void check_record(const MoldingRecord& record) {
  const auto require = [](const char* name, double value) {
    if (!(value >= 0) || !std::isfinite(value))
      throw InputError({{"", 0, 0, std::string("state/") + name, "",
                         fmt::format("{:g} is negative or not finite", value), ""}});
  };
  require("series_rows", static_cast<double>(record.series_rows));
  require("frames", static_cast<double>(record.frames));
  require("wall_s", record.wall_s);
  require("cpu_s", record.cpu_s);
  require("greatest_pressure", record.greatest_pressure);
}

/// Compares the parts of a checkpoint with each other: damage that checksums do not see is caught here.
void require_whole(const std::string& path, const MoldingCheckpoint& checkpoint) {
  refuse_faults(path + " does not hold together", [&] {
    check_shell(checkpoint.shell);
    check_state(checkpoint.state, shape_of(checkpoint.state, checkpoint.shell.nodes.size()));
    check_record(checkpoint.record);
  });
}

/// Fills a new checkpoint file.
CheckpointBody body_of(const MoldingCheckpoint& checkpoint) {
  return [&checkpoint](Hdf5File& file) {
    file.write_text_attribute("/", "study", "molding");
    file.make_group("state");
    Saver saver(file);
    visit(saver, checkpoint);
  };
}

}  // namespace

void write_molding(const std::string& path, const MoldingCheckpoint& checkpoint) {
  write_checkpoint_file(path, body_of(checkpoint));
}

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
  visit(loader, checkpoint);
  require_whole(path, checkpoint);
  return checkpoint;
}

Filling filling_from(MoldingCheckpoint checkpoint, const FillingParams& params) {
  return refuse_faults("the checkpoint is not one of this case", [&] {
    return Filling(ShellMesh(std::move(checkpoint.shell)), params, std::move(checkpoint.state));
  });
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
