# trocar_package(): what `cmake --install` puts in place. The libraries common and strategies with their headers, for
# find_package(trocar); the program. (The analysis installs itself.) results and experiments are the inside of the
# program: other software meets them through sweep files and result files. So is common/process, which they use.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

function(trocar_package)
    foreach(name common strategies)
        set_target_properties(trocar_${name} PROPERTIES EXPORT_NAME ${name})
        install(TARGETS trocar_${name} EXPORT trocarTargets)
        install(DIRECTORY ${CMAKE_SOURCE_DIR}/${name} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/trocar
                FILES_MATCHING PATTERN "*.h" PATTERN process EXCLUDE)
    endforeach()

    set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/trocar)
    install(EXPORT trocarTargets NAMESPACE trocar:: DESTINATION ${package_folder})
    # Before version 1.0.0 a new minor version may change any interface.
    write_basic_package_version_file(${CMAKE_BINARY_DIR}/trocarConfigVersion.cmake COMPATIBILITY SameMinorVersion)
    install(FILES ${CMAKE_SOURCE_DIR}/cmake/trocarConfig.cmake ${CMAKE_BINARY_DIR}/trocarConfigVersion.cmake
            DESTINATION ${package_folder})

    install(TARGETS trocar)
    # What `trocar reproduce` runs.
    install(FILES ${CMAKE_SOURCE_DIR}/experiments/claims.toml
            DESTINATION ${CMAKE_INSTALL_DATADIR}/trocar/experiments)
    install(DIRECTORY ${CMAKE_SOURCE_DIR}/experiments/claims
            DESTINATION ${CMAKE_INSTALL_DATADIR}/trocar/experiments
            FILES_MATCHING PATTERN "*.toml")
    install(FILES LICENSE CITATION.cff DESTINATION ${CMAKE_INSTALL_DOCDIR})
endfunction()
