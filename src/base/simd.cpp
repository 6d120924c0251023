// Asks the processor for its instruction set.
#include "base/simd.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <string_view>

#include "base/error.hpp"

namespace fiberfate {
namespace {

constexpr InstructionSet all_sets[] = {InstructionSet::baseline, InstructionSet::avx2,
                                       InstructionSet::avx512};

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
  if (wish == nullptr || *wish == 0) return best;
  for (const InstructionSet set : all_sets) {
    if (std::string_view(wish) != name(set)) continue;
    if (set > best)
      throw InputError(
          fmt::format("FIBERFATE_ISA = {}: this processor has no more than {}", wish, name(best)),
          "give a lesser one, or unset it");
    return set;
  }
  throw InputError(fmt::format("FIBERFATE_ISA = {}: there is no such instruction set", wish),
                   "give one of baseline, avx2, avx512, or unset it");
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
