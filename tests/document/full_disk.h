// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sys/mount.h>

#include <fstream>
#include <string>

namespace ew::test {

/// A disk of 256 KiB in memory, mounted on a folder as long as this lives, where that is allowed.
class SmallDisk {
  public:
    explicit SmallDisk(std::string folder)
        : folder_(std::move(folder)),
          mounted_(::mount("tmpfs", folder_.c_str(), "tmpfs", 0, "size=256k") == 0) {}
    ~SmallDisk() {
        if (mounted_) ::umount2(folder_.c_str(), MNT_DETACH);
    }
    SmallDisk(const SmallDisk&) = delete;
    SmallDisk& operator=(const SmallDisk&) = delete;

    bool mounted() const { return mounted_; }
    /// Takes all the room that is left.
    void fill() const {
        std::ofstream filler(folder_ + "/filler", std::ios::binary);
        const std::string block(4096, 'x');
        while (filler.write(block.data(), static_cast<std::streamsize>(block.size())).flush()) {
        }
    }

  private:
    std::string folder_;
    bool mounted_;
};

}  // namespace ew::test
