# fiberfate_embed_gallery(TARGET) compiles the files of cases/ and materials/ into TARGET (src/app/gallery.hpp,
# src/app/material_presets.hpp).
set(FIBERFATE_EMBED_GALLERY_SCRIPT "${CMAKE_CURRENT_LIST_DIR}/WriteGallery.cmake")

function(fiberfate_embed_gallery target)
  file(GLOB_RECURSE files CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/cases/*.toml" "${PROJECT_SOURCE_DIR}/cases/*.md"
       "${PROJECT_SOURCE_DIR}/cases/*.txt" "${PROJECT_SOURCE_DIR}/cases/*.csv" "${PROJECT_SOURCE_DIR}/cases/*.msh")
  file(GLOB materials CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/materials/*.toml")
  set(source "${CMAKE_CURRENT_BINARY_DIR}/gallery_files.cpp")
  add_custom_command(
    OUTPUT "${source}"
    COMMAND "${CMAKE_COMMAND}" -D "CASES=${PROJECT_SOURCE_DIR}/cases"
            -D "MATERIALS=${PROJECT_SOURCE_DIR}/materials" -D "OUTPUT=${source}"
            -P "${FIBERFATE_EMBED_GALLERY_SCRIPT}"
    DEPENDS ${files} ${materials} "${FIBERFATE_EMBED_GALLERY_SCRIPT}"
    COMMENT "Embedding cases and materials" VERBATIM)
  target_sources(${target} PRIVATE "${source}")
endfunction()
