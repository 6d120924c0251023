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
  target_sources(${target} PRIVATE "${source}")
endfunction()

function(fiberfate_embed_gallery target)
  file(GLOB_RECURSE files CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/cases/*.toml" "${PROJECT_SOURCE_DIR}/cases/*.md"
       "${PROJECT_SOURCE_DIR}/cases/*.txt" "${PROJECT_SOURCE_DIR}/cases/*.csv" "${PROJECT_SOURCE_DIR}/cases/*.msh")
  _fiberfate_embed(${target} gallery_files "${FIBERFATE_CMAKE_SCRIPTS}/WriteGallery.cmake"
                   "CASES=${PROJECT_SOURCE_DIR}/cases" ${files})
endfunction()

function(fiberfate_embed_materials target)
  file(GLOB files CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/materials/*.toml")
  _fiberfate_embed(${target} material_files "${FIBERFATE_CMAKE_SCRIPTS}/WriteMaterials.cmake"
                   "MATERIALS=${PROJECT_SOURCE_DIR}/materials" ${files})
endfunction()
