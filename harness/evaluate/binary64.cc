#include "evaluate/run.h"

namespace etalon::evaluate {

template class Evaluator<double>;

}  // namespace etalon::evaluate
