# Headers that are parsed once for many sources. Every source includes what it uses all the same: the debug preset builds without.

option(BIOTOPE_PRECOMPILED "Parse the headers that most sources include only once (GCC)" ON)
if(NOT CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  set(BIOTOPE_PRECOMPILED OFF)
endif()

if(BIOTOPE_PRECOMPILED)
  # Lets ccache see through them.
  add_compile_options(-fpch-preprocess)
endif()

# biotope_precompile(TARGET header): the first target that asks for a header parses it, the others take what it made.
function(biotope_precompile target header)
  get_target_property(kind ${target} TYPE)
  if(NOT BIOTOPE_PRECOMPILED OR kind STREQUAL "INTERFACE_LIBRARY")
    return()
  endif()
  get_property(owner GLOBAL PROPERTY biotope_precompiled_${header})
  if(owner)
    target_precompile_headers(${target} REUSE_FROM ${owner})
  else()
    target_precompile_headers(${target} PRIVATE ${PROJECT_SOURCE_DIR}/cmake/precompiled/${header}.hpp)
    set_property(GLOBAL PROPERTY biotope_precompiled_${header} ${target})
  endif()
endfunction()
