// SPDX-License-Identifier: MIT
// The beginning of Barycage in one file: mounts the squashfs that follows it, and starts AppRun there. Where
// mounting is not possible, the files are unpacked once into the user's cache. The options and the variables
// for AppRun are those of AppImages of type 2.
#define FUSE_USE_VERSION 32
extern "C" {
#include <squashfuse/ll.h>
#include <squashfuse/squashfuse.h>
}

#include <elf.h>
#include <fcntl.h>
#include <sys/mount.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <climits>
#include <cstdarg>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace {

namespace fs = std::filesystem;

constexpr int cannotRun = 127; // as shells say it

[[noreturn]] void fail(const std::string& sentence) {
    std::fprintf(stderr, "barycage: %s\n", sentence.c_str());
    std::exit(cannotRun);
}

std::string systemError(const std::string& what) {
    return what + ": " + std::strerror(errno) + ".";
}

std::string variable(const char* name) {
    const char* value = std::getenv(name);
    return value ? value : "";
}

// Bytes of the program itself, after which the squashfs begins.
std::size_t programSize(const std::string& image) {
    Elf64_Ehdr header{};
    const int file = open(image.c_str(), O_RDONLY | O_CLOEXEC);
    if (file < 0 || read(file, &header, sizeof header) != ssize_t(sizeof header))
        fail(systemError("“" + image + "” cannot be read"));
    close(file);
    return header.e_shoff + std::size_t(header.e_shentsize) * header.e_shnum;
}

// Distinguishes this image from others: FNV-1a of its end, which lists all files, and of its size.
std::string digestOf(const std::string& image) {
    constexpr std::size_t most = 1 << 18;
    const std::uintmax_t size = fs::file_size(image);
    std::vector<unsigned char> end(std::min<std::uintmax_t>(size, most));
    const int file = open(image.c_str(), O_RDONLY | O_CLOEXEC);
    if (file < 0 || pread(file, end.data(), end.size(), off_t(size - end.size())) != ssize_t(end.size()))
        fail(systemError("“" + image + "” cannot be read"));
    close(file);
    std::uint64_t hash = 0xcbf29ce484222325 ^ size;
    for (const unsigned char byte : end)
        hash = (hash ^ byte) * 0x100000001b3;
    char text[17];
    std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(hash));
    return text;
}

// The file system in the image, opened for reading without a mount.
class Contents {
public:
    explicit Contents(const std::string& image) {
        if (sqfs_open_image(&m_files, image.c_str(), programSize(image)) != SQFS_OK)
            fail("“" + image + "” is damaged.");
    }
    ~Contents() { sqfs_destroy(&m_files); }
    Contents(const Contents&) = delete;
    Contents& operator=(const Contents&) = delete;

    // False with errno if a file cannot be written.
    bool unpack(const fs::path& folder) {
        std::error_code error;
        fs::create_directories(folder, error);
        sqfs_traverse walk;
        sqfs_err status = sqfs_traverse_open(&walk, &m_files, sqfs_inode_root(&m_files));
        while (status == SQFS_OK && sqfs_traverse_next(&walk, &status)) {
            if (walk.dir_end) continue;
            sqfs_inode inode;
            if (sqfs_inode_get(&m_files, &inode, sqfs_dentry_inode(&walk.entry)) != SQFS_OK) return false;
            if (!unpackOne(folder / walk.path, inode)) return false;
        }
        sqfs_traverse_close(&walk);
        return status == SQFS_OK;
    }

private:
    bool unpackOne(const fs::path& to, sqfs_inode& inode) {
        const mode_t kind = inode.base.mode & S_IFMT;
        if (kind == S_IFDIR) return mkdir(to.c_str(), 0755) == 0 || errno == EEXIST;
        if (kind == S_IFLNK) {
            std::size_t size = 0;
            sqfs_readlink(&m_files, &inode, nullptr, &size);
            std::vector<char> target(size);
            if (sqfs_readlink(&m_files, &inode, target.data(), &size) != SQFS_OK) return false;
            return symlink(target.data(), to.c_str()) == 0 || errno == EEXIST;
        }
        if (kind != S_IFREG) return true;
        const int file = open(to.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, inode.base.mode & 0777);
        const bool isWritten = file >= 0 && copy(inode, file);
        return (file < 0 || close(file) == 0) && isWritten;
    }

    bool copy(sqfs_inode& inode, int file) {
        std::vector<char> buffer(1 << 20);
        for (sqfs_off_t at = 0; at < sqfs_off_t(inode.xtra.reg.file_size);) {
            sqfs_off_t size = sqfs_off_t(buffer.size());
            if (sqfs_read_range(&m_files, &inode, at, &size, buffer.data()) != SQFS_OK || size <= 0)
                return false;
            for (sqfs_off_t written = 0; written < size;) {
                const ssize_t more = write(file, buffer.data() + written, std::size_t(size - written));
                if (more <= 0) return false;
                written += more;
            }
            at += size;
        }
        return true;
    }

    sqfs m_files{};
};

// Starts AppRun in the folder with the variables of AppImages; returns only if it fails.
void run(const fs::path& folder, const std::string& image, std::vector<char*> arguments) {
    setenv("APPIMAGE", image.c_str(), 1);
    setenv("APPDIR", folder.c_str(), 1);
    setenv("ARGV0", arguments.front(), 1);
    std::error_code error;
    setenv("OWD", fs::current_path(error).c_str(), 1);
    const std::string program = folder / "AppRun";
    arguments.push_back(nullptr);
    execv(program.c_str(), arguments.data());
}

