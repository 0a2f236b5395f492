#include "format.hpp"
#include "kept.hpp"
#include "summary.hpp"

#include <QByteArray>
#include <QString>
#include <QXmlStreamWriter>
#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include <fmt/format.h>

#include <render/render.hpp>

namespace gsbench::render {
namespace {

using record::Verdict;

QString text(const std::string& utf8) {
  return QString::fromStdString(valid_text(utf8));
}

// One <testcase>. JUnit has no INCONCLUSIVE: it becomes a failure.
struct Case {
  std::string name;
  Verdict verdict = Verdict::kPass;
  std::string message;
  bool judged = true;
  std::string output = {};
};

Case case_of(const record::MeasurementResult& result) {
  Case one{result.name, result.verdict, shortfall_text(result), result.judged};
  if (!result.judged) {
    one.message = value_of(result) + " (no limit)";
  }
  return one;
}

// CI joins the history of cases by their names, so each is unique: a measure with several limits
// has the limit in its name, and a number if it has the same limit again.
std::vector<Case> cases_of(const std::vector<record::MeasurementResult>& results) {
  std::map<std::string, int> limits_of_measure;
  for (const record::MeasurementResult& result : results) {
    ++limits_of_measure[result.name];
  }
  std::vector<Case> cases;
  std::set<std::string> names;
  for (const record::MeasurementResult& result : results) {
    Case one = case_of(result);
    if (limits_of_measure[result.name] > 1 && result.judged) {
      one.name += ' ' + limits(result);
    }
    const std::string name = one.name;
    for (int n = 2; !names.insert(one.name).second; ++n) {
      one.name = fmt::format("{} ({})", name, n);
    }
    cases.push_back(std::move(one));
  }
  return cases;
}

// The element for its outcome; "" for a case that passed.
std::string outcome_of(const Case& one) {
  if (!one.judged) {
    return "skipped";
  }
  if (one.verdict == Verdict::kPass) {
    return "";
  }
  return one.verdict == Verdict::kError ? "error" : "failure";
}

void write_suite(QXmlStreamWriter& xml, const record::RunRecord& run, const std::string& name,
                 const std::vector<Case>& cases) {
  const auto count = [&](const char* outcome) {
    return QString::number(std::count_if(
        cases.begin(), cases.end(), [&](const Case& one) { return outcome_of(one) == outcome; }));
  };
  xml.writeStartElement("testsuite");
  xml.writeAttribute("name", text(name));
  xml.writeAttribute("tests", QString::number(cases.size()));
  xml.writeAttribute("failures", count("failure"));
  xml.writeAttribute("errors", count("error"));
  xml.writeAttribute("skipped", count("skipped"));
  xml.writeAttribute("timestamp", text(run.started_utc));
  for (const Case& one : cases) {
    xml.writeStartElement("testcase");
    xml.writeAttribute("classname", text(run.profile + "." + name));
    xml.writeAttribute("name", text(one.name));
    const std::string outcome = outcome_of(one);
    if (!outcome.empty()) {
      xml.writeStartElement(QString::fromStdString(outcome));
      if (one.judged) {
        xml.writeAttribute("type", record::to_string(one.verdict));
      }
      xml.writeAttribute("message", text(one.message));
      xml.writeEndElement();
    }
    if (!one.output.empty()) {
      xml.writeTextElement("system-out", text(one.output));
    }
    xml.writeEndElement();
  }
  xml.writeEndElement();
}

// Of an outlet whose verdict is worse than those of its measurements.
Case case_of(const View& view, std::size_t index) {
  const record::OutletRecord& outlet = view.run.outlets[index];
  Case one{"outlet", outlet.verdict, outlet_sentence(outlet)};
  if (!is_judged(view.run)) {
    const std::string fault = outlet.fault.empty() ? "" : one.message + "; ";
    one.message = fault + "not judged; kept: " + kept_sentence(view.run, kept_of(view, index));
    one.output = kept_list(view.run, view.marked(index));
  }
  return one;
}

Verdict worst(const std::vector<Case>& cases) {
  Verdict verdict = Verdict::kPass;
  for (const Case& one : cases) {
    if (one.judged) {
      verdict = std::max(verdict, one.verdict);
    }
  }
  return verdict;
}

}  // namespace

// If the verdict of an outlet or of the run is worse than those of its measurements (the outlet was
// lost, the run did not finish), a case is added for it, so that CI does not show the run as
// passed.
std::string junit_xml(const View& view) {
  const record::RunRecord& run = view.run;
  QByteArray bytes;
  QXmlStreamWriter xml(&bytes);
  xml.setAutoFormatting(true);
  xml.setAutoFormattingIndent(2);
  xml.writeStartDocument();
  xml.writeStartElement("testsuites");
  xml.writeAttribute("name", text(run.profile));
  for (const std::size_t index : view.outlets) {
    const record::OutletRecord& outlet = run.outlets[index];
    std::vector<Case> cases = cases_of(outlet.measurements);
    if (outlet.verdict > worst(cases)) {
      cases.push_back(case_of(view, index));
    }
    write_suite(xml, run, outlet.id, cases);
  }
  Verdict of_outlets = Verdict::kPass;
  for (const record::OutletRecord& outlet : run.outlets) {
    of_outlets = std::max(of_outlets, outlet.verdict);
  }
  if (run.verdict > of_outlets || !is_judged(run)) {
    write_suite(xml, run, "run", {{"run", run.verdict, verdict_sentence(run)}});
  }
  xml.writeEndDocument();
  return bytes.toStdString();
}

}  // namespace gsbench::render
