# Finds the spline libraries that bench_accuracy compares with, as the targets peer_sisl and peer_occt. Only for BATTEN_PEERS.
# OpenCASCADE's own package file is not used: it asks for the development files of libraries that are not needed here.
find_path(OCCT_INCLUDE_DIR Geom2d_BSplineCurve.hxx PATH_SUFFIXES opencascade REQUIRED)
add_library(peer_occt INTERFACE)
target_include_directories(peer_occt SYSTEM INTERFACE ${OCCT_INCLUDE_DIR})
foreach(name TKGeomAlgo TKGeomBase TKG3d TKG2d TKMath TKernel)
  find_library(OCCT_${name} ${name} REQUIRED)
  target_link_libraries(peer_occt INTERFACE ${OCCT_${name}})
endforeach()

find_path(SISL_INCLUDE_DIR sisl.h REQUIRED)
find_library(SISL_LIBRARY sisl REQUIRED)
add_library(peer_sisl INTERFACE)
target_include_directories(peer_sisl SYSTEM INTERFACE ${SISL_INCLUDE_DIR})
target_link_libraries(peer_sisl INTERFACE ${SISL_LIBRARY} m)

# SISL's headers do not tell its version; the package does, where there is one.
execute_process(
  COMMAND dpkg-query --show --showformat=\${source:Upstream-Version} libsisl-dev
  OUTPUT_VARIABLE SISL_VERSION
  ERROR_QUIET)
