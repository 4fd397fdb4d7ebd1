/* An interposed library that lets one call to the system fail, as a full or a faulty disk would:
 *
 *   LD_PRELOAD=faults.so SIGNORINI_FAULT="write 3 28" signorini ...
 *
 * the third write fails with errno 28; with 0 in place of an error it takes one byte only. With
 * SIGNORINI_FAULT_LOG=FILE every call is noted there instead, a name a line. Programs that signorini
 * starts, such as gnuplot, are left alone. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/uio.h>
#include <unistd.h>

#define NEXT(name) ((__typeof__(&name))dlsym(RTLD_NEXT, #name))

enum { goOn, beShort, fail };

/* What is to become of this call; sets errno. */
static int fate(const char* name)
{
    static int count = 0;
    if (strncmp(program_invocation_short_name, "signorini", 9) != 0) {
        return goOn;
    }
    const char* log = getenv("SIGNORINI_FAULT_LOG");
    if (log != NULL) {
        const int file = NEXT(open)(log, O_WRONLY | O_CREAT | O_APPEND, 0666);
        (void)!NEXT(write)(file, name, strlen(name));
        (void)!NEXT(write)(file, "\n", 1);
        NEXT(close)(file);
    }
    char wanted[32];
    int ordinal = 0;
    int error = 0;
    const char* fault = getenv("SIGNORINI_FAULT");
    if (fault == NULL || sscanf(fault, "%31s %d %d", wanted, &ordinal, &error) != 3 ||
        strcmp(wanted, name) != 0 || __atomic_add_fetch(&count, 1, __ATOMIC_SEQ_CST) != ordinal) {
        return goOn;
    }
    errno = error;
    return error == 0 ? beShort : fail;
}

ssize_t write(int file, const void* data, size_t size)
{
    const int what = file == STDERR_FILENO ? goOn : fate("write");
    return what == fail ? -1 : NEXT(write)(file, data, what == beShort && size > 1 ? 1 : size);
}

ssize_t writev(int file, const struct iovec* parts, int count)
{
    const int what = fate("write");
    return what == fail ? -1 : NEXT(writev)(file, parts, what == beShort ? 1 : count);
}

ssize_t pwrite64(int file, const void* data, size_t size, off64_t at)
{
    const int what = fate("pwrite");
    return what == fail ? -1 : NEXT(pwrite64)(file, data, what == beShort && size > 1 ? 1 : size, at);
}

int fsync(int file) { return fate("fsync") == fail ? -1 : NEXT(fsync)(file); }

int fdatasync(int file) { return fate("fsync") == fail ? -1 : NEXT(fdatasync)(file); }

int ftruncate64(int file, off64_t size)
{
    return fate("truncate") == fail ? -1 : NEXT(ftruncate64)(file, size);
}

int rename(const char* from, const char* to)
{
    return fate("rename") == fail ? -1 : NEXT(rename)(from, to);
}

int link(const char* from, const char* to)
{
    return fate("link") == fail ? -1 : NEXT(link)(from, to);
}

int mkstemp64(char* name) { return fate("create") == fail ? -1 : NEXT(mkstemp64)(name); }

int mkstemp(char* name) { return fate("create") == fail ? -1 : NEXT(mkstemp)(name); }

char* mkdtemp(char* name) { return fate("create") == fail ? NULL : NEXT(mkdtemp)(name); }

static int opened(__typeof__(&open) next, const char* path, int flags, unsigned mode)
{
    return (flags & O_CREAT) != 0 && fate("open") == fail ? -1 : next(path, flags, mode);
}

int open(const char* path, int flags, ...)
{
    va_list rest;
    va_start(rest, flags);
    const unsigned mode = (flags & O_CREAT) != 0 ? va_arg(rest, unsigned) : 0;
    va_end(rest);
    return opened(NEXT(open), path, flags, mode);
}

int open64(const char* path, int flags, ...)
{
    va_list rest;
    va_start(rest, flags);
    const unsigned mode = (flags & O_CREAT) != 0 ? va_arg(rest, unsigned) : 0;
    va_end(rest);
    return opened(NEXT(open64), path, flags, mode);
}
