// Tells a person how the tests go.
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "report/record.h"

namespace etalon {

// A progress line and each failure in full, on the standard output; with `verbose` a line for each
// of the `total` tests. The last of `records` is that of the test that has just ended.
std::unique_ptr<::testing::TestEventListener> MakeListener(const std::vector<Record>& records,
                                                           bool verbose, int total);

}  // namespace etalon
