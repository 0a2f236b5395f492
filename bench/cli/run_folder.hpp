// Where runs are kept: one folder a run, named by its id, in an output folder.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <record/run_record.hpp>

namespace gsbench::cli {

// A new folder for one run. Unless keep() was called it is gone again with everything in it, and so
// are the folders above it that were made for it: nothing half written stays behind.
class RunFolder {
 public:
  // Throws record::StoreError where the folder cannot be made.
  explicit RunFolder(const std::string& output_folder);
  ~RunFolder();
  RunFolder(const RunFolder&) = delete;
  RunFolder& operator=(const RunFolder&) = delete;

  // Gives it the run's own name and keeps it.
  void keep(const std::string& run_id);

  const std::string& path() const { return path_; }
  std::string file(const std::string& name) const { return path_ + "/" + name; }

 private:
  void remove_made() noexcept;

  std::string output_folder_;
  std::vector<std::filesystem::path> made_;  // above the run's own, the innermost first
  std::string path_;
  bool kept_ = false;
};

// $GSBENCH_RUNS, else $XDG_DATA_HOME/gsbench/runs (installation.hpp), else "runs".
std::string default_runs_folder();

constexpr const char* kRecordFile = "record.sqlite";

// Writes every report of a run into its folder. Throws render::WriteError where one cannot be
// written: that one is not there then, and the record still is.
void write_reports(const record::RunRecord& run, const std::string& folder);

// `run`: a run's folder, its record file, or a run id (or its beginning) in `output_folder`.
std::string find_record(const std::string& run, const std::string& output_folder);

// Record files of ended runs in an output folder, in order of their folders' names. Throws
// record::StoreError where the folder cannot be read.
std::vector<std::string> list_records(const std::string& output_folder);

// Folders of runs under way, or whose process was killed.
std::vector<std::string> list_unfinished(const std::string& output_folder);

}  // namespace gsbench::cli
