// SPDX-License-Identifier: GPL-3.0-or-later
// QProcess starts a program by clone(CLONE_VM | CLONE_VFORK): the child shares the test's memory until it
// becomes the program. The ThreadSanitizer of clang 14 takes the child for a second thread in the same place
// and ends the test. A fork serves Qt just as well, and ThreadSanitizer can handle it.
#include <csignal>
#include <cstdarg>
#include <sched.h>
#include <sys/syscall.h>
#include <sys/types.h>
#include <unistd.h>

/// In place of the C library's, for all that the test program calls: runs @p child in a process of its own,
/// with its own stack and exit signal SIGCHLD. Gives its process id, and with CLONE_PIDFD its file descriptor
/// in the argument after @p argument; -1 with errno, where the system has no further process.
extern "C" int clone(int (*child)(void *), void * /*stack*/, int flags, void *argument, ...)
{
    const pid_t process = fork();
    if (process == 0)
        _exit(child(argument));
    if (process > 0 && (flags & CLONE_PIDFD) != 0) {
        va_list rest;
        va_start(rest, argument);
        *va_arg(rest, pid_t *) = static_cast<pid_t>(syscall(SYS_pidfd_open, process, 0));
        va_end(rest);
    }
    return process;
}
