// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/document/fault_vfs.h"

#include <sqlite3.h>

#include <cstdlib>
#include <cstring>
#include <new>

namespace ew::test {

namespace {

sqlite3_vfs* real = nullptr;
std::atomic<bool> armed = false;
std::atomic<int> left = 0;
std::atomic<bool> failed = false;
std::atomic<FaultyDisk::Fault> kind = FaultyDisk::Fault::Fail;

/// Does this write fail?
/// \param tear  set where half of it arrives.
bool failsNow(bool& tear) {
    tear = false;
    if (!armed) return false;
    const int n = left--;
    if (n > 0) return false;
    if (n < 0 && kind == FaultyDisk::Fault::Fail) return false;
    tear = n == 0 && kind == FaultyDisk::Fault::Tear;
    failed = true;
    return true;
}

struct File {
    sqlite3_file base;
    sqlite3_file* inner() { return reinterpret_cast<sqlite3_file*>(this + 1); }
};
File* own(sqlite3_file* f) { return reinterpret_cast<File*>(f); }
sqlite3_file* in(sqlite3_file* f) { return own(f)->inner(); }

int fileClose(sqlite3_file* f) { return in(f)->pMethods->xClose(in(f)); }
int fileRead(sqlite3_file* f, void* to, int n, sqlite3_int64 at) {
    return in(f)->pMethods->xRead(in(f), to, n, at);
}
int fileWrite(sqlite3_file* f, const void* from, int n, sqlite3_int64 at) {
    bool tear = false;
    if (failsNow(tear)) {
        if (tear) in(f)->pMethods->xWrite(in(f), from, n / 2, at);
        return SQLITE_FULL;
    }
    return in(f)->pMethods->xWrite(in(f), from, n, at);
}
int fileTruncate(sqlite3_file* f, sqlite3_int64 n) {
    bool tear = false;
    if (failsNow(tear)) return SQLITE_IOERR_TRUNCATE;
    return in(f)->pMethods->xTruncate(in(f), n);
}
int fileSync(sqlite3_file* f, int flags) {
    bool tear = false;
    if (failsNow(tear)) return SQLITE_IOERR_FSYNC;
    return in(f)->pMethods->xSync(in(f), flags);
}
int fileSize(sqlite3_file* f, sqlite3_int64* n) { return in(f)->pMethods->xFileSize(in(f), n); }
int fileLock(sqlite3_file* f, int l) { return in(f)->pMethods->xLock(in(f), l); }
int fileUnlock(sqlite3_file* f, int l) { return in(f)->pMethods->xUnlock(in(f), l); }
int fileReserved(sqlite3_file* f, int* r) { return in(f)->pMethods->xCheckReservedLock(in(f), r); }
int fileControl(sqlite3_file* f, int op, void* arg) {
    return in(f)->pMethods->xFileControl(in(f), op, arg);
}
int fileSector(sqlite3_file* f) { return in(f)->pMethods->xSectorSize(in(f)); }
int fileTraits(sqlite3_file* f) { return in(f)->pMethods->xDeviceCharacteristics(in(f)); }

// Version 1: without shared memory, which an exclusive lock does not need.
const sqlite3_io_methods kMethods{1,           fileClose,  fileRead,   fileWrite,  fileTruncate,
                                  fileSync,    fileSize,   fileLock,   fileUnlock, fileReserved,
                                  fileControl, fileSector, fileTraits, nullptr,    nullptr,
                                  nullptr,     nullptr,    nullptr,    nullptr};

int openFile(sqlite3_vfs*, sqlite3_filename name, sqlite3_file* f, int flags, int* outFlags) {
    const int code = real->xOpen(real, name, in(f), flags, outFlags);
    f->pMethods = code == SQLITE_OK ? &kMethods : nullptr;
    return code;
}

sqlite3_vfs faulty;

}  // namespace

FaultyDisk::FaultyDisk() {
    real = sqlite3_vfs_find(nullptr);
    faulty = *real;
    faulty.zName = "faulty";
    faulty.szOsFile = static_cast<int>(sizeof(File)) + real->szOsFile;
    faulty.xOpen = openFile;
    mend();
    sqlite3_vfs_register(&faulty, 1);
}

FaultyDisk::~FaultyDisk() {
    mend();
    sqlite3_vfs_unregister(&faulty);
    sqlite3_vfs_register(real, 1);
}

void FaultyDisk::breakAfter(int inWrites, Fault fault) {
    failed = false;
    left = inWrites;
    kind = fault;
    armed = true;
}

void FaultyDisk::mend() { armed = false; }
bool FaultyDisk::broke() const { return failed; }

}  // namespace ew::test
