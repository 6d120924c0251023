# fiberfate_kernels(MODULE kernel.hpp...) compiles each kernel header once for every instruction set
# (docs in src/base/simd.hpp); the default build then runs on any x86-64 and is fast on a recent one.
set(FIBERFATE_KERNEL_FLAGS -O3 -ffp-contract=fast -fno-math-errno -fno-trapping-math -Wno-psabi)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # GCC 12 takes its own intrinsics for uninitialised.
  list(APPEND FIBERFATE_KERNEL_FLAGS -Wno-uninitialized -Wno-maybe-uninitialized)
endif()
set(FIBERFATE_FLAGS_baseline "")
set(FIBERFATE_FLAGS_avx2 -mavx2 -mfma)
set(FIBERFATE_FLAGS_avx512 -mavx512f -mavx512dq -mavx512vl -mavx2 -mfma -mprefer-vector-width=512)

function(fiberfate_kernels module)
  foreach(kernel ${ARGN})
    get_filename_component(stem "${kernel}" NAME_WE)
    foreach(set baseline avx2 avx512)
      set(unit "${CMAKE_CURRENT_BINARY_DIR}/${stem}_${set}.cpp")
      file(CONFIGURE OUTPUT "${unit}" @ONLY CONTENT
           "// Compiles @kernel@ for @set@.\n#define FIBERFATE_ISA @set@\n#include \"@module@/@kernel@\"\n")
      set_source_files_properties("${unit}" PROPERTIES COMPILE_OPTIONS
        "${FIBERFATE_FLAGS_${set}};${FIBERFATE_KERNEL_FLAGS}")
      # Kernels must not see the headers of the standard library or Eigen (src/base/simd.hpp).
      set_source_files_properties("${unit}" PROPERTIES SKIP_PRECOMPILE_HEADERS ON)
      target_sources(fiberfate_${module} PRIVATE "${unit}")
    endforeach()
  endforeach()
endfunction()
