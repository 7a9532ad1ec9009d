// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>

namespace ew::test {

/// While it lives, SQLite writes through it: from the write (or sync, or cut) with a number on,
/// they fail, as on a full or dying disk, or are lost, as in a power cut.
class FaultyDisk {
  public:
    enum class Fault {
        Fail,     ///< that one write fails
        FailAll,  ///< that one and all later ones fail
        Tear,     ///< of that write half arrives, and it and all later ones fail
    };
    FaultyDisk();
    ~FaultyDisk();
    FaultyDisk(const FaultyDisk&) = delete;
    FaultyDisk& operator=(const FaultyDisk&) = delete;

    /// \param inWrites  0: the next one.
    void breakAfter(int inWrites, Fault fault);
    void mend();
    /// Has it failed since breakAfter()?
    bool broke() const;
};

}  // namespace ew::test
