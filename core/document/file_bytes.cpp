// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/file_bytes.h"

#include <fcntl.h>
#include <linux/magic.h>
#include <sys/stat.h>
#include <sys/vfs.h>
#include <sys/xattr.h>
#include <unistd.h>

#include <QFile>
#include <QFileInfo>
#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <optional>
#include <random>
#include <utility>
#include <vector>

namespace ew {

namespace {

namespace fs = std::filesystem;

constexpr int kMostLinks = 40;  // what the system itself follows

/// Why a system call failed, in the middle of a sentence.
std::string reasonText(int reason) {
    switch (reason) {
        case ENOSPC:
        case EDQUOT:
            return "there is no room left on the disk";
        case ENOENT:
        case ENOTDIR:
            return "its folder does not exist";
        case EISDIR:
            return "it is a folder";
        case EACCES:
        case EPERM:
        case EROFS:
            return "it may not be changed";
        case ENAMETOOLONG:
            return "its name is too long";
        default:
            return std::strerror(reason);
    }
}

/// An open file; closed at the end of its life.
class OpenFile {
  public:
    explicit OpenFile(int descriptor) : descriptor_(descriptor) {}
    OpenFile(const OpenFile&) = delete;
    OpenFile& operator=(const OpenFile&) = delete;
    ~OpenFile() {
        if (descriptor_ >= 0) ::close(descriptor_);
    }
    bool isOpen() const { return descriptor_ >= 0; }
    int descriptor() const { return descriptor_; }

    // Each returns 0 or the system's error number.
    int write(std::string_view bytes) const {
        while (!bytes.empty()) {
            const ssize_t n = ::write(descriptor_, bytes.data(), bytes.size());
            if (n < 0 && errno == EINTR) continue;
            if (n < 0) return errno;
            bytes.remove_prefix(static_cast<std::size_t>(n));
        }
        return 0;
    }
    int sync() const {
        if (::fsync(descriptor_) == 0) return 0;
        // Pipes and some file systems know no such thing.
        return errno == EINVAL || errno == ENOTSUP || errno == EROFS ? 0 : errno;
    }
    /// Some file systems tell of a failed writing only here.
    int close() { return ::close(std::exchange(descriptor_, -1)) == 0 ? 0 : errno; }

