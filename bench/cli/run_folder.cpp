#include "run_folder.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <random>

#include <fmt/format.h>

#include <installation/installation.hpp>
#include <profile/load.hpp>
#include <record/store.hpp>
#include <render/file.hpp>
#include <render/render.hpp>

namespace gsbench::cli {

namespace fs = std::filesystem;

namespace {

constexpr const char* kUnfinished = ".unfinished-";

[[noreturn]] void refuse(const std::string& path, const std::error_code& error) {
  throw record::StoreError(path + ": " + error.message());
}

// A folder without permission counts as one with a record: reading it then reports the error.
bool holds_record(const fs::path& folder) {
  std::error_code error;
  return fs::is_regular_file(folder / kRecordFile, error) || error == std::errc::permission_denied;
}

// Folders with a record in an output folder, in the order of their names.
std::vector<fs::path> folders_with_records(const std::string& output_folder) {
  std::vector<fs::path> folders;
  std::error_code error;
  fs::directory_iterator entry(output_folder, error);
  if (error && error != std::errc::no_such_file_or_directory) {
    refuse(output_folder, error);
  }
  for (; !error && entry != fs::directory_iterator(); entry.increment(error)) {
    if (holds_record(entry->path())) {
      folders.push_back(entry->path());
    }
  }
  std::sort(folders.begin(), folders.end());
  return folders;
}

// Creates a folder and its parents. Returns those that did not exist, the innermost first.
std::vector<fs::path> make_folders(const std::string& folder, std::error_code& error) {
  std::vector<fs::path> made;
  fs::path path;
  for (const fs::path& part : fs::absolute(folder, error)) {
    path /= part;
    if (!error && !part.empty() && fs::create_directory(path, error)) {
      made.insert(made.begin(), path);
    }
  }
  return made;
}

// With a new name and the permissions of the user's umask.
std::string make_unfinished(const std::string& output_folder, std::error_code& error) {
  std::random_device random;
  std::string path;
  do {
    path = fmt::format("{}/{}{:08x}", output_folder, kUnfinished, random());
  } while (!fs::create_directory(path, error) && !error);
  return path;
}

// Of a run that did not finish; empty if it is not known.
std::string run_id_of(const fs::path& record) {
  try {
    return record::read_head(record.string()).run_id;
  } catch (const record::StoreError&) {
    return "";
  }
}

bool begins_with(const fs::path& folder, const std::string& beginning) {
  return folder.filename().string().rfind(beginning, 0) == 0;
}

}  // namespace

std::string default_runs_folder() {
  const char* chosen = std::getenv("GSBENCH_RUNS");
  if (chosen != nullptr && *chosen != '\0') {
    return chosen;
  }
  const fs::path own = installation::user_data("runs");
  return own.empty() ? "runs" : own.string();
}

RunFolder::RunFolder(const std::string& output_folder) : output_folder_(output_folder) {
  std::error_code error;
  made_ = make_folders(output_folder, error);
  if (!error) {
    path_ = make_unfinished(output_folder, error);
  }
  if (error) {
    remove_made();
    throw record::StoreError(output_folder + ": runs cannot be stored here: " + error.message() +
                             "; name another folder with --out");
  }
}

RunFolder::~RunFolder() {
  if (!kept_) {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
    remove_made();
  }
}

void RunFolder::remove_made() noexcept {
  std::error_code ignored;  // another process may use them by now
  for (const fs::path& folder : made_) {
    fs::remove(folder, ignored);
  }
}

void RunFolder::keep(const std::string& run_id) {
  const std::string named = output_folder_ + "/" + run_id;
  std::error_code error;
  fs::rename(path_, named, error);
  if (error) {
    throw record::StoreError(path_ + ": cannot be renamed to " + run_id + ": " + error.message());
  }
  path_ = named;
  kept_ = true;
}

void write_reports(const render::View& run, const std::string& folder, bool on_request) {
  try {
    for (const render::Format& format : render::kFormats) {
      if (format.is_kept() || (on_request && format.on_request)) {
        render::File file(folder + "/" + format.file);
        format.write(run, [&](std::string_view part) { file.append(part); });
        file.commit();
      }
    }
  } catch (const render::WriteError& error) {
    throw render::WriteError(std::string(error.what()) +
                             "; the run is kept without this report; `gsbench report " + folder +
                             "` prints it");
  }
}

std::vector<std::string> list_records(const std::string& output_folder) {
  std::vector<std::string> records;
  for (const fs::path& folder : folders_with_records(output_folder)) {
    if (!begins_with(folder, ".")) {
      records.push_back((folder / kRecordFile).string());
    }
  }
  return records;
}

std::vector<std::string> list_unfinished(const std::string& output_folder) {
  std::vector<std::string> unfinished;
  for (const fs::path& folder : folders_with_records(output_folder)) {
    if (begins_with(folder, kUnfinished)) {
      unfinished.push_back(folder.string());
    }
  }
  return unfinished;
}

void refuse_empty_record(const std::string& record) {
  std::error_code unknown;  // reading it reports it
  const bool is_new = begins_with(fs::absolute(record).parent_path(), kUnfinished);
  if (!is_new && fs::file_size(record, unknown) == 0 && !unknown) {
    throw record::StoreError(record + ": is empty; no record begins so, or its contents are lost");
  }
}

namespace {

std::string path_of_record(const std::string& run, const std::string& output_folder) {
  std::error_code error;
  if (fs::is_directory(run, error)) {
    if (holds_record(run)) {
      return (fs::path(run) / kRecordFile).string();
    }
    throw profile::ConfigurationError(run + ": this folder holds no " + kRecordFile);
  }
  if (fs::is_regular_file(run, error)) {
    return run;
  }
  if (error == std::errc::permission_denied) {
    refuse(run, error);
  }
  std::vector<std::string> found;
  for (const std::string& record : list_records(output_folder)) {
    if (begins_with(fs::path(record).parent_path(), run)) {
      found.push_back(record);
    }
  }
  for (const std::string& folder : list_unfinished(output_folder)) {
    const fs::path record = fs::path(folder) / kRecordFile;
    if (begins_with(folder, run) || run_id_of(record).rfind(run, 0) == 0) {
      found.push_back(record.string());
    }
  }
  if (found.size() == 1) {
    return found.front();
  }
  throw profile::ConfigurationError(
      found.empty()
          ? fmt::format("{}: no such run; `gsbench runs` lists those in {}", run, output_folder)
          : fmt::format("{}: {} runs start with this; give more of the id", run, found.size()));
}

}  // namespace

std::string find_record(const std::string& run, const std::string& output_folder) {
  std::string record = path_of_record(run, output_folder);
  refuse_empty_record(record);
  return record;
}

}  // namespace gsbench::cli
