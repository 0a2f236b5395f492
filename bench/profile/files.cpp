#include <QCryptographicHash>
#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include <installation/installation.hpp>
#include <profile/files.hpp>
#include <profile/load.hpp>

namespace gsbench::profile {
namespace {

namespace fs = std::filesystem;

constexpr const char* kExtension = ".toml";
constexpr const char* kGridsFolder = "grids";
constexpr const char* kStationsFolder = "stations";

// Enough for a frequency point each second of the longest run, with a margin of one half.
constexpr std::uintmax_t kLargestFile = 4U << 20U;

std::string chosen_folder() {
  const char* chosen = std::getenv("GSBENCH_PROFILES");
  return chosen != nullptr ? chosen : "";
}

// profiles_folder(), and the user's own folder unless $GSBENCH_PROFILES is set.
std::vector<fs::path> folders() {
  std::vector<fs::path> all = {profiles_folder()};
  std::error_code error;
  const fs::path own = installation::user_data("profiles");
  if (all[0] != chosen_folder() && fs::is_directory(own, error)) {
    all.push_back(own);
  }
  return all;
}

bool is_toml_path(const std::string& name) {
  return fs::path(name).extension() == kExtension;
}

// Adds every .toml file below `folder`; the name is its relative path without the extension.
void add_files_below(const fs::path& folder, std::vector<NamedFile>& found) {
  std::error_code ignored;  // a missing folder is treated as empty
  for (fs::recursive_directory_iterator
           at(folder, fs::directory_options::skip_permission_denied, ignored),
       end;
       at != end; at.increment(ignored)) {
    if (at->path().extension() != kExtension || !at->is_regular_file(ignored)) {
      continue;
    }
    fs::path name = at->path().lexically_relative(folder);
    found.push_back({name.replace_extension().generic_string(), at->path().string()});
  }
}

// Removes the files of grids and stations; `files` are below a folder of profiles.
void keep_profiles(std::vector<NamedFile>& files) {
  const auto is_grid_or_station = [](const NamedFile& file) {
    const fs::path folder = *fs::path(file.name).begin();
    return folder == kGridsFolder || folder == kStationsFolder;
  };
  files.erase(std::remove_if(files.begin(), files.end(), is_grid_or_station), files.end());
}

// Every .toml file below `part` of folders(), sorted by name.
std::vector<NamedFile> all_files(const fs::path& part) {
  std::error_code error;
  if (!fs::is_directory(profiles_folder(), error)) {
    throw ConfigurationError(
        fmt::format("{}: the folder of profiles does not exist; set GSBENCH_PROFILES to one that "
                    "does",
                    profiles_folder()));
  }
  std::vector<NamedFile> found;
  for (const fs::path& folder : folders()) {
    add_files_below(folder / part, found);
  }
  std::sort(found.begin(), found.end(),
            [](const NamedFile& a, const NamedFile& b) { return a.name < b.name; });
  return found;
}

// The file with this name in a sorted list; none if there is none. Throws ConfigurationError if a
// shipped file and the user's own have the same name.
std::optional<NamedFile> only_named(const std::string& name, const std::vector<NamedFile>& files) {
  const auto is_named = [&](const NamedFile& file) { return file.name == name; };
  const auto found = std::find_if(files.begin(), files.end(), is_named);
  if (found == files.end()) {
    return std::nullopt;
  }
  if (const auto twin = std::find_if(found + 1, files.end(), is_named); twin != files.end()) {
    throw ConfigurationError(fmt::format("{} and {} have the same name; rename one, or give a path",
                                         found->path, twin->path));
  }
  return *found;
}

// "paper" for "paper/loss-500mw", each once. `names` are sorted.
std::vector<std::string> folders_of(const std::vector<std::string>& names) {
  std::vector<std::string> folders;
  for (const std::string& name : names) {
    const std::string folder = fs::path(name).parent_path().generic_string();
    if (!folder.empty() && (folders.empty() || folders.back() != folder)) {
      folders.push_back(folder);
    }
  }
  return folders;
}

// Message for a name that is not in `known`.
std::string not_found(const std::string& kind, const std::string& name,
                      const std::vector<NamedFile>& known, const std::string& known_kind) {
  return fmt::format("unknown {} \"{}\"{} (for your own file, give its path, ending in .toml)",
                     kind, name, keys::suggestion(name, names_of(known), known_kind));
}

NamedFile find_file(const std::string& name_or_path, const std::string& kind,
                    std::vector<NamedFile> (*all)()) {
  if (is_toml_path(name_or_path)) {
    if (!is_regular_file(name_or_path)) {
      throw ConfigurationError(fmt::format("{}: the {} file does not exist", name_or_path, kind));
    }
    return {fs::path(name_or_path).stem().string(), name_or_path};
  }
  const std::vector<NamedFile> known = all();
  if (const auto found = only_named(name_or_path, known)) {
    return *found;
  }
  throw ConfigurationError(not_found(kind, name_or_path, known, kind + 's'));
}

}  // namespace

std::string profiles_folder() {
  const std::string chosen = chosen_folder();
  return chosen.empty() ? installation::shipped("profiles").string() : chosen;
}

std::string find_profile(const std::string& name_or_path) {
  return find_file(name_or_path, "profile", all_profiles).path;
}

FoundProfiles find_profile_or_folder(const std::string& name_or_path) {
  if (is_toml_path(name_or_path)) {
    return {{name_or_path}};
  }
  const std::vector<std::string> names = names_of(all_profiles());
  if (std::find(names.begin(), names.end(), name_or_path) != names.end()) {
    return {{name_or_path}};
  }
  const std::string folder = (fs::path(name_or_path) / "").generic_string();  // ends in a slash
  std::vector<std::string> found;
  std::copy_if(names.begin(), names.end(), std::back_inserter(found), [&](const std::string& name) {
    return !folder.empty() && name.rfind(folder, 0) == 0;
  });
  std::error_code ignored;  // what cannot be accessed is no folder
  if (found.empty() && fs::is_directory(name_or_path, ignored)) {
    std::vector<NamedFile> files;
    add_files_below(name_or_path, files);
    keep_profiles(files);
    std::transform(files.begin(), files.end(), std::back_inserter(found),
                   [](const NamedFile& file) { return file.path; });
    std::sort(found.begin(), found.end());
    if (found.empty()) {
      throw ConfigurationError(fmt::format("{}: no profile is in this folder", name_or_path));
    }
  }
  if (found.empty()) {
    std::vector<std::string> candidates = folders_of(names);
    candidates.insert(candidates.end(), names.begin(), names.end());
    throw ConfigurationError(fmt::format(
        "unknown profile or folder of profiles \"{}\"{} (for your own, give its path)",
        name_or_path, keys::suggestion(name_or_path, candidates, "folders and profiles")));
  }
  return {found, true};
}

NamedFile find_station(const std::string& name_or_path) {
  return find_file(name_or_path, "station", all_stations);
}

std::optional<NamedFile> find_grid(const std::string& name_or_path, const std::string& folder) {
  if (is_toml_path(name_or_path)) {
    const fs::path path = fs::path(folder) / name_or_path;
    if (!is_regular_file(path.string())) {
      return std::nullopt;
    }
    return NamedFile{path.stem().string(), path.string()};
  }
  return only_named(name_or_path, all_grids());
}

NamedFile copied_grid(const std::string& name_or_path, const std::string& folder) {
  return is_toml_path(name_or_path) ? NamedFile{fs::path(name_or_path).stem().string(),
                                                (fs::path(folder) / name_or_path).string()}
                                    : NamedFile{name_or_path, name_or_path};
}

std::string unknown_grid(const std::string& name_or_path) {
  return not_found("grid", name_or_path, all_grids(), "grids");
}

std::string profile_name(const std::string& path) {
  std::error_code ignored;  // a path that cannot be resolved is not below a folder
  const fs::path file = fs::weakly_canonical(path, ignored);
  for (const fs::path& folder : folders()) {
    fs::path name = file.lexically_relative(fs::weakly_canonical(folder, ignored));
    if (!name.empty() && *name.begin() != "..") {
      return name.replace_extension().generic_string();
    }
  }
  return file.stem().string();
}

std::string resolve(const std::string& path, const std::string& beside) {
  return (fs::path(beside).parent_path() / path).string();
}

bool is_regular_file(const std::string& path) {
  std::error_code ignored;  // a file that cannot be accessed cannot be read either
  return fs::is_regular_file(path, ignored);
}

std::string read_file(const std::string& path) {
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!is_regular_file(path) || !file) {
    throw ConfigurationError(fmt::format("{}: cannot be read: {}", path,
                                         errno != 0 ? std::strerror(errno) : "not a regular file"));
  }
  std::error_code ignored;
  const std::uintmax_t bytes = fs::file_size(path, ignored);
  if (bytes > kLargestFile) {
    throw ConfigurationError(fmt::format("{}: the file has {} bytes; it must have at most {}", path,
                                         bytes, kLargestFile));
  }
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

std::string sha256(const std::string& text) {
  return QCryptographicHash::hash(QByteArray::fromStdString(text), QCryptographicHash::Sha256)
      .toHex()
      .toStdString();
}

std::vector<NamedFile> all_profiles() {
  auto files = all_files("");
  keep_profiles(files);
  return files;
}

std::vector<NamedFile> all_grids() {
  return all_files(kGridsFolder);
}

std::vector<NamedFile> all_stations() {
  return all_files(kStationsFolder);
}

std::vector<std::string> names_of(const std::vector<NamedFile>& files) {
  std::vector<std::string> names;
  names.reserve(files.size());
  for (const NamedFile& file : files) {
    names.push_back(file.name);
  }
  return names;
}

}  // namespace gsbench::profile
