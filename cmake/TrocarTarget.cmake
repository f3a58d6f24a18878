# trocar_library(<name> SOURCES … PUBLIC … PRIVATE …): one folder, one target, alias trocar::<name>.
# trocar_compile_options(<target>): the flags every target of ours is built with.

include(GNUInstallDirs)

find_program(TROCAR_CCACHE ccache)
if(TROCAR_CCACHE AND NOT DEFINED CMAKE_CXX_COMPILER_LAUNCHER)
    set(CMAKE_CXX_COMPILER_LAUNCHER ${TROCAR_CCACHE})
endif()

function(trocar_compile_options target)
    target_compile_features(${target} PUBLIC cxx_std_20)
    set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF POSITION_INDEPENDENT_CODE ON)
    # Fused multiply-add would change the bits from one machine type to another.
    target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion
                                             -ffp-contract=off)
    if(CMAKE_CXX_FLAGS MATCHES "-fsanitize")
        # GCC's sanitizers make it see uninitialised values in CGAL's headers where there are none.
        target_compile_options(${target} PRIVATE -Wno-maybe-uninitialized)
    endif()
    if(TROCAR_WARNINGS_AS_ERRORS)
        target_compile_options(${target} PRIVATE -Werror)
    endif()
endfunction()

function(trocar_library name)
    cmake_parse_arguments(ARG "" "" "SOURCES;PUBLIC;PRIVATE" ${ARGN})
    add_library(trocar_${name} STATIC ${ARG_SOURCES})
    add_library(trocar::${name} ALIAS trocar_${name})
    target_include_directories(trocar_${name} PUBLIC $<BUILD_INTERFACE:${CMAKE_SOURCE_DIR}>
                                                     $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/trocar>)
    target_link_libraries(trocar_${name} PUBLIC ${ARG_PUBLIC} PRIVATE ${ARG_PRIVATE})
    trocar_compile_options(trocar_${name})
endfunction()
