// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/role.h"

#include <QCoreApplication>
#include <QStringList>

#include <optional>

class QWidget;

namespace codewheel {

class RingOffer;

// Project files for those who use an offered ring: one for each seat, or one for all clients. Whoever opens
// one in a Codewheel of their own connects to that ring.
class OfferFiles
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::OfferFiles)

public:
    // `own`: the addresses of this computer. Questions and file dialogs belong to the parent; `folder`: where
    // these begin.
    OfferFiles(const RingOffer &offer, const QStringList &own, const QString &folder, QWidget &parent);

    struct Outcome
    {
        Role role = Role::running;
        QString sentence;
    };
    // Asks where to save them, and whether to replace what is there. Empty: the user did not want to.
    std::optional<Outcome> save();

private:
    QString askAddress() const;
    bool mayReplace(const QString &folder) const;
    std::optional<Outcome> saveSeats(const QString &host);
    std::optional<Outcome> saveOne(const QString &host);
    QString whoReaches(const QString &host) const;

    const RingOffer &m_offer;
    const QStringList m_own; // those at which it is offered
    const QString m_folder;
    QWidget &m_parent;
};

} // namespace codewheel
