# SPDX-License-Identifier: MIT
# Language level, warnings, sanitizers, ccache and output folders: the same for every room.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/bin")
set(CMAKE_LIBRARY_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/lib")
set(CMAKE_ARCHIVE_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/lib")

find_program(SPEAR_CCACHE ccache)
if(SPEAR_CCACHE)
    # Precompiled headers and ccache agree only with these settings (ccache manual, "Precompiled headers").
    set(spear_ccache_command ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime
        CCACHE_BASEDIR=${CMAKE_SOURCE_DIR} CCACHE_NOHASHDIR=1 ${SPEAR_CCACHE})
    set(CMAKE_C_COMPILER_LAUNCHER ${spear_ccache_command})
    set(CMAKE_CXX_COMPILER_LAUNCHER ${spear_ccache_command})
endif()

# Targets opt in with target_link_libraries(... PRIVATE spear_options): warnings are for our code, not for generated capnp sources.
add_library(spear_options INTERFACE)
target_compile_options(spear_options INTERFACE -Wall -Wextra -Werror)

if(SPEAR_SANITIZE)
    add_compile_options(-fsanitize=${SPEAR_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
    if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
        add_compile_options(-Wno-maybe-uninitialized) # its flow analysis does not see through the instrumentation (g++ manual, -fsanitize)
    endif()
    add_link_options(-fsanitize=${SPEAR_SANITIZE})
    add_compile_definitions(SPEAR_SANITIZED=1)
endif()
