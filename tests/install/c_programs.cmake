# Checks an installed C interface: what the library shows, and the examples of the guide with CMake and with pkg-config.
function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE status)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "failed with status ${status}: ${ARGN}")
  endif()
endfunction()

# Tells what a command prints, as a list of its words.
function(words_of result)
  execute_process(COMMAND ${ARGN} OUTPUT_VARIABLE text COMMAND_ERROR_IS_FATAL ANY)
  string(STRIP "${text}" text)
  string(REGEX REPLACE "[ \t\r\n]+" ";" words "${text}")
  set(${result} "${words}" PARENT_SCOPE)
endfunction()

# Requires that the library shows the functions of the header and nothing else.
function(check_symbols prefix)
  file(READ "${prefix}/include/fiberfate/continuum/fiberfate.h" header)
  string(REGEX REPLACE "/\\*[^*]*\\*+([^/*][^*]*\\*+)*/" "" header "${header}")
  string(REGEX MATCHALL "fiberfate_[a-z_]+\\(" declared "${header}")
  list(TRANSFORM declared REPLACE "\\(" "")
  list(SORT declared)
  words_of(shown nm --dynamic --defined-only --format=just-symbols "${prefix}/lib/libfiberfate.so")
  list(SORT shown)
  if(NOT declared STREQUAL shown)
    message(FATAL_ERROR "the library shows\n${shown}\nand the header declares\n${declared}")
  endif()
endfunction()

# check_c_programs(PREFIX WORK) also takes SOURCES (this folder), EXAMPLES and C_COMPILER of the caller.
function(check_c_programs prefix work)
  check_symbols("${prefix}")
  set(with_cmake "${work}/with_cmake")
  set(with_pkgconfig "${work}/with_pkgconfig")
  file(MAKE_DIRECTORY "${with_pkgconfig}")
  run("${CMAKE_COMMAND}" -S "${SOURCES}/consumer_c" -B "${with_cmake}" -G Ninja "-DCMAKE_PREFIX_PATH=${prefix}"
      "-DCMAKE_C_COMPILER=${C_COMPILER}" "-DEXAMPLES=${EXAMPLES}")
  run("${CMAKE_COMMAND}" --build "${with_cmake}")
  set(ENV{PKG_CONFIG_PATH} "${prefix}/lib/pkgconfig")
  words_of(flags pkg-config --cflags --libs "fiberfate >= 0.1")
  foreach(example user_law point_laws)
    run("${C_COMPILER}" -std=c99 -Wall -Wextra -Wpedantic -Werror "${EXAMPLES}/${example}.c" ${flags} -lm
        -o "${with_pkgconfig}/${example}")
    run("${with_cmake}/${example}")
    run("${CMAKE_COMMAND}" -E env "LD_LIBRARY_PATH=${prefix}/lib" "${with_pkgconfig}/${example}")
  endforeach()
endfunction()
