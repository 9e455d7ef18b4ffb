// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/link_kind.h"

namespace codewheel {

extern const Subcommand terminalCommand;
extern const Subcommand serveCommand;

// Serial lines with the ESC protocol at the command line: a port, or the training line.
class LineLinkKind final : public LinkKind
{
public:
    QString bus() const override;
    QStringList schemes() const override;
    QString help() const override;
    bool isPlace(const QString &typed) const override;
    Checked<std::vector<MakeLink>> links(const LinkText &text, const Project *project) const override;
    MakeLink planned(const Project &project, BusId bus) const override;
    MakeLink training(const Project *project) const override;
    std::span<const Subcommand *const> commands() const override;
    std::span<const Option> scanOptions() const override;
    std::optional<Checked<Answer>> explain(const Call &call, const DeviceDescription &device) const override;
    Checked<DeviceDescription> asOnLink(const Call &call, DeviceDescription device) const override;
};

} // namespace codewheel
