# Installs the program, the libraries with find_package(fiberfate), the gallery and the docs; CPack makes a .deb of it.
include(CMakePackageConfigHelpers)

set(FIBERFATE_CMAKE_DIR "${CMAKE_INSTALL_LIBDIR}/cmake/fiberfate")
set(installed_modules "")
foreach(module base io microstructure fibers packing dynamics continuum molding calibration keys results studies)
  get_target_property(kind fiberfate_${module} TYPE)
  if(kind STREQUAL STATIC_LIBRARY)
    list(APPEND installed_modules fiberfate_${module})
    install(DIRECTORY "${PROJECT_SOURCE_DIR}/src/${module}"
            DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/fiberfate"
            FILES_MATCHING PATTERN "*.h" PATTERN "*.hpp" PATTERN "*.kernel.hpp" EXCLUDE)
  endif()
endforeach()

install(TARGETS fiberfate RUNTIME DESTINATION "${CMAKE_INSTALL_BINDIR}")
install(TARGETS ${installed_modules} fiberfate_udunits2 fiberfate_hdf5 fiberfate_gmsh EXPORT fiberfate
        ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}/fiberfate")
install(EXPORT fiberfate NAMESPACE fiberfate:: DESTINATION "${FIBERFATE_CMAKE_DIR}")

configure_package_config_file("${CMAKE_CURRENT_LIST_DIR}/fiberfate-config.cmake.in"
  "${PROJECT_BINARY_DIR}/fiberfate-config.cmake" INSTALL_DESTINATION "${FIBERFATE_CMAKE_DIR}")
write_basic_package_version_file("${PROJECT_BINARY_DIR}/fiberfate-config-version.cmake"
  COMPATIBILITY SameMinorVersion)
install(FILES "${PROJECT_BINARY_DIR}/fiberfate-config.cmake" "${PROJECT_BINARY_DIR}/fiberfate-config-version.cmake"
        DESTINATION "${FIBERFATE_CMAKE_DIR}")

install(DIRECTORY cases materials DESTINATION "${CMAKE_INSTALL_DATADIR}/fiberfate")
install(DIRECTORY docs/ DESTINATION "${CMAKE_INSTALL_DOCDIR}")
install(FILES README.md LICENSE CHANGELOG.md CITATION.cff DESTINATION "${CMAKE_INSTALL_DOCDIR}")

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME fiberfate)
set(CPACK_PACKAGE_CONTACT "The fiberfate developers <fiberfate@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "libeigen3-dev, libfmt-dev, libspdlog-dev, libudunits2-dev, libhdf5-dev, libtoml11-dev, libceres-dev, libgmsh-dev, nlohmann-json3-dev")
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "libgmsh4.8")
include(CPack)
