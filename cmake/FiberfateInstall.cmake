# Installs the program, the libraries with find_package(fiberfate) and pkg-config, the gallery and the docs; CPack makes
# a .deb of it.
include(CMakePackageConfigHelpers)

set(FIBERFATE_CMAKE_DIR "${CMAKE_INSTALL_LIBDIR}/cmake/fiberfate")
set(installed_modules "")
set(installed_names "")
foreach(module base io microstructure fibers packing dynamics continuum molding calibration keys results studies)
  get_target_property(kind fiberfate_${module} TYPE)
  if(kind STREQUAL STATIC_LIBRARY)
    list(APPEND installed_modules fiberfate_${module})
    list(APPEND installed_names ${module})
    install(DIRECTORY "${PROJECT_SOURCE_DIR}/src/${module}"
            DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/fiberfate"
            FILES_MATCHING PATTERN "*.h" PATTERN "*.hpp" PATTERN "*.kernel.hpp" EXCLUDE)
  endif()
endforeach()
list(JOIN installed_names " " installed_names)

install(TARGETS fiberfate RUNTIME DESTINATION "${CMAKE_INSTALL_BINDIR}")
install(TARGETS ${installed_modules} fiberfate_udunits2 fiberfate_hdf5 fiberfate_gmsh EXPORT fiberfate_modules
        ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}/fiberfate")
install(TARGETS fiberfate_c EXPORT fiberfate_c LIBRARY DESTINATION "${CMAKE_INSTALL_LIBDIR}")
foreach(export fiberfate_modules fiberfate_c)
  install(EXPORT ${export} NAMESPACE fiberfate:: DESTINATION "${FIBERFATE_CMAKE_DIR}")
endforeach()

configure_package_config_file("${CMAKE_CURRENT_LIST_DIR}/fiberfate-config.cmake.in"
  "${PROJECT_BINARY_DIR}/fiberfate-config.cmake" INSTALL_DESTINATION "${FIBERFATE_CMAKE_DIR}")
write_basic_package_version_file("${PROJECT_BINARY_DIR}/fiberfate-config-version.cmake"
  COMPATIBILITY SameMinorVersion)
install(FILES "${PROJECT_BINARY_DIR}/fiberfate-config.cmake" "${PROJECT_BINARY_DIR}/fiberfate-config-version.cmake"
        DESTINATION "${FIBERFATE_CMAKE_DIR}")

file(RELATIVE_PATH pkgconfig_to_prefix "/${CMAKE_INSTALL_LIBDIR}/pkgconfig" "/")
string(REGEX REPLACE "/$" "" pkgconfig_to_prefix "${pkgconfig_to_prefix}")
configure_file("${CMAKE_CURRENT_LIST_DIR}/fiberfate.pc.in" "${PROJECT_BINARY_DIR}/fiberfate.pc" @ONLY)
install(FILES "${PROJECT_BINARY_DIR}/fiberfate.pc" DESTINATION "${CMAKE_INSTALL_LIBDIR}/pkgconfig")

# Pages, cases and what they point at lie to one another as in the sources, so that their links hold.
install(FILES README.md LICENSE CHANGELOG.md CITATION.cff CONTRIBUTING.md DESTINATION "${CMAKE_INSTALL_DOCDIR}")
install(DIRECTORY docs cases materials DESTINATION "${CMAKE_INSTALL_DOCDIR}" PATTERN __pycache__ EXCLUDE)
install(FILES scripts/debian_packages.txt DESTINATION "${CMAKE_INSTALL_DOCDIR}/scripts")
install(FILES tests/robustness/README.md DESTINATION "${CMAKE_INSTALL_DOCDIR}/tests/robustness")
install(DIRECTORY tests/physics DESTINATION "${CMAKE_INSTALL_DOCDIR}/tests" FILES_MATCHING PATTERN "*_test.cpp")

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME fiberfate)
set(CPACK_PACKAGE_CONTACT "The fiberfate developers <fiberfate@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION "${PROJECT_DESCRIPTION}
 Every glass fiber is a chain of rods in sheared melt: drag, bending, contact, friction and breakage decide what becomes of it.
 Laws of orientation and attrition follow fibers at points and in filling molds, and are fitted to measurements.
 With the program, a library for C++ and C, a manual page, the documentation and a gallery of cases.")
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "libeigen3-dev, libfmt-dev, libspdlog-dev, libudunits2-dev, libhdf5-dev, libtoml11-dev, libceres-dev, libgmsh-dev, nlohmann-json3-dev")
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "libgmsh4.8")
include(CPack)
