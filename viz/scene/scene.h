#pragma once
namespace covaria {
struct Scene {};
}  // namespace covaria
