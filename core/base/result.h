// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cassert>
#include <utility>
#include <variant>

#include "core/base/error.h"

namespace ew {

/// Carries an error into a Result, as std::unexpected does.
template <class E>
class Unexpected {
  public:
    explicit Unexpected(E e) : error_(std::move(e)) {}
    const E& error() const& { return error_; }
    E&& error() && { return std::move(error_); }

  private:
    E error_;
};

/// Makes an Error ready to be returned from a function that returns a Result.
inline Unexpected<Error> fail(Errc code, std::string message, std::vector<Vec2> where = {}) {
    return Unexpected<Error>(Error{code, std::move(message), std::move(where)});
}
inline Unexpected<Error> fail(Error error) { return Unexpected<Error>(std::move(error)); }

/// A value or an error, with the member names of std::expected (which GCC 12 has not in C++20).
template <class T, class E = Error>
class [[nodiscard]] Result {
  public:
    using value_type = T;
    using error_type = E;

    Result(T value) : state_(std::in_place_index<0>, std::move(value)) {}
    Result(Unexpected<E> error) : state_(std::in_place_index<1>, std::move(error).error()) {}

    bool has_value() const { return state_.index() == 0; }
    explicit operator bool() const { return has_value(); }

    T& value() & {
        assert(has_value());
        return *std::get_if<0>(&state_);
    }
    const T& value() const& {
        assert(has_value());
        return *std::get_if<0>(&state_);
    }
    T&& value() && {
        assert(has_value());
        return std::move(*std::get_if<0>(&state_));
    }
    T& operator*() & { return value(); }
    const T& operator*() const& { return value(); }
    T&& operator*() && { return std::move(*this).value(); }
    T* operator->() { return &value(); }
    const T* operator->() const { return &value(); }

    const E& error() const& {
        assert(!has_value());
        return *std::get_if<1>(&state_);
    }
    E&& error() && {
        assert(!has_value());
        return std::move(*std::get_if<1>(&state_));
    }

    template <class U>
    T value_or(U&& other) const& {
        return has_value() ? value() : static_cast<T>(std::forward<U>(other));
    }

  private:
    std::variant<T, E> state_;
};

/// Success without a value, or an error.
template <class E>
class [[nodiscard]] Result<void, E> {
  public:
    using value_type = void;
    using error_type = E;

    Result() = default;
    Result(Unexpected<E> error) : error_(std::in_place_index<1>, std::move(error).error()) {}

    bool has_value() const { return error_.index() == 0; }
    explicit operator bool() const { return has_value(); }
    void value() const { assert(has_value()); }
    const E& error() const& {
        assert(!has_value());
        return *std::get_if<1>(&error_);
    }
    E&& error() && {
        assert(!has_value());
        return std::move(*std::get_if<1>(&error_));
    }

  private:
    std::variant<std::monostate, E> error_;
};

}  // namespace ew
