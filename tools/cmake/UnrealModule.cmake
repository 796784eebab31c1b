# SPDX-License-Identifier: MIT
# spear_unreal_module(NAME Engine DIRECTORY dir [DEPENDS Core ...] [LIBRARIES target ...] [EXCEPTIONS file.cpp ...]
#                     [PCH header] [OUTPUT_DIRECTORY dir])
#
# Builds one Unreal module (Public/, Private/) into libSpearUE-<NAME>.so the way Unreal does: reflected headers go through the
# header tool and the registration emitter first; no exceptions, no RTTI, hidden visibility, one <NAME>_API macro per module.
# EXCEPTIONS names sources (relative to DIRECTORY) that use third-party C++ libraries and are compiled with exceptions and RTTI.

set(SPEAR_UNREAL_FLAGS -fno-exceptions -fno-rtti -fvisibility=hidden -fvisibility-inlines-hidden -fno-strict-aliasing -Wall -Wextra -Wshadow -Wundef
    -Werror -Wno-unused-parameter)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # UObjects are allocated zeroed before their constructor runs, and members without initialiser rely on it, as in Unreal.
    # g++ 12's flow analysis reports impossible sizes in inlined containers; Unreal's compiler here is clang, which the ue-like preset uses.
    list(APPEND SPEAR_UNREAL_FLAGS -fno-lifetime-dse -Wno-stringop-overflow -Wno-stringop-overread -Wno-array-bounds -Wno-maybe-uninitialized
        -Wno-free-nonheap-object -Wno-restrict)
endif()
set(SPEAR_UNREAL_DEFINITIONS WITH_EDITOR=0 WITH_EDITORONLY_DATA=0 WITH_METADATA=1 UE_BUILD_DEVELOPMENT=1 UE_BUILD_DEBUG=0 UE_BUILD_SHIPPING=0
    PLATFORM_LINUX=1 SPEAR_EMBEDDED_ENGINE=1)
set(SPEAR_API_IMPORT "__attribute__((visibility(\"default\")))")

function(spear_unreal_module)
    cmake_parse_arguments(arg "" "NAME;DIRECTORY;PCH;OUTPUT_DIRECTORY" "DEPENDS;LIBRARIES;EXCEPTIONS;DEFINITIONS" ${ARGN})
    set(module ${arg_NAME})
    set(target SpearUE-${module})
    string(TOUPPER ${module} upper)
    set(generated "${CMAKE_BINARY_DIR}/codegen/${module}")

    file(GLOB_RECURSE headers CONFIGURE_DEPENDS "${arg_DIRECTORY}/Public/*.h" "${arg_DIRECTORY}/Private/*.h")
    file(GLOB_RECURSE sources CONFIGURE_DEPENDS "${arg_DIRECTORY}/Private/*.cpp")

    set(reflected "")
    foreach(header IN LISTS headers)
        file(STRINGS "${header}" has_generated REGEX "#include[ \t]+\"[^\"]+\\.generated\\.h\"")
        if(has_generated)
            list(APPEND reflected "${header}")
        endif()
    endforeach()

    add_library(${target} SHARED ${sources})
    target_include_directories(${target} PUBLIC "${arg_DIRECTORY}/Public" PRIVATE "${arg_DIRECTORY}/Private")
    target_compile_definitions(${target} PUBLIC ${SPEAR_UNREAL_DEFINITIONS} ${arg_DEFINITIONS}
        "${upper}_API=${SPEAR_API_IMPORT}" PRIVATE UE_MODULE_NAME="${module}")
    target_link_libraries(${target} PRIVATE ${arg_LIBRARIES})
    foreach(dependency IN LISTS arg_DEPENDS)
        target_link_libraries(${target} PUBLIC SpearUE-${dependency})
    endforeach()
    if(arg_OUTPUT_DIRECTORY)
        set_target_properties(${target} PROPERTIES LIBRARY_OUTPUT_DIRECTORY "${arg_OUTPUT_DIRECTORY}")
    endif()
    set_target_properties(${target} PROPERTIES BUILD_RPATH "\$ORIGIN" INSTALL_RPATH "\$ORIGIN")
    if(NOT SPEAR_SANITIZE)
        target_link_options(${target} PRIVATE -Wl,--no-undefined)
    endif()
    if(SPEAR_UE_LIKE)
        target_compile_options(${target} PUBLIC -stdlib=libc++)
        target_link_options(${target} PUBLIC -stdlib=libc++ -fuse-ld=lld)
    endif()

    set(ordinary ${sources})
    foreach(source IN LISTS arg_EXCEPTIONS)
        list(REMOVE_ITEM ordinary "${arg_DIRECTORY}/${source}")
        set_source_files_properties("${arg_DIRECTORY}/${source}" PROPERTIES COMPILE_OPTIONS "-fexceptions;-frtti" SKIP_PRECOMPILE_HEADERS ON)
    endforeach()
    target_compile_options(${target} PRIVATE ${SPEAR_UNREAL_FLAGS})
    if(NOT arg_PCH)
        set(arg_PCH CoreMinimal.h)
    endif()

    if(reflected)
        spear_reflect(${target} ${module} "${arg_DIRECTORY}" "${generated}" "${reflected}" "${arg_DEPENDS}")
    endif()
    target_precompile_headers(${target} PRIVATE "$<$<COMPILE_LANGUAGE:CXX>:${arg_PCH}>")
