#include "run_folder.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <filesystem>

#include <profile/load.hpp>
#include <record/store.hpp>
#include <render/file.hpp>
#include <render/render.hpp>

namespace gsbench::cli {

namespace fs = std::filesystem;

namespace {

constexpr const char* kUnfinished = ".unfinished-";

// Folders in an output folder that hold a record, in order of their names.
std::vector<fs::path> folders_with_records(const std::string& output_folder) {
  std::vector<fs::path> folders;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(output_folder, error)) {
    if (fs::exists(entry.path() / kRecordFile, error)) {
      folders.push_back(entry.path());
    }
  }
  std::sort(folders.begin(), folders.end());
  return folders;
}

bool is_unfinished(const fs::path& folder) {
  return folder.filename().string().rfind(kUnfinished, 0) == 0;
}

}  // namespace

RunFolder::RunFolder(const std::string& output_folder) : output_folder_(output_folder) {
  std::error_code error;
  made_output_folder_ = fs::create_directories(output_folder, error);
  if (!error) {
    path_ = output_folder + "/" + kUnfinished + "XXXXXX";
    if (mkdtemp(path_.data()) == nullptr) {
      error = std::error_code(errno, std::generic_category());
      path_.clear();
    }
  }
  if (error) {
    throw record::StoreError((output_folder.empty() ? "--out" : output_folder) +
                             ": cannot keep runs here: " + error.message() +
                             "; name another folder with --out");
  }
}

RunFolder::~RunFolder() {
  if (kept_) {
    return;
  }
  std::error_code ignored;
  fs::remove_all(path_, ignored);
  if (made_output_folder_) {
    fs::remove(output_folder_, ignored);
  }
}

void RunFolder::keep(const std::string& run_id) {
  const std::string named = output_folder_ + "/" + run_id;
  std::error_code error;
  fs::rename(path_, named, error);
  if (error) {
    throw record::StoreError(named + ": " + error.message());
  }
  path_ = named;
  kept_ = true;
}

void write_reports(const record::RunRecord& run, const std::string& folder) {
  render::write_file(folder + "/report.html", render::html(run));
  render::write_file(folder + "/result.json", render::json(run));
  render::write_file(folder + "/junit.xml", render::junit_xml(run));
  render::write_file(folder + "/traces.csv", render::csv(run));
}

std::vector<std::string> list_records(const std::string& output_folder) {
  std::vector<std::string> records;
  for (const fs::path& folder : folders_with_records(output_folder)) {
    if (!is_unfinished(folder)) {
      records.push_back((folder / kRecordFile).string());
    }
  }
  return records;
}

std::vector<std::string> list_unfinished(const std::string& output_folder) {
  std::vector<std::string> unfinished;
  for (const fs::path& folder : folders_with_records(output_folder)) {
    if (is_unfinished(folder)) {
      unfinished.push_back(folder.string());
    }
  }
  return unfinished;
}

std::string find_record(const std::string& run, const std::string& output_folder) {
  std::error_code error;
  if (fs::is_directory(run, error) && fs::exists(fs::path(run) / kRecordFile, error)) {
    return (fs::path(run) / kRecordFile).string();
  }
  if (fs::is_regular_file(run, error)) {
    return run;
  }
  std::vector<std::string> found;
  for (const std::string& record : list_records(output_folder)) {
    if (fs::path(record).parent_path().filename().string().rfind(run, 0) == 0) {
      found.push_back(record);
    }
  }
  if (found.size() == 1) {
    return found.front();
  }
  throw profile::ConfigurationError(
      found.empty()
          ? run + ": no such run; `gsbench runs` lists those in " + output_folder
          : run + ": " + std::to_string(found.size()) + " runs begin so; give more of the id");
}

}  // namespace gsbench::cli
