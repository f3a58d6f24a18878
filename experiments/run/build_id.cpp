#include "experiments/run/build_info.h"
#include "experiments/sweep/hash.h"

namespace trocar {

std::string build_id() {
    static const std::string id = hash_of_file("/proc/self/exe");
    return id;
}

}  // namespace trocar
