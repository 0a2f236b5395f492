// The fields of every message in their order on the wire. Encoder and decoder both use these lists,
// so that they cannot disagree.
//
// A visitor has
//   visit(field)                 for integers, bool, char and byte arrays
//   visit.choice(field, last)    for enumerations, 0 … last
//   visit.choice(field, last, first)
//   visit.samples(samples, count)
#pragma once

#include <head/messages.hpp>

namespace gs::head {

template <class V, class... Fields>
void visit_all(V& visit, Fields&... fields) {
  (visit(fields), ...);
}

// `M`: the message type, or its const form.
template <class M, class V>
void hello_fields(M& m, V& visit) {
  visit(m.protocol_version);
  // The other fields of another version's hello are unknown.
  if (m.protocol_version != kProtocolVersion) {
    return;
  }
  visit_all(visit, m.flags, m.board, m.unique_id, m.firmware_version, m.build, m.sample_rate_hz,
            m.oversampling, m.dac_bits, m.full_scale, m.full_scale_mv, m.buffer_samples,
            m.longest_samples, m.counts_per_sample, m.inputs, m.watchdog_ms);
}

template <class M, class V>
void status_fields(M& m, V& visit) {
  visit.choice(m.state, kLastState);
  visit.choice(m.fault, kLastFault);
  visit_all(visit, m.run, m.expected, m.position, m.room, m.count, m.echo, m.edges, m.closed,
            m.underruns, m.watchdog_trips, m.bad_frames, m.edges_missed);
}

template <class M, class V>
void fields(M& m, V& visit) {
  constexpr Kind kKind = M::kKind;
  if constexpr (kKind == Kind::kIdentify) {
    visit(m.protocol_version);
  } else if constexpr (kKind == Kind::kArm) {
    visit(m.run);
  } else if constexpr (kKind == Kind::kSamples) {
    visit_all(visit, m.first_sample, m.count);
    visit.samples(m.samples, m.count);
  } else if constexpr (kKind == Kind::kPlay) {
    visit(m.prefill);
  } else if constexpr (kKind == Kind::kPing) {
    visit(m.token);
  } else if constexpr (kKind == Kind::kResendEdges) {
    visit(m.first_edge);
  } else if constexpr (kKind == Kind::kHello) {
    hello_fields(m, visit);
  } else if constexpr (kKind == Kind::kStatus) {
    status_fields(m, visit);
  } else if constexpr (kKind == Kind::kEdge) {
    visit_all(visit, m.edge, m.input, m.closed, m.count);
  } else if constexpr (kKind == Kind::kRefused) {
    visit.choice(m.reason, kLastRefusal, kFirstRefusal);
    visit_all(visit, m.refused, m.expected);
  } else {
    static_assert(kKind == Kind::kStop, "a kind without a list of fields");
  }
}

}  // namespace gs::head
