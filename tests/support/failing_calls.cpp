// SPDX-License-Identifier: MIT
// Runs a program one of whose system calls fails, whoever makes it, the C library included:
//     failing_calls REPORT WHICH FOLDER PROGRAM ARGUMENT…
// Calls are counted from the first one that names something in FOLDER, which the program must not do before
// it works. Call number WHICH fails, counted from 1, with `+` behind it all from that one on; 0 is none.
// REPORT gets a line with the name of each call that was counted. Ends as the program does; 125 when the
// kernel cannot do this, 124 when the program takes too long.
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <poll.h>
#include <string>
#include <sys/ioctl.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

namespace {

struct Call {
    int number;
    const char* name;
    int error;
    int path = -1; // which of the arguments names a file
};

// All that can fail for reasons outside of the program. What keeps threads apart is left out, and so are
// signals, clocks, random numbers and giving memory back: these do not fail, and the C library aborts if they
// do.
constexpr Call known[]{
#ifdef SYS_open // none on newer architectures, as the others like it
    {SYS_open, "open", EIO, 0},
    {SYS_stat, "stat", EIO, 0},
    {SYS_lstat, "lstat", EIO, 0},
    {SYS_access, "access", EIO, 0},
    {SYS_readlink, "readlink", EIO, 0},
    {SYS_rename, "rename", EIO, 0},
    {SYS_link, "link", EIO, 0},
    {SYS_unlink, "unlink", EIO, 0},
    {SYS_mkdir, "mkdir", ENOSPC, 0},
    {SYS_chmod, "chmod", EIO, 0},
#endif
    {SYS_openat, "openat", EIO, 1},
    {SYS_newfstatat, "newfstatat", EIO, 1},
    {SYS_statx, "statx", EIO, 1},
    {SYS_faccessat, "faccessat", EIO, 1},
    {SYS_readlinkat, "readlinkat", EIO, 1},
    {SYS_renameat, "renameat", EIO, 1},
    {SYS_renameat2, "renameat2", EIO, 1},
    {SYS_linkat, "linkat", EIO, 1},
    {SYS_unlinkat, "unlinkat", EIO, 1},
    {SYS_mkdirat, "mkdirat", ENOSPC, 1},
    {SYS_fstat, "fstat", EIO},
    {SYS_fstatfs, "fstatfs", EIO},
    {SYS_lseek, "lseek", EIO},
    {SYS_read, "read", EIO},
    {SYS_readv, "readv", EIO},
    {SYS_pread64, "pread64", EIO},
    {SYS_write, "write", ENOSPC},
    {SYS_writev, "writev", ENOSPC},
    {SYS_pwrite64, "pwrite64", ENOSPC},
    {SYS_copy_file_range, "copy_file_range", ENOSPC},
    {SYS_sendfile, "sendfile", ENOSPC},
    {SYS_ftruncate, "ftruncate", EIO},
    {SYS_fallocate, "fallocate", ENOSPC},
    {SYS_fsync, "fsync", EIO},
    {SYS_fdatasync, "fdatasync", EIO},
    {SYS_close, "close", EIO},
    {SYS_flock, "flock", EIO},
    {SYS_fcntl, "fcntl", EIO},
    {SYS_ioctl, "ioctl", EIO},
    {SYS_getdents64, "getdents64", EIO},
    {SYS_fchmod, "fchmod", EPERM},
    {SYS_fchown, "fchown", EPERM},
    {SYS_listxattr, "listxattr", EIO, 0},
    {SYS_getxattr, "getxattr", EIO, 0},
    {SYS_fsetxattr, "fsetxattr", ENOSPC},
    {SYS_fremovexattr, "fremovexattr", EIO},
    {SYS_memfd_create, "memfd_create", ENOMEM},
    {SYS_pipe2, "pipe2", EMFILE},
    {SYS_eventfd2, "eventfd2", EMFILE},
    {SYS_socket, "socket", EMFILE},
    {SYS_mmap, "mmap", ENOMEM},
    {SYS_mremap, "mremap", ENOMEM},
    {SYS_mprotect, "mprotect", ENOMEM},
    {SYS_brk, "brk", ENOMEM},
    {SYS_clone, "clone", EAGAIN},
    {SYS_clone3, "clone3", EAGAIN},
};
constexpr auto calls = std::size(known);

constexpr int tooLong = 124;
constexpr int cannot = 125;

const Call* callOf(const seccomp_data& data) {
    for (const Call& call : known)
        if (call.number == data.nr) return &call;
    return nullptr;
}

// The calls above ask whoever listens; all others are made.
int listener() {
    std::vector<sock_filter> filter{BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, nr))};
    for (std::size_t i = 0; i < calls; ++i)
        filter.push_back(
            BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, std::uint32_t(known[i].number), std::uint8_t(calls - i), 0));
    filter.push_back(BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW));
    filter.push_back(BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_USER_NOTIF));
    const sock_fprog program{static_cast<unsigned short>(filter.size()), filter.data()};
    if (::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0) return -1;
    return int(::syscall(SYS_seccomp, SECCOMP_SET_MODE_FILTER, SECCOMP_FILTER_FLAG_NEW_LISTENER, &program));
}

// A descriptor through a socket, as sendmsg() wants it.
struct Parcel {
    char byte = 0;
    iovec bytes{&byte, 1};
    alignas(cmsghdr) char room[CMSG_SPACE(sizeof(int))]{};
    msghdr message{nullptr, 0, &bytes, 1, room, sizeof room, 0};
};

