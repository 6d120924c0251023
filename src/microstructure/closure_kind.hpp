// The choice of a closure approximation.
#pragma once

namespace fiberfate {

/// How A4 is made from A2: a place in ClosureLaws (closure_laws/closure_laws.hpp), the first where nobody
/// chooses. closure_named finds one.
enum class Closure : int {};

}  // namespace fiberfate
