# Every library Trocar needs, all of them Debian 12 packages (packages.txt).
# FCL's own CMake target is used because its pkg-config file appends -std=c++11 to the flags.

find_package(Threads REQUIRED)
find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(fcl 0.7 REQUIRED)
find_package(CGAL 5.5 REQUIRED)
find_package(HDF5 1.10 REQUIRED COMPONENTS C)
find_package(CLI11 2.1 REQUIRED)
find_package(tomlplusplus 3.3 REQUIRED)
find_package(fmt REQUIRED)
find_package(nlohmann_json 3.11 REQUIRED)

find_package(PkgConfig REQUIRED)
pkg_check_modules(xxhash REQUIRED IMPORTED_TARGET libxxhash)
pkg_check_modules(fuzzylite REQUIRED IMPORTED_TARGET fuzzylite)

find_path(RANDOM123_INCLUDE_DIR Random123/philox.h REQUIRED)
