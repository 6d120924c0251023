// The version of the program.
#pragma once

namespace fiberfate {

/// The program's version, as every result file records it.
inline constexpr const char* version = "0.1.0";

}  // namespace fiberfate
