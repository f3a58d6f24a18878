# cmake -DSOURCE=… -DINPUT=… -DOUTPUT=… -P git_info.cmake: writes OUTPUT, only where it changes, so that a build
# after a build compiles nothing. A tree without git has the commit "unknown".
set(GIT_COMMIT "unknown")
set(GIT_TREE "clean")
find_program(GIT git)
if(GIT)
    execute_process(COMMAND ${GIT} -C ${SOURCE} rev-parse HEAD
                    OUTPUT_VARIABLE commit RESULT_VARIABLE failed ERROR_QUIET OUTPUT_STRIP_TRAILING_WHITESPACE)
    if(NOT failed)
        set(GIT_COMMIT "${commit}")
        execute_process(COMMAND ${GIT} -C ${SOURCE} status --porcelain
                        OUTPUT_VARIABLE changes ERROR_QUIET OUTPUT_STRIP_TRAILING_WHITESPACE)
        if(changes)
            set(GIT_TREE "dirty")
        endif()
    endif()
endif()
# Programs of different commits differ in the letters of this text, not in its length: git_stamp.h.
string(LENGTH "${GIT_COMMIT}" length)
math(EXPR missing "64 - ${length}")
string(REPEAT " " ${missing} spaces)
string(APPEND GIT_COMMIT "${spaces}")
configure_file(${INPUT} ${OUTPUT} @ONLY)
