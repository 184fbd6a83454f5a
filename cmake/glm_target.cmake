# GLM's package calls its target glm or glm::glm, depending on its version; after this it is glm::glm. Installed beside batten's own package.
if(NOT TARGET glm::glm)
  add_library(glm::glm INTERFACE IMPORTED)
  target_link_libraries(glm::glm INTERFACE glm)
endif()
