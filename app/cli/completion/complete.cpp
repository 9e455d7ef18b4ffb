// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/completion/complete.h"

#include "cli/bus/present_ports.h"
#include "cli/call/terminal.h"
#include "cli/call/texts.h"
#include "cli/commands.h"
#include "cli/completion/known_devices.h"
#include "cli/completion/usage_words.h"
#include "history/track.h"
#include "journal/message_fields.h"
#include "vocabulary/shown_text.h"

#include <algorithm>

namespace codewheel {
namespace {

const QString completeName = QStringLiteral("complete");
const QString filesMark = QStringLiteral(":files");

using Candidates = std::vector<Candidate>;

// The call as far as it is typed, and the word that is being typed.
class CallSoFar
{
public:
    explicit CallSoFar(QStringList words);

    Candidates candidates() const;

private:
    void take(const QString &word);
    const Option *option(const QString &name) const;
    KnownDevices known() const;
    Candidates commandNames() const;
    Candidates optionNames() const;
    Candidates valuesOf(const QString &what, const QString &typed) const;
    Candidates places() const;
    Candidates parameters(bool isAssignment, const QString &typed) const;
    Candidates links(const QString &typed) const;
    Candidates settings(const LinkKind &kind, const QString &typed) const;
    Candidates files(const QString &what) const;

