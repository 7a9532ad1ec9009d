# Compiler settings shared by every target of this project, as the interface target edgewright_options.
add_library(edgewright_options INTERFACE)
target_include_directories(edgewright_options INTERFACE ${CMAKE_SOURCE_DIR})
target_compile_options(edgewright_options INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wconversion)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
    # Cries wolf at std::string + std::string where it is inlined (GCC bug 105651).
    target_compile_options(edgewright_options INTERFACE -Wno-restrict)
endif()
target_compile_definitions(edgewright_options INTERFACE
    EDGEWRIGHT_VERSION="${PROJECT_VERSION}")

if(EDGEWRIGHT_SANITIZE)
    target_compile_options(edgewright_options INTERFACE
        -fsanitize=${EDGEWRIGHT_SANITIZE} -fno-omit-frame-pointer)
    target_link_options(edgewright_options INTERFACE -fsanitize=${EDGEWRIGHT_SANITIZE})
    if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
        # What the sanitizers put in hides from GCC that OpenMesh's vectors are written first.
        target_compile_options(edgewright_options INTERFACE -Wno-maybe-uninitialized)
    endif()
endif()
if(EDGEWRIGHT_COVERAGE)
    target_compile_options(edgewright_options INTERFACE --coverage)
    target_link_options(edgewright_options INTERFACE --coverage)
endif()
if(EDGEWRIGHT_CCACHE)
    find_program(CCACHE_PROGRAM ccache)
    if(CCACHE_PROGRAM)
        set(CMAKE_C_COMPILER_LAUNCHER ${CCACHE_PROGRAM})
        set(CMAKE_CXX_COMPILER_LAUNCHER ${CCACHE_PROGRAM})
    endif()
endif()
