// What the program says on standard error.
#pragma once

#include <cstdio>
#include <string>

namespace fiberfate {

/// Says something on standard error; where that fails, nobody is left to tell, and what goes on goes on.
inline void say(const std::string& text) {
  std::fputs(text.c_str(), stderr);
}

}  // namespace fiberfate
