// SPDX-License-Identifier: MIT
#pragma once

#include <cassert>
#include <string>
#include <utility>
#include <variant>

/// Errors that are the user's or the file's fault, as values.
///
/// Every fallible function of core returns Result<T>; nothing in core prints, exits or lets a
/// third-party exception through. Programming faults are assertions instead.
namespace soffit {

/// What went wrong, where, and how to mend it. Each member is one sentence without a line break.
struct Error {
  std::string place;  ///< "office.soffit: luminaires[2].flux" or "downlight.ies:47"; may be empty
  std::string what;   ///< what was expected and what was found, no final full stop needed
  std::string hint;   ///< the remedy; may be empty

  /// The whole as one line: "place: what. hint".
  [[nodiscard]] std::string message() const;
};

/// A value or an Error. `if (!r) return r.error();` passes the error on.
template <class T>
class [[nodiscard]] Result {
 public:
  Result(T value) : state_(std::move(value)) {}         // NOLINT: implicit on purpose
  Result(Error error) : state_(std::move(error)) {}     // NOLINT: implicit on purpose

  [[nodiscard]] bool ok() const { return state_.index() == 0; }
  explicit operator bool() const { return ok(); }

  [[nodiscard]] T& value() & { assert(ok()); return *std::get_if<0>(&state_); }
  [[nodiscard]] const T& value() const& { assert(ok()); return *std::get_if<0>(&state_); }
  [[nodiscard]] T&& value() && { assert(ok()); return std::move(*std::get_if<0>(&state_)); }
  T& operator*() & { return value(); }
  const T& operator*() const& { return value(); }
  T&& operator*() && { return std::move(*this).value(); }
  T* operator->() { return &value(); }
  const T* operator->() const { return &value(); }

  [[nodiscard]] const Error& error() const { assert(!ok()); return *std::get_if<1>(&state_); }

 private:
  std::variant<T, Error> state_;
};

/// Success without a value, or an Error.
template <>
class [[nodiscard]] Result<void> {
 public:
  Result() = default;
  Result(Error error) : failed_(true), error_(std::move(error)) {}  // NOLINT: implicit on purpose
  [[nodiscard]] bool ok() const { return !failed_; }
  explicit operator bool() const { return ok(); }
  [[nodiscard]] const Error& error() const { assert(!ok()); return error_; }

 private:
  bool failed_ = false;
  Error error_;
};

}  // namespace soffit
