// Asks the processor for its instruction set.
#include "base/simd.hpp"

#include <cstdlib>
#include <string_view>

namespace fiberfate {
namespace {

InstructionSet best_available() {
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
      __builtin_cpu_supports("avx512vl"))
    return InstructionSet::avx512;
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) return InstructionSet::avx2;
  return InstructionSet::baseline;
}

InstructionSet chosen() {
  const InstructionSet best = best_available();
  const char* wish = std::getenv("FIBERFATE_ISA");
  if (wish == nullptr) return best;
  const std::string_view word(wish);
  if (word == "baseline") return InstructionSet::baseline;
  if (word == "avx2" && best != InstructionSet::baseline) return InstructionSet::avx2;
  return best;
}

}  // namespace

InstructionSet instruction_set() {
  static const InstructionSet set = chosen();
  return set;
}

const char* name(InstructionSet set) {
  switch (set) {
    case InstructionSet::avx512:
      return "avx512";
    case InstructionSet::avx2:
      return "avx2";
    default:
      return "baseline";
  }
}

}  // namespace fiberfate
