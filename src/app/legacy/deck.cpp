// Translates the input decks of the published program, key by key.
#include "app/legacy/deck.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "app/legacy/namelist.hpp"
#include "io/legacy_text.hpp"

namespace fiberfate {
namespace {

constexpr double simple_shear_case = 1;
constexpr double table_case = 1848;

/// The deck while it is translated.
struct Translation {
  const LegacyNamelist& namelist;
  const std::string& folder;
  LegacyDeck& deck;

  [[nodiscard]] ShearCellCase& values() const { return deck.values; }
  [[nodiscard]] double number(const char* key) const { return namelist.number(key).value_or(0); }
  [[nodiscard]] double step() const { return number("dt"); }
  [[nodiscard]] bool follows_table() const { return number("flow_case") == table_case; }
};

enum class Necessity { required, optional };

/// What becomes of one legacy key: `apply` stores its value and says where.
struct LegacyRule {
  const char* key;
  Necessity necessity;
  std::function<std::string(const Translation&)> apply;
};

/// Makes the rule of a key that has no counterpart.
LegacyRule unused(const char* key, const char* reason) {
  return {key, Necessity::optional,
          [reason](const Translation&) { return std::string("not used: ") + reason; }};
}

void require_positive(const Translation& deck, const char* key) {
  if (deck.number(key) > 0) return;
  throw InputError({deck.namelist.problem(key, "it is not positive", "give a positive number")});
}

/// Makes the rule of a key whose positive number goes to one member.
LegacyRule stored(const char* key, Necessity necessity, const char* target,
                  std::function<double&(ShearCellCase&)> member) {
  return {key, necessity, [=](const Translation& deck) {
            const double value = deck.number(key);
            if (value < 0)
              throw InputError({deck.namelist.problem(key, "it is negative", "give a positive number")});
            member(deck.values()) = value;
            return fmt::format("{} = {}", target, value);
          }};
}

std::string apply_flow_case(const Translation& deck) {
  if (deck.number("flow_case") == simple_shear_case) {
    deck.values().flow.kind = FlowKind::constant;
    return "flow.kind = \"constant\"";
  }
  if (!deck.follows_table())
    throw InputError({deck.namelist.problem("flow_case", "only 1 (simple shear) and 1848 (table) are offered",
                                            "give one of the two")});
  LegacyNumbers words(deck.folder + "/DynamicParameters.in");
  const std::int64_t rows = words.count("the number of rows");
  for (std::int64_t i = 1; i <= rows; ++i) {
    const std::string row = fmt::format(" of row {}", i);
    const double end = words.number("the end time" + row);
    const double rate = words.number("the rate" + row);
    const double viscosity = words.number("the viscosity" + row);
    deck.values().flow.table.push_back({end, rate, viscosity});
  }
  words.expect_end();
  deck.values().flow.kind = FlowKind::table;
  return fmt::format("flow.kind = \"table\", flow.table = {} rows of DynamicParameters.in", rows);
}

std::string apply_rate(const Translation& deck) {
  if (deck.follows_table()) return "not used: flow case 1848 takes the rates of DynamicParameters.in";
  deck.values().flow.rate = deck.number("gamma_dot");
  return fmt::format("flow.rate = {}", *deck.values().flow.rate);
}

std::string apply_viscosity(const Translation& deck) {
  if (deck.follows_table()) return "not used: flow case 1848 takes the viscosities of DynamicParameters.in";
  require_positive(deck, "viscosity");
  deck.values().flow.viscosity = deck.number("viscosity");
  return fmt::format("flow.viscosity = {}", *deck.values().flow.viscosity);
}

std::string apply_wall_friction(const Translation& deck) {
  const bool rough = *deck.namelist.truth("is_fric_wall");
  deck.values().dynamics.contact.wall_friction = rough ? deck.number("fric_coeff") : 0;
  return fmt::format("contact.wall_friction = {}", deck.values().dynamics.contact.wall_friction);
}

std::string apply_breakage(const Translation& deck) {
  const bool breaks = *deck.namelist.truth("allow_breakage");
  deck.values().dynamics.breakage.law = breaks ? "fixed" : "none";
  return breaks ? "breakage.law = \"fixed\"" : "breakage.law = \"none\"";
}

std::string apply_radius(const Translation& deck) {
  require_positive(deck, "r_fiber");
  deck.values().sample.fibers.diameter = 2 * deck.number("r_fiber");
  return fmt::format("fibers.diameter = {}, twice the radius", deck.values().sample.fibers.diameter);
}

std::string set_boundary(const Translation& deck, bool periodic) {
  deck.values().boundary.y = periodic ? Boundary::periodic : Boundary::walls;
  return periodic ? "boundary.y = \"periodic\"" : "boundary.y = \"walls\"";
}

/// In decks with isPeriodicY, periodic_boundary speaks of x and z only.
std::string apply_boundary(const Translation& deck) {
  const bool periodic = *deck.namelist.truth("periodic_boundary");
  if (deck.namelist.find("isPeriodicY") == nullptr)
    return set_boundary(deck, periodic) + "; the deck has no isPeriodicY, which would decide";
  return periodic ? "x and z are always periodic; isPeriodicY decides on y"
                  : "not used: x and z are always periodic; isPeriodicY decides on y";
}

std::string apply_boundary_y(const Translation& deck) {
  return set_boundary(deck, *deck.namelist.truth("isPeriodicY"));
}

std::string apply_box(const Translation& deck) {
  const std::vector<double> size = *deck.namelist.numbers("box_size", 3);
  deck.values().sample.cell.size = Vec3(size.data());
  return fmt::format("cell.size = [{}, {}, {}]", size[0], size[1], size[2]);
}

std::string apply_step(const Translation& deck) {
  require_positive(deck, "dt");
  deck.values().dynamics.step.initial = deck.step();
  return fmt::format("step.initial = {}; the step adapts from there (step.control = \"fixed\" keeps it)",
                     deck.step());
}

std::string apply_duration(const Translation& deck) {
  require_positive(deck, "nbr_intgr");
  deck.values().run.duration = deck.number("nbr_intgr") * deck.step();
  return fmt::format("run.duration = {}, times dt", deck.values().run.duration);
}

std::string apply_output(const Translation& deck) {
  require_positive(deck, "writ_period");
  const double interval = deck.number("writ_period") * deck.step();
  deck.values().output.interval = interval;
  deck.values().output.frame_interval = interval;
  return fmt::format("output.interval = output.frame_interval = {}, times dt", interval);
}

std::string apply_checks(const Translation& deck) {
  require_positive(deck, "break_period");
  deck.values().dynamics.breakage.check_interval = deck.number("break_period") * deck.step();
  return fmt::format("breakage.check_interval = {}, times dt",
                     deck.values().dynamics.breakage.check_interval);
}

std::string apply_drag(const Translation& deck) {
  const double choice = deck.number("TensorOrBeads");
  if (choice != 1 && choice != 2)
    throw InputError({deck.namelist.problem("TensorOrBeads", "only 1 (ellipsoid) and 2 (beads) are known",
                                            "give one of the two")});
  deck.values().dynamics.drag = choice == 1 ? "ellipsoid" : "beads";
  return choice == 1
             ? "drag.law = \"ellipsoid\""
             : "drag.law = \"beads\" (\"beads_integer\" rounds the number of beads down as that program did)";
}

std::string apply_extension(const Translation& deck) {
  if (deck.number("epsilon_dot") != 0 && deck.number("flow_case") != simple_shear_case)
    throw InputError({deck.namelist.problem("epsilon_dot", "extension is not offered", "set it to 0")});
  return "not used: flow cases 1 and 1848 are simple shear";
}

std::string apply_recovery(const Translation& deck) {
  return *deck.namelist.truth("recover_simulation")
             ? "not used: that program would go on from its own last frame; the fibers are those of "
               "Initial_Positions.txt"
             : "not used: 'fiberfate resume' continues a run";
}

/// The keys in the order in which the notes list them.
const std::vector<LegacyRule>& rules() {
  using enum Necessity;
  static const std::vector<LegacyRule> all = {
      stored("E_Young", required, "fibers.youngs_modulus",
             [](ShearCellCase& c) -> double& { return c.sample.fibers.youngs_modulus; }),
      {"r_fiber", required, apply_radius},
      {"flow_case", required, apply_flow_case},
      {"gamma_dot", optional, apply_rate},
      {"viscosity", optional, apply_viscosity},
      {"epsilon_dot", optional, apply_extension},
      {"periodic_boundary", optional, apply_boundary},
      {"isPeriodicY", optional, apply_boundary_y},
      {"box_size", required, apply_box},
      {"dt", required, apply_step},
      {"nbr_intgr", required, apply_duration},
      {"writ_period", required, apply_output},
      {"allow_breakage", optional, apply_breakage},
      stored("min_curv", optional, "breakage.critical_radius",
             [](ShearCellCase& c) -> double& { return c.dynamics.breakage.critical_radius; }),
      {"break_period", optional, apply_checks},
      stored("fric_coeff", optional, "contact.friction",
             [](ShearCellCase& c) -> double& { return c.dynamics.contact.friction; }),
      {"is_fric_wall", optional, apply_wall_friction},
      stored("ex_vol_const", optional, "contact.force_constant",
             [](ShearCellCase& c) -> double& { return c.dynamics.contact.force_constant; }),
      unused("distanceFactor",
             "it is the radius of that program's list; its force ends at two radii, as here"),
      {"TensorOrBeads", optional, apply_drag},
      {"recover_simulation", optional, apply_recovery},
      unused("nbr_neighbors", "the list of neighbours has no limit"),
      unused("ratio_displ_max", "the step follows its error, step.tolerance"),
      unused("printVelocities", "result.vtkhdf always holds velocities"),
      unused("coo_velocity", "fibers without inertia have no initial velocity"),
      unused("coo_omega", "fibers without inertia have no initial rotation"),
  };
  return all;
}

void append_unknown_keys(const LegacyNamelist& namelist, std::vector<InputProblem>& problems) {
  const std::vector<std::string> known = legacy_keys();
  for (const NamelistEntry& entry : namelist.entries()) {
    bool found = false;
    for (const LegacyRule& rule : rules())
      found = found || namelist.find(rule.key) == namelist.find(entry.key);
    if (found) continue;
    const std::string nearest = nearest_word(entry.key, known);
    problems.push_back(
        namelist.problem(entry.key, "this key of Fibers.in is not known",
                         nearest.empty() ? "remove the line" : fmt::format("did you mean {}?", nearest)));
  }
}

std::string value_of(const LegacyNamelist& namelist, const char* key) {
  const NamelistEntry* entry = namelist.find(key);
  return entry == nullptr ? "" : fmt::format("{}", fmt::join(entry->values, " "));
}

void translate_keys(const Translation& deck) {
  std::vector<InputProblem> problems;
  append_unknown_keys(deck.namelist, problems);
  for (const LegacyRule& rule : rules()) {
    try {
      if (deck.namelist.find(rule.key) != nullptr) {
        deck.deck.notes.push_back({rule.key, value_of(deck.namelist, rule.key), rule.apply(deck)});
      } else if (rule.necessity == Necessity::required) {
        problems.push_back(deck.namelist.problem(rule.key, "Fibers.in does not give it", "add it to &input"));
      } else {
        deck.deck.notes.push_back({rule.key, "", "not given; the default stands"});
      }
    } catch (const InputError& error) {
      problems.insert(problems.end(), error.problems().begin(), error.problems().end());
    }
  }
  if (!problems.empty()) throw InputError(std::move(problems));
}

/// Moves fibers between walls to where that program has them: its walls stand half a box above and below the
/// mean of all rods' middles, wherever the positions are; here the lower one is at y = 0.
LegacyNote centre_between_walls(LegacyDeck& deck) {
  double sum = 0, rods = 0;
  for (const LegacyFiber& fiber : deck.fibers)
    for (std::size_t k = 0; k + 1 < fiber.nodes.size(); ++k, ++rods)
      sum += 0.5 * (fiber.nodes[k].y() + fiber.nodes[k + 1].y());
  const double shift = 0.5 * deck.values.sample.cell.size->y() - sum / std::max(rods, 1.0);
  for (LegacyFiber& fiber : deck.fibers)
    for (Vec3& node : fiber.nodes) node.y() += shift;
  return {"Initial_Positions.txt", "",
          fmt::format(
              "fibers.csv, moved by {:.6g} m in y: walls stand half a box from the mean of the rods' middles",
              shift)};
}

}  // namespace

LegacyDeck read_legacy_deck(const std::string& folder) {
  LegacyDeck deck;
  const LegacyNamelist namelist(folder + "/Fibers.in");
  translate_keys({namelist, folder, deck});
  deck.fibers = read_legacy_positions(folder + "/Initial_Positions.txt");
  deck.values.sample.cluster.source = ClusterSource::file;
  deck.notes.push_back(deck.values.boundary.y == Boundary::walls
                           ? centre_between_walls(deck)
                           : LegacyNote{"Initial_Positions.txt", "", "fibers.csv"});
  std::int64_t held = 0;
  for (const LegacyFiber& fiber : deck.fibers) held += fiber.is_stationary ? 1 : 0;
  deck.notes.push_back(
      {"is_stationary", fmt::format("{} fibers", held),
       held > 0 ? "not used: no fiber is held in place; these move too" : "no fiber is held in place"});
  return deck;
}

std::vector<std::string> legacy_keys() {
  std::vector<std::string> keys;
  for (const LegacyRule& rule : rules()) keys.emplace_back(rule.key);
  return keys;
}

}  // namespace fiberfate
