// The flags that pass through to GoogleTest.
#pragma once

#include <string>
#include <vector>

#include "base/result.h"

namespace etalon {

// Initialises GoogleTest with these "--gtest_..." arguments. Fails for a flag that it does not
// know.
Status<> InitGoogleTest(const std::vector<std::string>& arguments);

}  // namespace etalon
