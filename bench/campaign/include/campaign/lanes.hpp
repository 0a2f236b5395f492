// A vector of floats, one trajectory in each lane, for the firmware's templates. Every operation is
// done lane by lane, in the firmware's order and without contraction, so that a lane's result
// equals that of an outlet bit for bit, for any vector width of the processor.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>

namespace gsbench::campaign {

constexpr std::size_t kWidth = 8;  // as in AVX2; narrower vectors need several steps
constexpr std::size_t kVectors =
    4;  // hides the latency: others compute while one waits for its result
constexpr std::size_t kLanes = kWidth * kVectors;

using Floats = float __attribute__((vector_size(kWidth * sizeof(float))));
using Integers = std::int32_t __attribute__((vector_size(kWidth * sizeof(std::int32_t))));

// AVX2's aligned moves need this alignment. Without it, a compiler for the baseline processor would
// align to half of it.
constexpr std::size_t kAlignment = kWidth * sizeof(float);
struct alignas(kAlignment) Lanes {
  Floats v[kVectors];
};
struct alignas(kAlignment) Mask {
  Integers v[kVectors];  // −1 if true, else 0
};

template <class Result, class Each>
inline Result each_vector(const Each& each) {
  Result result;
  for (std::size_t i = 0; i < kVectors; ++i) {
    result.v[i] = each(i);
  }
  return result;
}

inline const Floats& vector_of(const Lanes& lanes, std::size_t i) {
  return lanes.v[i];
}
// The same number in each lane.
inline float vector_of(float number, std::size_t /*i*/) {
  return number;
}

// Enables an operator if at least one operand is Lanes. The other may be a float.
template <class A, class B>
using IfLanes = std::enable_if_t<std::is_same_v<A, Lanes> || std::is_same_v<B, Lanes>>;

template <class A, class B, class = IfLanes<A, B>>
Lanes operator+(const A& a, const B& b) {
  return each_vector<Lanes>([&](std::size_t i) { return vector_of(a, i) + vector_of(b, i); });
}
template <class A, class B, class = IfLanes<A, B>>
Lanes operator-(const A& a, const B& b) {
  return each_vector<Lanes>([&](std::size_t i) { return vector_of(a, i) - vector_of(b, i); });
}
template <class A, class B, class = IfLanes<A, B>>
Lanes operator*(const A& a, const B& b) {
  return each_vector<Lanes>([&](std::size_t i) { return vector_of(a, i) * vector_of(b, i); });
}
template <class A, class B, class = IfLanes<A, B>>
Lanes operator/(const A& a, const B& b) {
  return each_vector<Lanes>([&](std::size_t i) { return vector_of(a, i) / vector_of(b, i); });
}
inline Lanes operator-(const Lanes& a) {
  return each_vector<Lanes>([&](std::size_t i) { return -a.v[i]; });
}

template <class B>
Mask operator<(const Lanes& a, const B& b) {
  return each_vector<Mask>([&](std::size_t i) { return a.v[i] < vector_of(b, i); });
}
template <class B>
Mask operator>(const Lanes& a, const B& b) {
  return each_vector<Mask>([&](std::size_t i) { return a.v[i] > vector_of(b, i); });
}
template <class B>
Mask operator>=(const Lanes& a, const B& b) {
  return each_vector<Mask>([&](std::size_t i) { return a.v[i] >= vector_of(b, i); });
}

inline Lanes load(const float* values) {
  Lanes lanes;
  std::memcpy(&lanes, values, sizeof lanes);
  return lanes;
}
inline void store(const Lanes& lanes, float* values) {
  std::memcpy(values, &lanes, sizeof lanes);
}

// The firmware has select() and root() for float. Its templates find these overloads for Lanes by
// argument-dependent lookup.
inline Lanes select(const Mask& condition, const Lanes& a, const Lanes& b) {
  return each_vector<Lanes>([&](std::size_t i) { return condition.v[i] ? a.v[i] : b.v[i]; });
}
inline Lanes root(const Lanes& x) {
  float values[kLanes];
  store(x, values);
  for (float& value : values) {
    value = __builtin_sqrtf(value);
  }
  return load(values);
}

}  // namespace gsbench::campaign
