#include "image/write.h"

#include "base/file.h"
#include "image/exr.h"

namespace etalon {

Status<> WriteExr(const std::filesystem::path& path, const Image& image) {
    const Result<std::string> bytes = EncodeExr(image);
    if (!bytes) {
        return Error{path.string() + ": " + bytes.error().message};
    }
    return WriteFile(path, *bytes);
}

}  // namespace etalon
