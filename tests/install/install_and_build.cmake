# Installs the build in BUILD, builds the programs in CONSUMER and of the guide in EXAMPLES against it and runs them.
function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE status)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "failed with status ${status}: ${ARGN}")
  endif()
endfunction()

set(prefix "${BUILD}/install_test/prefix")
set(consumer "${BUILD}/install_test/consumer")
file(REMOVE_RECURSE "${BUILD}/install_test")
run("${CMAKE_COMMAND}" --install "${BUILD}" --prefix "${prefix}")
run("${CMAKE_COMMAND}" -S "${CONSUMER}" -B "${consumer}" -G Ninja "-DCMAKE_PREFIX_PATH=${prefix}"
    "-DCMAKE_CXX_COMPILER=${COMPILER}" "-DEXAMPLES=${EXAMPLES}")
run("${CMAKE_COMMAND}" --build "${consumer}")
foreach(program tumble cell_in_memory user_law)
  run("${consumer}/${program}")
endforeach()
run("${prefix}/bin/fiberfate" --version)
