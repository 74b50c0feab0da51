// The main function of a test program that starts workers: it is also its own worker, as `etalon`
// is. Taken instead of the test library's, which the linker looks at last.
#include <gmock/gmock.h>

#include <string_view>

#include "worker/serve.h"

int main(int argc, char** argv) {
    if (argc > 1 && std::string_view(argv[1]) == "worker") {
        return etalon::ServeWorker(argc, argv);
    }
    testing::InitGoogleMock(&argc, argv);
    return RUN_ALL_TESTS();
}
