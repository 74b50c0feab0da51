#include "broken_worker.h"

#include <signal.h>
#include <unistd.h>

#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <string_view>

#include "process_table.h"

namespace etalon {

bool Misbehave(const std::string& fault) {
    if (fault == "chatter") {
        for (int i = 0; i < 100'000; ++i) {  // many times what a pipe holds
            std::cout << "driver: chatter" << std::endl;
            std::cerr << "driver: chatter" << std::endl;
        }
        return true;
    }
    if (fault == "count-descriptors") {
        // The five of a worker and the one that reads the folder.
        if (Numbers("/proc/self/fd").size() != 6) {
            std::exit(4);
        }
        return true;
    }
    if (fault == "fork") {
        if (fork() == 0) {
            pause();
        }
        return true;
    }
    if (fault == "last-words") {
        std::cerr << "driver: hello\ndriver: \x1bno\xff such card \n\n";
        std::exit(3);
    }
    char request[4096];
    (void)!read(3, request, sizeof request);
    const auto answer = [](std::uint64_t size, std::string_view body) {
        (void)!write(3, &size, sizeof size);
        (void)!write(3, body.data(), body.size());
    };
    if (fault == "garbage") {
        answer(100, std::string(100, '\x07'));
    } else if (fault == "huge-answer") {
        answer(~0ull, "x");
    } else if (fault == "endless-answer") {
        signal(SIGPIPE, SIG_DFL);
        for (;;) {
            answer(1u << 20, std::string(1u << 20, '\xff'));
        }
    } else if (fault == "hang-up") {
        close(3);
    } else if (fault == "deaf") {
        constexpr std::size_t kInfo = 1 + 6 * 8 + 2 * 8 + 3 * 4 + 2;  // DeviceInfo of empty fields
        answer(kInfo, std::string(1, '\1') + std::string(kInfo - 1, '\0'));
    }
    pause();
    return false;
}

}  // namespace etalon