// Serves the mounted files until nothing has the pipe open any more, which the program and its children do.
[[noreturn]] void serve(const std::string& image, const std::string& mountPoint, int ready, int alive) {
    setsid();
    for (const int stream :
         {0, 1, 2}) { // whoever waits for the end of the output waits for the program alone
        const int nothing = open("/dev/null", O_RDWR | O_CLOEXEC);
        dup2(nothing, stream);
        if (nothing > 2) close(nothing);
    }
    fuse_lowlevel_ops calls{};
    calls.getattr = sqfs_ll_op_getattr;
    calls.opendir = sqfs_ll_op_opendir;
    calls.releasedir = sqfs_ll_op_releasedir;
    calls.readdir = sqfs_ll_op_readdir;
    calls.lookup = sqfs_ll_op_lookup;
    calls.open = sqfs_ll_op_open;
    calls.release = sqfs_ll_op_release;
    calls.read = sqfs_ll_op_read;
    calls.readlink = sqfs_ll_op_readlink;
    calls.forget = sqfs_ll_op_forget;
    sqfs_ll* files = sqfs_ll_open(image.c_str(), programSize(image));
    char name[] = "barycage", option[] = "-oro,nodev,nosuid,fsname=barycage,subtype=squashfuse";
    char* words[] = {name, option, nullptr};
    fuse_args options = FUSE_ARGS_INIT(2, words);
    sqfs_ll_chan channel{};
    if (!files ||
        sqfs_ll_mount(&channel, mountPoint.c_str(), &options, &calls, sizeof calls, files) != SQFS_OK)
        _exit(1);
    std::thread([&] {
        char nothing;
        while (read(alive, &nothing, 1) < 0 && errno == EINTR)
            ;
        fuse_session_exit(channel.session);
        fuse_session_unmount(channel.session); // wakes the loop
    }).detach();
    const char yes = 1;
    if (write(ready, &yes, 1) != 1) _exit(1);
    close(ready);
    fuse_session_loop(channel.session);
    rmdir(mountPoint.c_str());
    _exit(0);
}

// The mounted folder; nullopt where mounting is not possible. Its pipe stays open in this process.
std::optional<fs::path> mounted(const std::string& image) {
    if (access("/dev/fuse", R_OK | W_OK) != 0) return std::nullopt;
    const std::string temporary = variable("TMPDIR");
    std::string mountPoint = (temporary.empty() ? "/tmp" : temporary) + "/.mount_barycageXXXXXX";
    int ready[2], alive[2];
    if (!mkdtemp(mountPoint.data()) || pipe2(ready, O_CLOEXEC) != 0 || pipe(alive) != 0) return std::nullopt;
    const pid_t child = fork();
    if (child == 0) {
        close(ready[0]);
        close(alive[1]);
        serve(image, mountPoint, ready[1], alive[0]);
    }
    close(ready[1]);
    close(alive[0]);
    char yes = 0;
    const bool isMounted = child > 0 && read(ready[0], &yes, 1) == 1;
    close(ready[0]);
    if (isMounted) return mountPoint;
    close(alive[1]);
    if (child > 0) waitpid(child, nullptr, 0);
    rmdir(mountPoint.c_str());
    return std::nullopt;
}

// The files in the user's cache, unpacked unless they are there already.
fs::path unpacked(const std::string& image) {
    const std::string cache = variable("XDG_CACHE_HOME"), home = variable("HOME");
    const fs::path parent =
        (cache.empty() ? fs::path(home.empty() ? "/tmp" : home) / ".cache" : fs::path(cache)) / "barycage";
    const fs::path folder = parent / ("portable-" + digestOf(image));
    std::error_code error;
    if (fs::exists(folder, error)) return folder;
    const fs::path partial = folder.string() + "." + std::to_string(getpid());
    if (!Contents(image).unpack(partial)) {
        const std::string sentence = systemError("“" + partial.string() + "” cannot be written");
        fs::remove_all(partial, error);
        fail(sentence);
    }
    fs::rename(partial, folder, error); // of two that start together, the folder of one is that of both
    if (error) fs::remove_all(partial, error);
    return folder;
}

void help() {
    std::puts("Options of this file, apart from those of Barycage:\n"
              "  --appimage-extract          unpack into ./squashfs-root\n"
              "  --appimage-extract-and-run  run without mounting\n"
              "  --appimage-mount            mount, print the folder, and wait for Ctrl+C\n"
              "  --appimage-offset           print where the squashfs begins\n"
              "  --appimage-version          print the version of this runtime\n"
              "  --cli ARGUMENTS             the command line of Barycage");
}

} // namespace

int main(int count, char** values) {
    std::vector<char*> arguments(values, values + count);
    std::error_code error;
    const std::string image = fs::read_symlink("/proc/self/exe", error);
    if (error) fail("/proc is not mounted.");
    const std::string option = count > 1 ? values[1] : "";
    if (option == "--appimage-help") return help(), 0;
    if (option == "--appimage-version") return std::puts("Barycage runtime of type 2"), 0;
    if (option == "--appimage-offset") return std::printf("%zu\n", programSize(image)), 0;
    if (option == "--appimage-extract") {
        if (!Contents(image).unpack("squashfs-root")) fail(systemError("“squashfs-root” cannot be written"));
        return 0;
    }
    if (option == "--appimage-mount") {
        const auto folder = mounted(image);
        if (!folder) fail("mounting is not possible here; use --appimage-extract.");
        std::printf("%s\n", folder->c_str());
        std::fflush(stdout);
        pause();
        return 0;
    }
    const bool isUnpacked = option == "--appimage-extract-and-run";
    if (isUnpacked) arguments.erase(arguments.begin() + 1);
    const bool mayMount = !isUnpacked && variable("APPIMAGE_EXTRACT_AND_RUN").empty();
    if (const auto folder = mayMount ? mounted(image) : std::nullopt) run(*folder, image, arguments);
    run(unpacked(image), image, arguments);
    fail(systemError("the program cannot be started"));
}
