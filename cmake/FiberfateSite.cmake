# The site: the pages and the gallery as HTML that opens without a server. There is a target `site` where mkdocs and what
# else it needs are there; with FIBERFATE_SITE it is built with the program, and what is built is installed.
option(FIBERFATE_SITE "Build the site with the program, where mkdocs is there" OFF)

find_package(Python3 COMPONENTS Interpreter)
if(NOT Python3_FOUND)
  return()
endif()
set(FIBERFATE_SITE_COMMAND "${CMAKE_COMMAND}" -E env PYTHONDONTWRITEBYTECODE=1 "${Python3_EXECUTABLE}" "${PROJECT_SOURCE_DIR}/site/make_site.py")
execute_process(COMMAND ${FIBERFATE_SITE_COMMAND} --missing OUTPUT_VARIABLE missing OUTPUT_STRIP_TRAILING_WHITESPACE RESULT_VARIABLE status)
if(missing OR NOT status EQUAL 0)
  message(STATUS "No site: these packages are missing: ${missing}")
  return()
endif()

set(FIBERFATE_SITE_DIR "${PROJECT_BINARY_DIR}/site")
list(APPEND FIBERFATE_SITE_COMMAND --program "$<TARGET_FILE:fiberfate>" "${FIBERFATE_SITE_DIR}")
set(site_sources "")
foreach(folder docs cases site)
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/${folder}/*")
  list(APPEND site_sources ${sources})
endforeach()
list(FILTER site_sources EXCLUDE REGEX "__pycache__|/results/")
add_custom_command(OUTPUT "${FIBERFATE_SITE_DIR}/html/index.html" COMMAND ${FIBERFATE_SITE_COMMAND}
                   DEPENDS ${site_sources} "${PROJECT_SOURCE_DIR}/CHANGELOG.md" "${PROJECT_SOURCE_DIR}/CONTRIBUTING.md"
                   COMMENT "Building the site" VERBATIM)
if(FIBERFATE_SITE)
  add_custom_target(site ALL DEPENDS "${FIBERFATE_SITE_DIR}/html/index.html")
else()
  add_custom_target(site DEPENDS "${FIBERFATE_SITE_DIR}/html/index.html")
endif()
add_dependencies(site fiberfate)
install(DIRECTORY "${FIBERFATE_SITE_DIR}/html" DESTINATION "${CMAKE_INSTALL_DOCDIR}" OPTIONAL)
