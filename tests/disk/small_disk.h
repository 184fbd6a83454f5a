/// A file system in memory with little room, for tests of full disks.
#pragma once

#include <sched.h>
#include <sys/mount.h>
#include <unistd.h>

#include <filesystem>
#include <string>

namespace batten::test {

/// Mounts a file system of `kilobytes` at `folder` for this process and what it starts alone. Returns whether it may;
/// without root it tries to in a space of names of its own, as one thread alone can.
inline bool mount_small_disk(const std::filesystem::path& folder, std::size_t kilobytes) {
    if (unshare(CLONE_NEWNS) != 0 && unshare(CLONE_NEWUSER | CLONE_NEWNS) != 0) return false;
    const std::string options = "size=" + std::to_string(kilobytes) + "k";
    return mount(nullptr, "/", nullptr, MS_REC | MS_PRIVATE, nullptr) == 0 &&
           mount("tmpfs", folder.c_str(), "tmpfs", 0, options.c_str()) == 0;
}

}  // namespace batten::test
