#include "spirv/loops.h"

#include <spirv/unified1/spirv.hpp11>

#include "base/check.h"

namespace etalon::spirv {

bool HasLoop(std::span<const std::uint32_t> words) {
    constexpr std::size_t kHeader = 5;
    for (std::size_t at = kHeader; at < words.size();) {
        if (static_cast<spv::Op>(words[at] & 0xffffu) == spv::Op::OpLoopMerge) {
            return true;
        }
        const std::size_t length = words[at] >> 16;
        ETALON_CHECK(length > 0);
        at += length;
    }
    return false;
}

}  // namespace etalon::spirv
