// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/call/texts.h"
#include "cli/kinds/canopen/can_log_access.h"
#include "cli/kinds/canopen/canopen_link_kind.h"

namespace codewheel {
namespace {

const QString interfaceKey = QStringLiteral("interface");
const QString mappingKey = QStringLiteral("usual-mapping");

Checked<CanLogMeant> logMeant(LinkText text)
{
    CanLogMeant meant{.file = text.where};
    meant.interface = text.take(interfaceKey).value_or(QString());
    const auto mapping = text.take(mappingKey);
    meant.isUsuallyMapped = mapping.has_value();
    if (mapping && *mapping != QStringLiteral("yes"))
        return badInput(QStringLiteral("canAgreementWrong"),
                        CommandLine::tr("%1 cannot be \"%2\": write %1=yes, or leave it out."),
                        {mappingKey, *mapping});
    if (!text.settings.isEmpty())
        return badInput(
            QStringLiteral("unknownCanSetting"),
            CommandLine::tr("A log has no setting \"%1\". Its settings are: %2."),
            {text.settings.front(), QStringList{interfaceKey, mappingKey}.join(QStringLiteral(", "))});
    return meant;
}

// Logs of CAN buses with CANopen at the command line.
class CanLogLinkKind final : public LinkKind
{
public:
    QString bus() const override { return QString::fromLatin1(canopenKind); }
    QStringList schemes() const override { return {QStringLiteral("log")}; }
    bool leadsToPlanned() const override { return false; }
    bool leadsToFile() const override { return true; }
    QString help() const override
    {
        return CommandLine::tr(
            "log:FILE, the log of a CAN bus, which can be listened to, as log:candump.log");
    }
    bool isPlace(const QString &typed) const override { return CanopenAddress::read(typed).has_value(); }
    Checked<std::vector<MakeLink>> links(const LinkText &text, const Project *project) const override
    {
        return logMeant(text).map([&](const CanLogMeant &meant) {
            return std::vector<MakeLink>{[meant, id = numberOf(*this, project)](const Catalog &catalog) {
                return CanLogAccess::to(meant, catalog, id);
            }};
        });
    }
    // Those of the project are buses that are there.
    Checked<MakeLink> planned(const Project &, BusId, const QStringList &) const override
    {
        return MakeLink();
    }
    MakeLink training(const Project *) const override { return {}; }
    QStringList settingKeys(const QString &) const override { return {interfaceKey, mappingKey}; }
};

} // namespace

std::unique_ptr<const LinkKind> canLogLinkKind()
{
    return std::make_unique<CanLogLinkKind>();
}

} // namespace codewheel
