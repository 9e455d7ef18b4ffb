// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/kinds/link_kind.h"
#include "tests/kinds/plain/plain_bus.h"

namespace codewheel::test {

// The tests' own kind at the command line: its row there. It leads to no bus: calls bring theirs.
class PlainLinkKind final : public LinkKind
{
public:
    QString bus() const override { return QStringLiteral("plain"); }
    QStringList schemes() const override { return {QStringLiteral("plain")}; }
    bool leadsToPlanned() const override { return false; }
    QString help() const override { return {}; }
    bool isPlace(const QString &typed) const override { return typed.startsWith(QStringLiteral("n:")); }
    Checked<std::vector<MakeLink>> links(const LinkText &, const Project *) const override { return {}; }
    Checked<MakeLink> planned(const Project &, BusId, const QStringList &) const override { return {}; }
    MakeLink training(const Project *) const override { return {}; }
    std::optional<Checked<Answer>> explain(const Call &call, const DeviceDescription &device) const override
    {
        return device.profile == plainProfile || device.profile == telegramProfile
                   ? std::optional(explainLine(call.arguments.rest.front(), device))
                   : std::nullopt;
    }

private:
    static Checked<Answer> explainLine(const QString &line, const DeviceDescription &device)
    {
        const QString meaning = plainMeaning(device, line.toUtf8());
        if (meaning.isEmpty())
            return badInput("notALine", QStringLiteral("\"%1\" is no line of a plain node."), {line});
        return Answer{QStringLiteral("%1, %2\n  %3\n").arg(line, device.fullName(), meaning),
                      {{QStringLiteral("line"), line},
                       {QStringLiteral("device"), device.key},
                       {QStringLiteral("meaning"), meaning}}};
    }
};

} // namespace codewheel::test
