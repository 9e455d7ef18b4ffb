// SPDX-License-Identifier: GPL-3.0-or-later
// README and manual page show the program's actual output.
#include "tests/cli/cli_run.h"

#include <QDir>
#include <QFile>
#include <QStringList>

#include <gtest/gtest.h>

namespace codewheel {
namespace {

struct Example
{
    QString line;
    QString printed;
};

// "$ codewheel-cli ..." and what follows it in its block.
std::vector<Example> examplesIn(const QString &page)
{
    const QString prompt = QStringLiteral("$ codewheel-cli ");
    std::vector<Example> examples;
    bool inBlock = false;
    for (const QString &line : page.split(u'\n')) {
        if (line.startsWith(QStringLiteral("```")))
            inBlock = !inBlock;
        else if (inBlock && line.startsWith(prompt))
            examples.push_back({line.sliced(prompt.size()), {}});
        else if (inBlock && !examples.empty())
            examples.back().printed += line + u'\n';
    }
    return examples;
}

void comparePage(const char *name, std::size_t atLeast)
{
    QDir::setCurrent(QStringLiteral(CODEWHEEL_ROOT)); // the examples name files in docs/examples
    QFile file(QStringLiteral(CODEWHEEL_ROOT "/") + QString::fromLatin1(name));
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    const std::vector<Example> examples = examplesIn(QString::fromUtf8(file.readAll()));
    EXPECT_GE(examples.size(), atLeast);
    for (const Example &example : examples) {
        const CliRun run = runLine(example.line);
        EXPECT_EQ(QString::fromStdString(run.out + run.err).trimmed().toStdString(),
                  example.printed.trimmed().toStdString())
            << name << ": codewheel-cli " << example.line.toStdString();
    }
}

TEST(CliManual, EveryExampleOfTheManualPagePrintsWhatItSays)
{
    comparePage("docs/command-line.md", 20);
}

TEST(CliManual, EveryExampleOfTheReadmePrintsWhatItSays)
{
    comparePage("README.md", 1);
}

} // namespace
} // namespace codewheel
