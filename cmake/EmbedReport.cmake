# fiberfate_embed_report(TARGET) builds the HTML report's template with npm and puts it into TARGET as
# report_template() of results/report_template.hpp. With FIBERFATE_REPORT=OFF the template is empty, and `fiberfate
# report` says why.

# Sets `out` to npm's program, or stops with the remedy.
function(_fiberfate_require_npm out)
  find_program(NPM_PROGRAM npm)
  find_program(NODE_PROGRAM NAMES node nodejs)
  set(remedy "Install them (Debian: apt-get install nodejs npm), or configure with -DFIBERFATE_REPORT=OFF to build without the HTML report.")
  if(NOT NPM_PROGRAM OR NOT NODE_PROGRAM)
    message(FATAL_ERROR "The HTML report needs Node.js and npm, which were not found. ${remedy}")
  endif()
  execute_process(COMMAND "${NODE_PROGRAM}" --version OUTPUT_VARIABLE version OUTPUT_STRIP_TRAILING_WHITESPACE)
  string(REGEX REPLACE "^v" "" version "${version}")
  if(version VERSION_LESS 18)
    message(FATAL_ERROR "The HTML report needs Node.js 18 or newer, found ${version}. ${remedy}")
  endif()
  set(${out} "${NPM_PROGRAM}" PARENT_SCOPE)
endfunction()

function(fiberfate_embed_report target)
  set(code "${PROJECT_BINARY_DIR}/report_template.cpp")
  set(code_template "${PROJECT_SOURCE_DIR}/cmake/report_template.cpp.in")
  if(FIBERFATE_REPORT)
    _fiberfate_require_npm(npm)
    set(source "${PROJECT_SOURCE_DIR}/report")
    # Each build tree has a copy of its own, so that builds beside each other do not meet.
    set(work "${PROJECT_BINARY_DIR}/report")
    set(template "${work}/dist/index.html")
    set(script "${PROJECT_SOURCE_DIR}/cmake/BuildReport.cmake")
    file(GLOB_RECURSE inputs CONFIGURE_DEPENDS "${source}/src/*")
    list(APPEND inputs "${source}/package.json" "${source}/package-lock.json" "${source}/.npmrc"
      "${source}/tsconfig.json" "${source}/vite.config.ts" "${source}/index.html")
    # The code names the digest of the page: a cache of compiled files sees no other trace of the assembler's .incbin.
    add_custom_command(OUTPUT "${template}" "${code}"
      COMMAND "${CMAKE_COMMAND}" -D "npm=${npm}" -D "source=${source}" -D "work=${work}" -D "code=${code}"
        -D "code_template=${code_template}" -P "${script}"
      DEPENDS ${inputs} "${script}" "${code_template}"
      COMMENT "Building the HTML report's template with npm"
      VERBATIM)
    # The compiler does not see the assembler's .incbin as an input.
    set_source_files_properties("${code}" PROPERTIES OBJECT_DEPENDS "${template}" COMPILE_DEFINITIONS FIBERFATE_HAS_REPORT)
  else()
    configure_file("${code_template}" "${code}" @ONLY)
  endif()
  target_sources(${target} PRIVATE "${code}")
endfunction()
