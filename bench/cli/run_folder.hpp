// Folders of kept runs: one per run, named by its id, in an output folder.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <render/view.hpp>

namespace gsbench::cli {

// A new folder for a run. Without keep(), the destructor removes the folder with its contents and
// the parent folders that were created for it. Thus no incomplete run is left.
class RunFolder {
 public:
  // Throws record::StoreError if the folder cannot be created.
  explicit RunFolder(const std::string& output_folder);
  ~RunFolder();
  RunFolder(const RunFolder&) = delete;
  RunFolder& operator=(const RunFolder&) = delete;

  // Renames the folder to the id of the run and keeps it. Throws record::StoreError.
  void keep(const std::string& run_id);

  const std::string& path() const { return path_; }
  std::string file(const std::string& name) const { return path_ + "/" + name; }

 private:
  void remove_made() noexcept;

  std::string output_folder_;
  std::vector<std::filesystem::path> made_;  // created parents, the innermost first
  std::string path_;
  bool kept_ = false;
};

// $GSBENCH_RUNS, else $XDG_DATA_HOME/gsbench/runs (installation.hpp), else "runs".
std::string default_runs_folder();

constexpr const char* kRecordFile = "record.sqlite";

// Writes the reports of a run into its folder, with `on_request` also those that are kept on
// request only. Throws render::WriteError if one cannot be written; that report is then missing,
// and the record is still there.
void write_reports(const render::View& run, const std::string& folder, bool on_request);

// Path of a record. `run` is the folder of a run, its record file, or the id of a run or the name
// of its folder in `output_folder`, or the start of one. Runs that did not finish count, too.
// Throws profile::ConfigurationError if no run or several runs match.
std::string find_record(const std::string& run, const std::string& output_folder);

// Throws record::StoreError if the file has no bytes. A run that has just begun may have none yet.
void refuse_empty_record(const std::string& record);

// Record files of ended runs in an output folder, in the order of their folder names. Throws
// record::StoreError if the folder cannot be read.
std::vector<std::string> list_records(const std::string& output_folder);

// Folders of runs that are in progress or whose process was killed.
std::vector<std::string> list_unfinished(const std::string& output_folder);

}  // namespace gsbench::cli
