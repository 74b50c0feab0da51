#include "oracle/function.h"

#include <algorithm>

#include "oracle/absorption.h"
#include "oracle/conductor.h"
#include "oracle/fresnel.h"
#include "oracle/intensity.h"
#include "oracle/layered.h"
#include "oracle/plane.h"
#include "oracle/relief.h"
#include "oracle/relief_fields.h"
#include "oracle/relief_layers.h"
#include "oracle/relief_texels.h"
#include "oracle/shadow.h"
#include "oracle/shadow_map.h"
#include "oracle/slab.h"
#include "oracle/snell.h"
#include "oracle/translucent.h"

namespace etalon::oracle {

const std::vector<Function>& Functions() {
    static const std::vector<Function> functions = [] {
        std::vector<Function> all;
        for (const auto& part : {
                 AbsorptionFunctions(),
                 ConductorFunctions(),
                 FresnelFunctions(),
                 IntensityFunctions(),
                 LayeredFunctions(),
                 PlaneFunctions(),
                 ReliefFunctions(),
                 ReliefFieldFunctions(),
                 ReliefLayerFunctions(),
                 ReliefTexelFunctions(),
                 ShadowFunctions(),
                 ShadowMapFunctions(),
                 SlabFunctions(),
                 SnellFunctions(),
                 TranslucentFunctions(),
             }) {
            all.insert(all.end(), part.begin(), part.end());
        }
        return all;
    }();
    return functions;
}

const Function* FindFunction(std::string_view name) {
    const auto& functions = Functions();
    const auto found = std::ranges::find(functions, name, &Function::name);
    return found == functions.end() ? nullptr : &*found;
}

}  // namespace etalon::oracle