  private:
    int descriptor_;
};

bool isSystemsLink(const fs::path& path) {
    struct statfs where {};
    return ::statfs(path.parent_path().c_str(), &where) == 0 && where.f_type == PROC_SUPER_MAGIC;
}

/// Follows symbolic links to their end, where nothing need stand yet. The system's own link to
/// what an open descriptor leads to is such an end: its text is no path where that is a pipe.
/// \return 0 or an error number.
int followLinks(fs::path& path) {
    std::error_code ec;
    for (int i = 0; i < kMostLinks; ++i) {
        if (!fs::is_symlink(path, ec) || isSystemsLink(path)) return 0;
        const fs::path next = fs::read_symlink(path, ec);
        if (ec) return ec.value();
        path = next.is_absolute() ? next : path.parent_path() / next;
    }
    return ELOOP;
}

/// Permissions, owner, group and attributes of a file that is to be replaced.
/// \return false where the owner cannot be kept.
bool takeAfter(const struct stat& old, const fs::path& oldPath, int descriptor) {
    struct stat now {};
    if (::fstat(descriptor, &now) != 0) return false;
    const bool owned = now.st_uid == old.st_uid && now.st_gid == old.st_gid;
    if (!owned && ::fchown(descriptor, old.st_uid, old.st_gid) != 0) return false;
    const ssize_t size = ::listxattr(oldPath.c_str(), nullptr, 0);
    std::vector<char> names(size > 0 ? static_cast<std::size_t>(size) : 0U);
    if (size > 0)
        names.resize(
            std::max<ssize_t>(0, ::listxattr(oldPath.c_str(), names.data(), names.size())));
    for (std::size_t at = 0; at < names.size(); at += std::strlen(names.data() + at) + 1) {
        const char* name = names.data() + at;
        const ssize_t length = ::getxattr(oldPath.c_str(), name, nullptr, 0);
        if (length < 0) continue;
        std::vector<char> value(static_cast<std::size_t>(length));
        if (::getxattr(oldPath.c_str(), name, value.data(), value.size()) != length) continue;
        // What the system keeps for itself cannot be set, and need not be.
        static_cast<void>(::fsetxattr(descriptor, name, value.data(), value.size(), 0));
    }
    return ::fchmod(descriptor, old.st_mode & 07777U) == 0;
}

/// Over the bytes that are there. Room is made sure of first, so that a full disk leaves the file
/// as it was.
int writeInPlace(const fs::path& path, off_t oldSize, std::string_view bytes) {
    OpenFile file(::open(path.c_str(), O_WRONLY | O_CLOEXEC));
    if (!file.isOpen()) return errno;
    const auto size = static_cast<off_t>(bytes.size());
    if (size > 0) {
        const int room = ::posix_fallocate(file.descriptor(), 0, size);
        if (room != 0 && room != EINVAL && room != EOPNOTSUPP) {
            // Some of the room may have been had.
            return ::ftruncate(file.descriptor(), oldSize) == 0 ? room : errno;
        }
    }
    if (const int e = file.write(bytes); e != 0) return e;
    if (::ftruncate(file.descriptor(), size) != 0) return errno;
    if (const int e = file.sync(); e != 0) return e;
    return file.close();
}

/// The number of a descriptor of this program, where the path names one, as /dev/stdout does.
std::optional<int> ownDescriptor(const fs::path& path) {
    const std::string folder = path.parent_path().string();
    if (folder != "/proc/self/fd" && folder != "/dev/fd") return std::nullopt;
    const std::string name = path.filename().string();
    int number = -1;
    const char* end = name.data() + name.size();
    const auto [last, error] = std::from_chars(name.data(), end, number);
    if (error != std::errc() || last != end || number < 0) return std::nullopt;
    return number;
}

/// Behind what was written to it before; a file that it leads to is not begun anew.
int writeToDescriptor(int number, std::string_view bytes) {
    const OpenFile file(::dup(number));
    if (!file.isOpen()) return errno;
    return file.write(bytes);
}

/// Into a pipe or a device.
int writeThrough(const fs::path& path, std::string_view bytes) {
    OpenFile file(::open(path.c_str(), O_WRONLY | O_CLOEXEC | O_NOCTTY));
    if (!file.isOpen()) return errno;
    if (const int e = file.write(bytes); e != 0) return e;
    return file.close();
}

/// A new file beside the target, with a short name of its own, so that a name at the system's limit
/// can still be written.
/// \return its descriptor, -1 with errno set.
int openBeside(const fs::path& folder, mode_t mode, fs::path& beside) {
    std::random_device random;
    int descriptor = -1;
    do {
        char name[24] = ".ew";
        *std::to_chars(name + 3, name + sizeof(name) - 1, random(), 36).ptr = '\0';
        beside = folder / name;
        descriptor = ::open(beside.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode);
    } while (descriptor < 0 && errno == EEXIST);
    return descriptor;
}

int writeWhole(fs::path path, std::string_view bytes) {
    if (const int e = followLinks(path); e != 0) return e;
    if (const auto own = ownDescriptor(path)) return writeToDescriptor(*own, bytes);
    struct stat old {};
    const bool exists = ::stat(path.c_str(), &old) == 0;
    if (!exists && errno != ENOENT) return errno;
    if (exists && S_ISDIR(old.st_mode)) return EISDIR;
    if (exists && !S_ISREG(old.st_mode)) return writeThrough(path, bytes);
    if (exists && ::access(path.c_str(), W_OK) != 0) return errno;
    if (exists && old.st_nlink > 1) return writeInPlace(path, old.st_size, bytes);

    const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
    fs::path beside;
    // The system takes its mask away from what a new file may be.
    constexpr mode_t kPrivate = 0600;
    constexpr mode_t kNew = 0666;
    OpenFile file(openBeside(folder, exists ? kPrivate : kNew, beside));
    if (!file.isOpen()) return errno;
    const auto giveUp = [&](int reason) {
        ::unlink(beside.c_str());
        return reason;
    };
    if (exists && !takeAfter(old, path, file.descriptor())) {
        giveUp(0);
        return writeInPlace(path, old.st_size, bytes);
    }
    if (const int e = file.write(bytes); e != 0) return giveUp(e);
    if (const int e = file.sync(); e != 0) return giveUp(e);
    if (const int e = file.close(); e != 0) return giveUp(e);
    if (::rename(beside.c_str(), path.c_str()) != 0) return giveUp(errno);
    // The new name, too, is to outlive a power cut; the file itself does already.
    const OpenFile named(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (named.isOpen()) static_cast<void>(named.sync());
    return 0;
}

}  // namespace

Result<std::string> readFileBytes(const QString& path, std::size_t maxBytes) {
    const std::string name = path.toStdString();
    const QFileInfo info(path);
    if (!info.exists()) return fail(Errc::FileNotFound, "There is no file at " + name + ".");
    if (info.isDir()) return fail(Errc::FileNotFound, name + " is a folder, not a file.");
    const auto tooLarge = [&] {
        return fail(Errc::TooLarge,
                    name + " is larger than " + std::to_string(maxBytes >> 20U) + " MiB.");
    };
    if (info.size() > static_cast<qint64>(maxBytes)) return tooLarge();
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly)) {
        return fail(Errc::FileNotFound,
                    name + " cannot be read: " + file.errorString().toStdString() + ".");
    }
    // One byte more than allowed: a pipe or device has no size to ask for.
    const QByteArray bytes = file.read(static_cast<qint64>(maxBytes) + 1);
    if (bytes.size() > static_cast<qsizetype>(maxBytes)) return tooLarge();
    return bytes.toStdString();
}

Result<void> writeFileBytes(const QString& path, std::string_view bytes) {
    const QByteArray name = QFile::encodeName(path);
    const int reason = name.isEmpty() ? ENOENT : writeWhole(name.toStdString(), bytes);
    if (reason == 0) return {};
    return fail(Errc::CannotWrite, "The file " + path.toStdString() +
                                       " could not be written: " + reasonText(reason) + ".");
}

std::optional<FileStamp> fileStamp(const QString& path) {
    struct stat now {};
    if (::stat(QFile::encodeName(path).constData(), &now) != 0) return std::nullopt;
    FileStamp stamp;
    stamp.file = {now.st_dev, now.st_ino};
    stamp.bytes = now.st_size;
    stamp.changed = {now.st_mtim.tv_sec, now.st_mtim.tv_nsec};
    return stamp;
}

}  // namespace ew
