#include <algorithm>
#include <set>

#include <judge/judge.hpp>
#include <measures/catalogue.hpp>

namespace gsbench::judge {

using record::MeasurementResult;
using record::Verdict;

namespace {

MeasurementResult result_of(const measures::Measure& measure, const Reading& reading) {
  MeasurementResult result;
  result.name = measure.name;
  result.definition = measure.definition;
  result.value = reading.missing.empty() ? reading.value : kNone;
  result.text = reading.text;
  result.unit = measure.unit;
  result.low = kNone;
  result.high = kNone;
  result.uncertainty = reading.uncertainty;
  result.reason = reading.missing;
  return result;
}

bool concerns(const profile::Expectation& expectation, const record::OutletRecord& outlet) {
  return expectation.groups.empty() ||
         std::find(expectation.groups.begin(), expectation.groups.end(), outlet.group) !=
             expectation.groups.end();
}

// The value is converted to the unit of the limits, so that readers recognise their own figures.
MeasurementResult judged(const profile::Expectation& expectation, const measures::Measure& measure,
                         Reading reading) {
  const double scale = measures::unit_scale(measure.unit, expectation.unit).value_or(kNone);
  reading.value *= scale;
  reading.uncertainty *= scale;
  MeasurementResult result = result_of(measure, reading);
  result.judged = true;
  result.unit = expectation.unit;
  result.low = expectation.min.value_or(kNone);
  result.high = expectation.max.value_or(kNone);
  result.expected_text = expectation.equals.value_or("");
  const Judgement judgement = measure.is_text() ? judge_text(reading, result.expected_text)
                                                : judge_number(reading, result.low, result.high);
  result.verdict = judgement.verdict;
  result.reason = judgement.reason;
  return result;
}

Reading read(const std::string& measure, const Case& c) {
  const measures::Measure* known = measures::find(measure);
  return c.outlet.link.empty() && known != nullptr && known->needs_link
             ? not_known("the outlet has no link: it reports nothing")
             : reading_of(measure)(c);
}

}  // namespace

std::vector<MeasurementResult> measure(const Case& c) {
  std::vector<MeasurementResult> results;
  std::set<std::string> named;
  for (const profile::Expectation& expectation : c.plan.expectations) {
    if (!concerns(expectation, c.outlet)) {
      continue;
    }
    named.insert(expectation.measure);
    if (const measures::Measure* measure = measures::find(expectation.measure)) {
      results.push_back(judged(expectation, *measure, read(measure->name, c)));
    } else {
      // A limit that cannot be checked is kept: without it the outlet could pass.
      results.push_back(judged(expectation, {expectation.measure, expectation.unit, "", ""},
                               not_known("unknown measure")));
    }
  }
  for (const measures::Measure& measure : measures::catalogue()) {
    const bool is_offered = !measure.needs_link || !c.outlet.link.empty();
    if (is_offered && named.count(measure.name) == 0) {
      results.push_back(result_of(measure, read(measure.name, c)));
    }
  }
  return results;
}

void judge_outlet(const Case& c, record::OutletRecord& outlet) {
  outlet.measurements.clear();
  outlet.verdict = outlet.fault.empty() && outlet.took_part ? Verdict::kPass : Verdict::kError;
  if (!outlet.took_part) {
    return;
  }
  outlet.measurements = measure(c);
  bool any_judged = false;
  for (const MeasurementResult& result : outlet.measurements) {
    any_judged = any_judged || result.judged;
    outlet.verdict = std::max(outlet.verdict, result.verdict);  // PASS if it is not judged
  }
  if (!any_judged) {
    // Without limits, nothing was verified.
    outlet.verdict = std::max(outlet.verdict, Verdict::kInconclusive);
  }
}

}  // namespace gsbench::judge
