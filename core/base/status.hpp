#pragma once

#include <string>
#include <tl/expected.hpp>
#include <utility>

namespace biotope {

/// An expected failure (a bad file, a species that does not parse, a full disk).
/// The message says what happened, where, and what to do; it is shown to the person as it is.
struct Error {
  std::string message;
};

/// A value or the Error that kept it from being made.
template <class T>
using Result = tl::expected<T, Error>;

/// Success or an Error.
using Status = tl::expected<void, Error>;

/// Makes the failing side of a Result or a Status: `return fail("...")`.
[[nodiscard]] inline tl::unexpected<Error> fail(std::string message) {
  return tl::unexpected<Error>(Error{std::move(message)});
}

}  // namespace biotope
