// SPDX-License-Identifier: GPL-3.0-or-later
// Takes the place of the system's: for test programs that start no thread (codewheel_starts_no_thread).
#include <cstdio>
#include <cstdlib>
#include <pthread.h>

extern "C" int pthread_create(pthread_t *, const pthread_attr_t *, void *(*)(void *), void *) noexcept
{
    std::fputs("This program is said to start no thread (codewheel_starts_no_thread in its CMakeLists.txt), "
               "so ThreadSanitizer "
               "leaves it out.\n",
               stderr);
    std::abort();
}
