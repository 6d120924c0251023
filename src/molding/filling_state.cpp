// The names of what the state of a filling can say.
#include "molding/filling_state.hpp"

namespace fiberfate {

const char* name(FillingEnd reason) {
  switch (reason) {
    case FillingEnd::filled:
      return "filled";
    case FillingEnd::short_shot:
      return "short_shot";
    case FillingEnd::frozen:
      return "frozen";
    case FillingEnd::time:
      return "time";
    case FillingEnd::none:
      break;
  }
  return "none";
}

const char* name(ControlMode mode) {
  switch (mode) {
    case ControlMode::pressure_limit:
      return "pressure_limit";
    case ControlMode::switchover:
      return "switchover";
    case ControlMode::flow:
      break;
  }
  return "flow";
}

const char* name(FillingEventKind kind) {
  switch (kind) {
    case FillingEventKind::gate_opened:
      return "gate_opened";
    case FillingEventKind::gate_closed:
      return "gate_closed";
    case FillingEventKind::pressure_limited:
      return "pressure_limited";
    case FillingEventKind::flow_resumed:
      return "flow_resumed";
    case FillingEventKind::switched_over:
      return "switched_over";
    case FillingEventKind::ended:
      break;
  }
  return "ended";
}

}  // namespace fiberfate
