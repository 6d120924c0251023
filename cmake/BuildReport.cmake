# Builds the report's template: cmake -D npm=NPM -D source=REPORT -D work=DIR -P BuildReport.cmake leaves
# DIR/dist/index.html, and with -D code_template=IN -D code=OUT the code that holds it. Packages are installed again only
# when the lock file has changed.
function(run what)
  execute_process(COMMAND ${ARGN} WORKING_DIRECTORY "${work}" RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT status EQUAL 0)
    message("${output}")
    message(FATAL_ERROR "${what} failed (status ${status}). Without network access or npm, configure with -DFIBERFATE_REPORT=OFF.")
  endif()
endfunction()

file(REMOVE_RECURSE "${work}/src" "${work}/dist")
file(MAKE_DIRECTORY "${work}")
foreach(part src package.json package-lock.json .npmrc tsconfig.json vite.config.ts index.html)
  file(COPY "${source}/${part}" DESTINATION "${work}")
endforeach()

set(stamp "${work}/node_modules/.fiberfate-lock")
file(SHA256 "${source}/package-lock.json" wanted)
set(installed "")
if(EXISTS "${stamp}")
  file(READ "${stamp}" installed)
endif()
if(NOT installed STREQUAL wanted)
  # rollup is its WebAssembly build (report/package.json): no package here is tied to a processor but esbuild.
  # No package here needs its install script; --include=dev holds even where NODE_ENV says production.
  run("npm ci of the report's packages" "${npm}" ci --ignore-scripts --include=dev --prefer-offline --no-audit --no-fund)
  file(WRITE "${stamp}" "${wanted}")
endif()
run("The build of the report" "${npm}" run build)

set(FIBERFATE_REPORT_TEMPLATE "${work}/dist/index.html")
file(SHA256 "${FIBERFATE_REPORT_TEMPLATE}" FIBERFATE_REPORT_DIGEST)
configure_file("${code_template}" "${code}" @ONLY)
file(TOUCH "${code}")
