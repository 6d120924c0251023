// Starts the program.
#include <cstdio>

#include "base/version.hpp"

int main() {
  std::printf("fiberfate %s\n", fiberfate::version);
  return 0;
}
