// Input quantities that a model, what is prepared of it and its results have in common.
#pragma once

#include <memory>
#include <utility>

#include "core/quantity/input_quantity.h"

namespace covaria {

/// Never changed; a copy is the same object.
class SharedInputs {
public:
    SharedInputs() : SharedInputs(InputSet{}) {}
    SharedInputs(InputSet inputs) : inputs_(std::make_shared<const InputSet>(std::move(inputs))) {}
    /// Takes a set that others hold already; not null.
    SharedInputs(std::shared_ptr<const InputSet> inputs) : inputs_(std::move(inputs)) {}

    operator const InputSet&() const { return *inputs_; }
    const InputSet& operator*() const { return *inputs_; }
    const InputSet* operator->() const { return inputs_.get(); }

private:
    std::shared_ptr<const InputSet> inputs_;
};

}  // namespace covaria
