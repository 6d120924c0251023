// What a registry tells about a law that a case may choose.
#pragma once

namespace fiberfate {

/// What sources call the thesis, "thesis equation 5.7".
inline constexpr const char* thesis_title =
    "Evolution of Fiber Microstructure During Polymer Processing, PhD thesis, University of "
    "Wisconsin-Madison";

/// Describes a law in words. Plain text, because kernels include the files of laws.
struct LawText {
  const char* name;               ///< as in case files
  const char* meaning;            ///< in a few words
  const char* source;             ///< author, year, equation; empty where it is this program's own
  const char* constants[8] = {};  ///< that it reads: keys of the section in which it is chosen
};

}  // namespace fiberfate
