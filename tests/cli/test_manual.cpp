// SPDX-License-Identifier: GPL-3.0-or-later
// docs/command-line.md prints what the program prints.
#include "tests/cli/cli_run.h"

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

TEST(CliManual, EveryExamplePrintsWhatThePageSays)
{
    QFile file(QStringLiteral(CODEWHEEL_DOCS "/command-line.md"));
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    const std::vector<Example> examples = examplesIn(QString::fromUtf8(file.readAll()));
    EXPECT_GT(examples.size(), 20u);
    for (const Example &example : examples) {
        const CliRun run = runLine(example.line);
        EXPECT_EQ(QString::fromStdString(run.out + run.err).trimmed(), example.printed.trimmed())
            << "codewheel-cli " << example.line.toStdString();
    }
}

} // namespace
} // namespace codewheel
