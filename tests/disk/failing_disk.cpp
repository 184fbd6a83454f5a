#include "tests/disk/failing_disk.h"

#include <dlfcn.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdarg>
#include <cstdio>

namespace batten::test {

namespace {

constexpr int never = -1;
std::atomic<int> calls_before_failure{never};
std::atomic<int> failure_reason{0};
std::atomic<const char*> failed_function{nullptr};

// Whether this call is the one.
bool fails(const char* function) {
    int left = calls_before_failure;
    while (left != never)
        if (calls_before_failure.compare_exchange_weak(left, left - 1)) {
            if (left != 0) return false;
            failed_function = function;
            errno = failure_reason;
            return true;
        }
    return false;
}

template <class Function>
Function real(const char* name) {
    return reinterpret_cast<Function>(dlsym(RTLD_NEXT, name));
}

}  // namespace

FailingDisk::FailingDisk(int nth, int reason) {
    failed_function = nullptr;
    failure_reason = reason;
    calls_before_failure = nth;
}

FailingDisk::~FailingDisk() {
    calls_before_failure = never;
}

std::string FailingDisk::failed() {
    const char* function = failed_function;
    return function == nullptr ? "" : function;
}

}  // namespace batten::test

using batten::test::fails;
using batten::test::failure_reason;
using batten::test::real;

extern "C" {

int open(const char* path, int flags, ...) {
    mode_t mode = 0;
    if ((flags & O_CREAT) != 0) {
        va_list rest;
        va_start(rest, flags);
        mode = va_arg(rest, mode_t);
        va_end(rest);
    }
    const bool makes = (flags & O_CREAT) != 0;
    if (makes && fails("open")) return -1;
    return real<int (*)(const char*, int, mode_t)>("open")(path, flags, mode);
}

ssize_t write(int file, const void* bytes, size_t count) {
    const auto real_write = real<ssize_t (*)(int, const void*, size_t)>("write");
    if (!fails("write")) return real_write(file, bytes, count);
    static_cast<void>(real_write(file, bytes, count / 2));
    errno = failure_reason;
    return -1;
}

ssize_t pwrite(int file, const void* bytes, size_t count, off_t place) {
    const auto real_write = real<ssize_t (*)(int, const void*, size_t, off_t)>("pwrite");
    if (!fails("pwrite")) return real_write(file, bytes, count, place);
    static_cast<void>(real_write(file, bytes, count / 2, place));
    errno = failure_reason;
    return -1;
}

int fsync(int file) {
    return fails("fsync") ? -1 : real<int (*)(int)>("fsync")(file);
}

int fdatasync(int file) {
    return fails("fdatasync") ? -1 : real<int (*)(int)>("fdatasync")(file);
}

int fchmod(int file, mode_t mode) noexcept {
    return fails("fchmod") ? -1 : real<int (*)(int, mode_t)>("fchmod")(file, mode);
}

int ftruncate(int file, off_t size) noexcept {
    return fails("ftruncate") ? -1 : real<int (*)(int, off_t)>("ftruncate")(file, size);
}

// As the system does it where there is no room: the file has a part of it.
int posix_fallocate(int file, off_t place, off_t size) {
    const auto real_allocate = real<int (*)(int, off_t, off_t)>("posix_fallocate");
    if (!fails("posix_fallocate")) return real_allocate(file, place, size);
    static_cast<void>(real_allocate(file, place, size / 2));
    return failure_reason;
}

int rename(const char* from, const char* to) noexcept {
    return fails("rename") ? -1 : real<int (*)(const char*, const char*)>("rename")(from, to);
}

// As the system does it: the file is closed all the same.
int close(int file) {
    const int result = real<int (*)(int)>("close")(file);
    return fails("close") ? -1 : result;
}

}  // extern "C"
