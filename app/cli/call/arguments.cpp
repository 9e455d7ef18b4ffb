// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/call/arguments.h"

#include "cli/call/texts.h"
#include "vocabulary/hex.h"

#include <algorithm>

namespace codewheel {
namespace {

// A minus before a digit is a number with the wrong sign, which gets a better sentence further on.
bool looksLikeOption(const QString &word)
{
    return word.size() > 1 && word[0] == u'-' && !word[1].isDigit();
}

QString nameOf(const Option &option)
{
    return QString::fromLatin1(option.name);
}

tl::unexpected<Complaint> unknownOption(const QString &name, std::span<const Option> options,
                                        const QString &who)
{
    return badInput("unknownOption", CommandLine::tr("There is no option \"%1\" of %2. Its options are: %3."),
                    {name, who, listed(options, nameOf)});
}

class Parser
{
public:
    Parser(const QStringList &words, std::span<const Option> options, QString who)
        : m_words(words)
        , m_options(options)
        , m_who(std::move(who))
    {}

    Checked<Arguments> parse()
    {
        while (m_next < m_words.size()) {
            const QString &word = m_words[m_next++];
            if (word == QStringLiteral("--")) {
                m_result.rest << m_words.sliced(m_next);
                break;
            }
            if (!looksLikeOption(word))
                m_result.rest << word;
            else if (auto taken = takeOption(word); !taken)
                return tl::unexpected(taken.error());
        }
        return m_result;
    }

private:
    Checked<void> takeOption(const QString &word)
    {
        const QString name = word.section(u'=', 0, 0);
        const auto option = std::ranges::find_if(
            m_options, [&](const Option &known) { return name == QLatin1String(known.name); });
        if (option == m_options.end())
            return unknownOption(name, m_options, m_who);
        if (m_result.options.contains(name))
            return badInput("optionGivenTwice", CommandLine::tr("%1 is given twice. Give it once."), {name});
        const auto value = valueOf(*option, word);
        if (!value)
            return tl::unexpected(value.error());
        m_result.options[name] = *value;
        return {};
    }

    Checked<QString> valueOf(const Option &option, const QString &word)
    {
        const QString name = QString::fromLatin1(option.name);
        const bool attached = word.contains(u'=');
        if (!option.value) {
            if (attached)
                return badInput("optionWithoutValue", CommandLine::tr("%1 takes no value. Give it alone."),
                                {name});
            return QString();
        }
        if (attached)
            return word.section(u'=', 1);
        if (m_next == m_words.size())
            return badInput("optionNeedsValue", CommandLine::tr("%1 needs a value: %1 %2."),
                            {name, QString::fromLatin1(option.value)});
        return m_words[m_next++];
    }

    const QStringList &m_words;
    std::span<const Option> m_options;
    QString m_who;
    qsizetype m_next = 0;
    Arguments m_result;
};

} // namespace

bool Arguments::has(const char *option) const
{
    return options.contains(QString::fromLatin1(option));
}

std::optional<QString> Arguments::value(const char *option) const
{
    const auto found = options.find(QString::fromLatin1(option));
    return found == options.end() ? std::nullopt : std::optional(found->second);
}

Checked<int> Arguments::number(const char *option, int otherwise, int minimum, int maximum) const
{
    const auto text = value(option);
    if (!text)
        return otherwise;
    const auto given = parseNumber(*text);
    if (!given || *given < minimum || *given > maximum)
        return badInput("optionOutOfRange",
                        CommandLine::tr("%1 cannot be \"%2\". Give a whole number from %3 to %4."),
                        {QString::fromLatin1(option), *text, std::int64_t{minimum}, std::int64_t{maximum}});
    return static_cast<int>(*given);
}

Checked<Arguments> parseArguments(const QStringList &words, std::span<const Option> options,
                                  const QString &who)
{
    return Parser(words, options, who).parse();
}

} // namespace codewheel
