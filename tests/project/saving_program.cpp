// SPDX-License-Identifier: GPL-3.0-or-later
// Saves two projects to one file, alternately and endlessly, until it is killed
// (test_killed_while_saving.cpp):
//   saving_program projects|bytes FILE FIRST SECOND
// "projects" saves as the program does; "bytes" only replaces the file, so that a kill is sure to hit that.
#include "catalog/catalog.h"
#include "project/file_access.h"
#include "project/project_file.h"

#include <QFile>

#include <array>
#include <cstdio>
#include <cstdlib>

namespace {

using namespace codewheel;

template <typename T>
T orEnd(Result<T> result)
{
    if (!result)
        std::exit(1);
    return *std::move(result);
}

// Prints a line for each save, so that the test can follow it.
[[noreturn]] void saveForEver(auto save)
{
    for (unsigned long round = 0;; ++round) {
        if (!save(round % 2))
            std::exit(1);
        std::puts("saved");
        std::fflush(stdout);
    }
}

} // namespace

int main(int argc, char **argv)
{
    if (argc != 5)
        return 2;
    const QString file = QFile::decodeName(argv[2]);
    const QString first = QFile::decodeName(argv[3]);
    const QString second = QFile::decodeName(argv[4]);
    if (QByteArrayView(argv[1]) == "projects") {
        Catalog::builtIn(); // names the parameters
        const std::array projects{orEnd(loadProject(first)), orEnd(loadProject(second))};
        saveForEver([&](std::size_t which) { return saveProject(projects.at(which), file); });
    }
    const std::array bytes{orEnd(readWholeFile(first, largestProjectFile)),
                           orEnd(readWholeFile(second, largestProjectFile))};
    saveForEver(
        [&](std::size_t which) { return replaceFile(file, bytes.at(which), OldFile::isKeptAsBackup); });
}
