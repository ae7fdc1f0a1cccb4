/* A disk that fails once, for tests: loaded before the C library (LD_PRELOAD), so that the program under test is the one that
 * ships. It counts operations on files below DISK_UNDER: open, read, write, sync, rename, make, remove, truncate, list. Operation
 * number DISK_AT (from 1) fails with errno DISK_ERRNO, or, with DISK_ERRNO=short, writes half of what it should. With
 * DISK_STAYS every operation from there on fails too. At the end DISK_REPORT gets the count and what failed. */
#define _GNU_SOURCE
#include <dirent.h>
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <stdarg.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#define FILES 4096

static const char *under;
static long at;
static int error, is_short, stays;
static char here[4096];
static atomic_long count;
static atomic_int is_ours[FILES];
static char failed[4200] = "nothing";

__attribute__((constructor)) static void begin(void) {
    const char *number = getenv("DISK_AT"), *word = getenv("DISK_ERRNO");
    under = getenv("DISK_UNDER");
    at = number ? atol(number) : 0;
    is_short = word && strcmp(word, "short") == 0;
    error = word ? atoi(word) : 0;
    stays = getenv("DISK_STAYS") != NULL;
    if (!getcwd(here, sizeof here)) here[0] = 0;
}

__attribute__((destructor)) static void end(void) {
    const char *report = getenv("DISK_REPORT");
    under = NULL;
    FILE *file = report ? fopen(report, "w") : NULL;
    if (file) {
        fprintf(file, "%ld\n%s\n", atomic_load(&count), failed);
        fclose(file);
    }
}

static int is_below(const char *path) {
    if (!under || !path) return 0;
    const char *whole = path[0] == '/' ? path : here;
    return strncmp(whole, under, strlen(under)) == 0;
}

/* Whether this operation fails; errno is set. */
static int fails(const char *what, const char *path) {
    long number = atomic_fetch_add(&count, 1) + 1;
    if (!at || (stays ? number < at : number != at)) return 0;
    if (number == at) snprintf(failed, sizeof failed, "%s %s", what, path ? path : "");
    errno = error;
    return 1;
}

static int fd_fails(const char *what, int fd) {
    return fd >= 0 && fd < FILES && atomic_load(&is_ours[fd]) && fails(what, "") && !is_short;
}

#define REAL(name) ((__typeof__(&name))dlsym(RTLD_NEXT, #name))

static int opened(int fd, int ours) {
    if (fd >= 0 && fd < FILES) atomic_store(&is_ours[fd], ours);
    return fd;
}

#define OPEN(name)                                                                                   \
    int name(const char *path, int flags, ...) {                                                     \
        va_list rest;                                                                                \
        va_start(rest, flags);                                                                       \
        mode_t mode = va_arg(rest, mode_t);                                                          \
        va_end(rest);                                                                                \
        int ours = is_below(path);                                                                   \
        if (ours && fails(flags & O_CREAT ? "create" : "open", path) && !is_short) return -1;        \
        return opened(REAL(name)(path, flags, mode), ours);                                          \
    }
OPEN(open)
OPEN(open64)

int close(int fd) {
    opened(fd, 0);
    return REAL(close)(fd);
}

ssize_t read(int fd, void *bytes, size_t size) {
    return fd_fails("read", fd) ? -1 : REAL(read)(fd, bytes, size);
}

ssize_t write(int fd, const void *bytes, size_t size) {
    if (fd >= 0 && fd < FILES && atomic_load(&is_ours[fd]) && fails("write", "")) {
        if (!is_short) return -1;
        size = size > 1 ? size / 2 : size;
    }
    return REAL(write)(fd, bytes, size);
}

int fsync(int fd) { return fd_fails("sync", fd) ? -1 : REAL(fsync)(fd); }
int fdatasync(int fd) { return fd_fails("sync", fd) ? -1 : REAL(fdatasync)(fd); }
int ftruncate64(int fd, off64_t size) { return fd_fails("truncate", fd) ? -1 : REAL(ftruncate64)(fd, size); }

#define ON_PATH(name, what, result, failure, parameters, ...)                                        \
    result name parameters {                                                                         \
        if (is_below(path) && fails(what, path) && !is_short) return failure;                        \
        return REAL(name)(__VA_ARGS__);                                                              \
    }
ON_PATH(rename, "rename", int, -1, (const char *path, const char *to), path, to)
ON_PATH(mkdir, "make", int, -1, (const char *path, mode_t mode), path, mode)
ON_PATH(rmdir, "remove", int, -1, (const char *path), path)
ON_PATH(unlink, "remove", int, -1, (const char *path), path)
ON_PATH(opendir, "list", DIR *, NULL, (const char *path), path)
