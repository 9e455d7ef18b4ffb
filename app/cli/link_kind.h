// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/bus_access.h"
#include "cli/subcommand.h"

#include <functional>
#include <span>

namespace codewheel {

// A link as it is typed: SCHEME:WHERE,setting=value,...
struct LinkText
{
    QString scheme;
    QString where;
    QStringList settings; // "baud=9600"

    static std::optional<LinkText> parse(const QString &typed); // nothing: it has no scheme
    QString link() const { return scheme + u':' + where; }
    // Takes it out of the settings.
    std::optional<QString> take(const QString &setting);
};

// Makes a bus of the call; the catalog outlives it.
using MakeLink = std::function<Checked<std::unique_ptr<BusAccess>>(const Catalog &)>;

// A kind of bus at the command line: by which links it is reached, and what it brings along.
class LinkKind
{
public:
    virtual ~LinkKind() = default;

    virtual QString bus() const = 0;         // key of its BusKind
    virtual QStringList schemes() const = 0; // "esc"
    virtual QString help() const = 0;        // "esc:PORT, a serial line": of the links that there are
    virtual bool isPlace(const QString &typed) const = 0; // by its form
    // SCHEME:WHERE, unless it is SCHEME:project.
    virtual Checked<std::vector<MakeLink>> links(const LinkText &text, const Project *project) const = 0;
    // Of a bus of this kind that the project plans; these settings go before those of the project.
    virtual Checked<MakeLink> planned(const Project &project, BusId bus,
                                      const QStringList &settings) const = 0;
    // The simulated bus, which stands for the one of the project, null where there is none; none: it has
    // none.
    virtual MakeLink training(const Project *project) const = 0;
    virtual std::span<const Subcommand *const> commands() const { return {}; }
    virtual std::span<const Option> scanOptions() const { return {}; } // of the search for encoders
    // Of a device on this kind of bus, whose words are none; nothing: it is explained as all others.
    virtual std::optional<Checked<Answer>> explain(const Call &, const DeviceDescription &) const
    {
        return std::nullopt;
    }
    // With what its parameters are limited to by the settings of --link.
    virtual Checked<DeviceDescription> asOnLink(const Call &call, DeviceDescription device) const;
};

// Those of the program, and what was added.
std::vector<const LinkKind *> linkKinds();
// Until what is given back ends.
std::shared_ptr<const LinkKind> addLinkKind(std::unique_ptr<const LinkKind> kind);

// The number of a bus of this kind that the call reaches: that of the bus of the project that is meant; else
// that of its training bus, or of its only one of this kind; else one that the project gives to no bus.
BusId numberOf(const LinkKind &kind, const Project *project, std::optional<BusId> meant = {});

// What --link names: "training", the simulated bus of each kind; "project", all that the project plans;
// SCHEME:WHERE of the kind that has this scheme, or, where several have it, of the one that protocol= names;
// SCHEME:project, all of that kind that the project plans. Refused where there is no such link, and where it
// means something with a project only and there is none.
Checked<std::vector<MakeLink>> linksMeant(const QString &typed, const Project *project);
// And which links there are.
tl::unexpected<Complaint> unknownLink(const QString &typed);

} // namespace codewheel
