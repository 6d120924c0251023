# fiberfate_module(NAME [DEPENDS module...] [LIBRARIES target...] [PRIVATE_LIBRARIES target...])
# defines the library of src/NAME from all of its sources, with the project's language and warnings.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)

find_program(CCACHE_PROGRAM ccache)
if(CCACHE_PROGRAM AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER "${CCACHE_PROGRAM}")
endif()

add_library(fiberfate_flags INTERFACE)
target_compile_features(fiberfate_flags INTERFACE cxx_std_20)
target_compile_options(fiberfate_flags INTERFACE
  $<$<COMPILE_LANGUAGE:CXX>:-Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Wold-style-cast -Wcast-qual>
  # GCC 12 sees overlaps in std::string that are not there (GCC bug 105651).
  $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>
  # Results must not depend on how a compiler contracts a*b+c in one build and not in another.
  $<$<COMPILE_LANGUAGE:CXX>:-ffp-contract=off>)
if(CMAKE_CXX_FLAGS MATCHES "-fsanitize=")
  # Instrumented, GCC 12 sees uninitialised members in the standard library's own std::function (GCC bug 105562).
  target_compile_options(fiberfate_flags INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
endif()
if(FIBERFATE_WERROR)
  target_compile_options(fiberfate_flags INTERFACE $<$<COMPILE_LANGUAGE:CXX>:-Werror>)
endif()

# fiberfate_precompile(TARGET) makes every source of TARGET read the headers that nearly all read from where they are
# precompiled, where asked for: once for libraries and once, with GoogleTest, for programs, whose code is placed otherwise.
function(fiberfate_precompile target)
  if(NOT FIBERFATE_PRECOMPILE)
    return()
  endif()
  get_target_property(kind ${target} TYPE)
  set(owner fiberfate_precompiled_${kind})
  if(NOT TARGET ${owner})
    fiberfate_add_precompiled(${owner})
    if(kind STREQUAL EXECUTABLE)
      target_link_libraries(${owner} PRIVATE GTest::gtest)
      target_precompile_headers(${owner} PRIVATE <gtest/gtest.h>)
      set_target_properties(${owner} PROPERTIES POSITION_INDEPENDENT_CODE OFF)
      target_compile_options(${owner} PRIVATE -fPIE)
    endif()
  endif()
  target_precompile_headers(${target} REUSE_FROM ${owner})
endfunction()

function(fiberfate_add_precompiled owner)
  file(CONFIGURE OUTPUT "${CMAKE_CURRENT_BINARY_DIR}/${owner}.cpp" CONTENT "// Carries precompiled headers.\n")
  add_library(${owner} OBJECT "${CMAKE_CURRENT_BINARY_DIR}/${owner}.cpp")
  target_link_libraries(${owner} PRIVATE fiberfate_flags Eigen3::Eigen OpenMP::OpenMP_CXX)
  target_precompile_headers(${owner} PRIVATE
    <Eigen/Dense> <algorithm> <functional> <map> <memory> <string> <vector>)
endfunction()

function(fiberfate_module name)
  cmake_parse_arguments(arg "" "" "DEPENDS;LIBRARIES;PRIVATE_LIBRARIES" ${ARGN})
  file(GLOB sources CONFIGURE_DEPENDS "${CMAKE_CURRENT_SOURCE_DIR}/*.cpp" "${CMAKE_CURRENT_SOURCE_DIR}/*/*.cpp")
  list(FILTER sources EXCLUDE REGEX "/main\\.cpp$")
  if(NOT sources)
    add_library(fiberfate_${name} INTERFACE)
    add_library(fiberfate::${name} ALIAS fiberfate_${name})
    return()
  endif()
  add_library(fiberfate_${name} STATIC ${sources})
  add_library(fiberfate::${name} ALIAS fiberfate_${name})
  list(TRANSFORM arg_DEPENDS PREPEND fiberfate::)
  target_include_directories(fiberfate_${name} PUBLIC
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/src>
    $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/fiberfate>)
  target_compile_features(fiberfate_${name} PUBLIC cxx_std_20)
  target_link_libraries(fiberfate_${name}
    PUBLIC ${arg_DEPENDS} ${arg_LIBRARIES}
    PRIVATE $<BUILD_INTERFACE:fiberfate_flags> ${arg_PRIVATE_LIBRARIES})
  set_target_properties(fiberfate_${name} PROPERTIES EXPORT_NAME ${name})
  fiberfate_precompile(fiberfate_${name})
endfunction()
