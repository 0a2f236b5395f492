// Records after a crash of the bench: a child process writes, reports that it is done, and is
// killed between two calls.
#include "sample_run.hpp"
#include <sys/wait.h>
#include <test_support/temporary_folder.hpp>
#include <unistd.h>

#include <csignal>

#include <gmock/gmock.h>

#include <record/store.hpp>

namespace gsbench::record {
namespace {

// Runs `write` in a child process and kills it afterwards with SIGKILL, while its Writer is open.
template <class Write>
void killed_after(Write&& write) {
  int ready[2];
  ASSERT_EQ(::pipe(ready), 0);
  const pid_t child = ::fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    write([&] {
      const char done = 1;
      if (::write(ready[1], &done, 1) == 1) {
        ::pause();
      }
      ::_exit(1);
    });
    ::_exit(1);
  }
  ::close(ready[1]);
  char done = 0;
  EXPECT_EQ(::read(ready[0], &done, 1), 1) << "the child ended early";
  ::close(ready[0]);
  ::kill(child, SIGKILL);
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL);
}

class CrashedStore : public ::testing::TestWithParam<std::size_t> {};

TEST_P(CrashedStore, KeepsEveryFinishedCall) {
  const test::TemporaryFolder folder;
  const std::string path = folder.file("run.sqlite");
  const RunRecord run = sample::loss_500mw(4);
  const std::size_t written = GetParam();
  killed_after([&](auto&& done) {
    Writer writer(path);
    writer.begin(run);
    for (std::size_t i = 0; i < written; ++i) {
      writer.add_outlet(run.outlets[i]);
    }
    done();
  });
  const RunRecord read = read_run(path);
  EXPECT_EQ(read.verdict, Verdict::kError);
  EXPECT_TRUE(read.interrupted);
  EXPECT_THAT(read.verdict_reason, ::testing::StartsWith("interrupted: the run did not finish"));
  RunRecord expected = run;
  expected.interrupted = true;
  expected.fault = read.fault;
  expected.verdict = read.verdict;
  expected.verdict_reason = read.verdict_reason;
  expected.outlets.resize(written);
  for (OutletRecord& outlet : expected.outlets) {  // killed in the midst of judging
    outlet.verdict = Verdict::kError;
    outlet.measurements.clear();
  }
  EXPECT_EQ(content_digest(read), content_digest(expected));
  EXPECT_EQ(folder.entries(), std::vector<std::string>{"run.sqlite"});
}

INSTANTIATE_TEST_SUITE_P(OutletsWritten, CrashedStore, ::testing::Values(0, 1, 4));

TEST(CrashAfterFinish, LeavesACompleteRecord) {
  const test::TemporaryFolder folder;
  const std::string path = folder.file("run.sqlite");
  const RunRecord run = sample::loss_500mw(1);
  killed_after([&](auto&& done) {
    Writer writer(path);
    writer.begin(run);
    writer.add_outlet(run.outlets[0]);
    writer.finish(run);
    done();
  });
  EXPECT_EQ(content_digest(read_run(path)), content_digest(run));
}

}  // namespace
}  // namespace gsbench::record
