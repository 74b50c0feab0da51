// What a reporter is told of a case beside what its runs found.
#pragma once

#include "case/case.h"
#include "report/record.h"

namespace etalon {

// The functions under test are those that the call and the laws name and the sources define. One
// that is defined below cases/ is a scene's and stands for the functions that it calls itself.
// Files are relative to the root.
CaseNote NoteOf(const Case& source);

}  // namespace etalon
