#include "evaluate/run.h"

namespace etalon::evaluate {

template class Evaluator<float>;

}  // namespace etalon::evaluate
