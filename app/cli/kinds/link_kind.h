// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/bus/bus_access.h"
#include "cli/call/subcommand.h"
#include "finder/place_finder.h"

#include <functional>
#include <span>

namespace codewheel {

// A link as typed: SCHEME:WHERE,setting=value,...
struct LinkText
{
    QString scheme;
    QString where;
    QStringList settings; // "baud=9600"

    static std::optional<LinkText> parse(const QString &typed); // empty: it has no scheme
    QString link() const { return scheme + u':' + where; }
    // Takes it out of the settings.
    std::optional<QString> take(const QString &setting);
};

// Makes a bus of the call; the catalog must outlive it.
using MakeLink = std::function<Checked<std::unique_ptr<BusAccess>>(const Catalog &)>;

// A device whose place is known without asking its bus.
struct KnownDevice
{
    QString place; // as it is typed
    QString key;   // of its description; empty: it has none, or it is not known
};

// What of a simulated bus can be offered to other programs, as "serve esc".
struct Service
{
    const char *name;
    std::span<const Option> options;
    Checked<Answer> (*serve)(const Call &call); // until it is told to end
};

// A kind of bus at the command line: the links that reach it, and what it adds.
class LinkKind
{
public:
    virtual ~LinkKind() = default;

    virtual QString bus() const = 0;         // key of its BusKind
    virtual QStringList schemes() const = 0; // "esc"
    // Whether SCHEME:project stands for what the project plans of this kind.
    virtual bool leadsToPlanned() const { return true; }
    virtual QString help() const = 0;                     // "esc:PORT, a serial line": for the list of links
    virtual bool isPlace(const QString &typed) const = 0; // by its form
    // SCHEME:WHERE, unless it leads to what is planned.
    virtual Checked<std::vector<MakeLink>> links(const LinkText &text, const Project *project) const = 0;
    // For a bus of this kind planned by the project; these settings take precedence over those of the
    // project.
    virtual Checked<MakeLink> planned(const Project &project, BusId bus,
                                      const QStringList &settings) const = 0;
    // The simulated bus, which stands for the one of the project, null if there is none; empty: it has none.
    virtual MakeLink training(const Project *project) const = 0;
    virtual std::span<const Subcommand *const> commands() const { return {}; }
    virtual std::span<const Option> scanOptions() const { return {}; } // of the search for encoders
    virtual std::span<const Service> services() const { return {}; }
    // For shells that complete a call: where SCHEME: leads besides what is planned, the settings that may
    // stand behind it, and the devices of the simulated bus. Opens nothing.
    virtual QStringList ends(const QString &) const { return {}; }
    virtual QStringList settingKeys(const QString &) const { return {}; }
    virtual std::vector<KnownDevice> trainingDevices(const Catalog &) const { return {}; }
    // At HOST[:PORT], as typed; null: this kind is at no host.
    virtual Checked<std::optional<HostSearch>> hostSearch(const QString &) const { return std::nullopt; }
    // For a device on this kind of bus that has no words; empty: it is explained like all others.
    virtual std::optional<Checked<Answer>> explain(const Call &, const DeviceDescription &) const
    {
        return std::nullopt;
    }
    // For `devices --check`, of a file in which makers of this kind of encoder describe one; empty: it is
    // none.
    virtual std::optional<Answer> checkDeviceFile(const Call &, const QString & /*path*/) const
    {
        return std::nullopt;
    }
    // What stands behind its schemes is a file, whose name the shell completes.
    virtual bool leadsToFile() const { return false; }
    // With its parameters limited by the settings of --link.
    virtual Checked<DeviceDescription> asOnLink(const Call &call, DeviceDescription device) const;
    // What only listens there, as typed; where nothing was typed, at all places of this computer.
    virtual std::vector<std::unique_ptr<PlaceFinder>> listenersAt(const QString &) const { return {}; }
};

// The built-in ones, and any that were added.
std::vector<const LinkKind *> linkKinds();
// Of all kinds.
std::vector<Service> allServices();
// Until the returned pointer is released.
std::shared_ptr<const LinkKind> addLinkKind(std::unique_ptr<const LinkKind> kind);

// The number of a bus of this kind that the call reaches: that of the bus of the project that is meant;
// otherwise that of its training bus, or of its only one of this kind; otherwise one that the project assigns
// to no bus.
BusId numberOf(const LinkKind &kind, const Project *project, std::optional<BusId> meant = {});

// What --link names: "training", the simulated bus of each kind; "project", everything the project plans;
// SCHEME:WHERE for the kind that has this scheme, or, if several have it, for the one that protocol= names;
// SCHEME:project, everything of that kind that the project plans. Refused if there is no such link, and if it
// only makes sense with a project and there is none.
Checked<std::vector<MakeLink>> linksMeant(const QString &typed, const Project *project);
// Also says which links there are.
tl::unexpected<Complaint> unknownLink(const QString &typed);

} // namespace codewheel