bool send(int socket, int descriptor) {
    Parcel parcel;
    cmsghdr* const header = CMSG_FIRSTHDR(&parcel.message);
    header->cmsg_level = SOL_SOCKET;
    header->cmsg_type = SCM_RIGHTS;
    header->cmsg_len = CMSG_LEN(sizeof(int));
    std::memcpy(CMSG_DATA(header), &descriptor, sizeof descriptor);
    return ::sendmsg(socket, &parcel.message, 0) == 1;
}

int receive(int socket) {
    Parcel parcel;
    if (::recvmsg(socket, &parcel.message, MSG_CMSG_CLOEXEC) != 1) return -1;
    const cmsghdr* const header = CMSG_FIRSTHDR(&parcel.message);
    if (!header || header->cmsg_type != SCM_RIGHTS) return -1;
    int descriptor = -1;
    std::memcpy(&descriptor, CMSG_DATA(header), sizeof descriptor);
    return descriptor;
}

[[noreturn]] void become(char** program, int socket) {
    const int notices = listener();
    if (notices < 0 || !send(socket, notices)) ::_exit(cannot); // asked about close() nobody would answer
    ::execv(program[0], program);
    ::_exit(cannot);
}

class Failures {
public:
    Failures(std::FILE* report, const char* which, std::string folder)
        : m_report(report), m_folder(std::move(folder)) {
        char* end = nullptr;
        m_which = std::strtol(which, &end, 10);
        m_isLasting = *end == '+';
    }

    // The error of the call; 0 when it is made.
    int met(const seccomp_notif& notice) {
        const Call* const call = callOf(notice.data);
        if (!call) return 0;
        m_counts = m_counts || isInFolder(notice, *call);
        if (!m_counts || isMessage(notice.data) || isOfKernel(notice, *call)) return 0;
        std::fprintf(m_report, "%s\n", call->name);
        ++m_count;
        const bool isLater = m_isLasting && m_count > m_which && !isTidying(*call);
        return m_which > 0 && (m_count == m_which || isLater) ? call->error : 0;
    }

private:
    // What the program says of its failure is to be seen.
    static bool isMessage(const seccomp_data& data) {
        return (data.nr == SYS_write || data.nr == SYS_writev) && data.args[0] == STDERR_FILENO;
    }
    // A program that may not even remove a file leaves it there.
    static bool isTidying(const Call& call) { return std::strncmp(call.name, "unlink", 6) == 0; }
    // Settings of the kernel are always there; libgcrypt aborts otherwise.
    static bool isOfKernel(const seccomp_notif& notice, const Call& call) {
        return call.path >= 0 && isBelow(notice, call, "/proc/sys/");
    }
    bool isInFolder(const seccomp_notif& notice, const Call& call) const {
        return call.path >= 0 && isBelow(notice, call, m_folder);
    }
    static bool isBelow(const seccomp_notif& notice, const Call& call, const std::string& folder) {
        std::string path(folder.size(), '\0');
        const iovec into{path.data(), path.size()};
        const iovec from{reinterpret_cast<void*>(notice.data.args[call.path]), path.size()};
        return ::process_vm_readv(pid_t(notice.pid), &into, 1, &from, 1, 0) == ssize_t(path.size()) &&
               path == folder;
    }

    std::FILE* m_report;
    std::string m_folder;
    long m_which = 0;
    bool m_isLasting = false;
    bool m_counts = false;
    long m_count = 0;
};

// Until the program has ended; false when it takes too long.
bool answer(int notices, Failures failures) {
    using Clock = std::chrono::steady_clock;
    const auto end = Clock::now() + std::chrono::seconds(60);
    for (;;) {
        const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end - Clock::now()).count();
        pollfd waiting{notices, POLLIN, 0};
        if (left <= 0 || ::poll(&waiting, 1, int(left)) == 0) return false;
        if (!(waiting.revents & POLLIN)) return true;
        seccomp_notif notice{};
        if (::ioctl(notices, SECCOMP_IOCTL_NOTIF_RECV, &notice) != 0) continue; // its thread is gone
        seccomp_notif_resp response{};
        response.id = notice.id;
        const int error = failures.met(notice);
        // The kernel answers brk() with the end of the heap, not with an error.
        if (notice.data.nr != SYS_brk) response.error = -error;
        if (error == 0) response.flags = SECCOMP_USER_NOTIF_FLAG_CONTINUE;
        ::ioctl(notices, SECCOMP_IOCTL_NOTIF_SEND, &response);
    }
}

} // namespace

int main(int argc, char** argv) {
    int ends[2];
    if (argc < 5 || ::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) return cannot;
    std::FILE* const report = std::fopen(argv[1], "we");
    if (!report) return cannot;
    const pid_t child = ::fork();
    if (child == 0) become(argv + 4, ends[1]);
    ::close(ends[1]);
    const int notices = receive(ends[0]);
    const bool isOver = notices >= 0 && answer(notices, Failures(report, argv[2], argv[3]));
    if (!isOver) ::kill(child, SIGKILL);
    int status = 0;
    ::waitpid(child, &status, 0);
    std::fclose(report);
    if (notices < 0) return cannot;
    if (!isOver) return tooLong;
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}
