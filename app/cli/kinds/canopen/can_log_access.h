// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/kinds/canopen/canopen_access.h"
#include "replay/can_log.h"

namespace codewheel {

// Which log is meant, and how it is taken.
struct CanLogMeant
{
    QString file{};
    QString interface {};         // empty: that of the first frame
    bool isUsuallyMapped = false; // the user says that the first PDOs hold the position, as CiA 406 has it
};

// A log of a CAN bus at the command line, as if it were the bus: what came then comes again, in virtual time.
// It can be listened to only.
class CanLogAccess final : public CanopenAccess
{
public:
    // Refused as by CanLog::look().
    static Checked<std::unique_ptr<BusAccess>> to(const CanLogMeant &meant, const Catalog &catalog, BusId id);

    Checked<void> open() override;
    std::optional<Complaint> whyNot(const Subcommand &command) const override;
    bool mayHave(NodeId node) const override;
    std::vector<Place> knownPlaces() const override; // of nodes that told something
    bool knowsItsPlaces() const override { return true; }
    // At once: no time passes.
    Checked<EncoderSession *> encoder(const Call &call, NodeId node, bool namesIt) override;
    std::optional<Instant> length() const override;
    QString linkKey() const override;

private:
    CanLogAccess(const CanLogMeant &meant, CanLogSummary summary, const Catalog &catalog, BusId id);
    bool hasHeard(int node) const;

    CanLogMeant m_meant;
    CanLogSummary m_summary;
};

} // namespace codewheel
