# fiberfate_embed_gallery(TARGET) compiles the files of cases/ into TARGET (src/app/gallery.hpp), and
# fiberfate_embed_materials(TARGET) those of materials/ (src/keys/material_presets.hpp).
set(FIBERFATE_CMAKE_SCRIPTS "${CMAKE_CURRENT_LIST_DIR}")

# Compiles what SCRIPT writes from the given FILES into TARGET.
function(_fiberfate_embed target name script argument)
  set(source "${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp")
  add_custom_command(
    OUTPUT "${source}"
    COMMAND "${CMAKE_COMMAND}" -D "${argument}" -D "OUTPUT=${source}" -P "${script}"
    DEPENDS ${ARGN} "${script}"
    COMMENT "Embedding ${name}" VERBATIM)
  # Pictures are longer than compilers must support.
  set_source_files_properties("${source}" PROPERTIES COMPILE_OPTIONS "-Wno-overlength-strings")
  target_sources(${target} PRIVATE "${source}")
endfunction()

function(fiberfate_embed_gallery target)
  file(GLOB files CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/cases/*.py" "${PROJECT_SOURCE_DIR}/cases/[0-9][0-9]_*/*")
  _fiberfate_embed(${target} gallery_files "${FIBERFATE_CMAKE_SCRIPTS}/WriteGallery.cmake"
                   "CASES=${PROJECT_SOURCE_DIR}/cases" ${files})
endfunction()

function(fiberfate_embed_materials target)
  file(GLOB files CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/materials/*.toml")
  _fiberfate_embed(${target} material_files "${FIBERFATE_CMAKE_SCRIPTS}/WriteMaterials.cmake"
                   "MATERIALS=${PROJECT_SOURCE_DIR}/materials" ${files})
endfunction()
