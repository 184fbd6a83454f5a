# What is tested at nearly every access and found by AddressSanitizer, or by the processor, too: a third of the time of a sanitized build.
set(BATTEN_SANITIZERS -fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer
  -fno-sanitize=null,alignment,vptr,object-size,nonnull-attribute,returns-nonnull-attribute)

# batten_settings(TARGET): warnings as errors, the sanitizers where asked for, sources together where asked for.
function(batten_settings target)
  set_target_properties(${target} PROPERTIES UNITY_BUILD ${BATTEN_TOGETHER} UNITY_BUILD_BATCH_SIZE 6)
  # Where sources are compiled together, a local name may be that of something in another of them.
  set(shadow -Wshadow)
  if(BATTEN_TOGETHER)
    set(shadow $<$<CXX_COMPILER_ID:GNU>:-Wshadow=local>)
  endif()
  target_compile_options(${target} PRIVATE
    $<$<COMPILE_LANGUAGE:CXX>:-Wall -Wextra -Wpedantic ${shadow} -Wconversion -Wsign-conversion -Wold-style-cast
    -Wnon-virtual-dtor -Woverloaded-virtual -Werror>
    # At -O3 GCC 12 sees copies of endless length and uninitialized optionals where there are none.
    $<$<COMPILE_LANG_AND_ID:CXX,GNU>:-Wno-maybe-uninitialized -Wno-stringop-overflow>)
  # Another compiler, whose warnings are the checks' of style.
  if(BATTEN_FUZZ)
    target_compile_options(${target} PRIVATE -w)
  endif()
  if(BATTEN_SANITIZE)
    target_compile_options(${target} PRIVATE ${BATTEN_SANITIZERS})
    target_link_options(${target} PRIVATE -fsanitize=address,undefined)
  endif()
endfunction()

# batten_library(NAME FOLDER SOURCES...): the static library of one layer. Headers are included by their path from the root
# ("core/curve.h"), but only this folder's are put within reach of those who link the library, so that an include across layers
# does not compile.
function(batten_library name folder)
  add_library(${name} STATIC ${ARGN})
  batten_settings(${name})
  set(reach ${PROJECT_BINARY_DIR}/layers/${name})
  get_filename_component(parent ${reach}/${folder} DIRECTORY)
  file(MAKE_DIRECTORY ${parent})
  file(CREATE_LINK ${PROJECT_SOURCE_DIR}/${folder} ${reach}/${folder} SYMBOLIC)
  target_include_directories(${name} PUBLIC $<BUILD_INTERFACE:${reach}>)
endfunction()
