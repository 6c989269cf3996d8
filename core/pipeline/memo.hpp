#pragma once

#include <memory>
#include <optional>
#include <utility>

#include "core/base/status.hpp"

namespace biotope {

/// The last output of an operator with the inputs it was made from. Inputs are pointers to immutable parts or plain values, compared with ==.
template <class Key, class Value>
struct Memo {
  std::optional<Key> key;
  std::shared_ptr<const Value> value;

  /// The value for `wanted`: the one held when the inputs are equal, else `compute()`. A computed value equal to the one held keeps the old
  /// pointer (backdating), so that what depends on it stays clean.
  template <class Compute, class Same>
  Result<std::shared_ptr<const Value>> get(const Key& wanted, const Compute& compute, const Same& same) {
    if (value && key && *key == wanted) return value;
    Result<Value> made = compute();
    if (!made) return tl::unexpected<Error>(made.error());
    if (!value || !same(*value, *made)) value = std::make_shared<const Value>(std::move(*made));
    key = wanted;
    return value;
  }

  /// As above, without backdating: every computed value is a new one.
  template <class Compute>
  Result<std::shared_ptr<const Value>> get(const Key& wanted, const Compute& compute) {
    return get(wanted, compute, [](const Value&, const Value&) { return false; });
  }
};

}  // namespace biotope
