# trocar_link_program(): makes build/trocar a link to this build's program, so that its name is the same whatever
# the preset. A build outside build/ leaves the link alone, and so does TROCAR_LINK_PROGRAM=OFF.
function(trocar_link_program)
    set(link_folder ${CMAKE_SOURCE_DIR}/build)
    cmake_path(IS_PREFIX link_folder ${CMAKE_BINARY_DIR} inside)
    if(NOT TROCAR_LINK_PROGRAM OR NOT inside)
        return()
    endif()
    # Always run: the link may point to another build although this one is up to date.
    add_custom_target(trocar_link ALL
        COMMAND ${CMAKE_COMMAND} -E create_symlink $<PATH:RELATIVE_PATH,$<TARGET_FILE:trocar>,${link_folder}>
                ${link_folder}/trocar
        COMMENT "Linking build/trocar to this build's program"
        VERBATIM)
    add_dependencies(trocar_link trocar)
endfunction()
