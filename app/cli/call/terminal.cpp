// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/call/terminal.h"

#include "cli/call/texts.h"
#include "vocabulary/shown_text.h"

#include <cerrno>
#include <istream>
#include <ostream>

namespace codewheel {

void Terminal::print(const QString &text) const
{
    errno = 0;
    out << shownText(text).toStdString() << std::flush;
    if (!out && printError == 0)
        printError = errno == 0 ? EIO : errno;
}

QString Terminal::whyNotPrinted() const
{
    return qt_error_string(printError);
}

void Terminal::complain(const QString &text) const
{
    err << "codewheel-cli: " << shownText(text).toStdString() << std::endl;
}

void Terminal::showProgress(const QString &text) const
{
    constexpr auto eraseLine = "\r\x1B[K";
    if (isInteractive)
        err << eraseLine << shownText(text).toStdString() << std::flush;
}

bool Terminal::confirms(const QString &question) const
{
    const QString choice = QStringLiteral(" [%1]").arg(CommandLine::tr("y/N", "answers to a question"));
    return isYes(answer(question + choice));
}

bool Terminal::isYes(const QString &answer)
{
    const QString typed = answer.toLower();
    return typed == QStringLiteral("y") || typed == QStringLiteral("yes") ||
           typed == CommandLine::tr("y", "answer to a question") ||
           typed == CommandLine::tr("yes", "answer to a question");
}

QString Terminal::answer(const QString &question) const
{
    print(question + u' ');
    std::string line;
    std::getline(in, line);
    return QString::fromStdString(line).trimmed();
}

} // namespace codewheel
