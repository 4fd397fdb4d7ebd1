// Several files that appear together or not at all.

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <system_error>

#include "signorini/output.hpp"

namespace signorini {

namespace {

namespace fs = std::filesystem;

std::string cannotWrite(int error)
{
    return fmt::format("cannot write: {}", std::generic_category().message(error));
}

/// What a file is; one that does not exist is no error. \throws FileError.
fs::file_status statusOf(const fs::path& path, const std::string& name, bool followsLinks)
{
    std::error_code error;
    const fs::file_status status =
        followsLinks ? fs::status(path, error) : fs::symlink_status(path, error);
    if (!fs::status_known(status)) {
        throw FileError(name, fmt::format("cannot write: {}", error.message()));
    }
    return status;
}

/// A sticky folder (/tmp) lets nobody replace the files of others.
bool mayReplace(const fs::path& target)
{
    struct stat file = {};
    struct stat folder = {};
    const uid_t user = geteuid();
    return user == 0 || stat(target.c_str(), &file) != 0 ||
           stat(target.parent_path().c_str(), &folder) != 0 || (folder.st_mode & S_ISVTX) == 0 ||
           file.st_uid == user || folder.st_uid == user;
}

/// Writes a staged file into an open target that cannot be replaced by renaming.
void copyContent(const std::string& from, TextFile& target)
{
    std::ifstream source(from, std::ios::binary);
    std::vector<char> block(std::size_t{1} << 20);
    while (source) {
        source.read(block.data(), static_cast<std::streamsize>(block.size()));
        target.write({block.data(), static_cast<std::size_t>(source.gcount())});
    }
    if (source.bad() || !source.eof()) {
        throw FileError(from, "cannot read what was to be written");
    }
    target.close();
}

[[noreturn]] void cannotReplace(const std::string& name, int error)
{
    throw FileError(name,
                    fmt::format("cannot replace: {}", std::generic_category().message(error)));
}

/// Keeps the file `target` under the name `kept`, too, or moves it there where the file system has
/// no links. \return whether there is such a file. \throws FileError.
bool keep(const std::string& target, const std::string& kept, const std::string& name,
          bool isFolder)
{
    const fs::file_status status = statusOf(target, name, false);
    if (!fs::exists(status)) {
        return false;
    }
    if (!isFolder && !fs::is_regular_file(status)) {
        cannotReplace(name, fs::is_directory(status) ? EISDIR : EEXIST);
    }
    if ((isFolder || link(target.c_str(), kept.c_str()) != 0) &&
        rename(target.c_str(), kept.c_str()) != 0) {
        cannotReplace(name, errno);
    }
    return true;
}

/// Runs `action` and calls the file `name` in what it throws.
template <typename Action>
void naming(const std::string& name, Action action)
{
    try {
        action();
    } catch (const FileError& error) {
        throw FileError(name, error.reason());
    }
}

}  // namespace

fs::path outputPlace(const std::string& path)
{
    constexpr int mostLinks = 40;
    std::error_code error;
    fs::path target = fs::absolute(path, error);
    for (int k = 0; k < mostLinks && !error; ++k) {
        const fs::path folder = fs::canonical(target.parent_path(), error);
        if (error) {
            break;
        }
        target = folder / target.filename();
        if (!fs::is_symlink(statusOf(target, path, false))) {
            return target;
        }
        const fs::file_status status = fs::status(target, error);
        if (fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status)) {
            return target;  // /dev/fd/63 leads to a pipe, which has no name
        }
        target = folder / fs::read_symlink(target, error);
    }
    throw FileError(path,
                    error ? fmt::format("cannot write: {}", error.message()) : cannotWrite(ELOOP));
}

bool isSameOutput(const std::string& path, const std::string& other)
{
    const fs::path one = outputPlace(path);
    const fs::path two = outputPlace(other);
    std::error_code ignored;
    return one == two || fs::equivalent(one, two, ignored) ||
           (one.filename() == two.filename() &&
            fs::equivalent(one.parent_path(), two.parent_path(), ignored));
}

OutputFiles::~OutputFiles()
{
    for (const Entry& entry : entries_) {
        std::error_code ignored;
        fs::remove_all(entry.staged, ignored);
    }
}

