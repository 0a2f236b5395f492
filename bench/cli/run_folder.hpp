// Where runs are kept: one folder a run, named by its id, in an output folder.
#pragma once

#include <string>
#include <vector>

#include <record/run_record.hpp>

namespace gsbench::cli {

// A new folder for one run. Unless keep() was called it is gone again with everything in it:
// nothing half written stays behind.
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
  std::string output_folder_;
  bool made_output_folder_ = false;
  std::string path_;
  bool kept_ = false;
};

constexpr const char* kRecordFile = "record.sqlite";

// Writes every report of a run into its folder.
void write_reports(const record::RunRecord& run, const std::string& folder);

// `run`: a run's folder, its record file, or a run id (or its beginning) in `output_folder`.
std::string find_record(const std::string& run, const std::string& output_folder);

// Record files of ended runs in an output folder, oldest first.
std::vector<std::string> list_records(const std::string& output_folder);

// Folders of runs under way, or whose process was killed.
std::vector<std::string> list_unfinished(const std::string& output_folder);

}  // namespace gsbench::cli