endfunction()

# The generated half of a module: schema, *.generated.h, *.gen.cpp.
function(spear_reflect target module directory generated reflected depends)
    set(schema "${generated}/${module}.schema.json")
    set(imports "")
    set(import_files "")
    foreach(dependency IN LISTS depends)
        get_target_property(dependency_schema SpearUE-${dependency} SPEAR_SCHEMAS)
        if(dependency_schema)
            foreach(file IN LISTS dependency_schema)
                list(APPEND import_files "${file}")
            endforeach()
        endif()
    endforeach()
    list(REMOVE_DUPLICATES import_files)
    foreach(file IN LISTS import_files)
        list(APPEND imports --import "${file}")
    endforeach()
    set_target_properties(${target} PROPERTIES SPEAR_SCHEMAS "${import_files};${schema}" SPEAR_SCHEMA "${schema}")

    add_custom_command(OUTPUT "${schema}"
        COMMAND ${CMAKE_COMMAND} -E make_directory "${generated}/include"
        COMMAND spear-header-tool dump --strict --cache "${CMAKE_BINARY_DIR}/codegen/cache" --module "${module}=${directory}" ${imports}
            --define WITH_EDITOR=0 --define WITH_EDITORONLY_DATA=0 -o "${schema}"
        DEPENDS spear-header-tool ${reflected} ${import_files}
        COMMENT "Reading the reflection of ${module}" VERBATIM)

    set(outputs "")
    set(generated_sources "${generated}/${module}.init.gen.cpp")
    foreach(header IN LISTS reflected)
        get_filename_component(stem "${header}" NAME_WE)
        list(APPEND outputs "${generated}/include/${stem}.generated.h")
        list(APPEND generated_sources "${generated}/${stem}.gen.cpp")
    endforeach()
    get_filename_component(emit "${CMAKE_CURRENT_FUNCTION_LIST_DIR}/../../codegen/emit" ABSOLUTE)
    file(GLOB_RECURSE emitter CONFIGURE_DEPENDS "${emit}/*.py" "${emit}/templates/registration/*")
    # The emitter leaves unchanged files alone, so that only what changed is compiled again; the stamp tells ninja it has run.
    set(stamp "${generated}/registration.stamp")
    add_custom_command(OUTPUT "${stamp}"
        BYPRODUCTS ${outputs} ${generated_sources}
        COMMAND "${SPEAR_VENV}/bin/python" "${emit}" registration "${schema}" ${imports}
            --output-dir "${generated}"
        COMMAND ${CMAKE_COMMAND} -E touch "${stamp}"
        DEPENDS "${schema}" ${emitter}
        COMMENT "Writing the registration code of ${module}" VERBATIM)
    add_custom_target(${target}-reflection DEPENDS "${stamp}")
    add_dependencies(${target} ${target}-reflection)

    set_source_files_properties(${generated_sources} PROPERTIES GENERATED ON UNITY_GROUP generated)
    # One object library for the generated sources, in unity batches: they share nearly all of their includes.
    add_library(${target}-gen OBJECT ${generated_sources})
    add_dependencies(${target}-gen ${target}-reflection)
    set_target_properties(${target}-gen PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 24)
    target_include_directories(${target}-gen PRIVATE "${directory}/Private" "$<TARGET_PROPERTY:${target},INTERFACE_INCLUDE_DIRECTORIES>")
    target_compile_definitions(${target}-gen PRIVATE "$<TARGET_PROPERTY:${target},INTERFACE_COMPILE_DEFINITIONS>" UE_MODULE_NAME="${module}")
    target_compile_options(${target}-gen PRIVATE ${SPEAR_UNREAL_FLAGS})
    if(SPEAR_UE_LIKE)
        target_compile_options(${target}-gen PRIVATE -stdlib=libc++)
    endif()
    foreach(dependency IN LISTS depends)
        target_link_libraries(${target}-gen PRIVATE SpearUE-${dependency})
    endforeach()
    target_sources(${target} PRIVATE $<TARGET_OBJECTS:${target}-gen>)
    target_include_directories(${target} PUBLIC "${generated}/include")
endfunction()