std::string OutputFiles::stageFolder(const std::string& path, const std::string& ending,
                                     const std::string& name)
{
    const fs::path target = outputPlace(path);
    std::error_code error;
    if (fs::exists(statusOf(target, path, true))) {
        for (fs::directory_iterator entry(target, error), end; !error && entry != end;
             entry.increment(error)) {
            if (!entry->is_regular_file(error) || entry->path().extension() != ending) {
                throw FileError(path, fmt::format("holds more than {} files: allowed a new folder, "
                                                  "or one of the same kind to replace",
                                                  ending));
            }
        }
        if (error) {
            throw FileError(path, fmt::format("cannot replace: {}", error.message()));
        }
    }
    std::string staged = (target.parent_path() / ".signorini-XXXXXX").string();
    if (mkdtemp(staged.data()) == nullptr) {
        throw FileError(path, cannotWrite(errno));
    }
    const mode_t mask = umask(0);
    umask(mask);
    (void)chmod(staged.c_str(), 0777U & ~mask);
    entries_.push_back({.staged = staged,
                        .target = target.string(),
                        .name = name.empty() ? path : name,
                        .isRegular = true,
                        .isFolder = true});
    return staged;
}

std::string OutputFiles::stage(const std::string& path, const std::string& name)
{
    const fs::path target = outputPlace(path);
    const fs::file_status status = statusOf(target, path, true);
    if (fs::is_directory(status)) {
        throw FileError(path, "is a directory");
    }
    const bool isRegular = !fs::exists(status) || fs::is_regular_file(status);
    if (fs::exists(status) && access(target.c_str(), W_OK) != 0) {
        throw FileError(path, cannotWrite(errno));
    }
    if (isRegular && !mayReplace(target)) {
        throw FileError(path, cannotWrite(EPERM));
    }
    const fs::path folder = isRegular ? target.parent_path() : temporaryDirectory();
    std::string staged = (folder / ".signorini-XXXXXX").string();
    const int descriptor = mkstemp(staged.data());
    if (descriptor < 0) {
        throw FileError(path, cannotWrite(errno));
    }
    // mkstemp keeps its file to the user; a result gets the mode of the file it replaces, or the
    // usual one.
    const mode_t mask = umask(0);
    umask(mask);
    const mode_t mode = fs::is_regular_file(status)
                            ? static_cast<mode_t>(status.permissions()) & 07777U
                            : 0666U & ~mask;
    (void)fchmod(descriptor, mode);
    ::close(descriptor);
    entries_.push_back({.staged = staged,
                        .target = target.string(),
                        .name = name.empty() ? path : name,
                        .isRegular = isRegular});
    return staged;
}

void OutputFiles::commit()
{
    // What cannot be taken back comes last: content that has gone into a pipe. Who reads it is
    // waited for first of all.
    std::stable_partition(entries_.begin(), entries_.end(),
                          [](const Entry& entry) { return entry.isRegular; });
    std::vector<std::unique_ptr<TextFile>> pipes;
    for (const Entry& entry : entries_) {
        if (!entry.isRegular) {
            naming(entry.name, [&] { pipes.push_back(std::make_unique<TextFile>(entry.target)); });
        }
    }
    const std::size_t regular = entries_.size() - pipes.size();
    try {
        for (std::size_t k = 0; k < regular; ++k) {
            // The last step of all needs no way back.
            replace(entries_[k], k + 1 < entries_.size());
        }
        for (std::size_t k = 0; k < pipes.size(); ++k) {
            const Entry& entry = entries_[regular + k];
            naming(entry.name, [&] { copyContent(entry.staged, *pipes[k]); });
        }
    } catch (...) {
        for (std::size_t k = regular; k > 0; --k) {
            restore(entries_[k - 1]);
        }
        throw;
    }
    for (const Entry& entry : entries_) {
        std::error_code ignored;
        fs::remove_all(keptName(entry.staged), ignored);
        if (!entry.isRegular) {
            fs::remove(entry.staged, ignored);
        }
    }
    entries_.clear();
}

void OutputFiles::replace(Entry& entry, bool keepsOld)
{
    entry.isKept = (keepsOld || entry.isFolder) &&
                   keep(entry.target, keptName(entry.staged), entry.name, entry.isFolder);
    if (rename(entry.staged.c_str(), entry.target.c_str()) != 0) {
        cannotReplace(entry.name, errno);
    }
    entry.isPlaced = true;
}

void OutputFiles::restore(const Entry& entry)
{
    std::error_code ignored;
    if (entry.isFolder && entry.isPlaced) {
        fs::remove_all(entry.target, ignored);
    }
    if (entry.isKept) {
        const std::string kept = keptName(entry.staged);
        // Between two names of one file renaming does nothing, so one of them may be left.
        if (rename(kept.c_str(), entry.target.c_str()) == 0) {
            fs::remove(kept, ignored);
        }
    } else if (entry.isPlaced) {
        fs::remove(entry.target, ignored);
    }
}

}  // namespace signorini
