// ETALON_CHECK: stops the program, with file and line, at a programmer's mistake.
#pragma once

namespace etalon {

[[noreturn]] void CheckFailed(const char* file, int line, const char* condition);

}  // namespace etalon

#define ETALON_CHECK(condition)                                    \
    do {                                                           \
        if (!(condition)) {                                        \
            ::etalon::CheckFailed(__FILE__, __LINE__, #condition); \
        }                                                          \
    } while (false)
