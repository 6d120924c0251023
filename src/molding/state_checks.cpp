// Compares the members of a state with what they can be.
#include "molding/state_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "base/error.hpp"

namespace fiberfate {
namespace {

constexpr const char* remedy =
    "continue with the mesh, gates, layers and fibers that it was made with, from a checkpoint that is whole";

bool is_finite(double value) {
  return std::isfinite(value);
}
bool is_finite_or_nan(double value) {
  return !std::isinf(value);
}
bool is_not_negative(double value) {
  return std::isfinite(value) && value >= 0;
}
bool is_share(double value) {
  return value >= 0 && value <= 1;
}

class StateChecker {
 public:
  StateChecker(const FillingState& state, const StateShape& shape) : state_(state), shape_(shape) {}

  void check_arrays() {
    const std::size_t nodes = shape_.nodes, points = nodes * shape_.layers;
    values("sensor_arrivals", state_.sensor_arrivals, shape_.sensors, is_finite_or_nan);
    values("filled", state_.filled, nodes, is_share);
    values("excess", state_.excess, nodes, is_finite);
    values("fill_time", state_.fill_time, nodes, is_finite_or_nan);
    values("pressure", state_.pressure, nodes, is_finite);
    values("temperature", state_.temperature, points, is_not_negative);
    values("rate", state_.rate, points, is_not_negative);
    values("lengths", state_.lengths, points * shape_.fields, is_not_negative);
    for (std::size_t m = 0; m < state_.orientation.size(); ++m)
      values(fmt::format("orientation_{}", m), state_.orientation[m], m < shape_.components ? points : 0,
             is_finite);
    vectors("gradient", state_.gradient);
    vectors("inflow", state_.inflow);
    size("mark", state_.mark.size(), nodes);
    if (!state_.covered.empty()) size("covered", state_.covered.size(), nodes);
    require("mark",
            std::all_of(state_.mark.begin(), state_.mark.end(),
                        [](NodeMark mark) { return mark <= NodeMark::last_filled; }),
            "there are no such marks");
  }

  void check_numbers() {
    const auto number = [this](const char* name, double value) {
      require(name, is_not_negative(value), fmt::format("{:g} is negative or not finite", value));
    };
    number("time", state_.time);
    number("steps", static_cast<double>(state_.steps));
    number("flow_rate", state_.flow_rate);
    number("injected_volume", state_.injected_volume);
    number("filled_volume", state_.filled_volume);
    require("sprue_pressure", is_finite(state_.sprue_pressure), "it is not finite");
    require("held_pressure", !std::isnan(state_.held_pressure), "it is not a number");
    require("end", state_.stop_reason >= FillingEnd::none && state_.stop_reason <= FillingEnd::time,
            "there is no such end");
    require("control", state_.control >= ControlMode::flow && state_.control <= ControlMode::switchover,
            "there is no such control");
  }

  void check_gates() {
    size("gates", state_.gates.size(), shape_.most_moves.size());
    for (std::size_t g = 0; g < std::min(state_.gates.size(), shape_.most_moves.size()); ++g) {
      const GateState& gate = state_.gates[g];
      require("gates", gate.moves >= 0 && gate.moves <= shape_.most_moves[g],
              fmt::format("gate {} cannot have moved {} times", g, gate.moves));
      require("gates",
              is_finite_or_nan(gate.arrival_time) && is_finite(gate.pressure) && is_finite(gate.rate) &&
                  is_finite(gate.volume),
              fmt::format("numbers of gate {} are not finite", g));
    }
    const auto is_possible = [this](const FillingEvent& event) {
      return is_not_negative(event.time) && is_finite(event.filled_fraction) &&
             event.kind >= FillingEventKind::gate_opened && event.kind <= FillingEventKind::ended &&
             event.gate >= -1 && event.gate < std::ssize(state_.gates);
    };
    require("events", std::all_of(state_.events.begin(), state_.events.end(), is_possible),
            "there are no such events");
  }

  void raise() const {
    if (!problems_.empty()) throw InputError(problems_);
  }

 private:
  void require(const std::string& name, bool holds, std::string complaint) {
    const bool told = std::any_of(problems_.begin(), problems_.end(),
                                  [&](const InputProblem& one) { return one.key == "state/" + name; });
    if (!holds && !told) problems_.push_back({"", 0, 0, "state/" + name, "", std::move(complaint), remedy});
  }
  void size(const std::string& name, std::size_t found, std::size_t wanted) {
    require(name, found == wanted, fmt::format("{} values where {} belong", found, wanted));
  }
  void values(const std::string& name, const std::vector<double>& found, std::size_t wanted,
              bool (*allowed)(double)) {
    size(name, found.size(), wanted);
    const auto fault = std::find_if_not(found.begin(), found.end(), allowed);
    if (fault != found.end())
      require(name, false, fmt::format("value {} is {:g}", fault - found.begin(), *fault));
  }
  void vectors(const char* name, const std::vector<Vec2>& found) {
    size(name, found.size(), shape_.nodes);
    require(name, std::all_of(found.begin(), found.end(), [](const Vec2& one) { return one.allFinite(); }),
            "some are not finite");
  }

  const FillingState& state_;
  const StateShape& shape_;
  std::vector<InputProblem> problems_;
};

}  // namespace

void check_state(const FillingState& state, const StateShape& shape) {
  StateChecker checker(state, shape);
  checker.check_numbers();
  checker.check_gates();
  checker.check_arrays();
  checker.raise();
}

}  // namespace fiberfate