    QString m_current;
    const Subcommand *m_command = nullptr;
    std::vector<Option> m_options; // that can be given
    std::map<QString, QString> m_given;
    QStringList m_rest;
    const Option *m_open = nullptr; // its value is being typed
};

CallSoFar::CallSoFar(QStringList words)
    : m_current(words.isEmpty() ? QString() : words.takeLast())
    , m_options(commonOptions().begin(), commonOptions().end())
{
    for (const QString &word : words)
        take(word);
}

void CallSoFar::take(const QString &word)
{
    if (m_open != nullptr) {
        m_given[QString::fromLatin1(std::exchange(m_open, nullptr)->name)] = word;
        return;
    }
    if (word.startsWith(u'-') && word.size() > 1) {
        const QString name = word.section(u'=', 0, 0);
        m_given[name] = word.section(u'=', 1);
        const Option *its = option(name);
        m_open = its != nullptr && its->value != nullptr && !word.contains(u'=') ? its : nullptr;
        return;
    }
    if (m_command != nullptr) {
        m_rest << word;
        return;
    }
    m_command = commandNamed(word);
    m_options = m_command != nullptr ? optionsOf(*m_command) : std::vector<Option>();
}

const Option *CallSoFar::option(const QString &name) const
{
    const auto found =
        std::ranges::find_if(m_options, [&](const Option &each) { return name == QLatin1String(each.name); });
    return found == m_options.end() ? nullptr : &*found;
}

KnownDevices CallSoFar::known() const
{
    const auto given = [this](const char *name) {
        const auto found = m_given.find(QString::fromLatin1(name));
        return found == m_given.end() ? QString() : found->second;
    };
    const QString link = given("--link");
    const bool isNamed = m_command != nullptr && m_command->namesProject;
    return {link.isEmpty() ? QStringLiteral("training") : link,
            isNamed ? m_rest.value(0) : given("--project")};
}

Candidates CallSoFar::candidates() const
{
    if (m_open != nullptr)
        return valuesOf(QString::fromLatin1(m_open->value), m_current);
    if (m_current.startsWith(u'-') && m_current.contains(u'=')) {
        const qsizetype value = m_current.indexOf(u'=') + 1;
        const Option *its = option(m_current.first(value - 1));
        Candidates all = its != nullptr && its->value != nullptr
                             ? valuesOf(QString::fromLatin1(its->value), m_current.sliced(value))
                             : Candidates();
        for (Candidate &candidate : all)
            if (!candidate.text.startsWith(filesMark))
                candidate.text.prepend(m_current.first(value));
        return all;
    }
    if (m_current.startsWith(u'-'))
        return optionNames();
    if (m_command == nullptr)
        return m_options.empty() ? Candidates() : commandNames();
    Candidates all;
    for (const QString &what : UsageWords(*m_command).at(m_rest.size()))
        std::ranges::copy(valuesOf(what, m_current), std::back_inserter(all));
    return all;
}

Candidates CallSoFar::commandNames() const
{
    Candidates all;
    for (const Subcommand *command : allCommands())
        all.push_back({QString::fromLatin1(command->name), CommandLine::tr(command->summary)});
    return all;
}

Candidates CallSoFar::optionNames() const
{
    Candidates all;
    for (const Option &each : m_options)
        if (const QString name = QString::fromLatin1(each.name); !m_given.contains(name))
            all.push_back({name, each.help != nullptr ? CommandLine::tr(each.help) : QString()});
    return all;
}

Candidates listOf(const QStringList &texts)
{
    Candidates all;
    for (const QString &text : texts)
        all.push_back({text});
    return all;
}

Candidates severities()
{
    Candidates all;
    for (const Severity severity : {Severity::information, Severity::attention, Severity::fault})
        all.push_back({severityKey(severity), severityName(severity)});
    return all;
}

Candidates units()
{
    Candidates all;
    for (const TrackUnit unit : trackUnits)
        all.push_back({QString(unitKey(unit))});
    return all;
}

// `what`: as a usage calls it.
Candidates CallSoFar::valuesOf(const QString &what, const QString &typed) const
{
    if (UsageWords::isLiteral(what))
        return listOf(what.split(u'|'));
    if (what == QStringLiteral("PLACE") || what == QStringLiteral("FROM") || what == QStringLiteral("TO"))
        return places();
    if (what == QStringLiteral("PARAMETER") || what == QStringLiteral("PARAMETER=VALUE"))
        return parameters(what.contains(u'='), typed);
    if (what == QStringLiteral("LINK"))
        return links(typed);
    if (what == QStringLiteral("BUS"))
        return listOf(known().buses());
    if (what == QStringLiteral("SEVERITY"))
        return severities();
    if (what == QStringLiteral("UNIT"))
        return units();
    const bool isServer = m_command == &serveCommand && !m_rest.contains(QStringLiteral("modbus-rtu"));
    if (what == QStringLiteral("PORT") && !isServer)
        return listOf(presentPortNames());
    if (what == QStringLiteral("NAME")) {
        Candidates all;
        const KnownDevices its = known();
        for (const DeviceDescription &device : its.catalog().devices())
            all.push_back({device.key, device.fullName()});
        return all;
    }
    return files(what);
}

Candidates CallSoFar::places() const
{
    Candidates all;
    const KnownDevices its = known();
    for (const KnownDevice &device : its.devices()) {
        const DeviceDescription *description = its.catalog().find(device.key);
        all.push_back({device.place, description != nullptr ? description->fullName() : QString()});
    }
    return all;
}

// The names, or behind a name and its = the values it can have.
Candidates CallSoFar::parameters(bool isAssignment, const QString &typed) const
{
    Candidates all;
    const KnownDevices its = known();
    for (const ParameterDescription *parameter : its.parameters(m_rest.value(0))) {
        const QString key = parameterKey(parameter->parameter);
        const QString name = isAssignment ? key + u'=' : key;
        if (parameter->onLabel || !(isAssignment ? parameter->canBeWritten : parameter->canBeRead))
            continue;
        if (isAssignment && typed.startsWith(name))
            for (const Choice &choice : parameter->choices)
                all.push_back({name + choice.key});
        else
            all.push_back({name});
    }
    return all;
}

Candidates CallSoFar::links(const QString &typed) const
{
    const QString project = QStringLiteral("project");
    Candidates all{{QStringLiteral("training")}, {project}};
    for (const LinkKind *kind : linkKinds())
        for (const QString &scheme : kind->schemes()) {
            const QString begin = scheme + u':';
            if (!typed.startsWith(begin)) {
                all.push_back({begin, kind->help()});
                continue;
            }
            if (typed.contains(u',')) {
                std::ranges::copy(settings(*kind, typed), std::back_inserter(all));
                continue;
            }
            if (kind->leadsToFile())
                all.push_back({filesMark + u' ' + begin});
            for (const QString &where : kind->ends(scheme))
                all.push_back({begin + where});
            if (kind->leadsToPlanned())
                all.push_back({begin + project});
        }
    return all;
}

Candidates CallSoFar::settings(const LinkKind &kind, const QString &typed) const
{
    Candidates all;
    const QString before = typed.first(typed.lastIndexOf(u',') + 1);
    for (const QString &key : kind.settingKeys(typed.section(u':', 0, 0)))
        if (!before.contains(u',' + key + u'='))
            all.push_back({before + key + u'='});
    return all;
}

Candidates CallSoFar::files(const QString &what) const
{
    const bool isRecording = what == QStringLiteral("FILE") && m_command == &exportCommand;
    const bool isProject = what == QStringLiteral("PROJECT") ||
                           (m_open != nullptr && QLatin1String(m_open->name) == QLatin1String("--project"));
    if (isProject)
        return {{filesMark + QStringLiteral(" codewheel")}};
    if (isRecording)
        return {{filesMark + QStringLiteral(" cwrec")}};
    return what == QStringLiteral("FILE") || what == QStringLiteral("CSV") ? Candidates{{filesMark}}
                                                                           : Candidates();
}

// Each once, as the tables have them.
Candidates fitting(Candidates all, const QString &typed)
{
    Candidates fit;
    for (Candidate &candidate : all)
        if (candidate.text.startsWith(filesMark) ||
            (candidate.text.startsWith(typed) &&
             std::ranges::count(fit, candidate.text, &Candidate::text) == 0))
            fit.push_back(std::move(candidate));
    return fit;
}

} // namespace

std::vector<Candidate> candidates(const QStringList &words)
{
    return fitting(CallSoFar(words).candidates(), words.isEmpty() ? QString() : words.last());
}

bool isCompletion(const QStringList &words)
{
    return words.value(0) == completeName && words.value(1) == QStringLiteral("--");
}

int complete(const QStringList &words, const Terminal &terminal)
{
    QString lines;
    for (const Candidate &candidate : candidates(words.sliced(2)))
        lines += shownInLine(candidate.text) +
                 (candidate.help.isEmpty() ? QString() : u'\t' + shownInLine(candidate.help)) + u'\n';
    terminal.print(lines);
    return static_cast<int>(ExitCode::done);
}

} // namespace codewheel
