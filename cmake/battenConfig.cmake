# The package batten: its target batten::core.
include(CMakeFindDependencyMacro)
find_dependency(glm)
find_dependency(tl-expected)
find_dependency(fmt)
find_dependency(hwy)
include(${CMAKE_CURRENT_LIST_DIR}/glm_target.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/battenTargets.cmake)
