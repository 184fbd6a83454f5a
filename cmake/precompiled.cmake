# batten_precompile(TARGET HEADERS...): what nearly every source of TARGET reads (the standard library, GLM, tl::expected and the
# HEADERS given) is read once. A source still includes what it uses: -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON builds without.
function(batten_precompile target)
  target_precompile_headers(${target} PRIVATE
    <algorithm> <array> <cmath> <filesystem> <functional> <limits> <memory> <numeric> <optional> <span> <string> <utility> <variant> <vector>
    <glm/geometric.hpp> <glm/vec2.hpp> <glm/vec3.hpp> <tl/expected.hpp> ${ARGN})
endfunction()
