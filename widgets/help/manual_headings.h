// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>

#include <vector>

namespace codewheel {

// A heading of the manual, found without laying out its page.
struct ManualHeading
{
    QString page;  // its title
    QString title; // the same for the page's own heading
    QString topic; // in the form of setHelpTopic()
};

// Of one page, in its order: "offline-and-online".
QStringList headingAnchors(const QString &file);
// Of all pages that Manual has, page by page.
std::vector<ManualHeading> manualHeadings();

} // namespace codewheel
