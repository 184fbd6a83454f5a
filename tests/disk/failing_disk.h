/// Makes the disk fail at a chosen call, for tests of what is written.
#pragma once

#include <string>

namespace batten::test {

/// While it lives, the call number `nth`, counted from 0, of those that change files fails for `reason` (of <cerrno>);
/// one that writes has written half of it then. Programs that link failing_disk.cpp go through it with all these calls.
class FailingDisk {
  public:
    FailingDisk(int nth, int reason);
    ~FailingDisk();
    FailingDisk(const FailingDisk&) = delete;
    FailingDisk& operator=(const FailingDisk&) = delete;

    /// The function that failed; empty where none came to that.
    static std::string failed();
};

}  // namespace batten::test
