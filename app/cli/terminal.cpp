// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/terminal.h"

#include "cli/texts.h"

#include <istream>
#include <ostream>

namespace codewheel {

void Terminal::print(const QString &text) const
{
    out << text.toStdString() << std::flush;
}

void Terminal::complain(const QString &text) const
{
    err << "codewheel-cli: " << text.toStdString() << std::endl;
}

bool Terminal::confirms(const QString &question) const
{
    print(question + QStringLiteral(" [%1] ").arg(CommandLine::tr("y/N", "answers to a question")));
    std::string line;
    std::getline(in, line);
    const QString answer = QString::fromStdString(line).trimmed().toLower();
    return answer == QStringLiteral("y") || answer == QStringLiteral("yes") ||
           answer == CommandLine::tr("y", "answer to a question") ||
           answer == CommandLine::tr("yes", "answer to a question");
}

} // namespace codewheel
