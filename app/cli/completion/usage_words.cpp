// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/completion/usage_words.h"

#include "cli/call/help.h"
#include "cli/commands.h"

#include <algorithm>

namespace codewheel {
namespace {

bool takesValue(const std::vector<Option> &options, const QString &name)
{
    return std::ranges::any_of(options, [&](const Option &option) {
        return option.value != nullptr && name == QLatin1String(option.name);
    });
}

} // namespace

UsageWords::UsageWords(const Subcommand &command)
{
    const std::vector<Option> options = optionsOf(command);
    QString usage = callOf(command).section(u' ', 1);
    usage.replace(u'[', QStringLiteral(" [ ")).replace(u']', QStringLiteral(" ] "));
    std::vector<std::size_t> begins{0}; // of the groups that are open
    std::size_t position = 0;
    bool isValue = false; // of an option
    for (const QString &word : usage.split(u' ', Qt::SkipEmptyParts)) {
        if (word == QStringLiteral("["))
            begins.push_back(position);
        else if (word == QStringLiteral("]"))
            begins.pop_back();
        else if (word == QStringLiteral("|")) // another way to go on from there
            position = begins.back();
        else if (word.startsWith(u'-'))
            isValue = takesValue(options, word);
        else if (!std::exchange(isValue, false))
            add(position++, word);
    }
}

void UsageWords::add(std::size_t position, const QString &word)
{
    const QString dots = QStringLiteral("...");
    m_words.resize(std::max(m_words.size(), position + 1));
    m_repeats = word.endsWith(dots);
    m_words[position] << (m_repeats ? word.chopped(dots.size()) : word).split(u'|');
}

QStringList UsageWords::at(qsizetype position) const
{
    const auto count = static_cast<qsizetype>(m_words.size());
    if (position >= count && !(m_repeats && count > 0))
        return {};
    return m_words[static_cast<std::size_t>(std::min(position, count - 1))];
}

bool UsageWords::isLiteral(const QString &word)
{
    return word == word.toLower();
}

} // namespace codewheel
