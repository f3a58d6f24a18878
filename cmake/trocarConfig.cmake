# find_package(trocar): the targets trocar::common and trocar::strategies, and the libraries that they need.
include(CMakeFindDependencyMacro)

# Eigen is in our headers; the others are only linked.
find_dependency(Eigen3 3.4 NO_MODULE)
find_dependency(fcl 0.7)
find_dependency(CGAL 5.5)
find_dependency(fmt)
find_dependency(PkgConfig)
pkg_check_modules(fuzzylite REQUIRED IMPORTED_TARGET fuzzylite)

include(${CMAKE_CURRENT_LIST_DIR}/trocarTargets.cmake)
