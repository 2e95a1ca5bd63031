#include "ui/run/run_backend.h"

#include "core/base/guarded.h"
#include "core/propagation/engine.h"

namespace covaria::ui {

namespace {

Result<UncertaintyResult> first_order(const PreparedAnalysis& analysis) {
    auto result = guarded([&] { return evaluate_first_order(*analysis.propagated, analysis.options); });
    if (!result) return fail(result.error());
    if (*result) take_style(**result, analysis.style);
    return *std::move(result);
}

}  // namespace

RunBackend core_backend() {
    return {first_order, run_analysis};
}

}  // namespace covaria::ui
