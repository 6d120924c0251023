# Installs the build in BUILD, builds the programs of SOURCES and of the guide in EXAMPLES against it and runs them, and
# checks the links of the installed pages.
include("${CMAKE_CURRENT_LIST_DIR}/c_programs.cmake")

set(prefix "${BUILD}/install_test/prefix")
set(consumer "${BUILD}/install_test/consumer")
file(REMOVE_RECURSE "${BUILD}/install_test")
run("${CMAKE_COMMAND}" --install "${BUILD}" --prefix "${prefix}")
run("${prefix}/bin/fiberfate" --version)
check_c_programs("${prefix}" "${BUILD}/install_test")
run("${CMAKE_COMMAND}" -S "${SOURCES}/consumer" -B "${consumer}" -G Ninja "-DCMAKE_PREFIX_PATH=${prefix}"
    "-DCMAKE_CXX_COMPILER=${COMPILER}" "-DEXAMPLES=${EXAMPLES}")
run("${CMAKE_COMMAND}" --build "${consumer}")
foreach(program tumble cell_in_memory)
  run("${consumer}/${program}")
endforeach()
run("${PYTHON}" "${SOURCES}/../structure/check_links.py" "${prefix}/share/doc/fiberfate")
