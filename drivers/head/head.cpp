#include "head_relay_sense.hpp"
#include "head_source.hpp"
#include "session.hpp"
#include <head_driver/head.hpp>

namespace gsbench::head {

using drivers::Error;
using drivers::Result;
using drivers::Status;

Head::Head(const HeadOptions& options)
    : session_(std::make_shared<Session>(options)),
      source_(std::make_unique<HeadSource>(session_)),
      relay_sense_(std::make_unique<HeadRelaySense>(session_)) {}

Head::~Head() = default;

Result<std::unique_ptr<Head>> Head::create(const HeadOptions& options) {
  if (const Status checked = check(options); !checked.ok()) {
    return Error{checked.error()};
  }
  return std::unique_ptr<Head>(new Head(options));
}

}  // namespace gsbench::head
