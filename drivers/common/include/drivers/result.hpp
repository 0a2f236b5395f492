// Drivers return errors by value. The message is for people: it names the port or instrument, the
// operation and the reason. Exceptions of third-party libraries are caught in the adapter.
#pragma once

#include <string>
#include <utility>
#include <variant>

namespace gsbench::drivers {

struct Error {
  std::string message;
};

struct Done {};
template <class T>
class Result;
using Status = Result<Done>;

template <class T>
class [[nodiscard]] Result {
 public:
  Result(T value) : content_(std::move(value)) {}      // NOLINT(google-explicit-constructor)
  Result(Error error) : content_(std::move(error)) {}  // NOLINT(google-explicit-constructor)

  bool ok() const { return std::holds_alternative<T>(content_); }
  const T& value() const { return std::get<T>(content_); }
  // Moves the value out.
  T take() { return std::move(std::get<T>(content_)); }
  // Moves the value to `place`. If there is none, returns the error and leaves `place` unchanged.
  template <class Place>
  Status move_to(Place& place);
  const std::string& error() const { return std::get<Error>(content_).message; }

 private:
  std::variant<T, Error> content_;
};

template <class T>
template <class Place>
Status Result<T>::move_to(Place& place) {
  if (!ok()) {
    return Error{error()};
  }
  place = take();
  return Done{};
}

}  // namespace gsbench::drivers
