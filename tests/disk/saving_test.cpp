// Saving on disks that fail: the old file stays whole, or the new one is there, and nothing else.

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/xattr.h>

#include <array>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>
#include <set>

#include "core/document/file_stamp.h"
#include "core/document/file_text.h"
#include "tests/disk/failing_disk.h"
#include "tests/disk/small_disk.h"

namespace batten::core {
namespace {

namespace fs = std::filesystem;

class Saving : public ::testing::Test {
  protected:
    Saving() {
        std::string name = (fs::temp_directory_path() / "batten-test-XXXXXX").string();
        folder_ = mkdtemp(name.data());
    }
    ~Saving() override {
        std::error_code error;
        fs::permissions(folder_, fs::perms::owner_all, error);
        fs::remove_all(folder_, error);
    }

    static std::string content(const fs::path& path) {
        std::ifstream file(path, std::ios::binary);
        return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    }
    std::size_t file_count() const {
        return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
    }

    fs::path folder_;
};

TEST_F(Saving, a_disk_that_fails_at_any_call_leaves_the_old_file_or_the_new_one) {
    const fs::path path = folder_ / "wave.json";
    const std::string text(100'000, 'x');
    std::set<std::string> refused;
    std::set<std::string> passed;
    for (const int reason : {ENOSPC, EIO, EDQUOT}) {
        for (int nth = 0;; ++nth) {
            std::ofstream(path, std::ios::binary) << "old";
            FileResult<void> saved;
            std::string failed;
            {
                const test::FailingDisk disk(nth, reason);
                saved = replace_text(path, text);
                failed = test::FailingDisk::failed();
            }
            EXPECT_EQ(content(path), saved ? text : "old") << failed;
            EXPECT_EQ(file_count(), 1U) << failed;
            const std::string told = saved ? std::strerror(reason) : saved.error().what;
            EXPECT_NE(told.find(std::strerror(reason)), std::string::npos) << failed;
            if (failed.empty()) break;
            (saved ? passed : refused).insert(failed);
        }
    }
    EXPECT_EQ(refused, (std::set<std::string>{"open", "fchmod", "write", "fsync", "close", "rename"}));
    // Of the folder, once the file is replaced.
    EXPECT_EQ(passed, (std::set<std::string>{"fsync", "close"}));
}

TEST_F(Saving, keeps_all_names_of_a_file) {
    const fs::path path = folder_ / "wave.json";
    const fs::path other = folder_ / "other.json";
    std::ofstream(path, std::ios::binary) << "old";
    fs::create_hard_link(path, other);
    for (const std::string& text : {std::string(100'000, 'x'), std::string("short")}) {
        const FileResult<FileStamp> saved = replace_and_stamp(path, text);
        ASSERT_TRUE(saved) << saved.error().sentence();
        EXPECT_EQ(content(path), text);
        EXPECT_EQ(content(other), text);
        EXPECT_EQ(*saved, file_stamp(path));
        EXPECT_EQ(file_stamp(other), file_stamp(path));
        EXPECT_EQ(file_count(), 2U);
    }
}

// Whole at any time: in the file, or beside it with its place told.
TEST_F(Saving, a_disk_that_fails_leaves_a_file_of_several_names_whole_or_a_copy_beside_it) {
    const fs::path path = folder_ / "wave.json";
    const fs::path other = folder_ / "other.json";
    std::set<std::string> refused;
    std::set<std::string> left_beside;
    for (const auto& [before, text] : {std::pair(std::string("old"), std::string(100'000, 'x')),
                                       std::pair(std::string(200'000, 'o'), std::string("new"))}) {
        for (int nth = 0;; ++nth) {
            fs::remove_all(folder_);
            fs::create_directory(folder_);
            std::ofstream(path, std::ios::binary) << before;
            fs::create_hard_link(path, other);
            FileResult<void> saved;
            std::string failed;
            {
                const test::FailingDisk disk(nth, EIO);
                saved = replace_text(path, text);
                failed = test::FailingDisk::failed();
            }
            EXPECT_EQ(content(path), content(other)) << failed;
            if (saved) {
                EXPECT_EQ(content(path), text) << failed;
                EXPECT_EQ(file_count(), 2U) << failed;
            } else if (file_count() == 2) {
                EXPECT_EQ(content(path), before) << failed;
                refused.insert(failed);
            } else {
                const std::string beside = (folder_ / ".batten-").string();
                const std::size_t place = saved.error().what.find(beside);
                ASSERT_NE(place, std::string::npos) << saved.error().what;
                EXPECT_EQ(content(saved.error().what.substr(place)), text) << failed;
                EXPECT_NE(saved.error().what.find(std::strerror(EIO)), std::string::npos) << saved.error().what;
                left_beside.insert(failed);
            }
            if (failed.empty()) break;
        }
    }
    EXPECT_EQ(refused, (std::set<std::string>{"open", "fchmod", "write", "fsync", "close", "posix_fallocate"}));
    EXPECT_EQ(left_beside, (std::set<std::string>{"pwrite", "ftruncate", "fsync"}));
}

TEST_F(Saving, a_full_disk_leaves_a_file_of_several_names) {
    const fs::path path = folder_ / "wave.json";
    if (!test::mount_small_disk(folder_, 64)) GTEST_SKIP() << "mounting a small disk is not permitted here";
    std::ofstream(path, std::ios::binary) << "old";
    fs::create_hard_link(path, folder_ / "other.json");
    // There is room for one more, not for two.
    const FileResult<void> saved = replace_text(path, std::string(40'000, 'x'));
    ASSERT_FALSE(saved);
    EXPECT_EQ(saved.error().what, "the file cannot be written: No space left on device");
    EXPECT_EQ(content(path), "old");
    EXPECT_EQ(file_count(), 2U);
    umount(folder_.c_str());
}

TEST_F(Saving, tells_the_stamp_of_what_was_written) {
    const fs::path path = folder_ / "wave.json";
    const FileResult<FileStamp> made = replace_and_stamp(path, "first");
    ASSERT_TRUE(made);
    EXPECT_EQ(*made, file_stamp(path));
    const FileResult<FileStamp> replaced = replace_and_stamp(path, "second");
    ASSERT_TRUE(replaced);
    EXPECT_EQ(*replaced, file_stamp(path));
    EXPECT_NE(*replaced, *made);
}

TEST_F(Saving, keeps_attributes_and_the_access_list) {
    const fs::path path = folder_ / "wave.json";
    std::ofstream(path) << "old";
    // Version 2: the owner, user 1000, the group, the mask and all others (acl(5)).
    const std::array<std::uint32_t, 11> list{2,          0x60001, UINT32_MAX, 0x40002, 1000,      0x40004,
                                             UINT32_MAX, 0x40010, UINT32_MAX, 0x20,    UINT32_MAX};
    if (setxattr(path.c_str(), "user.origin", "survey", 6, 0) != 0 ||
        setxattr(path.c_str(), "system.posix_acl_access", list.data(), sizeof(list), 0) != 0)
        GTEST_SKIP() << "this file system keeps no attributes: " << std::strerror(errno);
    ASSERT_TRUE(replace_text(path, "new"));
    std::array<char, 16> origin{};
    EXPECT_EQ(getxattr(path.c_str(), "user.origin", origin.data(), origin.size()), 6);
    EXPECT_STREQ(origin.data(), "survey");
    std::array<std::uint32_t, 11> found{};
    EXPECT_EQ(getxattr(path.c_str(), "system.posix_acl_access", found.data(), sizeof(found)),
              static_cast<ssize_t>(sizeof(list)));
    EXPECT_EQ(found, list);
    EXPECT_EQ(content(path), "new");
}

TEST_F(Saving, gives_no_more_access_than_there_was) {
    const fs::path path = folder_ / "wave.json";
    std::ofstream(path) << "old";
    fs::permissions(path, fs::perms::owner_read | fs::perms::owner_write);
    const std::array<std::uint32_t, 11> list{2,          0x60001, UINT32_MAX, 0x40002, 1000,      0x40004,
                                             UINT32_MAX, 0x40010, UINT32_MAX, 0x20,    UINT32_MAX};
    if (setxattr(folder_.c_str(), "system.posix_acl_default", list.data(), sizeof(list), 0) != 0)
        GTEST_SKIP() << "this file system keeps no access lists: " << std::strerror(errno);
    ASSERT_TRUE(replace_text(path, "new"));
    EXPECT_EQ(getxattr(path.c_str(), "system.posix_acl_access", nullptr, 0), -1);
    EXPECT_EQ(fs::status(path).permissions(), fs::perms::owner_read | fs::perms::owner_write);
}

TEST_F(Saving, a_full_disk_leaves_the_old_file) {
    const fs::path path = folder_ / "wave.json";
    if (!test::mount_small_disk(folder_, 64)) GTEST_SKIP() << "mounting a small disk is not permitted here";
    std::ofstream(path, std::ios::binary) << "old";
    const FileResult<void> saved = replace_text(path, std::string(200'000, 'x'));
    ASSERT_FALSE(saved);
    EXPECT_EQ(saved.error().what, "the file cannot be written: No space left on device");
    EXPECT_EQ(content(path), "old");
    EXPECT_EQ(file_count(), 1U);
    EXPECT_TRUE(replace_text(path, std::string(20'000, 'y')));
    EXPECT_EQ(content(path).size(), 20'000U);
    umount(folder_.c_str());
}

TEST_F(Saving, a_folder_that_may_not_be_written_or_is_gone_is_told) {
    const fs::path path = folder_ / "wave.json";
    std::ofstream(path, std::ios::binary) << "old";
    if (geteuid() != 0) {
        fs::permissions(folder_, fs::perms::owner_read | fs::perms::owner_exec);
        const FileResult<void> saved = replace_text(path, "new");
        ASSERT_FALSE(saved);
        EXPECT_EQ(saved.error().what, "no file can be made in this folder: Permission denied");
        EXPECT_EQ(content(path), "old");
        fs::permissions(folder_, fs::perms::owner_all);
    }
    const FileResult<void> saved = replace_text(folder_ / "gone" / "wave.json", "new");
    ASSERT_FALSE(saved);
    EXPECT_EQ(saved.error().what, "there is no folder " + (folder_ / "gone").string());
    EXPECT_EQ(file_count(), 1U);
}

TEST_F(Saving, what_a_program_has_opened_is_not_replaced) {
    const fs::path path = folder_ / "notes.txt";
    std::ofstream(path, std::ios::binary) << "precious";
    const int opened = open(path.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC);
    ASSERT_GE(opened, 0);
    const fs::path link = folder_ / "link";
    fs::create_symlink("/dev/fd/" + std::to_string(opened), link);
    for (const fs::path& name : {fs::path("/dev/fd") / std::to_string(opened), link}) {
        const FileResult<void> saved = replace_text(name, "new");
        ASSERT_FALSE(saved);
        EXPECT_EQ(saved.error().what,
                  "this is what a program has opened, not a file in a folder, so it cannot be saved to");
    }
    close(opened);
    EXPECT_EQ(content(path), "precious");
}

TEST_F(Saving, keeps_owner_group_and_permissions) {
    if (geteuid() != 0) GTEST_SKIP() << "only root can give files away";
    const fs::path path = folder_ / "wave.json";
    std::ofstream(path) << "old";
    constexpr uid_t nobody = 65534;
    ASSERT_EQ(chown(path.c_str(), nobody, nobody - 1), 0);
    ASSERT_EQ(chmod(path.c_str(), 0640), 0);
    ASSERT_TRUE(replace_text(path, "new"));
    struct stat status {};
    ASSERT_EQ(stat(path.c_str(), &status), 0);
    EXPECT_EQ(status.st_uid, nobody);
    EXPECT_EQ(status.st_gid, nobody - 1);
    EXPECT_EQ(status.st_mode & 07777U, 0640U);
}

TEST_F(Saving, a_group_that_cannot_be_kept_gets_no_rights) {
    if (geteuid() != 0) GTEST_SKIP() << "only root can become another user";
    const fs::path path = folder_ / "wave.json";
    std::ofstream(path) << "old";
    constexpr uid_t nobody = 65534;
    ASSERT_EQ(chown(path.c_str(), nobody, 0), 0);  // the folder is of a group that nobody is not in
    ASSERT_EQ(chown(folder_.c_str(), nobody, nobody), 0);
    ASSERT_EQ(chmod(path.c_str(), 0664), 0);
    ASSERT_EQ(setegid(nobody), 0);
    ASSERT_EQ(seteuid(nobody), 0);
    const FileResult<void> saved = replace_text(path, "new");
    ASSERT_EQ(seteuid(0), 0);
    ASSERT_EQ(setegid(0), 0);
    ASSERT_TRUE(saved) << saved.error().sentence();
    struct stat status {};
    ASSERT_EQ(stat(path.c_str(), &status), 0);
    EXPECT_EQ(status.st_gid, nobody);
    EXPECT_EQ(status.st_mode & 07777U, 0644U);
}

TEST_F(Saving, a_stamp_tells_every_change_of_a_file) {
    const fs::path path = folder_ / "wave.json";
    EXPECT_FALSE(file_stamp(path));
    std::ofstream(path) << "old";
    const auto stamp = file_stamp(path);
    ASSERT_TRUE(stamp);
    EXPECT_EQ(stamp, file_stamp(path));
    EXPECT_EQ(stamp->size, 3);
    // Another file of the same length, written at the same time.
    std::ofstream(folder_ / "other.json") << "new";
    const timespec times[2] = {{stamp->seconds, stamp->nanoseconds}, {stamp->seconds, stamp->nanoseconds}};
    ASSERT_EQ(utimensat(AT_FDCWD, (folder_ / "other.json").c_str(), static_cast<const timespec*>(times), 0), 0);
    fs::rename(folder_ / "other.json", path);
    EXPECT_NE(stamp, file_stamp(path));
    const auto second = file_stamp(path);
    // The same file a nanosecond later.
    const timespec later[2] = {{stamp->seconds, stamp->nanoseconds}, {stamp->seconds, stamp->nanoseconds ^ 1}};
    ASSERT_EQ(utimensat(AT_FDCWD, path.c_str(), static_cast<const timespec*>(later), 0), 0);
    EXPECT_NE(second, file_stamp(path));
}

}  // namespace
}  // namespace batten::core
