# Writes the manual page and the completions of bash, zsh and fish from what the built program says of itself, and installs
# them. A program built for another machine cannot be asked.
if(CMAKE_CROSSCOMPILING)
  return()
endif()
find_package(Python3 COMPONENTS Interpreter)
if(NOT Python3_FOUND)
  return()
endif()

set(manual "${PROJECT_BINARY_DIR}/manual")
file(GLOB scripts CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/scripts/manual/*.py")
add_custom_command(OUTPUT "${manual}/fiberfate.1" "${manual}/fiberfate.bash" "${manual}/_fiberfate" "${manual}/fiberfate.fish"
  COMMAND "${Python3_EXECUTABLE}" -B "${PROJECT_SOURCE_DIR}/scripts/manual/write_manual.py" "$<TARGET_FILE:fiberfate>" "${manual}"
  DEPENDS fiberfate ${scripts}
  VERBATIM)
add_custom_target(manual ALL DEPENDS "${manual}/fiberfate.1")

install(FILES "${manual}/fiberfate.1" DESTINATION "${CMAKE_INSTALL_MANDIR}/man1")
install(FILES "${manual}/fiberfate.bash" DESTINATION "${CMAKE_INSTALL_DATADIR}/bash-completion/completions" RENAME fiberfate)
install(FILES "${manual}/_fiberfate" DESTINATION "${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions")
install(FILES "${manual}/fiberfate.fish" DESTINATION "${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d")
