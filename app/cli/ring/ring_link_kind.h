// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/link_kind.h"

namespace codewheel {

extern const Subcommand masterCommand;

// INTERBUS at the command line: the training ring.
class RingLinkKind final : public LinkKind
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
};

} // namespace codewheel
